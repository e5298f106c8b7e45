"""The entries and checks of laws of seven stages, each stage given by its duration."""

import math
from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from engine.laws.modified import CLASSIC
from workbook.book.cell_tables import cell_tables
from workbook.book.sentence import figure
from workbook.fields.types import SUM_TOLERANCE, DesignError, Share
from workbook.laws import family
from workbook.laws.family import BRIEF, LawSheet, checks_in, parameters_in

CELLS = cell_tables(__file__)

Seven = Annotated[list[Share], Field(min_length=7, max_length=7)]


class SevenDurations(LawSheet):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Seven = Field(default=list(CLASSIC))

    def design_faults(self) -> Iterator[DesignError]:
        """Yield durations that do not fill the rise, and a law that cannot start or stop."""
        total = math.fsum(self.durations)
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("durations", f"they sum to {figure(total)}; expected 1", list(CLASSIC))
        if not (max(self.durations[:3]) and max(self.durations[4:])):
            yield DesignError("durations", "stages 1 to 3, or 5 to 7, are all 0", list(CLASSIC))
        yield from family.too_brief(self.durations, "durations", list(CLASSIC))


DURATIONS = parameters_in(CELLS["durations"])
LASTING = (*checks_in(CELLS["checks"]), BRIEF)
