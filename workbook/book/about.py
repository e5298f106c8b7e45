"""The first sheet: what the book is for, what to do, where everything stands."""

from __future__ import annotations

import workbook
from workbook.book.declare import FIRST, Book, Quantity, Text, constant, given

SOURCES = {
    "S1": "H. Giberti, Motion curve planning 02, Automated Mechanical System Design, Università di Pavia",
    "S2": "Timing Diagram (Part 3 - Cycloid Cam Profile Analysis), Mechanical Design Handbook, 24 November 2009",
    "S3": "Functional Mechanical Design, Exercise 1: Motion Law",
    "S4": "Introduction to Mechatronics (MCT 151): Actuator Sizing, Ain Shams University, Fall 2017",
    "S5": "R. Strada, B. Zappa, H. Giberti, A unified design procedure for flying machining operations (draft)",
}


def about_sheet(book: Book, purpose: str, key_results: list[Quantity]) -> None:
    """Declare the sheet's head; the contents follow once every sheet is there (:func:`contents`)."""
    sheet = book.sheet("About", purpose)
    sheet.one_page = True
    sheet.print_columns = 13
    sheet.heading("How to use this book")
    for line in (
        "1  Enter: change the cells with a fill and blue figures. Everything else follows, tables and charts too.",
        "2  Look: results stand in bold; a check says OK or FAIL in words, and each sheet repeats the overall verdict.",
        "3  Verify: save the book and run  motionbook verify BOOK.xlsx  - "
        "every formula cell is compared with an independent engine.",
        "The sheets are protected without a password: Review > Unprotect Sheet (LibreOffice: Tools > Protect Sheet).",
    ):
        sheet.note(line)
    sheet.heading("This book")
    sheet.rows(
        given("book_title", "Machine", "", "", book.title, "title"),
        constant("book_template", "Template", "", "", book.template),
        constant("book_version", "Made by motionbook", "", "", workbook.__version__),
    )
    sheet.heading("What comes out, in short")
    sheet.rows(*key_results)


def contents(book: Book, used: tuple[str, ...]) -> None:
    """Write the links to every sheet, and the sources that the book quotes."""
    sheet = book.sheets[0]
    sheet.heading("Contents")
    for other in book.sheets[1:]:
        sheet.texts.append(Text(sheet.row, FIRST, other.title, "link", other.title))
        sheet.texts.append(Text(sheet.row, FIRST + 1, other.purpose, "note"))
        sheet.row += 1
    sheet.heading("Sources")
    for key in used:
        sheet.texts.append(Text(sheet.row, FIRST, key, "label"))
        sheet.texts.append(Text(sheet.row, FIRST + 1, SOURCES[key], "note"))
        sheet.row += 1
