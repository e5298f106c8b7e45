"""How the law of each step is carried out between its ends, in cells, and what it begins and ends with, by VDI 2143."""

from collections.abc import Callable
from math import perm
from typing import Any

from engine.motion.handover import PULSES, Handover
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, calc, constant, result
from workbook.book.rows import filled
from workbook.machines.machine.boundary.handing import Handing

HERMITE = {
    2: {5: "[f0]/2", 7: "[f0]/2", 3: "3*[h]-2*[e1]-[f1]"},
    3: {3: "[e1]+[f1]-2*[h]", 5: "10*[h]-6*[e1]-4*[f1]+([g1]-3*[f0])/2"},
    4: {5: "8*[e1]+7*[f1]-15*[h]+(3*[f0]-2*[g1])/2", 7: "35*[w]-15*[x]+5*[z]/2"},
    5: {5: "6*[h]-3*([e1]+[f1])+([g1]-[f0])/2", 7: "39*[x]-84*[w]-7*[z]"},
    6: {7: "70*[w]-34*[x]+13*[z]/2"},
    7: {7: "10*[x]-20*[w]-2*[z]"},
}
"""e_n by the degree, from stroke, v δ and a δ² at both ends; w, x and z are what the begin leaves to be done"""
SEPTIC_POWERS = 8


def carried(one: Handing) -> list[Quantity]:
    """Return the columns of halves and polynomials."""
    at, size = one.rows.at, one.motion.size
    return [
        constant("k", "row", "k", "", list(range(1, one.room + 1))),
        calc("mode", "is carried out", "", "", f"=INDEX([{one.asked}.mode],[k])", one.of(lambda step: step.mode),
             format="0", source="0 between rests, 1 as two pulses, 2 straight on, 3, 5, 7 as a polynomial"),
        calc("h", "lift", "h", at.y, f"=INDEX([{at.phases}.h],[k])", one.of(lambda step: step.phase.lift),
             scale=size(0), source="of the phase"),
        calc("span", "duration", "δ", at.x, f"=INDEX([{at.phases}.span],[k])",
             one.of(lambda step: step.phase.duration), scale=one.motion.total, source="of the phase"),
        *halves(one), *polynomial(one),
    ]  # fmt: skip


def halves(one: Handing) -> list[Quantity]:
    """Return the columns of a law of two pulses between its ends."""
    at, split, h = one.rows.at, "INDEX(piece_{0},[split])", one.motion.size(0)
    xi, s = split.format("xi"), split.format("s")
    early = one.of(lambda step: step.early, 0)
    return [
        *(calc(f"d{i}", f"velocity added in its {word} half", "", at.unit(1),
               f"=IF([mode]=0,0,INDEX([{one.asked}.w{i}],[k]))",
               one.of(lambda step, i=i: step.drifts[i]), scale=one.motion.size(1))  # type: ignore[misc]
          for i, word in enumerate(("first", "second"))),
        calc("split", "row of its second pulse", "", "",
             f"=INDEX([{at.phases}.first],[k])+IF([mode]=1,INDEX(law_early,INDEX([{at.phases}.no],[k])),0)",
             [first + more for first, more in zip(one.rows.firsts, early, strict=True)], format="0",
             source="on Laws; of all else its first piece"),
        calc("gain", "velocity gained, as a lift", "", at.y,
             f"=IF([mode]=1,([d1]-[d0])*[span]/{split.format('v')},0)", one.of(lambda step: step.gain), scale=h,
             source="(v1 − v0) δ/C_v"),
        calc("h1", "lift of its second half", "h_b", at.y,
             f"=IF([mode]=1,[h]-[span]*([d0]*{xi}+[d1]*(1-{xi}))-{s}*[gain],IF([mode]=0,[h],0))",
             one.of(lambda step: step.halves[1]), scale=h,
             source="h − (v0 λ + v1 (1 − λ)) δ − s(λ) (v1 − v0) δ/C_v"),
        calc("h0", "lift of its first half", "h_a", at.y, "=[h1]+[gain]", one.of(lambda step: step.halves[0]), scale=h),
    ]  # fmt: skip


def polynomial(one: Handing) -> list[Quantity]:
    """Return the columns of a polynomial Σ e_n ξⁿ between its ends."""
    y, h, powers = one.rows.at.y, one.motion.size(0), one.rows.powers

    def at_end(step: Handover, end: int) -> float:
        terms = [perm(n, 2) * e for n, e in enumerate(step.powers)][2:]
        return sum(terms) if end else terms[0]

    left = (
        ("w", "lift that the begin leaves", "=IF([mode]=7,[h]-[e1]-[f0]/2,0)"),
        ("x", "velocity that it leaves", "=IF([mode]=7,[f1]-[e1]-[f0],0)"),
        ("z", "acceleration that it leaves", "=IF([mode]=7,[g1]-[f0],0)"),
    )
    return [
        calc("e1", "first power", "e1", y, "=IF([mode]>1,[d0]*[span],0)",
             one.of(lambda step: step.powers[1]), scale=h, source="v0 δ"),
        calc("f1", "velocity at its end", "v1 δ", y, "=IF([mode]>1,[d1]*[span],0)",
             one.of(lambda step: step.hermite.v1), scale=h),
        *(calc(name, f"acceleration at its {word}", f"a{i} δ²", y,
               f"=IF([mode]>1,INDEX([{one.asked}.q{i}],[k])*[span]^2,0)",
               one.of(lambda step, i=i: (step.hermite.a0, step.hermite.a1)[i]), scale=h)  # type: ignore[misc]
          for i, (name, word) in enumerate((("f0", "begin"), ("g1", "end")))),
        *(calc(name, label, "", y, formula,
               one.of(lambda step, i=i: left_by_begin(step)[i]), scale=h)  # type: ignore[misc]
          for i, (name, label, formula) in enumerate(left) if powers == SEPTIC_POWERS),
        *(calc(f"e{n}", f"power {n}", f"e{n}", y, hermite(n, powers),
               one.of(lambda step, n=n: step.powers[n]), scale=h)  # type: ignore[misc]
          for n in range(2, powers)),
        *(calc(f"b{i}", f"its acceleration at its {word}", "", y,
               "=" + "+".join(f"{perm(n, 2)}*[e{n}]" for n in range(2, powers if i else 3)),
               one.of(lambda step, i=i: at_end(step, i)), scale=h, source="Σ n (n − 1) e_n ξⁿ⁻²")  # type: ignore[misc]
          for i, word in enumerate(("begin", "end"))),
    ]  # fmt: skip


