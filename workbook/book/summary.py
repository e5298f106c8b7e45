"""Sheets that every book has: the first, a printed page for who gets the machine, and Checks with the verdict.

On the first, links to every sheet, how to use the book, and its sources follow below, outside what is printed.
"""

from collections.abc import Sequence
from itertools import accumulate
from typing import Any, NamedTuple

import workbook
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text
from workbook.book.quantity import SAYS
from workbook.book.rows import filled
from workbook.book.sentence import Sentence
from workbook.book.sheet import TITLES

CELLS = cell_tables(__file__)

ZERO = 1e-9
NONE = "none"  # what stands in place of the first check that fails, where none does
FAILS = '1-COUNTIF([verdict]:[verdict],"OK")'
"""1 where a check does not hold, be it for an error value; a range, for IronCalc counts in no single cell"""


def checks_sheet(book: Book) -> Sheet:
    """Declare the sheet; to be called when every check of the book is declared."""
    sheet = book.sheet("Checks", "Every check of this book; one FAIL fails the book.")
    sheet.one_page = sheet.portrait = True
    sheet.widths, sheet.print_columns = {2: 60, 6: 90}, 6
    checks = book.checks
    summed = summary(book)
    sheet.heading("Results")
    sheet.rows(
        CELLS["checks_sheet"]("checks_ok", summed.holding),
        CELLS["checks_sheet"]("checks_all", len(checks)),
        CELLS["checks_sheet"]("check_zero", ZERO),
    )
    ok = summed.overall == "OK"
    sheet.rows(CELLS["checks_sheet"]("overall", ok))
    sheet.row += 1
    sheet.table(
        "checks",
        "Checks",
        len(checks),
        CELLS["checks"]("what", [q.label for _, q in checks]),
        CELLS["checks"]("k", list(range(1, len(checks) + 1))),
        CELLS["checks"]("verdict", summed.verdicts, formula=[f"={q.name}" for _, q in checks]),
        CELLS["checks"]("where", [s.title for s, _ in checks]),
        Quantity(
            "says",
            "what it is about, or where it fails and by how much",
            "",
            "",
            "sentence",
            [f"={q.name}{SAYS}" for _, q in checks],
            summed.sentences,
            align="left",
        ),
        CELLS["checks"]("nth", summed.so_far, formula=["=" + FAILS, *[f"=[nth-1]+{FAILS}" for _ in checks[1:]]]),
    )
    sheet.not_printed_below()
    return sheet


class Summary(NamedTuple):
    """The sum of the checks of a book: each may be None, where it is unfinished."""

    verdicts: list[str | None]
    sentences: list[str | None]
    holding: int | None
    failing: int | None
    so_far: list[int | None]  # of each check how many up to it do not hold; None from the first that is unfinished
    overall: str | None


def summary(book: Book) -> Summary:
    """Return the counts of the checks and their joint verdict; an unfinished check leaves these open."""
    judged = [(q.value, book.blocks[f"{q.name}{SAYS}"].quantities[0].value) for _, q in book.checks]
    verdicts, sentences = [verdict for verdict, _ in judged], [sentence for _, sentence in judged]
    known = verdicts.index(None) if None in verdicts else len(verdicts)
    so_far = list(accumulate(int(verdict != "OK") for verdict in verdicts[:known]))
    holding = verdicts.count("OK") if known == len(verdicts) else None
    failing = None if holding is None else len(verdicts) - holding
    return Summary(verdicts, sentences, holding, failing, filled(so_far, len(verdicts), None), joint_verdict(verdicts))


def joint_verdict(verdicts: Sequence[str | None]) -> str | None:
    """Return FAIL if any verdict is, else None if any is unfinished, else OK."""
    if "FAIL" in verdicts:
        return "FAIL"
    return None if None in verdicts else "OK"


def group_verdict_column(book: Book, table: str, label: str, rows: list[list[int]]) -> Quantity:
    """Return the column ``verdict`` of a table: of each row the joint verdict of the checks at its places.

    All hold where as many fail up to the end of each run of places as before it.
    """
    book.summed[f"{table}.verdict"], formulas = rows, []
    for places in rows:
        ends = "+".join(f"[checks.nth.{k}]" for k in places if k + 1 not in places)
        befores = "+".join(f"[checks.nth.{k - 1}]" for k in places if k > 1 and k - 1 not in places)
        formulas.append(f'=IF({ends}={befores or 0},"OK","FAIL")')
    return Quantity("verdict", label, "", "", "check", formulas, group_verdicts(book)[f"{table}.verdict"])


