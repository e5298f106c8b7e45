"""What a step between prescribed ends comes to, in cells: the extremes of polynomials and positions at points.

Velocity and acceleration of a law of two pulses are exact by the heights of its pulses, its jerk by its pieces' ends.
"""

from collections.abc import Callable
from math import isfinite
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.laws.piece_extremes import NODES, WEIGHTS
from engine.motion import Phase
from engine.motion.handover import PULSES, Handover
from engine.motion.pieces import MotionPiece
from engine.motion.shifted import LOST
from workbook.book.declare import Book, Quantity, Sheet, calc, constant
from workbook.book.rows import filled
from workbook.machines.machine.boundary.carried import horner
from workbook.machines.machine.boundary.handing import Handing
from workbook.machines.machine.motion.extremes import POINTS, at_points

ACCELERATION = "2*[c2]+6*[c3]*{0}-[A]*[om]^2*SIN([om]*{0}+[ph])"
JERK = "ABS(6*[c3]-[A]*[om]^3*COS([om]*{0}+[ph]))"
POSITION = "{0}*([c1]+{0}*([c2]+{0}*[c3]))+[A]*SIN([om]*{0}+[ph])"
"""of a piece of a pulse, whose acceleration is a straight line and a sine"""


def points(book: Book, sheet: Sheet) -> None:
    """Declare the points that pieces and polynomials are looked at, and those of Gauss's rule."""
    sheet.table(
        "piece_points", "Points of a polynomial or a piece, as shares of its duration", len(POINTS),
        constant("xi", "share", "ξ", "", POINTS.tolist()),
    )  # fmt: skip
    sheet.table(
        "gauss", "Gauss–Legendre rule on 0 … 1", len(NODES),
        constant("xi", "share", "ξ", "", (0.5 * (NODES + 1.0)).tolist()),
        constant("w", "weight", "", "", (0.5 * WEIGHTS).tolist()),
    )  # fmt: skip
    book.name("piece_points", xi="xi")
    book.name("gauss", xi_g="xi", w_g="w")


def ended(one: Handing, figure: Callable[[Handover], float]) -> list[Any]:
    """Return a figure of each step with prescribed ends; 0 of all else."""
    return one.of(lambda step: figure(step) if step.ended else 0.0)


def inside(one: Handing) -> list[Quantity]:
    """Return the columns of the extremes of polynomials per unit of ξ, and the greatest velocity of two pulses."""
    y, size, powers = one.rows.at.y, one.motion.size(0), one.rows.powers

    def polynomial(figure: Callable[[Phase, float], float]) -> list[Any]:
        return one.of(
            lambda step: figure(step.phase, step.phase.duration) if step.ended and step.mode != PULSES else 0.0
        )

    def low_high(end: int) -> list[Any]:
        return one.spread([
            reach[end] - at.begin.y if step.ended and step.mode != PULSES else 0.0
            for step, reach, at in zip(one.handed, one.motion.reaches, one.motion.ends, strict=True)
        ])  # fmt: skip

    def most(order: int) -> str:
        return f"SUMPRODUCT(MAX(({horner(powers, order, 'xi')})^2))^0.5"

    place = horner(powers, 0, "xi")
    velocity = one.of(lambda step: abs(step.reversing) * step.phase.duration if step.mode == PULSES else
                      step.phase.y1_max * step.phase.duration if step.ended else 0.0)  # fmt: skip
    return [
        calc("pv", "greatest velocity within", "|dy/dξ|", y,
             f"=IF([mode]=1,ABS([d0]*[span]+[h0]*INDEX(piece_v,[split])),{most(1)})", velocity, scale=size,
             source="between two pulses, or of the polynomial at points"),
        calc("pa", "greatest acceleration of the polynomial", "|d²y/dξ²|", y, f"={most(2)}",
             polynomial(lambda phase, d: phase.y2_max * d**2), scale=size, source="at points"),
        calc("pj", "greatest jerk of the polynomial", "|d³y/dξ³|", y, f"={most(3)}",
             polynomial(lambda phase, d: phase.y3_max * d**3), scale=size, source="at points"),
        calc("pr", "mean square of its acceleration", "", "", f"=SUMPRODUCT(w_g,({horner(powers, 2, 'xi_g')})^2)",
             polynomial(lambda phase, d: (phase.y2_rms * d**2) ** 2), scale=size**2, source="∫(d²y/dξ²)² dξ"),
        calc("plow", "its lowest position", "", y, f"=SUMPRODUCT(MIN({place}))", low_high(0), scale=size,
             source="from its begin, at points"),
        calc("phigh", "its highest position", "", y, f"=SUMPRODUCT(MAX({place}))", low_high(1), scale=size,
             source="from its begin, at points"),
    ]  # fmt: skip


