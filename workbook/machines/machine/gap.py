"""The gap of two axes that must stay apart, over the cycle, and where it is least."""

from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.motion.shifted import GapLine, gap_size, least_gap, least_gap_by_lines, place_in_cycle
from workbook.book.checks import ZERO
from workbook.book.rows import filled
from workbook.entries.phase import TURN
from workbook.fields.texts import place_of
from workbook.fields.units import DEGREE, shown, si
from workbook.machines.machine.entries_beside import ClearanceEntry
from workbook.machines.machine.motion_tables import AxisTables


class Lowest(NamedTuple):
    """Per point, of the parabola from the point before: how far it falls by its slope; its lowest point."""

    fall: Array
    share: Array
    gap: Array
    angle: Array


PARTS, PARTS_BY_PAIRS = 2, 4  # of each piece, at whose begins the gap is worked out
# of the gap's size: the place of a smaller fall would keep fewer than nine digits
FLAT = 1000.0 * ZERO


class FreePositions(NamedTuple):
    """The table of a clearance: the free position of the second axis, on straight lines over the first axis' position.

    Beyond its ends it goes on as its first and its last line do.
    """

    at: Array
    free: Array

    @property
    def slopes(self) -> Array:
        """The slope from each pair to the next."""
        return np.diff(self.free) / np.diff(self.at)

    @property
    def near(self) -> float:
        """So near below a pair a position counts as at it."""
        return ZERO * float(np.ptp(self.at))

    def row(self, y: Array) -> NDArray[np.intp]:
        """Return the number of the line, from 0, on which each position of the first axis lies."""
        return np.clip(np.searchsorted(self.at, y + self.near, side="right") - 1, 0, len(self.at) - 2)

    def slope(self, y: Array) -> Array:
        """Return the slope at positions of the first axis."""
        return self.slopes[self.row(y)]

    def position(self, y: Array) -> Array:
        """Return the free position of the second axis at positions of the first."""
        row = self.row(y)
        return np.asarray(self.free[row] + self.slopes[row] * (y - self.at[row]))