def group_verdicts(book: Book) -> dict[str, list[str | None]]:
    """Return the verdicts in the columns that sum up groups of checks."""
    verdicts = summary(book).verdicts
    return {
        column: [joint_verdict([verdicts[k - 1] for k in places]) for places in rows]
        for column, rows in book.summed.items()
    }


def failing_checks(book: Book, most: int) -> dict[str, list[str | None]]:
    """Return the first ``most`` checks that fail, by block and column of the table To mend: ``mend.says``."""
    facts = summary(book)
    failing = [
        (sheet.title, None if message is None else Sentence(f"{q.label}: {message}"))
        for (sheet, q), verdict, message in zip(book.checks, facts.verdicts, facts.sentences, strict=True)
        if verdict != "OK"
    ][:most]
    rows = filled(failing or [(NONE, "")], most, ("", ""))
    known = facts.holding is not None
    columns = zip(*rows, strict=True)
    return {
        f"mend.{name}": list(column) if known else filled([], most, None)
        for name, column in zip(("where", "says"), columns, strict=True)
    }


def check_cells(book: Book) -> dict[str, list[Any]]:
    """Return the values of all cells that sum up checks, by block and column: ``checks.verdict``."""
    facts = summary(book)
    heads = [f"status{i}" for i in range(1, len(book.sheets) + 1)]
    return {
        "checks.verdict": facts.verdicts,
        "checks.says": facts.sentences,
        "checks.nth": facts.so_far,
        **group_verdicts(book),
        "mend_count.mend_count": [facts.failing],
        **failing_checks(book, book.blocks["mend"].size),
        "checks_ok.checks_ok": [facts.holding],
        "overall.overall": [facts.overall],
        **{f"{head}.{head}": [facts.overall] for head in heads},
    }


def repeat_verdict(book: Book) -> None:
    """Repeat the overall verdict at the head of every sheet."""
    ok = str(book.blocks["overall"].quantities[0].value)
    for i, sheet in enumerate(book.sheets, 1):
        sheet.row, row = 3, sheet.row
        sheet.rows(Quantity(f"status{i}", "All checks of this book", role="check", formula="=overall", value=ok))
        sheet.row = row


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
"""entries that tell a machine, and a state of its design, from others"""


def summary_sheet(book: Book, machine: Any, purpose: str, key_results: list[Quantity]) -> Sheet:
    """Declare the head of the first sheet; a table of axes may follow; :func:`close_summary` adds the rest."""
    cell = CELLS["summary_sheet"]
    sheet = book.sheet(TITLE, purpose)
    sheet.one_page, sheet.print_columns, sheet.widths = True, COLUMNS, {FIRST: 36, FIRST + 2: 18, FIRST + 3: 16}
    sheet.heading("This machine")
    sheet.rows(
        cell("book_title", machine.title),
        *(cell("book_{key}", getattr(machine, key), key=key, label=label) for key, label in IDENTIFIED.items()),
    )
    sheet.heading("Results, in short")
    sheet.rows(*key_results)
    sheet.row = max(sheet.row, PICTURE_ROW + PICTURE_ROWS)
    return sheet


def close_summary(book: Book, sources: tuple[str, ...]) -> None:
    """Declare what needs all other sheets: the picture, what is to mend; then what is not printed."""
    cell = CELLS["close_summary"]
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
        cell("book_template", book.template),
        cell("book_version", workbook.__version__),
        cell("book_layout", ""),
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
    sheet.rows(CELLS["to_mend"]("mend_count", summary(book).failing, to_mend=TO_MEND))
    rows = failing_checks(book, TO_MEND)
    where, what, says = (f"INDEX([checks.{column}],MATCH([k],[checks.nth],0))" for column in ("where", "what", "says"))
    sheet.table(
        "mend",
        "The checks that fail",
        TO_MEND,
        CELLS["mend"]("where", rows["mend.where"], none=NONE, where=where),
        CELLS["mend"]("k", list(range(1, TO_MEND + 1))),
        Quantity(
            "says",
            "check: where, and by how much",
            "",
            "",
            "sentence",
            f'=IF([k]>mend_count,"",{what}&": "&{says})',
            rows["mend.says"],
            align="left",
        ),
        blank="[k]>MAX(1,mend_count)",
    )


def entry(sheet: Sheet, first: Text, note: str) -> None:
    """Write a line of a list."""
    sheet.texts += [first, Text(sheet.row, FIRST + 1, note, "note")]
    sheet.row += 1
