"""No label is cut: every text of every committed book has room for what it says, in Calibri as in Carlito."""

from functools import cache

import pytest

from tests.workbook.writing.carlito import pixels, room
from workbook.book.rows import as_rows
from workbook.book_layout import NAME as LAYOUT
from workbook.build import committed_descriptions
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER as FOLDER_OF_TEMPLATES
from workbook.templates import TEMPLATES
from workbook.writing import style
from workbook.writing.layout import COLUMN_WIDTH, WIDTHS, PossibleTexts, text_width, widths

WRAPPED = ("header", "equation")
INDENT = 9  # pixels, of a text that keeps off a number before it
FARTHEST = 15  # columns over which a text may run, where they are empty


@cache
def declared(path):
    """Return a book as declared, and the widths of its columns, by sheet."""
    machine = read_machine(path)
    book = TEMPLATES[machine.template].declare(machine)
    return book, widths_of(book)


def widths_of(book):
    standing = PossibleTexts(book)
    return {sheet.title: widths(sheet, standing) for sheet in book.sheets}


def wide(text, style_name):
    """How wide a text is in its style; of one that wraps, its longest word."""
    font = style.TEXTS[style_name].font
    words = text.split() if style_name in WRAPPED else [text]
    return max((pixels(word, font.sz, bool(font.b), bool(font.i)) for word in words), default=0.0)


def cut(sheet, room_of):
    """Yield the texts of a sheet that do not fit, with what they take and what they have, in pixels.

    Workings that are closed below a page have its columns, whatever their own heads and labels take.
    """
    taken = {(t.row, t.column) for t in sheet.texts if t.text}
    taken |= {(cell.row, cell.column) for block in sheet.blocks for cell in block.cells()}
    for text in (text for text in sheet.texts if not 0 < sheet.folded_rows <= text.row):
        column, has = text.column, room(room_of.get(text.column, COLUMN_WIDTH))
        if text.style not in (*WRAPPED, "units"):
            while (text.row, column + 1) not in taken and column < text.column + FARTHEST:
                column += 1
                has += room(room_of.get(column, COLUMN_WIDTH)) - room(0)
        wraps = sheet.one_page and text.style == "units"
        if wide(text.text, "header" if wraps else text.style) > has:
            yield sheet.title, text.text, round(wide(text.text, text.style)), round(has)


def shortened(book, wide):
    """Yield the texts for people that do not fit into columns so wide, or run under a chart, with what they lack."""
    for sheet in book.sheets:
        full = {(text.row, text.column) for text in sheet.texts if text.text}
        columns = [column for block in sheet.blocks for column in block.by_column()]
        full |= {
            (c.row, c.column) for cells in columns for c in cells
            if c.quantity.formula is not None or c.content not in (None, "")
        }  # fmt: skip
        for _, row, column, width, height in sheet.charts:
            full |= {(r, c) for r in range(row, row + height - 1) for c in range(column, column + width)}
        texts = [c for cells in columns for c in cells if isinstance(c.expected, str)]
        for cell in (cell for cell in texts if cell.quantity.name != LAYOUT):
            lacks = lacking(cell, wide[sheet.title], full) if cell.quantity.role != "sentence" else 0
            if lacks > 0:
                yield sheet.title, cell.block.name, cell.quantity.name, cell.expected or cell.content, round(lacks)


def lacking(cell, wide, full):
    """How many pixels a text lacks in its cell and, where it may run over them, in the empty ones beside it."""
    q, text = cell.quantity, cell.content if cell.quantity.formula is None else cell.expected
    if not isinstance(text, str):
        return 0
    is_table = cell.block.is_table
    font = style.ROLES["calculation" if is_table and q.role == "result" else q.role].font
    look = style.aligned(q, is_table, cell.column)
    has = room(wide.get(cell.column, COLUMN_WIDTH)) - look.indent * INDENT
    step, column = {"left": 1, "right": -1}.get(look.side, 0), cell.column
    while step and not q.wrap and 1 < column + step < cell.column + FARTHEST and (cell.row, column + step) not in full:
        column += step
        has += room(wide.get(column, COLUMN_WIDTH)) - room(0)
    return max((pixels(part, font.sz, bool(font.b)) for part in (text.split() if q.wrap else [text])), default=0) - has


@pytest.mark.sample(3)
@pytest.mark.parametrize("path", committed_descriptions(), ids=lambda path: path.stem)
def test_no_text_is_cut(path):
    """Results of formulas too: names of products, axes, laws, sheets. Letters are counted rather too wide."""
    book, room_of = declared(path)
    assert [label for sheet in book.sheets for label in cut(sheet, room_of[sheet.title])] == []
    assert list(shortened(book, room_of)) == []
    for text, kind in {(t.text, t.style) for sheet in book.sheets for t in sheet.texts if t.style in WRAPPED}:
        font = style.TEXTS[kind].font
        assert text_width(text, font.sz) * pixels("0") >= 0.97 * pixels(text, font.sz, bool(font.b)), text


LONG = "Servomotor of a long name, with brake and encoder, no. {}"


def test_columns_grow_with_the_names_of_products():
    machine = read_machine(FOLDER_OF_TEMPLATES / "machine.toml")
    chosen = machine.selection
    named = {
        kind: [row.model_copy(update={"name": LONG.format(n)}) for n, row in enumerate(getattr(chosen, kind))]
        for kind in ("motors", "reducers")
    }
    single = {"motor": LONG.format(0), "reducer": LONG.format(0)} if hasattr(chosen, "motor") else {}
    machine = machine.model_copy(update={"selection": chosen.model_copy(update=named | single)})
    book = TEMPLATES[machine.template].declare(machine)
    assert list(shortened(book, widths_of(book))) == []
    usual = {sheet.title: WIDTHS | sheet.widths for sheet in book.sheets}
    assert len({found[1:3] for found in shortened(book, usual)}) > 3


def test_a_column_has_room_for_what_may_stand_there_later():
    """Of the drives of a machine, whose motors are entered, for each name of the catalogue and of what limits them."""
    machine = read_machine(FOLDER_OF_TEMPLATES / "machine.toml")
    book, room_of = declared(FOLDER_OF_TEMPLATES / "machine.toml")
    block = book.blocks["axes_short"]
    motor = next(q for q in block.quantities if q.name == "motor")
    assert set(as_rows(motor.value, block.size, "motor")) <= {"as entered", "–"}
    names = {product.name for product in machine.selection.motors}
    assert names <= PossibleTexts(book).texts(block, motor)
    wide = room_of[block.sheet.title][block.columns["motor"]]
    assert all(pixels(name) <= room(wide) for name in names)
