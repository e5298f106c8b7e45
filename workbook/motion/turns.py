"""Extremes of a movement between prescribed ends, in cells: the zeros of its derivatives, each within known brackets.

A polynomial has at most one zero between two neighbouring zeros of its derivative: the ladder from the highest
derivative down finds all. A piece of a pulse has a velocity that only rises or only falls.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property, partial
from itertools import pairwise
from math import isfinite, perm
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.laws.piece_extremes import NODES, WEIGHTS
from engine.motion import Motion, Phase
from engine.motion.handover import PULSES, Handover
from engine.motion.pieces import MotionPiece
from engine.motion.turning import GRID, LOST, PARTS, Ladder, Narrowed, square_of, turn_of
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.rows import filled, spread
from workbook.motion.cells import PieceRows
from workbook.motion.sampled import in_piece

MOST = 7  # pieces of a law of two pulses
STEPS = ("p", "q", "r")
PLACES = ("t1", "t2", "t3")
WORDS = ("position", "velocity", "acceleration", "jerk")
MOST_ORDER = len(WORDS) - 1


def grids(sheet: Sheet) -> None:
    """Declare what brackets are divided by, and the points of Gauss's rule."""
    sheet.table(
        "grid", "Parts of a bracket", PARTS,
        constant("at", "share", "", "", GRID.tolist()),
    )  # fmt: skip
    sheet.table(
        "gauss", "Gauss–Legendre rule on −1 … 1", len(NODES),
        constant("x", "place", "", "", NODES.tolist()), constant("w", "weight", "", "", WEIGHTS.tolist()),
    )  # fmt: skip


def narrowing(
    names: tuple[str, ...], sign: str, bracket: tuple[str, str], f: Callable[[str], str], lost: str,
    found: list[Narrowed], unit: str, scale: float,
) -> list[Quantity]:  # fmt: skip
    """Return the columns that find where a function of a bracket loses its sign: the sign, and round by round."""
    low, high = bracket
    first = f(low)
    columns = [
        calc(sign, "sign it begins with", "", "", f"=IF(ABS({first})>{lost},SIGN({first}),0)",
             [one.sign for one in found], format="0")
    ]  # fmt: skip
    at, width = low, f"({high}-{low})" if low != "0" else high
    for i, name in enumerate(names):
        parts, half = "1" + "00" * i, "+0.5" if i == len(names) - 1 else ""
        step = width if i == 0 else f"{width}/{parts}"
        kept = f"MIN({PARTS - 1},SUMPRODUCT(([{sign}]*{f(f'({at}+{step}*[grid.at])')}>{lost})*1))"
        start = "" if at == "0" else f"{at}+"
        columns.append(
            calc(name, "where it is lost" if half else f"not before, round {i + 1}", "", unit,
                 f"={start}{width}*({kept}{half})/{parts}00", [one.places[i] for one in found], scale=scale)
        )  # fmt: skip
        at = f"[{name}]"
    return columns


def both(piece: MotionPiece) -> Array:
    """Return u at the begin and at the end of a piece."""
    return np.array([0.0, piece.duration])


