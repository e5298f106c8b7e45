"""The least stage of a law: what lasts less cannot be told from a jump, in cells as in any drive."""

from collections.abc import Iterator, Sequence
from typing import Any

from engine.laws.base import BREAK_TOLERANCE
from workbook.book.sentence import figure
from workbook.entries.types import DesignError
from workbook.laws.family import LawCheck

LEAST_STAGE = 1e-4
"""of the rise: from there on cells and engine agree to 1e-9; below it, differences of shares lose the digits"""
BRIEF = LawCheck(
    "@brief", "each stage lasts, or is none",
    "SUMPRODUCT(([@pieces.d]>break_tolerance)*([@pieces.d]<stage_least))=0", "brief",
    '"a stage lasts less than "&ROUND(stage_least,9)&" of the rise; expected that, or none"',
)  # fmt: skip


def too_brief(durations: Sequence[float], entry: str, fits: Any) -> Iterator[DesignError]:
    """Yield the fault of durations among which one is none, but lasts less than any stage."""
    if any(BREAK_TOLERANCE < d < LEAST_STAGE for d in durations):
        said = f"a stage lasts less than {figure(LEAST_STAGE)} of the rise; expected that, or none"
        yield DesignError(entry, said, "brief", fits)
