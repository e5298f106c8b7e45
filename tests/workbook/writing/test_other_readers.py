"""Programs of other makers read each formula and each value of a book as openpyxl does."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import openpyxl
import pytest

from tests.mutation.bench import smaller
from tests.tiers import by_day
from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as
from workbook.build import build

PACKAGES = ("exceljs@4.4.0", "xlsx@0.18.5")
SCRIPT = Path(__file__).with_name("readers.js")
PATIENCE = 300  # seconds in which npm has to come with the packages


@pytest.fixture(scope="module", params=by_day(DESCRIBED, COMPOSED))
def book(request, tmp_path_factory):
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(smaller(committed_as(request.param)[1]), path)
    return path


@pytest.fixture(scope="module")
def packages():
    """The folder of ExcelJS and SheetJS, installed once beside the Python packages."""
    kept = Path(sys.prefix) / "-".join(["readers", *PACKAGES])
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("Node.js is not there, and with it neither ExcelJS nor SheetJS")
    if not kept.exists():
        with tempfile.TemporaryDirectory(dir=sys.prefix) as folder:
            options = ["--no-audit", "--no-fund", "--ignore-scripts", "--prefix", folder]
            try:
                command = [shutil.which("npm"), "install", *options, *PACKAGES]
                subprocess.run(command, check=True, timeout=PATIENCE, capture_output=True)
            except subprocess.SubprocessError as error:
                pytest.skip(f"npm could not install ExcelJS and SheetJS: {error}")
            if not kept.exists():
                Path(folder, "node_modules").rename(kept)
    return kept


def spoken(value):
    """The value of a cell; None for a text of no letters, which some programs tell from nothing."""
    return None if value == "" else value


def contents(path):
    """Formula and value of each cell that has either, by sheet and place."""
    formulas, values = (openpyxl.load_workbook(path, data_only=shown) for shown in (False, True))
    found = {}
    for sheet in formulas:
        shown = values[sheet.title]
        for cell in (cell for row in sheet.iter_rows() for cell in row if cell.value is not None):
            formula = cell.value[1:] if cell.data_type == "f" else None
            found[sheet.title, cell.coordinate] = formula, spoken(shown[cell.coordinate].value)
    return found


@pytest.fixture
def by_javascript(book, packages):
    """What ExcelJS and SheetJS read: by program, sheet and place."""
    environment = os.environ | {"NODE_PATH": str(packages)}
    command = [shutil.which("node"), str(SCRIPT), str(book)]
    return json.loads(subprocess.run(command, check=True, env=environment, stdout=subprocess.PIPE).stdout)


def test_programs_in_javascript_read_every_formula_and_value(book, by_javascript):
    expected = contents(book)
    assert sum(formula is not None for formula, _ in expected.values()) > 1_000
    for program, sheets in by_javascript.items():
        read = {(name, place): (formula, spoken(value))
                for name, cells in sheets.items() for place, (formula, value) in cells.items()}  # fmt: skip
        wrong = {at: (cell, read.get(at)) for at, cell in expected.items() if read.get(at, (None, None)) != cell}
        assert not wrong, program


def test_calamine_reads_every_value(book):
    calamine = pytest.importorskip("python_calamine")
    read = calamine.load_workbook(str(book))
    pages = {name: read.get_sheet_by_name(name).to_python(skip_empty_area=False) for name in read.sheet_names}
    wrong = {}
    for (sheet, place), (_, value) in contents(book).items():
        column, row = openpyxl.utils.cell.coordinate_from_string(place)
        cells = pages[sheet][row - 1] if row <= len(pages[sheet]) else []
        across = openpyxl.utils.column_index_from_string(column) - 1
        found = cells[across] if across < len(cells) else None
        if spoken(found) != value:
            wrong[sheet, place] = value, found
    assert not wrong