def peaks(one: Handing) -> list[Quantity]:
    """Return the columns of the greatest velocity, acceleration and jerk, and the RMS acceleration."""
    at, size = one.rows.at, one.motion.size
    law, rate = f"INDEX({{0}},INDEX([{at.phases}.no],[k]))", f"INDEX([{at.phases}.rate],[k])"
    own = f"([{at.pieces}.p]=[k])*[{at.pieces}.{{0}}]"
    jump = f"IF(ABS(INDEX([{one.kinds}.a1],[k]))>check_zero*[amax],1,0)"
    return [
        calc("vmax", "greatest velocity", "", at.unit(1), f"=IF([mode]=0,0,MAX(ABS([d0]),ABS([d1]),[pv]*{rate}))",
             ended(one, lambda step: step.phase.y1_max), scale=size(1)),
        calc("amax", "greatest acceleration", "", at.unit(2),
             f"=IF([mode]=1,MAX(ABS([h0])*{law.format('law_ca_max')},0-ABS([h1])*{law.format('law_ca_min')}),[pa])"
             f"*{rate}^2", ended(one, lambda step: step.phase.y2_max), scale=size(2)),
        calc("jumps", "jumps of its acceleration", "", "",
             f"=IF([mode]=1,SUMPRODUCT({own.format('leap')})+{jump},0)", jumps(one), format="0"),
        calc("jmax", "greatest jerk", "", at.unit(3),
             f'=IF([mode]=1,IF([jumps]>0,"∞",SUMPRODUCT(MAX({own.format("jerk")}))),[pj]*{rate}^3)',
             [value if isfinite(value) else "∞" for value in ended(one, lambda step: step.phase.y3_max)],
             scale=size(3)),
        calc("rms", "RMS acceleration", "", at.unit(2),
             f"=IF([mode]=1,SQRT(SUMPRODUCT({own.format('square')})*{rate}),SQRT([pr])*{rate}^2)",
             ended(one, lambda step: step.phase.y2_rms), scale=size(2), source="√(∫y''² dx/δ)"),
    ]  # fmt: skip


def reach(one: Handing) -> list[Quantity]:
    """Return the columns of the lowest and highest position."""
    at = one.rows.at
    both = list(zip(one.handed, one.motion.reaches, strict=True))
    return [
        calc(name, f"{word} position", "", at.y,
             f"=IF([mode]=0,0,INDEX([{at.phases}.y0],[k])+{end}([p{name}],"
             f"SUMPRODUCT({end}(([{at.pieces}.p]=[k])*[{at.pieces}.{name}]))))",
             one.spread([found[i] if step.ended else 0.0 for step, found in both]), scale=one.motion.size(0))
        for i, (name, word, end) in enumerate((("low", "lowest", "MIN"), ("high", "highest", "MAX")))
    ]  # fmt: skip


def both_ends(piece: MotionPiece) -> Array:
    """Return u at the begin and at the end of a piece."""
    return np.array([0.0, piece.duration])


