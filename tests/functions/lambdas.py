"""The LAMBDA names in a workbook, computed by IronCalc."""

import openpyxl
import pytest
from openpyxl.workbook.defined_name import DefinedName

from tests.functions.case import write
from workbook.functions.names import definitions

ironcalc = pytest.importorskip("ironcalc")  # which has no wheel for every Python
BLOCK = 400  # cases a workbook: IronCalc keeps 0.7 MB for each, and its time grows faster than their number


def computed(cases, path):
    """Return what the names give for each case."""
    found = []
    for first in range(0, len(cases), BLOCK):
        block = cases[first : first + BLOCK]
        write(block, path)
        found += recomputed(path, len(block))
    return found


def recomputed(path, count):
    """Give the workbook the names, and return the values of the first ``count`` cells of its first column."""
    book = openpyxl.load_workbook(path)
    for definition in definitions():
        book.defined_names[definition.name] = DefinedName(definition.name, attr_text=definition.stored)
    book.save(path)
    return values(path, [(row, 1) for row in range(1, count + 1)])


def values(path, cells, sheet=0):
    """Return the values that IronCalc computes for cells (row, column) of a sheet."""
    model = ironcalc.load_from_xlsx(str(path), "en", "UTC", "en")
    model.evaluate()
    return [model.get_cell_value(sheet, *cell) for cell in cells]
