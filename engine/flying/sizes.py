"""How large the quantities of a cut are: beside these, what rounding leaves of a zero is next to nothing."""

import math
from typing import NamedTuple

from engine.flying.cut import Cut


class Sizes(NamedTuple):
    """Sizes in SI: of lengths, and of what the line speed over such a length makes of speeds, accelerations, β."""

    length: float
    speed: float
    acceleration: float
    angle: float
    angular_speed: float
    angular_acceleration: float
    torque: float
    power_rate: float


def sizes(cut: Cut, inertia: float, torque: float) -> Sizes:
    """Return the sizes for a load of J_L (kg m²) and T_L (Nm): a = v_L²/L, β = J_L (a/R_t)²."""
    length, radius = max(cut.tool.design_length, cut.product_length), cut.tool.radius
    acceleration = cut.line_speed**2 / length
    turning = acceleration / radius
    return Sizes(
        length,
        cut.line_speed,
        acceleration,
        length / radius,
        cut.line_speed / radius,
        turning,
        math.hypot(inertia * turning, torque),
        inertia * turning**2,
    )
