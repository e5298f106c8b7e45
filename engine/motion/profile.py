"""A motion as a cam profile: its pieces in an array."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from engine.laws.base import Array
from engine.motion.motion import Motion
from engine.motion.phase import MotionValues
from engine.motion.pieces import MotionPiece, motion_pieces

SAME = 1e-12  # share of the cycle: breaks that are nearer to each other count as the same


@dataclass(frozen=True, eq=False)
class CamProfile:
    """A cam y(x) in n pieces, y = Σ c_k u^k + Σ A sin(ωu + φ); the first and the last extend beyond the range."""

    edges: Array  # x of the breaks, rising: shape (n + 1,)
    origins: Array  # x at which u = 0 on each piece: shape (n,)
    c: Array  # c_0, c_1 …: shape (n, powers)
    sines: Array  # A, ω, φ (rad) of each sine: shape (n, sines, 3)

    @property
    def total(self) -> float:
        """Length of the cycle."""
        return float(self.edges[-1] - self.edges[0])

    @property
    def travel(self) -> float:
        """Travel of a cycle, y(end) − y(begin)."""
        begin, end = self.at(self.edges[:1]).y, self.at(self.edges[-1:], left=True).y
        return float(end[0] - begin[0])

    def index(self, x: Array, left: bool = False) -> NDArray[np.intp]:
        """Return the number of the piece at each x; at a break the piece after it, or with ``left`` before it."""
        after = np.searchsorted(self.edges, x, side="left" if left else "right") - 1
        return np.clip(after, 0, len(self.origins) - 1)

    def at(self, x: Array, left: bool = False) -> MotionValues[Array]:
        """Return y, y', y'', y''' at x; at a jump the value after it, or with ``left`` before it."""
        powers = self.taylor(x, self.index(x, left), 4)
        return MotionValues(*(math.factorial(n) * row for n, row in enumerate(powers)))

    def taylor(self, x: Array, k: NDArray[np.intp], terms: int) -> Array:
        """Return the Taylor coefficients of y about each x.

        Parameters
        ----------
        x : array (n,)
            Abscissae.
        k : array (n,) of int
            The piece in which each lies.
        terms : int

        Returns
        -------
        array (terms, n)
        """
        u, c, sines = x - self.origins[k], self.c[k].T, self.sines[k]
        values = np.zeros((terms, x.size))
        for power in range(min(terms, len(c))):
            value = np.zeros(x.size)
            for higher in range(len(c) - 1, power - 1, -1):
                value = value * u + math.comb(higher, power) * c[higher]
            values[power] = value
        for a, w, phi in np.moveaxis(sines, 1, 0).transpose(0, 2, 1):
            size = a.copy()
            for power in range(terms):
                values[power] += size * np.sin(w * u + phi + power * math.pi / 2.0)
                size = size * w / (power + 1)
        return values

    def in_units(self, x: float, y: float) -> Self:
        """Return it in other units: ``x`` and ``y`` are what its units of abscissa and position are in them."""
        c = self.c * y / x ** np.arange(self.c.shape[1])
        return type(self)(self.edges * x, self.origins * x, c, self.sines * [y, 1.0, 1.0] / [1.0, x, 1.0])

    def shifted(self, by: float, travel: float | None = None) -> Self:
        """Return y(x − by), the cycle later by an abscissa, over the same range.

        A piece that runs over the end of the cycle is cut there, and begins the range lower by the travel of a cycle:
        by default the profile's own, from which the sum of lifts differs if the last law does not end at 1.
        """
        begin, end, total = float(self.edges[0]), float(self.edges[-1]), self.total
        travel = self.travel if travel is None else travel
        whole = math.floor(by / total + SAME)
        by -= whole * total
        c = np.concatenate([self.c, self.c])  # of the cycle before, and of this
        c[:, 0] -= np.repeat([whole + 1, whole], len(self.c)) * travel
        edges, origins = (np.concatenate([x + by - total, x + by]) for x in (self.edges[:-1], self.origins))
        ends = np.append(edges[1:], end + by)
        inside = (ends > begin + SAME * total) & (edges < end - SAME * total)
        edges = np.concatenate([[begin], edges[inside][1:], [end]])
        return type(self)(edges, origins[inside], c[inside], np.concatenate([self.sines, self.sines])[inside])


def profile_of(pieces: Sequence[MotionPiece], end: float) -> CamProfile:
    """Return the pieces of any duration as a profile in their units; ``end`` is the abscissa where the last ends."""
    lasting = [piece for piece in pieces if piece.duration > 0.0]
    ends = [*(piece.begin for piece in lasting[1:]), np.inf]
    least = SAME * abs(end - lasting[0].begin)
    parts = [piece for piece, after in zip(lasting, ends, strict=True) if after - piece.begin > least]
    c, sines = np.array([piece.c for piece in parts]), np.array([piece.sines for piece in parts])
    sines[sines[:, :, 0] == 0.0] = 0.0
    sines = sines[:, sines.any(axis=(0, 2))]
    edges = np.array([*(piece.begin for piece in parts), end])
    last = int(np.flatnonzero(c.any(axis=0)).max(initial=0))
    return CamProfile(edges, np.array([piece.origin for piece in parts]), c[:, : last + 1], sines)


def profile_of_motion(motion: Motion) -> CamProfile:
    """Return a motion as a profile, in its units."""
    return profile_of(motion_pieces(motion, whole=True), float(motion.edges[-1]))