class Turns:
    """The extremes of a motion's phases between prescribed ends."""

    def __init__(
        self, rows: PieceRows, motion: Motion, handed: tuple[Handover, ...], places: Sequence[int]
    ) -> None:  # fmt: skip
        self.rows, self.motion, self.handed, self.places = rows, motion, handed, places
        self.in_row = {place: k for k, place in enumerate(places)}
        none = Ladder((0.0,) * rows.powers)
        self.ladders = self.spread([Ladder(one.powers[: rows.powers]) for one in handed], none)

    def spread(self, values: Sequence[Any], spare: Any = 0.0) -> list[Any]:
        """Return values of the phases in their rows."""
        return spread(values, self.places, len(self.rows.firsts), spare)

    @property
    def degree(self) -> int:
        """The highest power of a polynomial."""
        return self.rows.powers - 1

    def value(self, order: int, u: str) -> str:
        """Return the formula of a derivative (0 is y) of a polynomial between prescribed ends, per unit of ξ."""
        text = ""
        for n in range(self.degree, max(order, 1) - 1, -1):
            share = perm(n, order)
            scaled = f"[e{n}]" if share == 1 else f"{share}*[e{n}]"
            text = f"{scaled}+{u}*({text})" if text else scaled
        return f"{u}*({text})" if order == 0 else f"({text})"

    def columns(self) -> list[Quantity]:
        """Return the columns of zeros and extremes, phase by phase."""
        powers = "+".join(f"ABS([e{n}])" for n in range(1, self.rows.powers))
        found = [calc("lost", "has no sign below", "", self.rows.at.y, f"={LOST:.0E}*({powers})",
                      [one.lost for one in self.ladders], scale=self.motion.size(0), format="0E+00")]  # fmt: skip
        edges = ["0", "1"]
        for order in range(self.degree - 1, 0, -1):
            for i, bracket in enumerate(pairwise(edges)):
                names = tuple(f"{step}{order}_{i}" for step in STEPS)
                found += narrowing(
                    names, f"s{order}_{i}", bracket, partial(self.value, order), "[lost]",
                    [one.zeros[order][i] for one in self.ladders], "", 1.0,
                )  # fmt: skip
            edges = ["0", *(f"[r{order}_{i}]" for i in range(self.degree - order)), "1"]
            if order <= MOST_ORDER + 1:
                found += self.tops(order - 1)
        return [*found, *self.extremes()]

    def tops(self, order: int) -> list[Quantity]:
        """Return the columns of a derivative where the next one is lost."""
        return [
            calc(f"t{order}_{i}", f"extreme {i + 1} of {WORDS[order]}", "", self.rows.at.y,
                 f"={self.value(order, f'[r{order + 1}_{i}]')}", [one.tops(order)[i] for one in self.ladders],
                 scale=self.motion.size(0))
            for i in range(self.degree - order - 1)
        ]  # fmt: skip

    def of(self, figure: Callable[[Handover], float]) -> list[Any]:
        """Return a figure of each phase with prescribed ends; 0 of all else."""
        return self.spread([figure(one) if one.ended else 0.0 for one in self.handed])

    def extremes(self) -> list[Quantity]:
        """Return the columns of the extremes of each phase with prescribed ends."""
        at = self.rows.at
        pieces, law = at.pieces, f"INDEX({{0}},INDEX([{at.phases}.no],[k]))"
        size = self.motion.size

        def tops(order: int) -> str:
            inner = [f"[t{order}_{i}]" for i in range(self.degree - order - 1)]
            return ",".join(f"ABS({one})" for one in [*inner, self.value(order, "1"), self.value(order, "0")])

        def each(column: str) -> str:
            before = f"INDEX([{at.phases}.before],[k])"
            count = f"INDEX([{at.phases}.pieces],[k])"
            return ",".join(f"INDEX([{pieces}.{column}],{before}+MIN({n},{count}))" for n in range(1, MOST + 1))

        jumps = (
            f"SUMPRODUCT(([{pieces}.p]=[k])*[{pieces}.leap])+IF(ABS(INDEX([{at.phases}.a1],[k]))>check_zero*[amax],1,0)"
        )
        inner = ",".join(f"[t0_{i}]" for i in range(self.degree - 1))
        start = f"INDEX([{at.phases}.y0],[k])"
        both = list(zip(self.handed, self.motion.reaches, strict=True))
        lows, highs = (self.spread([reach[i] if one.ended else 0.0 for one, reach in both]) for i in (0, 1))
        return [
            calc("top", "velocity between its pulses", "V", at.unit(1),
                 "=IF([mode]=1,[w0]+[h0]*INDEX(piece_v,[split])/[span],0)", self.of(lambda one: one.reversing),
                 scale=size(1)),
            calc("vmax", "greatest velocity", "", at.unit(1),
                 f"=IF([mode]=0,0,IF([mode]=1,MAX(ABS([w0]),ABS([top]),ABS([w1])),MAX({tops(1)})/[span]))",
                 self.of(lambda one: one.phase.y1_max), scale=size(1)),
            calc("amax", "greatest acceleration", "", at.unit(2),
                 (f"=IF([mode]=0,0,IF([mode]=1,MAX(ABS([h0])*{law.format('law_ca_max')},"
                  f"0-ABS([h1])*{law.format('law_ca_min')}),MAX({tops(2)}))/[span]^2)"),
                 self.of(lambda one: one.phase.y2_max), scale=size(2)),
            calc("jumps", "jumps of its acceleration", "", "", f"=IF([mode]=1,{jumps},0)", self._jumps(), format="0"),
            calc("jmax", "greatest jerk", "", at.unit(3),
                 f'=IF([mode]=0,0,IF([mode]>1,MAX({tops(3)})/[span]^3,IF([jumps]>0,"∞",MAX({each("jerk")}))))',
                 [value if isfinite(value) else "∞" for value in self.of(lambda one: one.phase.y3_max)], scale=size(3)),
            calc("rms", "RMS acceleration", "", at.unit(2),
                 f"=IF([mode]=0,0,SQRT(SUMPRODUCT(([{pieces}.p]=[k])*[{pieces}.square])/[span]))",
                 self.of(lambda one: one.phase.y2_rms), scale=size(2), source="√(∫y''² dx/δ)"),
            *(calc(name, f"{word} position", "", at.y,
                   f"=IF([mode]=0,0,IF([mode]=1,{end}({start},{start}+[h],{each('turn')}),"
                   f"{start}+{end}(0,[h],{inner})))", values, scale=size(0))
              for name, word, end, values in (("low", "lowest", "MIN", lows), ("high", "highest", "MAX", highs))),
        ]  # fmt: skip

    def _jumps(self) -> list[int]:
        """Return how often y'' jumps at the pieces of each phase of two pulses, and at its end."""
        found = self.spread([0] * len(self.handed), 0)
        for piece, leap in zip(self.rows.pieces, self.leaps, strict=True):
            found[piece.phase] += leap
        for place, one, at in zip(self.places, self.handed, self.motion.ends, strict=True):
            ends = abs(at.end.y2) > LOST * one.phase.y2_max
            found[place] = found[place] + ends if one.mode == PULSES else 0
        return found

    def phase_of(self, piece: MotionPiece) -> Phase:
        """Return the phase of a piece."""
        return self.motion.phases[self.in_row[piece.phase]]

    @cached_property
    def earlier(self) -> list[float]:
        """What y'' is before each piece that lasts, in its phase; 0 of the first."""
        before, found = [0.0] * len(self.rows.firsts), []
        for piece in self.rows.pieces:
            lasts = piece.duration > 0.0
            found.append(before[piece.phase] if lasts else 0.0)
            before[piece.phase] = piece.at(both(piece)).y2.tolist()[1] if lasts else before[piece.phase]
        return found

    @cached_property
    def leaps(self) -> list[int]:
        """Whether y'' jumps at the begin of each piece from what is before it in its phase, or from 0."""
        found = []
        for piece, before in zip(self.rows.pieces, self.earlier, strict=True):
            jump = abs(piece.at(both(piece)).y2.tolist()[0] - before)
            found.append(int(piece.duration > 0.0 and jump > LOST * self.phase_of(piece).y2_max))
        return found

    def of_pieces(self, room: int) -> list[Quantity]:
        """Return the columns of the pieces' table: what a piece adds to the extremes of its phase."""
        at, pieces = self.rows.at, self.rows.pieces

        def of(values: list[Any]) -> list[Any]:
            return filled(values, room, 0.0)

        peaks = [self.phase_of(piece) for piece in pieces]
        lost = [LOST * phase.y1_max for phase in peaks]
        turns = [turn_of(piece, least) for piece, least in zip(pieces, lost, strict=True)]
        jerks = [float(np.abs(piece.at(both(piece)).y3).max()) if piece.duration else 0.0 for piece in pieces]
        rest = [turns[-1]._replace(at=Narrowed(turns[-1].at.sign, (0.0,) * len(PLACES)))] * (room - len(pieces))
        last = float(pieces[-1].at(np.zeros(1)).y[0])
        squares = [square_of(piece) for piece in pieces]
        u = "([d]*(1+[gauss.x])/2)"
        joints = at.pieces.replace("_pieces", "_joints")
        first = f"OR(INDEX([{joints}.n],[r])=1,INDEX([{joints}.from],[r])<>[p])"
        return [
            calc("before", "y'' before it in its phase", "", at.unit(2),
                 f"=IF({first},0,INDEX([{joints}.a1],MAX([r]-1,1)))", of(self.earlier), scale=self.motion.size(2),
                 source="0 of the first"),
            calc("leap", "y'' jumps within its phase", "", "",
                 f"=IF([d]>0,IF(ABS(INDEX([{joints}.a0],[r])-[before])>"
                 f"check_zero*INDEX([{at.phases}.{at.peaks[1]}],[p]),1,0),0)", of(self.leaps), format="0",
                 source="or begins with one"),
            calc("jerk", "greater jerk of its ends", "", at.unit(3),
                 (f"=IF([d]>0,MAX(ABS({in_piece(self.rows, 3, '')}),"
                  f"ABS({in_piece(self.rows, 3, '[d]')})),0)"), of(jerks), scale=self.motion.size(3)),
            calc("square", "∫y''² dx", "", "",
                 f"=[d]/2*SUMPRODUCT([gauss.w],{in_piece(self.rows, 2, u)}^2)", of(squares),
                 scale=max(squares) or 1.0, source="Gauss's rule"),
            *narrowing(
                PLACES, "sign", ("0", "[d]"), lambda u: in_piece(self.rows, 1, u if u != "0" else ""),
                f"check_zero*INDEX([{at.phases}.{at.peaks[0]}],[p])", [turn.at for turn in (*turns, *rest)], at.x,
                self.rows.end,
            ),
            calc("turn", "position where it turns", "", at.y, f"={in_piece(self.rows, 0, f'[{PLACES[-1]}]')}",
                 filled([turn.y for turn in turns], room, last), scale=self.motion.size(0), source="if it does"),
        ]  # fmt: skip
