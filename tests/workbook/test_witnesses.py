"""Each witness agrees with the engine, and notices a corrupted formula and, where it reads them, corrupted values."""

import re
import zipfile

import pytest

from workbook.errors import MotionbookError
from workbook.judging.verify import verify
from workbook.reading.entries import read_machine
from workbook.reading.files import open_book
from workbook.templates import TEMPLATES
from workbook.witnesses import WITNESSES, libreoffice_witness

SMALL = {"cycle": 12, "law": 4, "own_law": 4}


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    """A small book of the cutting machine."""
    from workbook.build import build

    machine = read_machine(TEMPLATES["cutting-machine"].description)
    machine = machine.model_copy(update={"sizes": machine.sizes.model_copy(update=SMALL)})
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(machine, path)
    return path


def changed(book, path, pattern, replacement):
    """A copy of ``book`` with the first match in its Timing sheet replaced."""
    with zipfile.ZipFile(book) as old, zipfile.ZipFile(path, "w") as new:
        for name in old.namelist():
            data = old.read(name)
            if name == "xl/worksheets/sheet2.xml":
                data, count = re.subn(pattern, replacement, data, count=1)
                assert count == 1
            new.writestr(name, data)
    return path


@pytest.mark.parametrize("name", WITNESSES)
def test_a_witness_agrees_and_says_its_version(name, book):
    report = verify(book, [name])
    assert report.findings == []
    (ran,) = report.witnesses
    assert ran.version is not None
    assert ran.compared == report.compared > 2000


@pytest.mark.parametrize("name", [n for n in WITNESSES if n != "saved"])
def test_a_witness_computes_a_corrupted_formula_and_is_not_misled_by_the_saved_value(name, book, tmp_path):
    path = changed(book, tmp_path / "b.xlsx", rb"<f>60/timing_rate</f>", b"<f>61/timing_rate</f>")
    values = WITNESSES[name]().values(open_book(path))
    report = verify(path, [name])
    place = open_book(path).places["timing_cycle"]
    assert values[place.cell(0, 0)] == pytest.approx(61 / 200, rel=1e-12)
    first = report.findings[0]
    assert (first.sheet, first.cell, first.kind) == ("Timing", place.cell(0, 0).a1, "formula")
    assert any(f.kind == "value" and f.cell == first.cell and f.witness == name for f in report.findings)


@pytest.mark.parametrize("name", WITNESSES)
def test_only_the_saved_values_are_misled_by_a_corrupted_saved_value(name, book, tmp_path):
    path = changed(book, tmp_path / "b.xlsx", rb"(<f>60/timing_rate</f><v ?>)0.3(</v>)", rb"\g<1>0.31\g<2>")
    report = verify(path, [name])
    if name == "saved":
        (found,) = report.findings
        assert (found.kind, found.computed, found.expected) == ("value", 0.31, 0.3)
    else:
        assert report.findings == []


def test_saved_refuses_a_file_that_was_never_calculated(book, tmp_path):
    import openpyxl

    path = tmp_path / "b.xlsx"
    openpyxl.load_workbook(book).save(path)
    report = verify(path, ["pycel", "saved"])
    assert [f.kind for f in report.findings] == ["witness"]
    assert "no saved values" in report.findings[0].computed


def test_an_absent_witness_is_named_and_fails(book, monkeypatch):
    monkeypatch.setattr(libreoffice_witness, "program", lambda: None)
    report = verify(book, ["pycel", "libreoffice"])
    assert [(f.kind, f.cell, f.computed) for f in report.findings] == [("witness", "libreoffice", "absent")]


def test_an_unknown_witness_is_refused(book):
    with pytest.raises(MotionbookError, match=r"expected pycel, formualizer, libreoffice, saved"):
        verify(book, ["excel"])


def test_error_values_volatile_functions_and_foreign_formulas_are_told(book, tmp_path):
    import openpyxl

    opened = openpyxl.load_workbook(book)
    sheet = opened.create_sheet("Mine")
    sheet["A1"], sheet["A2"], sheet["A3"], sheet["A4"] = "=1/0", "=Timing!D8*2", "#REF!", "=NOW()"
    opened.save(tmp_path / "b.xlsx")
    report = verify(tmp_path / "b.xlsx")
    assert {(f.sheet, f.cell, f.kind) for f in report.findings} == {
        ("Mine", "A1", "error"), ("Mine", "A3", "error"), ("Mine", "A4", "function"),
    }  # fmt: skip
    assert report.unmatched == ["Mine!A1", "Mine!A2", "Mine!A4"]
