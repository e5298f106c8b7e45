"""Modified trapezoid by its share, also between rest and reversal."""

from typing import Literal

from engine.laws.trapezoid_by_share import TrapezoidByShare
from workbook.entries.types import Share
from workbook.laws.edged import FLAT, SINE_IN, SINE_OUT, Stage, edged
from workbook.laws.family import Parameter
from workbook.laws.shared import SHARE, Shared


class Cut(Shared):
    """The share of the time that accelerates, and the end at which the motion turns round."""

    reversal: Literal["none", "start", "end"] = "none"
    edge: Share = TrapezoidByShare.edge


PAGE = edged(
    {
        1: Stage(SINE_OUT, '=IF(@reversal="start",0,@share/4)'),
        2: Stage(FLAT, '=@share*IF(@reversal="start",1-@edge,1/2)'),
        3: Stage(SINE_IN, '=@share*IF(@reversal="start",@edge,1/4)'),
        5: Stage(SINE_IN, '=(1-@share)*IF(@reversal="end",@edge,1/4)'),
        6: Stage(FLAT, '=(1-@share)*IF(@reversal="end",1-@edge,1/2)'),
        7: Stage(SINE_OUT, '=IF(@reversal="end",0,(1-@share)/4)'),
    },
    source="LCamHdl, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D",
    entries=Cut,
    law=TrapezoidByShare,
    parameters=(
        SHARE,
        Parameter("@reversal", "It turns round at", "", "reversal", "reversal",
                  source="none, start or end: there the acceleration stands"),
        Parameter("@edge", "Edge of the pulse that is cut off", "ρ", "edge", "edge",
                  source="share of the pulse; without a reversal of no account"),
    ),
    variations=(
        {"share": 0.4, "reversal": "end", "edge": 0.3},
        {"share": 0.6, "reversal": "start", "edge": 0.7},
        {"share": 0.3, "reversal": "none", "edge": 0.4},
        {"share": 0.55, "reversal": "end", "edge": 1.0},
    ),
)  # fmt: skip
