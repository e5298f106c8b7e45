"""Faults in a workbook's defined names: one leads elsewhere, or two inputs' have changed places."""

import random
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from unittest.mock import patch

from tests.mutation.bench import Bench
from tests.mutation.mutants import REFERENCE, STEPS, moved, tokens_of
from workbook.errors import MotionbookError
from workbook.judging.verify import verify
from workbook.reading.files import BookFile, find_places


@dataclass(frozen=True)
class Redirection:
    """Names of the workbook with what they are made to refer to."""

    targets: dict[str, str]

    def __str__(self) -> str:
        return ", ".join(f"{name} -> {target}" for name, target in self.targets.items())


def swapped(bench: Bench, seed: int | str) -> Iterator[Redirection]:
    """Yield pairs of inputs whose names have changed places; their values differ."""
    drawn = random.Random(seed)
    names = bench.orchard.mutator.inputs
    values = {name: bench.declared.blocks[name].quantities[0].value for name in names}
    pairs = [(a, b) for i, a in enumerate(names) for b in names[i + 1 :] if values[a] != values[b]]
    for a, b in drawn.sample(pairs, len(pairs)):
        yield Redirection({a: bench.targets[b], b: bench.targets[a]})


def blocks(bench: Bench) -> list[str]:
    """Return the names of blocks: where inputs, results and tables are found."""
    return list(bench.declared.blocks)


def columns(bench: Bench) -> list[str]:
    """Return the names of tables' columns that formulas look up."""
    used = {t.value for f in bench.model.formulas for t in tokens_of(bench.file.value(f))}
    return [name for name in bench.declared.column_names if name in used]


def shifted(bench: Bench, names: list[str], count: int, seed: int | str) -> Iterator[Redirection]:
    """Yield some of ``names``, each by a row or a column away, or a range's end moved."""
    drawn = random.Random(seed)
    for name in drawn.sample(names, min(count, len(names))):
        found = REFERENCE.fullmatch(bench.targets[name])
        assert found is not None
        first, last = found[2], found[7]
        rows, columns = drawn.choice(STEPS)
        if last and drawn.random() < 0.5:
            corners = [first, moved(last, 1, 0)]
        else:
            corners = [moved(c, rows, columns) for c in (first, last) if c]
        yield Redirection({name: (found[1] or "") + ":".join(c for c in corners if c)})


def outcome(bench: Bench, redirection: Redirection) -> str:
    """Return what ``verify`` makes of the book: "agrees", "found", or "refused" with a word on the entries."""
    with redirected(bench, redirection):
        file = BookFile(bench.file.path, bench.workbook, find_places(bench.workbook))
        known = patch(
            "workbook.reading.descriptions.TEMPLATES", {bench.template.name: bench.template}
        )  # it remembers books
        with known, patch("workbook.judging.verify.open_book", return_value=file):
            try:
                return "agrees" if verify(bench.file.path).agrees else "found"
            except MotionbookError:
                return "refused"


@contextmanager
def redirected(bench: Bench, redirection: Redirection) -> Iterator[None]:
    """Let names lead elsewhere, and back to their places afterwards."""
    names = bench.workbook.defined_names
    try:
        for name, target in redirection.targets.items():
            names[name].attr_text = target
        yield
    finally:
        for name in redirection.targets:
            names[name].attr_text = bench.targets[name]
