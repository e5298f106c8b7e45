"""The first sheet of every book, a printed page for who gets the machine, and what stands at the head of all sheets.

On the first, links to every sheet, how to use the book, and its sources follow below, outside what is printed.
"""

from collections.abc import Sequence
from itertools import count
from typing import Any

import workbook
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import FAILING, IN_ONE, failing_table, in_one, repeat_verdicts, summary
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text
from workbook.book.stamp import stamp_line, stamp_table

CELLS = cell_tables(__file__)


def title_blocks(book: Book) -> None:
    """Head every sheet: its title and purpose, its own verdict and the book's, machine and revision."""
    repeat_verdicts(book)
    identified = str(book.blocks["book_block"].quantities[0].value)
    for i, sheet in enumerate(book.sheets, 1):
        block = Quantity(f"block{i}", "Title block", role="sentence", formula="=book_block", value=identified)
        sheet.put(block._replace(align="left"), 3, FIRST)
        sheet.texts.append(Text(2, FIRST, sheet.purpose, "note"))
        if sheet is book.sheets[0]:
            head(sheet)
        else:
            sheet.texts.append(Text(1, FIRST, sheet.title, "title"))
            links = {TITLE: "A1"} | sheet.links
            for column, (title, cell) in zip(count(sheet.last_column, -1), links.items(), strict=False):
                sheet.texts.append(Text(3, column, title, "link", title, cell))


TITLE = "Summary"
SOURCES = {
    "S1": "H. Giberti, Motion curve planning 02, Automated Mechanical System Design, Università di Pavia",
    "S2": "Timing Diagram (Part 3 - Cycloid Cam Profile Analysis), Mechanical Design Handbook, 24 November 2009",
    "S3": "Functional Mechanical Design, Exercise 1: Motion Law",
    "S4": "Introduction to Mechatronics (MCT 151): Actuator Sizing, Ain Shams University, Fall 2017",
    "S5": "R. Strada, B. Zappa, H. Giberti, A unified design procedure for flying machining operations (draft)",
}
USE = (
    "1  Enter: change the cells with a fill and blue figures. Everything else follows, tables and charts too.",
    "2  Look: results stand in bold; a check says OK or FAIL in words, and each sheet repeats the overall verdict.",
    "3  Verify: save the book and run  motionbook verify BOOK.xlsx  - "
    "every formula cell is compared with an independent engine.",
    "The sheets are protected without a password: Review > Unprotect Sheet (LibreOffice: Tools > Protect Sheet).",
    "Yours are the cells with a fill, the columns beside the tables, and notes.",
    "Workings are not printed, nor are Names, Catalogue, Laws, the laws' sheets, unless print_also asks for them.",
)
COLUMNS = 17
WIDTHS: dict[int, float] = {
    FIRST: 14.5,
    FIRST + 1: 17,
    FIRST + 2: 20.5,
    9: 8,
    10: 8,
    11: 8,
    12: 8.5,
    13: 8,
    15: 13,
    16: 16,
}
SENTENCE, FIGURES = 4, 6  # rows of the verdict in words, and of figures
# width of a letter at most, and of a column that has none of its own, in digits
LETTER, COLUMN = 0.95, 9.5
ENTERED = 16  # the column of entries
PICTURE_ROW, PICTURE_ROWS = 11, 14


IDENTIFIED = {"number": "Machine number", "revision": "Revision", "author": "Author", "date": "Date"}
"""entries that tell a machine, and a state of its design, from others"""


