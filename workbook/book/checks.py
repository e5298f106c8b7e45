"""The sheet Checks, which every book has: the verdict, what fails, and every check; verdicts on all sheets."""

from collections.abc import Iterable, Sequence
from itertools import accumulate
from typing import NamedTuple

from workbook.book.cell_tables import cell_tables
from workbook.book.declare import FIRST, Book, Quantity, Sheet, Text
from workbook.book.quantity import SAYS
from workbook.book.rows import filled
from workbook.book.sentence import Sentence, sentence_formula

CELLS = cell_tables(__file__)

FAILING = {"mend": 6, "failing": 8}
"""tables of the first checks that fail, on the first sheet and on Checks, and how many each has room for"""
FAILING_NOW, OWN = "(checks_all-checks_ok)", "by_sheet.verdict"

ZERO = 1e-9
NONE = "Nothing: {} checks OK."
FAILS = '1-COUNTIF([verdict]:[verdict],"OK")'
"""1 where a check does not hold, be it for an error value; a range, for IronCalc counts in no single cell"""


def checks_sheet(book: Book) -> None:
    """Declare the sheet; to be called when every check of the book is declared. All of them stand below the print."""
    sheet = book.sheet("Checks", "What fails, and how many checks each sheet has; one FAIL fails the book.")
    sheet.one_page, sheet.print_columns, sheet.widths = True, 12, {2: 22, 6: 58}
    checks, summed, top = book.checks, summary(book), sheet.row
    sheet.row += FAILING["failing"] + 2
    by_sheet(sheet)
    sheet.not_printed_below()
    sheet.heading("Results")
    cell = CELLS["checks_sheet"]
    sheet.rows(
        cell("checks_ok", summed.verdicts.count("OK")),
        cell("checks_all", len(checks)),
        cell("check_zero", ZERO),
        cell("overall", "FAIL" not in summed.verdicts),
    )
    sheet.heading("Every check")
    every = sheet.table(
        "checks",
        "Checks",
        len(checks),
        CELLS["checks"]("where", [s.title for s, _ in checks]),
        CELLS["checks"]("k", list(range(1, len(checks) + 1))),
        CELLS["checks"]("verdict", summed.verdicts, formula=[f"={q.name}" for _, q in checks]),
        CELLS["checks"]("nth", summed.so_far, formula=["=" + FAILS, *[f"=[nth-1]+{FAILS}" for _ in checks[1:]]]),
        CELLS["checks"]("what", [q.label for _, q in checks]),
        CELLS["checks"]("says", summed.sentences, formula=[f"={q.name}{SAYS}" for _, q in checks]),
    )
    links = ((row, book.blocks[q.name]) for row, (_, q) in enumerate(checks, every.row))
    sheet.texts += [Text(row, FIRST, "", "link", own.sheet.title, own.at) for row, own in links]
    failing_table(sheet, "failing", "What fails", top)


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
    """The checks of a book, in their order."""

    verdicts: list[str]
    sentences: list[str]
    so_far: list[int]  # of each check how many up to it do not hold


def summary(book: Book) -> Summary:
    """Return the verdict of each check, its sentence, and how many fail up to it."""
    judged = [(q.value, book.blocks[f"{q.name}{SAYS}"].quantities[0].value) for _, q in book.checks]
    verdicts, sentences = [verdict for verdict, _ in judged], [sentence for _, sentence in judged]
    so_far = list(accumulate(int(verdict != "OK") for verdict in verdicts))
    return Summary(verdicts, sentences, so_far)


def joint_verdict(verdicts: Sequence[str]) -> str:
    """Return FAIL if any verdict is, else OK."""
    return "FAIL" if "FAIL" in verdicts else "OK"


def group_verdict_column(book: Book, table: str, label: str, rows: list[list[int]]) -> Quantity:
    """Return the column ``verdict`` of a table: of each row the joint verdict of the checks at its places.

    All hold where as many fail up to the end of each run of places as before it.
    """
    formulas = []
    for places in rows:
        ends = "+".join(f"[checks.nth.{k}]" for k in places if k + 1 not in places)
        befores = "+".join(f"[checks.nth.{k - 1}]" for k in places if k > 1 and k - 1 not in places)
        formulas.append(f'=IF({ends}={befores or 0},"OK","FAIL")')
    return Quantity("verdict", label, "", "", "check", formulas, group_verdicts(book, rows))


def group_verdicts(book: Book, rows: Iterable[list[int]]) -> list[str]:
    """Return the joint verdict of the checks at the places of each row, counted from 1."""
    verdicts = summary(book).verdicts
    return [joint_verdict([verdicts[k - 1] for k in places]) for places in rows]


def failing_checks(book: Book, most: int) -> list[str]:
    """Return of the first ``most`` checks that fail where each fails and by how much; else that none does."""
    facts = summary(book)
    failing: list[str] = [
        Sentence(f"{q.label}: {message}")
        for (_, q), verdict, message in zip(book.checks, facts.verdicts, facts.sentences, strict=True)
        if verdict != "OK"
    ]
    return filled(failing[:most] or [NONE.format(len(book.checks))], most, "")


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
    checks_of = own_checks(book)
    verdicts = dict(zip(checks_of, group_verdicts(book, checks_of.values()), strict=True))
    places = {i: place for place, i in enumerate(checks_of, 1)}
    for i, sheet in enumerate(book.sheets, 1):
        right = sheet.last_column
        if place := places.get(i):
            own = Quantity(f"status{i}_own", "Checks of this sheet", role="check", formula=f"=[{OWN}.{place}]")
            sheet.texts.append(Text(1, right - 1, "this sheet", "aside"))
            sheet.put(own._replace(value=verdicts[i]), 1, right)
        whole = Quantity(f"status{i}", "All checks of this book", role="check", formula="=overall", value=ok)
        sheet.texts.append(Text(2, right - 1, "the book", "aside"))
        sheet.put(whole, 2, right)


IN_ONE = (
    f'=IF({FAILING_NOW}=0,"All "&checks_all&" checks hold.","Checks that fail: "&{FAILING_NOW}&" of "&checks_all&".")'
)


def in_one(book: Book) -> str:
    """Return whether all checks hold, as a sentence."""
    failing, count = summary(book).so_far[-1], len(book.checks)
    return f"Checks that fail: {failing} of {count}." if failing else f"All {count} checks hold."


def failing_table(sheet: Sheet, name: str, title: str, row: int) -> None:
    """Declare from a row on the first checks that fail, each in a sentence, or that none does, with a link to all."""
    most = FAILING[name]
    what, says = (f"INDEX([checks.{column}],MATCH([{name}_k.k.same],[checks.nth],0))" for column in ("what", "says"))
    cell = CELLS["failing"].sharing(
        k=f"[{name}_k.k.same]", failing=FAILING_NOW, none=sentence_formula(NONE, "checks_all")
    )
    failing = cell("says", failing_checks(sheet.book, most), what=what, message=says)
    failing = failing._replace(red=f"[{name}_k.k.same]<={FAILING_NOW}")
    block = sheet.list_at(name, title, row, FIRST, failing)
    sheet.workings(block, f"{name}_k", "", sheet.print_columns + 2, cell("k", list(range(1, most + 1))), heads=False)
    every = sheet.book.blocks["checks"]
    links = [("every check", every.sheet.title, every.at)]
    links += [("choose a pair", other.title, "A1") for other in sheet.book.sheets if other.title == "Selection"]
    sheet.texts += [Text(row, FIRST + 2 * n, text, "link", *at) for n, (text, *at) in enumerate(links, 1)]
