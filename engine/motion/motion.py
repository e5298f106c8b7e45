"""Phases joined into a motion over an abscissa: the angle of a shaft, time, or the travel of a product."""

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from engine.laws import Law, law
from engine.laws.base import BREAK_TOLERANCE, Array, Real, require_finite, require_within, unwrap
from engine.laws.points import reach
from engine.motion.phase import MotionValues, Phase, PhaseEnds, phases_of

ZERO_TOLERANCE = 1e-9  # of the largest lift: a smaller jump is none


class Motion:
    """Phases in succession: y = y_k + h s(ξ), y' = h v(ξ)/δ, y'' = h a(ξ)/δ², ξ = (x − x_k)/δ.

    Each phase begins at the sum of the lifts before it. (S3's listing lacks this sum, so a dwell after a rise would be
    at 0.) The motion is right-continuous at the edges; at the last edge it has the left limit.
    Source: S3, function motionlaw.

    Parameters
    ----------
    phases : sequence of Phase
        At least one.
    start : float
        Abscissa of the begin, in its unit.
    position : float
        y at the begin, in the unit of the lifts.
    edges : array, optional
        Abscissae of the begin of each phase and of the end, if they are known more exactly than by the durations.

    Raises
    ------
    ValueError
        If there are no phases, or a number is not finite.
    """

    def __init__(
        self, phases: Sequence[Phase], start: float = 0.0, position: float = 0.0, edges: Array | None = None
    ) -> None:
        if not phases:
            raise ValueError("a motion has no phases; expected at least one")
        self.phases, self.position = tuple(phases), position
        self.edges = start + np.cumsum([0.0, *(p.duration for p in phases)]) if edges is None else edges
        require_finite(start=float(self.edges[0]), position=position)
        self.edges.flags.writeable = False

    @classmethod
    def from_edges(cls, edges: ArrayLike, lifts: Sequence[float], laws: Sequence[Law], position: float = 0.0) -> Self:
        """Return the motion of phases between edges that are held exactly.

        Parameters
        ----------
        edges : array (n + 1,)
            Abscissae at which phases begin and end.
        lifts : sequence of float, n
        laws : sequence of Law, n
        position : float
            y at the first edge.

        Raises
        ------
        ValueError
            Where the edges do not rise, or their number does not suit.
        """
        bounds = np.array(edges, dtype=np.float64)
        if not len(bounds) - 1 == len(lifts) == len(laws):
            raise ValueError(
                f"{len(bounds)} edges, {len(lifts)} lifts and {len(laws)} laws are given; "
                "expected one lift and one law between each two edges"
            )
        rows = zip(laws, map(float, lifts), np.diff(bounds).tolist(), strict=True)
        return cls(phases_of(rows), position=position, edges=bounds)

    @cached_property
    def total(self) -> float:
        """Length of the abscissa, in its unit."""
        return float(self.edges[-1] - self.edges[0])

    @property
    def tolerance(self) -> float:
        """Distance from an edge within which a place counts as on it, in units of the abscissa."""
        return BREAK_TOLERANCE * self.total

    @cached_property
    def lifts_sum(self) -> float:
        """Sum of the lifts, the travel of a cycle."""
        return math.fsum(p.lift for p in self.phases)

    @cached_property
    def _begins(self) -> Array:
        """Position at the begin of each phase."""
        return self.position + np.cumsum([0.0, *(p.lift for p in self.phases[:-1])])

    @cached_property
    def ends(self) -> tuple[PhaseEnds, ...]:
        """y, y', y'', y''' at the begin and at the end of each phase, of its law at ξ = 0 and 1."""
        return tuple(
            PhaseEnds(*(phase.values(y, at) for at in (phase.law.start, phase.law.end)))
            for phase, y in zip(self.phases, self._begins.tolist(), strict=True)
        )

    @cached_property
    def peaks(self) -> MotionValues[float]:
        """Largest |h|, |y'|, |y''| and |y'''| of any phase, exact by the laws' coefficients."""
        peaks = [(abs(p.lift), p.y1_max, p.y2_max, p.y3_max) for p in self.phases]
        return MotionValues(*map(max, zip(*peaks, strict=True)))

    @cached_property
    def reaches(self) -> tuple[tuple[float, float], ...]:
        """The lowest and the highest position of each phase."""
        reaches = []
        for phase, y in zip(self.phases, self._begins.tolist(), strict=True):
            ends = [y + phase.scale * s for s in reach(phase.law)]
            reaches.append((min(ends), max(ends)))
        return tuple(reaches)

    @property
    def reach(self) -> tuple[float, float]:
        """The lowest and the highest position of the motion."""
        return min(low for low, _ in self.reaches), max(high for _, high in self.reaches)

    @cached_property
    def y2_rms(self) -> float:
        """RMS of y'' over the motion, √(Σ y''²_rms δ / Σδ), exact by the laws' coefficients."""
        return math.sqrt(math.fsum(p.y2_rms**2 * p.duration for p in self.phases) / self.total)

    def size(self, order: int) -> float:
        """Return the largest |h|/δⁿ of any phase for the order n; 1 if no phase moves."""
        return max((abs(p.lift) / p.duration**order for p in self.phases if p.lift), default=1.0)

    @property
    def gap(self) -> float:
        """Error of closure, y(end) − y(begin)."""
        return self.ends[-1].end.y - self.ends[0].begin.y

    @property
    def closes(self) -> bool:
        """Whether the end of the cycle joins its begin without a jump of position."""
        return abs(self.gap) <= ZERO_TOLERANCE * self.peaks.y

    @property
    def complete(self) -> bool:
        """Whether every law reaches its lift: there is no jump of position between the phases."""
        return all(abs(p.missing_lift) <= ZERO_TOLERANCE * self.peaks.y for p in self.phases)

    def at(self, x: Real) -> MotionValues[Real]:
        """Return y, y', y'', y''' at x: floats for a number, else arrays. Raises ValueError outside the abscissa."""
        at = np.asarray(x, dtype=np.float64)
        flat = at.reshape(-1)
        require_within(float(self.edges[0]), float(self.edges[-1]), x=flat)
        after = np.searchsorted(self.edges, flat + self.tolerance, side="right") - 1
        index = np.clip(after, 0, len(self.phases) - 1)
        durations = np.array([p.duration for p in self.phases])
        xi = np.clip((flat - self.edges[index]) / durations[index], 0.0, 1.0)
        table = np.empty((4, flat.size))
        for k in np.unique(index):
            here, phase = index == k, self.phases[k]
            table[:, here] = phase.values(self._begins[k], phase.law.evaluate(xi[here]))
        return MotionValues(*unwrap(x, [row.reshape(at.shape) for row in table]))

    def at_speed(self, x: Real, speed: float) -> tuple[Real, Real, Real, Real]:
        """Return y, ẏ = y' w, ÿ = y'' w² and the jerk y''' w³ at x, w the constant speed of the abscissa (unit/s)."""
        y, y1, y2, y3 = self.at(x)
        return y, y1 * speed, y2 * speed**2, y3 * speed**3