def summary_sheet(
    book: Book, machine: Any, purpose: str, figures: Sequence[Quantity], more: Sequence[Quantity] = ()
) -> Sheet:
    """Declare the head of the first sheet, with its figures, large; ``more`` results stand below what is printed.

    A table of axes may follow; :func:`close_summary` adds the rest.
    """
    cell = CELLS["summary_sheet"]
    sheet = book.sheet(TITLE, purpose)
    book.stamp = machine.stamp
    sheet.one_page, sheet.print_columns = True, COLUMNS
    sheet.widths = dict(WIDTHS)
    sheet.more = more
    entered = (
        cell("book_title", machine.title),
        *(cell("book_{key}", getattr(machine, key), key=key, label=label) for key, label in IDENTIFIED.items()),
    )
    for row, quantity in enumerate(entered, FIGURES):
        sheet.texts.append(Text(row, ENTERED - 1, quantity.label, "aside"))
        sheet.put(quantity, row, ENTERED)
    column = FIRST
    for quantity in figures:
        unit = sheet.figure(quantity, FIGURES, column)
        room = LETTER * max(len(quantity.label), len(unit)) + 1
        while room > 0:
            room, column = room - WIDTHS.get(column, COLUMN), column + 1
    sheet.row = PICTURE_ROW + PICTURE_ROWS
    return sheet


def close_summary(book: Book, sources: tuple[str, ...]) -> None:
    """Declare what needs all other sheets: the picture, what is to mend; then what is not printed."""
    cell = CELLS["close_summary"]
    for each in book.sheets:
        each.place_messages()
    sheet = book.sheets[0]
    sheet.put(cell("about_verdict", in_one(book), formula=IN_ONE), SENTENCE, FIRST)
    drawn = [chart for other in book.sheets[1:] for chart, *_ in other.charts]
    for picture in drawn[:1]:
        sheet.charts.append((picture, PICTURE_ROW, FIRST, COLUMNS - FIRST + 1, PICTURE_ROWS))
    stamp_line(book, sheet, SENTENCE + 1, ENTERED)
    sheet.heading("To mend")
    failing_table(sheet, "mend")
    sheet.not_printed_below()
    sheet.heading("More results")
    sheet.rows(CELLS["to_mend"]("mend_count", summary(book).failing, to_mend=FAILING["mend"]), *sheet.more)
    sheet.heading("Contents")
    for other in book.sheets[1:]:
        entry(sheet, Text(sheet.row, FIRST, other.title, "link", other.title), other.purpose)
    sheet.heading("How to use this book")
    mark, block = title_block(book)
    for line in USE:
        sheet.note(line)
    sheet.row += 1
    sheet.rows(
        cell("book_mark", mark, formula=MARK),
        cell("book_block", block, formula=BLOCK),
        cell("book_template", book.template),
        cell("book_version", workbook.__version__),
        cell("book_layout", ""),
    )
    sheet.heading("Sources")
    for key in sources:
        entry(sheet, Text(sheet.row, FIRST, key, "label"), SOURCES[key])
    stamp_table(book, book.blocks["checks"].sheet)


MARK = '=book_title&IF(book_number="","",", no. "&book_number)&IF(book_revision="","",", revision "&book_revision)'
BLOCK = '=book_mark&IF(book_author="","",", "&book_author)&IF(book_date="","",", "&book_date)'


def title_block(book: Book) -> tuple[str, str]:
    """Return machine, number and revision as one text; and this with author and date."""
    title, number, revision, author, date = (
        book.blocks[f"book_{key}"].quantities[0].value or "" for key in ("title", *IDENTIFIED)
    )
    mark = f"{title}{number and f', no. {number}'}{revision and f', revision {revision}'}"
    return mark, f"{mark}{author and f', {author}'}{date and f', {date}'}"


def head(sheet: Sheet) -> None:
    """Declare the title of the first sheet: the machine's, as it is entered."""
    entered = sheet.book.blocks["book_title"].quantities[0].value
    title = Quantity("book_heading", "Title", "", "", "title", '=book_title&""', entered, align="left")
    sheet.put(title, 1, FIRST)


def entry(sheet: Sheet, first: Text, note: str) -> None:
    """Write a line of a list."""
    sheet.texts += [first, Text(sheet.row, FIRST + 1, note, "note")]
    sheet.row += 1