def leaps(one: Handing) -> tuple[list[float], list[int]]:
    """Return what y'' is before each piece that lasts, in its phase (0 of the first), and whether it jumps there."""
    before, earlier, found = [0.0] * one.room, [], []
    for piece in one.rows.pieces:
        lasts, (first, last) = piece.duration > 0.0, piece.at(both_ends(piece)).y2.tolist()
        earlier.append(before[piece.phase] if lasts else 0.0)
        found.append(int(lasts and abs(first - earlier[-1]) > LOST * one.step_of(piece).phase.y2_max))
        before[piece.phase] = last if lasts else before[piece.phase]
    return earlier, found


def jumps(one: Handing) -> list[int]:
    """Return how often y'' jumps at the pieces of each step of two pulses, and at its end."""
    found = [0] * one.room
    for piece, leap in zip(one.rows.pieces, leaps(one)[1], strict=True):
        found[piece.phase] += leap
    for place, step, at in zip(one.axis.places, one.handed, one.motion.ends, strict=True):
        last = abs(at.end.y2) > LOST * step.phase.y2_max
        found[place] = found[place] + last if step.mode == PULSES else 0
    return found


def in_pieces(one: Handing, room: int) -> list[Quantity]:
    """Return the columns of the pieces' table: what pieces of laws of two pulses add to the extremes of their steps."""
    at, size = one.rows.at, one.motion.size
    joints = at.pieces.replace("_pieces", "_joints")
    first = f"OR(INDEX([{joints}.n],[r])=1,INDEX([{joints}.from],[r])<>[p])"
    pulses = f"=IF([d]*({at.of_end('mode')}={PULSES})>0,{{0}},0)"
    jerk = f"MAX({JERK.format('0')},{JERK.format('[d]')})"
    earlier, jumping = leaps(one)

    def of(figure: Callable[[MotionPiece], float]) -> list[float]:
        both = ((piece, one.step_of(piece)) for piece in one.rows.pieces)
        return filled((figure(piece) if step.mode == PULSES and piece.duration else 0.0 for piece, step in both), room)

    def begin(piece: MotionPiece) -> float:
        return one.motion.ends[one.in_row[piece.phase]].begin.y

    lows = of(lambda piece: float(at_points(piece, 0).min()) - begin(piece))
    highs = of(lambda piece: float(at_points(piece, 0).max()) - begin(piece))
    squares = of(lambda piece: mean_square(piece) * piece.duration)
    return [
        calc("before", "y'' before it in its phase", "", at.unit(2),
             f"=IF({first},0,INDEX([{joints}.a1],MAX([r]-1,1)))", filled(earlier, room), scale=size(2),
             source="0 of the first"),
        calc("leap", "y'' jumps within its phase", "", "",
             f"=IF([d]>0,IF(ABS(INDEX([{joints}.a0],[r])-[before])>"
             f"check_zero*INDEX([{at.phases}.{at.peaks[1]}],[p]),1,0),0)", filled(jumping, room), format="0",
             source="or begins with one"),
        calc("jerk", "greater jerk of its ends", "", at.unit(3), pulses.format(jerk),
             of(lambda piece: float(np.abs(piece.at(both_ends(piece)).y3).max())), scale=size(3),
             source="of two pulses"),
        calc("square", "∫y''² dx", "", "",
             pulses.format(f"[d]*SUMPRODUCT(w_g,({ACCELERATION.format('[d]*xi_g')})^2)"), squares,
             scale=max(squares) or 1.0, source="Gauss's rule"),
        *(calc(name, f"{word} position", "", at.y,
               pulses.format(f"[c0]-{at.of_phase('y0')}+SUMPRODUCT({end}({POSITION.format('[d]*xi')}))"), values,
               scale=size(0), source="from the begin of its phase, at points")
          for name, word, end, values in (("low", "lowest", "MIN", lows), ("high", "highest", "MAX", highs))),
    ]  # fmt: skip


def mean_square(piece: MotionPiece) -> float:
    """Return the mean of y''² over a piece, by Gauss's rule."""
    u = piece.duration * (NODES + 1.0) / 2.0
    return float(WEIGHTS @ piece.derivative(2, u) ** 2) / 2.0
