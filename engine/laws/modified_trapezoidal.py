"""Modified trapezoidal acceleration with seven durations (MTP)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, Coefficients, Law, Shapes, stage_of
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece

SUM_TOLERANCE = 1e-9
K = 2.0 / math.pi  # mean of a quarter sine
QUARTER = math.pi / 2.0
CLASSIC = (1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8)


class Stage(NamedTuple):
    """One stage of a lobe; with t from its begin and the angle x = x0 + t/r (x0 where r is 0)::

    a = sin x,  v = v0 + c t − r cos x,  s = s0 + v0 t + c t²/2 − r² sin x
    """

    begin: float
    r: float
    x0: float
    c: float
    v0: float
    s0: float


class Quarter(NamedTuple):
    """A quarter sine that ends without acceleration: velocity v2 at its begin, velocity g gained on it.

    With x from 0 to π/2 its velocity is v2 + g sin x and its acceleration, of unit height, cos x.
    """

    velocity: float
    gain: float

    @property
    def sin(self) -> float:
        """Sin x where v·a is largest: 2g sin²x + v2 sin x = g; the same for any height of the acceleration."""
        v2, g = self
        return 2.0 * g / (v2 + math.hypot(v2, math.sqrt(8.0) * g))

    @property
    def power(self) -> float:
        """Largest v·a, for unit height: cos x (v2 + g sin x)."""
        return math.sqrt(1.0 - self.sin**2) * (self.velocity + self.gain * self.sin)

    def scaled(self, height: float) -> Quarter:
        """Return the same for another height of the acceleration."""
        return Quarter(height * self.velocity, height * self.gain)


class Lobe(NamedTuple):
    """Three stages of unit acceleration from rest: a quarter sine up, a constant, a quarter sine down.

    a = sin x, where the angle x turns from 0 to π/2 over d1, stands over d2, and turns on to π over d3.
    A deceleration is the same thing seen backwards from its end.
    """

    d1: float
    d2: float
    d3: float

    @property
    def velocities(self) -> tuple[float, float, float]:
        """Velocity at the end of each stage."""
        return K * self.d1, K * self.d1 + self.d2, K * self.d1 + self.d2 + K * self.d3

    @property
    def travels(self) -> tuple[float, float, float]:
        """Travel up to the end of each stage."""
        v1, v2, _ = self.velocities
        first = K * (1.0 - K) * self.d1**2
        second = first + v1 * self.d2 + self.d2**2 / 2.0
        return first, second, second + v2 * self.d3 + (K * self.d3) ** 2

    @property
    def square(self) -> float:
        """∫ a² dt."""
        return self.d1 / 2.0 + self.d2 + self.d3 / 2.0

    @property
    def quarter(self) -> Quarter:
        """The last quarter sine, on which v·a is largest."""
        return Quarter(self.velocities[1], K * self.d3)

    @property
    def power(self) -> float:
        """Largest v·a."""
        return self.quarter.power

    @property
    def jerk(self) -> float:
        """Largest |j|; infinite without both quarter sines."""
        shorter = min(self.d1, self.d3)
        return 1.0 / (K * shorter) if shorter > 0.0 else math.inf

    @property
    def stages(self) -> tuple[Stage, Stage, Stage]:
        """The three stages in closed form."""
        (v1, v2, _), (s1, s2, _) = self.velocities, self.travels
        r1, r3 = K * self.d1, K * self.d3
        return (
            Stage(begin=0.0, r=r1, x0=0.0, c=0.0, v0=r1, s0=0.0),
            Stage(begin=self.d1, r=0.0, x0=QUARTER, c=1.0, v0=v1, s0=s1),
            Stage(begin=self.d1 + self.d2, r=r3, x0=QUARTER, c=0.0, v0=v2, s0=s2 + r3 * r3),
        )


@dataclass(frozen=True)
class ModifiedTrapezoidal(Law):
    """Seven stages: a = A sin(πu/2d1), A, A cos(πu/2d3), 0, −B sin(πu/2d5), −B, −B cos(πu/2d7).

    ``durations`` are the seven shares of the rise: not negative, of sum 1 (within 1e-9), neither the first
    three nor the last three all zero; else ValueError. With k = 2/π, m = k d1 + d2 + k d3 and
    n = k d5 + d6 + k d7, A m = B n = C_v and A = 1/(S_a + m d4 + S_d m/n), where S_a and S_d are the travels
    of the two lobes for unit acceleration.
    Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'; S3, figure 2, 'ModTVP'.
    """

    code = "MTP"
    name = "Modified trapezoidal"

    durations: tuple[float, float, float, float, float, float, float] = CLASSIC

    def __post_init__(self) -> None:
        durations = tuple(float(d) for d in self.durations)
        if len(durations) != 7:
            raise ValueError(f"{len(durations)} durations are given; expected seven")
        for i, d in enumerate(durations, 1):
            if not 0.0 <= d <= 1.0 + SUM_TOLERANCE:
                raise ValueError(f"the duration of stage {i} is {d:g}; expected a share from 0 to 1")
        if abs(sum(durations) - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the seven durations sum to {sum(durations):.12g}; expected 1")
        for stages, part in (("1 to 3", durations[:3]), ("5 to 7", durations[4:])):
            if not sum(part) > 0.0:
                raise ValueError(f"the durations of stages {stages} are all zero; expected one that lasts")
        object.__setattr__(self, "durations", durations)

    @cached_property
    def lobes(self) -> tuple[Lobe, Lobe]:
        """The acceleration from its begin and the deceleration from its end, for unit acceleration."""
        d1, d2, d3, _, d5, d6, d7 = self.durations
        return Lobe(d1, d2, d3), Lobe(d7, d6, d5)

    @cached_property
    def acceleration(self) -> float:
        """A: the height of the acceleration, from s(1) = 1."""
        rise, fall = self.lobes
        m, n = rise.velocities[2], fall.velocities[2]
        return 1.0 / (rise.travels[2] + m * self.durations[3] + fall.travels[2] * m / n)

    @cached_property
    def deceleration(self) -> float:
        """B = A m/n: the height of the deceleration, positive."""
        rise, fall = self.lobes
        return self.acceleration * rise.velocities[2] / fall.velocities[2]

    @property
    def quarters(self) -> tuple[Quarter, Quarter]:
        """The quarter sines on either side of the uniform velocity, with their velocities in this law."""
        rise, fall = self.lobes
        return rise.quarter.scaled(self.acceleration), fall.quarter.scaled(self.deceleration)

    @cached_property
    def _stages(self) -> tuple[Array, Array]:
        """Begin of each stage, and a column of what evaluates it: direction, origin, amplitude, …"""
        rise, fall = self.lobes
        coast = Stage(sum(self.durations[:3]), 0.0, 0.0, 0.0, rise.velocities[2], rise.travels[2])
        forward = [_column(stage, 1.0, 0.0, self.acceleration, 0.0) for stage in (*rise.stages, coast)]
        end = sum(self.durations)
        backward = [_column(stage, -1.0, end, self.deceleration, 1.0) for stage in fall.stages[::-1]]
        return np.cumsum((0.0, *self.durations[:6])), np.array([*forward, *backward]).T.copy()

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        starts, table = self._stages
        sign, origin, f, base, rate, r, x0, c, v0, s0 = table.take(stage_of(xi, starts), axis=1)
        t = sign * xi + origin  # since the begin of the stage, or until its end
        x = x0 + rate * t
        sin, cos = np.sin(x), np.cos(x)
        travel = s0 + t * (v0 + c / 2.0 * t) - r * r * sin
        return base + sign * f * travel, f * (v0 + c * t - r * cos), sign * f * sin, f * rate * cos

    def _coefficients(self) -> Coefficients:
        (rise, fall), up, down = self.lobes, self.acceleration, self.deceleration
        return Coefficients(
            cv=up * rise.velocities[2],
            ca_max=up,
            ca_min=-down,
            ca_rms=math.sqrt(up**2 * rise.square + down**2 * fall.square),
            cj=max(up * rise.jerk, down * fall.jerk),
            va_max=up**2 * rise.power,
            va_min=-(down**2) * fall.power,
        )

    @property
    def breaks(self) -> tuple[float, ...]:
        """The ends of the first six stages."""
        return tuple(accumulate(self.durations[:6]))

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the seven stages, with ω = π/2d of the sines and the cosines as sines of φ = π/2."""
        d1, d2, d3, d4, d5, d6, d7 = self.durations
        return (*_lobe(d1, d2, d3, self.acceleration), Piece(d4), *_lobe(d5, d6, d7, -self.deceleration))

    def shapes(self) -> Shapes:
        """Return the constants of d2 and d6, and the quarter sines of d1 and d3, d5 and d7."""
        d1, d2, d3, _, d5, d6, d7 = self.durations
        return Shapes(flat_up=d2, flat_down=d6, sine_up=d1 + d3, sine_down=d5 + d7)


