"""A name that leads to more cells than its own, or elsewhere, is a finding, or refused in a line: no more, no less."""

import random

import openpyxl
import pytest
from openpyxl.utils import get_column_letter, quote_sheetname

from workbook.errors import MotionbookError
from workbook.judging.verify import verify
from workbook.reading.files import open_book

ROOM = ((1, 0), (0, 1), (5, 0), (0, 3), (1, 1))
EDITS = 24


@pytest.fixture
def book(press):
    """The smallest book there is."""
    return press.path


def renamed(book, path, name, cells, away):
    """A copy of a book of which one name leads to so many rows and columns more, so far away."""
    workbook, place = openpyxl.load_workbook(book), open_book(book).places[name]
    first = place._replace(row=place.row + away[0], column=place.column + away[1])
    corners = first._replace(rows=place.rows + cells[0], columns=place.columns + cells[1]).corners
    text = ":".join(f"${get_column_letter(one.column)}${one.row}" for one in corners)
    workbook.defined_names[name].attr_text = f"{quote_sheetname(place.sheet)}!{text}"
    workbook.save(path)
    return path


def kinds(path, witness):
    """The kinds of what is found in a book; "refused" where it is refused in a line."""
    try:
        return {finding.kind for finding in verify(path, [witness]).findings}
    except MotionbookError:
        return {"refused"}


def test_a_single_cell_whose_name_leads_to_more_is_a_finding(book, tmp_path):
    places = open_book(book).places
    single = [name for name, place in places.items() if place.rows * place.columns == 1]
    drawn = random.Random(39)
    for k, name in enumerate(drawn.sample(single, EDITS // 2)):
        path = renamed(book, tmp_path / "b.xlsx", name, ROOM[k % len(ROOM)], (0, 0))
        assert kinds(path, "pycel") == {"refused"}, name


def test_saved_values_alone_are_held_against_the_engine(book, monkeypatch):
    """No witness has computed anything that they could be stale against; some are empty, some another number."""
    file = open_book(book)
    others = (None, 7.25)
    file.saved |= {at: others[k % 2] for k, at in enumerate(file.saved)}
    monkeypatch.setattr("workbook.judging.verify.open_book", lambda path: file)
    found = [finding for finding in verify(book, ["saved"]).findings if finding.kind == "saved"]
    assert {finding.computed for finding in found} == {*others}
