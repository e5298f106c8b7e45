"""A tool that goes round or comes back, and a cut: what a product length asks of it.

Lengths in m along the line, speeds in m/s, angles in rad.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.inverse import is_monotone
from engine.laws.sections import breaks, roots, velocity_extremes, velocity_peak

Beyond = Literal["standstill", "reversal"]
SAME_LENGTH = 1e-12  # of the design length, the line speed: a smaller difference is none
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


class ToolMotion(NamedTuple):
    """Motion of the tool along its path over a cycle: m, m/s, m/s², m/s³."""

    position: Array
    speed: Array
    acceleration: Array
    jerk: Array


@dataclass(frozen=True)
class Cut:
    """A product length L_p (m) at line speed v_L (m/s), the law of the superimposed motion.

    ``beyond`` says what a drum does with products longer than ``limit_length``: come to a standstill, wait
    at the law's fastest instant and go on, or reverse. ``peak`` is the ξ of that instant, or None for the first
    at which the law is exactly at its fastest. Raises ValueError unless L_p > L_T and v_L > 0, and
    for a law that moves backwards or does not end at rest at 1.
    """

    tool: Tool
    product_length: float
    line_speed: float
    law: Law
    beyond: Beyond = "standstill"
    peak: float | None = None

    def __post_init__(self) -> None:
        require(self.line_speed > 0.0, "line speed", self.line_speed, "more than 0")
        if not (math.isfinite(self.product_length) and self.product_length > self.tool.tool_length):
            least = self.tool.tool_length
            raise ValueError(f"product length is {self.product_length:g} m; expected more than L_T, {least:g} m")
        if self.beyond not in ("standstill", "reversal"):
            raise ValueError(f"beyond is {self.beyond!r}; expected 'standstill' or 'reversal'")
        end = self.law.end
        if not is_monotone(self.law) or abs(end.s - 1.0) > 1e-9 or max(abs(end.v), abs(self.law.start.v)) > 1e-9:
            raise ValueError(f"{self.law.name}: expected a law that rises from rest at 0 to rest at 1")

    @property
    def cycle_time(self) -> float:
        """t_C = L_p/v_L (s). Source: S5, eq. (4)."""
        return self.product_length / self.line_speed

    @property
    def rate(self) -> float:
        """Products a second, v_L/L_p."""
        return self.line_speed / self.product_length

    @property
    def time_tolerance(self) -> float:
        """A time (s) this near to an event counts as on it."""
        return BREAK_TOLERANCE * self.cycle_time

    @property
    def tool_time(self) -> float:
        """t_T = L_T/v_L (s)."""
        return self.tool.tool_length / self.line_speed

    @property
    def repositioning_time(self) -> float:
        """t_R = t_C − t_T (s)."""
        return (self.product_length - self.tool.tool_length) / self.line_speed

    @property
    def displacement(self) -> float:
        """Displacement h = L_0 − L_p (m), the dynamic displacement; 0 where rounding alone tells them apart."""
        found = self.tool.design_length - self.product_length
        return found if abs(found) > SAME_LENGTH * self.tool.design_length else 0.0

    @property
    def limit_length(self) -> float:
        """L_p,lim = (C_v L_0 − L_T)/(C_v − 1) (m): longer, and the drum cannot but stop or reverse.

        For a tool that comes back it is below L_T. Source: S5, 'Variable length cut'.
        """
        cv = self.law.coefficients.cv
        return (cv * self.tool.design_length - self.tool.tool_length) / (cv - 1.0)

    @property
    def waits(self) -> bool:
        """Whether the drum stands still for part of the cycle."""
        drum = self.tool.design_length > 0.0
        return drum and self.beyond == "standstill" and self.product_length > self.limit_length

    @cached_property
    def moving_time(self) -> float:
        """Time of the superimposed motion without the wait (s): t_R, or C_v L_R/((C_v − 1) v_L) with a wait.

        The latter brings the slowest instant of the motion to standstill exactly.
        """
        if not self.waits:
            return self.repositioning_time
        cv = self.law.coefficients.cv
        return cv * self.tool.repositioning_length / ((cv - 1.0) * self.line_speed)

    @property
    def waiting_time(self) -> float:
        """Time at standstill (s)."""
        return self.repositioning_time - self.moving_time

    @property
    def superimposed(self) -> float:
        """Displacement by the law (m): h, or what remains of it beside the wait, −v_L t/C_v."""
        return -self.line_speed * self.moving_time / self.law.coefficients.cv if self.waits else self.displacement

    @property
    def speed_change(self) -> float:
        """Δv_max = C_v h/t_R (m/s), with the sign of h. Source: S5, eq. (10)."""
        return self.law.coefficients.cv * self.superimposed / self.moving_time

    @property
    def max_acceleration(self) -> float:
        """a_max = C_a |h|/t_R² (m/s²)."""
        return self.law.coefficients.ca * abs(self.superimposed) / self.moving_time**2

    @property
    def max_angular_acceleration(self) -> float:
        """ω̇_L,max = a_max/R_t (rad/s²). Source: S5, eq. (12)."""
        return self.max_acceleration / self.tool.radius

    @property
    def rms_acceleration(self) -> float:
        """a_rms = C_a,rms |h|/t_R² sqrt(t_R/t_C) (m/s²), over the whole cycle."""
        share = math.sqrt(self.moving_time / self.cycle_time)
        return self.law.coefficients.ca_rms * abs(self.superimposed) / self.moving_time**2 * share

    @property
    def rms_angular_acceleration(self) -> float:
        """ω̇_L,rms = a_rms/R_t (rad/s²). Source: S5, eq. (13)."""
        return self.rms_acceleration / self.tool.radius

    @property
    def speed_range(self) -> tuple[float, float]:
        """Lowest and highest speed of the tool over the cycle (m/s)."""
        ends = (self.line_speed, self.line_speed + self.speed_change)
        return min(ends), max(ends)

    @property
    def max_angular_speed(self) -> float:
        """Largest |ω_L| (rad/s)."""
        return max(abs(v) for v in self.speed_range) / self.tool.radius

    @property
    def reverses(self) -> bool:
        """Whether the tool moves against the line for part of the cycle."""
        return self.speed_range[0] < -SAME_LENGTH * self.line_speed

    def fastest_line(self, max_speed: float, max_acceleration: float) -> float:
        """Return the line speed (m/s) at which the shaft is at the first of its limits (rad/s, rad/s²).

        Of one product and law, ω grows with v_L, ω̇ with v_L²: S5, eqs. (11), (12) with t_R = (L_p − L_T)/v_L.
        """
        unit = replace(self, line_speed=1.0)
        by_speed, asked = max_speed / unit.max_angular_speed, unit.max_angular_acceleration
        return min(by_speed, math.sqrt(max_acceleration / asked)) if asked > 0.0 else by_speed

    @property
    def stroke(self) -> float:
        """Furthest less nearest position of the tool in a cycle (m): the slide's travel of a flying saw."""
        times = np.array([0.0, self.repositioning_time, self.cycle_time])
        if self.reverses:  # the tool stands where the law has this velocity
            standing = -self.line_speed * self.moving_time / self.superimposed
            xi = roots(lambda x: self.law.v(x) - standing, velocity_extremes(self.law))
            times = np.concatenate([times, np.union1d(xi, breaks(self.law)) * self.moving_time])
        return float(np.ptp(self.at(times).position))

    def at(self, time: ArrayLike) -> ToolMotion:
        """Return position, speed, acceleration and jerk of the tool (m, s) at times from 0 to t_C.

        At an event they are those behind it, at the end of the cycle those before it. Raises ValueError outside.
        """
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

    @cached_property
    def fastest(self) -> float:
        """ξ at which the law is at its fastest: there a drum waits."""
        return velocity_peak(self.law) if self.peak is None else self.peak

    @property
    def wait(self) -> tuple[float, float]:
        """When the drum comes to a standstill, and when it goes on (s); both t_R where it does not wait."""
        begin = self.fastest * self.moving_time if self.waits else self.repositioning_time
        return begin, begin + self.waiting_time

    def size(self, order: int) -> float:
        """Return how large the n-th derivative of the tool's position is: v_L tⁿ⁻¹ and |h|/tⁿ, of t_m or t_C."""
        superimposed = abs(self.superimposed) / self.moving_time**order
        return max(superimposed, self.product_length / self.cycle_time**order)
