"""The chain from a motor to its load: stages in line, parts on their shafts, the resisting load. SI units."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from engine.laws.base import Array, require_finite

# losses by the direction of power, or as S4 counts them: always over η
Method = Literal["physical", "document"]


def held_factor(efficiency: float, back_efficiency: float) -> float:
    """Return the factor of losses at rest: 1/η as if the motor drove; 0 of a self-locking stage."""
    return 0.0 if back_efficiency <= 0.0 else 1.0 / efficiency


@dataclass(frozen=True)
class Stage:
    """A transmission. Raises ValueError for figures outside the limits below."""

    name: str
    ratio: float  # input over output speed, above 0; rad/m if the output travels (screw: 2πP; roller: 1/R)
    efficiency: float = 1.0  # η where the motor drives, above 0, at most 1
    # η' where the load drives, at most 1; None: η; 0 or less: self-locking
    back_efficiency: float | None = None
    friction: float = 0.0  # on its output (Nm), against the motion, 0 at rest

    def __post_init__(self) -> None:
        require_positive(self.name, ratio=self.ratio)
        require_not_negative(self.name, friction=self.friction)
        if not 0.0 < self.efficiency <= 1.0:
            raise ValueError(f"{self.name}: efficiency is {self.efficiency:g}; expected more than 0 and at most 1")
        back = self.back_efficiency
        if back is not None and not (math.isfinite(back) and back <= 1.0):
            raise ValueError(f"{self.name}: efficiency backward is {back:g}; expected a finite number, at most 1")

    def factor(self, torque: ArrayLike, direction: ArrayLike, method: Method) -> Array:
        """Return the factor of losses f, by which the torque at the output times 1/ratio is multiplied.

        f = 1/η where power flows to the load and at rest, η' where the load drives. A self-locking stage, η' ≤ 0, holds
        the load at rest by itself, f = 0, and has to be driven when the load drives. Source: S1, 'Feeding group', last
        equation, where f = 1; S4, problem 1, where inertia and torque behind the screw are over η; S5, step 7.

        Parameters
        ----------
        torque : array_like, Nm, or N
            At the output.
        direction : array_like
            Direction of motion: 1, −1, or 0 at rest.
        method : {"physical", "document"}
            Losses by the direction of power, or f = 1/η always.

        Returns
        -------
        array
            f, dimensionless.
        """
        if method == "document":
            return np.full(np.broadcast(torque, direction).shape, 1.0 / self.efficiency)
        back = self.efficiency if self.back_efficiency is None else self.back_efficiency
        forward = np.where(np.asarray(direction) == 0.0, held_factor(self.efficiency, back), 1.0 / self.efficiency)
        return np.where(np.asarray(torque) * np.asarray(direction) < 0.0, back, forward)


@dataclass(frozen=True)
class Part:
    """Equal parts on a shaft, or geared to it. Raises ValueError for a negative count or inertia."""

    name: str
    inertia: float  # J of each (kg m²; kg if it travels)
    shaft: int = 0  # number of stages between the motor and the part's shaft; 0 is the motor's
    count: float = 1.0
    # ω_i/ω of parts geared to that shaft, n1/n2 of its teeth (S1: τ_g = 90/45)
    speed_ratio: float = 1.0

    def __post_init__(self) -> None:
        require_not_negative(self.name, inertia=self.inertia, count=self.count)
        require_finite(speed_ratio=self.speed_ratio)

    @property
    def total_inertia(self) -> float:
        """Inertia of all parts, count · J (kg m², or kg)."""
        return self.count * self.inertia

    @property
    def reflected(self) -> float:
        """Inertia at its shaft, count · J · (ω_i/ω)² (kg m², or kg)."""
        return self.total_inertia * self.speed_ratio**2


@dataclass(frozen=True)
class Load:
    """The load at the end of a chain. Raises ValueError for a negative inertia."""

    inertia: float  # kg m²; kg if it travels
    torque: float = 0.0  # Nm, or N; against positive motion, also at rest, like a weight
    friction: float = 0.0  # Nm, or N; against the motion (below 0 with it), 0 at rest

    def __post_init__(self) -> None:
        require_finite(torque=self.torque, friction=self.friction)
        require_not_negative("load", inertia=self.inertia)

    def resisting(self, direction: ArrayLike) -> Array:
        """Return the resisting torque (Nm, or N) in a direction of motion: 1, −1, or 0 at rest."""
        return self.torque + self.friction * np.asarray(direction, dtype=np.float64)


@dataclass(frozen=True)
class Mechanism:
    """Stages from the motor to the load, parts on their shafts, and the load."""

    name: str
    stages: tuple[Stage, ...]  # from the motor to the load, at least one, else ValueError
    # on shafts from the motor's, 0, to the load's, the number of stages, else ValueError
    parts: tuple[Part, ...]
    load: Load  # on the last shaft

    def __post_init__(self) -> None:
        if not self.stages:
            raise ValueError(f"{self.name}: no stages are given; expected at least one")
        for part in self.parts:
            if not 0 <= part.shaft <= self.last:
                raise ValueError(f"{part.name}: shaft is {part.shaft}; expected 0 to {self.last}")

    @property
    def last(self) -> int:
        """Number of the load's shaft."""
        return len(self.stages)

    @property
    def ratio(self) -> float:
        """Speed of the motor over that of the load (rad/m or 1)."""
        return self.ratio_to(self.last)

    def ratio_to(self, shaft: int) -> float:
        """Return the speed of the motor over that of a shaft (1, or rad/m if it travels)."""
        return math.prod(stage.ratio for stage in self.stages[:shaft])

    def ratio_from(self, shaft: int) -> float:
        """Return the speed of a shaft over that of the load (rad/m or 1)."""
        return math.prod(stage.ratio for stage in self.stages[shaft:])

    def on_shaft(self, shaft: int) -> float:
        """Return the inertia of parts and load at their shaft (kg m² or kg): S1, J_tot = 4 J1 + 4 J2."""
        parts = math.fsum(part.reflected for part in self.parts if part.shaft == shaft)
        return parts + self.load.inertia if shaft == self.last else parts

    def friction_on(self, shaft: int) -> float:
        """Return the friction on a shaft (Nm) of the stage that drives it; 0 on the motor's."""
        return self.stages[shaft - 1].friction if shaft else 0.0

    def inertia_divisor(self, shaft: int, method: Method = "physical") -> float:
        """Return i², by which an inertia on a shaft is divided at the motor's; by the method "document" i² η.

        Source: S4, problem 1, J_load = m/(η (2πP)²); problem 2, J = m r²/(η N²).
        """
        lost = math.prod(stage.efficiency for stage in self.stages[:shaft]) if method == "document" else 1.0
        return self.ratio_to(shaft) ** 2 * lost

    def inertia(self, method: Method = "physical") -> float:
        """Return the inertia of all parts and the load at the motor's shaft (kg m²), without the motor's own."""
        return math.fsum(self.on_shaft(k) / self.inertia_divisor(k, method) for k in range(self.last + 1))


