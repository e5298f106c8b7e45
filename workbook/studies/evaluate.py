"""The results of designs: those that differ only in what scales at once, others each by itself; their labels."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import filter as matching
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from engine.laws.base import Flags
from workbook.book.declare import Book, Quantity
from workbook.book.quantity import OK
from workbook.book.rows import as_rows
from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.studies.paths import nearest
from workbook.studies.plan import Plan, book_names
from workbook.studies.space import Bound, Study
from workbook.template_outputs import Column, Results, Values
from workbook.templates import TEMPLATES

ENDLESS = "∞"  # what a book shows of a jerk where the acceleration jumps
NOTHING = "this result has no value"
UNITS = {"mass": "kg"}
ROW = re.compile(r"(.+)\.(\d+)")


class Label(NamedTuple):
    """The label of a result and its unit."""

    words: str
    unit: str


Labels = dict[str, Label]


@dataclass(frozen=True)
class Table:
    """Designs by their numbers from ``begin``: entries by dimension, results by name, the reason where impossible.

    A result is NaN, or an empty text, where there is none. ``fails`` says by constraint which designs break it.
    """

    begin: int
    entries: tuple[Column, ...]
    results: Mapping[str, Values]
    fails: Mapping[str, Flags]
    reasons: Values

    def __len__(self) -> int:
        return len(self.reasons)

    @property
    def possible(self) -> Flags:
        """Return whether each design is possible."""
        return np.asarray(self.reasons == "")

    @cached_property
    def feasible(self) -> Flags:
        """Return whether each design keeps to all constraints."""
        return np.asarray(~np.logical_or.reduce([~self.possible, *self.fails.values()]))


class GroupResults(NamedTuple):
    """The results of designs that are computed together, or the reason why there are none."""

    results: Mapping[str, Any]
    fails: Mapping[str, Any]
    reason: str = ""


class Evaluator:
    """Computes the results of designs; slow checks, unless ``thorough``, only of designs that keep to all else."""

    def __init__(self, plan: Plan, thorough: bool = False) -> None:
        self.plan, self.names, self.thorough = plan, plan.study.names, thorough
        # the results of the base that come without a book
        self.usual = results_without_book(plan.base)
        self.asked = list(dict.fromkeys([*self.names, *plan.study.bounds]))
        self.from_books = [name for name in self.asked if name not in self.usual.named]
        self.swift = plan.template.scaling is not None and not self.from_books
        self._outer = [k for k, dimension in enumerate(plan.space.dimensions) if not (self.swift and dimension.part)]
        """the dimensions in which a design is worked out by itself"""
        self._last: tuple[tuple[Any, ...], Machine | str] | None = None

    def table(self, begin: int, columns: Sequence[Column]) -> Table:
        """Return the results of designs that are numbered from ``begin``."""
        count = len(columns[0].places)
        places = np.array([columns[k].places for k in self._outer], dtype=np.intp).reshape(-1, count)
        # others follow in an outer dimension
        cuts = np.flatnonzero((places[:, 1:] != places[:, :-1]).any(axis=0)) + 1
        groups: list[tuple[GroupResults, int]] = []
        for first, last in pairwise([0, *cuts.tolist(), count]):
            some = [Column(entry.values, entry.places[first:last]) for entry in columns]
            groups.append((self._group(some, last - first), last - first))
        results = {
            name: joined([spread(group.results.get(name, np.nan), n) for group, n in groups]) for name in self.names
        }
        constraints = dict.fromkeys(name for group, _ in groups for name in group.fails)
        fails = {
            name: np.concatenate([spread(group.fails.get(name, False), n) for group, n in groups])
            for name in constraints
        }
        reasons = np.concatenate([np.full(n, group.reason, dtype=object) for group, n in groups])
        return Table(begin, tuple(columns), results, fails, reasons)

    def _group(self, columns: Sequence[Column], count: int) -> GroupResults:
        """Return the results of designs that are worked out together."""
        dimensions = self.plan.space.dimensions
        chosen = {dimensions[k]: columns[k].values[columns[k].places[0]] for k in self._outer}
        values = tuple(chosen.values())
        if self._last is None or self._last[0] != values:
            self._last = values, self.plan.machine(chosen)
        machine = self._last[1]
        if isinstance(machine, str):
            return GroupResults({}, {}, machine)
        try:
            if not self.swift:
                book = self.plan.template.declare(machine)
                results = {name: book_value(book, name) for name in self.asked}
                exact = self.plan.template.judge(machine)
                checks = {
                    q.name: exact.judge(q.name, q.value, "")[0] != OK
                    for _, q in book.checks
                    if not self.plan.study.is_off(q.name)
                }
                return GroupResults(results, checks | self._beyond(results))
            scaled = {
                dimension.key: column for dimension, column in zip(dimensions, columns, strict=True) if dimension.part
            }
            return self._scaled(machine, scaled, count)
        except (ValueError, ArithmeticError) as error:  # what the engine refuses
            return GroupResults({}, {}, str(error).replace("\n", " "))

    def _beyond(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return which designs do not keep to bounds, or are another text; what is no number keeps to none."""
        broken: dict[str, Any] = {}
        for name, bound in self.plan.study.bounds.items():
            if isinstance(bound, str):
                broken[name] = np.asarray(values[name]) != bound
            else:
                numbers = np.asarray(values[name]).astype(np.float64)
                low = -np.inf if bound.min is None else bound.min
                high = np.inf if bound.max is None else bound.max
                broken[name] = ~((numbers >= low) & (numbers <= high))
        return broken

    def _scaled(self, machine: Machine, scaled: Mapping[str, Column], count: int) -> GroupResults:
        """Return the results of designs that differ only in what scales."""
        scaling = self.plan.template.scaling
        assert scaling is not None  # noqa: S101 - of a plan that is swift
        asked = scaling.results(machine, scaled)
        values = {name: asked.named[name]() for name in self.asked}
        fails = self._beyond(values)
        checks = [name for name in asked.checks if name not in fails and not self.plan.study.is_off(name)]
        fails |= {name: asked.named[name]() != OK for name in checks if name not in asked.slow}
        broken = np.logical_or.reduce([spread(False, count), *(spread(failed, count) for failed in fails.values())])
        left = np.arange(count) if self.thorough else np.flatnonzero(~broken)
        if left.size:
            few = {key: Column(column.values, spread(column.places, count)[left]) for key, column in scaled.items()}
            some = asked if left.size == count else scaling.results(machine, few)
            slow = ((name, some.named[name]) for name in checks if name in asked.slow)
            for name, judge in (*slow, *((name, some.exact[name]) for name in checks if name in some.exact)):
                fails[name] = np.array(spread(fails.get(name, False), count))
                fails[name][left] |= judge() != OK
        return GroupResults(values, fails)


