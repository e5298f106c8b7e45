"""Entries that are not in order are refused, with a line that says where they stand and what to do."""

import re

import openpyxl
import pytest

from workbook.errors import InputError
from workbook.judging.verify import verify


@pytest.fixture
def edited(press, tmp_path):
    """What makes a book of the press with other entries in columns of a table: what ``verify`` says."""

    def made(table, **columns):
        workbook, block = openpyxl.load_workbook(press.path), press.declared.blocks[table]
        for name, values in columns.items():
            for row, value in enumerate(values):
                workbook[block.sheet.title].cell(block.row + row, block.columns[name]).value = value
        workbook.save(tmp_path / "edited.xlsx")
        return verify(tmp_path / "edited.xlsx")

    return made


@pytest.mark.parametrize(
    ("held", "says"),
    [("M1 ", "begins or ends with a blank"), (" M2", "begins or ends with a blank"), ("A*", "holds [*]"),
     ("?", "holds [?]"), ("1", "reads as a value"), (1, "text"), ("TRUE", "reads as a value"),
     ("3/4", "reads as a value")],
)  # fmt: skip
def test_a_name_that_look_ups_read_otherwise_is_refused_in_a_line_with_its_cell(held, says, edited):
    with pytest.raises(InputError) as refused:
        edited("motors", name=[held])
    (line,) = refused.value.lines
    assert re.search(f"Motors!B8.*{says}", line)


@pytest.mark.parametrize(
    ("table", "columns"),
    [
        ("motors", {"name": [None, None, "M1", "M2", "M3"], "torque": [None, None, 4, 12, 30]}),
        ("motors", {"name": ["M1", None, "M2", "M3"], "torque": [4, None, 12, 30]}),
        ("axis1", {"start": [None, 0, 90, 180], "stop": [None, 90, 180, 300], "law": [None, "rise", "dwell", "rise"],
                   "lift": [None, 30, 0, -30]}),
    ],
)  # fmt: skip
def test_a_row_left_empty_before_others_is_told_in_a_line(table, columns, edited):
    with pytest.raises(InputError) as refused:
        edited(table, **columns)
    (line,) = refused.value.lines
    assert re.search(f"nothing is entered in row [12] of the table {table}, but below it; fill it, or move up", line)
