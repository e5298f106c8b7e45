"""Phases joined into a motion over an abscissa: y = h s(ξ) + what came before (S3, with its misprint mended)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws import Law, law
from engine.laws.base import BREAK_TOLERANCE

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Phase:
    """One phase: a law, its lift (m, rad …) and its duration, in units of the abscissa (rad, s, m …)."""

    law: Law
    lift: float
    duration: float

    def __post_init__(self) -> None:
        if not self.duration > 0:
            raise ValueError(f"phase {self.law.code}: expected a duration above 0, found {self.duration:g}")


class MotionValues(NamedTuple):
    """Position and its first two derivatives: per unit of the abscissa, or of time."""

    y: Any
    y1: Any
    y2: Any


class MotionSamples(NamedTuple):
    """N samples of a motion over its whole abscissa."""

    abscissa: Array
    y: Array
    y1: Array
    y2: Array


@dataclass(frozen=True)
class Junction:
    """Where phase ``before`` ends and phase ``after`` begins: the steps of y, y', y'' from one to the other."""

    x: float
    before: int
    after: int
    jump_y: float
    jump_v: float
    jump_a: float


class Motion:
    """Phases one after the other, each beginning where the lifts before it add up to.

    A law that does not reach s = 1 shows as a jump of position at the end of its phase. At a junction the
    values are those of the later phase; a sample within 1e-12 of the whole abscissa counts as on it.
    """

    def __init__(self, phases: Sequence[Phase], start: float = 0.0, position: float = 0.0) -> None:
        edges = start + np.concatenate([[0.0], np.cumsum([p.duration for p in phases])])
        self._set(tuple(phases), edges, position)

    @classmethod
    def from_edges(
        cls, edges: ArrayLike, lifts: Sequence[float], laws: Sequence[Law], position: float = 0.0
    ) -> Motion:
        """Return the motion whose phase k lies between ``edges[k]`` and ``edges[k + 1]``, to the last bit.

        Raises ValueError where the lengths do not match, or the edges do not rise.
        """
        x = np.asarray(edges, dtype=np.float64)
        if not len(x) - 1 == len(lifts) == len(laws):
            raise ValueError(
                f"{len(x) - 1} phases between edges, but {len(lifts)} lifts and {len(laws)} laws"
            )
        motion = cls.__new__(cls)
        phases = tuple(Phase(w, float(h), float(d)) for w, h, d in zip(laws, lifts, np.diff(x), strict=True))
        motion._set(phases, x, position)
        return motion

    def _set(self, phases: tuple[Phase, ...], edges: Array, position: float) -> None:
        if not phases:
            raise ValueError("a motion needs at least one phase")
        self.phases, self.edges = phases, edges
        self.total = float(edges[-1] - edges[0])
        self.positions = position + np.concatenate([[0.0], np.cumsum([p.lift for p in phases])])

    @property
    def lifts_sum(self) -> float:
        """The travel over the whole abscissa."""
        return float(self.positions[-1] - self.positions[0])

    def phase_index(self, x: ArrayLike) -> NDArray[np.intp]:
        """Return the phase, from 0, of each abscissa; raise ValueError outside the motion."""
        values = np.asarray(x, dtype=np.float64)
        near = BREAK_TOLERANCE * self.total
        if values.size and not (
            values.min() >= self.edges[0] - near and values.max() <= self.edges[-1] + near
        ):
            raise ValueError(
                f"the abscissa must lie in [{self.edges[0]:g}, {self.edges[-1]:g}], "
                f"found values from {values.min():g} to {values.max():g}"
            )
        inside = np.minimum(values + near, self.edges[-1] - near)
        return np.searchsorted(self.edges, inside, side="right") - 1

    def xi(self, x: ArrayLike) -> Any:
        """Return the abscissa of each sample within its phase, from 0 to 1."""
        values, k = np.asarray(x, dtype=np.float64), self.phase_index(x)
        xi = (values - self.edges[k]) / (self.edges[k + 1] - self.edges[k])
        return np.clip(xi, 0.0, 1.0)

    def at(self, x: ArrayLike) -> MotionValues:
        """Return y, y', y'' at ``x``: floats for a scalar, else arrays of its shape. ValueError outside."""
        given = np.asarray(x, dtype=np.float64)
        flat = given.reshape(-1)
        k, xi = self.phase_index(flat), self.xi(flat)
        out = np.empty((3, flat.size))
        for i in np.unique(k):
            here, phase = k == i, self.phases[i]
            s, v, a, _ = phase.law.evaluate(xi[here])
            out[0, here] = self.positions[i] + phase.lift * s
            out[1, here] = phase.lift / phase.duration * v
            out[2, here] = phase.lift / phase.duration**2 * a
        if given.ndim == 0:
            return MotionValues(*(float(row[0]) for row in out))
        return MotionValues(*(row.reshape(given.shape) for row in out))

    def at_speed(self, x: ArrayLike, speed: float) -> MotionValues:
        """Return y, dy/dt, d²y/dt² where the abscissa runs at a constant ``speed``: ẏ = y'ω, ÿ = y''ω² (S1)."""
        y, y1, y2 = self.at(x)
        return MotionValues(y, y1 * speed, y2 * speed**2)

    def junctions(self) -> tuple[Junction, ...]:
        """Return the jumps at every junction; the last is the wrap from the end to the begin.

        There ``jump_y`` is what is missing for the cycle to close: y(begin) − y(end).
        """
        return tuple(self._junction(k, (k + 1) % len(self.phases)) for k in range(len(self.phases)))

    def _junction(self, before: int, after: int) -> Junction:
        one, two = self.phases[before], self.phases[after]
        end, start = one.law.end, two.law.start
        reached = self.positions[before] + one.lift * end.s
        begins = self.positions[after] + two.lift * start.s
        return Junction(
            x=float(self.edges[before + 1]),
            before=before,
            after=after,
            jump_y=float(begins - reached),
            jump_v=two.lift / two.duration * start.v - one.lift / one.duration * end.v,
            jump_a=two.lift / two.duration**2 * start.a - one.lift / one.duration**2 * end.a,
        )


def motionlaw(
    laws: Sequence[str],
    lifts: Sequence[float],
    durations: Sequence[float],
    n: int,
    parameters: Mapping[str, Mapping[str, Any]] | None = None,
) -> MotionSamples:
    """Return ``n`` samples of a motion composed of named laws: S3's function of the same name.

    ``parameters`` gives a law's own parameters by its name. Velocity is per unit of the abscissa,
    acceleration per its square. Raises ValueError where the lists differ in length or ``n`` < 2,
    UnknownLawError for a name that no law has.
    """
    if not len(laws) == len(lifts) == len(durations):
        raise ValueError(
            f"laws, lifts and durations must be of the same length; found {len(laws)}, {len(lifts)} and {len(durations)}"
        )
    if n < 2:
        raise ValueError(f"expected at least 2 samples, found {n}")
    given = parameters or {}
    motion = Motion(
        [Phase(law(w, **given.get(w, {})), h, d) for w, h, d in zip(laws, lifts, durations, strict=True)]
    )
    x = np.linspace(0.0, motion.total, n)
    return MotionSamples(x, *motion.at(x))
