"""Modified trapezoidal acceleration with seven durations (MTP): S1, S3 figure 2."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf, pi, sqrt
from typing import ClassVar

import numpy as np

from engine.laws.base import BREAK_TOLERANCE, Array, Coefficients, Law

CLASSIC = (1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8)
K = 2 / pi  # the mean of a quarter sine


@dataclass(frozen=True)
class Lobe:
    """A lobe of unit acceleration from rest: quarter sine up, constant, quarter sine down.

    With p the share of the first part that has passed, q that of the third::

        a = sin(πp/2) cos(πq/2)

    so that v and s follow in closed form without a case for each part. ``closed`` tells that time never runs
    past the end: there a third part without duration belongs to what follows, not to the lobe.
    """

    up: float
    flat: float
    down: float
    closed: bool

    @property
    def speed(self) -> float:
        """The velocity gained over the lobe."""
        return K * self.up + self.flat + K * self.down

    @property
    def stroke(self) -> float:
        """The travel over the lobe."""
        first = K * (1 - K) * self.up**2
        second = K * self.up * self.flat + self.flat**2 / 2
        return first + second + (K * self.up + self.flat) * self.down + (K * self.down) ** 2

    @property
    def power(self) -> float:
        """The largest v·a: on the third part, where 2G sin²x + v₂ sin x = G with v₂ the velocity at its begin."""
        v, gain = K * self.up + self.flat, K * self.down
        sine = 2 * gain / (v + sqrt(v * v + 8 * gain * gain)) if v or gain else 0.0
        return sqrt(1 - sine * sine) * (v + gain * sine)

    @property
    def mean_square(self) -> float:
        """∫a² over the lobe."""
        return self.up / 2 + self.flat + self.down / 2

    @property
    def jerk(self) -> float:
        """The largest |j|; infinite where a part without duration makes a jump."""
        shortest = min(self.up, self.down)
        return pi / 2 / shortest if shortest > 0 else inf

    def kinematics(self, t: Array) -> tuple[Array, Array, Array, Array]:
        """Return s, v, a, j at times ``t`` from the lobe's begin, and of the uniform motion that follows it."""
        second, third = self.up, self.up + self.flat
        n = t - third
        if self.up > 0:
            p = np.minimum(t, second) * (pi / 2 / self.up)
            sin_p, cos_p = np.sin(p), np.cos(p)
        else:
            sin_p, cos_p = np.ones_like(t), np.zeros_like(t)
        if self.down > 0:
            within = np.maximum(n, 0.0)
            q = np.minimum(within, self.down) * (pi / 2 / self.down)
            sin_q, cos_q = np.sin(q), np.cos(q)
        else:
            within = np.maximum(n, 0.0)
            past = (n >= -BREAK_TOLERANCE) & (not self.closed)
            sin_q, cos_q = past.astype(float), (~past).astype(float)
        k1, k3 = K * self.up, K * self.down
        m = np.clip(t - second, 0.0, self.flat)
        v2 = k1 + self.flat
        v = k1 * (1 - cos_p) + m + k3 * sin_q
        s = k1 * (np.minimum(t, second) - k1 * sin_p) + m * (k1 + m / 2) + within * v2
        if self.down > 0:
            s += np.maximum(n - self.down, 0.0) * k3 + k3 * k3 * (1 - cos_q)
        a = sin_p * cos_q
        j = np.zeros_like(t)
        if self.up > 0:
            j += cos_p * (pi / 2 / self.up)
        if self.down > 0:
            inside = True if self.closed else n < self.down - BREAK_TOLERANCE
            j -= np.where(inside, sin_q, 0.0) * (pi / 2 / self.down)
        return s, v, a, j


class ModifiedTrapezoidal(Law):
    """Seven stages: 1, 3, 5, 7 quarter sines, 2 and 6 constant, 4 without acceleration (S3, figure 2).

    ``durations`` d1 … d7, as shares of the rise, are not negative and sum to 1; zeros and asymmetry are allowed.
    With k = 2/π, m = k d1 + d2 + k d3, n = k d7 + d6 + k d5 and S_a, S_d the strokes of both lobes for unit
    acceleration, rest at the end and s(1) = 1 give::

        A = 1 / (S_a + m d4 + (m/n) S_d),   B = A m/n

    The deceleration is the mirror image, in time, of a lobe like the acceleration's.
    Raises ValueError for durations that are not seven, negative, do not sum to 1 within 1e-9, or leave
    stages 1 to 3 or 5 to 7 without any.
    """

    code: ClassVar[str] = "MTP"
    name: ClassVar[str] = "Modified trapezoidal"

    def __init__(self, durations: Sequence[float] = CLASSIC) -> None:
        d = tuple(float(x) for x in durations)
        if len(d) != 7:
            raise ValueError(f"modified trapezoidal: expected seven durations, found {len(d)}")
        if not all(x >= 0 for x in d):
            raise ValueError(f"modified trapezoidal: expected durations of at least 0, found {min(d):g}")
        if abs(sum(d) - 1) > 1e-9:
            raise ValueError(f"modified trapezoidal: expected durations that sum to 1, found {sum(d):.10g}")
        if not sum(d[:3]) or not sum(d[4:]):
            raise ValueError(
                "modified trapezoidal: expected stages 1 to 3, and 5 to 7, of some duration each"
            )
        self.durations = d
        self.rise = Lobe(d[0], d[1], d[2], closed=False)
        self.fall = Lobe(d[6], d[5], d[4], closed=True)
        ratio = self.rise.speed / self.fall.speed
        self.acceleration = 1 / (self.rise.stroke + self.rise.speed * d[3] + ratio * self.fall.stroke)
        self.deceleration = self.acceleration * ratio
        self.fall_begins = d[0] + d[1] + d[2] + d[3]

    def _kinematics(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        falling = xi >= self.fall_begins - BREAK_TOLERANCE
        if not falling.any():
            return self._rising(xi)
        if falling.all():
            return self._falling(xi)
        out = np.empty((4, xi.size))
        rows = np.flatnonzero(~falling)
        out[:, rows] = self._rising(xi[rows])
        rows = np.flatnonzero(falling)
        out[:, rows] = self._falling(xi[rows])
        return out[0], out[1], out[2], out[3]

    def _rising(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        s, v, a, j = self.rise.kinematics(xi)
        return s * self.acceleration, v * self.acceleration, a * self.acceleration, j * self.acceleration

    def _falling(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        s, v, a, j = self.fall.kinematics(1 - xi)
        b = self.deceleration
        return 1 - b * s, b * v, -b * a, b * j

    def _coefficients(self) -> Coefficients:
        a, b, rise, fall = self.acceleration, self.deceleration, self.rise, self.fall
        return Coefficients(
            cv=a * rise.speed,
            ca_max=a,
            ca_min=-b,
            ca_rms=sqrt(a * a * rise.mean_square + b * b * fall.mean_square),
            cj=max(a * rise.jerk, b * fall.jerk),
            va_max=a * a * rise.power,
            va_min=-b * b * fall.power,
        )
