"""Jerk-limited S-curve with seven durations."""

from typing import Annotated

from pydantic import Field

from engine.laws.s_curve import SCurve
from workbook.entries.types import Share
from workbook.laws.edged import FLAT, LINE_IN, LINE_OUT, Stage, edged
from workbook.laws.shared import DURATIONS, LASTING, SevenDurations


class Ramps(SevenDurations):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = Field(default=list(SCurve.durations))


PAGE = edged(
    dict(enumerate(map(Stage, (LINE_OUT, FLAT, LINE_IN, None, LINE_IN, FLAT, LINE_OUT)), 1)),
    source="TwinCAT NC, set-point generator with seven phases",
    entries=Ramps,
    law=SCurve,
    parameters=DURATIONS,
    variations=(
        {"durations": [0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2]},
        {"durations": [0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25]},
        {"durations": [0.0, 0.2, 0.2, 0.1, 0.3, 0.2, 0.0]},
        {"durations": [0.1, 0.15, 0.05, 0.3, 0.0, 0.2, 0.2]},
    ),
    checks=LASTING,
)
