"""The law of the cells on the sheets of motions: short formulas, few functions deep, few columns."""

import re

import pytest

from tests.workbook.composed import committed_as
from workbook.judging.matching import is_formula

LONGEST, DEEPEST, WIDEST = 200, 4, 40
SHEETS = re.compile(r"Cycle \d+|Pieces|Export")
BOOKS = ("machine", "machine-seconds", "motion-composer-example-1", "motion-composer-example-3", "cutting-machine")


def depth(formula):
    """Return how many functions a formula nests."""
    plain, open_, deepest = re.sub(r'"[^"]*"', "", formula), [], 0
    for one in re.finditer(r"([A-Z][A-Z0-9.]*)?\(|\)", plain):
        if one[0] == ")":
            open_.pop()
        else:
            open_.append(bool(one[1]))
            deepest = max(deepest, sum(open_))
    return deepest


def on_sheets(name):
    """The declared cells of a committed description on the sheets of motions."""
    template, machine = committed_as(name)
    return [cell for cell in template.declare(machine).cells() if SHEETS.fullmatch(cell.block.sheet.title)]


@pytest.mark.parametrize("name", BOOKS)
def test_each_cell_of_a_motion_is_a_quantity(name):
    cells = on_sheets(name)
    formulas = {cell.content for cell in cells if is_formula(cell.content)}
    assert formulas
    assert [text for text in formulas if len(text) > LONGEST or depth(text) > DEEPEST] == []
    assert max(cell.column for cell in cells) <= WIDEST


def test_depth_counts_functions_alone():
    assert depth('=IF((A1+(2*B1))>0,"MAX(MIN(",SUM(ABS(A1),2))') == 3
