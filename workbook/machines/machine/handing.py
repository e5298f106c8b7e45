"""What the phases of an axis take from their neighbours, where rests stand between them: in the table of its steps."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from engine.motion.handover import PULSES, SEPTIC, Handover
from engine.motion.pieces import MotionPiece
from engine.motion.turning import WITHIN, rest_of
from workbook.book.declare import Quantity, calc
from workbook.book.rows import filled
from workbook.entries.abscissa import Abscissa
from workbook.entries.units import DEGREE, shown
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows
from workbook.motion.ends import Ends
from workbook.motion.neighbours import Formulas
from workbook.motion.sampled import in_piece
from workbook.motion.turns import PLACES, WORDS

FINEST = "/1000000"
"""of a bracket: its last part"""
PHASE, REST = 1, 0
"""of the number of a row in the table of steps, from 0: the remainder of a phase and of a rest"""


def halved(row: str) -> str:
    """Return the formula of the row of a phase as it is entered, from its row in the table of steps."""
    return f"({row}/2)"


def doubled(formula: str) -> str:
    """Return a formula that takes a figure of the same row, of which phases stand in every second."""
    return formula.replace(",[k])", ",2*[k])")


class StepEnds(Ends):
    """The same for a table in which phases stand in the second, fourth, sixth row, and rests between them."""

    def __init__(self, rows: PieceRows, axis: MovingAxis, used: str, over: Abscissa, wraps: str) -> None:
        self.axis, self.over = axis, over
        name = f"[axes.name.{axis.number}]", axis.given.name
        periodic = axis.given.repeats
        super().__init__(rows, axis.joined, axis.given.phases, used, name, wraps, periodic, axis.passed)

    def more(self) -> list[Quantity]:
        """Return, of an axis with a drive, where polynomials turn round, and where those of degree 7 have extremes."""
        if self.axis.given.motor is None:
            return []
        return [*self._rests(), *(self._bends() if self.turns.degree == SEPTIC else [])]

    def _rests(self) -> list[Quantity]:
        turns, width = self.turns, f"{WITHIN:.0E}".replace("E-0", "E-")
        found = [self._last(1)]
        for i in range(turns.degree - 1):
            v, a = (turns.value(order, f"[r1_{i}]") for order in (1, 2))
            step = f"MAX(0-{width},MIN({width},{v}*{a}/MAX({a}^2,[lost]^2)))"
            found.append(
                calc(f"rest{i + 1}", "turns round at", "u", "rad",
                     f"=IF([s1_{i}]*{self._next(1, i)}<0,[span]*([r1_{i}]-{step}),0)", self._changes(1, i), scale=1.0,
                     source="0: it does not")
            )  # fmt: skip
        return found

    def _bends(self) -> list[Quantity]:
        return [
            self._last(3),
            *(calc(f"bend{i + 1}", "extreme of its acceleration", "u", "rad",
                   f"=IF(AND([mode]={SEPTIC},[s3_{i}]*{self._next(3, i)}<0),[span]*[r3_{i}],0)", self._changes(3, i),
                   scale=1.0, source="0: none")
              for i in range(self.turns.degree - 3)),
        ]  # fmt: skip

    def _last(self, order: int) -> Quantity:
        value = self.turns.value(order, "1")
        return calc(f"last{order}", f"sign its {WORDS[order]} ends with", "", "",
                    f"=IF(ABS({value})>[lost],SIGN({value}),0)", [one.end_sign(order) for one in self.turns.ladders],
                    format="0")  # fmt: skip

    def _next(self, order: int, i: int) -> str:
        return f"[s{order}_{i + 1}]" if i + 1 < self.turns.degree - order else f"[last{order}]"

    def _changes(self, order: int, i: int) -> list[float]:
        """Return where a derivative changes its sign in a bracket (rad), row by row; 0 where it does not."""
        each = zip(self.places, self.handed, strict=True)
        return self.turns.spread([
            self.turns.ladders[place].changed(order, i, one.phase.duration) if order == 1 or one.mode == SEPTIC else 0.0
            for place, one in each
        ])  # fmt: skip

    def bends_of(self, piece: MotionPiece) -> list[float]:
        """Return where a polynomial of degree 7 has extremes of its acceleration (rad); nothing of other pieces."""
        if self.handed[self.in_row[piece.phase]].mode != SEPTIC:
            return []
        return [self._changes(3, i)[piece.phase] for i in range(self.turns.degree - 3)]

    def rests_of_pieces(self, room: int) -> list[Quantity]:
        """Return the column of the pieces' table that says where a piece of two pulses turns round."""
        rows, at = self.rows, self.rows.at
        v, a = (in_piece(rows, order, f"[{PLACES[-1]}]") for order in (1, 2))
        lost, width = f"check_zero*INDEX([{at.phases}.{at.peaks[0]}],[p])", f"[d]{FINEST}"
        step = f"MAX(0-{width},MIN({width},{v}*{a}/MAX({a}^2,({lost})^2)))"
        turns = f"AND({at.of_end('mode')}={PULSES},[sign]*{in_piece(rows, 1, '[d]')}<0-{lost})"
        return [
            calc("rest", "turns round at", "u", "rad", f"=IF({turns},[{PLACES[-1]}]-{step},0)",
                 filled(self.rests, room), scale=1.0, source="0: it does not")
        ]  # fmt: skip

    @cached_property
    def rests(self) -> list[float]:
        """Where each piece of two pulses turns round (rad); 0 where it does not."""
        found = []
        for piece in self.rows.pieces:
            one = self.handed[self.in_row[piece.phase]]
            found.append(rest_of(piece, one.phase.y1_max) if one.mode == PULSES else 0.0)
        return found

    def turning_round(self) -> list[str]:
        """Return the formulas of how often phases turn round, to add up."""
        at = self.rows.at
        columns = [f"[{at.ends}.rest{i}]" for i in range(1, self.turns.degree)]
        return [f"SUMPRODUCT(({name}<>0)*1)" for name in [*columns, f"[{at.pieces}.rest]"]]

    def turned_round(self, room: int) -> list[tuple[float, str]]:
        """Return where phases turn round, in degrees of the motion, each with its formula; 360 where none does."""
        at, end = self.rows.at, self.rows.end
        begins = {place: float(self.motion.edges[k]) for k, place in enumerate(self.places)}
        found: list[tuple[float, str]] = []
        for i in range(self.turns.degree - 1):
            places = self._changes(1, i)
            for k in range(PHASE, self.room, len((REST, PHASE))):
                u, name = places[k], f"[{at.ends}.rest{i + 1}.{k + 1}]"
                found.append((shown(begins[k] + u if u else end, DEGREE),
                              f"=IF({name}=0,360,[{at.phases}.begin.{k + 1}]+DEGREES({name}))"))  # fmt: skip
        pieces = zip(self.rows.pieces, self.rests, strict=True)
        each = [shown(piece.begin + u if u else end, DEGREE) for piece, u in pieces]
        for r, angle in enumerate(filled(each, room, shown(end, DEGREE)), 1):
            name = f"[{at.pieces}.rest.{r}]"
            found.append((angle, f"=IF({name}=0,360,[{at.pieces}.begin.{r}]+DEGREES({name}))"))
        return found

    @property
    def name_of_phases(self) -> str:
        """The table in which the phases are entered."""
        return self.rows.at.phases.removesuffix("_steps")

    @property
    def places(self) -> Sequence[int]:
        """The row, from 0, of each step of the motion."""
        return self.axis.places

    @property
    def numbered(self) -> list[tuple[int, Handover]]:
        """The phases with the numbers, from 1, of the rows in which they are entered."""
        return [(i, self.handed[k]) for i, k in enumerate(self.axis.entered, 1)]

    def told(self, row: str) -> tuple[str, str]:
        """Return the formulas of a row's number as it is entered, and of its law."""
        return halved(row), f"INDEX([{self.name_of_phases}.law],{halved(row)})"

    def entries_at(self) -> tuple[Formulas, Formulas, Formulas]:
        """Return the formulas of what is entered: nothing for rests."""
        none = "=0*[k]"
        each = [
            self.set_by(f"[{self.name_of_phases}.velocity.{row}]", f"[{self.name_of_phases}.acceleration.{row}]")
            for row in range(1, self.axis_room + 1)
        ]
        whether, velocity, acceleration = (
            [none, *(text for formula in column for text in (formula, none))] for column in zip(*each, strict=True)
        )
        return whether, velocity, acceleration

    def by_rad(self, cell: str, order: int) -> str:
        """Return the formula of what is entered of a derivative, by rad."""
        return self.over.rate(f"{cell}{self.over.lift(self.axis.given.unit).taken}", order)

    @property
    def axis_room(self) -> int:
        """Rows of the table in which the phases are entered."""
        return len(range(PHASE, self.room, len((REST, PHASE))))

    def beside(self) -> list[Quantity]:
        """Return the columns that tell the rows before and after: of a rest that has no length the phase behind it."""
        phases, last = self.rows.at.phases, f"2*{self.used}"
        lasts = f"INDEX([{phases}.span],{{0}})>0"
        before, after = zip(*(self._next_to(row) for row in range(self.room)), strict=True)
        wrapped = f"IF({self.wraps},IF({lasts.format(f'{last}+1')},{last}+1,{last}),0)"
        again = f"IF({self.wraps},IF({lasts.format('1')},1,2),0)"
        return [
            calc("before", "row before", "", "",
                 f"=IF([k]=1,{wrapped},IF({lasts.format('[k]-1')},[k]-1,IF([k]=2,{wrapped},[k]-2)))", list(before),
                 format="0"),
            calc("after", "row after", "", "",
                 f"=IF([k]>{last},{again},IF({lasts.format('[k]+1')},[k]+1,IF([k]={last},{again},MIN([k]+2,{last}))))",
                 list(after), format="0"),
        ]  # fmt: skip

    def _next_to(self, row: int) -> tuple[int, int]:
        """Return the rows, from 1, before and behind a row, from 0, as the cells count them."""
        used, phases = set(self.places), max(self.numbered)[0]
        last, k = phases + phases, row + 1
        wrapped = (last + 1 if last in used else last) if self.periodic else 0
        again = (1 if 0 in used else 2) if self.periodic else 0
        before = wrapped if k == 1 else k - 1 if k - 2 in used else wrapped if k == 2 else k - 2
        after = again if k > last else k + 1 if k in used else again if k == last else min(k + 2, last)
        return before, after
