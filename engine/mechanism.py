"""Mechanisms between a motor and its load: stages in line, the inertia on each shaft, what resists. SI units."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from engine.laws.base import require_finite

GRAVITY = 9.81
"""m/s², the value of S4"""


@dataclass(frozen=True)
class Stage:
    """A transmission: speed before it over speed behind it, and its efficiency.

    Where it turns rotation into travel, ``ratio`` is in rad/m (lead screw: 2πP; roller: 1/r).
    Raises ValueError unless the ratio is above 0 and the efficiency above 0 and at most 1.
    """

    name: str
    ratio: float
    efficiency: float = 1.0

    def __post_init__(self) -> None:
        _require_positive(self.name, ratio=self.ratio)
        if not 0.0 < self.efficiency <= 1.0:
            raise ValueError(f"{self.name}: efficiency is {self.efficiency:g}; expected more than 0 and at most 1")


@dataclass(frozen=True)
class Part:
    """``count`` equal parts of an inertia, kg m² (kg behind a stage that makes travel).

    ``shaft`` counts the stages between the motor and it: 0 is the motor's shaft.
    Raises ValueError for a negative count or inertia.
    """

    name: str
    inertia: float
    shaft: int = 0
    count: float = 1.0

    def __post_init__(self) -> None:
        _require_not_negative(self.name, inertia=self.inertia, count=self.count)


@dataclass(frozen=True)
class Slide:
    """A mass (kg) on a guide: friction coefficient μ, slope (rad, rising with positive travel), process force (N).

    The force acts against positive travel, always. Raises ValueError for a negative mass or μ, or a slope
    beyond a right angle.
    """

    mass: float
    friction: float = 0.0
    slope: float = 0.0
    force: float = 0.0

    def __post_init__(self) -> None:
        _require_not_negative("load", mass=self.mass, friction=self.friction)
        require_finite(slope=self.slope, force=self.force)
        if abs(self.slope) > math.pi / 2 + 1e-12:
            raise ValueError(f"slope is {math.degrees(self.slope):g} degrees; expected −90 to 90")

    @property
    def steady(self) -> float:
        """F + m g sin θ (N): acts in one direction, also at rest."""
        return self.force + self.mass * GRAVITY * math.sin(self.slope)

    @property
    def rubbing(self) -> float:
        """μ m g cos θ (N): opposes the motion."""
        return self.friction * self.mass * GRAVITY * abs(math.cos(self.slope))


@dataclass(frozen=True)
class Mechanism:
    """Stages from the motor to the load, the parts on their shafts, what resists at the load.

    ``steady`` (N or Nm) acts against positive motion, always; ``rubbing`` (N or Nm) opposes the motion.
    Raises ValueError for no stages, a part on a shaft that is not there, or negative friction.
    """

    name: str
    stages: tuple[Stage, ...]
    parts: tuple[Part, ...]
    steady: float = 0.0
    rubbing: float = 0.0

    def __post_init__(self) -> None:
        require_finite(steady=self.steady)
        _require_not_negative(self.name, rubbing=self.rubbing)
        if not self.stages:
            raise ValueError(f"{self.name}: no stages are given; expected at least one")
        for part in self.parts:
            if not 0 <= part.shaft <= len(self.stages):
                raise ValueError(f"{part.name}: shaft is {part.shaft}; expected 0 to {len(self.stages)}")

    @property
    def ratio(self) -> float:
        """Speed of the motor over that of the load (rad/m or 1)."""
        return self.ratio_to(len(self.stages))

    @property
    def efficiency(self) -> float:
        """Product of the stages' efficiencies."""
        return self.efficiency_to(len(self.stages))

    def ratio_to(self, shaft: int) -> float:
        """Return the speed of the motor over that of a shaft."""
        return math.prod(stage.ratio for stage in self.stages[:shaft])

    def efficiency_to(self, shaft: int) -> float:
        """Return the product of the efficiencies between the motor and a shaft."""
        return math.prod(stage.efficiency for stage in self.stages[:shaft])

    def on_shaft(self, shaft: int) -> float:
        """Return the inertia of the parts on a shaft, at that shaft (kg m² or kg)."""
        return math.fsum(part.count * part.inertia for part in self.parts if part.shaft == shaft)

    def reflected(self, part: Part, losses: bool = False) -> float:
        """Return count · J/i² of a part at the motor's shaft (kg m²); with ``losses`` over η, as S4 does.

        Source: S4, problem 1, J_load = m/(η (2πP)²); problem 2, J = m r²/(η N²).
        """
        lossless = part.count * part.inertia / self.ratio_to(part.shaft) ** 2
        return lossless / self.efficiency_to(part.shaft) if losses else lossless

    def inertia(self, losses: bool = False) -> float:
        """Return J of all parts at the motor's shaft (kg m²), without the motor's own."""
        return math.fsum(self.reflected(part, losses) for part in self.parts)


