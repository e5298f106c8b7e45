"""Workings beside a table are folded away in an outline: never an entry, a result or a verdict."""

import openpyxl
import pytest
from openpyxl.utils import get_column_letter

from workbook.build import build
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES


@pytest.mark.parametrize("name", ["machine", "machine-linkages"])
def test_what_is_folded_is_workings_alone(name, tmp_path):
    machine = read_machine(TEMPLATES["machine"].description.with_stem(name))
    declared = TEMPLATES["machine"].declare(machine)
    build(machine, tmp_path / "book.xlsx")
    pages = openpyxl.load_workbook(tmp_path / "book.xlsx")
    sheets = [sheet for sheet in declared.sheets if sheet.folded]
    assert [sheet.title for sheet in sheets] == ["Timing"]
    for sheet in sheets:
        folded = [(block.name, q.name, q.role) for block in sheet.blocks for q in block.quantities
                  if block.columns[q.name] >= sheet.folded]  # fmt: skip
        assert len(folded) > 10
        assert {role for *_, role in folded} <= {"calculation", "constant"}
        assert all(column + width <= sheet.folded for _, _, column, width, _ in sheet.charts)
        first = pages[sheet.title].column_dimensions[get_column_letter(sheet.folded)]
        assert (first.hidden, first.outlineLevel) == (True, 1)
        assert first.max >= max(max(block.columns.values()) for block in sheet.blocks)
        assert not pages[sheet.title].column_dimensions[get_column_letter(sheet.folded - 1)].hidden
