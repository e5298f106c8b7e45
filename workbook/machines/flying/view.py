"""The engine's view of flying machining."""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drive import Load
from engine.flying import Beyond, Cut, ShaftMotion, Sizes, Tool, ToolMotion, flying_saw, generalized_torque, rotary_drum
from engine.flying import sizes as sizes_of
from engine.laws import Dwell, Law
from engine.laws.base import Array
from engine.laws.points import fastest
from engine.motion import Phase
from engine.selection import Task
from workbook.entries.units import DEGREE, KG_CM2, MM, MM_PER_TURN, PER_MINUTE, RPM, shown, si
from workbook.machines.flying.entries import DRUM, CutterEntry, FlyingCutter

CASES = {"faster": "faster", "constant speed": "in step", "slower": "slower"}
"""the engine's words for the three cases, and the sheet's"""
REST = 1e-9  # dimensionless velocity at which a law is at rest


def tool_of(given: CutterEntry) -> Tool:
    """Return the engine's tool."""
    if given.kind == DRUM:
        drum = given.drum
        return rotary_drum(int(drum.tools), si(drum.radius, MM), si(drum.tool_angle, DEGREE))
    return flying_saw(si(given.saw.tool_length, MM), si(given.saw.lead, MM_PER_TURN))


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
        self.number = machine.laws.number(self.given.law)
        self.line = si(self.given.line_speed, PER_MINUTE)
        load = self.given.load
        self.load = Load(self.tool.load_inertia(si(load.inertia, KG_CM2), load.mass), load.torque)
        self.peak = fastest(self.law)
        self.cut = self.of(self.given.product_length)

    @property
    def is_drum(self) -> bool:
        """Whether the tool goes round."""
        return self.given.kind == DRUM

    def of(self, length: float, beyond: Beyond | None = None) -> Cut:
        """Return the cut of a product length in mm, whose drum waits where the cells find the law fastest."""
        return Cut(self.tool, si(length, MM), self.line, self.law, beyond or self.given.beyond, self.peak)

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

    @property
    def room(self) -> int:
        """Rows of the table of the motion's pieces."""
        return self.sizes.motion_pieces or 0

    @property
    def xi_fastest(self) -> Array:
        """Where the law is fastest, as a column of one row."""
        return np.array([self.cut.fastest])

    @property
    def times(self) -> Array:
        """The sampled times of the cycle (s)."""
        return np.linspace(0.0, self.cut.cycle_time, self.sizes.cycle + 1)

    @cached_property
    def samples(self) -> ToolMotion:
        """The tool at :attr:`times`."""
        return self.cut.at(self.times)

    @cached_property
    def shaft(self) -> ShaftMotion:
        """The shaft of the tool at :attr:`times`."""
        return self.samples.at_shaft(self.tool.radius)

    @property
    def torque(self) -> Array:
        """The generalized load torque at :attr:`times` (Nm)."""
        return generalized_torque(self.load.torque, self.load.inertia, self.shaft.acceleration)

    @property
    def lengths(self) -> Array:
        """The product lengths compared (mm)."""
        return np.linspace(self.given.lengths.shortest, self.given.lengths.longest, self.sizes.lengths + 1)

    @property
    def limit(self) -> float:
        """L_p,lim in mm; 0 for a saw, which always reverses."""
        return shown(self.cut.limit_length, MM) if self.is_drum else 0.0

    @property
    def fastest_line(self) -> float:
        """The line speed at which the shaft reaches the first of its limits (m/min)."""
        limits = self.given.limits
        return shown(self.cut.fastest_line(si(limits.speed, RPM), limits.acceleration), PER_MINUTE)

    @property
    def case(self) -> int:
        """Which row of the cases by product length holds: shorter than L_0, as long, longer, too long to keep on."""
        if self.cut.case != "slower":
            return 1 if self.cut.case == "faster" else 2
        return 4 if self.cut.stops else 3

    @property
    def holds(self) -> dict[str, bool]:
        """Whether each limit of the shaft is kept: speed, acceleration."""
        limits, cut = self.given.limits, self.cut
        return {
            "speed": shown(cut.max_angular_speed, RPM) <= limits.speed,
            "acceleration": cut.max_angular_acceleration <= limits.acceleration,
        }

    @cached_property
    def scales(self) -> Sizes:
        """What deviations are measured by where a quantity may be near 0."""
        return sizes_of(self.cut, self.load.inertia, self.load.torque)


def does(cut: Cut) -> str:
    """Return in a word what the tool does while it re-positions."""
    return "waits" if cut.waits else "reverses" if cut.reverses else "keeps moving"