def _lobe(first: float, constant: float, last: float, height: float) -> Iterator[Piece]:
    """Yield a quarter sine from 0 to a height, the height, and a quarter sine back to 0."""
    yield Piece(first, amplitude=height, omega=QUARTER / first if first else 0.0)
    yield Piece(constant, (height, 0.0, 0.0, 0.0))
    yield Piece(last, amplitude=height, omega=QUARTER / last if last else 0.0, phase=QUARTER)


def _column(stage: Stage, sign: float, origin: float, amplitude: float, base: float) -> tuple[float, ...]:
    begin, r, x0, c, v0, s0 = stage
    return sign, origin - begin, amplitude, base, 1.0 / r if r else 0.0, r, x0, c, v0, s0


ENTRY = Entry(
    law=ModifiedTrapezoidal,
    aliases=("ModTVP", "modified trapezoidal acceleration", "modified trapezoid"),
    source="S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'; S3, figure 2, 'ModTVP'",
    claims=Claims(
        order_ends=2,
        order_inside=3,  # with equal sines at the middle; else 2
        where={"y": "2/(1 + pi + sqrt((1 + pi)**2 + 8))"},  # sin x where v·a is greatest
        coefficients={
            "cv": "2",
            "ca_max": "8*pi/(2 + pi)",
            "ca_min": "-ca_max",
            "ca_rms": "ca_max*sqrt(3)/2",
            "cj": "4*pi*ca_max",
            "va_max": "ca_max**2/(4*pi)*(1 + pi + y)*sqrt(1 - y**2)",
            "va_min": "-va_max",
        },
    ),
    example=ModifiedTrapezoidal,
    others=tuple(
        ModifiedTrapezoidal(durations)
        for durations in (
            (0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1),
            (0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2),
            (0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0),
            (0.0, 0.0, 0.4, 0.1, 0.0, 0.5, 0.0),
        )
    ),
)
