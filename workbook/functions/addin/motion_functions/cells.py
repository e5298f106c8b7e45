"""Codes, parameters and phases in cells, empty ones as empty texts, arguments left out as None; motions, and sums."""

from __future__ import annotations

import math
from bisect import bisect_right
from functools import lru_cache
from itertools import accumulate
from typing import Mapping, NamedTuple, Sequence, Tuple, Union

from .law import NUM, OUTSIDE, TOLERANCE, VALUE, Law, Refused
from .library import OWN, OWN_WIDTH, PARAMETERS, REST, End, Rows, law

Cell = Union[float, str]
Cells = Union[Cell, Tuple[Tuple[Cell, ...], ...], None]
TURNS = {"start": -1.0, "none": 0.0, "end": 1.0}  # where a law turns round, as a number
AGREES = 1e-9
VIA = "VIA"  # stands for the code in a row of what is prescribed between phases


class Via(NamedTuple):
    """Velocity, acceleration and jerk that are prescribed where two phases meet, or where the motion begins or ends."""

    v: float = 0.0
    a: float = 0.0
    j: float = 0.0


class Row(NamedTuple):
    """A phase: code and parameters of its law, duration and lift."""

    code: str
    parameters: Rows
    duration: float
    lift: float

    @property
    def straight(self) -> bool:
        """Whether it is a straight line, or a dwell."""
        return self.code in ("LIN", "DWL")

    def met(self, end: Via) -> End:
        """Return the rates that it has to meet at an end per unit of its duration; a straight line meets nothing."""
        return REST if self.straight else (end.v * self.duration, end.a * self.duration**2, end.j * self.duration**3)


class Motion:
    """Phases in succession, from position 0: from x = 0, or from a rest that goes on before and after."""

    def __init__(self, rows: Sequence[Row | Via], rests_from: float | None = None) -> None:
        met = [(end_condition(rows, k, -1), end_condition(rows, k, 1)) for k in range(len(rows))]
        phases = [(row, ends) for row, ends in zip(rows, met) if isinstance(row, Row)]
        if not phases:
            raise Refused(NUM if rows else VALUE)
        self.durations = [row.duration for row, _ in phases]
        self.laws = [law(row.code, row.parameters, row.lift, *(row.met(end) for end in ends)) for row, ends in phases]
        *self.begins, self.total = accumulate([0.0, *self.durations])
        self.positions = list(accumulate([0.0, *(row.lift for row, _ in phases)]))
        self.rests_from = rests_from

    def later(self, x: float, shift: float, cycle: float) -> tuple[float, float, float]:
        """Return the same of the motion later by a shift, repeated after each cycle; a cycle of 0: it runs once."""
        if not cycle:
            return self.at(x - shift)
        first, last = 0.0, self.total
        if self.rests_from is not None:
            first, last = (self.rests_from + part * self.total / 3.0 for part in (1, 2))
        if cycle < 0.0 or first < -AGREES * self.total or last > cycle * (1.0 + AGREES):
            raise Refused(NUM)
        cycles = math.floor((x - shift) / cycle + TOLERANCE)
        y, v, a = self.at(max(x - shift - cycles * cycle, 0.0))
        return y + cycles * self.positions[-1], v, a

    def at(self, x: float) -> tuple[float, float, float]:
        """Return position, velocity per unit of x, acceleration per unit of x²; at a joint of the later phase."""
        if self.rests_from is not None:
            x = min(max(x - self.rests_from, 0.0), self.total)
        if not -OUTSIDE * self.total <= x <= self.total * (1.0 + OUTSIDE):
            raise Refused(NUM)
        k = max(bisect_right(self.begins, x + TOLERANCE * self.total) - 1, 0)
        duration = self.durations[k]
        s, v, a, _ = self.laws[k].at(min(max((x - self.begins[k]) / duration, 0.0), 1.0))
        return self.positions[k] + s, v / duration, a / duration / duration


def end_condition(rows: Sequence[Row | Via], k: int, side: int) -> Via:
    """Return the condition of a row beside it: a straight line, what is prescribed, else rest."""
    asked, place = rows[k], k + side
    near = rows[place] if 0 <= place < len(rows) else None
    if isinstance(asked, Row) and isinstance(near, Via):
        asked, place = near, place + side
        near = rows[place] if 0 <= place < len(rows) else None
    if isinstance(asked, Via) and isinstance(near, Via):
        raise Refused(NUM)
    if isinstance(near, Row) and near.straight:
        own = near.lift / near.duration
        if isinstance(asked, Via) and (asked.a or asked.j or abs(asked.v - own) > AGREES * (abs(asked.v) + abs(own))):
            raise Refused(NUM)
        return Via(own)
    return asked if isinstance(asked, Via) else Via()


def number(cell: Cell, words: Mapping[str, float] = {}) -> float:
    """Return the number in a cell, 0 of an empty cell, or what any of these words stands for; refuses another text."""
    if isinstance(cell, str):
        cell = words.get(cell.strip().lower(), cell or 0.0)
    if isinstance(cell, str):
        raise Refused(VALUE)
    return cell


