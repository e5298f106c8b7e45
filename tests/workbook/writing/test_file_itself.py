"""The file itself: valid Office Open XML, sound to a spreadsheet auditor, the same bytes each time, wherever built."""

import json
import os
import re
import subprocess
import sys
import zipfile
from filecmp import cmp

import openpyxl
import pytest
from openpyxl.utils import get_column_letter
from openxml_audit import FileFormat, OpenXmlValidator
from spreadsheet_auditor.audit import main as audit

from tests.tiers import by_day
from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as, small
from workbook.build import build
from workbook.reading.descriptions import write_machine
from workbook.templates import TEMPLATES

BETWEEN = pytest.param(FileFormat.OFFICE_2019, marks=pytest.mark.nightly)
BUILD = """
import sys
from pathlib import Path
from workbook.build import build
from workbook.reading.descriptions import read_machine, write_machine
build(read_machine(Path(sys.argv[1])), Path(sys.argv[2]))
"""
OTHER_SUM = """
import builtins, functools, math, operator, sys

def as_other_pythons_add(values, /, start=0, sum=sum):
    values = list(values)
    if not all(type(value) is float for value in values):
        return sum(values, start)
    return functools.reduce(operator.add, values, start) if sys.version_info >= (3, 12) else math.fsum(values)

builtins.sum = as_other_pythons_add
"""


@pytest.fixture(scope="module", params=by_day(DESCRIBED, COMPOSED))
def template(request):
    """The template of a committed description, and that with fewer rows."""
    return shortened(request.param)


@pytest.fixture(scope="module")
def book(template, tmp_path_factory):
    """The formulas of the committed books in fewer rows: what is judged are patterns, and that takes its time."""
    path = tmp_path_factory.mktemp("short") / "book.xlsx"
    build(template[1], path)
    return path


def shortened(name):
    template, machine = committed_as(name)
    sizes = machine.sizes.model_copy(update=dict.fromkeys(("law", "cycle"), 12))
    return template, machine.model_copy(update={"sizes": sizes})


@pytest.mark.parametrize("office", [FileFormat.OFFICE_2010, FileFormat.MICROSOFT_365, BETWEEN])
@pytest.mark.sample(3)
def test_office_open_xml_is_valid(book, office):
    """No error and no warning either: openpyxl's own slips (order in fonts, texts in cells) are mended in writing."""
    found = OpenXmlValidator(file_format=office, max_errors=0, security_validation=True).validate(book)
    assert [f"{e.part_uri}: {e.description}" for e in found.errors] == []


def by_row(book):
    """Return the cells that have a formula of their own by declaration, in a column of others."""
    cells = set()
    for block in book.blocks.values():
        fixed = not block.is_table and block.sheet.title == "Straight line"  # coefficients of 1 and 0, in turn
        name_of_axis = not block.is_table and block.sheet.title == "Timing"  # above the rows of its phases
        for cell in block.cells():
            formula = cell.quantity.formula
            if fixed or name_of_axis or (formula is not None and not isinstance(formula, str)):
                cells.add(f"{block.sheet.title}!{get_column_letter(cell.column)}{cell.row}")
    return cells


def audited(book, folder):
    settings = folder / "settings.json"
    settings.write_text(
        json.dumps({"recalc": {"enabled": False}, "limits": {"max_formulas": 10**6, "timeout_seconds": 0}})
    )
    answer = folder / "findings.json"
    audit([str(book), "--config", str(settings), "--json", str(answer), "--out", str(folder / "report.md")])
    return json.loads(answer.read_text())


def folded(found, book):
    """Whether what is found hidden are workings beside tables, which are folded by declaration."""
    titles = [sheet.title for sheet in book.sheets if sheet.folded]
    hidden = [re.match(r"Hidden columns [\w, ]+ on (.*) feed ", text) for text in found["evidence"]]
    return found["rule_id"] == "HIDDEN_STRUCTURE_IN_TOTAL" and all(one and one[1] in titles for one in hidden)


