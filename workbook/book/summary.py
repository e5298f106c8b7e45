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

CELLS = cell_tables(__file__)

FAILING = {"mend": 6, "failing": 8}
"""tables of the first checks that fail, on the first sheet and on Checks, and how many each has room for"""
FAILING_NOW, OWN = "(checks_all-checks_ok)", "by_sheet.verdict"

ZERO = 1e-9
NONE = "none"  # what stands in place of the first check that fails, where none does
FAILS = '1-COUNTIF([verdict]:[verdict],"OK")'
"""1 where a check does not hold, be it for an error value; a range, for IronCalc counts in no single cell"""


def checks_sheet(book: Book) -> Sheet:
    """Declare the sheet; to be called when every check of the book is declared. All of them stand below the print."""
    sheet = book.sheet("Checks", "What fails, and how many checks each sheet has; one FAIL fails the book.")
    sheet.one_page, sheet.print_columns, sheet.widths = True, 6, {2: 22, 5: 58, 6: 66}
    checks, summed = book.checks, summary(book)
    sheet.heading("Results")
    sheet.rows(
        CELLS["checks_sheet"]("checks_ok", summed.holding),
        CELLS["checks_sheet"]("checks_all", len(checks)),
        CELLS["checks_sheet"]("check_zero", ZERO),
        CELLS["checks_sheet"]("overall", summed.overall == "OK"),
    )
    sheet.row += 1
    failing_table(sheet, "failing")
    by_sheet(sheet)
    sheet.not_printed_below()
    sheet.heading("Every check")
    sheet.table(
        "checks",
        "Checks",
        len(checks),
        CELLS["checks"]("where", [s.title for s, _ in checks]),
        CELLS["checks"]("k", list(range(1, len(checks) + 1))),
        CELLS["checks"]("verdict", summed.verdicts, formula=[f"={q.name}" for _, q in checks]),
        CELLS["checks"]("what", [q.label for _, q in checks]),
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
    return sheet


def by_sheet(sheet: Sheet) -> None:
    """Declare a row for each sheet that has checks: how many, and their verdict, which stands on that sheet too."""
    book = sheet.book
    own = own_checks(book)
    sheet.table(
        "by_sheet",
        "Checks by sheet",
        len(own),
        CELLS["by_sheet"]("sheet", [book.sheets[i - 1].title for i in own]),
        CELLS["by_sheet"]("count", [len(places) for places in own.values()]),
        group_verdict_column(book, "by_sheet", "verdict", list(own.values())),
    )


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


def failing_checks(book: Book, most: int) -> tuple[list[str | None], list[str | None]]:
    """Return of the first ``most`` checks that fail on which sheet each stands, and where it fails and by how much."""
    facts = summary(book)
    failing = [
        (sheet.title, None if message is None else Sentence(f"{q.label}: {message}"))
        for (sheet, q), verdict, message in zip(book.checks, facts.verdicts, facts.sentences, strict=True)
        if verdict != "OK"
    ][:most]
    if facts.holding is None:
        return filled([], most, None), filled([], most, None)
    where, says = zip(*filled(failing or [(NONE, "")], most, ("", "")), strict=True)
    return list(where), list(says)


def check_cells(book: Book) -> dict[str, list[Any]]:
    """Return the values of all cells that sum up checks, by block and column: ``checks.verdict``."""
    facts = summary(book)
    heads = [f"status{i}" for i in range(1, len(book.sheets) + 1)]
    judged = {f"status{i}_own": verdict for i, verdict in zip(own_checks(book), group_verdicts(book)[OWN], strict=True)}
    return {
        "checks.verdict": facts.verdicts,
        "checks.says": facts.sentences,
        "checks.nth": facts.so_far,
        **group_verdicts(book),
        "mend_count.mend_count": [facts.failing],
        **{
            f"{table}.{column}": values
            for table, most in FAILING.items()
            for column, values in zip(("where", "says"), failing_checks(book, most), strict=True)
        },
        "checks_ok.checks_ok": [facts.holding],
        "overall.overall": [facts.overall],
        "about_verdict.about_verdict": [in_one(book)],
        **{f"{head}.{head}": [facts.overall] for head in heads},
        **{f"{head}.{head}": [verdict] for head, verdict in judged.items()},
    }


def own_checks(book: Book) -> dict[int, list[int]]:
    """Return of each sheet that has checks, by its number from 1, their places among all."""
    places = [
        (i, [k for k, (owner, _) in enumerate(book.checks, 1) if owner is sheet])
        for i, sheet in enumerate(book.sheets, 1)
    ]
    return {i: own for i, own in places if own}


def repeat_verdicts(book: Book) -> None:
    """Show at the top right of each sheet the verdict of its own checks, if it has any, over the book's."""
    ok = str(book.blocks["overall"].quantities[0].value)
    verdicts = group_verdicts(book)[OWN]
    places = {i: place for place, i in enumerate(own_checks(book), 1)}
    for i, sheet in enumerate(book.sheets, 1):
        right = sheet.last_column
        if place := places.get(i):
            own = Quantity(f"status{i}_own", "Checks of this sheet", role="check", formula=f"=[{OWN}.{place}]")
            sheet.texts.append(Text(1, right - 1, "this sheet", "aside"))
            sheet.put(own._replace(value=verdicts[place - 1]), 1, right)
        whole = Quantity(f"status{i}", "All checks of this book", role="check", formula="=overall", value=ok)
        sheet.texts.append(Text(2, right - 1, "the book", "aside"))
        sheet.put(whole, 2, right)


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
            sheet.texts.append(Text(3, sheet.last_column, TITLE, "link", TITLE))


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
    "Workings are not printed, nor are Catalogue, Laws and the laws' sheets: clear a sheet's print area to print it.",
)
COLUMNS = 17
WIDTHS: dict[int, float] = {FIRST: 14, FIRST + 1: 24, 6: 12, 7: 13, 13: 12, 14: 12, 15: 16}
SENTENCE, FIGURES, FIGURE_COLUMNS = 4, 6, (2, 3, 4, 7, 10, 13)  # rows of the verdict in words and of figures, columns
ENTERED = 15  # the column of entries
PICTURE_ROW, PICTURE_ROWS = 11, 17


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
    sheet.one_page, sheet.print_columns, sheet.widths, sheet.more = True, COLUMNS, dict(WIDTHS), more
    entered = (
        cell("book_title", machine.title),
        *(cell("book_{key}", getattr(machine, key), key=key, label=label) for key, label in IDENTIFIED.items()),
    )
    for row, quantity in enumerate(entered, FIGURES):
        sheet.texts.append(Text(row, ENTERED - 1, quantity.label, "aside"))
        sheet.put(quantity, row, ENTERED)
    for column, quantity in zip(FIGURE_COLUMNS, figures, strict=False):
        sheet.figure(quantity, FIGURES, column)
    sheet.row = PICTURE_ROW + PICTURE_ROWS
    return sheet


