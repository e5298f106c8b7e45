"""What holds of every template: random machines come back from their books, and books may be edited anyhow."""

import random
import tempfile
from pathlib import Path

import openpyxl
import pytest
from openpyxl.utils import get_column_letter

from tests.mutation.bench import smaller
from tests.mutation.machines import machine
from tests.tiers import by_day, nights, seed
from tests.workbook import office
from tests.workbook.cells import disagreeing, entered
from tests.workbook.composed import COMPOSED, DESCRIBED
from tests.workbook.judging.test_real_edits import numbers
from workbook.build import build, committed_descriptions, read_inputs
from workbook.judging.matching import is_formula
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine, write_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import libreoffice_path

STATIONS = "indexing-overlap-stations"
DAY, MACHINES = 7, 16  # random machines of each layout, the same every day
needs_office = pytest.mark.skipif(libreoffice_path() is None, reason="LibreOffice is not on this machine")


@pytest.fixture(scope="module", params=by_day([*DESCRIBED, STATIONS], COMPOSED))
def layout(request):
    return smaller(read_machine(FOLDER / f"{request.param}.toml"))


@pytest.fixture(scope="module")
def book(layout, tmp_path_factory):
    path = tmp_path_factory.mktemp("book") / "book.xlsx"
    build(layout, path)
    return path


@pytest.mark.parametrize("template", TEMPLATES.values(), ids=TEMPLATES)
def test_every_formula_cell_has_an_engine_value(template):
    cells = [cell for cell in template.declare(read_machine(template.description)).cells() if is_formula(cell.content)]
    assert [f"{c.block.name}.{c.quantity.name}[{c.i}]" for c in cells if c.expected is None] == []
    assert len(cells) > 10_000


@pytest.mark.parametrize("k", [0, *nights(3)])
def test_a_random_machine_comes_back_from_its_book(layout, k, tmp_path):
    drawn, path = machine(layout, random.Random(seed(k))), tmp_path / "book.xlsx"
    build(drawn, path)
    assert read_inputs(path) == (drawn, [])
    assert verify(path).findings == []


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
@pytest.mark.sample(2)
def test_every_committed_book_verifies(path, committed_book):
    assert verify(committed_book(path)).findings == []


@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
@pytest.mark.sample(2)
def test_every_committed_machine_comes_back_from_its_cells(path):
    given = read_machine(path)
    assert entered(TEMPLATES[given.template], given) == (given, [])


def test_every_variation_agrees_with_the_engine_and_comes_back_from_its_cells(layout):
    template = TEMPLATES[layout.template]
    for number, variation in enumerate(template.variants(layout), 1):
        assert disagreeing(template, variation)[0] == [], number
        assert entered(template, variation) == (variation, []), number


@pytest.mark.parametrize("run", [None, *nights(1)])
def test_every_cell_agrees_with_the_engine_at_random_machines(layout, run):
    """All cells from all others, nothing assumed: some thousand formulas at machines that nobody chose."""
    dice, count = (random.Random(DAY), MACHINES) if run is None else (random.Random(seed(run)), 100)
    for drawn in (machine(layout, dice) for _ in range(count)):
        assert disagreeing(TEMPLATES[layout.template], drawn)[0] == [], drawn.model_dump_json()
        assert read_back(drawn) == drawn


def read_back(given):
    """The machine that its description describes."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "machine.toml")
        path.write_text(write_machine(given), encoding="utf-8")
        return read_machine(path)


def test_another_name_is_no_finding_and_leaves_no_label_behind(layout, book, tmp_path):
    """Of an axis, a tool, a motor, a body: what shows a name follows it."""
    declared = TEMPLATES[layout.template].declare(layout)
    entries = [cell for cell in declared.cells() if cell.quantity.role == "input" and isinstance(cell.content, str)]
    names = {cell.content for cell in entries if cell.quantity.key.rpartition(".")[2] in ("name", "group", "title")}
    opened = openpyxl.load_workbook(book)
    for cell in entries:
        if cell.content in names:
            opened[cell.block.sheet.title].cell(cell.row, cell.column).value = f"Z {cell.content}"
    opened.save(tmp_path / "edited.xlsx")
    report = verify(tmp_path / "edited.xlsx")
    assert [f"{f.sheet}!{f.cell} {f.kind}" for f in report.findings] == []
    assert report.notices == []


@needs_office
@pytest.mark.nightly  # by day a press has rows, columns and titles put in: test_real_edits.py
def test_rows_above_every_table_columns_and_other_titles_change_nothing(layout, book, tmp_path):
    declared = TEMPLATES[layout.template].declare(layout)
    lines = []
    for number, sheet in enumerate(declared.sheets):
        lines.append(f"sheet = book.Sheets.getByIndex({number})")
        lines += [f'sheet.getCellRangeByName("{a1}").Value = {value!r}' for a1, value in first_number(sheet)]
        lines += [f"sheet.Rows.insertByIndex({row - 1}, 2)" for row in rows_to_insert(sheet)]
        lines += ["sheet.Columns.insertByIndex(0, 1)", f'sheet.Name = "Foglio {number} à l\'œuvre"']
    edited = office.edit(book, tmp_path / "edited.xlsx", lines)
    report = verify(edited, ["pycel", "saved"])
    assert [f"{f.sheet}!{f.cell} {f.kind}" for f in report.findings] == []
    assert report.own == []
    assert numbers(read_inputs(edited)[0]) == numbers(layout)


def first_number(sheet):
    """Where the first number of a sheet is entered, and which; entered again, it has LibreOffice compute anew."""
    for block in sheet.blocks:
        for cell in block.cells():
            if cell.quantity.role == "input" and isinstance(cell.content, int | float):
                return [(f"{get_column_letter(cell.column)}{cell.row}", cell.content)]
    return []


def rows_to_insert(sheet):
    """The first row of each table, from below, where no other table would be torn apart."""
    tables = [block for block in sheet.blocks if block.size > 1]
    firsts = {table.row for table in tables}
    whole = [row for row in firsts if not any(t.row < row < t.row + t.size for t in tables)]
    return sorted(whole, reverse=True)
