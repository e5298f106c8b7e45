"""Printed pages end between things: no chart is cut, no table that a page has room for, no text runs under a chart."""

from functools import cache
from itertools import pairwise

import openpyxl
import pytest

from tests.workbook.writing.carlito import room
from tests.workbook.writing.test_widths import WRAPPED, declared, wide
from workbook.build import committed_descriptions
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES
from workbook.writing.layout import COLUMN_WIDTH

BOOKS = committed_descriptions()
WIDE, HIGH = 297 / 25.4 * 72, 210 / 25.4 * 72


@cache
def opened(book):
    return openpyxl.load_workbook(book)


def printed(path, book):
    """Yield each sheet of a book with its page in the file, its last printed row, and where its pages begin and end."""
    machine = read_machine(path)
    for sheet in (one for one in TEMPLATES[machine.template].declare(machine).sheets if not one.unprinted):
        page = opened(book)[sheet.title]
        last = int(page.print_area.rpartition("$")[2])
        ends = [one.id for one in page.row_breaks.brk]
        yield sheet, page, last, list(pairwise([0, *ends, last]))


@pytest.mark.sample(5)
@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_a_page_ends_between_charts_and_tables_and_is_no_higher_than_paper(path, committed_book):
    """Of tables those that a page has room for; a page that is higher the program breaks once more, where it likes."""
    for sheet, page, last, between in printed(path, committed_book(path)):
        across = openpyxl.utils.range_boundaries(page.print_area.rpartition("!")[2])[2]
        for chart, row, column, width, height in (chart for chart in sheet.charts if chart[1] <= last):
            high = [page.row_dimensions[r].height or 15 for r in range(row, row + height)]
            rows = next(n for n in range(1, height + 1) if sum(high[:n]) >= 15 * height or n == height)
            assert any(top < row and row + rows - 1 <= end for top, end in between), (sheet.title, chart.title)
            assert column + width - 1 <= across, (sheet.title, chart.title)
        tables = [
            (block.row if block.shared_heads else block.row - 3, block.row + block.size - 1, block.name)
            for block in sheet.blocks
            if block.is_table
        ]
        for first, end, name in tables:
            if end <= last and fits(page, first - 1, end, sheet.head, 0.9):
                assert any(top < first and end <= bottom for top, bottom in between), (sheet.title, name)
        for top, end in [] if page.page_setup.fitToHeight else between:
            assert fits(page, max(top, sheet.head) + 1, end, sheet.head, 1.0), (sheet.title, top, end)


def fits(page, first, last, head, share):
    """Whether rows take no more than a share of a page, with the titles over them."""
    across = page.print_area.rpartition(":")[2].split("$")[1]
    columns = range(1, openpyxl.utils.column_index_from_string(across) + 1)
    letters = [openpyxl.utils.get_column_letter(column) for column in columns]
    width = sum(5.25 * page.column_dimensions[letter].width + 3.75 for letter in letters)
    margins = page.page_margins
    is_fitted = getattr(page.sheet_properties.pageSetUpPr, "fitToPage", False)
    set_scale = 1.0 if is_fitted else (page.page_setup.scale or 100) / 100
    scale = min(set_scale, (WIDE - 72 * (margins.left + margins.right)) / width)
    room = share * (HIGH - 72 * (margins.top + margins.bottom)) / scale
    return sum(page.row_dimensions[r].height or 15 for r in [*range(1, head + 1), *range(first, last + 1)]) <= room


@pytest.mark.sample(5)
@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_no_text_and_no_cell_is_under_a_chart(path):
    book, widths_of = declared(path)
    assert [text for sheet in book.sheets for text in under(sheet, widths_of[sheet.title])] == []
    for sheet in book.sheets:
        filled = {(cell.row, cell.column) for block in sheet.blocks for cell in block.cells()}
        for chart, row, column, width, height in sheet.charts:
            covered = {(r, c) for r in range(row, row + height - 1) for c in range(column, column + width)}
            assert not filled & covered, (sheet.title, chart.title)


def under(sheet, room_of):
    """Yield the texts that have no room before the chart in their rows."""
    taken = {(t.row, t.column) for t in sheet.texts if t.text}
    taken |= {(cell.row, cell.column) for block in sheet.blocks for cell in block.cells()}
    for _, row, column, _, height in sheet.charts:
        beside = [t for t in sheet.texts if row <= t.row < row + height - 1 and t.column < column]
        for text in beside:
            before = range(text.column, column)
            if text.style not in WRAPPED and not any((text.row, c) in taken for c in before[1:]):
                has = sum(room(room_of.get(c, COLUMN_WIDTH)) - room(0) for c in before)
                if wide(text.text, text.style) > has:
                    yield sheet.title, text.text
