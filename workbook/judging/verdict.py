"""The machine's own verdict: what each check of the book says."""

from workbook.book.quantity import SAYS
from workbook.judging.compare import is_error
from workbook.judging.matching import Match, Pair
from workbook.judging.report import FAIL, Check
from workbook.reading.contents import Cells

UNFINISHED = "unfinished"


def checks(match: Match, computed: Cells) -> list[Check]:
    """Return the machine's checks, with what their cells compute, or what the engine says where these do not."""
    at = {pair.cell.block.name: pair for pair in match.pairs if not pair.cell.block.is_table}
    found = []
    for sheet, quantity in match.declared.checks:
        pair = at.get(quantity.name)
        verdict = told(pair, computed) or quantity.value
        says = told(at.get(f"{quantity.name}{SAYS}"), computed) if verdict == FAIL else ""
        where = (pair.address.sheet, pair.address.a1) if pair else (sheet.title, quantity.name)
        found.append(Check(*where, quantity.label, str(verdict or UNFINISHED), says))
    return found


def told(pair: Pair | None, computed: Cells) -> str:
    """Return the text that a cell computes, or that the engine has for it; nothing of an unfinished one."""
    if pair is None or (pair.declared_formula and pair.cell.expected is None):
        return ""
    value = computed.get(pair.address)
    return value if isinstance(value, str) and not is_error(value) else str(pair.cell.expected)
