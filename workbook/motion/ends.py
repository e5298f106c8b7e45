"""What phases take from their neighbours, in cells: velocities at their ends, and what the law becomes between them.

A straight line hands its velocity to both of its neighbours, a dwell its rest. A law of two pulses keeps the form of
either, with other heights: v0 and h_a times the law while it speeds up, v1 and h_b times it from then on; h_a and h_b
follow from the stroke and from the velocity between the pulses. A polynomial is the one of its degree by Hermite's
conditions. Source: LCamHdl, ProfileTypes, C_C_, D_C_ and C_D_ laws, POLY_3, POLY_5, POLY_7.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from math import perm
from typing import Any

from engine.motion.handover import KEEPS, NEVER, PULSES, Handover
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, Sheet, calc, check, constant, result
from workbook.book.rows import filled
from workbook.book.sentence import Said
from workbook.motion.neighbours import Neighbours
from workbook.motion.turns import Turns, grids

TITLE = "Workings: what phases take from their neighbours"
ABOUT = (
    "A straight line hands its velocity to both neighbours. y = v0 u + h_a s(ξ) up to the greatest velocity of a law "
    "of two pulses, from then on y_1 − v1 (δ − u) − h_b (1 − s(ξ)); a polynomial is Σ e_n ξⁿ."
)
KIND = (
    '=IF([span]>0,IF(ABS({v})>check_zero*IF([{0}]>0,[{0}],1),IF(ABS({a})>check_zero*IF([{1}]>0,[{1}],1),"B","G"),'
    'IF(ABS({a})>check_zero*IF([{1}]>0,[{1}],1),"U","R")),"")'
)
HERMITE = {
    2: {5: "[f0]/2", 7: "[f0]/2", 3: "3*[h]-2*[e1]-[f1]"},
    3: {3: "[e1]+[f1]-2*[h]", 5: "10*[h]-6*[e1]-4*[f1]+([g1]-3*[f0])/2"},
    4: {5: "8*[e1]+7*[f1]-15*[h]+(3*[f0]-2*[g1])/2", 7: "35*[w]-15*[x]+5*[z]/2"},
    5: {5: "6*[h]-3*([e1]+[f1])+([g1]-[f0])/2", 7: "39*[x]-84*[w]-7*[z]"},
    6: {7: "70*[w]-34*[x]+13*[z]/2"},
    7: {7: "10*[x]-20*[w]-2*[z]"},
}
"""e_n by the degree, from stroke, v δ and a δ² at both ends; w, x and z are what the begin leaves to be done"""


VELOCITY = " with a velocity: it begins and ends at rest"
ACCELERATION = " with an acceleration: it begins and ends at rest"
ONLY = " with an acceleration: it takes a velocity only, accelerations follow from that, its lift and its shares"
KEPT = " with an acceleration: what it has there follows from its points"
BESIDE = ": its begin is entered otherwise than the straight line or dwell there has it"


class Ends(Neighbours):
    """What the phases of a motion take from their neighbours, and what becomes of their laws: engine's and cells'."""

    @cached_property
    def turns(self) -> Turns:
        """The extremes between prescribed ends."""
        return Turns(self.rows, self.motion, self.handed, self.places)

    def own(self, column: str, formula: str) -> str:
        """Return a formula of the phases' table where the law is carried out between rests, else a figure from here."""
        return self.other(formula, f"INDEX([{self.rows.at.ends}.{column}],[k])")

    def other(self, formula: str, ended: str) -> str:
        """Return a formula of the phases' table where the law is carried out between rests, else another."""
        return f"=IF(INDEX([{self.rows.at.ends}.mode],[k])=0,{formula.removeprefix('=')},{ended})"

    def at_end(self, derivative: str, end: int) -> str:
        """Return the formula, without its =, of y' or y'' at an end of a phase that lasts, for the table of phases."""
        table = self.rows.at.ends
        law = f"INDEX(law_{derivative}{end},[no])*INDEX([{table}.h{end}],[k])"
        if derivative == "v":
            return f"{law}/[span]+INDEX([{table}.d{end}],[k])"
        highest = self.rows.powers if end else 3
        own = "".join(f"+{perm(n, 2)}*INDEX([{table}.e{n}],[k])" for n in range(2, highest))
        return f"({law}{own})/[span]^2"

    def kinds(self) -> list[Quantity]:
        """Return the columns of the kinds of a phase's ends, for the table of phases."""
        table = self.rows.at.ends
        both = []
        for i, (name, word) in enumerate((("begins", "begin"), ("ends", "end"))):
            settled, v = f"INDEX([{table}.settled{i}],[k])=1", f"INDEX([{table}.w{i}],[k])"
            formula = KIND.format(
                *self.rows.at.peaks, v=f"IF({settled},{v},[v{i}])", a=f"IF({settled},INDEX([{table}.q{i}],[k]),[a{i}])"
            )
            values = self.of(lambda one, i=i: one.kinds[i], "")  # type: ignore[misc]
            both.append(result(name, f"kind of its {word}", "", "", formula, values, align="center",
                               source="R rest, G velocity, U reversal, B both"))  # fmt: skip
        return both

    def checks(self, name: str, label: str) -> list[Quantity]:
        """Return the checks that each law can have the ends that are asked of it, and that nothing speaks against them.

        ``name`` and ``label`` are what the checks' begin with.
        """
        table = self.rows.at.ends
        row = f"MATCH(1,[{table}.cannot],0)"
        number, law = self.told(row)
        head = f'{self.name[0]}&" row "&' if self.name[0] else '"row "&'

        def at(column: str) -> str:
            return f"ABS(INDEX([{table}.{column}],{row}))"

        moving = f"{at('w0')}+{at('w1')}>0"
        never = f"INDEX([{table}.way],{row})=0"
        begins = f'IF(IF(AND({never},{moving}),{at("w0")},{at("q0")})>0,"begin","end")'
        kept = f"INDEX([{table}.way],{row})={KEEPS}"
        what = f'IF({never},IF({moving},"{VELOCITY}","{ACCELERATION}"),IF({kept},"{KEPT}","{ONLY}"))'
        says = f'{head}{number}&": "&{law}&" cannot "&{begins}&{what}'
        against = f"MATCH(1,[{table}.contrary],0)"
        return [
            check(f"{name}_meets", f"{label}each law meets its neighbours", f"SUM([{table}.cannot])=0",
                  not any(one.fault for one in self.handed), says=Said(says, self._said())),
            check(f"{name}_passes", f"{label}what is entered goes with straight lines and dwells",
                  f"SUM([{table}.contrary])=0", not any(one.contrary for one in self.handed),
                  says=Said(f'{head}{self.told(against)[0]}&"{BESIDE}"', self._contrary())),
        ]  # fmt: skip

    def told(self, row: str) -> tuple[str, str]:
        """Return the formulas of a row's number as it is entered, and of its law."""
        return row, f"INDEX([{self.rows.at.phases}.law],{row})"

    @property
    def numbered(self) -> list[tuple[int, Handover]]:
        """The phases with the numbers, from 1, of the rows in which they are entered."""
        return list(enumerate(self.handed, 1))

    def _said(self) -> str:
        first = next(((k, one) for k, one in self.numbered if one.fault), None)
        if first is None:
            return ""
        k, one = first
        begin, end = one.begin.asked, one.end.asked
        moving, never = bool(begin.v or end.v), one.way == NEVER
        verb = "begin" if (begin.v if never and moving else begin.a) else "end"
        what = (VELOCITY if moving else ACCELERATION) if never else KEPT if one.way == KEEPS else ONLY
        return f"{self._row(k)}: {self.phases[k - 1].law} cannot {verb}{what}"

    def _contrary(self) -> str:
        return next((f"{self._row(k)}{BESIDE}" for k, one in self.numbered if one.contrary), "")

    def _row(self, k: int) -> str:
        return f"{self.name[1]} row {k}" if self.name[1] else f"row {k}"

    def table(self, sheet: Sheet, title: str) -> None:
        """Declare the table of what the phases take."""
        at = self.rows.at
        sheet.table(
            at.ends, title, self.room,
            constant("k", "row", "k", "", list(range(1, self.room + 1))),
            calc("h", "lift", "h", at.y, f"=INDEX([{at.phases}.h],[k])", self.of(lambda one: one.phase.lift),
                 scale=self.motion.size(0), source="of the phase"),
            calc("span", "duration", "δ", at.x, f"=INDEX([{at.phases}.span],[k])",
                 self.of(lambda one: one.phase.duration), scale=self.motion.total, source="of the phase"),
            *self.neighbours(),
            *self.halves(),
            *self.polynomial(),
            *self.turns.columns(),
            *self.more(),
            blank="[span]=0",
        )  # fmt: skip

    def more(self) -> list[Quantity]:
        """Return further columns: none."""
        return []

    def halves(self) -> list[Quantity]:
        """Return the columns of a law of two pulses between its ends."""
        at, split, h = self.rows.at, "INDEX(piece_{0},[split])", self.motion.size(0)
        return [
            calc("split", "row of its second pulse", "", "",
                 f"=INDEX([{at.phases}.first],[k])+IF([mode]=1,INDEX(law_early,INDEX([{at.phases}.no],[k])),0)",
                 self.splits(), format="0", source="on Laws; of all else its first piece"),
            calc("gain", "velocity gained, as a lift", "", at.y,
                 f"=IF([mode]=1,([w1]-[w0])*[span]/{split.format('v')},0)", self.of(lambda one: one.gain), scale=h,
                 source="(v1 − v0) δ/C_v"),
            calc("h1", "lift of its second half", "h_b", at.y,
                 "=IF([mode]=1,[h]-[span]*([w0]*{0}+[w1]*(1-{0}))-{1}*[gain],IF([mode]=0,[h],0))".format(
                     split.format("xi"), split.format("s")),
                 self.of(lambda one: one.halves[1]), scale=h,
                 source="h − (v0 λ + v1 (1 − λ)) δ − s(λ) (v1 − v0) δ/C_v"),
            calc("h0", "lift of its first half", "h_a", at.y,
                 "=[h1]+[gain]", self.of(lambda one: one.halves[0]), scale=h),
            *(calc(f"d{i}", f"velocity added in its {word} half", "", at.unit(1),
                   f"=IF([mode]=0,0,[w{i}])",
                   self.of(lambda one, i=i: one.drifts[i]), scale=self.motion.size(1))  # type: ignore[misc]
              for i, word in enumerate(("first", "second"))),
        ]  # fmt: skip

    def splits(self) -> list[int]:
        """Return the row on Laws of each phase's second pulse."""
        early = self.of(lambda one: one.early, 0)
        return [first + more for first, more in zip(self.rows.firsts, early, strict=True)]

    def polynomial(self) -> list[Quantity]:
        """Return the columns of a polynomial between its ends."""
        y, h = self.rows.at.y, self.motion.size(0)
        return [
            calc("e1", "first power", "e1", y, "=IF([mode]>1,[w0]*[span],0)",
                 self.of(lambda one: one.powers[1]), scale=h, source="v0 δ"),
            calc("f1", "velocity at its end", "v1 δ", y,
                 "=IF([mode]>1,[w1]*[span],0)", self.of(lambda one: one.hermite.v1), scale=h),
            calc("f0", "acceleration at its begin", "a0 δ²", y,
                 "=IF([mode]>1,[q0]*[span]^2,0)", self.of(lambda one: one.hermite.a0), scale=h),
            calc("g1", "acceleration at its end", "a1 δ²", y,
                 "=IF([mode]>1,[q1]*[span]^2,0)", self.of(lambda one: one.hermite.a1), scale=h),
            *(calc(name, label, "", y, formula, self.of(lambda one, i=i: one.left[i]), scale=h)  # type: ignore[misc]
              for i, (name, label, formula) in enumerate((
                  ("w", "lift that the begin leaves", "=IF([mode]=7,[h]-[e1]-[f0]/2,0)"),
                  ("x", "velocity that it leaves", "=IF([mode]=7,[f1]-[e1]-[f0],0)"),
                  ("z", "acceleration that it leaves", "=IF([mode]=7,[g1]-[f0],0)")))
              if self.rows.powers > 6),
            *(calc(f"e{n}", f"power {n}", f"e{n}", y, self._hermite(n),
                   self.of(lambda one, n=n: one.powers[n]), scale=h)  # type: ignore[misc]
              for n in range(2, self.rows.powers)),
        ]  # fmt: skip

    def _hermite(self, n: int) -> str:
        text = "0"
        for degree, formula in HERMITE[n].items():
            if degree < self.rows.powers:
                text = f"IF([mode]={degree},{formula},{text})"
        return f"={text}"

    def taken(self, room: int) -> list[Quantity]:
        """Return the columns of the pieces' table that say what a piece takes over."""
        at, pieces = self.rows.at, self.rows.pieces

        def of(figure: Callable[[Handover, bool, MotionPiece], Any]) -> list[Any]:
            found = []
            for piece in pieces:
                one = self.handed[self.in_row[piece.phase]]
                found.append(figure(one, one.mode == PULSES and piece.number >= one.early, piece))
            return filled(found, room, found[-1])

        second = f"INDEX([{at.ends}.{{0}}1],[p])"
        first = f"INDEX([{at.ends}.{{0}}0],[p])"
        return [
            calc("late", "in the second half", "", "",
                 f"=IF([m]<{at.of_end('split')},0,IF({at.of_end('mode')}=1,1,0))", of(lambda one, late, _: int(late)),
                 format="0"),
            calc("hp", "lift of its half", "h", at.y,
                 f"=IF([late]=1,{second.format('h')},{first.format('h')})", of(lambda one, late, _: one.halves[late]),
                 scale=self.motion.size(0)),
            calc("drift", "velocity added", "", at.unit(1),
                 f"=IF([late]=1,{second.format('d')},{first.format('d')})", of(lambda one, late, _: one.drifts[late]),
                 scale=self.motion.size(1)),
            calc("base", "position without the law", "", at.y,
                 (f"={at.of_phase('y0')}+IF([late]=1,{at.of_phase('h')}-[hp]-[drift]*{at.of_phase('span')},0)"),
                 of(lambda one, late, piece: one.base(late, self.motion.ends[self.in_row[piece.phase]].begin.y)),
                 scale=self.motion.size(0)),
        ]  # fmt: skip


def ends_tables(sheet: Sheet, found: Sequence[tuple[str, Ends]]) -> None:
    """Declare the tables of what the phases of motions take from their neighbours, by the motions' names."""
    if found:
        sheet.heading(TITLE, ABOUT)
        for name, ends in found:
            ends.table(sheet, f"Ends of {name}" if name else "Ends of the phases")
        grids(sheet)
