"""Entries that are not in order are judged all the same, with a line that says what to do."""

import re

import openpyxl
import pytest

from workbook.build import read_inputs
from workbook.errors import InputError
from workbook.judging.verify import verify


@pytest.fixture
def edited(press, tmp_path):
    """What makes a book of the press with other entries in columns of a table: what ``verify`` says, and its path."""

    def made(table, **columns):
        workbook, block = openpyxl.load_workbook(press.path), press.declared.blocks[table]
        for name, values in columns.items():
            for row, value in enumerate(values):
                workbook[block.sheet.title].cell(block.row + row, block.columns[name]).value = value
        workbook.save(tmp_path / "edited.xlsx")
        return verify(tmp_path / "edited.xlsx"), tmp_path / "edited.xlsx"

    return made


def lines(found):
    return [(f"{one.sheet}!{one.cell}", one.kind, one.computed, one.expected) for one in found]


def test_a_name_with_blanks_around_it_is_trimmed_and_told(edited):
    report, path = edited("motors", name=["M1 ", " M2"])
    assert (report.findings, report.compared) == ([], report.declared)
    assert lines(report.notices) == [
        ("Motors!B8", "notice", "'M1 '", "'M1', without blanks around it"),
        ("Motors!B9", "notice", "' M2'", "'M2', without blanks around it"),
    ]
    machine, notes = read_inputs(path)
    assert [motor.name for motor in machine.motors] == ["M1", "M2", "M3"]
    assert any("without blanks" in note for note in notes)


def test_a_name_that_is_another_without_its_blank_is_found(edited):
    report, _ = edited("motors", name=["M1", "M1 "])
    assert lines(report.findings) == [("Motors!B9", "entry", "'M1 '", "'M1', without blanks around it")]


@pytest.mark.parametrize(
    ("held", "other"), [("A*", "A_"), ("1", "1_"), (1, "1_"), ("?", "_"), ("TRUE", "TRUE_"), ("3/4", "3/4_")]
)
def test_a_name_that_look_ups_read_otherwise_is_found_and_the_rest_is_judged(held, other, edited):
    report, _ = edited("motors", name=[held])
    found = ("Motors!B8", "entry", f"'{held}'", f"a name that look-ups find, such as {other!r}")
    assert lines(report.findings) == [found]
    assert report.compared == report.declared


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
