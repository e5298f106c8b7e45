"""How the law of each step is carried out between its ends, in cells, by VDI 2143, and the extremes that it comes to.

Of polynomials, and of positions, these are at points. Velocity and acceleration of a law of two pulses are exact by the
heights of its pulses, its jerk by its pieces' ends.
"""

from collections.abc import Callable
from functools import partial
from math import fsum, isfinite, perm
from typing import Any

import numpy as np

from engine.laws.ends import BoundaryValues
from engine.laws.extremes import NODES, WEIGHTS
from engine.motion import Phase
from engine.motion.handover import PULSES, Handover
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.book.summary import ZERO
from workbook.machines.machine.boundary.handover import CARRIED, AxisHandover
from workbook.machines.machine.extremes import POINTS, at_points

HERMITE = {
    2: {5: "[f0]/2", 7: "[f0]/2", 3: "3*[h]-2*[e1]-[f1]"},
    3: {3: "[e1]+[f1]-2*[h]", 5: "10*[h]-6*[e1]-4*[f1]+([g1]-3*[f0])/2"},
    4: {5: "8*[e1]+7*[f1]-15*[h]+(3*[f0]-2*[g1])/2", 7: "35*[w]-15*[x]+5*[z]/2"},
    5: {5: "6*[h]-3*([e1]+[f1])+([g1]-[f0])/2", 7: "39*[x]-84*[w]-7*[z]"},
    6: {7: "70*[w]-34*[x]+13*[z]/2"},
    7: {7: "10*[x]-20*[w]-2*[z]"},
}
"""e_n by the degree, from stroke, v δ and a δ² at both ends; w, x and z are what the begin leaves to be done"""
SEPTIC, AT_ENDS = 7, "Σ n (n − 1) e_n ξⁿ⁻²"
LEFT: tuple[tuple[str, str, str, Callable[[BoundaryValues], float]], ...] = (
    ("w", "lift that the begin leaves", "[h]-[e1]-[f0]/2", lambda at: at.stroke - at.v0 - at.a0 / 2.0),
    ("x", "velocity that it leaves", "[f1]-[e1]-[f0]", lambda at: at.v1 - at.v0 - at.a0),
    ("z", "acceleration that it leaves", "[g1]-[f0]", lambda at: at.a1 - at.a0),
)
"""of a polynomial of degree 7: what its ends ask for that its first terms do not give"""
WORDS = "begin", "end"
ACCELERATION = "2*[c2]+6*[c3]*{0}-[A]*[om]^2*SIN([om]*{0}+[ph])"
JERK = "ABS(6*[c3]-[A]*[om]^3*COS([om]*{0}+[ph]))"
POSITION = "{0}*([c1]+{0}*([c2]+{0}*[c3]))+[A]*SIN([om]*{0}+[ph])"
"""of a piece of a pulse, whose acceleration is a straight line and a sine"""


def curves_between_ends(one: AxisHandover) -> list[Quantity]:
    """Return the columns of the halves of a law of two pulses, and of a polynomial Σ e_n ξⁿ, between their ends."""
    row, *phase = one.steps()
    mode = one.number("mode", "is carried out", f"=INDEX([{one.required}.mode],[k])", lambda step: step.mode, CARRIED)
    phases, (xi, s, v) = one.rows.at.phases, (f"INDEX(piece_{name},[split])" for name in ("xi", "s", "v"))
    early, added = one.of(lambda step: step.early, 0), f"=IF([mode]=0,0,INDEX([{one.required}.w{{}}],[k]))"
    own, powers = partial(one.rate, 0), one.rows.powers
    at_end = f"=IF([mode]>1,INDEX([{one.required}.q{{}}],[k])*[span]^2,0)"
    return [
        row, mode, *phase,
        one.rate(1, "d0", "velocity added in its first half", "", added.format(0), lambda step: step.drifts[0]),
        one.rate(1, "d1", "velocity added in its second half", "", added.format(1), lambda step: step.drifts[1]),
        one.number("split", "row of its second pulse",
                   f"=INDEX([{phases}.first],[k])+IF([mode]=1,INDEX(law_early,INDEX([{phases}.no],[k])),0)",
                   [first + more for first, more in zip(one.rows.firsts, early, strict=True)],
                   "on Laws; of all else its first piece"),
        own("gain", "velocity gained, as a lift", "", f"=IF([mode]=1,([d1]-[d0])*[span]/{v},0)",
            lambda step: step.halves[0] - step.halves[1], "(v1 − v0) δ/C_v"),
        own("h1", "lift of its second half", "h_b",
            f"=IF([mode]=1,[h]-[span]*([d0]*{xi}+[d1]*(1-{xi}))-{s}*[gain],IF([mode]=0,[h],0))",
            lambda step: step.halves[1], "h − (v0 λ + v1 (1 − λ)) δ − s(λ) (v1 − v0) δ/C_v"),
        own("h0", "lift of its first half", "h_a", "=[h1]+[gain]", lambda step: step.halves[0]),
        own("e1", "first power", "e1", "=IF([mode]>1,[d0]*[span],0)", lambda step: step.powers[1], "v0 δ"),
        own("f1", "velocity at its end", "v1 δ", "=IF([mode]>1,[d1]*[span],0)", lambda step: step.hermite.v1),
        own("f0", "acceleration at its begin", "a0 δ²", at_end.format(0), lambda step: step.hermite.a0),
        own("g1", "acceleration at its end", "a1 δ²", at_end.format(1), lambda step: step.hermite.a1),
        *(own(name, label, "", f"=IF([mode]=7,{formula},0)",
              one.spread([left(step.hermite) if step.mode == SEPTIC else 0.0 for step in one.handed]))
          for name, label, formula, left in LEFT if powers > SEPTIC),
        *(own(f"e{n}", f"power {n}", f"e{n}", hermite(n, powers), one.spread([step.powers[n] for step in one.handed]))
          for n in range(2, powers)),
        own("b0", "its acceleration at its begin", "", "=2*[e2]", lambda step: 2.0 * step.powers[2], AT_ENDS),
        own("b1", "its acceleration at its end", "", "=" + "+".join(f"{perm(n, 2)}*[e{n}]" for n in range(2, powers)),
            lambda step: fsum(perm(n, 2) * e for n, e in enumerate(step.powers)), AT_ENDS),
    ]  # fmt: skip


