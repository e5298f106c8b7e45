"""A phase of a motion: a law over a lift in a duration, and its peaks."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Generic, NamedTuple

from engine.laws import Dwell, Law
from engine.laws.base import Kinematics, Real, require_finite


class MotionValues(NamedTuple, Generic[Real]):
    """Position and its derivatives by the abscissa, in the units of the motion; floats, or arrays of equal shape."""

    y: Real  # position
    y1: Real  # geometric velocity y'
    y2: Real  # geometric acceleration y''
    y3: Real  # geometric jerk y'''


@dataclass(frozen=True)
class Phase:
    """A law over a lift in a duration. Raises ValueError for figures outside the limits below."""

    law: Law
    lift: float  # h, in any unit of y; negative for a return, 0 in a dwell
    duration: float  # δ, in any unit of the abscissa; above 0
    # the entered law, between two rests, where the law is another with boundary values, the lift among them
    origin: Law | None = None

    def __post_init__(self) -> None:
        require_finite(lift=self.lift, duration=self.duration)
        if self.duration <= 0.0:
            raise ValueError(f"duration is {self.duration:g}; expected more than 0")
        if isinstance(self.law, Dwell) and self.lift != 0.0:
            raise ValueError(f"lift is {self.lift:g} in a dwell; expected 0")

    @property
    def scale(self) -> float:
        """Factor of the law's s: the lift h, or 1 where the law has boundary values."""
        return 1.0 if self.origin else self.lift

    @property
    def named(self) -> Law:
        """The entered law, between two rests."""
        return self.origin or self.law

    @property
    def moves(self) -> bool:
        """Whether it moves, be it back to where it began."""
        return self.lift != 0.0 or self.origin is not None

    @property
    def rate(self) -> float:
        """1/δ."""
        return 1.0 / self.duration

    @property
    def missing_lift(self) -> float:
        """Part of the lift that the law does not reach, h (1 − s(1)); 0 of a law that ends at 1."""
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
        """RMS of y'' over the phase, C_a,rms |h|/δ²."""
        return self.law.coefficients.ca_rms * abs(self.scale) / self.duration**2

    def values(self, y: float, at: Kinematics[Real]) -> MotionValues[Real]:
        """Return y, y', y'' and the jerk where its law has the values ``at``; the phase begins at ``y``."""
        d, per = self.duration, self.scale / self.duration
        return MotionValues(y + self.scale * at.s, per * at.v, per / d * at.a, per / d**2 * at.j)


class PhaseEnds(NamedTuple):
    """y, y', y'', y''' of a phase at its ends."""

    begin: MotionValues[float]
    end: MotionValues[float]  # left limit


def phases_of(rows: Iterable[tuple[Law, float, float]]) -> list[Phase]:
    """Return phases of laws, lifts and durations. Raises ValueError with the number of an impossible phase, from 1."""
    phases = []
    for number, row in enumerate(rows, 1):
        try:
            phases.append(Phase(*row))
        except ValueError as error:
            raise ValueError(f"phase {number}: {error}") from None
    return phases
