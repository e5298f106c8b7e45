"""No label is cut: every text of every committed book has room for what it says, in Calibri as in Carlito."""

import pytest

from tests.workbook.writing.carlito import FOLDER, pixels, room
from workbook.build import committed
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES
from workbook.writing import heights, style
from workbook.writing.write import COLUMN_WIDTH, WIDTHS

pytestmark = pytest.mark.skipif(not FOLDER.exists(), reason="Carlito is not there: fonts-crosextra-carlito")
WRAPPED = ("header", "equation")
FARTHEST = 12  # columns over which a text may run, where they are empty


def wide(text, style_name):
    """How wide a text is in its style; of one that wraps, its longest word."""
    font = style.TEXTS[style_name].font
    words = text.split() if style_name in WRAPPED else [text]
    return max((pixels(word, font.sz, bool(font.b), bool(font.i)) for word in words), default=0.0)


def cut(sheet):
    """Yield the texts of a sheet that do not fit, with what they take and what they have, in pixels."""
    widths = WIDTHS | sheet.widths
    taken = {(t.row, t.column) for t in sheet.texts if t.text}
    taken |= {(cell.row, cell.column) for block in sheet.blocks for cell in block.cells()}
    for text in sheet.texts:
        column, has = text.column, room(widths.get(text.column, COLUMN_WIDTH))
        if text.style not in (*WRAPPED, "units"):
            while (text.row, column + 1) not in taken and column < text.column + FARTHEST:
                column += 1
                has += room(widths.get(column, COLUMN_WIDTH)) - room(0)
        if wide(text.text, text.style) > has:
            yield sheet.title, text.text, round(wide(text.text, text.style)), round(has)


@pytest.mark.parametrize("path", committed(), ids=lambda path: path.stem)
def test_no_label_is_cut(path):
    machine = read_machine(path)
    book = TEMPLATES[machine.template].declare(machine)
    assert [found for sheet in book.sheets for found in cut(sheet)] == []


@pytest.mark.parametrize("width", [5, 12, 38])
def test_a_column_holds_its_digits_and_not_two_more(width):
    assert pixels("0" * width) <= room(width) < pixels("0" * (width + 2))


def test_bold_is_wider_and_letters_differ():
    assert pixels("Drive") < pixels("Drive", bold=True)
    assert pixels("iii") < pixels("mmm") / 3


@pytest.mark.parametrize("path", committed()[::4], ids=lambda path: path.stem)
def test_no_wrapped_text_takes_more_room_than_its_row_was_given(path):
    """The letters are counted rather too wide than too narrow."""
    machine = read_machine(path)
    book = TEMPLATES[machine.template].declare(machine)
    texts = {(t.text, t.style) for sheet in book.sheets for t in sheet.texts if t.style in WRAPPED and t.text}
    for text, kind in texts:
        font = style.TEXTS[kind].font
        assert heights.width(text, font.sz) * pixels("0") >= 0.97 * pixels(text, font.sz, bool(font.b)), text
