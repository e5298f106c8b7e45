"""Phases joined into a motion over an abscissa: the angle of a shaft, time, or the travel of a product."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Generic, NamedTuple, Self, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws import Dwell, Law, law
from engine.laws.base import Array, Real, require_finite, require_within, unwrap

EDGE_TOLERANCE = 1e-12
"""A sample this near to an edge, in units of the whole abscissa, counts as on it."""


class MotionValues(NamedTuple, Generic[Real]):
    """Position y, geometric velocity y' and acceleration y'', per unit of the abscissa."""

    y: Real
    y1: Real
    y2: Real


class TimeValues(NamedTuple, Generic[Real]):
    """Position y, velocity ẏ and acceleration ÿ in time."""

    y: Real
    v: Real
    a: Real


class MotionSamples(NamedTuple):
    """A motion sampled at equal steps of its abscissa."""

    abscissa: Array
    y: Array
    y1: Array
    y2: Array


@dataclass(frozen=True)
class Phase:
    """A law, carried out over a lift (negative for a return) in a duration (in units of the abscissa).

    Raises ValueError unless the duration is positive, both are finite, and a dwell has no lift.
    """

    law: Law
    lift: float
    duration: float

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


@dataclass(frozen=True)
class Junction:
    """Where phase ``before`` ends and phase ``after`` begins, with the jumps (after less before) at ``x``.

    At the wrap of the cycle, ``jump_y`` is what the cycle does not close by: y(end) − y(start).
    """

    x: float
    before: int
    after: int
    jump_y: float
    jump_v: float
    jump_a: float


class Motion:
    """Phases one after the other: y = y_k + h s(ξ), y' = h v(ξ)/δ, y'' = h a(ξ)/δ², ξ = (x − x_k)/δ.

    The abscissa begins at ``start``, the position at ``position``, and each phase takes over the position
    where the lifts before have brought it. (S3's listing leaves that out, so that a dwell after a rise would
    drop to 0.) Right-continuous at the edges; at the last edge the left limit.
    Raises ValueError for no phases. Source: S3, function motionlaw.
    """

    def __init__(self, phases: Sequence[Phase], start: float = 0.0, position: float = 0.0) -> None:
        self._set(phases, start + np.cumsum([0.0, *(p.duration for p in phases)]), position)

    @classmethod
    def from_edges(cls, edges: ArrayLike, lifts: Sequence[float], laws: Sequence[Law], position: float = 0.0) -> Self:
        """Return the motion whose phases run between ``edges``, one more than lifts and laws, kept exactly.

        Raises ValueError where the numbers do not go together or the edges do not rise.
        """
        bounds = np.array(edges, dtype=np.float64)
        if not len(bounds) - 1 == len(lifts) == len(laws):
            raise ValueError(
                f"{len(bounds)} edges, {len(lifts)} lifts and {len(laws)} laws are given; "
                "expected one lift and one law between each two edges"
            )
        made = []
        for k, (one, lift, duration) in enumerate(zip(laws, lifts, np.diff(bounds), strict=True), 1):
            made.append(_phase(k, one, float(lift), float(duration)))
        motion = cls.__new__(cls)
        motion._set(made, bounds, position)
        return motion

    def _set(self, phases: Sequence[Phase], edges: Array, position: float) -> None:
        if not phases:
            raise ValueError("a motion has no phases; expected at least one")
        require_finite(start=float(edges[0]), position=position)
        self.phases = tuple(phases)
        self.edges = edges
        self.edges.flags.writeable = False
        self.position = position

    @cached_property
    def total(self) -> float:
        """Length of the abscissa."""
        return float(self.edges[-1] - self.edges[0])

    @cached_property
    def lifts_sum(self) -> float:
        """Sum of the lifts: the travel of a cycle."""
        return float(sum(p.lift for p in self.phases))

    @cached_property
    def tolerance(self) -> float:
        """A place this near to an edge counts as on it, in units of the abscissa."""
        return EDGE_TOLERANCE * self.total

    @cached_property
    def _begins(self) -> Array:
        """Position at the begin of each phase."""
        return self.position + np.cumsum([0.0, *(p.lift for p in self.phases[:-1])])

    @overload
    def phase_index(self, x: float) -> int: ...
    @overload
    def phase_index(self, x: Array) -> NDArray[np.intp]: ...
    def phase_index(self, x: float | Array) -> int | NDArray[np.intp]:
        """Return the index of the phase at x: an int of a number, an array of x's shape of an array.

        Raises ValueError outside the abscissa.
        """
        at = np.asarray(x, dtype=np.float64)
        return unwrap(x, [self._locate(at.reshape(-1)).reshape(at.shape)])[0]  # type: ignore[no-any-return]

    def xi(self, x: Real) -> Real:
        """Return ξ, the share of its phase that has passed at x. Raises ValueError outside the abscissa."""
        at = np.asarray(x, dtype=np.float64)
        flat = at.reshape(-1)
        return unwrap(x, [self._share(flat, self._locate(flat)).reshape(at.shape)])[0]  # type: ignore[no-any-return]

    def at(self, x: Real) -> MotionValues[Real]:
        """Return y, y', y'' at x: floats of a number, arrays of x's shape of an array.

        Raises ValueError outside the abscissa.
        """
        at = np.asarray(x, dtype=np.float64)
        flat = at.reshape(-1)
        index = self._locate(flat)
        xi = self._share(flat, index)
        table = np.empty((3, flat.size))
        for k in np.unique(index):
            here, phase = index == k, self.phases[k]
            values = phase.law.evaluate(xi[here])
            per = phase.scale / phase.duration
            table[0, here] = self._begins[k] + phase.scale * values.s
            table[1, here] = per * values.v
            table[2, here] = per / phase.duration * values.a
        return MotionValues(*unwrap(x, [row.reshape(at.shape) for row in table]))

    def at_speed(self, x: Real, speed: float) -> TimeValues[Real]:
        """Return y, ẏ = y' w, ÿ = y'' w² at x, where the abscissa advances at the constant speed w."""
        y, y1, y2 = self.at(x)
        return TimeValues(y, y1 * speed, y2 * speed**2)

    def junctions(self, periodic: bool = True) -> tuple[Junction, ...]:
        """Return the jumps between the phases in order; of a periodic motion, the wrap last."""
        last = len(self.phases) - 1
        found = [self._junction(k, k + 1) for k in range(last)]
        return tuple([*found, self._junction(last, 0)] if periodic else found)

    def _junction(self, before: int, after: int) -> Junction:
        one, other = self.phases[before], self.phases[after]
        y_end = float(self._begins[before]) + one.scale * one.law.end.s
        y_begin = float(self._begins[after]) + other.scale * other.law.start.s
        return Junction(
            x=float(self.edges[before + 1]),
            before=before,
            after=after,
            jump_y=y_begin - y_end if after > before else y_end - y_begin,
            jump_v=other.scale * other.law.start.v / other.duration - one.scale * one.law.end.v / one.duration,
            jump_a=other.scale * other.law.start.a / other.duration**2 - one.scale * one.law.end.a / one.duration**2,
        )

    def _locate(self, x: Array) -> NDArray[np.intp]:
        require_within("x", x, float(self.edges[0]), float(self.edges[-1]), self.tolerance)
        found = np.searchsorted(self.edges, x + self.tolerance, side="right") - 1
        return np.clip(found, 0, len(self.phases) - 1)

    def _share(self, x: Array, index: NDArray[np.intp]) -> Array:
        durations = np.array([p.duration for p in self.phases])
        xi: Array = (x - self.edges[index]) / durations[index]
        return np.minimum(np.maximum(xi, 0.0), 1.0)