def rows(cells: Cells, words: Mapping[str, float] = {}) -> Rows:
    """Return the numbers of a range, or of a single value, by row."""
    if cells is None:
        raise Refused(VALUE)
    table = cells if isinstance(cells, tuple) else ((cells,),)
    return tuple(tuple(number(cell, words) for cell in row) for row in table)


def parameters(code: str, given: Cells) -> Rows:
    """Return the parameters of a law in cells; those of a law that takes none are not looked at."""
    if PARAMETERS.get(code) == 0 or given is None:
        return OWN if code == "OWN" else ((0.0,),)
    if code != "OWN":
        return rows(given, TURNS)
    filled = rows(given)
    # blank rows are no pieces, and would fill the cache
    return tuple(row for row in filled if any(row)) or filled[:1]


def as_law(name: Cell, given: Cells) -> Law:
    """Return the law of a code with the parameters in cells."""
    code = str(name).strip().upper()
    return law(code, parameters(code, given))


def motion(table: Cells) -> Motion:
    """Return the motion of rows code, duration, lift, parameters; or, as in books, from, to, lift, code, parameters."""
    if not isinstance(table, tuple) or len(table[0]) < 3:
        raise Refused(VALUE)
    dated = any(isinstance(row[0], float) for row in table)
    count, looked_at = len(table), 4 if dated else 3
    while count and not any(cell != "" for cell in table[count - 1][:looked_at]):
        count -= 1
    return (resting_motion if dated else motion_of_table)(table[:count])


@lru_cache(maxsize=128)
def motion_of_table(table: tuple[tuple[Cell, ...], ...]) -> Motion:
    """Return the motion of a table without blank rows at its end; a row VIA prescribes what its phases have there."""
    return Motion(
        [
            Via(*(number(cell) for cell in (*row[1:4], 0.0)[:3])) if str(row[0]).strip().upper() == VIA else phase(row)
            for row in table
        ]
    )


@lru_cache(maxsize=128)
def resting_motion(table: tuple[tuple[Cell, ...], ...]) -> Motion:
    """Return the motion of phases from, to, which rests before, between and after them."""
    if len(table[0]) < 4 or any(str(row[3]).strip().upper() == VIA for row in table):
        raise Refused(VALUE)
    starts, stops = [number(row[0]) for row in table], [number(row[1]) for row in table]
    length = stops[-1] - starts[0]
    begin, end = starts[0] - length, stops[-1] + length
    phases = []
    for done, start, stop, row in zip([begin, *stops], [*starts, end], [*stops, end], [*table, ()]):
        if abs(start - done) > AGREES * abs(length):
            phases.append(phase(("DWL", start - done, 0.0)))
        if row:
            phases.append(phase((row[3], stop - start, row[2], *row[4:])))
    return Motion(phases, begin)


def phase(row: tuple[Cell, ...]) -> Row:
    """Return law, parameters, duration and lift of a row of cells; refuse one that is no phase."""
    code = str(row[0]).strip().upper()
    duration, lift = number(row[1]), number(row[2])
    given: tuple[tuple[Cell, ...], ...] = (row[3 : 3 + PARAMETERS.get(code, 0)] or (0.0,),)
    if code == "OWN":  # its pieces follow each other in a row
        given = tuple(row[start : start + OWN_WIDTH] for start in range(3, len(row) - OWN_WIDTH + 1, OWN_WIDTH))
        if not given:
            raise Refused(VALUE)
    given_numbers = parameters(code, given)
    law(code, given_numbers)  # refuses a code and parameters before all else
    if duration <= 0.0 or (code == "DWL" and lift):
        raise Refused(NUM)
    return Row(code, given_numbers, duration, lift)


def single(cells: Cells) -> float:
    """Return the number of a single cell, 0 of an argument that is left out; refuses several cells."""
    table = ((0.0,),) if cells is None else rows(cells)
    if len(table) != 1 or len(table[0]) != 1:
        raise Refused(VALUE)
    return table[0][0]


def pairs(one: Cells, other: Cells) -> tuple[list[float], list[float]]:
    """Return the numbers of two ranges; refuses ranges of unequal rows or columns."""
    first, second = rows(one), rows(other)
    if [len(row) for row in first] != [len(row) for row in second]:
        raise Refused(VALUE)
    return [value for row in first for value in row], [value for row in second for value in row]


def reflected(inertias: Sequence[float], ratios: Sequence[float]) -> float:
    """Return Σ J (ω_i/ω)². Source: S1, 'Feeding group layout'."""
    if min(inertias) < 0.0:
        raise Refused(NUM)
    return math.fsum(j * ratio * ratio for j, ratio in zip(inertias, ratios))


def root_mean_square(values: Sequence[float], durations: Sequence[float]) -> float:
    """Return √(Σ v² t / Σ t)."""
    if min(durations) < 0.0 or not sum(durations):
        raise Refused(NUM)
    return math.sqrt(math.fsum(v * v * t for v, t in zip(values, durations)) / math.fsum(durations))
