"""Where a motion passes the points of a table, at which the ratio's change jumps: stretches begin there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property, partial
from typing import NamedTuple

import numpy as np

from engine.machine.passing import Passed, close, passed, passing_piece
from engine.mechanisms.linkage import near_end
from engine.mechanisms.table import PositionTable
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Sheet, calc, constant
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.linked.driven import LinkedDriven
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.stretches import FINER
from workbook.motion.sampled import in_piece

INNER = "check_zero/1000*(@high-@low)"


class Pass(NamedTuple):
    """A phase and a point of the table, from 1: whether it passes it, in which piece, and where (°)."""

    phase: int
    point: int
    level: float
    way: float
    here: int
    piece: int
    duration: float
    found: Passed
    angle: float


NOWHERE = Passed((0.0, 0.0, 0.0), 0.0, 0.0, 0.0)


class Passes:
    """All of them, phase by phase; none of a mechanism that is no table."""

    def __init__(self, one: AxisRows, driven: LinkedDriven) -> None:
        self.one, self.driven = one, driven

    @property
    def rows(self) -> int:
        """Rows of their table."""
        return len(self.places) if isinstance(self.driven.linkage, PositionTable) else 0

    @property
    def turns(self) -> int:
        """Rows for how often power may turn round more than without points."""
        return self.one.machine.machine.sizes.positions if self.rows else 0

    @property
    def places(self) -> list[tuple[int, int]]:
        """Phase and point of each row, from 1: all points but the first and the last."""
        sizes = self.one.machine.machine.sizes
        return [(n, j) for n in range(1, sizes.phases + 1) for j in range(2, sizes.positions)]

    @cached_property
    def each(self) -> list[Pass]:
        """The rows."""
        return [self._pass(*place) for place in self.places]

    @property
    def levels(self) -> list[float]:
        """The positions of the points."""
        low, high, *_ = self.driven.linkage.reach
        return [low, *self.driven.linkage.knots, high]

    @property
    def further(self) -> list[tuple[float, str]]:
        """Where a stretch begins, in degrees, each with its formula."""
        return [(one.angle, f"=[@pass.at.{k}]") for k, one in enumerate(self.each, 1)] if self.rows else []

    def _pass(self, phase: int, point: int) -> Pass:
        axis, linkage, moves = self.driven.axis, self.driven.linkage, self.driven.axis.entered
        level = self.levels[point - 1] if point <= len(self.levels) else 0.0
        k = moves[phase - 1] if phase <= len(moves) else -1
        way = float(np.sign(axis.motion.phases[k].lift)) if k >= 0 else 0.0
        (low, high), near = axis.motion.reaches[k], -near_end(linkage)
        here = way != 0.0 and point < len(self.levels) and level - low > near and high - level > near
        pieces = list(self.one.pieces.pieces)
        if not here:
            return Pass(phase, point, level, way, 0, 1, pieces[0].duration, NOWHERE, TURN)
        own = [piece for piece in pieces if piece.phase == axis.places[k]]
        lost = close(linkage.reach.low, linkage.reach.high)
        piece = own[passing_piece(own, level, way, lost)]
        found = passed(piece, level, way, lost)
        angle = shown(piece.begin + found.place, DEGREE)
        return Pass(phase, point, level, way, 1, pieces.index(piece) + 1, piece.duration, found, angle)


def coefficients(one: AxisRows, size: float) -> Iterator[tuple[str, Callable[[MotionPiece], float], float]]:
    """Yield each figure of a piece that y hangs on: its column, what it is, its scale."""
    for n in range(one.pieces.powers):
        yield f"c{n}", partial(of_power, n), one.axis.motion.size(n)
    for k, sine in enumerate(one.pieces.sines):
        for j, (name, scale) in enumerate((("A", size), ("om", 0.0), ("ph", 1.0))):
            yield f"{name}{sine.mark}", partial(of_wave, k, j), scale


def of_power(n: int, piece: MotionPiece) -> float:
    """Return a coefficient of a piece."""
    return piece.c[n]


def of_wave(k: int, j: int, piece: MotionPiece) -> float:
    """Return amplitude, frequency or phase of a sine of a piece."""
    return piece.sines[k][j]


def passing(sheet: Sheet, one: AxisRows, found: Passes) -> None:
    """Declare where each phase passes each point of the table but the first and the last."""
    i, each = found.driven.number, found.each
    pieces = list(one.pieces.pieces)
    t, size, count = f"axis{i}_pieces", found.driven.axis.motion.size(0), f"axis{i}_count"
    begins = f"[{t}.c0]" + "".join(f"+[{t}.A{sine.mark}]*SIN([{t}.ph{sine.mark}]+0)" for sine in one.pieces.sines)
    # +0: IronCalc takes the sine of a bare range for an error
    beyond, near = f"[way]*[level]-{INNER}", "0-@near_end"
    own = f"([{t}.p]=2*[phase])*([{t}.r]<={count})*([way]*({begins})<{beyond})"
    passes = f"[point]<@count,[way]<>0,[level]-INDEX([@reach.low],[phase])>{near}"
    unit = found.driven.axis.base

    def y(place: str) -> str:
        return in_piece(one.pieces, 0, f"({place})")

    def round_of(k: int) -> str:
        at, width = (f"[a{k}]" if k else "0"), f"[d]{FINER[k]}"
        kept = f"MIN(99,SUMPRODUCT(([way]*({y(f'{at}+{width}*[grid.at]')})<{beyond})*1))"
        return f"=IF([here]=0,0,{at}+{width}*{kept}/100)"

    def of(name: str) -> list[float]:
        return [getattr(row, name) for row in each]

    def of_found(name: str) -> list[float]:
        return [getattr(row.found, name) for row in each]

    end = "[a3]+[d]/1000000"
    sheet.table(
        "@pass", "Where phases pass points of the table", found.rows,
        constant("phase", "row", "", "", of("phase")),
        constant("point", "point", "", "", of("point")),
        calc("level", "position", "y", unit, "=INDEX([@cubics.y],[point])", of("level"), scale=size),
        calc("way", "direction", "", "", f"=SIGN(INDEX([axis{i}_steps.h],2*[phase]))", of("way"), format="0"),
        calc("here", "is passed", "", "",
             f"=IF(AND({passes},INDEX([@reach.high],[phase])-[level]>{near}),1,0)", of("here"), format="0"),
        calc("q", "piece", "q", "",
             f"=IF([here]=0,1,INDEX([axis{i}_steps.before],2*[phase])+MAX(1,SUMPRODUCT({own})))", of("piece"),
             format="0"),
        *(calc(name, "of the piece", name, "", f"=INDEX([{t}.{name}],[q])",
               [get(pieces[row.piece - 1]) for row in each], scale=scale)
          for name, get, scale in coefficients(one, size)),
        calc("d", "its duration", "d", "rad", f"=INDEX([{t}.d],[q])", of("duration"), scale=1.0),
        *(calc(f"a{k}", "not before", "u", "rad", round_of(k - 1), [row.found.rounds[k - 1] for row in each],
               scale=1.0)
          for k in range(1, 4)),
        calc("ya", "position there", "", unit, f"=IF([here]=0,0,{y('[a3]')})", of_found("low"), scale=size),
        calc("yb", "a millionth of the piece later", "", unit, f"=IF([here]=0,0,{y(end)})", of_found("high"),
             scale=size),
        calc("u", "passes it at", "u", "rad",
             "=IF([here]=0,0,[a3]+[d]/1000000*([level]-[ya])/([yb]-[ya]))", of_found("place"), scale=1.0,
             source="chord"),
        calc("at", "angle of its phases", "θ", "°",
             f"=IF([here]=0,360,INDEX([{t}.begin],[q])+DEGREES([u]))", of("angle"), scale=360.0, format="0.0##"),
    )  # fmt: skip
