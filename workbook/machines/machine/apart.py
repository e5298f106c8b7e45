"""The engine's view of two axes that must stay apart."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np

from engine.machine.bent import middle, stretches, turned
from engine.motion.nearing import NODES, Nearing, gap_size, keeps, nearings
from engine.motion.shifted import Gap, Shifted, least_gap
from workbook.book.rows import filled
from workbook.entries.texts import place_of
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown, si
from workbook.machines.machine.clearance import ClearanceEntry
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.view import clearance_name

GRID: list[float] = np.linspace(0.0, TURN, NODES + 1)[:-1].tolist()
"""where stretches begin besides"""


class Apart:
    """A clearance: its gap over the cycle, in the unit of the first axis."""

    def __init__(self, given: ClearanceEntry, number: int, rows: list[AxisRows]) -> None:
        self.given, self.number = given, number
        self.rows = [rows[axis_place(name, rows)] for name in (given.first, given.second)]
        self.unit, self.over = self.rows[0].axis.unit, self.rows[0].machine.over

    @property
    def name(self) -> str:
        """The name of the cell that tells what it is called, and of which axes it is."""
        return clearance_name(self.number, *(one.axis.number for one in self.rows))

    @property
    def scales(self) -> list[float]:
        """What a position of each axis in m or rad is multiplied by."""
        factors = (self.given.first_factor, self.given.second_factor)
        return [shown(factor, one.axis.unit) for factor, one in zip(factors, self.rows, strict=True)]

    @cached_property
    def terms(self) -> list[tuple[float, Shifted]]:
        """The factors and motions."""
        return [(scale, one.axis.shifted) for scale, one in zip(self.scales, self.rows, strict=True)]

    @cached_property
    def gap(self) -> Gap:
        """The least gap, and where (rad)."""
        return least_gap(self.terms, self.given.offset)

    @property
    def size(self) -> float:
        """How large the gap grows."""
        return gap_size(self.terms, self.given.offset)

    @property
    def kept(self) -> bool:
        """Whether the least gap is left."""
        return keeps(self.gap.least, self.given.least, self.size)

    @property
    def steep(self) -> float:
        """How large its slope grows."""
        return self.stretches[0].steep

    @property
    def room(self) -> int:
        """Rows of the table of stretches."""
        return len(self.breaks) - 1

    @cached_property
    def breaks(self) -> list[float]:
        """Where a stretch can begin, and the end of the turn (degrees of the master shaft)."""
        found = [turned(at, one.axis.given.shift, TURN, one.machine.near) for one in self.rows for at in begins(one)]
        return [*found, *GRID, TURN]

    @cached_property
    def spans(self) -> list[tuple[float, float]]:
        """Begin and end of each stretch (degrees of the master shaft)."""
        return stretches(self.breaks, TURN, self.rows[0].machine.near)

    @cached_property
    def stretches(self) -> list[Nearing]:
        """The stretches."""
        return nearings(self.terms, self.given.offset, [(si(a, DEGREE), si(b, DEGREE)) for a, b in self.spans])

    def of(self, figure: Callable[[Nearing], Any]) -> list[Any]:
        """Return a figure of each stretch; spare rows repeat the last."""
        return filled(map(figure, self.stretches), self.room, figure(self.stretches[-1]))

    def ends(self, k: int) -> list[float]:
        """Return the begin, 0, or the end, 1, of each stretch."""
        return filled([span[k] for span in self.spans], self.room, self.spans[-1][k])

    def told(self, end: int) -> list[tuple[int, int, float]]:
        """Return, for each stretch, which cycle of an axis it is in, which piece, from 1, and u at its begin (rad)."""
        one = self.rows[end]
        found = [_told(one, span) for span in self.spans]
        return filled(found, self.room, found[-1])

    def near(self, one: Nearing) -> int:
        """Whether the gap is least in a stretch."""
        return int(keeps(self.gap.least, one.least, self.size))

    def where(self, one: Nearing) -> float:
        """Return where the gap is least in a stretch (degrees of the master shaft)."""
        return shown(one.place, DEGREE)

    @property
    def place(self) -> float:
        """Where it is least of all."""
        return next(self.where(one) for one in self.stretches if self.near(one))


def axis_place(name: str, rows: list[AxisRows]) -> int:
    """Return the place of an axis by its name; where a file's layout tells it, by its number."""
    place = place_of(name, [one.axis.given.name for one in rows])
    return place if place >= 0 else int(name) - 1


def begins(one: AxisRows) -> list[float]:
    """Return where each piece of an axis begins, in degrees of its phases; spare ones at the end of the turn."""
    return filled([shown(piece.begin, DEGREE) for piece in one.pieces.pieces], one.machine.room, TURN)


def _told(one: AxisRows, span: tuple[float, float]) -> tuple[int, int, float]:
    late, known = one.axis.given.shift, begins(one)[: len(one.pieces.pieces)]
    inside = turned(middle(span), -late, TURN, one.machine.near)
    cycle = round(shown(middle(span) - late - inside, TURN))
    row = int(np.searchsorted(known, inside, side="right"))
    return cycle, row, si(span[0] - late - shown(cycle, shown(1.0, TURN)) - known[row - 1], DEGREE)
