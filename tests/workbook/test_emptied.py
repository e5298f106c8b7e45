"""Entries that are emptied in a book, and rows left blank: told where they are, and never taken for a default."""

import re

import openpyxl
import pytest

from tests.workbook.test_unfinished import small
from workbook.build import build, inputs
from workbook.entries import rules
from workbook.entries.design import designed
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.templates import TEMPLATES


def machine_of(name):
    template = TEMPLATES[name]
    return designed(template.model, template.check, small(name), lambda: None)


def defaulted(name):
    """An input of each kind that a description may lack, and that is filled in the book: block, column and row."""
    template, found = TEMPLATES[name], {}
    for block in template.declare(machine_of(name)).blocks.values():
        for q in block.quantities:
            key = re.sub(r"\.\d+(?=\.|$)", ".*", q.key)
            optional = q.role == "input" and not rules.is_required(template.model, key)
            if optional and rules.must_be_there(template.model, key):
                found.setdefault(key, (block.name, q.name))
    return found


CASES = [(name, *place) for name in TEMPLATES for key, place in defaulted(name).items()
         if name == "motion-composer" or not key.startswith("laws.")]  # fmt: skip


@pytest.mark.parametrize(("name", "block", "column"), CASES)
@pytest.mark.sample(4)
def test_an_emptied_entry_is_missing_and_not_its_default(name, block, column, tmp_path):
    machine = machine_of(name)
    build(machine, tmp_path / "book.xlsx")
    place = TEMPLATES[name].declare(machine).blocks[block]
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    cell = book[place.sheet.title].cell(place.row, place.columns[column])
    assert cell.value is not None
    cell.value = None
    book.save(tmp_path / "edited.xlsx")
    try:
        report = verify(tmp_path / "edited.xlsx")
    except InputError as refused:  # a text
        (line,) = refused.lines
        assert f"{place.sheet.title}!{cell.coordinate} " in line
        assert "empty; expected a text" in line
        return
    assert report.findings == []
    assert report.unfinished
    assert any(f"{place.quantities[0].label if not place.is_table else ''}" in c.says and "empty" in c.says
               for c in report.failing)  # fmt: skip
    found, _ = inputs(tmp_path / "edited.xlsx")
    build(found, tmp_path / "new.xlsx")
    assert (verify(tmp_path / "new.xlsx").findings, inputs(tmp_path / "new.xlsx")[0]) == ([], found)


def test_a_coefficient_without_a_duration_makes_no_rise_of_two(tmp_path):
    """The duration that is missing counts as 0, as in its cell: the others still sum to 1."""
    machine = machine_of("motion-composer")
    build(machine, tmp_path / "book.xlsx")
    place = TEMPLATES["motion-composer"].declare(machine).blocks["OWN_pieces"]
    for row in (1, place.size - 1):
        book = openpyxl.load_workbook(tmp_path / "book.xlsx")
        book[place.sheet.title].cell(place.row + row, place.columns["c3"]).value = 2.5
        book.save(tmp_path / "edited.xlsx")
        report = verify(tmp_path / "edited.xlsx")
        assert report.findings == []
        assert any(f"duration, row {row + 1}: empty" in c.says for c in report.failing)


@pytest.mark.parametrize("name", ["actuator-sizing", "machine"])
def test_a_row_left_blank_is_blamed_alone_or_not_at_all(name, tmp_path):
    """What is entered below it lacks a name, or is whole and leaves it between."""
    machine = machine_of(name)
    held = len(machine.selection.reducers)
    roomy = machine.model_copy(update={"sizes": machine.sizes.model_copy(update={"reducers": held + 3})})
    build(roomy, tmp_path / "book.xlsx")
    place = TEMPLATES[name].declare(roomy).blocks["reducers"]
    for column, value, blamed in (("mass", 2.5, held + 1), ("name", "X 1", held)):
        book = openpyxl.load_workbook(tmp_path / "book.xlsx")
        book[place.sheet.title].cell(place.row + held + 1, place.columns[column]).value = value
        book.save(tmp_path / "edited.xlsx")
        with pytest.raises(InputError) as refused:
            inputs(tmp_path / "edited.xlsx")
        (line,) = refused.value.lines
        assert f"!B{place.row + blamed} " in line