def test_auditor_finds_nothing_of_level_high(book, template, tmp_path):
    answer, declared = audited(book, tmp_path), template[0].declare(template[1])
    own = by_row(declared)
    high = [f for f in answer["findings"] if f["severity"] in ("High", "Critical") and not folded(f, declared)]
    faults = [f for f in high if f["rule_id"] != "FORMULA_DRIFT" or f["location"] not in own]
    assert [(f["rule_id"], f["location"], f["evidence"]) for f in faults] == []
    assert answer["coverage"]["complete"]


def test_auditor_is_awake(tmp_path):
    """A number typed over a formula in the middle of a column is found; so silence means something."""
    build(shortened(COMPOSED)[1], tmp_path / "book.xlsx")
    spoiled = openpyxl.load_workbook(tmp_path / "book.xlsx")
    sheet = spoiled["ACS"]
    row = next(c.row for c in sheet["D"] if isinstance(c.value, str) and "piece_y" in c.value) + 3
    sheet.cell(row, 4).value = 0.25
    spoiled.save(tmp_path / "spoiled.xlsx")
    found = audited(tmp_path / "spoiled.xlsx", tmp_path)["findings"]
    assert any(f["severity"] not in ("Low", "Info") and f["cell"] == f"D{row}" for f in found)


def test_bytes_are_the_same_each_time(book, template, tmp_path):
    again = tmp_path / "again.xlsx"
    build(template[1], again)
    assert cmp(again, book, shallow=False)  # no diff of a million bytes


def built_elsewhere(machine, folder, program=BUILD, without=""):
    """The book of a machine, built by a program in a process of its own, one variable of the environment left out."""
    described, book = folder / "short.toml", folder / "elsewhere.xlsx"
    described.write_text(write_machine(machine), encoding="utf-8")
    environment = {name: value for name, value in os.environ.items() if name != without}
    subprocess.run([sys.executable, "-c", program, str(described), str(book)], check=True, env=environment)
    return book


def test_bytes_do_not_hang_on_lxml(book, template, tmp_path):
    """openpyxl writes through lxml where it is installed, and then other bytes, unless it is told not to."""
    pytest.importorskip("lxml")
    assert cmp(built_elsewhere(template[1], tmp_path, without="OPENPYXL_LXML"), book, shallow=False)


def test_bytes_do_not_hang_on_how_python_adds_floats(book, template, tmp_path):
    """Since 3.12 sum() carries what it rounds off: a sum of floats that is left to it is another on other Pythons."""
    assert cmp(built_elsewhere(template[1], tmp_path, OTHER_SUM + BUILD), book, shallow=False)


def test_every_chart_has_a_title_and_alternative_text(book):
    with zipfile.ZipFile(book) as parts:
        drawings = "".join(parts.read(n).decode() for n in parts.namelist() if re.match(r"xl/drawings/d", n))
    frames = re.findall(r"<xdr:cNvPr [^>]*>", drawings)
    assert len(frames) > 10
    assert all(re.search(r'name="(?!Chart \d)[^"]+" descr="[^"]{20,}"', frame) for frame in frames)


def test_an_engineer_writes_beside_the_tables_of_a_protected_sheet(tmp_path):
    """A cell that is not there is as its column says; notes need no permission where objects are not protected."""
    build(small(), tmp_path / "book.xlsx")
    declared = TEMPLATES["machine"].declare(small())
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    for sheet in declared.sheets:
        page, used = book[sheet.title], max(column for block in sheet.blocks for column in block.columns.values())
        assert (page.protection.sheet, page.protection.objects) == (True, False)
        free = {c for one in page.column_dimensions.values() if not one.protection.locked
                for c in range(one.min, one.max + 1)}  # fmt: skip
        assert free == set(range(used + 2, 16_385))
        locked = {cell.column for row in page.iter_rows() for cell in row if cell.value is not None
                  and cell.protection.locked}  # fmt: skip
        assert locked
    notes = [str(cell.value) for (cell,) in book["Summary"].iter_rows(min_col=2, max_col=2)]
    assert any("protected without a password" in note for note in notes)
