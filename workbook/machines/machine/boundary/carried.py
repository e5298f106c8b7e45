"""How the law of each step is carried out between its ends, in cells, and what it begins and ends with, by VDI 2143."""

from collections.abc import Callable
from functools import partial
from math import perm
from typing import Any

from engine.laws.ends import Ends
from engine.motion.handover import PULSES, Handover
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, result
from workbook.book.rows import filled
from workbook.machines.machine.boundary.handing import CARRIED, Handing

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
LEFT: tuple[tuple[str, str, str, Callable[[Ends], float]], ...] = (
    ("w", "lift that the begin leaves", "[h]-[e1]-[f0]/2", lambda at: at.stroke - at.v0 - at.a0 / 2.0),
    ("x", "velocity that it leaves", "[f1]-[e1]-[f0]", lambda at: at.v1 - at.v0 - at.a0),
    ("z", "acceleration that it leaves", "[g1]-[f0]", lambda at: at.a1 - at.a0),
)
"""of a polynomial of degree 7: what its ends ask for that its first terms do not give"""
WORDS = "begin", "end"


def carried(one: Handing) -> list[Quantity]:
    """Return the columns of halves and polynomials."""
    row, *phase = one.steps()
    mode = one.number("mode", "is carried out", f"=INDEX([{one.asked}.mode],[k])", lambda step: step.mode, CARRIED)
    return [row, mode, *phase, *halves(one), *polynomial(one)]


def halves(one: Handing) -> list[Quantity]:
    """Return the columns of a law of two pulses between its ends."""
    phases, (xi, s, v) = one.rows.at.phases, (f"INDEX(piece_{name},[split])" for name in ("xi", "s", "v"))
    early, added = one.of(lambda step: step.early, 0), f"=IF([mode]=0,0,INDEX([{one.asked}.w{{}}],[k]))"
    return [
        one.rate(1, "d0", "velocity added in its first half", "", added.format(0), lambda step: step.drifts[0]),
        one.rate(1, "d1", "velocity added in its second half", "", added.format(1), lambda step: step.drifts[1]),
        one.number("split", "row of its second pulse",
                   f"=INDEX([{phases}.first],[k])+IF([mode]=1,INDEX(law_early,INDEX([{phases}.no],[k])),0)",
                   [first + more for first, more in zip(one.rows.firsts, early, strict=True)],
                   "on Laws; of all else its first piece"),
        one.rate(0, "gain", "velocity gained, as a lift", "", f"=IF([mode]=1,([d1]-[d0])*[span]/{v},0)",
                 lambda step: step.gain, "(v1 − v0) δ/C_v"),
        one.rate(0, "h1", "lift of its second half", "h_b",
                 f"=IF([mode]=1,[h]-[span]*([d0]*{xi}+[d1]*(1-{xi}))-{s}*[gain],IF([mode]=0,[h],0))",
                 lambda step: step.halves[1], "h − (v0 λ + v1 (1 − λ)) δ − s(λ) (v1 − v0) δ/C_v"),
        one.rate(0, "h0", "lift of its first half", "h_a", "=[h1]+[gain]", lambda step: step.halves[0]),
    ]  # fmt: skip


def polynomial(one: Handing) -> list[Quantity]:
    """Return the columns of a polynomial Σ e_n ξⁿ between its ends."""
    own, powers = partial(one.rate, 0), one.rows.powers
    at_end = f"=IF([mode]>1,INDEX([{one.asked}.q{{}}],[k])*[span]^2,0)"
    return [
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
            lambda step: sum(perm(n, 2) * e for n, e in enumerate(step.powers)), AT_ENDS),
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
        text = f"{scaled}+{xi}*({text})" if "*" in text or "+" in text else f"{scaled}+{xi}*{text}" if text else scaled
    return text if order else f"{xi}*({text})"


def taken(one: Handing, room: int) -> list[Quantity]:
    """Return the columns of the pieces' table that say what a piece takes over."""
    at = one.rows.at

    def of(figure: Callable[[Handover, bool, MotionPiece], Any]) -> list[Any]:
        both = ((piece, one.step_of(piece)) for piece in one.rows.pieces)
        found = [figure(step, step.mode == PULSES and piece.number >= step.early, piece) for piece, step in both]
        return filled(found, room, found[-1])

    def half(column: str) -> str:
        return f"=IF([late]=1,INDEX([{at.ends}.{column}1],[p]),INDEX([{at.ends}.{column}0],[p]))"

    return [
        one.number("late", "in the second half", f"=IF([m]<{at.of_end('split')},0,IF({at.of_end('mode')}=1,1,0))",
                   of(lambda _, late, __: int(late))),
        one.rate(0, "hp", "lift of its half", "h", half("h"), of(lambda step, late, _: step.halves[late])),
        one.rate(1, "drift", "velocity added", "", half("d"), of(lambda step, late, _: step.drifts[late])),
        one.rate(0, "base", "position without the law", "",
                 f"={at.of_phase('y0')}+IF([late]=1,{at.of_phase('h')}-[hp]-[drift]*{at.of_phase('span')},0)",
                 of(lambda step, late, piece: step.base(late, one.begin_of(piece)))),
    ]  # fmt: skip


def kinds(one: Handing) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and of the kinds of both."""
    at = one.rows.at
    no, rate, *peaks = (f"INDEX([{at.phases}.{name}],[k])" for name in ("no", "rate", *at.peaks))
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
        *settled(one),
        *(result(f"{word}s", f"kind of its {word}", "", "",
                 f'=IF(INDEX([{at.phases}.span],[k])=0,"",CHOOSE(1+[moves{i}]+2*[bends{i}],"R","G","U","B"))',
                 one.spread([step.kinds[i] for step in one.handed], ""), align="center",
                 source="R rest, G velocity, U reversal, B both")
          for i, word in enumerate(WORDS)),
    ]  # fmt: skip


def settled(one: Handing) -> list[Quantity]:
    """Return the columns of whether a step moves, and whether it has an acceleration, where it begins and ends.

    What is asked for counts, where a neighbour or an entry settles it; else what the law has.
    """
    found = []
    for i, word in enumerate(WORDS):
        for name, what, own, asked, peak, letters in (
            ("moves", "has a velocity", "v", "w", 1, "GB"), ("bends", "has an acceleration", "a", "q", 2, "UB")
        ):  # fmt: skip
            rate = f"IF(INDEX([{one.asked}.settled{i}],[k])=1,INDEX([{one.asked}.{asked}{i}],[k]),[{own}{i}])"
            values = one.spread([int(step.kinds[i] in letters) for step in one.handed])
            formula = f"=IF(ABS({rate})>check_zero*[peak{peak}],1,0)"
            found.append(one.number(f"{name}{i}", f"{what} at its {word}", formula, values))
    return found
