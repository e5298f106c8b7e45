"""Faults in the pump's workbook, one at a time: docs/any-workbook.md says how many of them are named."""

from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from tests.mutation.mutants import literals, operators, shifts, tokens_of
from tests.workbook.oracle.test_oracle import PUMP, build
from workbook.book.address import Address
from workbook.oracle.declarations import load_oracle
from workbook.oracle.judge import Judge
from workbook.reading.files import open_book
from workbook.witnesses.registry import WITNESSES

PAGE = Path(__file__).parents[3] / "docs/any-workbook.md"
MAKERS = {"operator": operators, "constant": literals, "reference": shifts}
CASES = 100
FLOW, HEAD, EFFICIENCY, POWER = (Address("Sheet", row, 2) for row in (1, 2, 3, 6))
TABLE = [(row, Address("Sheet", row, 2), Address("Sheet", row, 3)) for row in range(10, 14)]


def faults(book):
    """Yield each fault of a formula that an output follows from: its kind, its cell and what stands there."""
    for cell in book.contents.formulas:
        text = book.value(cell)
        if cell.a1 == "B7":  # a note, from which nothing follows
            continue
        yield "sign", cell, f"=-({text[1:]})"
        yield "value", cell, 7.5
        tokens = tokens_of(text)
        for kind, make in MAKERS.items():
            for at in range(len(tokens)):
                for other in make(tokens, at):
                    yield kind, cell, "=" + "".join(t.value if i != at else other for i, t in enumerate(tokens))


def changes_an_output(path):
    """Whether an output is another than by hand at cases of a seed of its own, as formulon computes it."""
    drawn = np.random.default_rng(59).uniform([5, 2, 0.4], [80, 60, 0.9], (CASES, 3)).tolist()
    entered = [dict(zip((FLOW, HEAD, EFFICIENCY), case, strict=True)) for case in drawn]
    for (q, h, eta), (_, values) in zip(drawn, WITNESSES["formulon"]().varied(open_book(path), entered), strict=True):
        expected = {POWER: 9.81 * q * h / 3600 / eta}
        for row, v, a in TABLE:
            expected |= {v: (row - 10) / 4 * q, a: (row - 10) / 2 * q}
        if any(values[cell] != pytest.approx(value, rel=1e-9, abs=1e-9) for cell, value in expected.items()):
            return True
    return False


@pytest.mark.nightly
@pytest.mark.skipif(WITNESSES["formulon"]().version() is None, reason="formulon is not on this machine")
def test_the_page_says_how_many_faults_of_the_pump_s_workbook_are_named(tmp_path):
    declared, path = tmp_path / "pump.py", tmp_path / "pump.xlsx"
    declared.write_text(PUMP, encoding="utf-8")
    counts = Counter()
    for kind, cell, content in [*faults(open_book(build(path)))]:
        file = open_book(build(path, **{cell.a1: content}))
        if Judge(file, load_oracle(declared)).judge(CASES).wrong:
            counts[kind, "named"] += 1
        else:
            counts[kind, "missed" if changes_an_output(path) else "alike"] += 1
    rows = []
    for kind in dict.fromkeys(kind for kind, _ in counts):
        named, missed, alike = (counts[kind, outcome] for outcome in ("named", "missed", "alike"))
        rows.append(f"| {kind} | {named + missed + alike} | {alike} | {named} of {named + missed} |\n")
    assert "".join(rows) in PAGE.read_text(encoding="utf-8")