def spread(values: Any, count: int) -> Values:
    """Return a value for each of so many designs."""
    return np.broadcast_to(np.asarray(values), count)


def joined(parts: Sequence[Values]) -> Values:
    """Return values in a row: numbers, or texts, empty where there is none."""
    if all(part.dtype.kind in "fiub" for part in parts):
        return np.concatenate([part.astype(np.float64) for part in parts])
    return np.concatenate([np.full(len(p), "", object) if p.dtype.kind == "f" else p.astype(object) for p in parts])


def results_without_book(machine: Machine) -> Results:
    """Return the results of a machine that come without a book."""
    scaling = TEMPLATES[machine.template].scaling
    return scaling.results(machine, {}) if scaling else Results({}, (), ())


def book_value(book: Book, name: str) -> Any:
    """Return the engine's value of a cell of a book by its name: of a block, or ``table.column.row``."""
    block, column, row = (*name.split("."), "", "")[:3]
    value = as_rows(quantity_of(book, block, column).value, book.blocks[block].size, name)[int(row or 1) - 1]
    if value is None:
        raise ValueError(f"{name}: {NOTHING}")
    return np.inf if value == ENDLESS else value


def quantity_of(book: Book, block: str, column: str) -> Quantity:
    """Return the quantity of a block, or of a column of a table."""
    return next(q for q in book.blocks[block].quantities if not column or q.name == column)


def require_names(plan: Plan, where: str) -> Labels:
    """Return the labels of results and constraints; raise InputError for a name that there is not."""
    book, usual = plan.template.declare(plan.base), results_without_book(plan.base)
    study = plan.study
    known = dict.fromkeys([*usual.named, *book_names(book)])
    checks = [q.name for _, q in book.checks]
    lines = []
    for pattern in study.off:
        if not matching([*checks, *known], pattern):
            lines.append(f"{where}: constraints: no check is named {pattern!r}; expected {nearest(pattern, checks)}")
    for name in study.names:
        if name not in known:
            lines.append(f"{where}: no result is named {name!r}; expected {nearest(name, known)}")
            continue
        value = usual.named[name]() if name in usual.named else book_value(book, name)
        value = value.ravel()[0].item() if hasattr(value, "ravel") else value
        lines += [f"{where}: {line}" for line in misuses(study, name, value)]
    if lines:
        raise InputError(lines)
    return {name: label(book, name) for name in dict.fromkeys([*study.names, *plan.study.bounds, *checks])}


def misuses(study: Study, name: str, value: Any) -> Iterator[str]:
    """Yield what is wrong with the use of a result in a study: a text as a goal, a bound that does not suit it."""
    text = isinstance(value, str)
    if name in study.goals and text:
        yield f"{name} is a text, {value!r}; expected a number to minimise or maximise"
    bound = study.bounds.get(name)
    if bound is not None and text == isinstance(bound, Bound):
        expected = f'{name} = "OK"' if text else f"{name} = {{ max = ... }}"
        yield f"constraints: {name} is {'a text' if text else 'a number'}; expected {expected}"


def listed_results(machine: Machine) -> Iterator[tuple[str, list[tuple[str, Label]]]]:
    """Yield headings and the names below them, a table's rows in a line: ``axis1.v.1…3``."""
    template = TEMPLATES[machine.template]
    book, usual = template.declare(machine), results_without_book(machine)
    inputs = {name for name, block in book.blocks.items() for q in block.quantities if q.role == "input"}
    named = (name for name in dict.fromkeys(book_names(book)) if name not in usual.named)
    fast = [name for name in usual.named if name not in usual.slow]
    slow = [name for name in usual.named if name in usual.slow]
    others = [name for name in named if name.partition(".")[0] not in inputs]
    for heading, names in (("Fast", fast), ("Each design by itself", slow), ("From a book of each design", others)):
        yield heading, [(name, label(book, name.partition("…")[0])) for name in with_row_ranges(names)]


def with_row_ranges(names: list[str]) -> Iterator[str]:
    """Yield names, a table's rows as a range."""
    rows: dict[str, list[str]] = {}
    for name in names:
        match = ROW.fullmatch(name)
        rows.setdefault(match[1] if match else name, []).append(match[2] if match else "")
    for name, numbers in rows.items():
        last = f"…{numbers[-1]}" if len(numbers) > 1 else ""
        yield f"{name}.{numbers[0]}{last}" if numbers[0] else name


def label(book: Book, name: str) -> Label:
    """Return the label of a result."""
    block, column = (*name.split("."), "")[:2]
    if block not in book.blocks:
        return Label(name.partition("_")[2].replace("_", " "), UNITS.get(name.rpartition("_")[2], ""))
    quantity = quantity_of(book, block, column)
    return Label(quantity.label, quantity.unit)
