"""Closed forms stage by stage, evaluated for many ξ at once."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from engine.laws.base import Array, stage_of
from engine.laws.piece import POWERS, Piece, gains_at


class Stage(NamedTuple):
    """A stage with its own time t = sign ξ + origin, counted from its begin, or backwards from its end.

    a = sign (Σ c_i tⁱ + P sin x)      v = v0 + Σ c_i tⁱ⁺¹/(i + 1) − P r cos x
    s = s0 + sign (v0 t + Σ c_i tⁱ⁺²/((i + 1)(i + 2)) − P r² sin x)      x = φ + t/r
    """

    begin: float
    sign: float
    origin: float
    s0: float
    v0: float
    c: tuple[float, ...]
    amplitude: float
    r: float
    phase: float


def carried(pieces: Sequence[Piece], sign: float, edge: float, s: float, v: float) -> Iterator[Stage]:
    """Yield the stages of pieces one after the other from ξ = edge on (sign 1) or back from it (sign −1).

    ``s`` and ``v`` are position and velocity at the edge.
    """
    passed = 0.0
    for p in pieces:
        begin = edge + sign * passed
        amplitude, r = (p.amplitude, 1.0 / p.omega) if p.omega else (0.0, 0.0)
        ds, dv = gains_at(p, p.duration)
        yield Stage(
            begin=begin if sign > 0.0 else begin - p.duration, sign=sign, origin=-sign * begin,
            s0=s + sign * amplitude * r * r * np.sin(p.phase), v0=v + amplitude * r * np.cos(p.phase), c=p.c,
            amplitude=amplitude, r=r, phase=p.phase,
        )  # fmt: skip
        s, v, passed = s + sign * (v * p.duration + ds), v + dv, passed + p.duration


class Staged:
    """Stages in the order of ξ, with no more columns than they use."""

    def __init__(self, stages: Sequence[Stage]) -> None:
        self.starts = np.array([stage.begin for stage in stages])
        c = np.zeros((POWERS, len(stages)))
        for k, stage in enumerate(stages):
            c[: len(stage.c), k] = stage.c
        self.powers = max((i + 1 for i in range(POWERS) if c[i].any()), default=0)
        self.sines = any(stage.amplitude for stage in stages)
        where = [(stage.sign, stage.origin, stage.s0, stage.v0) for stage in stages]
        rate = [(s.amplitude, s.r, 1.0 / s.r if s.r else 0.0, s.phase) for s in stages] if self.sines else []
        self.table = np.vstack([np.array(where).T, c[: self.powers], *([np.array(rate).T] if rate else [])])

    def __call__(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        """Return s, v, a, j of a flat array of ξ."""
        sign, origin, s0, v0, *more = self.table.take(stage_of(xi, self.starts), axis=1)
        t = sign * xi + origin
        travel, v, a, j = _polynomial(t, v0, more[: self.powers])
        if self.sines:
            amplitude, r, rate, phase = more[self.powers :]
            x = phase + rate * t
            sin, cos = amplitude * np.sin(x), amplitude * np.cos(x)
            travel, v, a, j = travel - r * r * sin, v - r * cos, a + sin, j + rate * cos
        return s0 + sign * travel, v, sign * a, j


def _polynomial(t: Array, v0: Array, c: Sequence[Array]) -> tuple[Array, Array, Array, Array]:
    """Return the travel, velocity, acceleration and jerk of Σ c_i tⁱ, entered with v0."""
    s, v, a, j = (np.zeros_like(t) for _ in range(4))
    for i in range(len(c) - 1, -1, -1):
        s = s * t + c[i] * (1.0 / ((i + 1) * (i + 2)))
        v = v * t + c[i] * (1.0 / (i + 1))
        j = j * t + a if i < len(c) - 1 else j
        a = a * t + c[i]
    return t * (v0 + t * s), v0 + t * v, a, j
