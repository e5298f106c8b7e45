"""The stamp of a verified book: on its first page, by plain formulas, whether it was verified for today's entries."""

import zipfile

import pytest
from openpyxl import load_workbook

from tests.workbook.edit import cell_named
from workbook.book.stamp import NEVER, OTHER, SAME
from workbook.build import read_entered, regenerate
from workbook.commands import verify as command
from workbook.errors import WriteError
from workbook.judging.verify import verify
from workbook.witnesses.engines import convert
from workbook.writing.stamp import write_stamp


@pytest.fixture(scope="module")
def book(press):
    return press.path


@pytest.fixture
def stamped(book, tmp_path):
    match, *_ = read_entered(book)
    write_stamp(match.file, match.declared, tmp_path / "stamped.xlsx", overwrite=False)
    return tmp_path / "stamped.xlsx"


def line(path):
    """The line on the first page, as it was saved."""
    return cell_named(load_workbook(path, data_only=True), "stamp_today").value


def edited(path, change):
    """Return a book after a change, computed and saved by LibreOffice; verify finds nothing in it."""
    workbook = load_workbook(path)
    change(workbook)
    workbook.save(path)
    computed = convert(path, "xlsx", path.parent / "computed")
    assert verify(computed).findings == []
    return computed


def exchange_lifts(workbook):
    first = cell_named(workbook, "axis1").offset(0, 4)
    third = first.offset(2, 0)
    first.value, third.value = third.value, first.value


EDITS = {
    "none": (lambda workbook: None, SAME),
    "a last digit that counts": (lambda workbook: enter(workbook, "drive1_inertia", 1 + 1e-5), OTHER),
    "the sign": (lambda workbook: enter(workbook, "drive1_friction", -1), OTHER),
    "two rows exchanged": (exchange_lifts, OTHER),
    "a stamp that is gone": (lambda workbook: enter(workbook, "book_stamp", None), NEVER),
    "another number for a stamp": (lambda workbook: enter(workbook, "book_stamp", 1.5), OTHER),
}


def enter(workbook, name, factor):
    cell = cell_named(workbook, name)
    cell.value = factor and cell.value * factor


@pytest.mark.parametrize("edit", EDITS)
def test_the_line_says_whether_the_entries_are_those_that_were_verified(stamped, edit):
    change, says = EDITS[edit]
    assert line(edited(stamped, change)) == says


def test_every_witness_computes_the_fingerprint_that_the_engine_has(stamped):
    report = verify(stamped, ["all"])
    assert report.findings == []
    assert sum(ran.answered for ran in report.witnesses) >= 3


def test_the_stamp_is_all_that_changes_in_the_file(book, stamped):
    with zipfile.ZipFile(book) as before, zipfile.ZipFile(stamped) as after:
        assert before.namelist() == after.namelist()
        changed = [name for name in before.namelist() if before.read(name) != after.read(name)]
    assert changed == ["xl/worksheets/sheet1.xml"]
    assert (line(book), line(stamped)) == (NEVER, SAME)


def test_a_text_for_a_stamp_is_a_finding_and_a_book_built_anew_has_none(stamped, tmp_path):
    regenerate(stamped, tmp_path / "anew.xlsx")
    assert line(tmp_path / "anew.xlsx") == NEVER
    workbook = load_workbook(stamped)
    cell_named(workbook, "book_stamp").value = "verified!"
    workbook.save(stamped)
    assert [(f.kind, f.what) for f in verify(stamped).findings if f.kind == "changed"] == [("changed", "Verified at")]


def run(path, in_place=False):
    return command.verify([path], False, None, None, None, False, None, 1, False, None, True, in_place)


def test_verify_stamps_what_agrees_in_a_copy_or_in_place(book, tmp_path):
    path, copy = tmp_path / "press.xlsx", tmp_path / "press-verified.xlsx"
    path.write_bytes(book.read_bytes())
    assert run(path) == 0
    assert (line(path), line(copy)) == (NEVER, SAME)
    with pytest.raises(WriteError, match="exists"):
        run(path)
    assert run(path, in_place=True) == 0
    assert line(path) == SAME
    workbook = load_workbook(path)
    cell_named(workbook, "timing_period").value = 1.0
    workbook.save(path)
    before = path.read_bytes()
    assert run(path, in_place=True) == 1
    assert path.read_bytes() == before
