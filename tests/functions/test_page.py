"""The workbook motion-functions: what it shows is right in Excel's way and in LibreOffice's, and Excel can read it."""

import re
import subprocess
import zipfile

import openpyxl
import pytest
import xlsxwriter
from openxml_audit import FileFormat, OpenXmlValidator
from typer.testing import CliRunner

from tests.functions import lambdas
from tests.workbook.office import TIMEOUT, profile, started
from workbook.cli import app
from workbook.functions import publish
from workbook.functions.declarations import CODES
from workbook.functions.names import definitions
from workbook.functions.page import EXAMPLE, declare
from workbook.writing import archive

SHEET = "xl/worksheets/sheet1.xml"
EMPTY = re.compile(rb'<c r="\w+" s="\d+"[^<>]*/>')
NEAR = 1e-9


@pytest.fixture(scope="module")
def book(tmp_path_factory):
    path = tmp_path_factory.mktemp("page") / "motion-functions.xlsx"
    publish.write_book(path)
    return path


def part(path, name):
    with zipfile.ZipFile(path) as book:
        return book.read(name).decode()


def expected(shown):
    """The engine's value of each formula cell, by row and column."""
    cells = (cell for block in declare(shown).sheets[0].blocks for cell in block.cells())
    return {(c.row, c.column): c.expected for c in cells if c.quantity.formula is not None}


def wrong(found, values):
    def agree(one, other):
        return one == other if isinstance(other, str) else isinstance(one, int | float) and abs(one - other) <= NEAR

    return [(place, found[place], value) for place, value in values.items() if not agree(found[place], value)]


def without_empty_cells(path, made):
    """A copy without cells that hold only a style: IronCalc takes them for zeros."""
    parts = archive.unzipped(path.read_bytes())
    made.write_bytes(archive.zipped(parts | {SHEET: EMPTY.sub(b"", parts[SHEET])}))
    return made


OF_EACH_KIND = ("DWL", "LIN", "TVP", "MTP", "PO7", "DHM", "OWN")
LAWS = [law if law in OF_EACH_KIND else pytest.param(law, marks=pytest.mark.nightly) for law in CODES]


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.sample(3)
def test_the_names_compute_what_the_page_shows(law, tmp_path):
    shown = EXAMPLE.model_copy(update={"law": law, "xi": 0.625})
    publish.write_book(tmp_path / "page.xlsx", shown)
    values = expected(shown)
    bare = without_empty_cells(tmp_path / "page.xlsx", tmp_path / "bare.xlsx")
    found = dict(zip(values, lambdas.values(bare, list(values)), strict=True))
    assert len(values) > 900
    assert wrong(found, values) == []


def test_libreoffice_computes_it_with_the_add_in(book, calc):
    sheet = openpyxl.load_workbook(calc.computed(book), data_only=True).active
    values = expected(EXAMPLE)
    assert wrong({place: sheet.cell(*place).value for place in values}, values) == []


def test_without_the_add_in_libreoffice_says_so(book, tmp_path):
    """As the book is opened: what is saved is not computed anew."""
    command = [*started(profile("en-US").name), "--convert-to", "pdf", "--outdir", tmp_path, book]
    subprocess.run(command, capture_output=True, timeout=TIMEOUT, check=True)
    pdf = tmp_path / "motion-functions.pdf"
    text = subprocess.run(["pdftotext", "-layout", pdf, "-"], capture_output=True, text=True, check=True).stdout
    assert re.search(r"Do the functions compute here\? +no: they need Excel 365 or 2024", text)


def test_and_the_errors_of_the_examples_are_not_shown(book):
    """The ink of each is the paper's where the probe, the one error that is left, is one."""
    sheet = openpyxl.load_workbook(book).active
    calling = {
        (row, column): cell.coordinate
        for (row, column), cell in sheet._cells.items()
        if str(getattr(cell.value, "text", "")).startswith("=MOTION.")
    }
    probe = min(calling)
    rules = [(cells.cells, rule) for cells in sheet.conditional_formatting for rule in cells.rules]
    hidden = [area for area, rule in rules if rule.formula == [f"ISERROR($D${probe[0]})"]]
    assert all(rule.dxf.font.color.rgb.endswith("FFFFFF") for area, rule in rules if area in hidden)
    assert [cell for cell in calling.values() if not any(cell in area for area in hidden)] == [calling[probe]]


def test_the_names_are_the_only_ones_and_tell_what_they_do(book):
    names = openpyxl.load_workbook(book).defined_names
    assert {name: (n.attr_text, n.comment) for name, n in names.items()} == {
        d.name: (d.stored, d.note) for d in definitions()
    }


def test_cells_are_dynamic_as_xlsxwriter_writes_them(book, tmp_path):
    with xlsxwriter.Workbook(tmp_path / "oracle.xlsx") as oracle:
        oracle.add_worksheet().write_dynamic_array_formula("A1", '=MOTION.S("CUB",0.5,0)', None, 0.5)
    cell = re.search(r"<c r=.*?</c>", part(tmp_path / "oracle.xlsx", SHEET))[0]
    assert cell == '<c r="A1" cm="1"><f t="array" ref="A1">MOTION.S("CUB",0.5,0)</f><v>0.5</v></c>'
    cells = re.findall(r'<c r="(\w+)" s="\d+" ([^>]*)>(<f.*?</f>)', part(book, SHEET))
    calling = [(place, marks, formula) for place, marks, formula in cells if "MOTION." in formula]
    assert len(calling) > 700
    for place, marks, formula in calling:
        assert marks.startswith('cm="1"'), place
        assert formula.startswith(f'<f t="array" ref="{place}">'), place
    assert not [place for place, marks, formula in cells if "MOTION." not in formula and "cm=" in marks]
    assert part(book, "xl/metadata.xml") == part(tmp_path / "oracle.xlsx", "xl/metadata.xml")
    for name in ("[Content_Types].xml", "xl/_rels/workbook.xml.rels"):
        entry = next(e for e in part(tmp_path / "oracle.xlsx", name).split("<") if "metadata.xml" in e)
        kind = re.search(r'(ContentType|Type)="([^"]*)"', entry)[2]
        assert re.search(
            rf'<[^<]*{re.escape(kind)}[^<]*metadata.xml"|<[^<]*metadata.xml"[^<]*{re.escape(kind)}', part(book, name)
        )


def test_office_open_xml_is_valid(book):
    found = OpenXmlValidator(file_format=FileFormat.MICROSOFT_365, max_errors=0, security_validation=True).validate(
        book
    )
    assert [f"{e.part_uri}: {e.description}" for e in found.errors] == []


def test_the_committed_workbook_is_that_of_todays_code():
    assert not publish.is_stale(), "run motionbook templates"


def test_a_changed_workbook_is_noticed(tmp_path, monkeypatch):
    monkeypatch.setattr(publish, "BOOK", tmp_path / "motion-functions.xlsx")
    assert publish.is_stale()
    publish.write_book(publish.BOOK)
    assert not publish.is_stale()


@pytest.mark.parametrize("command", [("verify",), ("inputs",), ("regenerate", "-o", "new.xlsx")], ids=lambda c: c[0])
def test_it_is_no_machine_and_the_command_says_so_in_a_line(book, command):
    done = CliRunner().invoke(app, [*command, str(book)])
    assert done.exit_code
    assert "holds the functions MOTION.*" in done.output + str(done.exception or "")
