"""Flying cuts: a tool on a drum or a slide, and its motion for a product length. Lengths in m along the line."""

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.inverse import is_monotone, velocity_peak

Beyond = Literal["standstill", "reversal"]
SAME_LENGTH = 1e-12  # share of the design length, or line speed, by which equal figures may differ
LONGER = 1.001  # shortest product over the tool length


@dataclass(frozen=True)
class Tool:
    """A tool and its carrier. Raises ValueError unless L_0 ≥ 0, L_T ≥ 0, R_t > 0, and L_T < L_0 if L_0 > 0."""

    design_length: float  # L_0 (m), travel in a cycle at line speed; 0 of a tool that returns
    tool_length: float  # L_T (m), travel at line speed while it works
    radius: float  # R_t (m/rad of its shaft)

    def __post_init__(self) -> None:
        _require(self.radius > 0.0, "radius", self.radius, "more than 0")
        _require(self.design_length >= 0.0, "design length", self.design_length, "0 or more")
        _require(self.tool_length >= 0.0, "tool length", self.tool_length, "0 or more")
        if 0.0 < self.design_length <= self.tool_length:
            raise ValueError(f"tool length is {self.tool_length:g} m; expected less than {self.design_length:g} m")

    @property
    def repositioning_length(self) -> float:
        """L_R = L_0 − L_T (m); negative for a tool that returns."""
        return self.design_length - self.tool_length

    def angle(self, length: float) -> float:
        """Return the angle of the shaft (rad) over a length (m): θ = L/R_t. Source: S5, 'Kinematic analysis'."""
        return length / self.radius


def rotary_drum(tools: int, radius: float, tool_angle: float) -> Tool:
    """Return a drum of tools: θ_0 = 2π/n, L_0 = θ_0 R_t, L_T = θ_T R_t. Source: S5, 'Kinematic analysis'.

    Parameters
    ----------
    tools : int
        n, evenly around the drum.
    radius : float, m
        R_t.
    tool_angle : float, rad
        θ_T, over which a tool is in step with the line.

    Raises
    ------
    ValueError
        Unless n ≥ 1, R_t > 0 and 0 ≤ θ_T < θ_0.
    """
    _require(tools >= 1, "tools", tools, "1 or more")
    pitch = 2.0 * math.pi / tools
    if not 0.0 <= tool_angle < pitch:
        degrees, limit = math.degrees(tool_angle), math.degrees(pitch)
        raise ValueError(f"tool angle is {degrees:g} degrees; expected at least 0 and less than {limit:g}")
    return Tool(pitch * radius, tool_angle * radius, radius)


def flying_saw(tool_length: float, metres_per_radian: float) -> Tool:
    """Return a saw on a slide: in step with the line over L_T (m), then back; the mean speed of the motor is 0.

    It is the case L_0 = 0 of the drum's equations: h = −L_p, and the tool always reverses. ``metres_per_radian`` is the
    travel of the slide by the angle of its shaft: 1/(2πP) of a screw of P turns a metre, the radius of a pinion.
    Source: S5, 'Systems where τ_gx,mean ≠ 0'.
    """
    return Tool(0.0, tool_length, metres_per_radian)


def _require(holds: bool, name: str, value: float, expected: str) -> None:
    """Raise ValueError, with what was expected, unless the condition holds and the value is finite."""
    if not (holds and math.isfinite(value)):
        raise ValueError(f"{name} is {value:g}; expected {expected}")


class ToolMotion(NamedTuple):
    """Motion of the tool along its path, arrays of equal shape."""

    position: Array  # m
    speed: Array  # m/s
    acceleration: Array  # m/s²
    jerk: Array  # m/s³


