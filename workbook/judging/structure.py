"""What the cells of a matched file hold, against what they should: without evaluating anything."""

import math
from typing import Any

from workbook.book.address import Address
from workbook.judging.matching import Match, Pair, is_formula
from workbook.judging.report import Finding, Report
from workbook.reading.files import Words

LAST_DIGITS = 1e-14  # LibreOffice keeps 15 digits of a number when it saves


def structure(match: Match, report: Report, shapes: bool = True) -> set[Address]:
    """Enter missing blocks, and formulas and constants that are not the declared ones; return those formulas."""
    for block, place in match.misfits:
        if place is not None and block.is_table:  # told with what was inserted or is gone
            continue
        expected = f"{block.size} rows by {len(block.quantities)} columns"
        found = f"{place.rows} rows by {place.columns} columns" if place else None
        where = (place.sheet, place.cell(0, 0).a1) if place else (block.sheet.title, block.name)
        report.findings.append(Finding(*where, "missing", found, expected, block.title or block.quantities[0].label))
    suspects = set()
    for pair in match.pairs:
        if pair.cell.quantity.role == "input":
            continue
        if not pair.declared_formula:
            if not same(pair.held, pair.cell.content):
                report.add(pair, "changed", shown(pair.held), pair.cell.content)
        elif is_array(pair.held):
            suspects.add(pair.address)
            report.add(pair, "formula", pair.held, pair.cell.content)
        elif not is_formula(pair.held):
            replaced(pair, report)
        elif not match.same_shape(pair):
            suspects.add(pair.address)
            if shapes:
                report.add(pair, "formula", pair.held, pair.cell.content)
    return suspects


def replaced(pair: Pair, report: Report) -> None:
    """Enter a cell that holds no formula where one is declared."""
    if pair.held is None:
        report.add(pair, "missing", None, pair.cell.expected)
    elif isinstance(pair.held, Words):
        report.add(pair, "replaced", shown(pair.held), pair.cell.content, why="a text is never computed")
    else:
        report.add(pair, "replaced", pair.held, pair.cell.expected)


def same(held: Any, content: Any) -> bool:
    """Whether a cell holds what is declared, of the same type: TRUE is not 1, a text of digits is no number.

    An empty text is an empty cell: most programs save none.
    """
    if content == "":
        return held is None or held == ""
    if isinstance(content, int | float) and not isinstance(content, bool):
        number = isinstance(held, int | float) and not isinstance(held, bool)
        return number and math.isclose(held, content, rel_tol=LAST_DIGITS)
    return type(held) is type(content) and bool(held == content)


def is_array(held: Any) -> bool:
    """Whether what a cell holds is part of a formula that fills several cells."""
    return isinstance(held, str) and held.startswith("{=")


def shown(held: Any) -> Any:
    """Return what a cell holds, a text that looks like a formula in quotes."""
    return f'"{held}"' if isinstance(held, Words) else held