class ClearanceView:
    """A clearance: its gap over the cycle, in the unit of its axis; angles in degrees of the master shaft.

    ``scales`` are what a position of each axis in m or rad is multiplied by, ``terms`` these with the motions, ``size``
    how large the gap grows; the points divide each piece into so many ``parts``.
    """

    def __init__(self, given: ClearanceEntry, number: int, rows: list[AxisTables]) -> None:
        self.given, self.number = given, number
        names = [row.axis.given.name for row in rows]
        places = [(place_of(name, names), name) for name in (given.first, given.second)]
        # a file's layout tells numbers
        self.rows = [rows[k if k >= 0 else int(name) - 1] for k, name in places]
        pairs = np.array([(pair.at, pair.free) for pair in given.pairs])
        self.table = FreePositions(*pairs.T) if given.pairs else None
        self.parts = PARTS_BY_PAIRS if self.table else PARTS
        self.over = self.rows[0].machine.over
        self.unit = self.rows[1 if self.table else 0].axis.given.unit
        self.factors = (given.first_factor, given.second_factor)
        self.scales = [shown(factor, row.axis.unit) for factor, row in zip(self.factors, self.rows, strict=True)]
        self.terms = [(scale, row.axis.shifted) for scale, row in zip(self.scales, self.rows, strict=True)]
        self.size = gap_size(self.terms[1:] if self.table else self.terms, given.offset)
        if self.table:
            self.size += abs(given.first_factor) * float(np.abs(self.table.free).max())

    @property
    def exact(self) -> float:
        """The least gap by closed forms."""
        if self.table:
            (scale, first), second = self.terms
            rows = zip(self.table.at.tolist(), self.table.free.tolist(), self.table.slopes.tolist(), strict=False)
            lines = [
                GapLine(
                    si(at, self.rows[0].axis.unit),
                    self.given.offset + self.factors[0] * (free - slope * at),
                    scale * slope,
                )
                for at, free, slope in rows
            ]
            return least_gap_by_lines(first, second, lines)
        return least_gap(self.terms, self.given.offset).least

    @property
    def change(self) -> float:
        """By how much both axes together can change the gap."""
        moved = [abs(scale) * np.ptp(shifted.motion.reach) for scale, shifted in self.terms]
        if self.table:
            reach = shown(np.array(self.rows[0].axis.motion.reach), self.rows[0].axis.unit)
            inner = self.table.at[(self.table.at > reach.min()) & (self.table.at < reach.max())]
            free = self.table.position(np.concatenate([reach, inner]))
            moved[0] = abs(self.given.first_factor) * np.ptp(free)
        return float(np.sum(moved))

    def cuts(self, end: int) -> list[list[float]]:
        """Return where each piece of an axis begins, and each further part; spare pieces as the end of the turn."""
        axis, room = self.rows[end], max(row.room for row in self.rows)
        near, pieces = axis.machine.near, axis.pieces.pieces
        begins = filled([shown(piece.begin, DEGREE) for piece in pieces], room, TURN)
        first = [place_in_cycle(begin + axis.axis.given.shift, TURN, near) for begin in begins]
        spans = filled([shown(piece.duration, DEGREE) for piece in pieces], room)
        later = (
            [place_in_cycle(at + span * k / self.parts, TURN, near) for at, span in zip(first, spans, strict=True)]
            for k in range(1, self.parts)
        )
        return [first, *later]

    @cached_property
    def angles(self) -> Array:
        """The points: begin and end of the turn, and between them all cuts in their order."""
        cuts = sorted(at for end in range(len(self.rows)) for column in self.cuts(end) for at in column)
        return np.array([0.0, *np.maximum(cuts, 0.0), TURN])

    def positions(self, angles: Array) -> list[Array]:
        """Return the position of each axis at angles, in its own unit."""
        return [shown(row.axis.at(si(angles, DEGREE)).y, row.axis.unit) for row in self.rows]

    def gaps(self, angles: Array) -> Array:
        """Return the gap at angles."""
        first, second = self.positions(angles)
        first = self.table.position(first) if self.table else first
        return np.asarray(self.given.offset + self.factors[0] * first + self.factors[1] * second)

    @cached_property
    def velocities(self) -> list[Array]:
        """The geometric velocity of each axis at each point (m or rad per rad)."""
        return [row.axis.at(si(self.angles, DEGREE)).y1 for row in self.rows]

    @property
    def slopes(self) -> Array:
        """The slope of the gap at each point (per rad)."""
        by = self.table.slope(self.positions(self.angles)[0]) if self.table else 1.0
        return self.scales[0] * by * self.velocities[0] + self.scales[1] * self.velocities[1]

    @cached_property
    def lowest(self) -> Lowest:
        """The parabola through each point and the point before, with the slope there."""
        angles, gaps, slopes = self.angles, self.gaps(self.angles), self.slopes
        steps, rise = np.diff(angles, prepend=angles[0]), np.diff(gaps, prepend=gaps[0])
        fall = np.concatenate([[0.0], slopes[:-1] * si(steps[1:], DEGREE)])
        inside = (fall < -FLAT * self.size) & (fall < 2.0 * rise)
        share = np.where(inside, fall / np.where(inside, 2.0 * (fall - rise), 1.0), 1.0)
        low = np.where(inside, gaps - rise + 0.5 * fall * share, gaps)
        return Lowest(fall, share, low, angles - (1.0 - share) * steps)

    def first_lowest(self, gaps: Array) -> int:
        """Return the number, from 0, of the first gap that is as low as any, but for rounding."""
        return int((gaps <= gaps.min() + ZERO * self.size).argmax())

    @cached_property
    def lowest_rows(self) -> list[int]:
        """The numbers, from 0, of the first of the lowest points, and of the first with the lowest parabola."""
        return [self.first_lowest(gaps) for gaps in (self.gaps(self.angles), self.lowest.gap)]

    @cached_property
    def lowest_at(self) -> Array:
        """The angles of the lowest point, and of the lowest parabola's."""
        point, parabola = self.lowest_rows
        return np.array([self.angles[point], self.lowest.angle[parabola]])

    @property
    def place(self) -> float:
        """The angle of the least gap: of two alike that of the points."""
        return float(self.lowest_at[self.first_lowest(self.gaps(self.lowest_at))])

    @cached_property
    def least(self) -> float:
        """The least gap."""
        return float(self.gaps(self.lowest_at).min())

    @property
    def is_left(self) -> bool:
        """Whether the gap that is asked for is left, but for rounding."""
        return self.least >= self.given.least - ZERO * self.size
