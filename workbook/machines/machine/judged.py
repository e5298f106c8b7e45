"""What the summary's table of axes tells when all other sheets are declared: each axis' laws, and its verdict."""

from __future__ import annotations

from collections.abc import Sequence

from workbook.book.checks import summed_up
from workbook.book.declare import Book, result
from workbook.drive.in_short import NO_DRIVE
from workbook.entries.turn import TurnPhase
from workbook.machines.machine.view import MovingAxis

SEVERAL = "several"
OTHERS = 'SUMPRODUCT(([axis{0}.law]<>"")*([axis{0}.law]<>[axis{0}.law.1]))>0'
LAW = f'=IF({OTHERS},"{SEVERAL}",IF([axis{{0}}.law.1]="","{NO_DRIVE}",[axis{{0}}.law.1]))'


def judge_axes(book: Book, axes: Sequence[MovingAxis]) -> None:
    """Declare two more columns of the table: the law of all phases of an axis, and whether all its checks hold."""
    block = book.blocks["axes_short"]
    laws = [law_of(axis.given.phases) for axis in axes]
    block.sheet.workings(
        block, "axes_judged", "", max(block.columns.values()) + 1,
        result("law", "law", "", "", [LAW.format(axis.number) for axis in axes], laws, align="right"),
        summed_up(book, "axes_judged", "its checks", [of_axis(book, axis.number) for axis in axes]),
    )  # fmt: skip


def of_axis(book: Book, number: int) -> list[int]:
    """Return which checks are those of an axis: of its phases, and of its drive."""
    own = (f"axis{number}_", f"drive{number}_")
    return [k for k, (_, q) in enumerate(book.checks, 1) if q.name.startswith(own)]


def law_of(phases: Sequence[TurnPhase]) -> str:
    """Return the law of all phases, as the first one has it."""
    first = phases[0].law
    return first if all(phase.law.casefold() == first.casefold() for phase in phases) else SEVERAL
