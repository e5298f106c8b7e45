"""Validations of inputs: whether a program still keeps what is entered within its rules."""

from __future__ import annotations

from collections import Counter

from workbook.book.address import Address
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, Report


def validations(match: Match, report: Report) -> None:
    """Enter as a notice for each sheet how many inputs have no validation any more."""
    covered = {sheet.title: ranges(sheet) for sheet in match.file.workbook.worksheets}
    inputs = [pair.address for pair in match.pairs if pair.cell.quantity.role == "input"]
    bare = [a for a in inputs if not any(top <= a.row <= bottom and left <= a.column <= right
                                         for top, left, bottom, right in covered[a.sheet])]  # fmt: skip
    first = {a.sheet: a for a in reversed(bare)}
    for title, count in Counter(a.sheet for a in bare).items():
        at: Address = first[title]
        report.say(at, NOTICE, "no validation", "a rule for what is entered", f"{count} inputs of the sheet {title}")


def ranges(sheet: object) -> list[tuple[int, int, int, int]]:
    """Return the ranges that have a validation."""
    rules = getattr(sheet, "data_validations").dataValidation  # noqa: B009 - of a worksheet; the stubs hide it
    return [(r.min_row, r.min_col, r.max_row, r.max_col) for rule in rules for r in rule.sqref.ranges]