def hermite(n: int, powers: int) -> str:
    """Return the formula of a coefficient, by the degree of the polynomial."""
    text = "0"
    for degree, formula in HERMITE[n].items():
        if degree < powers:
            text = f"IF([mode]={degree},{formula},{text})"
    return f"={text}"


def horner(powers: int, order: int, xi: str) -> str:
    """Return the formula of a derivative (order 0 is y) of Σ e_n ξⁿ, per unit of ξ."""
    text = ""
    for n in range(powers - 1, max(order, 1) - 1, -1):
        share = perm(n, order)
        scaled = f"[e{n}]" if share == 1 else f"{share}*[e{n}]"
        inner = f"({text})" if "*" in text or "+" in text else text
        text = f"{scaled}+{xi}*{inner}" if text else scaled
    return text if order else f"{xi}*({text})"


def end_kinds(one: AxisHandover) -> list[Quantity]:
    """Return the columns of rates at both ends, and of their kinds: of what is settled there, else of the law's."""
    at = one.rows.at
    no, rate, *peaks = (f"INDEX([{at.phases}.{name}],[k])" for name in ("no", "rate", "y1", "y2"))
    end = f"INDEX([{at.ends}.{{}}],[k])".format

    def at_end(i: int, order: int) -> list[float]:
        return one.spread([(found.begin, found.end)[i][order] for found in one.motion.ends])

    return [
        one.steps()[0],
        one.rate(1, "peak1", "greatest velocity, or 1", "", f"=IF({peaks[0]}>0,{peaks[0]},1)",
                 [value or 1.0 for value in one.of(lambda step: step.phase.y1_max)]),
        one.rate(2, "peak2", "greatest acceleration, or 1", "", f"=IF({peaks[1]}>0,{peaks[1]},1)",
                 [value or 1.0 for value in one.of(lambda step: step.phase.y2_max)]),
        *(one.rate(1, f"v{i}", f"velocity at its {word}", "",
                   f"=INDEX(law_v{i},{no})*{end(f'h{i}')}*{rate}+{end(f'd{i}')}", at_end(i, 1))
          for i, word in enumerate(WORDS)),
        *(one.rate(2, f"a{i}", f"acceleration at its {word}", "",
                   f"=(INDEX(law_a{i},{no})*{end(f'h{i}')}+{end(f'b{i}')})*{rate}^2", at_end(i, 2))
          for i, word in enumerate(WORDS)),
        *(one.number(f"{name}{i}", f"has {what} at its {word}",
                     f"=IF(ABS(IF(INDEX([{one.required}.settled{i}],[k])=1,INDEX([{one.required}.{asked}{i}],[k]),"
                     f"[{law}{i}]))>check_zero*[peak{order}],1,0)",
                     one.spread([int(step.kinds[i] in kinds) for step in one.handed]))
          for i, word in enumerate(WORDS)
          for order, (name, what, law, asked, kinds) in enumerate((("moves", "a velocity", "v", "w", "GB"),
                                                                   ("bends", "an acceleration", "a", "q", "UB")), 1)),
        *(result(f"{word}s", f"kind of its {word}", "", "",
                 f'=IF(INDEX([{at.phases}.span],[k])=0,"",CHOOSE(1+[moves{i}]+2*[bends{i}],"R","G","U","B"))',
                 one.spread([step.kinds[i] for step in one.handed], ""), align="center",
                 source="R rest, G velocity, U reversal, B both")
          for i, word in enumerate(WORDS)),
    ]  # fmt: skip


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


