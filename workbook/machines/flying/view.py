"""The engine's view of flying machining."""

from __future__ import annotations

from functools import cached_property
from math import pi, radians, sqrt
from typing import NamedTuple

import numpy as np

from engine.choice import Task
from engine.drivetrain import Load
from engine.flying import Beyond, Cut, Tool, ToolMotion, flying_saw, rotary_drum
from engine.laws import Dwell, Law
from engine.laws.base import Array
from engine.laws.sections import velocity_peak
from engine.motion import Phase
from workbook.entries.units import MM, PER_MINUTE, RPM
from workbook.laws.library import OwnLaw
from workbook.machines.flying.entries import DRUM, REST, CutterEntry, FlyingCutter

CASES = {"faster": "faster", "constant speed": "in step", "slower": "slower"}
"""the engine's words for the three cases, and the sheet's"""
NEAR = 1e-12  # of a length, a time, a speed: so near is the same


def tool_of(given: CutterEntry) -> Tool:
    """Return the engine's tool."""
    if given.kind == DRUM:
        drum = given.drum
        return rotary_drum(int(drum.tools), drum.radius * MM, radians(drum.tool_angle))
    return flying_saw(given.saw.tool_length * MM, given.saw.lead * MM / (2 * pi))


def fastest(law: Law) -> float:
    """Return where a law is fastest; of the own law, the first of its samples that is as fast as any."""
    if not isinstance(law, OwnLaw):
        return velocity_peak(law)
    xi = np.arange(law.intervals + 1) / law.intervals
    v = law.v(xi)
    return float(xi[np.argmax(v >= v.max() - REST)])


class BookCut(Cut):
    """A cut whose drum waits where the cells find the law fastest."""

    @cached_property
    def _wait_begins(self) -> float:
        return fastest(self.law) * self.moving_time if self.waits else self.repositioning_time

    @property
    def does(self) -> str:
        """What the tool does while it re-positions."""
        return "waits" if self.waits else "reverses" if self.reverses else "keeps on"

    @property
    def wait(self) -> tuple[float, float]:
        """When the drum comes to a standstill and when it goes on (s); the end of the re-positioning without."""
        return self._wait_begins, self._wait_begins + self.waiting_time


class Asked(NamedTuple):
    """What a cut asks of the drive: RMS acceleration and torque, (ω̇ T*)_mean, β, at the tool's shaft."""

    acceleration: float
    torque: float
    mean: float
    factor: float


class Flying:
    """The engine's view: tool and load, the cut entered, its cycle, and cuts of other lengths."""

    def __init__(self, machine: FlyingCutter, library: dict[str, Law]) -> None:
        self.given, self.sizes, self.library = machine.cutter, machine.sizes, library
        self.tool, self.law = tool_of(self.given), library[self.given.law]
        self.line = self.given.line_speed * PER_MINUTE
        load = self.given.load
        self.load = Load(load.inertia + load.mass * self.tool.radius**2, load.torque)
        self.cut = self.of(self.given.product_length)

    @property
    def is_drum(self) -> bool:
        """Whether the tool goes round."""
        return self.given.kind == DRUM

    def of(self, length: float, beyond: Beyond | None = None) -> BookCut:
        """Return the cut of a product length in mm."""
        return BookCut(self.tool, length * MM, self.line, self.law, beyond or self.given.beyond)

    def asked(self, cut: Cut) -> Asked:
        """Return what a cut asks of the drive, exactly, from the law's coefficients."""
        if cut.superimposed == 0.0:
            return Asked(0.0, abs(self.load.torque), 0.0, 0.0)
        phases = [Phase(self.law, cut.superimposed, cut.moving_time)]
        rest = cut.cycle_time - cut.moving_time
        if rest > 0.0:
            phases.append(Phase(Dwell(), 0.0, rest))
        task = Task.of_load(self.load, phases, self.tool.radius)
        return Asked(task.acceleration_rms, task.torque_rms, task.power_rate_mean, task.load_factor)

    @cached_property
    def times(self) -> Array:
        """The sampled times of the cycle (s)."""
        n = self.sizes.cycle
        return np.arange(n + 1) * self.cut.cycle_time / n

    @cached_property
    def samples(self) -> ToolMotion:
        """The tool at :attr:`times`; a sample on an end of the wait takes the law's side of it, as the cells do."""
        near = NEAR * self.cut.cycle_time
        begin, end = self.cut.wait
        t = self.times
        if self.cut.waits:
            t = np.where(np.abs(t - begin) <= near, begin, np.where(np.abs(t - end) <= near, end + near, t))
        return self.cut.at(t)

    @cached_property
    def lengths(self) -> Array:
        """The product lengths compared (mm)."""
        given, n = self.given.lengths, self.sizes.lengths
        return given.shortest + np.arange(n + 1) * (given.longest - given.shortest) / n

    @property
    def limit(self) -> float:
        """L_p,lim in mm; 0 for a saw, which always reverses."""
        return self.cut.limit_length / MM if self.is_drum else 0.0

    @property
    def allowed_line(self) -> float:
        """The line speed at which the shaft reaches the first of its limits (m/s): ω ~ v_L, ω̇ ~ v_L²."""
        limits = self.given.limits
        unit = BookCut(self.tool, self.cut.product_length, 1.0, self.law, self.given.beyond)
        by_speed = limits.speed * RPM / unit.max_angular_speed
        dw = unit.max_angular_acceleration
        return min(by_speed, sqrt(limits.acceleration / dw)) if dw > 0.0 else by_speed

    @property
    def case(self) -> int:
        """Which row of the cases by product length holds: shorter than L_0, as long, longer, too long to keep on."""
        if self.cut.case != "slower":
            return 1 if self.cut.case == "faster" else 2
        return 4 if self.cut.speed_range[0] <= NEAR * self.line else 3

    @property
    def holds(self) -> dict[str, bool]:
        """Whether each limit is kept: speed, acceleration, stroke."""
        limits, cut = self.given.limits, self.cut
        return {
            "speed": cut.max_angular_speed / RPM <= limits.speed,
            "acceleration": cut.max_angular_acceleration <= limits.acceleration,
            "stroke": self.is_drum or cut.stroke / MM <= self.given.saw.stroke,
        }

    @cached_property
    def scales(self) -> dict[str, float]:
        """What deviations are measured by where a quantity may be near 0: mm, m/s, m/s², rad/s², W/s."""
        length = max(self.tool.design_length, self.cut.product_length)
        a = self.line**2 / length
        dw = a / self.tool.radius
        torque = self.load.inertia * dw
        return {"mm": length / MM, "v": self.line, "a": a, "w": self.line / self.tool.radius, "dw": dw,
                "torque": sqrt(torque**2 + self.load.torque**2), "beta": self.load.inertia * dw**2}  # fmt: skip
