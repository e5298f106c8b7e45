"""The results of designs: those that differ only in what scales at once, all others one by one."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from workbook.book.declare import Book
from workbook.book.rows import as_rows
from workbook.entries.machine import Machine
from workbook.scaling import Column
from workbook.studies.model import Bound
from workbook.studies.plan import Plan
from workbook.studies.space import Dimension

Values = NDArray[Any]
ENDLESS = "∞"
"""what a book shows of a jerk where the acceleration jumps"""
NOTHING = "this result has no value"


@dataclass(frozen=True)
class Table:
    """Designs by their numbers from ``begin``: entries by dimension, results by name, why one is impossible.

    A result is NaN, or an empty text, where there is none.
    """

    begin: int
    entries: tuple[Column, ...]
    results: Mapping[str, Values]
    reasons: Values

    def __len__(self) -> int:
        return len(self.reasons)

    @property
    def possible(self) -> NDArray[np.bool_]:
        """Which designs there can be."""
        return np.asarray(self.reasons == "")


class Evaluator:
    """What works designs of a plan out; the machine of the last design is kept."""

    def __init__(self, plan: Plan) -> None:
        self.plan, self.names = plan, plan.study.names
        self._last: tuple[tuple[Any, ...], Machine | str] | None = None

    @cached_property
    def swift(self) -> bool:
        """Whether all results come without a book."""
        scaling = self.plan.template.scaling
        return scaling is not None and set(self.names) <= set(scaling.results(self.plan.base, {}))

    def table(self, begin: int, columns: Sequence[Column]) -> Table:
        """Return the results of designs that are numbered from ``begin``."""
        count = len(columns[0].places)
        found: dict[str, list[Values]] = {name: [] for name in self.names}
        reasons: list[Values] = []
        for first, last in groups(columns, self._outer, count):
            some = [Column(one.values, one.places[first:last]) for one in columns]
            values, reason = self._group(some, last - first)
            reasons.append(np.full(last - first, reason, dtype=object))
            for name in self.names:
                found[name].append(np.broadcast_to(np.asarray(values.get(name, np.nan)), last - first))
        whole = {name: together(each) for name, each in found.items()}
        return Table(begin, tuple(columns), whole, np.concatenate(reasons))

    @cached_property
    def _outer(self) -> list[int]:
        """The dimensions in which a design is worked out by itself."""
        return [k for k, one in enumerate(self.plan.space.dimensions) if not (self.swift and one.part)]

    def _group(self, columns: Sequence[Column], count: int) -> tuple[dict[str, Any], str]:
        """Return results of designs that are worked out together, or why there are none."""
        dimensions = self.plan.space.dimensions
        chosen = {dimensions[k]: columns[k].values[columns[k].places[0]] for k in self._outer}
        machine = self._machine(chosen)
        if isinstance(machine, str):
            return {}, machine
        try:
            if not self.swift:
                book = self.plan.template.declare(machine)
                return {name: of_book(book, name) for name in self.names}, ""
            scaled = {one.key: column for one, column in zip(dimensions, columns, strict=True) if one.part}
            scaling = self.plan.template.scaling
            results = scaling.results(machine, scaled) if scaling else {}
            return {name: results[name]() for name in self.names}, ""
        except (ValueError, ArithmeticError) as error:  # what the engine refuses
            return {}, str(error).replace("\n", " ")

    def _machine(self, chosen: dict[Dimension, Any]) -> Machine | str:
        values = tuple(chosen.values())
        if self._last is None or self._last[0] != values:
            self._last = values, self.plan.machine(chosen)
        return self._last[1]


def groups(columns: Sequence[Column], outer: Sequence[int], count: int) -> Iterator[tuple[int, int]]:
    """Yield from which row to which designs follow each other that are the same in the outer columns."""
    if not outer:
        yield 0, count
        return
    indices = np.array([columns[k].places for k in outer])
    cuts = np.flatnonzero((indices[:, 1:] != indices[:, :-1]).any(axis=0)) + 1
    yield from pairwise([0, *cuts.tolist(), count])


def together(parts: Sequence[Values]) -> Values:
    """Return values one behind the other: numbers, or texts with an empty one where there is none."""
    if all(part.dtype.kind in "fiub" for part in parts):
        return np.concatenate([part.astype(np.float64) for part in parts])
    texts = [np.full(len(p), "", dtype=object) if p.dtype.kind == "f" else p.astype(object) for p in parts]
    return np.concatenate(texts)


def of_book(book: Book, name: str) -> Any:
    """Return the engine's value of a cell of a book by its name: of a block, or ``table.column.row``."""
    block, _, rest = name.partition(".")
    column, _, row = rest.partition(".")
    found = book.blocks[block]
    quantity = next(q for q in found.quantities if q.name == column) if column else found.quantities[0]
    value = as_rows(quantity.value, found.size, name)[int(row or 1) - 1]
    if value is None:
        raise ValueError(f"{name}: {NOTHING}")
    return np.inf if value == ENDLESS else value


def keeps(bound: Bound | str, values: Values) -> NDArray[np.bool_]:
    """Return which results keep to a bound, or are a text."""
    if isinstance(bound, str):
        return np.asarray(values == bound)
    kept = ~np.isnan(values.astype(np.float64))
    if bound.min is not None:
        kept &= values >= bound.min
    if bound.max is not None:
        kept &= values <= bound.max
    return np.asarray(kept)