def polynomial_extremes(one: AxisHandover) -> list[Quantity]:
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


def step_extremes(one: AxisHandover) -> list[Quantity]:
    """Return the columns of the greatest velocity, acceleration and jerk, the RMS acceleration, and both positions."""
    at, both = one.rows.at, list(zip(one.handed, one.motion.reaches, strict=True))
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
        *(one.rate(0, name, f"{name}est position", "",
                   f"=IF([mode]=0,0,INDEX([{at.phases}.y0],[k])+{end}([p{name}],"
                   f"SUMPRODUCT({end}({own.format(name)}))))",
                   one.spread([reach[i] if step.ended else 0.0 for step, reach in both]))
          for i, (name, end) in enumerate((("low", "MIN"), ("high", "MAX")))),
    ]  # fmt: skip


def at_ends(piece: MotionPiece, order: int) -> list[float]:
    """Return a derivative at the begin and at the end of a piece."""
    return [float(y) for y in piece.curves[order].at(np.array([0.0, piece.duration]))]


def leaps(one: AxisHandover) -> tuple[list[float], list[int]]:
    """Return y'' at the end of the piece before, within the phase (0 for its first), and whether y'' jumps there."""
    before, earlier, found = [0.0] * one.room, [], []
    for piece in one.rows.pieces:
        lasts, (first, last) = piece.duration > 0.0, at_ends(piece, 2)
        earlier.append(before[piece.phase] if lasts else 0.0)
        found.append(int(lasts and abs(first - earlier[-1]) > ZERO * one.step_of(piece).phase.y2_max))
        if lasts:
            before[piece.phase] = last
    return earlier, found


def jumps(one: AxisHandover) -> list[int]:
    """Return how often y'' jumps at the pieces of each step of two pulses, and at its end."""
    found = [0] * one.room
    for piece, leap in zip(one.rows.pieces, leaps(one)[1], strict=True):
        found[piece.phase] += leap
    for place, step, at in zip(one.axis.places, one.handed, one.motion.ends, strict=True):
        last = abs(at.end.y2) > ZERO * step.phase.y2_max
        found[place] = found[place] + last if step.mode == PULSES else 0
    return found


def pulse_extremes(one: AxisHandover, room: int) -> list[Quantity]:
    """Return the columns of the pieces' table: what pieces of laws of two pulses add to the extremes of their steps."""
    at, joints = one.rows.at, one.rows.at.pieces.replace("_pieces", "_joints")
    first = f"OR(INDEX([{joints}.n],[r])=1,INDEX([{joints}.from],[r])<>[p])"
    pulses = f"=IF([d]*({at.of_end('mode')}={PULSES})>0,{{0}},0)"
    earlier, jumping = leaps(one)

    def of(figure: Callable[[MotionPiece], float]) -> list[float]:
        both = ((piece, one.step_of(piece)) for piece in one.rows.pieces)
        return filled((figure(piece) if step.mode == PULSES and piece.duration else 0.0 for piece, step in both), room)

    def mean_square(piece: MotionPiece) -> float:
        return float(WEIGHTS @ piece.curves[2].at(piece.duration * (NODES + 1.0) / 2.0) ** 2) / 2.0

    lows = of(lambda piece: float(at_points(piece, 0).min()) - one.begin_of(piece))
    highs = of(lambda piece: float(at_points(piece, 0).max()) - one.begin_of(piece))
    squares = of(lambda piece: mean_square(piece) * piece.duration)
    return [
        one.rate(2, "before", "y'' before it in its phase", "", f"=IF({first},0,INDEX([{joints}.a1],MAX([r]-1,1)))",
                 filled(earlier, room), "0 of the first"),
        one.number("leap", "y'' jumps within its phase",
                   f"=IF([d]>0,IF(ABS(INDEX([{joints}.a0],[r])-[before])>"
                   f"check_zero*INDEX([{at.phases}.y2],[p]),1,0),0)", filled(jumping, room),
                   "or begins with one"),
        one.rate(3, "jerk", "greater jerk of its ends", "",
                 pulses.format(f"MAX({JERK.format('0')},{JERK.format('[d]')})"),
                 of(lambda piece: max(map(abs, at_ends(piece, 3)))), "of two pulses"),
        calc("square", "∫y''² dx", "", "", pulses.format(f"[d]*SUMPRODUCT(w_g,({ACCELERATION.format('[d]*xi_g')})^2)"),
             squares, scale=max(squares) or 1.0, source="Gauss's rule"),
        *(one.rate(0, name, f"{name}est position", "",
                   pulses.format(f"[c0]-{at.of_phase('y0')}+SUMPRODUCT({end}({POSITION.format('[d]*xi')}))"), values,
                   "from the begin of its phase, at points")
          for name, end, values in (("low", "MIN", lows), ("high", "MAX", highs))),
    ]  # fmt: skip
