"""What a step between prescribed ends comes to, in cells: the extremes of polynomials and positions at points.

Velocity and acceleration of a law of two pulses are exact by the heights of its pulses, its jerk by its pieces' ends.
"""

from collections.abc import Callable
from math import isfinite
from typing import Any

import numpy as np

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


def inside(one: Handing) -> list[Quantity]:
    """Return the columns of the extremes of polynomials per unit of ξ, and the greatest velocity of two pulses."""
    size, powers = one.motion.size(0), one.rows.powers
    place = horner(powers, 0, "xi")

    def curved(step: Handover) -> bool:
        return step.ended and step.mode != PULSES

    def scaled(figure: Callable[[Phase], float], order: int) -> list[Any]:
        return one.of(lambda step: figure(step.phase) * step.phase.duration**order if curved(step) else 0.0)

    def low_high(end: int) -> list[Any]:
        both = zip(one.handed, one.motion.reaches, one.motion.ends, strict=True)
        return one.spread([reach[end] - at.begin.y if curved(step) else 0.0 for step, reach, at in both])

    def most(order: int) -> str:
        return f"SUMPRODUCT(MAX(({horner(powers, order, 'xi')})^2))^0.5"

    velocity = one.of(lambda step: abs(step.reversing) * step.phase.duration if step.mode == PULSES else
                      step.phase.y1_max * step.phase.duration if step.ended else 0.0)  # fmt: skip
    return [
        one.rate(0, "pv", "greatest velocity within", "|dy/dξ|",
                 f"=IF([mode]=1,ABS([d0]*[span]+[h0]*INDEX(piece_v,[split])),{most(1)})", velocity,
                 "between two pulses, or of the polynomial at points"),
        one.rate(0, "pa", "greatest acceleration of the polynomial", "|d²y/dξ²|", f"={most(2)}",
                 scaled(lambda phase: phase.y2_max, 2), "at points"),
        one.rate(0, "pj", "greatest jerk of the polynomial", "|d³y/dξ³|", f"={most(3)}",
                 scaled(lambda phase: phase.y3_max, 3), "at points"),
        calc("pr", "mean square of its acceleration", "", "", f"=SUMPRODUCT(w_g,({horner(powers, 2, 'xi_g')})^2)",
             scaled(lambda phase: phase.y2_rms**2, 4), scale=size**2, source="∫(d²y/dξ²)² dξ"),
        one.rate(0, "plow", "its lowest position", "", f"=SUMPRODUCT(MIN({place}))", low_high(0),
                 "from its begin, at points"),
        one.rate(0, "phigh", "its highest position", "", f"=SUMPRODUCT(MAX({place}))", low_high(1),
                 "from its begin, at points"),
    ]  # fmt: skip


def peaks(one: Handing) -> list[Quantity]:
    """Return the columns of the greatest velocity, acceleration and jerk, and the RMS acceleration."""
    at = one.rows.at
    law, rate = f"INDEX({{0}},INDEX([{at.phases}.no],[k]))", f"INDEX([{at.phases}.rate],[k])"
    own = f"([{at.pieces}.p]=[k])*[{at.pieces}.{{0}}]"
    jump = f"IF(ABS(INDEX([{one.kinds}.a1],[k]))>check_zero*[amax],1,0)"

    def ended(figure: Callable[[Phase], float]) -> list[Any]:
        return one.of(lambda step: figure(step.phase) if step.ended else 0.0)

    return [
        one.rate(1, "vmax", "greatest velocity", "", f"=IF([mode]=0,0,MAX(ABS([d0]),ABS([d1]),[pv]*{rate}))",
                 ended(lambda phase: phase.y1_max)),
        one.rate(2, "amax", "greatest acceleration", "",
                 f"=IF([mode]=1,MAX(ABS([h0])*{law.format('law_ca_max')},0-ABS([h1])*{law.format('law_ca_min')}),[pa])"
                 f"*{rate}^2", ended(lambda phase: phase.y2_max)),
        one.number("jumps", "jumps of its acceleration", f"=IF([mode]=1,SUMPRODUCT({own.format('leap')})+{jump},0)",
                   jumps(one)),
        one.rate(3, "jmax", "greatest jerk", "",
                 f'=IF([mode]=1,IF([jumps]>0,"∞",SUMPRODUCT(MAX({own.format("jerk")}))),[pj]*{rate}^3)',
                 [value if isfinite(value) else "∞" for value in ended(lambda phase: phase.y3_max)]),
        one.rate(2, "rms", "RMS acceleration", "",
                 f"=IF([mode]=1,SQRT(SUMPRODUCT({own.format('square')})*{rate}),SQRT([pr])*{rate}^2)",
                 ended(lambda phase: phase.y2_rms), "√(∫y''² dx/δ)"),
    ]  # fmt: skip