class Cut:
    """The motion of a tool for a product length L_p (m) at the line speed v_L (m/s), in the order of S5.

    ``law`` is superimposed on the line speed. For products longer than ``limit_length`` a drum waits at the law's
    fastest instant, or reverses, as ``beyond`` says; ``peak`` is the ξ of that instant, by default the exact ξ.
    Raises ValueError unless L_p > L_T and v_L > 0, and for a law that moves backwards or does not end at 1 at rest.
    """

    def __init__(
        self,
        tool: Tool,
        product_length: float,
        line_speed: float,
        law: Law,
        beyond: Beyond = "standstill",
        peak: float | None = None,
    ) -> None:
        _require(line_speed > 0.0, "line speed", line_speed, "more than 0")
        if not (math.isfinite(product_length) and product_length > tool.tool_length):
            raise ValueError(f"product length is {product_length:g} m; expected more than L_T, {tool.tool_length:g} m")
        if beyond not in ("standstill", "reversal"):
            raise ValueError(f"beyond is {beyond!r}; expected 'standstill' or 'reversal'")
        if not is_monotone(law) or abs(law.end.s - 1.0) > 1e-9 or max(abs(law.end.v), abs(law.start.v)) > 1e-9:
            raise ValueError(f"{law.name}: expected a law that rises from rest at 0 to rest at 1")
        self.tool, self.product_length, self.line_speed = tool, product_length, line_speed
        self.law = law
        cv, ca, ca_rms = law.coefficients.cv, law.coefficients.ca, law.coefficients.ca_rms
        self.rate = line_speed / product_length  # 1/s
        self.cycle_time = product_length / line_speed  # t_C (s): eq. (4)
        self.tool_time = tool.tool_length / line_speed  # t_T (s)
        self.repositioning_time = (product_length - tool.tool_length) / line_speed  # t_R (s)
        # s; a time this near to an event counts as on it
        self.time_tolerance = BREAK_TOLERANCE * self.cycle_time
        h, same = tool.design_length - product_length, SAME_LENGTH * tool.design_length
        # h = L_0 − L_p (m), the dynamic displacement
        self.displacement = h if abs(h) > same else 0.0
        # L_p,lim (m): for longer products a drum has to stop or reverse; below L_T for a tool that returns
        self.limit_length = (cv * tool.design_length - tool.tool_length) / (cv - 1.0)
        self.waits = tool.design_length > 0.0 and beyond == "standstill" and product_length > self.limit_length
        # time (s) and displacement (m) of the law; with a wait, those at which the tool just comes to a standstill
        self.moving_time, self.superimposed = self.repositioning_time, self.displacement
        if self.waits:
            self.moving_time = cv * tool.repositioning_length / ((cv - 1.0) * line_speed)
            self.superimposed = -line_speed * self.moving_time / cv
        self.waiting_time = self.repositioning_time - self.moving_time  # s
        # ξ at which v of the law is largest: a drum waits
        self.fastest = velocity_peak(law) if peak is None else peak
        # when the law is fastest (s): the tool too, or slowest
        self.slowest = self.fastest * self.moving_time
        begin = self.slowest if self.waits else self.repositioning_time
        # begin and end of the standstill (s); both t_R without a wait
        self.wait = begin, begin + self.waiting_time
        # Δv_max (m/s), with the sign of h: eq. (10)
        self.speed_change = cv * self.superimposed / self.moving_time
        ends = line_speed, line_speed + self.speed_change
        self.speed_range = min(ends), max(ends)  # m/s
        self.slowest_speed = line_speed + law.v(self.fastest) * self.superimposed / self.moving_time
        # moves against the line for part of the cycle
        self.reverses = self.speed_range[0] < -SAME_LENGTH * line_speed
        pace = abs(self.superimposed) / self.moving_time**2
        share = math.sqrt(self.moving_time / self.cycle_time)
        self.max_acceleration = ca * pace  # a_max = C_a |h|/t_R² (m/s²)
        # a_rms = C_a,rms |h|/t_R² √(t_R/t_C), over the whole cycle
        self.rms_acceleration = ca_rms * pace * share
        # |ω_L| (rad/s), ω̇_L,max (rad/s²): eq. (12), and ω̇_L,rms (rad/s²): eq. (13)
        self.max_angular_speed = max(abs(v) for v in self.speed_range) / tool.radius
        self.max_angular_acceleration = self.max_acceleration / tool.radius
        self.rms_angular_acceleration = self.rms_acceleration / tool.radius

    def fastest_line(self, max_speed: float, max_acceleration: float) -> float:
        """Return the line speed (m/s) at which the shaft reaches the first of its limits (rad/s, rad/s²).

        For a product and a law, ω grows with v_L and ω̇ with v_L²: S5, eqs. (11), (12) with t_R = (L_p − L_T)/v_L.
        """
        v, asked = self.line_speed, self.max_angular_acceleration
        by_speed = v * max_speed / self.max_angular_speed
        return min(by_speed, v * math.sqrt(max_acceleration / asked)) if asked > 0.0 else by_speed

    def at(self, time: ArrayLike) -> ToolMotion:
        """Return the tool's motion at times from 0 to t_C (s), else raise ValueError; at an event that after it."""
        t, near = np.asarray(time, dtype=np.float64), self.time_tolerance
        if t.size and not (t.min() >= -near and t.max() <= self.cycle_time + near):
            raise ValueError(f"time reaches from {t.min():g} to {t.max():g} s; expected 0 to {self.cycle_time:g} s")
        begin, end = self.wait
        works = (t >= self.repositioning_time - near) & (self.tool_time > near)
        waits = (t >= begin - near) & (t < end - near) & ~works
        waited = np.clip(t - begin, 0.0, self.waiting_time)
        law = self.law.evaluate(np.clip((t - waited) / self.moving_time, 0.0, 1.0))
        per = self.superimposed / self.moving_time
        moved = self.superimposed * law.s - self.line_speed * waited
        speed = np.select([waits, works], [0.0, self.line_speed], self.line_speed + per * law.v)
        rates = (np.where(waits | works, 0.0, per / self.moving_time**n * x) for n, x in ((1, law.a), (2, law.j)))
        return ToolMotion(self.line_speed * t + moved, speed, *rates)

    def size(self, order: int) -> float:
        """Return a scale of the n-th derivative of the tool's position (m/sⁿ): the larger of |h|/t_mⁿ and L_p/t_Cⁿ."""
        superimposed = abs(self.superimposed) / self.moving_time**order
        return max(superimposed, self.product_length / self.cycle_time**order)
