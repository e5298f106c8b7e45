"""Flying machining: the tool follows the line while it works, and catches up or waits before the next product.

A cycle re-positions first (0 to t_R), then works at line speed (t_R to t_C), as the integrals of S5 run.
"""

from engine.flying.cut import SAME_LENGTH, Beyond, Case, Cut
from engine.flying.points import Sizes, sizes
from engine.flying.tool import (
    LONGER,
    CycleState,
    ShaftMotion,
    Tool,
    ToolMotion,
    flying_saw,
    generalized_torque,
    rotary_drum,
)  # fmt: skip

__all__ = [
    "LONGER", "SAME_LENGTH", "Beyond", "Case", "Cut", "CycleState", "ShaftMotion", "Sizes", "Tool", "ToolMotion",
    "flying_saw", "generalized_torque", "rotary_drum", "sizes",
]  # fmt: skip
