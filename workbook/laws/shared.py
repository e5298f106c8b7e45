"""Entries and checks that several families have: the share λ of the time that accelerates, stages, seven durations."""

from collections.abc import Iterator, Sequence
from typing import Annotated, Any

from pydantic import Field

from engine.laws.base import BREAK_TOLERANCE
from engine.laws.modified import CLASSIC
from workbook.book.sentence import figure
from workbook.entries.types import SUM_TOLERANCE, DesignError, Share
from workbook.laws.family import LawCheck, LawSheet, Parameter

LEAST = 0.01
EVEN = 0.5
Between = Annotated[float, Field(ge=LEAST, le=1 - LEAST, allow_inf_nan=False)]
"""a share of the time: sensible are 0.2 to 0.8; far beyond 0.01 and 0.99 figures lose digits"""


class Shared(LawSheet):
    """The share of the time that accelerates."""

    share: Between = EVEN


SHARE = Parameter("@share", "Share of the time that accelerates", "λ", "share", "share λ", source="½: symmetric")
REVERSAL = Parameter("@reversal", "It turns round at", "", "reversal", "reversal", source="start or end")
SHARED: dict[str, Any] = {  # what the page of a law states that has no parameter but the share
    "entries": Shared,
    "parameters": (SHARE,),
    "variations": ({"share": 0.4}, {"share": 0.65}, {"share": 0.3}),
}
POLYNOMIAL = "=IF(ABS(@share-1/2)<1E-12,{},0)"
"""how a polynomial meets its neighbours: by its degree, unless a share shifts it"""
LEAST_STAGE = 1e-4
"""of the rise: from there on cells and engine agree to 1e-9; below it, differences of shares lose the digits"""
BRIEF = LawCheck(
    "@brief", "each stage lasts, or is none",
    "SUMPRODUCT(([@pieces.d]>break_eps)*([@pieces.d]<stage_least))=0", "brief",
    '"a stage lasts less than "&ROUND(stage_least,9)&" of the rise; expected that, or none"',
)  # fmt: skip


def too_brief(durations: Sequence[float], entry: str, fits: Any) -> Iterator[DesignError]:
    """Yield the fault of durations among which one is none, but lasts less than any stage."""
    if any(BREAK_TOLERANCE < d < LEAST_STAGE for d in durations):
        said = f"a stage lasts less than {figure(LEAST_STAGE)} of the rise; expected that, or none"
        yield DesignError(entry, said, "brief", fits)


class SevenDurations(LawSheet):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = Field(default=list(CLASSIC))

    def design_faults(self) -> Iterator[DesignError]:
        """Yield durations that do not fill the rise, and a law that cannot start or stop."""
        total = sum(self.durations)
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("durations", f"they sum to {figure(total)}; expected 1", "sum", list(CLASSIC))
        if not (sum(self.durations[:3]) and sum(self.durations[4:])):
            yield DesignError("durations", "stages 1 to 3, or 5 to 7, are all 0", "lasts", list(CLASSIC))
        yield from too_brief(self.durations, "durations", list(CLASSIC))


KINDS = ("edge up", "constant", "edge down", "uniform velocity", "edge down", "constant", "edge up")
DURATIONS = tuple(
    Parameter(f"@d{k}", f"Duration of stage {k}: {kind}", f"d{k}", f"durations.{k - 1}", f"stage {k}",
              source="shares of the rise that sum to 1; 0 is allowed" if k == 1 else "")
    for k, kind in enumerate(KINDS, 1)
)  # fmt: skip
SUM_SAYS = '"they sum to "&ROUND(SUM([@pieces.d]),9)&"; expected 1"'
LASTING = (
    LawCheck("@sum", "the seven durations sum to 1", "ABS(SUM([@pieces.d])-1)<check_zero", "sum", SUM_SAYS),
    LawCheck("@lasts", "the law starts and stops", "MIN(@d1+@d2+@d3,@d5+@d6+@d7)>0", "lasts",
             '"stages 1 to 3, or 5 to 7, are all 0"'),
    BRIEF,
)  # fmt: skip
