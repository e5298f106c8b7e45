"""All that a book displays, held against what its cells have."""

from __future__ import annotations

from typing import Any

from workbook.book.address import Address
from workbook.judging.matching import Match, is_formula
from workbook.judging.report import Report
from workbook.judging.shown.charts import charts
from workbook.judging.shown.conditional import Rules
from workbook.judging.shown.numbers import numbers
from workbook.judging.shown.rules import validations
from workbook.judging.shown.visible import visible
from workbook.judging.shown.words import words
from workbook.reading.contents import Cells


def displayed(match: Match, computed: Cells, report: Report) -> None:
    """Enter into a report what a reader of the book is told otherwise, and as notices what is reworded or gone.

    ``computed`` are the values of the formula cells; where there are none, the engine's are taken.
    """
    values = {p.address: computed.get(p.address, p.cell.expected) for p in match.pairs if p.declared_formula}

    def known(at: Address) -> Any:
        """Return what a cell shows; of the engineer's own formulas, what they were saved with."""
        if at in values or at in computed:
            return values.get(at, computed.get(at))
        held = match.file.value(at) if at.sheet in titles else None
        return match.file.saved.get(at) if is_formula(held) else held

    titles = set(match.file.workbook.sheetnames)
    rules = {sheet.title: Rules(sheet, known) for sheet in match.file.workbook.worksheets}
    numbers(match, values, rules, report)
    visible(match, values, rules, report)
    words(match, report)
    charts(match, report)
    validations(match, report)