def motionlaw(
    laws: Sequence[str],
    lifts: Sequence[float],
    durations: Sequence[float],
    n: int,
    parameters: Sequence[Mapping[str, Any] | None] | None = None,
) -> MotionSamples:
    """Return n samples, at equal steps, of the phases that three lists describe: S3's call in Python.

    ``laws`` are names of the catalogue, ``lifts`` in any unit of y, ``durations`` in any unit of the
    abscissa, ``parameters`` (if given) a mapping or None a phase, handed to its law.
    Raises ValueError for lists of unequal length, fewer than two samples, or a phase that cannot be
    (which says the phase), UnknownLawError for a name that is not in the catalogue.
    Source: S3, function motionlaw, its misprint mended (see :class:`Motion`).
    """
    given = {"laws": laws, "lifts": lifts, "durations": durations}
    if parameters is not None:
        given["parameters"] = parameters
    lengths = {name: len(values) for name, values in given.items()}
    if len(set(lengths.values())) > 1:
        counts = ", ".join(f"{count} {name}" for name, count in lengths.items())
        raise ValueError(f"{counts} are given; expected as many of each")
    if n < 2:
        raise ValueError(f"n is {n}; expected at least 2 samples")
    settings = parameters if parameters is not None else [None] * len(laws)
    phases = [
        _phase(k, law(name, **(more or {})), lift, duration)
        for k, (name, lift, duration, more) in enumerate(zip(laws, lifts, durations, settings, strict=True), 1)
    ]
    motion = Motion(phases)
    abscissa = np.linspace(0.0, motion.total, n)
    return MotionSamples(abscissa, *motion.at(abscissa))


def _phase(number: int, one: Law, lift: float, duration: float) -> Phase:
    try:
        return Phase(one, lift, duration)
    except ValueError as error:
        raise ValueError(f"phase {number}: {error}") from None
