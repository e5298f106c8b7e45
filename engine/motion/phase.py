"""A phase: a law carried out over a lift in a duration; what it comes to, and what jumps behind it."""

from dataclasses import dataclass
from typing import Generic, NamedTuple

from engine.laws import Dwell, Law
from engine.laws.base import Kinematics, Real, require_finite


class MotionValues(NamedTuple, Generic[Real]):
    """Position y, geometric velocity y', acceleration y'' and jerk y''', per unit of the abscissa."""

    y: Real
    y1: Real
    y2: Real
    y3: Real


class TimeValues(NamedTuple, Generic[Real]):
    """Position y, velocity ẏ, acceleration ÿ and jerk in time."""

    y: Real
    v: Real
    a: Real
    j: Real


@dataclass(frozen=True)
class Phase:
    """A law, from rise 0 to rise 1, over a lift in a duration, in any units. Raises ValueError for what cannot be."""

    law: Law
    lift: float  # h, negative for a return, 0 in a dwell
    duration: float  # δ, above 0

    def __post_init__(self) -> None:
        require_finite(lift=self.lift, duration=self.duration)
        if self.duration <= 0.0:
            raise ValueError(f"duration is {self.duration:g}; expected more than 0")
        if isinstance(self.law, Dwell) and self.lift != 0.0:
            raise ValueError(f"lift is {self.lift:g} in a dwell; expected 0")

    @property
    def scale(self) -> float:
        """What the law's s is multiplied by: the lift, h."""
        return self.lift

    @property
    def named(self) -> Law:
        """The law as it is named: between two rests."""
        return self.law

    @property
    def moves(self) -> bool:
        """Whether it moves."""
        return self.lift != 0.0

    @property
    def rate(self) -> float:
        """1/δ."""
        return 1.0 / self.duration

    @property
    def missing_lift(self) -> float:
        """What the law leaves of the lift, h (1 − s(1)): 0 of a law that ends at 1."""
        return self.lift - self.scale * self.law.end.s

    @property
    def y1_max(self) -> float:
        """Largest |y'| = C_v |h|/δ."""
        return self.law.coefficients.cv * abs(self.scale) / self.duration

    @property
    def y2_max(self) -> float:
        """Largest |y''| = C_a |h|/δ². Source: S1, 'Timing diagram for a cutting machine'."""
        return self.law.coefficients.ca * abs(self.scale) / self.duration**2

    @property
    def y3_max(self) -> float:
        """Largest |y'''| = C_j |h|/δ³; infinite where the law's acceleration jumps."""
        return self.law.coefficients.cj * abs(self.scale) / self.duration**3 if self.scale else 0.0

    @property
    def y2_rms(self) -> float:
        """Root of the mean of y''² over the phase, C_a,rms |h|/δ²."""
        return self.law.coefficients.ca_rms * abs(self.scale) / self.duration**2


class PhaseEnds(NamedTuple):
    """A phase where it begins, and where it ends from within: y, y', y'', y'''."""

    begin: MotionValues[float]
    end: MotionValues[float]


def scaled(phase: Phase, y: float, at: Kinematics[Real]) -> MotionValues[Real]:
    """Return what a phase that begins at y makes of its law at ξ."""
    d, per = phase.duration, phase.scale / phase.duration
    return MotionValues(y + phase.scale * at.s, per * at.v, per / d * at.a, per / d**2 * at.j)


def numbered_phase(number: int, one: Law, lift: float, duration: float) -> Phase:
    """Return a phase; a ValueError says its number."""
    try:
        return Phase(one, lift, duration)
    except ValueError as error:
        raise ValueError(f"phase {number}: {error}") from None
