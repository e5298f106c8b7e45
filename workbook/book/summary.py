"""The first sheet: what the book is of, what comes out, what is to mend; one printed page for who gets the machine.

Links to every sheet, how to use the book, and its sources follow below, outside what is printed.
"""

from typing import Any

import workbook
from workbook.book.checks import NONE, mended, summary
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text, calc, constant, given
from workbook.book.sheet import TITLES

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
)
PROTECTED = "Protected without a password. Yours are the cells with a fill, the columns beside the tables, and notes."
COLUMNS, PICTURE_ROW, PICTURE_COLUMN, PICTURE_ROWS = 14, 5, 7, 20
TO_MEND = 6  # checks that fail which the sheet has room for; all of them stand on the sheet Checks


IDENTIFIED = {"number": "Machine number", "revision": "Revision", "author": "Author", "date": "Date"}
"""entries that tell one machine, and one state of its design, from others"""


def summary_sheet(book: Book, machine: Any, purpose: str, key_results: list[Quantity]) -> Sheet:
    """Declare the head of the first sheet; a table of axes may follow, :func:`close` adds what needs all sheets."""
    sheet = book.sheet(TITLE, purpose)
    sheet.one_page, sheet.print_columns, sheet.widths = True, COLUMNS, {FIRST: 36, FIRST + 2: 18, FIRST + 3: 16}
    sheet.heading("This machine")
    sheet.rows(
        given("book_title", "Machine", "", "", machine.title, "title", align="left"),
        *(given(f"book_{key}", label, "", "", getattr(machine, key), key, align="left")
          for key, label in IDENTIFIED.items()),
    )  # fmt: skip
    sheet.heading("Results, in short")
    sheet.rows(*key_results)
    sheet.row = max(sheet.row, PICTURE_ROW + PICTURE_ROWS)
    return sheet


def close(book: Book, sources: tuple[str, ...]) -> None:
    """Declare what needs all other sheets: the picture, what is to mend; then what is not printed."""
    for each in book.sheets:
        each.place_messages()
    sheet = book.sheets[0]
    for picture in [chart for other in book.sheets[1:] for chart, *_ in other.charts][:1]:
        sheet.charts.append((picture, PICTURE_ROW, PICTURE_COLUMN, COLUMNS + 1 - PICTURE_COLUMN, PICTURE_ROWS))
    sheet.print_columns = max([COLUMNS, *(column for block in sheet.blocks for column in block.columns.values())])
    to_mend(book, sheet)
    sheet.not_printed_below()
    sheet.heading("Contents")
    for other in book.sheets[1:]:
        entry(sheet, Text(sheet.row, FIRST, other.title, "link", other.title), other.purpose)
    sheet.heading("How to use this book")
    for line in USE:
        sheet.note(line)
    sheet.row += 1
    sheet.rows(
        constant("book_template", "Template", "", "", book.template, align="left"),
        constant("book_version", "Made by motionbook", "", "", workbook.__version__, align="left"),
    )
    sheet.heading("Sources")
    for key in sources:
        entry(sheet, Text(sheet.row, FIRST, key, "label"), SOURCES[key])


def head(sheet: Sheet) -> None:
    """Declare the title of the first sheet: the machine's, as it is entered."""
    entered = sheet.book.blocks["book_title"].quantities[0].value
    title = Quantity("book_heading", "Title", "", "", "title", '=book_title&""', entered, align="left")
    sheet.put(title, 1, FIRST)
    sheet.texts.append(Text(TITLES + 1, FIRST, PROTECTED, "note"))


def to_mend(book: Book, sheet: Sheet) -> None:
    """Declare the first checks that fail: what, on which sheet, where and by how much."""
    sheet.heading("To mend")
    sheet.rows(calc("mend_count", "Checks that fail", "", "", "=checks_all-checks_ok", summary(book).failing,
                    format="0", source=f"the first {TO_MEND} of them; all stand on the sheet Checks"))  # fmt: skip
    rows, where = mended(book, TO_MEND), of_failing("where")
    sheet.table(
        "mend", "The checks that fail", TO_MEND,
        calc("where", "sheet", "", "", f'=IF([k]>mend_count,IF([k]=1,"{NONE}",""),{where})', rows["mend.where"],
             align="left"),
        constant("k", "number", "", "", list(range(1, TO_MEND + 1))),
        Quantity("says", "check: where, and by how much", "", "", "sentence",
                 f'=IF([k]>mend_count,"",{of_failing("what")}&": "&{of_failing("says")})', rows["mend.says"],
                 align="left"),
        blank="[k]>MAX(1,mend_count)",
    )  # fmt: skip


def of_failing(column: str) -> str:
    """Return the formula that looks up a column of the check that fails as the k-th."""
    return f"INDEX([checks.{column}],MATCH([k],[checks.nth],0))"


def entry(sheet: Sheet, first: Text, note: str) -> None:
    """Write a line of a list."""
    sheet.texts += [first, Text(sheet.row, FIRST + 1, note, "note")]
    sheet.row += 1
