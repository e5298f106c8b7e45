"""Modified sine."""

from engine.laws.modified_sine import ModifiedSine
from workbook.entries.types import Share
from workbook.laws.edged import SINE_IN, SINE_OUT, Stage, edged
from workbook.laws.family import LawSheet, Parameter
from workbook.laws.shared import SHARE, Between


class Edges(LawSheet):
    """The share of the time that accelerates, and the edges' shares of either half."""

    share: Between = ModifiedSine.share
    rise_edge: Share = ModifiedSine.rise_edge
    fall_edge: Share = ModifiedSine.fall_edge


PAGE = edged(
    {
        1: Stage(SINE_OUT, "=@rise_edge*@share"),
        3: Stage(SINE_IN, "=(1-@rise_edge)*@share"),
        5: Stage(SINE_IN, "=(1-@fall_edge)*(1-@share)"),
        7: Stage(SINE_OUT, "=@fall_edge*(1-@share)"),
    },
    source="LCamHdl, D_D_MOD_SINE",
    entries=Edges,
    law=ModifiedSine,
    parameters=(
        SHARE,
        Parameter("@rise_edge", "First edge, as a share of the acceleration", "β_1", "rise_edge", "first edge",
                  source="¼; ½: cycloidal, 0: simple harmonic"),
        Parameter("@fall_edge", "Last edge, as a share of the deceleration", "β_2", "fall_edge", "last edge"),
    ),
    variations=(
        {"share": 0.4, "rise_edge": 0.25, "fall_edge": 0.4},
        {"share": 0.6, "rise_edge": 0.0, "fall_edge": 1.0},
        {"share": 0.3, "rise_edge": 0.5, "fall_edge": 0.1},
    ),
)  # fmt: skip
