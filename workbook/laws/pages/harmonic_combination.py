"""Harmonic combination: a modified sine at the end at rest, a quarter of a sine at the reversal."""

from typing import Literal

from engine.laws.harmonic_combination import HarmonicCombination
from workbook.laws.edged import SINE_IN, SINE_OUT, Stage, edged
from workbook.laws.family import Parameter
from workbook.laws.shared import SHARE, Shared


class Turning(Shared):
    """The share of the time that accelerates, and the end at which the motion turns round."""

    reversal: Literal["start", "end"] = "end"


REVERSAL = Parameter("@reversal", "It turns round at", "", "reversal", "reversal", source="start or end")

PAGE = edged(
    {
        1: Stage(SINE_OUT, '=IF(@reversal="start",0,@share/4)'),
        3: Stage(SINE_IN, '=@share*IF(@reversal="start",1,3/4)'),
        5: Stage(SINE_IN, '=(1-@share)*IF(@reversal="end",1,3/4)'),
        7: Stage(SINE_OUT, '=IF(@reversal="end",0,(1-@share)/4)'),
    },
    source="LCamHdl, D_R_ and R_D_HARMONIC_COMBI",
    entries=Turning,
    law=HarmonicCombination,
    parameters=(SHARE, REVERSAL),
    variations=(
        {"share": 0.4, "reversal": "start"},
        {"share": 0.6, "reversal": "end"},
        {"share": 0.3, "reversal": "start"},
    ),
)