def cylinder(radius: float, length: float, density: float, bore: float = 0.0) -> float:
    """Return the inertia of a solid or hollow cylinder about its axis, ½ ρ π (R⁴ − r⁴) L, in kg m².

    ``radius``, ``length`` and ``bore`` (the inner radius) in m, ``density`` in kg/m³.
    Raises ValueError for a negative quantity, or a bore that is not smaller than the radius.
    Source: S4, problem 1, 'a. J_leadscrew'.
    """
    _require_not_negative("cylinder", radius=radius, length=length, density=density, bore=bore)
    if bore > 0.0 and bore >= radius:
        raise ValueError(f"cylinder: bore is {bore:g} m; expected less than the radius, {radius:g} m")
    return 0.5 * density * math.pi * (radius**4 - bore**4) * length


def lead_screw(
    turns_per_metre: float, screw_inertia: float, load: Slide, efficiency: float = 1.0, coupling_inertia: float = 0.0
) -> Mechanism:
    """Return a screw on the motor's shaft; P in rev/m, inertias in kg m²; i = 2πP.

    Source: S4, problem 1.
    """
    _require_positive("lead screw", turns_per_metre=turns_per_metre)
    parts = (Part("coupling", coupling_inertia), Part("screw", screw_inertia), Part("load", load.mass, 1))
    stages = (Stage("screw", 2.0 * math.pi * turns_per_metre, efficiency),)
    return Mechanism("lead screw", stages, parts, load.steady, load.rubbing)


def conveyor(
    radius: float,
    roller_inertia: float,
    belt_mass: float,
    load: Slide,
    reduction: float = 1.0,
    efficiency: float = 1.0,
    rollers: float = 2.0,
    gear_inertia: float = 0.0,
) -> Mechanism:
    """Return a belt over rollers of a radius (m), driven through a gear; the belt's own weight balances itself.

    ``roller_inertia`` (kg m²) is that of one roller, ``gear_inertia`` at the motor's shaft; N = ω_m/ω_roller
    is the ``reduction``.
    Source: S4, problem 2.
    """
    parts = (Part("rollers", roller_inertia, 1, rollers), Part("belt", belt_mass, 2), Part("load", load.mass, 2))
    return _geared("conveyor", radius, parts, load, reduction, efficiency, gear_inertia)


def belt_axis(
    radius: float,
    pulley_inertia: float,
    belt_mass: float,
    load: Slide,
    reduction: float = 1.0,
    efficiency: float = 1.0,
    pulleys: float = 2.0,
    gear_inertia: float = 0.0,
) -> Mechanism:
    """Return a carriage on a toothed belt over pulleys of a pitch radius (m); otherwise as :func:`conveyor`."""
    parts = (Part("pulleys", pulley_inertia, 1, pulleys), Part("belt", belt_mass, 2), Part("load", load.mass, 2))
    return _geared("belt", radius, parts, load, reduction, efficiency, gear_inertia)


def rack_and_pinion(
    radius: float,
    pinion_inertia: float,
    load: Slide,
    reduction: float = 1.0,
    efficiency: float = 1.0,
    gear_inertia: float = 0.0,
) -> Mechanism:
    """Return a rack, part of the load's mass, on a pinion of a pitch radius (m) behind a gear."""
    parts = (Part("pinion", pinion_inertia, 1), Part("load", load.mass, 2))
    return _geared("rack and pinion", radius, parts, load, reduction, efficiency, gear_inertia)


def rotary_table(
    table_inertia: float,
    load_inertia: float = 0.0,
    torque: float = 0.0,
    friction_torque: float = 0.0,
    reduction: float = 1.0,
    efficiency: float = 1.0,
    gear_inertia: float = 0.0,
) -> Mechanism:
    """Return a table behind a gear; inertias in kg m², ``torque`` (Nm) always against positive motion."""
    parts = (Part("gear", gear_inertia), Part("table", table_inertia, 1), Part("load", load_inertia, 1))
    return Mechanism("rotary table", (Stage("gear", reduction, efficiency),), parts, torque, friction_torque)


def gear_train(
    stages: Sequence[Stage], parts: Sequence[Part], torque: float = 0.0, friction_torque: float = 0.0
) -> Mechanism:
    """Return gears in line; ``parts`` name their shaft, and the load stands on the last.

    ``torque`` (Nm at the last shaft) acts always against positive motion, ``friction_torque`` opposes it.
    """
    return Mechanism("gear train", tuple(stages), tuple(parts), torque, friction_torque)


def _geared(
    name: str, radius: float, parts: tuple[Part, ...], load: Slide, reduction: float, efficiency: float, gear: float
) -> Mechanism:
    _require_positive(name, radius=radius)
    stages = (Stage("gear", reduction, efficiency), Stage("radius", 1.0 / radius))
    return Mechanism(name, stages, (Part("gear", gear), *parts), load.steady, load.rubbing)


def _require_positive(where: str, **quantities: float) -> None:
    for name, value in quantities.items():
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{where}: {name} is {value:g}; expected a finite number above 0")


def _require_not_negative(where: str, **quantities: float) -> None:
    for name, value in quantities.items():
        if not (math.isfinite(value) and value >= 0.0):
            raise ValueError(f"{where}: {name} is {value:g}; expected a finite number, 0 or more")
