"""The machine's own verdict: what each check of the book says."""

from __future__ import annotations

from workbook.judging.compare import is_error
from workbook.judging.matching import Match
from workbook.judging.report import OK, Check
from workbook.reading.contents import Cells

UNFINISHED = "unfinished"


def checks(match: Match, computed: Cells) -> list[Check]:
    """Return the machine's checks, with what their cells compute, or what the engine says where these do not."""
    at = {pair.cell.block.name: pair for pair in match.pairs if pair.cell.quantity.role == "check"}
    found = []
    for sheet, quantity in match.declared.checks:
        pair = at.get(quantity.name)
        value = computed.get(pair.address) if pair else None
        if not isinstance(value, str) or is_error(value):
            value = quantity.value
        where = (pair.address.sheet, pair.address.a1) if pair else (sheet.title, quantity.name)
        found.append(Check(*where, quantity.label, OK if value == OK else str(value or UNFINISHED)))
    return found
