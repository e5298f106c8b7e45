"""The Checks sheet: every check of the book in one table, and the overall verdict that each sheet repeats."""

from __future__ import annotations

from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, result

ZERO = 1e-9


def checks_sheet(book: Book) -> Sheet:
    """Declare the sheet; to be called when every check of the book is declared."""
    sheet = book.sheet("Checks", "Every check of this book; one FAIL fails the book.")
    sheet.one_page = True
    found = book.checks
    verdicts = [str(q.value) for _, q in found]
    holding = verdicts.count("OK")
    sheet.heading("What comes out")
    sheet.rows(
        result("checks_ok", "Checks that hold", "", "", '=COUNTIF([checks.verdict],"OK")', holding, format="0"),
        calc("checks_all", "Checks in all", "", "", "=MAX([checks.k])", len(found), format="0"),
        constant("check_zero", "What a check takes for zero", "", "", ZERO, format="0E+00",
                 source="so that rounding fails no check"),
    )  # fmt: skip
    ok = holding == len(found)
    sheet.rows(check("overall", "This book", "checks_ok=checks_all", ok, "repeated at the head of each sheet"))
    sheet.row += 1
    sheet.table(
        "checks", "Checks", len(found),
        constant("what", "check", "", "", [q.label for _, q in found], align="left"),
        constant("k", "number", "", "", list(range(1, len(found) + 1))),
        result("verdict", "verdict", "", "", [f"={q.name}" for _, q in found], verdicts),
        constant("where", "sheet", "", "", [s.title for s, _ in found]),
    )  # fmt: skip
    return sheet


def repeat_verdict(book: Book) -> None:
    """Repeat the overall verdict at the head of every sheet."""
    ok = str(book.blocks["overall"].quantities[0].value)
    for i, sheet in enumerate(book.sheets, 1):
        sheet.row, row = 3, sheet.row
        sheet.rows(Quantity(f"status{i}", "All checks of this book", role="check", formula="=overall", value=ok))
        sheet.row = row
