"""What carries the tool: a drum that goes round, or a slide that comes back."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array

LONGER = 1.001  # times the tool length, the shortest product


@dataclass(frozen=True)
class Tool:
    """What carries the tool: the length it covers a cycle, that at line speed, and metres per rad of its shaft.

    ``design_length`` L_0 (0 of a tool that comes back), ``tool_length`` L_T, ``radius`` R_t.
    Raises ValueError unless 0 ≤ L_0, L_T ≥ 0, R_t > 0, and L_T < L_0 where L_0 > 0.
    """

    design_length: float
    tool_length: float
    radius: float

    def __post_init__(self) -> None:
        require(self.radius > 0.0, "radius", self.radius, "more than 0")
        require(self.design_length >= 0.0, "design length", self.design_length, "0 or more")
        require(self.tool_length >= 0.0, "tool length", self.tool_length, "0 or more")
        if 0.0 < self.design_length <= self.tool_length:
            raise ValueError(f"tool length is {self.tool_length:g} m; expected less than {self.design_length:g} m")

    @property
    def repositioning_length(self) -> float:
        """L_R = L_0 − L_T; negative for a tool that comes back."""
        return self.design_length - self.tool_length

    def angle(self, length: float) -> float:
        """Return the angle of the shaft (rad) over a length (m): θ = L/R_t. Source: S5, 'Kinematic analysis'."""
        return length / self.radius


def rotary_drum(tools: int, radius: float, tool_angle: float) -> Tool:
    """Return a drum of n tools at radius R_t (m), in step with the line over the angle θ_T (rad).

    θ_0 = 2π/n, L_0 = θ_0 R_t, L_T = θ_T R_t. Raises ValueError unless n ≥ 1 and 0 ≤ θ_T < θ_0.
    Source: S5, 'Kinematic analysis'.
    """
    require(tools >= 1, "tools", tools, "1 or more")
    pitch = 2.0 * math.pi / tools
    if not 0.0 <= tool_angle < pitch:
        found, limit = math.degrees(tool_angle), math.degrees(pitch)
        raise ValueError(f"tool angle is {found:g} degrees; expected at least 0 and less than {limit:g}")
    return Tool(pitch * radius, tool_angle * radius, radius)


def flying_saw(tool_length: float, metres_per_radian: float) -> Tool:
    """Return a saw on a slide: in step with the line over L_T (m), then back; the motor's mean speed is zero.

    A transmission ratio with a mean that is not zero makes it the case L_0 = 0 of the drum's equations:
    there is no design length, h = −L_p, and the tool always reverses. ``metres_per_radian`` of the shaft
    that moves the slide: 1/(2πP) of a screw, the radius of a pinion.
    Source: S5, 'Systems where τ_gx,mean ≠ 0'.
    """
    return Tool(0.0, tool_length, metres_per_radian)


def require(holds: bool, name: str, value: float, expected: str) -> None:
    """Raise ValueError, which says what was expected, unless the condition holds and the value is finite."""
    if not (holds and math.isfinite(value)):
        raise ValueError(f"{name} is {value:g}; expected {expected}")


MOVES, WAITS, WORKS = 1, 2, 3  # the parts of a cycle


class CycleState(NamedTuple):
    """Where the cycle is at each time."""

    part: NDArray[np.intp]  # 1 moves by its law, 2 waits at standstill, 3 works at line speed
    waited: Array  # s
    xi: Array  # abscissa of the law


class ToolMotion(NamedTuple):
    """Motion of the tool along its path over a cycle: m, m/s, m/s², m/s³."""

    position: Array
    speed: Array
    acceleration: Array
    jerk: Array
