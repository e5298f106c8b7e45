"""The phases of an axis that hand velocity over, at their place in its book: their tables and their checks.

A straight line hands its velocity to both of its neighbours, a dwell its rest. A law of two pulses has v0 and h_a times
the law while it speeds up, v1 and h_b times it from then on; h_a and h_b follow from the stroke and from the velocity
between the pulses. A polynomial is the one of its degree by Hermite's conditions. Source: LCamHdl, ProfileTypes, C_C_,
D_C_ and C_D_ laws, POLY_3, POLY_5, POLY_7.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from engine.motion.handover import FIXED, NEVER, Handover, handovers
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, check
from workbook.book.rows import spread
from workbook.book.sentence import Said, first_text
from workbook.entries.abscissa import Abscissa
from workbook.machines.machine.view import MovingAxis
from workbook.motion.cells import PieceRows

SPEED, BEND = " with a velocity", " with an acceleration"
RESTS = ": it begins and ends at rest"
ONLY = ": it takes a velocity only"
KEPT = ": what it has there follows from its points"
BESIDE = ": its begin is entered otherwise than the straight line or dwell there has it"


class Handing:
    """What the phases of an axis take from their neighbours; they stand in every second row of its steps.

    The table of steps has as many rows as there is ``room``; ``in_row`` has the number in the motion of the step of
    each row that is used, both from 0.
    """

    def __init__(self, rows: PieceRows, axis: MovingAxis, over: Abscissa) -> None:
        self.rows, self.axis, self.over, self.motion = rows, axis, over, axis.motion
        self.handed = handovers(replace(axis.joined, motion=axis.motion), axis.passed, axis.given.repeats)
        self.entries = f"axis{axis.number}"
        self.asked, self.kinds, self.last = rows.at.asked, f"{self.entries}_kinds", f"{self.entries}_last"
        self.open, self.room = f'[axes.closes.{axis.number}]="open"', len(rows.firsts)
        self.in_row = {place: k for k, place in enumerate(axis.places)}

    def step_of(self, piece: MotionPiece) -> Handover:
        """Return the step that a piece is of."""
        return self.handed[self.in_row[piece.phase]]

    def of(self, figure: Callable[[Handover], Any], spare: Any = 0.0) -> list[Any]:
        """Return a figure of each step, row by row."""
        return self.spread([figure(one) for one in self.handed], spare)

    def spread(self, values: list[Any], spare: Any = 0.0) -> list[Any]:
        """Return values of the steps in their rows."""
        return spread(values, self.axis.places, self.room, spare)

    @property
    def phases(self) -> list[tuple[int, Handover]]:
        """The phases with the numbers, from 1, of the rows in which they are entered."""
        return [(i, self.handed[k]) for i, k in enumerate(self.axis.entered, 1)]

    def own(self, column: str, formula: str) -> str:
        """Return a formula of the phases' table where the law is carried out between rests, else a figure from here."""
        return self.other(formula, f"INDEX([{self.rows.at.ends}.{column}],[k])")

    def other(self, formula: str, ended: str) -> str:
        """Return a formula of the phases' table where the law is carried out between rests, else another."""
        return f"=IF(INDEX([{self.rows.at.ends}.mode],[k])=0,{formula.removeprefix('=')},{ended})"

    def faults(self) -> list[str]:
        """Return for each step why it cannot have its ends, as its row of the table says it."""
        found = [""] * len(self.handed)
        for (i, one), k in zip(self.phases, self.axis.entered, strict=True):
            found[k] = (
                f"row {i}: {self.axis.given.phases[i - 1].law} cannot {''.join(reason(one))}" if one.fault else ""
            )
        return found

    def checks(self, name: str, label: str) -> list[Quantity]:
        """Return the checks that each law can have the ends that are asked of it, and that nothing speaks against them.

        ``name`` and ``label`` are what the checks' begin with.
        """
        texts, against = f"[{self.asked}.fault]", f"[{self.asked}.contrary]"
        axis, called = self.axis.given.name, f'[axes.name.{self.axis.number}]&" '
        fault = next(filter(None, self.faults()), "")
        contrary = next((f"{axis} row {i}{BESIDE}" for i, one in self.phases if one.contrary), "")
        return [
            check(f"{name}_meets", f"{label}each law meets its neighbours", f"SUM([{self.asked}.cannot])=0", not fault,
                  says=Said(f'{called}"&INDEX({texts},{first_text(texts)})', fault and f"{axis} {fault}")),
            check(f"{name}_passes", f"{label}what is entered goes with straight lines and dwells",
                  f"SUM({against})=0", not contrary,
                  says=Said(f'{called}row "&MATCH(1,{against},0)/2&"{BESIDE}"', contrary)),
        ]  # fmt: skip


def reason(one: Handover) -> tuple[str, str, str]:
    """Return at which end a phase cannot have what is asked for, what that is, and why; nothing where it can."""
    if not one.fault:
        return "", "", ""
    begin, end = one.begin.required, one.end.required
    never, moving = one.end_mode == NEVER, bool(begin.v or end.v)
    first = begin.v if never and moving else begin.a
    return ("begin" if first else "end", SPEED if never and moving else BEND,
            RESTS if never else KEPT if one.end_mode == FIXED else ONLY)  # fmt: skip
