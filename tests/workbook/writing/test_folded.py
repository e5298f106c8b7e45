"""Workings beside a table are folded away in an outline: never an entry, a result or a verdict."""

import openpyxl
import pytest
from openpyxl.utils import get_column_letter

from workbook.build import build, committed_descriptions
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES


@pytest.mark.parametrize("name", ["machine", "machine-linkages"])
def test_what_is_folded_is_workings_alone(name, tmp_path):
    machine = read_machine(TEMPLATES["machine"].description.with_stem(name))
    declared = TEMPLATES["machine"].declare(machine)
    build(machine, tmp_path / "book.xlsx")
    pages = openpyxl.load_workbook(tmp_path / "book.xlsx")
    sheets = [sheet for sheet in declared.sheets if sheet.folded]
    assert [sheet.title for sheet in sheets] == ["Timing", *(["Clearances"] if machine.clearances else [])]
    for sheet in sheets:
        folded = [(block.name, q.name, q.role) for block in sheet.blocks for q in block.quantities
                  if block.columns[q.name] >= sheet.folded]  # fmt: skip
        assert len(folded) > 10
        assert {role for *_, role in folded} <= {"calculation", "constant", "sentence"}
        assert all(column + width <= sheet.folded for _, _, column, width, _ in sheet.charts)
        first = pages[sheet.title].column_dimensions[get_column_letter(sheet.folded)]
        assert (first.hidden, first.outlineLevel) == (True, 1)
        assert first.max >= max(max(block.columns.values()) for block in sheet.blocks)
        assert not pages[sheet.title].column_dimensions[get_column_letter(sheet.folded - 1)].hidden
        assert not any(chart.visible_cells_only for chart in pages[sheet.title]._charts)


MACHINES = [path for path in committed_descriptions() if path.stem.startswith("machine")]
SAID = {"kind"}
"""what a phase is: to be read, not a step of the calculation"""


def steps_printed(sheet):
    """Return the columns of tables that are printed and hold workings."""
    return {
        (block.name, q.name) for block in sheet.blocks for q in block.quantities
        if block.is_table and block.row <= sheet.print_rows and block.columns[q.name] <= sheet.print_columns
        and q.role == "calculation" and q.name not in SAID
    }  # fmt: skip


@pytest.mark.parametrize("path", MACHINES, ids=lambda path: path.stem)
def test_no_step_of_the_calculation_is_printed_with_the_phases(path):
    machine = read_machine(path)
    sheet = next(s for s in TEMPLATES[machine.template].declare(machine).sheets if s.title == "Timing")
    assert steps_printed(sheet) == set()
    below = {q.role for block in sheet.blocks for q in block.quantities if block.row > sheet.print_rows}
    assert below <= {"calculation", "constant", "check", "sentence"}


def test_the_comparison_of_laws_prints_their_names_and_what_they_cost():
    template = TEMPLATES["motion-laws"]
    sheets = template.declare(read_machine(template.description)).sheets
    sheet = next(s for s in sheets if s.title == "Comparison")
    assert steps_printed(sheet) == {("curves", "no"), ("costs", "law"), ("costs", "family")}


WORKED = {"Laws", "RMS", "Inverse"}
"""sheets of workings, printed so that they can be followed"""


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
def test_no_sheet_ends_its_print_with_workings(path):
    """But where checks follow them: these are printed, each."""
    machine = read_machine(path)
    for sheet in (one for one in TEMPLATES[machine.template].declare(machine).sheets if not one.unprinted):
        last = sheet.print_rows or sheet.row
        heads = [(text.row, text.text) for text in sheet.texts if text.style == "heading" and text.row < last]
        for row, head in heads[-1:] if sheet.title not in WORKED else []:
            checked = any(block.row > row and block.quantities[0].role == "check" for block in sheet.blocks)
            assert checked or not head.startswith("Workings"), (sheet.title, head)
