"""The first sheet of every book, a printed page for who gets the machine, and what stands at the head of all sheets.

On the first, links to every sheet, how to use the book, and its sources follow below, outside what is printed.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import count, pairwise
from typing import Any

import workbook
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import FAILING, IN_ONE, failing_table, in_one, repeat_verdicts
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text
from workbook.book.sentence import NOTHING, CheckSentence, Sentence
from workbook.book.sheet import COLUMN_WIDTH
from workbook.book.stamp import stamp_quantities, stamp_table

CELLS = cell_tables(__file__)


def title_blocks(book: Book) -> None:
    """Head every sheet: its title and purpose, its own verdict and the book's, machine and revision."""
    repeat_verdicts(book)
    identified = str(book.blocks["book_block"].quantities[0].value)
    for i, sheet in enumerate(book.sheets[1:], 2):
        block = Quantity(f"block{i}", "Title block", role="sentence", formula="=book_block", value=identified)
        sheet.put(block._replace(align="left"), 3, FIRST)
        sheet.texts += [Text(1, FIRST, sheet.title, "title"), Text(2, FIRST, sheet.purpose, "note")]
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
WIDTHS: dict[int, float] = dict(enumerate((13, 13, 18, 15, 7.5, 8.5, 8.5, 7.5, 7.5, 7.5, 7.5, 7.5, 8, 8, 17, 7), FIRST))
LAST = max(WIDTHS)
SENTENCE, STAMP, FIGURES = 2, 3, 5  # rows of the verdict in words, of the stamp, of figures
ENTERED = LAST - 1  # the column of entries that identify the machine
LETTER = 0.87  # width of a letter in digits
PICTURE_ROW, PICTURE_ROWS = 9, 18
LARGE = 22.0  # points of the row of figures
MENDING = 2 + FAILING["mend"]  # rows of the table of what is to mend


IDENTIFIED = {"number": "Number", "revision": "Revision", "author": "Author", "date": "Date"}
"""entries that tell a machine, and a state of its design, from others"""


def summary_sheet(
    book: Book,
    machine: Any,
    purpose: str,
    figures: Sequence[Quantity],
    more: Sequence[Quantity] = (),
) -> Sheet:
    """Declare the head of the first sheet, with its figures, large; ``more`` results stand below what is printed.

    A sentence behind a figure stands below it in place of its unit. A table of axes may follow; :func:`close_summary`
    adds the rest.
    """
    cell = CELLS["summary_sheet"]
    sheet = book.sheet(TITLE, purpose)
    book.stamp = machine.stamp
    sheet.one_page, sheet.print_columns, sheet.widths = True, LAST, dict(WIDTHS)
    title = cell("book_title", machine.title)
    sheet.more = (title, *more)
    heading = Quantity("book_heading", "Title", role="title", formula='=book_title&""', value=machine.title)
    sheet.put(heading._replace(align="left"), 1, FIRST)
    for row, (key, label) in enumerate(IDENTIFIED.items(), STAMP):
        sheet.texts.append(Text(row, ENTERED - 1, label, "aside"))
        sheet.put(cell("book_{key}", getattr(machine, key), key=key, label=label), row, ENTERED)
    sheet.heights[FIGURES + 1] = LARGE
    column = FIRST
    for q, after in pairwise((*figures, title)):
        if q.role == "sentence":
            continue
        sheet.put(q._replace(align="left"), FIGURES + 1, column, is_large=True)
        below = ", ".join(filter(None, (q.unit, q.source)))
        sheet.texts.append(Text(FIGURES, column, q.label, "figure name"))
        if after.role == "sentence":
            sheet.put(after, FIGURES + 2, column)
            below = after.value
        else:
            sheet.texts.append(Text(FIGURES + 2, column, below, "figure unit"))
        room = LETTER * max(len(q.label), len(below)) + 1
        while room > 0:
            room, column = room - WIDTHS.get(column, COLUMN_WIDTH), column + 1
    sheet.row = PICTURE_ROW + PICTURE_ROWS
    return sheet


def more_results(book: Book) -> None:
    """Leave room for what is to mend, and declare below what is printed the results and checks of the first sheet."""
    sheet = book.sheets[0]
    sheet.row += MENDING
    sheet.not_printed_below()
    sheet.heading("More results")
    checks = [q for q in sheet.more if q.role == "check"]
    sheet.rows(*(q for q in sheet.more if q not in checks))
    sheet.checks(*checks)


def close_summary(book: Book, sources: tuple[str, ...], says: CheckSentence = NOTHING) -> None:
    """Declare what needs all other sheets: the picture, what is to mend; then what is not printed.

    ``says`` stands behind the verdict.
    """
    cell = CELLS["close_summary"]
    for each in book.sheets:
        each.place_messages()
    sheet = book.sheets[0]
    verdict = Sentence(f"{in_one(book)}{says.text}")
    sheet.put(cell("about_verdict", verdict, formula="&".join(filter(None, [IN_ONE, says.says]))), SENTENCE, FIRST)
    drawn = [chart for other in book.sheets[1:] for chart, *_ in other.charts]
    for picture in drawn[:1]:
        large = replace(picture, title="", series=picture.series + picture.notes)
        sheet.charts.append((large, PICTURE_ROW, FIRST, LAST - FIRST + 1, PICTURE_ROWS))
    stamp, today = stamp_quantities(book)
    sheet.put(today, STAMP, FIRST)
    failing_table(sheet, "mend", "To mend", sheet.print_rows - MENDING)
    sheet.heading("Contents")
    for other in book.sheets[1:]:
        entry(sheet, Text(sheet.row, FIRST, other.title, "link", other.title), other.purpose)
    sheet.heading("How to use this book", sheet.purpose)
    mark, block = title_block(book)
    for line in USE:
        sheet.note(line)
    sheet.row += 1
    sheet.rows(
        cell("book_mark", mark, formula=MARK),
        cell("book_block", block, formula=BLOCK),
        stamp,
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


def entry(sheet: Sheet, first: Text, note: str) -> None:
    """Write a line of a list."""
    sheet.texts += [first, Text(sheet.row, FIRST + 1, note, "note")]
    sheet.row += 1
