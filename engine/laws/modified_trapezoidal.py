"""Modified trapezoidal acceleration with seven durations (MTP)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, Claims, Coefficients, Entry, Law, stage_of

SUM_TOLERANCE = 1e-9
K = 2.0 / math.pi  # mean of a quarter sine
QUARTER = math.pi / 2.0
CLASSIC = (1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8)


class Lobe(NamedTuple):
    """Three stages of unit acceleration from rest: a quarter sine up, a constant, a quarter sine down.

    With t from its begin, a = sin x, where the angle x turns from 0 to π/2 over d1, stands over d2, and
    turns on to π over d3. So a deceleration is the same thing seen backwards from its end.
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
    def power(self) -> float:
        """Largest v·a: on the last quarter, cos x (v2 + g sin x) with 2g sin²x + v2 sin x = g."""
        v2, g = self.velocities[1], K * self.d3
        sin = 2.0 * g / (v2 + math.hypot(v2, math.sqrt(8.0) * g))
        return math.sqrt(1.0 - sin * sin) * (v2 + g * sin)

    @property
    def jerk(self) -> float:
        """Largest |j|; infinite without both quarter sines."""
        shorter = min(self.d1, self.d3)
        return 1.0 / (K * shorter) if shorter > 0.0 else math.inf

    def rows(self, amplitude: float, sign: float, origin: float, s: float) -> list[tuple[float, ...]]:
        """Return the coefficients by which :meth:`ModifiedTrapezoidal._block` evaluates the three stages."""
        (v1, v2, _), (s1, s2, _) = self.velocities, self.travels
        r1, r3 = K * self.d1, K * self.d3
        begins = (0.0, self.d1, self.d1 + self.d2)
        parts = ((0.0, r1, 0.0, r1, 0.0), (s1, v1, 1.0, 0.0, QUARTER), (s2 + r3 * r3, v2, 0.0, r3, QUARTER))
        f = amplitude
        return [
            (sign, origin - t, 1.0 / r if r else 0.0, x,
             s + sign * f * s0, f * v0, f * c, f * r, sign * f * r * r, sign * f, f / r if r else 0.0)
            for t, (s0, v0, c, r, x) in zip(begins, parts, strict=True)
        ]  # fmt: skip


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

    @cached_property
    def _stages(self) -> tuple[Array, Array]:
        """Begin of each stage, and its coefficients: one column a stage."""
        rise, fall = self.lobes
        up, down = self.acceleration, self.deceleration
        accelerated = sum(self.durations[:3])
        coast = (1.0, -accelerated, 0.0, 0.0, up * rise.travels[2], up * rise.velocities[2], 0, 0, 0, 0, 0)
        backwards = fall.rows(down, -1.0, sum(self.durations), 1.0)[::-1]
        starts = np.cumsum((0.0, *self.durations[:6]))
        return starts, np.array([*rise.rows(up, 1.0, 0.0, 0.0), coast, *backwards]).T.copy()

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        starts, table = self._stages
        sign, origin, rate, x0, s0, v0, c, q, r, p, w = table.take(stage_of(xi, starts), axis=1)
        t = sign * xi + origin  # since the begin of the stage, or until its end
        x = rate * t + x0
        sin, cos = np.sin(x), np.cos(x)
        s = s0 + sign * t * (v0 + c / 2.0 * t) - r * sin
        return s, v0 + c * t - q * cos, p * sin, w * cos

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
)
