"""Entries of the laws of seven durations."""

from typing import Annotated, Self

from pydantic import Field, model_validator

from engine.laws.modified_trapezoidal import CLASSIC
from workbook.entries.types import SUM_TOLERANCE, EntryError, Share
from workbook.laws.family import LawCheck, LawSheet, Parameter


class SevenDurations(LawSheet):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = Field(default=list(CLASSIC))

    @model_validator(mode="after")
    def _complete(self) -> Self:
        total = sum(self.durations)
        if abs(total - 1) > SUM_TOLERANCE:
            raise EntryError("durations", f"the seven durations sum to {total:.10g}; expected 1")
        if not sum(self.durations[:3]) or not sum(self.durations[4:]):
            raise EntryError(
                "durations",
                "stages 1 to 3 or stages 5 to 7 are all zero; expected at least one of each "
                "three to last, or the law cannot start and stop",
            )
        return self


KINDS = ("edge up", "constant", "edge down", "uniform velocity", "edge down", "constant", "edge up")
DURATIONS = tuple(
    Parameter(f"@d{k}", f"Duration of stage {k}: {kind}", f"d{k}", f"durations.{k - 1}", f"stage {k}",
              source="shares of the rise that sum to 1; zeros are allowed" if k == 1 else "")
    for k, kind in enumerate(KINDS, 1)
)  # fmt: skip
SUM_IS_1 = LawCheck("@sum", "the seven durations sum to 1", "ABS(SUM([@pieces.d])-1)<check_zero")
