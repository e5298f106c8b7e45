"""What the cells of a matched file hold, against what they should: without evaluating anything."""

import math
from collections.abc import Iterator
from typing import Any

from openpyxl import Workbook
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.entries.rules import field_at
from workbook.functions.declared import NAMESPACE
from workbook.functions.names import definitions, meaning
from workbook.judging.matching import Match
from workbook.judging.names import misled
from workbook.judging.report import Finding, Report
from workbook.reading.files import Words, is_formula

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
        elif isinstance(pair.held, str) and pair.held.startswith("{="):  # part of a formula that fills several cells
            suspects.add(pair.address)
            report.add(pair, "formula", pair.held, pair.cell.content)
        elif pair.held is None:
            report.add(pair, "missing", None, pair.cell.expected)
        elif isinstance(pair.held, Words):
            report.add(pair, "replaced", shown(pair.held), pair.cell.content, why="a text is never computed")
        elif not is_formula(pair.held):
            report.add(pair, "replaced", pair.held, pair.cell.expected)
        elif not match.same_shape(pair):
            suspects.add(pair.address)
            if shapes:
                report.add(pair, "formula", pair.held, pair.cell.content)
    return suspects


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


def shown(held: Any) -> Any:
    """Return what a cell holds, a text that looks like a formula in quotes."""
    return f'"{held}"' if isinstance(held, Words) else held


ALLOWED = frozenset([
    "IF", "AND", "OR", "NOT", "MIN", "MAX", "ABS", "SIGN", "SQRT", "SIN", "COS",
    "TAN", "ATAN2", "PI", "EXP", "LN", "LOG10", "POWER", "INT", "ROUND", "SUM", "SUMPRODUCT",
    "AVERAGE", "COUNT", "COUNTIF", "INDEX", "MATCH", "CHOOSE", "LARGE", "SMALL", "ISNUMBER", "RADIANS", "DEGREES",
])  # fmt: skip
VOLATILE = frozenset(["NOW", "TODAY", "RAND", "RANDBETWEEN", "OFFSET", "INDIRECT", "CELL", "INFO", "RANDARRAY"])
MOST = 5  # names that a note lists
COMPUTED = "how the program computes"


def audit(match: Match, template: type[BaseModel]) -> Iterator[Finding]:
    """Yield what is wrong with formulas, names, inputs and settings of a matched workbook."""
    yield from functions(match)
    yield from own_names(match)
    yield from misled(match)
    yield from unread_inputs(match, template)
    yield from settings(match.file.workbook)


def functions(match: Match) -> Iterator[Finding]:
    """Yield cells that should hold another formula: with a function that not every program has, or that is volatile."""
    formulas = match.file.contents.formulas
    for pair in match.pairs:
        formula = formulas.get(pair.address) if pair.declared_formula else None
        for name in sorted(formula.functions - ALLOWED) if formula else ():
            why = "a function that is not volatile" if name in VOLATILE else "a function that every program has"
            yield Finding(pair.address.sheet, pair.address.a1, "function", name, why)


def own_names(match: Match) -> Iterator[Finding]:
    """Yield names that a generated sheet has for itself: its formulas take them for the book's of the same name."""
    declared = {name.casefold() for name, _ in match.declared.names()}
    ours = {pair.address.sheet for pair in match.pairs}
    for sheet in match.file.workbook.worksheets:
        for name, defined in sheet.defined_names.items() if sheet.title in ours else ():
            if name.casefold() in declared:
                yield Finding(sheet.title, name, "name", str(defined.attr_text), "no name of the sheet's own")


def unread_inputs(match: Match, template: type[BaseModel]) -> Iterator[Finding]:
    """Yield inputs that no formula reads; texts that only describe are left out."""
    inputs = [pair for pair in match.pairs if pair.cell.quantity.role == "input" and pair.held is not None]
    read = match.file.contents.read([pair.address for pair in inputs])
    for pair in inputs:
        q, at = pair.cell.quantity, pair.address
        if at not in read and (field_at(template, q.key)[0] is not str or q.choices):
            yield Finding(at.sheet, at.a1, "unread", str(pair.held), "an input that a formula reads")


def settings(workbook: Workbook) -> Iterator[Finding]:
    """Yield the settings of a file that let formulas go stale, round them, or read them by other rules."""
    held = workbook.calculation
    for wrong, found, expected in (
        (held and held.calcMode == "manual", "manual", "automatic: else what is shown is not what was entered"),
        (held and held.iterate, "iterative", "not iterative: else a cell that depends on itself has a value"),
        (held and held.fullPrecision is False, "with the precision as displayed", "with full precision"),
    ):
        if wrong:
            yield Finding("", "calculation", "setting", found, expected, COMPUTED)
    for sheet in workbook.worksheets:
        own = sheet.sheet_properties
        if own.transitionEvaluation or own.transitionEntry:
            rules = "by the rules of Lotus 1-2-3", "by those of Excel"
            yield Finding(sheet.title, "calculation", "setting", *rules, COMPUTED)


def stale_functions(workbook: Workbook) -> Iterator[str]:
    """Yield a note where names that define the functions MOTION.*, copied beside a machine, are not today's."""
    held = {name: one.attr_text or "" for name, one in workbook.defined_names.items() if NAMESPACE in name}
    if not held:  # as in most books: the definitions need not be read
        return
    other = sorted(d.name for d in definitions() if d.name in held and meaning(held[d.name]) != meaning(d.stored))
    if other:
        said = ", ".join(other[:MOST]) + (f" and {len(other) - MOST} more" if len(other) > MOST else "")
        yield f"names that are not today's definitions: {said}; take them from motion-functions.xlsx"
