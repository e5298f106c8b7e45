"""Sheets of drives by their axes' names: of any name, and where an axis is renamed in the book."""

import re

import openpyxl
import pytest

from tests.workbook.edit import enter
from tests.workbook.machines.test_machine import TEMPLATE, axis, described, driven
from workbook.build import build, read_inputs
from workbook.reading.descriptions import read_machine
from workbook.reading.entries import Entries
from workbook.reading.files import open_book
from workbook.witnesses.agreement import agreed_values

AWKWARD = ["a/b", "a:b", "[x] 'y'", "'", "\U0001f529" * 12 + "1", "\U0001f529" * 12 + "2", "Drive 1", "History"]
PHASES = (0, 90, 2.0, "CIC"), (180, 200, -2.0, "CIC")


def named(*names):
    """A machine of axes with drives."""
    return described([driven(*PHASES) | {"name": name} for name in names])


def drives(book):
    return [block.sheet.title for name, block in book.blocks.items() if re.fullmatch(r"drive\d+_axis", name)]


def test_the_sheet_of_a_drive_has_its_axis_name():
    book = TEMPLATE.declare(read_machine(TEMPLATE.description))
    assert drives(book) == ["Drive MC01", "Drive MC02"]
    labels = [check.label for sheet, check in book.checks if sheet.title == "Drive MC02"]
    assert "Drive MC02: RMS torque within the continuous torque" in labels
    assert "Drive MC02: entries within limits" in labels
    texts = {text.text for sheet in book.sheets if sheet.title == "Drive MC02" for text in sheet.texts}
    assert {"RMS torque", "Entries within limits"} <= texts
    links = [text for text in book.sheets[0].texts if text.text and text.link.startswith("Drive")]
    assert [(text.text, text.link) for text in links] == [(name, name) for name in drives(book)]


def test_axes_of_any_names_have_sheets_of_their_own():
    titles = drives(TEMPLATE.declare(named(*AWKWARD)))
    assert titles[:4] == ["Drive a-b", "Drive a-b (2)", "Drive -x- 'y", "Drive"]
    assert len({title.casefold() for title in titles}) == len(AWKWARD)
    assert max(len(title.encode("utf-16-le")) for title in titles) <= 62


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """A drive of MC01, beside an axis MC02 without; a law with a name of its own."""
    made = tmp_path_factory.mktemp("names") / "book.xlsx"
    data = described([driven(*PHASES) | {"name": "MC01"}, axis(2, *PHASES) | {"name": "MC02"}]).model_dump()
    build(TEMPLATE.model.model_validate(data | {"laws": data["laws"] | {"Hard": {"family": "CUB"}}}), made)
    return made


def test_regenerate_gives_the_sheets_of_a_renamed_axis_and_law_their_new_names(path):
    """Also where another axis has taken the old one."""
    others = {"axis_name": "Punch / cam", ("axis_name", 1): "MC01", "CUB8_called": "Harder"}
    renamed = enter(path, path.with_suffix(".other.xlsx"), others)
    held = Entries(open_book(renamed), agreed_values).machine()
    assert drives(TEMPLATE.declare(held)) == ["Drive MC01"]
    machine, lost = read_inputs(renamed)
    assert lost == []
    again = path.with_suffix(".again.xlsx")
    build(machine, again)
    titles = openpyxl.load_workbook(again).sheetnames
    assert [title for title in titles if "Drive" in title] == ["Drive Punch - cam"]
    assert "Harder" in titles
    assert "Hard" not in titles
    assert read_inputs(again)[0] == machine


@pytest.mark.parametrize("held", [None, "x" * 90])
def test_whatever_stands_for_the_name_that_was_built_the_inputs_come_back(path, held):
    machine, _ = read_inputs(enter(path, path.with_suffix(".other.xlsx"), {"axis1_built": held}))
    assert [one.name for one in machine.axes] == ["MC01", "MC02"]
