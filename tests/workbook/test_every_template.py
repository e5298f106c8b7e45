"""What holds of every template: random machines come back from their books, and books may be edited anyhow."""

import random

import openpyxl
import pytest

from tests.mutation.bench import smaller
from tests.mutation.machines import machine
from tests.workbook import office
from tests.workbook.test_real_edits import numbers
from workbook.build import build, inputs
from workbook.judging.matching import is_formula
from workbook.judging.verify import verify
from workbook.reading.entries import read_machine, write_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.witnesses.libreoffice import convert, program

needs_office = pytest.mark.skipif(program() is None, reason="LibreOffice is not on this machine")


@pytest.fixture(scope="module", params=[*TEMPLATES, "indexing-overlap-stations"])
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


@pytest.mark.parametrize("seed", range(4))
def test_a_random_machine_comes_back_from_its_book_and_its_description(layout, seed, tmp_path):
    drawn, path, text = machine(layout, random.Random(seed)), tmp_path / "book.xlsx", tmp_path / "machine.toml"
    build(drawn, path)
    assert inputs(path) == (drawn, [])
    assert verify(path).findings == []
    text.write_text(write_machine(drawn), encoding="utf-8")
    assert read_machine(text) == drawn


@needs_office
def test_a_book_saved_by_libreoffice_agrees(layout, book, tmp_path):
    saved = convert(book, "xlsx", tmp_path)
    report = verify(saved, ["pycel", "saved"])
    assert report.findings == []
    assert report.unmatched == []
    assert numbers(inputs(saved)[0]) == numbers(layout)


@needs_office
def test_rows_above_every_table_columns_and_other_titles_change_nothing(layout, book, tmp_path):
    declared = TEMPLATES[layout.template].declare(layout)
    lines = []
    for number, sheet in enumerate(declared.sheets):
        lines.append(f"sheet = book.Sheets.getByIndex({number})")
        lines += [f"sheet.Rows.insertByIndex({row - 1}, 2)" for row in rows_to_insert(sheet)]
        lines += ["sheet.Columns.insertByIndex(0, 1)", f'sheet.Name = "Foglio {number} à l\'œuvre"']
    edited = office.edit(book, tmp_path / "edited.xlsx", lines)
    report = verify(edited)
    assert [f"{f.sheet}!{f.cell} {f.kind}" for f in report.findings] == []
    assert report.unmatched == []
    assert numbers(inputs(edited)[0]) == numbers(layout)


def rows_to_insert(sheet):
    """The first row of each table, from below, where no other table would be torn apart."""
    tables = [block for block in sheet.blocks if block.size > 1]
    firsts = {table.row for table in tables}
    whole = [row for row in firsts if not any(t.row < row < t.row + t.size for t in tables)]
    return sorted(whole, reverse=True)


def test_looks_charts_and_protection_are_the_engineers_own(book, tmp_path):
    opened = openpyxl.load_workbook(book)
    for sheet in opened.worksheets:
        sheet.protection.set_password("secret")
        sheet._charts = []
        sheet.column_dimensions["C"].hidden = True
        sheet.row_dimensions[20].hidden = True
    opened.move_sheet(opened.sheetnames[1], 2)
    opened.save(tmp_path / "edited.xlsx")
    assert verify(tmp_path / "edited.xlsx").findings == []
