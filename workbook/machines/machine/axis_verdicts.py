"""What the summary's table of axes tells when all other sheets are declared: each axis' laws, and its verdict."""

from __future__ import annotations

from collections.abc import Sequence

from workbook.book.checks import summed_up
from workbook.book.declare import Book, result
from workbook.drive.in_short import NO_DRIVE
from workbook.entries.turn import TurnPhase
from workbook.machines.machine.view import MovingAxis

SEVERAL, DWELL = "several", 1
"""what stands for laws that differ, and the number of the dwell, which spare rows have too"""
OTHERS = f"SUMPRODUCT(([axis{{0}}.no]<>{DWELL})*([axis{{0}}.no]<>MAX([axis{{0}}.no])))>0"
LAW = f'=IF({OTHERS},"{SEVERAL}",IF(MAX([axis{{0}}.no])={DWELL},"{NO_DRIVE}",INDEX(law_code,MAX([axis{{0}}.no]))))'


def judge_axes(book: Book, axes: Sequence[MovingAxis], names: Sequence[str]) -> None:
    """Declare two more columns of the table: the law of all movements of an axis, and whether all its checks hold.

    ``names`` are those of the book's laws.
    """
    block = book.blocks["axes_short"]
    laws = [law_of(axis.given.phases, names) for axis in axes]
    block.sheet.workings(
        block, "axes_judged", "", max(block.columns.values()) + 1,
        result("law", "law", "", "", [LAW.format(axis.number) for axis in axes], laws, align="right"),
        summed_up(book, "axes_judged", "its checks", [of_axis(book, axis.number) for axis in axes]),
    )  # fmt: skip


def of_axis(book: Book, number: int) -> list[int]:
    """Return which checks are those of an axis: of its phases, and of its drive."""
    own = (f"axis{number}_", f"drive{number}_")
    return [k for k, (_, q) in enumerate(book.checks, 1) if q.name.startswith(own)]


def law_of(phases: Sequence[TurnPhase], names: Sequence[str]) -> str:
    """Return the law of all movements, as the sheet Laws has it."""
    moving = {names.index(phase.law) for phase in phases} - {DWELL - 1}
    return SEVERAL if len(moving) > 1 else names[moving.pop()] if moving else NO_DRIVE
