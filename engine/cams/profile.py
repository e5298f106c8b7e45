"""A position over a master in pieces, each a polynomial and sines: a motion, or what rebuilds it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.motion.motion import Motion
from engine.motion.phase import MotionValues
from engine.motion.pieces import MotionPiece, motion_pieces

V = TypeVar("V", float, Array)
SAME = 1e-12
"""of the cycle: breaks so near to each other are one"""


@dataclass(frozen=True, eq=False)
class CamProfile:
    """y(x) from ``edges[0]`` to ``edges[-1]`` in pieces, n of them: y = Σ c_k u^k + Σ A sin(ωu + φ).

    ``edges`` are n + 1 places in rising order, ``origins`` n places from which u counts, ``c`` n rows of powers,
    ``sines`` n rows of sines, each A, ω, φ. Outside its range the first and the last piece go on.
    """

    edges: Array
    origins: Array
    c: Array
    sines: Array

    @property
    def total(self) -> float:
        """Length of the cycle."""
        return float(self.edges[-1] - self.edges[0])

    @property
    def travel(self) -> float:
        """What a cycle does not come back by, y(end) − y(begin)."""
        begin, end = self.at(self.edges[:1]).y, self.at(self.edges[-1:], left=True).y
        return float(end[0] - begin[0])

    def index(self, x: Array, left: bool = False) -> NDArray[np.intp]:
        """Return the piece at each x: the one that begins there, or with ``left`` the one that ends there."""
        found = np.searchsorted(self.edges, x, side="left" if left else "right") - 1
        return np.clip(found, 0, len(self.origins) - 1)

    def at(self, x: Array, left: bool = False) -> MotionValues[Array]:
        """Return y, y', y'', y''' at x: where it jumps what comes after, or with ``left`` what came before."""
        return MotionValues(*(math.factorial(n) * row for n, row in enumerate(self.taylor(x, self.index(x, left), 4))))

    def taylor(self, x: Array, k: NDArray[np.intp], terms: int) -> Array:
        """Return the first coefficients of y in powers of (x − place), a row a power, about places in pieces k."""
        u, c, sines = x - self.origins[k], self.c[k].T, self.sines[k]
        found = np.zeros((terms, x.size))
        for power in range(min(terms, len(c))):
            value = np.zeros(x.size)
            for higher in range(len(c) - 1, power - 1, -1):
                value = value * u + math.comb(higher, power) * c[higher]
            found[power] = value
        for a, w, phi in np.moveaxis(sines, 1, 0).transpose(0, 2, 1):
            size = a.copy()
            for power in range(terms):
                found[power] += size * np.sin(w * u + phi + power * math.pi / 2.0)
                size = size * w / (power + 1)
        return found


def profile_of(pieces: Sequence[MotionPiece], end: float, x: float = 1.0, y: float = 1.0) -> CamProfile:
    """Return a motion's pieces up to ``end`` as a profile in other units: ``x`` and ``y`` of them make one of its own.

    Pieces that do not last are left out.
    """
    lasting = [one for one in pieces if one.duration > 0.0]
    ends = [*(one.begin for one in lasting[1:]), np.inf]
    kept = [one for one, after in zip(lasting, ends, strict=True)
            if after - one.begin > SAME * abs(end - lasting[0].begin)]  # fmt: skip
    c = np.array([one.c for one in kept])
    c = c * y / x ** np.arange(c.shape[1])
    sines = np.array([one.sines for one in kept])
    sines[sines[:, :, 0] == 0.0] = 0.0
    sines = sines[:, sines.any(axis=(0, 2))] * [y, 1.0, 1.0] / [1.0, x, 1.0]
    edges = np.array([*(one.begin for one in kept), end])
    last = int(np.flatnonzero(c.any(axis=0)).max(initial=0))
    return CamProfile(edges * x, np.array([one.origin for one in kept]) * x, c[:, : last + 1], sines)


def profile_of_motion(motion: Motion, x: float = 1.0, y: float = 1.0) -> CamProfile:
    """Return a motion as a profile in other units, x and y of them a unit of its own."""
    return profile_of(motion_pieces(motion, whole=True), float(motion.edges[-1]), x, y)


def in_units(values: MotionValues[V], x: float, y: float) -> MotionValues[V]:
    """Return a motion's values in other units, of which a unit of x and of y has so many."""
    return MotionValues(*(value * (y / x**order) for order, value in enumerate(values)))


def turned(of: CamProfile, by: float, travel: float | None = None) -> CamProfile:
    """Return the profile that a master sees which is ``by`` further on where it begins, over the same range.

    What runs over the end of the cycle is parted there, and goes on from the cycle before by its ``travel``, the
    profile's own unless told: a motion whose last law does not end at 1 jumps there to the sum of its lifts. Of more
    than a cycle, each whole one is a travel less.
    """
    begin, end, total = float(of.edges[0]), float(of.edges[-1]), of.total
    travel = of.travel if travel is None else travel
    whole = math.floor(by / total + SAME)
    by -= whole * total
    c = np.concatenate([of.c, of.c])  # of the cycle before, and of this one
    c[:, 0] -= np.repeat([whole + 1, whole], len(of.c)) * travel
    edges, origins = (np.concatenate([one + by - total, one + by]) for one in (of.edges[:-1], of.origins))
    ends = np.append(edges[1:], end + by)
    kept = (ends > begin + SAME * total) & (edges < end - SAME * total)
    edges = np.concatenate([[begin], edges[kept][1:], [end]])
    return CamProfile(edges, origins[kept], c[kept], np.concatenate([of.sines, of.sines])[kept])
