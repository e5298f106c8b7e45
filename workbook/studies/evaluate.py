"""The results of designs: those that differ only in what scales at once, all others one by one."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from workbook.book.declare import Book
from workbook.book.rows import as_rows
from workbook.entries.machine import Machine
from workbook.scaling import Column, Results
from workbook.studies.model import Bound
from workbook.studies.plan import Plan
from workbook.templates import TEMPLATES

Values = NDArray[Any]
ENDLESS = "∞"  # what a book shows of a jerk where the acceleration jumps
NOTHING = "this result has no value"


@dataclass(frozen=True)
class Table:
    """Designs by their numbers from ``begin``: entries by dimension, results by name, why one is impossible.

    A result is NaN, or an empty text, where there is none. ``fails`` says by constraint which designs break it.
    """

    begin: int
    entries: tuple[Column, ...]
    results: Mapping[str, Values]
    fails: Mapping[str, NDArray[np.bool_]]
    reasons: Values

    def __len__(self) -> int:
        return len(self.reasons)

    @property
    def possible(self) -> NDArray[np.bool_]:
        """Which designs there can be."""
        return np.asarray(self.reasons == "")

    @cached_property
    def feasible(self) -> NDArray[np.bool_]:
        """Which designs keep to all constraints."""
        return np.asarray(~np.logical_or.reduce([~self.possible, *self.fails.values()]))


class Found(NamedTuple):
    """What is found of designs that are worked out together; why there is nothing, if so."""

    results: Mapping[str, Any]
    fails: Mapping[str, Any]
    reason: str = ""


class Evaluator:
    """What works designs of a plan out; slow checks, unless ``thorough``, only of designs that keep to all else."""

    def __init__(self, plan: Plan, thorough: bool = False) -> None:
        self.plan, self.names, self.thorough = plan, plan.study.names, thorough
        self._last: tuple[tuple[Any, ...], Machine | str] | None = None

    @cached_property
    def usual(self) -> Results:
        """The results of the base that come without a book."""
        return of_no_book(self.plan.base)

    @cached_property
    def asked(self) -> list[str]:
        """The names of results and of what is bounded."""
        return list(dict.fromkeys([*self.names, *self.plan.bounds]))

    @property
    def from_books(self) -> list[str]:
        """The results that need a book of each design."""
        return [name for name in self.asked if name not in self.usual.named]

    @cached_property
    def swift(self) -> bool:
        """Whether all results come without a book."""
        return self.plan.template.scaling is not None and not self.from_books

    def table(self, begin: int, columns: Sequence[Column]) -> Table:
        """Return the results of designs that are numbered from ``begin``."""
        count = len(columns[0].places)
        found: list[tuple[Found, int]] = []
        for first, last in groups(columns, self._outer, count):
            some = [Column(one.values, one.places[first:last]) for one in columns]
            found.append((self._group(some, last - first), last - first))
        results = {name: together([wide(one.results.get(name, np.nan), n) for one, n in found]) for name in self.names}
        constraints = dict.fromkeys(name for one, _ in found for name in one.fails)
        fails = {name: np.concatenate([wide(one.fails.get(name, False), n) for one, n in found])
                 for name in constraints}  # fmt: skip
        reasons = np.concatenate([np.full(n, one.reason, dtype=object) for one, n in found])
        return Table(begin, tuple(columns), results, fails, reasons)

    @cached_property
    def _outer(self) -> list[int]:
        """The dimensions in which a design is worked out by itself."""
        return [k for k, one in enumerate(self.plan.space.dimensions) if not (self.swift and one.part)]

    def _group(self, columns: Sequence[Column], count: int) -> Found:
        """Return what is found of designs that are worked out together."""
        dimensions = self.plan.space.dimensions
        chosen = {dimensions[k]: columns[k].values[columns[k].places[0]] for k in self._outer}
        values = tuple(chosen.values())
        if self._last is None or self._last[0] != values:
            self._last = values, self.plan.machine(chosen)
        machine = self._last[1]
        if isinstance(machine, str):
            return Found({}, {}, machine)
        try:
            if not self.swift:
                book = self.plan.template.declare(machine)
                results = {name: of_book(book, name) for name in self.asked}
                checks = {q.name: q.value != "OK" for _, q in book.checks if not self.plan.study.is_off(q.name)}
                return Found(results, checks | self._beyond(results))
            scaled = {one.key: column for one, column in zip(dimensions, columns, strict=True) if one.part}
            return self._scaled(machine, scaled, count)
        except (ValueError, ArithmeticError) as error:  # what the engine refuses
            return Found({}, {}, str(error).replace("\n", " "))

    def _beyond(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return which designs do not keep to bounds."""
        return {name: ~keeps(bound, np.asarray(values[name])) for name, bound in self.plan.bounds.items()}

    def _scaled(self, machine: Machine, scaled: Mapping[str, Column], count: int) -> Found:
        """Return what is found of designs that differ only in what scales."""
        scaling = self.plan.template.scaling
        assert scaling is not None  # noqa: S101 - of a plan that is swift
        asked = scaling.results(machine, scaled)
        values = {name: asked.named[name]() for name in self.asked}
        fails = self._beyond(values)
        checks = [name for name in asked.checks if name not in fails and not self.plan.study.is_off(name)]
        fails |= {name: asked.named[name]() != "OK" for name in checks if name not in asked.slow}
        broken = np.logical_or.reduce([wide(False, count), *(wide(one, count) for one in fails.values())])
        left = np.arange(count) if self.thorough else np.flatnonzero(~broken)
        if left.size:
            few = {key: Column(one.values, wide(one.places, count)[left]) for key, one in scaled.items()}
            some = asked if left.size == count else scaling.results(machine, few)
            for name in (one for one in checks if one in asked.slow):
                fails[name] = np.zeros(count, dtype=bool)
                fails[name][left] = some.named[name]() != "OK"
        return Found(values, fails)


def wide(values: Any, count: int) -> Values:
    """Return a value for each of so many designs."""
    return np.broadcast_to(np.asarray(values), count)


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


def of_no_book(machine: Machine) -> Results:
    """Return the results of a machine that come without a book."""
    scaling = TEMPLATES[machine.template].scaling
    return scaling.results(machine, {}) if scaling else Results({}, (), ())


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
    numbers = values.astype(np.float64)  # what is none keeps to nothing
    low, high = -np.inf if bound.min is None else bound.min, np.inf if bound.max is None else bound.max
    return np.asarray((numbers >= low) & (numbers <= high))
