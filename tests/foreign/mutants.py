"""Faults in workbooks that are declared in Python, one at a time, and whether they are named.

Source of the classes: R. Abraham, M. Erwig, Mutation operators for spreadsheets, IEEE Trans. Softw. Eng. 35 (2009).
"""

import random
from collections import defaultdict
from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain, zip_longest
from typing import Any

from tests.mutation.mutants import functions, literals, operators, ranges, shifts, tokens_of
from workbook.book.address import Address
from workbook.book.formula import FormulaError, read
from workbook.oracle.declarations import Oracle, cases, close
from workbook.oracle.judge import Judge
from workbook.reading.files import BookFile

MAKERS = {"operator": operators, "function": functions, "constant": literals, "reference": shifts,
          "range": partial(ranges, {})}  # fmt: skip
UNITS = {"m": "s", "mm": "m", "W": "kW", "K": "W", "V": "A", "A": "V", "ohm": "V"}
OTHER_CASES = 100


@dataclass(frozen=True)
class Fault:
    """A cell with another content than it had."""

    cell: Address
    kind: str
    content: Any


def faults_of(judge: Judge) -> Iterator[tuple[tuple[str, ...], Fault]]:
    """Yield every fault in the counted formulas and in the units beside declared cells, with what it is alike to."""
    for cell in judge.formulas:
        text = judge.file.value(cell)
        formula = judge.file.contents.formulas.get(cell)
        if not isinstance(text, str) or formula is None:
            continue
        text, alike = text.strip("{}"), (cell.sheet, formula.shape)
        yield ("value", *alike), Fault(cell, "value", judge.values(judge.entered).get(cell))
        yield ("sign", *alike), Fault(cell, "sign", f"=-({text[1:]})")
        tokens = tokens_of(text)
        for kind, make in MAKERS.items():
            for at in range(len(tokens)):
                for other in make(tokens, at):
                    mutated = "=" + "".join(t.value if i != at else other for i, t in enumerate(tokens))
                    yield (kind, *alike), Fault(cell, kind, mutated)
    for cell, unit in judge.looks.units.items():
        beside = cell._replace(column=cell.column + 1)
        if unit in UNITS and judge.file.contents.constants.get(beside) == unit:
            yield ("unit", str(cell)), Fault(beside, "unit", UNITS[unit])


def sample(judge: Judge, size: int, seed: int) -> list[Fault]:
    """Return so many faults, spread over their kinds and over formulas that are not alike."""
    groups: dict[tuple[str, ...], list[Fault]] = defaultdict(list)
    for key, fault in faults_of(judge):
        groups[key].append(fault)
    drawn = random.Random(seed)
    for group in groups.values():
        drawn.shuffle(group)
    keys = sorted(groups)
    drawn.shuffle(keys)
    rounds = chain.from_iterable(zip_longest(*(groups[key] for key in keys)))
    return [fault for fault in rounds if fault is not None][:size]


def put_in(file: BookFile, fault: Fault) -> BookFile:
    """Return the book with a fault in it."""
    contents, cell = copy(file.contents), fault.cell
    contents.__dict__.pop("patterns", None)
    contents.formulas = {at: formula for at, formula in contents.formulas.items() if at != cell}
    contents.constants, contents.failed = dict(contents.constants), dict(contents.failed)
    if str(fault.content).startswith("="):
        try:
            contents.formulas[cell] = read(fault.content, cell.sheet, contents.area)
        except FormulaError as error:
            contents.failed[cell] = error.value
    else:
        contents.constants[cell] = fault.content
    made = replace(file)
    made.__dict__["contents"] = contents
    return made


class Trial:
    """A sound book, what it computes at cases other than those at which it is judged, and faults put in."""

    def __init__(self, file: BookFile, oracle: Oracle) -> None:
        self.file, self.oracle = file, oracle
        self.judge = Judge(file, oracle)
        entered = self.judge.entered
        self.tried = cases(oracle.inputs, entered, 100)
        self.others = cases(oracle.inputs, entered, OTHER_CASES, seed=1)
        self.expected = [list(self.judge.expected(case, self.judge.values(case))) for case in self.others]

    def outcome(self, fault: Fault) -> str:
        """Return "named", "missed", or "alike" of a fault that changes no output by more than its tolerance."""
        judge = Judge(put_in(self.file, fault), self.oracle)
        if any(True for _ in chain(judge.deviating(self.tried, ("pycel",), []), judge.other_findings())):
            return "named"
        if judge.looks.dimensions(judge.model.order).wrong:
            return "named"
        for case, expected in zip(self.others, self.expected, strict=True):
            values = judge.values(case)
            if any(not close(values.get(cell), value, allowed) for cell, value, allowed, _ in expected):
                return "missed"
        return "alike"
