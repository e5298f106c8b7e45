"""Jerk-limited S-curve with seven durations."""

from typing import Annotated

from pydantic import Field

from engine.laws.s_curve import SCurve
from workbook.entries.types import Share
from workbook.laws.brief import BRIEF
from workbook.laws.edged import FLAT, LINE_IN, LINE_OUT, Stage, Stages, edged
from workbook.laws.seven import DURATIONS, LASTS, SUM_IS_1, SevenDurations

FORMS = {1: LINE_OUT, 2: FLAT, 3: LINE_IN, 4: None, 5: LINE_IN, 6: FLAT, 7: LINE_OUT}
STAGES = Stages({k: Stage(form, "") for k, form in FORMS.items()}, entered=True)


class Ramps(SevenDurations):
    """Seven stage durations as shares of the rise; they sum to 1."""

    durations: Annotated[list[Share], Field(min_length=7, max_length=7)] = Field(default=list(SCurve.durations))


PAGE = edged(
    STAGES,
    title="Jerk-limited S-curve",
    source="TwinCAT NC, set-point generator with seven phases",
    entries=Ramps,
    made=lambda entered: SCurve(entered.durations),
    parameters=DURATIONS,
    variations=(
        {"durations": [0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2]},
        {"durations": [0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25]},
        {"durations": [0.0, 0.2, 0.2, 0.1, 0.3, 0.2, 0.0]},
        {"durations": [0.1, 0.15, 0.05, 0.3, 0.0, 0.2, 0.2]},
    ),
    checks=(SUM_IS_1, LASTS, BRIEF),
)
