"""What checks of entries, and the sheets Checks and Summary, hold in their cells: short formulas, one a column."""

import re

import pytest

from workbook.book.limits import EXPECTED, MESSAGES
from workbook.book.quantity import SAYS
from workbook.build import committed
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

LONGEST, DEEPEST, COLUMNS = 200, 4, 40
PLAIN = re.compile(r"-?\d{1,6}(\.\d{1,4})?")
NUMBER = re.compile(r"(?<![\w.$])-?\d+\.?\d*(?:[eE][+-]?\d+)?(?![\w.$])")
TEXT, CALL = re.compile(r'"[^"]*"'), re.compile(r"[A-Z]+\(|\(|\)")


def deepest(formula):
    """How many functions a formula nests."""
    depth, most, opened = 0, 0, []
    for word in CALL.findall(TEXT.sub("", formula)):
        if word == ")":
            depth -= opened.pop()
        else:
            opened.append(int(word != "("))
            depth += opened[-1]
        most = max(most, depth)
    return most


def ruled(book):
    """The blocks of checks of entries and their messages, and all of Checks and Summary."""
    names = {name for guard in book.guards for name in (guard.check, guard.check + SAYS, f"{guard.table}{MESSAGES}")}
    names |= {f"{q.name}{EXPECTED}" for guard in book.guards if not guard.table for q, _ in guard.entries}
    return [b for b in book.blocks.values() if b.name in names or b.sheet.title in ("Checks", "Summary")]


@pytest.mark.parametrize("path", committed(), ids=lambda path: path.stem)
def test_checks_of_entries_are_read_at_a_glance(path):
    machine = read_machine(path)
    book = TEMPLATES[machine.template].declare(machine)
    blocks = ruled(book)
    cells = [(b, cell) for b in blocks for cell in b.cells() if cell.quantity.formula is not None]
    assert len(cells) > 50
    assert [cell.content for _, cell in cells if len(cell.content) > LONGEST] == []
    assert [cell.content for _, cell in cells if deepest(cell.content) > DEEPEST] == []
    numbers = {n for _, cell in cells for n in NUMBER.findall(TEXT.sub("", cell.content))}
    assert [n for n in numbers if not PLAIN.fullmatch(n)] == []
    assert all(max(b.columns.values()) <= COLUMNS for b in blocks)
    messages = [b for b in blocks if b.name.endswith(MESSAGES)]
    assert all(isinstance(q.formula, str) for b in messages for q in b.quantities)


def test_functions_are_counted_by_how_deep_they_are():
    assert deepest('=IF(AND(A1="((",(1+2)*SUM(B1)),1,2)') == 3
