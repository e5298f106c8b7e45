"""The base class of motion laws: s, v, a, j over ξ in [0, 1], coefficients, names and source, all by its pieces."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import cached_property
from itertools import accumulate
from typing import ClassVar, NamedTuple

import numpy as np

from engine.laws.base import Array, Coefficients, Kinematics, Real, require_within, stage_of, unwrap
from engine.laws.extremes import coefficients_of
from engine.laws.piece import POWERS, Piece, PlacedPiece, placed_pieces


class Vendors(NamedTuple):
    """Names of a law in vendors' cam editors, with its number there; empty if there is none or the match is unsure.

    Sources: simatic-ax/lcamhdl, LCamHdl_ProfileConstants; Beckhoff Infosys, MC_MotionFunctionType; CODESYS, segment
    types of SM3_CamBuilder; SEW 27800520, aCamSegment.
    """

    siemens: str = ""
    twincat: str = ""
    codesys: str = ""
    sew: str = ""


class Law(ABC):
    """A motion law s(ξ), ξ = t/t_a from 0 to 1, from s(0) = 0: a family states names, source and pieces."""

    numbered: ClassVar[list[type["Law"]]] = []  # the classes that state a number: the laws of the catalogue
    number: ClassVar[int]  # place in the catalogue, from 1
    code: ClassVar[str]  # three letters
    name: ClassVar[str]
    aliases: ClassVar[tuple[str, ...]] = ()  # other names that documents give it
    source: ClassVar[str]
    vendors: ClassVar[Vendors] = Vendors()

    def __init_subclass__(cls) -> None:
        if "number" in cls.__dict__:
            cls.numbered.append(cls)

    @abstractmethod
    def as_pieces(self) -> tuple[Piece, ...]:
        """Return the law as pieces, each a polynomial and sines; the cells of its page hold the same."""

    def monotone_pieces(self) -> tuple[Piece, ...]:
        """Return the pieces, cut where the acceleration is largest or lowest, so that it is monotone on each.

        Sines are cut at quarter turns, polynomials at their peaks. Laws that are entered piece by piece, and
        polynomials with boundary values, are not cut.
        """
        return self.as_pieces()

    @property
    def entry_velocity(self) -> float:
        """Velocity at ξ = 0."""
        return 0.0

    @property
    def fixes_ends(self) -> bool:
        """Whether the law sets the rates at its ends by itself, whatever its neighbours are."""
        return False

    @property
    def adjacent_accelerations(self) -> tuple[float, float]:
        """Accelerations before ξ = 0 and after ξ = 1; a jumps at an end where the law's own differs."""
        return 0.0, 0.0

    @cached_property
    def breaks(self) -> tuple[float, ...]:
        """Every ξ between 0 and 1 at which the formula changes, in order; a piece without duration repeats a ξ."""
        return tuple(accumulate(piece.duration for piece in self.as_pieces()[:-1]))

    def evaluate(self, xi: Real) -> Kinematics[Real]:
        """Return s, v, a, j at ξ: floats for a number, else arrays of ξ's shape. Raises ValueError outside 0 to 1."""
        x = np.asarray(xi, dtype=np.float64)
        require_within(0.0, 1.0, xi=x)
        values = self._at(np.clip(x.reshape(-1), 0.0, 1.0))
        return Kinematics(*unwrap(xi, [row.reshape(x.shape) for row in values]))

    def _at(self, xi: Array) -> Sequence[Array]:
        """Return s, v, a, j of a flat array of ξ in [0, 1].

        The sign ± is + for pieces placed from the begin and − for those placed from the end. With u, the time since
        that end of a piece, and x = ωu + φ, s = S0 ± (u (S1 + Σ c_i uⁱ⁺¹/((i + 1)(i + 2))) − Σ P/ω² sin x).
        """
        starts, columns, powers = self._table
        sign, origin, s0, s1, *more = columns.take(stage_of(xi, starts), axis=1) if len(starts) > 1 else columns
        u = sign * xi + origin
        s, v, a, j = (np.zeros_like(u) for _ in range(4))
        for i in range(powers - 1, -1, -1):
            s = s * u + more[i] * (1.0 / ((i + 1) * (i + 2)))
            v = v * u + more[i] * (1.0 / (i + 1))
            j = j * u + a if i < powers - 1 else j
            a = a * u + more[i]
        s, v = u * (s1 + u * s), s1 + u * v
        for k in range(powers, len(more), 4):
            p, r, w, phi = more[k : k + 4]
            x = w * u + phi
            sin, cos = p * np.sin(x), p * np.cos(x)
            s, v, a, j = s - r * r * sin, v - r * cos, a + sin, j + w * cos
        return s0 + sign * s, v, sign * a, j

    @property
    def _placed(self) -> tuple[list[PlacedPiece], list[PlacedPiece], float]:
        """Pieces placed from ξ = 0; pieces placed backwards from ξ = 1, where the law is then exact; s(1)."""
        return placed_pieces(self.as_pieces(), self.entry_velocity), [], 1.0

    @cached_property
    def _table(self) -> tuple[Array, Array, int]:
        """Begins of the pieces; columns of ±1, origin, S0, S1, the powers in use, and P, 1/ω, ω, φ of the sines in use.

        A piece placed from the end is s(1) − r(1 − ξ), r the position of the reversed law.
        """
        early, back, end = self._placed
        pieces = [*early, *(late := back[::-1])]
        c = np.array([place.piece.row[:POWERS] for place in pieces]).T
        powers = int(np.flatnonzero(c.any(axis=1)).max(initial=-1)) + 1
        waves = [[(p, 1.0 / w, w, phi) if w else (0.0,) * 4 for p, w, phi in place.piece.both] for place in pieces]
        where = [(1.0, -place.begin, *place.constants) for place in early]
        where += [(-1.0, 1.0 - place.begin, end - place.constants[0], place.constants[1]) for place in late]
        starts = [place.begin for place in early] + [1.0 - place.begin - place.piece.duration for place in late]
        sines = (sine for sine in np.array(waves).transpose(1, 2, 0) if sine[0].any())
        return np.array(starts), np.vstack([np.array(where).T, c[:powers], *sines]), powers

    def s(self, xi: Real) -> Real:
        """Return the position s(ξ)."""
        return self.evaluate(xi).s

    def v(self, xi: Real) -> Real:
        """Return the velocity v = ds/dξ."""
        return self.evaluate(xi).v

    def a(self, xi: Real) -> Real:
        """Return the acceleration a = dv/dξ."""
        return self.evaluate(xi).a

    def j(self, xi: Real) -> Real:
        """Return the jerk j = da/dξ within the pieces; a jump of a adds no value."""
        return self.evaluate(xi).j

    @cached_property
    def coefficients(self) -> Coefficients:
        """The exact coefficients C_v, C_a, C_a,rms, C_j, max(v·a)."""
        return coefficients_of(self.as_pieces(), self.entry_velocity, *self.adjacent_accelerations)

    @cached_property
    def start(self) -> Kinematics[float]:
        """Values at ξ = 0."""
        return self.evaluate(0.0)

    @cached_property
    def end(self) -> Kinematics[float]:
        """Values at ξ = 1, from the left."""
        return self.evaluate(1.0)