def reach(one: Handing) -> list[Quantity]:
    """Return the columns of the lowest and highest position."""
    at, both = one.rows.at, list(zip(one.handed, one.motion.reaches, strict=True))
    return [
        one.rate(0, name, f"{name}est position", "",
                 f"=IF([mode]=0,0,INDEX([{at.phases}.y0],[k])+{end}([p{name}],"
                 f"SUMPRODUCT({end}(([{at.pieces}.p]=[k])*[{at.pieces}.{name}]))))",
                 one.spread([found[i] if step.ended else 0.0 for step, found in both]))
        for i, (name, end) in enumerate((("low", "MIN"), ("high", "MAX")))
    ]  # fmt: skip


def at_ends(piece: MotionPiece, order: int) -> list[float]:
    """Return a derivative at the begin and at the end of a piece."""
    return [float(y) for y in piece.derivative(order, np.array([0.0, piece.duration]))]


def leaps(one: Handing) -> tuple[list[float], list[int]]:
    """Return what y'' is before each piece that lasts, in its phase (0 of the first), and whether it jumps there."""
    before, earlier, found = [0.0] * one.room, [], []
    for piece in one.rows.pieces:
        lasts, (first, last) = piece.duration > 0.0, at_ends(piece, 2)
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
    at, joints = one.rows.at, one.rows.at.pieces.replace("_pieces", "_joints")
    first = f"OR(INDEX([{joints}.n],[r])=1,INDEX([{joints}.from],[r])<>[p])"
    pulses = f"=IF([d]*({at.of_end('mode')}={PULSES})>0,{{0}},0)"
    earlier, jumping = leaps(one)

    def of(figure: Callable[[MotionPiece], float]) -> list[float]:
        both = ((piece, one.step_of(piece)) for piece in one.rows.pieces)
        return filled((figure(piece) if step.mode == PULSES and piece.duration else 0.0 for piece, step in both), room)

    def mean_square(piece: MotionPiece) -> float:
        return float(WEIGHTS @ piece.derivative(2, piece.duration * (NODES + 1.0) / 2.0) ** 2) / 2.0

    lows = of(lambda piece: float(at_points(piece, 0).min()) - one.begin_of(piece))
    highs = of(lambda piece: float(at_points(piece, 0).max()) - one.begin_of(piece))
    squares = of(lambda piece: mean_square(piece) * piece.duration)
    return [
        one.rate(2, "before", "y'' before it in its phase", "", f"=IF({first},0,INDEX([{joints}.a1],MAX([r]-1,1)))",
                 filled(earlier, room), "0 of the first"),
        one.number("leap", "y'' jumps within its phase",
                   f"=IF([d]>0,IF(ABS(INDEX([{joints}.a0],[r])-[before])>"
                   f"check_zero*INDEX([{at.phases}.{at.peaks[1]}],[p]),1,0),0)", filled(jumping, room),
                   "or begins with one"),
        one.rate(3, "jerk", "greater jerk of its ends", "",
                 pulses.format(f"MAX({JERK.format('0')},{JERK.format('[d]')})"),
                 of(lambda piece: max(map(abs, at_ends(piece, 3)))), "of two pulses"),
        calc("square", "∫y''² dx", "", "",
             pulses.format(f"[d]*SUMPRODUCT(w_g,({ACCELERATION.format('[d]*xi_g')})^2)"), squares,
             scale=max(squares) or 1.0, source="Gauss's rule"),
        *(one.rate(0, name, f"{name}est position", "",
                   pulses.format(f"[c0]-{at.of_phase('y0')}+SUMPRODUCT({end}({POSITION.format('[d]*xi')}))"), values,
                   "from the begin of its phase, at points")
          for name, end, values in (("low", "MIN", lows), ("high", "MAX", highs))),
    ]  # fmt: skip
