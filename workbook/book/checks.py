"""The sheet Checks, which every book has: the verdict, what fails, and every check; verdicts on all sheets."""

import re
from collections.abc import Sequence
from itertools import accumulate
from typing import Any, NamedTuple

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity, Sheet, Text
from workbook.book.quantity import SAYS
from workbook.book.rows import filled
from workbook.book.sentence import Sentence

CELLS = cell_tables(__file__)

FAILING = {"mend": 6, "failing": 8}
"""tables of the first checks that fail, on the first sheet and on Checks, and how many each has room for"""
FAILING_NOW, OWN = "(checks_all-checks_ok)", "by_sheet.verdict"

GROUP_VERDICT = re.compile(r"=\[(\w+\.verdict)\.(\d+)\]")

ZERO = 1e-9
NONE = "none"  # what stands in place of the first check that fails, where none does
FAILS = '1-COUNTIF([verdict]:[verdict],"OK")'
"""1 where a check does not hold, be it for an error value; a range, for IronCalc counts in no single cell"""


def checks_sheet(book: Book) -> Sheet:
    """Declare the sheet; to be called when every check of the book is declared. All of them stand below the print."""
    sheet = book.sheet("Checks", "What fails, and how many checks each sheet has; one FAIL fails the book.")
    sheet.one_page, sheet.print_columns, sheet.widths = True, 12, {2: 22, 6: 58}
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
        CELLS["checks"]("nth", summed.so_far, formula=["=" + FAILS, *[f"=[nth-1]+{FAILS}" for _ in checks[1:]]]),
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
    # of each check how many up to it do not hold; None from the first that is unfinished
    so_far: list[int | None]
    overall: str | None


def summary(book: Book) -> Summary:
    """Return the counts of the checks and their joint verdict; an unfinished check leaves these open."""
    judged = [(q.value, book.blocks[f"{q.name}{SAYS}"].quantities[0].value) for _, q in book.checks]
    verdicts, sentences = [verdict for verdict, _ in judged], [sentence for _, sentence in judged]
    known = verdicts.index(None) if None in verdicts else len(verdicts)
    so_far = list(accumulate(int(verdict != "OK") for verdict in verdicts[:known]))
    holding = verdicts.count("OK") if known == len(verdicts) else None
    failing = None if holding is None else len(verdicts) - holding
    counted = filled(so_far, len(verdicts), None)
    return Summary(verdicts, sentences, holding, failing, counted, joint_verdict(verdicts))


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
        **repeated_verdicts(book),
    }


def repeated_verdicts(book: Book) -> dict[str, list[str | None]]:
    """Return the values of cells that repeat the verdict of a group: of each sheet's own checks, of an axis."""
    verdicts = group_verdicts(book)
    cells = ((name, str(block.quantities[0].formula)) for name, block in book.blocks.items() if not block.is_table)
    repeating = ((name, match) for name, formula in cells if (match := GROUP_VERDICT.fullmatch(formula)))
    return {f"{name}.{name}": [verdicts[match[1]][int(match[2]) - 1]] for name, match in repeating}


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


IN_ONE = '=IF(mend_count=0,"All "&checks_all&" checks hold.","Checks that fail: "&mend_count&" of "&checks_all&".")'


def in_one(book: Book) -> str | None:
    """Return whether all checks hold, as a sentence; None where the book is unfinished."""
    failing, count = summary(book).failing, len(book.checks)
    if failing is None:
        return None
    return f"Checks that fail: {failing} of {count}." if failing else f"All {count} checks hold."


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
