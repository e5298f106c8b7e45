"""What a phase takes from the phases beside it, in cells: the velocity of a straight line, a dwell's rest, an entry."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from typing import Any, Protocol

from engine.laws.ends import ROUNDING
from engine.motion.handover import LINE, STRAIGHT, Handover, handovers
from engine.motion.joining import Joined, Rates
from workbook.book.declare import Quantity, calc
from workbook.book.rows import filled, spread
from workbook.motion.cells import PieceRows
from workbook.motion.through import passed

Formulas = str | list[str]
"""one for all rows, or one for each"""


class Passed(Protocol):
    """A phase as entered."""

    law: str
    velocity: float | None
    acceleration: float | None

    @property
    def passes(self) -> bool:
        """Whether any of these is entered."""


class Neighbours:
    """What the phases of a motion take from their neighbours: the engine's, and the cells that find it.

    ``phases`` are these as entered. ``used`` is the formula of how many phases there are, ``wraps`` the
    condition under which the motion repeats, if it need not; ``name`` what the motion is called in sentences, as a
    formula and as a text.
    """

    def __init__(
        self, rows: PieceRows, found: Joined, phases: Sequence[Passed], used: str, name: tuple[str, str] = ("", ""),
        wraps: str = "", periodic: bool = True, entered: Mapping[int, Rates] | None = None,
    ) -> None:  # fmt: skip
        self.rows, self.motion, self.phases, self.used = rows, found.motion, phases, used
        self.name, self.wraps, self.periodic = name, wraps, periodic
        self.handed = handovers(found, passed(phases) if entered is None else entered, periodic)

    @property
    def room(self) -> int:
        """Rows of the table of phases."""
        return len(self.rows.firsts)

    @property
    def places(self) -> Sequence[int]:
        """The row, from 0, of each phase of the motion."""
        return range(len(self.handed))

    @cached_property
    def in_row(self) -> dict[int, int]:
        """The number in the motion, from 0, of the phase of each row that is used."""
        return {place: k for k, place in enumerate(self.places)}

    def of(self, figure: Callable[[Handover], Any], spare: Any = 0.0) -> list[Any]:
        """Return a figure of each phase, with the spare rows filled up."""
        return spread((figure(one) for one in self.handed), self.places, self.room, spare)

    def neighbours(self) -> list[Quantity]:
        """Return the columns of what a phase takes from the phases beside it."""
        at, velocity, size = self.rows.at, self.rows.at.unit(1), self.motion.size
        hands = "=IF([way]=-1,[slope],IF([{0}]=0,{2},IF({1}.way],MAX([{0}],1))=-1,{1}.slope],MAX([{0}],1)),{3})))"
        curves = "=IF([way]=-1,0,IF([{0}]=0,{2},IF({1}.way],MAX([{0}],1))=-1,0,{3})))"
        settled = "=IF([way]=-1,1,IF([{0}]=0,1,IF({1}.way],MAX([{0}],1))=-1,1,{2})))"
        here, there = f"INDEX([{at.ends}", "INDEX([{0}.{1}],MAX([after],1))"
        begin, end = ("begin", "before"), ("end", "after")
        set_by = ((*begin, "[set]"), (*end, there.format(at.ends, "set")))
        v_by = ((*begin, "[ev]", "[ev]"), (*end, "0", there.format(at.ends, "ev")))
        a_by = ((*begin, "[ea]", "[ea]"), (*end, "0", there.format(at.ends, "ea")))

        def against(way: str, slope: str) -> str:
            return f"AND({way}=-1,OR(ABS([ev]-{slope})>check_zero*(ABS([ev])+ABS({slope})),ABS([ea])>0))"

        beside = against(*(f"{here}.{name}],MAX([before],1))" for name in ("way", "slope")))
        return [
            calc("way", "meets its neighbours' velocity", "", "",
                 f"=IF([span]>0,INDEX(law_way,INDEX([{at.phases}.no],[k])),-1)", self.of(lambda one: one.way, STRAIGHT),
                 format="0", source="−1 has one, 0 cannot, 1 by two pulses, 2 keeps its own, 3, 5, 7 by a polynomial"),
            calc("slope", "its own velocity", "h/δ", velocity,
                 "=IF(AND([way]=-1,[span]>0),[h]/[span],0)", self.of(lambda one: one.slope), scale=size(1),
                 source="of a straight line"),
            *self.beside(),
            *self.entered(),
            *(calc(f"settled{i}", f"{word} is settled", "", "", settled.format(side, here, entered),
                   self.of(lambda one, i=i: int(one.sides[i].settled), 1), format="0",  # type: ignore[misc]
                   source="by a straight line, a dwell, an entry")
              for i, (word, side, entered) in enumerate(set_by)),
            *(calc(f"w{i}", f"velocity asked for at its {word}", f"v_{i}", velocity,
                   hands.format(side, here, *entered),
                   self.of(lambda one, i=i: one.sides[i].asked.v), scale=size(1))  # type: ignore[misc]
              for i, (word, side, *entered) in enumerate(v_by)),
            *(calc(f"q{i}", f"acceleration asked for at its {word}", f"a_{i}", at.unit(2),
                   curves.format(side, here, *entered),
                   self.of(lambda one, i=i: one.sides[i].asked.a), scale=size(2))  # type: ignore[misc]
              for i, (word, side, *entered) in enumerate(a_by)),
            calc("contrary", "is entered otherwise", "", "",
                 f"=IF([set]=0,0,IF({against('[way]', '[slope]')},1,IF([before]=0,0,IF({beside},1,0))))",
                 self.of(lambda one: int(one.contrary)), format="0;;", source="than a straight line there has it"),
            calc("cannot", "cannot have such ends", "", "",
                 "=IF(OR(AND([way]=0,ABS([w0])+ABS([w1])+ABS([q0])+ABS([q1])>0),"
                 "AND(OR([way]=1,[way]=2,[way]=3),ABS([q0])+ABS([q1])>0)),1,0)",
                 self.of(lambda one: int(bool(one.fault))), format="0;;", source="1 where it cannot"),
            calc("mode", "is carried out", "", "",
                 "=IF(OR([way]=-1,[way]=2,[cannot]=1,ABS([w0])+ABS([w1])+ABS([q0])+ABS([q1])=0),0,"
                 f"IF(AND(ABS([q0])+ABS([q1])=0,ABS([w1]-[w0])<={ROUNDING:.0E}*ABS([w0]),"
                 f"ABS([h]-[w0]*[span])<={ROUNDING:.0E}*ABS([h])),{LINE},[way]))",
                 self.of(lambda one: one.mode), format="0",
                 source="0 between rests, 1 as two pulses, 2 straight on, 3, 5, 7 as a polynomial"),
        ]  # fmt: skip

    def beside(self) -> list[Quantity]:
        """Return the columns that tell the rows before and after."""
        used, last = self.used, len(self.handed) - 1
        before, after = (self._beside(range(last + 1), last, side) for side in (-1, 1))
        first, end = (used, "1") if not self.wraps else (f"IF({self.wraps},{used},0)", f"IF({self.wraps},1,0)")
        return [
            calc("before", "row before", "", "", f"=IF([k]=1,{first},MIN([k]-1,{used}))",
                 filled(before, self.room, last + 1), format="0", source="0 where nothing is"),
            calc("after", "row after", "", "", f"=IF([k]<{used},[k]+1,{end})",
                 filled(after, self.room, after[-1]), format="0", source="0 where nothing is"),
        ]  # fmt: skip

    def set_by(self, velocity: str, acceleration: str) -> tuple[str, str, str]:
        """Return the formulas of whether anything is entered for the begin of a phase, and of what is."""
        entered = f"=IF(COUNT({velocity},{acceleration})>0,1,0)"
        first, second = (
            f"=IF(ISNUMBER({cell}),{self.by_rad(cell, order)},0)"
            for order, cell in enumerate((velocity, acceleration), 1)
        )
        return entered, first, second

    def by_rad(self, cell: str, order: int) -> str:
        """Return the formula of a derivative by the motion's own abscissa, from the cell in which it is entered."""
        return cell

    def entries_at(self) -> tuple[Formulas, Formulas, Formulas]:
        """Return these formulas, for the rows of the table."""
        phases = self.rows.at.phases
        return self.set_by(f"INDEX([{phases}.velocity],[k])", f"INDEX([{phases}.acceleration],[k])")

    def entered(self) -> list[Quantity]:
        """Return the columns that tell what is entered for the begin of a phase."""
        at, (whether, *rates) = self.rows.at, self.entries_at()
        return [
            calc("set", "its begin is entered", "", "",
                 whether, self.of(lambda one: int(one.entered is not None)), format="0"),
            *(calc(name, f"{word} entered", "", at.unit(order), formula,
                   self.of(lambda one, i=order: one.entered[i - 1] if one.entered else 0.0),  # type: ignore[misc]
                   scale=self.motion.size(order))
              for (name, word, order), formula in zip(
                  (("ev", "velocity", 1), ("ea", "acceleration", 2)), rates, strict=True)),
        ]  # fmt: skip

    def _beside(self, phases: range, last: int, side: int) -> list[int]:
        wrap = {-1: last + 1, 1: 1}[side] if self.periodic else 0
        edge = 0 if side < 0 else last
        return [wrap if k == edge else k + side + 1 for k in phases]