def left_by_begin(step: Handover) -> tuple[float, float, float]:
    """Return the lift, velocity and acceleration that the begin of a polynomial of degree 7 leaves; 0 of all else."""
    ends = step.hermite
    if step.mode != SEPTIC_POWERS - 1:
        return 0.0, 0.0, 0.0
    return ends.stroke - ends.v0 - ends.a0 / 2.0, ends.v1 - ends.v0 - ends.a0, ends.a1 - ends.a0


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
    at, pieces = one.rows.at, one.rows.pieces

    def of(figure: Callable[[Handover, bool, MotionPiece], Any]) -> list[Any]:
        found = []
        for piece in pieces:
            step = one.step_of(piece)
            found.append(figure(step, step.mode == PULSES and piece.number >= step.early, piece))
        return filled(found, room, found[-1])

    def half(column: str) -> str:
        return f"=IF([late]=1,INDEX([{at.ends}.{column}1],[p]),INDEX([{at.ends}.{column}0],[p]))"

    return [
        calc("late", "in the second half", "", "",
             f"=IF([m]<{at.of_end('split')},0,IF({at.of_end('mode')}=1,1,0))", of(lambda _, late, __: int(late)),
             format="0"),
        calc("hp", "lift of its half", "h", at.y, half("h"), of(lambda step, late, _: step.halves[late]),
             scale=one.motion.size(0)),
        calc("drift", "velocity added", "", at.unit(1), half("d"), of(lambda step, late, _: step.drifts[late]),
             scale=one.motion.size(1)),
        calc("base", "position without the law", "", at.y,
             f"={at.of_phase('y0')}+IF([late]=1,{at.of_phase('h')}-[hp]-[drift]*{at.of_phase('span')},0)",
             of(lambda step, late, piece: step.base(late, one.motion.ends[one.in_row[piece.phase]].begin.y)),
             scale=one.motion.size(0)),
    ]  # fmt: skip


WORDS = "begin", "end"


def kinds(one: Handing) -> list[Quantity]:
    """Return the columns of velocity and acceleration at both ends, and of the kinds of both."""
    at = one.rows.at
    peaks = [(f"peak{order}", f"INDEX([{at.phases}.{name}],[k])") for order, name in enumerate(at.peaks, 1)]
    each = one.of(lambda step: step.phase.y1_max), one.of(lambda step: step.phase.y2_max)
    return [
        constant("k", "row", "k", "", list(range(1, one.room + 1))),
        *(calc(name, f"greatest {word}, or 1", "", at.unit(order), f"=IF({peak}>0,{peak},1)",
               [value or 1.0 for value in values], scale=one.motion.size(order))
          for order, ((name, peak), word, values) in enumerate(
              zip(peaks, ("velocity", "acceleration"), each, strict=True), 1)),
        *rates(one), *settled(one),
        *(result(f"{word}s", f"kind of its {word}", "", "",
                 f'=IF(INDEX([{at.phases}.span],[k])=0,"",CHOOSE(1+[moves{i}]+2*[bends{i}],"R","G","U","B"))',
                 one.of(lambda step, i=i: step.kinds[i], ""), align="center",  # type: ignore[misc]
                 source="R rest, G velocity, U reversal, B both")
          for i, word in enumerate(WORDS)),
    ]  # fmt: skip


def rates(one: Handing) -> list[Quantity]:
    """Return the columns of what the law has at both ends."""
    at, size, motion = one.rows.at, one.motion.size, one.motion.ends
    no, rate = f"INDEX([{at.phases}.no],[k])", f"INDEX([{at.phases}.rate],[k])"

    def end(column: str) -> str:
        return f"INDEX([{at.ends}.{column}],[k])"

    return [
        *(calc(f"v{i}", f"velocity at its {word}", "", at.unit(1),
               f"=INDEX(law_v{i},{no})*{end(f'h{i}')}*{rate}+{end(f'd{i}')}",
               one.spread([(found.begin, found.end)[i].y1 for found in motion]), scale=size(1))
          for i, word in enumerate(WORDS)),
        *(calc(f"a{i}", f"acceleration at its {word}", "", at.unit(2),
               f"=(INDEX(law_a{i},{no})*{end(f'h{i}')}+{end(f'b{i}')})*{rate}^2",
               one.spread([(found.begin, found.end)[i].y2 for found in motion]), scale=size(2))
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
            found.append(
                calc(f"{name}{i}", f"{what} at its {word}", "", "", f"=IF(ABS({rate})>check_zero*[peak{peak}],1,0)",
                     one.of(lambda step, i=i, letters=letters: int(step.kinds[i] in letters)),  # type: ignore[misc]
                     format="0")
            )  # fmt: skip
    return found