class MotionSamples(NamedTuple):
    """A motion sampled at equal steps of its abscissa: arrays of shape (n,), in the units of the lists."""

    abscissa: Array
    y: Array
    y1: Array  # y'
    y2: Array  # y''
    y3: Array  # y'''


def motionlaw(
    laws: Sequence[str],
    lifts: Sequence[float],
    durations: Sequence[float],
    n: int,
    parameters: Sequence[Mapping[str, Any] | None] | None = None,
) -> MotionSamples:
    """Return samples of a motion whose phases are given by lists.

    Source: S3, function motionlaw, with its misprint corrected (see :class:`engine.motion.Motion`).

    Parameters
    ----------
    laws : sequence of str
        Names of the catalogue, for each phase.
    lifts, durations : sequence of float
        One for each phase, in any unit of y and of the abscissa.
    n : int
        Number of samples at equal steps, at least 2.
    parameters : sequence of mapping or None
        Parameters of each phase's law.

    Returns
    -------
    MotionSamples
        Abscissa, y and its first three derivatives.

    Raises
    ------
    UnknownLawError
        If a name is not in the catalogue.
    ValueError
        For lists of unequal length, fewer than two samples, or an impossible phase; the message says which.
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
    settings = [None] * len(laws) if parameters is None else parameters
    laws_of_phases = (law(name, **(more or {})) for name, more in zip(laws, settings, strict=True))
    motion = Motion(phases_of(zip(laws_of_phases, lifts, durations, strict=True)))
    abscissa = np.linspace(0.0, motion.total, n)
    return MotionSamples(abscissa, *motion.at(abscissa))