def close_summary(book: Book, sources: tuple[str, ...]) -> None:
    """Declare what needs all other sheets: the picture, what is to mend; then what is not printed."""
    cell = CELLS["close_summary"]
    for each in book.sheets:
        each.place_messages()
    sheet = book.sheets[0]
    sheet.put(cell("about_verdict", in_one(book), formula=IN_ONE), SENTENCE, FIRST)
    for picture in [chart for other in book.sheets[1:] for chart, *_ in other.charts][:1]:
        sheet.charts.append((picture, PICTURE_ROW, FIRST, COLUMNS - FIRST + 1, PICTURE_ROWS))
    to_mend(book, sheet)
    sheet.not_printed_below()
    if sheet.more:
        sheet.heading("More results")
        sheet.rows(*sheet.more)
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


IN_ONE = '=IF(mend_count=0,"All "&checks_all&" checks hold.","Checks that fail: "&mend_count&" of "&checks_all&".")'


def in_one(book: Book) -> str | None:
    """Return whether all checks hold, as a sentence; None where the book is unfinished."""
    failing, count = summary(book).failing, len(book.checks)
    if failing is None:
        return None
    return f"Checks that fail: {failing} of {count}." if failing else f"All {count} checks hold."


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


def to_mend(book: Book, sheet: Sheet) -> None:
    """Declare how many checks fail, and the first of them."""
    sheet.heading("To mend")
    sheet.rows(CELLS["to_mend"]("mend_count", summary(book).failing, to_mend=FAILING["mend"]))
    failing_table(sheet, "mend")


def failing_table(sheet: Sheet, name: str) -> None:
    """Declare the first checks that fail: what, on which sheet, where and by how much."""
    most = FAILING[name]
    on, sentences = failing_checks(sheet.book, most)
    where, what, says = (f"INDEX([checks.{column}],MATCH([k],[checks.nth],0))" for column in ("where", "what", "says"))
    sheet.table(
        name,
        "The checks that fail",
        most,
        CELLS["failing"]("where", on, none=NONE, where=where, failing=FAILING_NOW),
        CELLS["failing"]("k", list(range(1, most + 1))),
        Quantity(
            "says",
            "what fails",
            "",
            "",
            "sentence",
            f'=IF([k]>{FAILING_NOW},"",{what}&": "&{says})',
            sentences,
            align="left",
        ),
        blank=f"[k]>MAX(1,{FAILING_NOW})",
    )


def entry(sheet: Sheet, first: Text, note: str) -> None:
    """Write a line of a list."""
    sheet.texts += [first, Text(sheet.row, FIRST + 1, note, "note")]
    sheet.row += 1
