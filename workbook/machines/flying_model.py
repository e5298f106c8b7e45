"""Flying machining (S5): what an engineer enters, and the engine's view of it."""

from __future__ import annotations

from functools import cached_property
from math import pi, radians, sqrt
from typing import Annotated, Literal, NamedTuple, Self

import numpy as np
from pydantic import Field, model_validator

from engine.drive import Load
from engine.flying import Beyond, Cut, Tool, ToolMotion, flying_saw, rotary_drum
from engine.laws import Dwell, Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.inverse import is_monotone
from engine.laws.sections import velocity_extremes, velocity_peak
from engine.motion import Phase
from engine.selection import Task
from workbook.machine import EntryError, Laws, Machine, Model, NotNegative, Number, Positive, Sizes
from workbook.machines.selection.model import Selection, SelectionSizes, require_room
from workbook.reference import MM, PER_MINUTE, RPM, OwnLaw, laws

DRUM = "drum"
CASES = {"faster": "faster", "constant speed": "in step", "slower": "slower"}
"""the engine's words for the three cases, and the sheet's"""
NEAR = 1e-12  # of a length, a time, a speed: so near is the same
REST = 1e-9  # dimensionless velocity at which a law is at rest
LONGER = 1.001  # times the tool length, the shortest product: the tool needs time to get back
LEAST_CV = 1.001  # below, no product is too long to keep moving
RiseCode = Literal["ACS", "TVP", "CIC", "CUB", "MTP", "OWN"]


class DrumEntry(Model):
    """A drum of tools that goes round."""

    tools: Annotated[float, Field(ge=1, le=100, allow_inf_nan=False)]
    radius: Positive  # mm
    tool_angle: Annotated[float, Field(ge=0, lt=360, allow_inf_nan=False)]  # degrees

    @model_validator(mode="after")
    def _pitched(self) -> Self:
        if self.tools != int(self.tools):
            raise EntryError("tools", f"found {self.tools:g}; expected a whole number")
        if self.tool_angle >= 360 / self.tools:
            raise EntryError(
                "tool_angle",
                f"the tools are in step over {self.tool_angle:g}°; expected less than the {360 / self.tools:g}° "
                "between them",
            )
        return self


class SawEntry(Model):
    """A saw on a slide that comes back."""

    tool_length: NotNegative  # mm
    lead: Positive  # mm of the slide a turn of its shaft
    stroke: Positive  # mm that the slide has


class LoadEntry(Model):
    """What the shaft moves."""

    inertia: NotNegative  # kg m²
    mass: NotNegative = 0.0  # kg, in step with the tool
    torque: Number = 0.0  # Nm, against the line's direction

    @model_validator(mode="after")
    def _heavy(self) -> Self:
        if not (self.inertia or self.mass):
            raise EntryError("inertia", "neither an inertia nor a mass; expected at least one of them above 0")
        return self


class LimitEntry(Model):
    """What the shaft may do."""

    speed: Positive  # rpm
    acceleration: Positive  # rad/s²


class LengthsEntry(Model):
    """The product lengths that the machine is compared over."""

    shortest: Positive  # mm
    longest: Positive  # mm

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.longest <= self.shortest:
            raise EntryError("longest", f"{self.longest:g} mm; expected more than the shortest, {self.shortest:g} mm")
        return self


class CutterEntry(Model):
    """The product and its line, the tool, the law of the superimposed motion."""

    kind: Literal["drum", "saw"] = "drum"
    line_speed: Positive  # m/min
    product_length: Positive  # mm
    law: RiseCode
    beyond: Beyond = "standstill"
    drum: DrumEntry
    saw: SawEntry
    load: LoadEntry
    limits: LimitEntry
    lengths: LengthsEntry


class FlyingSizes(SelectionSizes):
    """How large the tables are built: also the intervals of the product lengths compared."""

    lengths: Annotated[int, Field(ge=2, le=400)] = 60


class FlyingCutter(Machine):
    """A tool that follows the line while it works, and re-positions for the next product (S5)."""

    template: Literal["flying-cutter"] = "flying-cutter"
    cutter: CutterEntry
    selection: Selection = Selection()
    sizes: FlyingSizes = FlyingSizes()

    @model_validator(mode="after")
    def _fits(self) -> Self:
        filled, room = len(self.laws.OWN.pieces), self.sizes.pieces
        if filled > room:
            raise EntryError("laws.OWN.pieces", f"{filled} rows do not fit into {room}; raise sizes.pieces")
        require_room(self.selection, self.sizes)
        require_law(self.cutter.law, self.laws, self.sizes)
        least = tool_of(self.cutter).tool_length / MM * LONGER
        for entry, length in (
            ("product_length", self.cutter.product_length),
            ("lengths.shortest", self.cutter.lengths.shortest),
        ):
            if length < least:
                raise EntryError(
                    f"cutter.{entry}",
                    f"a product of {length:g} mm leaves no time to re-position; expected at least {least:.6g} mm",
                )
        return self


def require_law(code: str, given: Laws, sizes: Sizes) -> None:
    """Raise EntryError unless the law goes from rest to rest, speeds up once and slows down once."""
    law = laws(given, sizes.own_law)[code]
    speeds = law.v(velocity_extremes(law))
    top = int(np.argmax(speeds))
    falls = np.diff(speeds)
    fault = None
    if not is_monotone(law):
        fault = "moves backwards; expected a law that rises throughout"
    elif abs(law.end.s - 1) > BREAK_TOLERANCE:
        fault = f"ends at s = {law.end.s:g}; expected a law that ends at 1"
    elif max(abs(law.start.v), abs(law.end.v)) > REST:
        fault = "does not begin and end at rest; expected a law that does"
    elif min(falls[:top].min(initial=0.0), -falls[top:].max(initial=0.0)) < -REST:
        fault = "speeds up more than once; expected a law that speeds up once, then slows down"
    elif law.coefficients.cv < LEAST_CV:
        fault = f"has C_v = {law.coefficients.cv:g}; expected at least {LEAST_CV:g}"
    if fault:
        raise EntryError("cutter.law", f"the law {code} {fault}")


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
        self.load = Load(load.inertia + load.mass * self.tool.radius**2, load.torque, "always")
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