def require_positive(where: str, **quantities: float) -> None:
    """Raise ValueError, which begins with ``where``, for the first quantity that is not finite and above 0."""
    for name, value in quantities.items():
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{where}: {name} is {value:g}; expected a finite number above 0")


def require_not_negative(where: str, **quantities: float) -> None:
    """Raise ValueError, which begins with ``where``, for the first quantity that is negative or not finite."""
    for name, value in quantities.items():
        if not (math.isfinite(value) and value >= 0.0):
            raise ValueError(f"{where}: {name} is {value:g}; expected a finite number, 0 or more")


GRAVITY = 9.81  # m/s², the value of S4
Resists = Literal["always", "moving"]


@dataclass(frozen=True)
class Slide:
    """A mass on a guide. Raises ValueError for figures outside the limits below."""

    mass: float  # kg, 0 or more
    friction: float = 0.0  # coefficient μ, 0 or more
    slope: float = 0.0  # θ (rad), above 0 if the guide rises with positive travel; within ±π/2
    force: float = 0.0  # constant force against positive travel (N)
    gravity: float = GRAVITY  # g (m/s²), 0 or more
    bed: float = 0.0  # mass that slides on the guide beside (kg), 0 or more: of a closed belt, whose weight balances

    def __post_init__(self) -> None:
        require_not_negative("load", mass=self.mass, friction=self.friction, gravity=self.gravity, bed=self.bed)
        require_finite(slope=self.slope, force=self.force)
        if abs(self.slope) > math.pi / 2 + 1e-12:
            raise ValueError(f"slope is {math.degrees(self.slope):g} degrees; expected −90 to 90")

    @property
    def load(self) -> Load:
        """The load at a chain's end (N): F + m g sin θ against positive travel, μ (m + m_b) g cos θ against motion."""
        weight = self.mass * self.gravity
        rubbing = self.friction * (self.mass + self.bed) * self.gravity * abs(math.cos(self.slope))
        return Load(self.mass, self.force + weight * math.sin(self.slope), rubbing)


def resisting(force: float, resists: Resists) -> Load:
    """Return the massless load of a force (N, or Nm): "always", like a weight, or "moving", like friction. S1, F_r."""
    if resists not in ("always", "moving"):
        raise ValueError(f"resists is {resists!r}; expected 'always' or 'moving'")
    return Load(0.0, force) if resists == "always" else Load(0.0, friction=force)


def cylinder(diameter: float, length: float, density: float, bore: float = 0.0) -> float:
    """Return the inertia of a solid or hollow cylinder about its axis, ½ ρ π (R⁴ − r⁴) L.

    Source: S4, problem 1, 'a. J_leadscrew'.

    Parameters
    ----------
    diameter, length, bore : float, m
        The bore is the inner diameter.
    density : float, kg/m³

    Returns
    -------
    float, kg m²

    Raises
    ------
    ValueError
        For a negative quantity, or a bore that is not smaller than the diameter.
    """
    require_not_negative("cylinder", diameter=diameter, length=length, density=density, bore=bore)
    if bore > 0.0 and bore >= diameter:
        raise ValueError(f"cylinder: bore is {bore:g} m; expected less than the diameter, {diameter:g} m")
    return 0.5 * density * math.pi * ((diameter / 2.0) ** 4 - (bore / 2.0) ** 4) * length
