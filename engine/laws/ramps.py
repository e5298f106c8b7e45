"""Laws whose velocity rises on a ramp, stays constant, and falls on a ramp: TVP, SRT, SCV."""

import math
from dataclasses import dataclass
from typing import ClassVar, NamedTuple, Self

from engine.laws.base import require_finite
from engine.laws.family import Vendors
from engine.laws.pulse_law import (
    CONSTANT,
    HALF_SINE,
    Pulse,
    PulseLaw,
    TwoPulses,
    pulses_of,
    seven_durations,
)


@dataclass(frozen=True)
class RampedLaw(PulseLaw):
    """A law of a pulse at either end. Raises ValueError unless 0 < rise_end ≤ fall_start < 1."""

    HALF: ClassVar[Pulse]

    rise_end: float  # ξ at which the first pulse ends
    fall_start: float  # ξ at which the second pulse begins

    def __post_init__(self) -> None:
        require_finite(rise_end=self.rise_end, fall_start=self.fall_start)
        if not 0.0 < self.rise_end <= self.fall_start < 1.0:
            raise ValueError(
                f"rise_end is {self.rise_end:g} and fall_start {self.fall_start:g}; "
                "expected 0 < rise_end <= fall_start < 1"
            )

    def _pulses(self) -> TwoPulses:
        cruise = self.fall_start - self.rise_end
        return TwoPulses(self.HALF, self.rise_end, cruise, self.HALF, 1.0 - self.fall_start)


@dataclass(frozen=True)
class TrapezoidalVelocity(RampedLaw):
    """Constant acceleration A up to ξ = α_v, uniform velocity A α_v, constant deceleration B from ξ = α_w on.

    A = 2/(α_v (1 − α_v + α_w)), B = 2/((1 − α_w)(1 − α_v + α_w)), as shares of the rise (α_s = 1); e_v = 1/3 in S3.
    """

    code = "TVP"
    number = 3
    name = "Trapezoidal velocity"
    aliases = (
        "trapezoidal speed",
        "trapezoidal velocity profile",
        "asymmetric trapezoidal",
        "asymmetric trapezoidal speed profile",
        "s-shape",
    )
    source = "S1, 'Asymmetric trapezoidal speed profile'; S3, function TVP"
    HALF = CONSTANT

    rise_end: float = 1 / 3  # α_v, above 0, at most α_w, else ValueError
    fall_start: float = 2 / 3  # α_w, below 1


@dataclass(frozen=True)
class SineRamps(RampedLaw):
    """v = V sin²(πξ/2α) up to ξ = α = ``rise_end``, V, and the same mirrored from ``fall_start`` on, over δ.

    a = (πV/2α) sin(πu/α), V = 2/(1 + β) with β the time at V. 0 < rise_end ≤ fall_start < 1, else ValueError.
    """

    code = "SRT"
    number = 18
    name = "Sine-ramp trapezoid"
    aliases = ("modified trapezoidal velocity", "cycloidal with constant velocity", "sin² ramp")
    source = "CODESYS, SML_RampType, Sin2; mechdesigner.support, 'Cycloidal CV'"
    vendors = Vendors(codesys="SML_RT_Sin2, of ramps")
    HALF = HALF_SINE

    rise_end: float = 0.25
    fall_start: float = 0.75


HALVINGS = 200


class Limits(NamedTuple):
    """Limits of a motion, all above 0, in any units of length and time (as m/s, m/s², m/s³)."""

    velocity: float
    acceleration: float
    deceleration: float
    jerk_up: float  # while speeding up
    jerk_down: float  # while slowing down


@dataclass(frozen=True)
class SCurve(PulseLaw):
    """Seven stages, j = A/d1, 0, −A/d3, 0, −B/d5, 0, B/d7: each ramp of velocity with its own jerk.

    With d1 = d3 = d5 = d7 = 0 it is the trapezoid of S1. Raises ValueError unless the shares are 0 or more, sum to 1
    (within 1e-9), and neither the first three nor the last three are all 0.
    """

    code = "SCV"
    number = 19
    name = "Jerk-limited S-curve"
    aliases = ("S-curve", "S-curve profile", "jerk-limited", "seven-segment profile", "ruckbegrenztes Profil")
    source = "TwinCAT NC, set-point generator with seven phases"

    durations: tuple[float, ...] = (1 / 12, 1 / 6, 1 / 12, 1 / 3, 1 / 12, 1 / 6, 1 / 12)

    def __post_init__(self) -> None:
        object.__setattr__(self, "durations", seven_durations(self.durations))

    def _pulses(self) -> TwoPulses:
        return pulses_of(self.durations, sine=False)

    @classmethod
    def of_shares(cls, ramp: float, jerk: float) -> Self:
        """Return the symmetric curve of ramps of 0 < ``ramp`` ≤ ½ of the time, under jerk in 0 ≤ ``jerk`` ≤ 1 of it."""
        if not (0.0 < ramp <= 0.5 and 0.0 <= jerk <= 1.0):
            raise ValueError(f"ramp is {ramp:g} and jerk {jerk:g}; expected 0 < ramp <= 0.5 and 0 <= jerk <= 1")
        edge, flat = jerk * ramp / 2.0, (1.0 - jerk) * ramp
        return cls((edge, flat, edge, 1.0 - 2.0 * ramp, edge, flat, edge))

    @classmethod
    def of_limits(cls, stroke: float, limits: Limits) -> tuple[Self, float]:
        """Return the quickest curve within the limits over a stroke, and its time, in the limits' units.

        A ramp to V takes V/A + A/J, or 2√(V/J) if A is never reached, and travels V/2 times that. If both ramps travel
        farther than the stroke, V is lowered until they do not. Raises ValueError unless all figures are positive.
        """
        if not min(stroke, *limits) > 0.0:
            raise ValueError(f"the stroke is {stroke:g} and the limits {tuple(limits)}; expected them positive")
        require_finite(stroke=stroke, **limits._asdict())

        def ramps(v: float) -> tuple[tuple[float, float], tuple[float, float]]:
            return _ramp(v, limits.acceleration, limits.jerk_up), _ramp(v, limits.deceleration, limits.jerk_down)

        def travel(v: float) -> float:
            return math.fsum(v * (edge + flat / 2.0) for edge, flat in ramps(v))

        top = limits.velocity
        if travel(top) > stroke:
            low = 0.0
            for _ in range(HALVINGS):
                middle = 0.5 * (low + top)
                low, top = (low, middle) if travel(middle) > stroke else (middle, top)
        (up, flat_up), (down, flat_down) = ramps(top)
        cruise = max(stroke - travel(top), 0.0) / top
        times = (up, flat_up, up, cruise, down, flat_down, down)
        time = math.fsum(times)
        return cls(tuple(t / time for t in times)), time


def _ramp(velocity: float, acceleration: float, jerk: float) -> tuple[float, float]:
    """Return the time under jerk on each side of a ramp from rest, and the time at constant acceleration between."""
    edge = min(acceleration / jerk, math.sqrt(velocity / jerk))
    return edge, max(velocity / (jerk * edge) - edge, 0.0)
