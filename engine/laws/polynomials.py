"""Polynomials between prescribed ends: cubic (y, v), quintic (y, v, a) and septic (y, v, a, j): CUB, PO5, PO7."""

from abc import abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from engine.laws.base import Array, Coefficients, Vendors
from engine.laws.ends import REST, EndedLaw, EndError, Ends, require_ends
from engine.laws.halved import HalvedLaw
from engine.laws.piece import Piece
from engine.laws.piece_extremes import coefficients_of
from engine.laws.pulse import HALF_345, HALF_4567, LINE_DOWN
from engine.laws.stages import Staged, carried


@dataclass(frozen=True)
class EndedPolynomial(EndedLaw):
    """The polynomial of least degree between the given ends, in closed form from Hermite's conditions.

    Its extremes are at zeros of its derivatives, found one from the other: those of a of a quintic in closed form
    too, as its jerk is a parabola.
    """

    ends: Ends

    @property
    @abstractmethod
    def polynomial(self) -> tuple[float, ...]:
        """c0, c1, … of a(ξ)."""

    @property
    def own_acceleration(self) -> tuple[bool, bool]:
        """Whether it begins and ends with an acceleration that follows from the other ends."""
        follows = "a" not in self.takes
        return follows, follows

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece."""
        return (Piece(1.0, self.polynomial),)

    @cached_property
    def _staged(self) -> Staged:
        return Staged([*carried(self.as_pieces(), 1.0, 0.0, 0.0, self.ends.v0)])

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        return self._staged(xi)

    def _coefficients(self) -> Coefficients:
        e = self.ends
        own = self.start.a, self.end.a
        a0, a1 = (e.a0, e.a1) if "a" in self.takes else own
        return coefficients_of(self.as_pieces(), e.v0, a0, a1)


class EndedLine(EndedPolynomial):
    """y'' = 0: what any law becomes between ends that a straight line meets."""

    code = "LIN"
    name = "Straight line"

    @property
    def polynomial(self) -> tuple[float, ...]:
        """c0 … c3, all of them 0."""
        return (0.0,) * 4


class EndedCubic(EndedPolynomial):
    """c0 = 6H − 4v0 − 2v1, c1 = −12H + 6(v0 + v1): of all motions between these ends that of least ∫a².

    Its acceleration at the ends follows from stroke and velocities, and counts as asked for in C_j.
    Source: LCamHdl, ProfileTypes, POLY_3; TwinCAT, POLYNOM3_VV.
    """

    code = "CUB"
    name = "Cubic"

    @property
    def polynomial(self) -> tuple[float, ...]:
        """c0, c1."""
        e = self.ends
        return 6.0 * e.stroke - 4.0 * e.v0 - 2.0 * e.v1, -12.0 * e.stroke + 6.0 * (e.v0 + e.v1), 0.0, 0.0


class EndedQuintic(EndedPolynomial):
    """c0 = a0, and c1, c2, c3 that meet stroke, v1 and a1.

    c1 = 3[20H − 12v0 − 8v1 − 3a0 + a1], c2 = 6[−30H + 16v0 + 14v1 + 3a0 − 2a1],
    c3 = 10[12H − 6(v0 + v1) + a1 − a0].
    Source: LCamHdl, ProfileTypes, POLY_5; TwinCAT, POLYNOM5_MM; CODESYS, Poly5.
    """

    code = "PO5"
    name = "Polynomial 3-4-5"
    TAKES = "va"

    @property
    def polynomial(self) -> tuple[float, ...]:
        """c0 … c3."""
        h, v0, v1, a0, a1, *_ = self.ends.values
        return (
            a0,
            3.0 * (20.0 * h - 12.0 * v0 - 8.0 * v1 - 3.0 * a0 + a1),
            6.0 * (-30.0 * h + 16.0 * v0 + 14.0 * v1 + 3.0 * a0 - 2.0 * a1),
            10.0 * (12.0 * h - 6.0 * (v0 + v1) + a1 - a0),
        )


class EndedSeptic(EndedPolynomial):
    """c0 = a0, c1 = j0, and c2 … c5 that meet stroke, v1, a1 and j1.

    With what the begin leaves to be done, h = H − v0 − a0/2 − j0/6, w = v1 − v0 − a0 − j0/2, α = a1 − a0 − j0 and
    β = j1 − j0: c2 = 12[35h − 15w + 5α/2 − β/6], c3 = 20[−84h + 39w − 7α + β/2],
    c4 = 30[70h − 34w + 13α/2 − β/2], c5 = 42[−20h + 10w − 2α + β/6].
    Source: LCamHdl, ProfileTypes, POLY_7; TwinCAT, POLYNOM7_MM; CODESYS, Poly7.
    """

    code = "PO7"
    name = "Polynomial 4-5-6-7"
    TAKES = "vaj"

    @property
    def polynomial(self) -> tuple[float, ...]:
        """c0 … c5."""
        stroke, v0, v1, a0, a1, j0, j1 = self.ends.values
        h, w = stroke - v0 - a0 / 2.0 - j0 / 6.0, v1 - v0 - a0 - j0 / 2.0
        alpha, gamma = a1 - a0 - j0, j1 - j0
        return (
            a0,
            j0,
            12.0 * (35.0 * h - 15.0 * w + 2.5 * alpha - gamma / 6.0),
            20.0 * (-84.0 * h + 39.0 * w - 7.0 * alpha + 0.5 * gamma),
            30.0 * (70.0 * h - 34.0 * w + 6.5 * alpha - 0.5 * gamma),
            42.0 * (-20.0 * h + 10.0 * w - 2.0 * alpha + gamma / 6.0),
        )


@dataclass(frozen=True)
class HalvedPolynomial(HalvedLaw):
    """Two halves of a symmetric polynomial, S: s = 2λ S(ξ/2λ) up to ξ = λ, s = 1 − 2μ S((1 − ξ)/2μ) from there.

    The halves meet on the diagonal, s(λ) = λ, with the polynomial's own C_v and a = 0. With λ = ½ it is the
    polynomial, and only then are its ends prescribed: by the polynomial of the same degree.
    """

    ends = REST
    ENDED: ClassVar[type[EndedPolynomial]]

    @property
    def takes(self) -> str:
        """What the polynomial takes; nothing where a share shifts it."""
        return self.ENDED.TAKES if self.share == 0.5 else ""

    def between(self, ends: Ends) -> EndedPolynomial:
        """Return the polynomial of this degree between these ends; EndError where a share shifts the law."""
        require_ends(self, ends, self.ENDED.TAKES)
        if self.share != 0.5:
            raise EndError(
                f"{self.name} with the share {self.share:g} is made of two halves that begin and end at rest; "
                "with the share 0.5 its ends can be prescribed"
            )
        return self.ENDED(ends)


@dataclass(frozen=True)
class Cubic(HalvedPolynomial):
    """The cubic that starts and ends at rest: s = ξ²(3 − 2ξ); v = 6ξ(1 − ξ); a = 6 − 12ξ; j = −12.

    Source: S1, 'Cubic curve'; S3, 'CUB'. With the share λ, a falls from 3/λ to 0 and on to −3/(1 − λ): LCamHdl,
    ProfileTypes, POLY_3.
    """

    code = "CUB"
    name = "Cubic"
    aliases = ("cubic curve",)
    source = "S1, 'Cubic curve'; S3, 'CUB'"
    vendors = Vendors(siemens="POLY_3 (4)", twincat="POLYNOM3 (3)", sew="POLYNOM_3")
    HALF = LINE_DOWN
    ENDED = EndedCubic


@dataclass(frozen=True)
class Polynomial345(HalvedPolynomial):
    """s = 10ξ³ − 15ξ⁴ + 6ξ⁵; v = 30ξ²(1 − ξ)²; a = 60ξ − 180ξ² + 120ξ³."""

    code = "PO5"
    name = "Polynomial 3-4-5"
    aliases = ("3-4-5", "quintic", "polynomial of degree 5", "Polynom 5. Grades")
    source = "LCamHdl, ProfileTypes, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'"
    vendors = Vendors(siemens="POLY_5 (5)", twincat="POLYNOM5 (5)", codesys="Poly5", sew="POLYNOM_5")
    HALF = HALF_345
    ENDED = EndedQuintic


@dataclass(frozen=True)
class Polynomial4567(HalvedPolynomial):
    """s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷; v = 140ξ³(1 − ξ)³; a = 420ξ² − 1680ξ³ + 2100ξ⁴ − 840ξ⁵."""

    code = "PO7"
    name = "Polynomial 4-5-6-7"
    aliases = ("4-5-6-7", "septic", "polynomial of degree 7", "Polynom 7. Grades")
    source = "LCamHdl, ProfileTypes, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'"
    vendors = Vendors(siemens="POLY_7 (6), of two sextics", twincat="POLYNOM7 (7)", codesys="Poly7", sew="POLYNOM_7")
    HALF = HALF_4567
    ENDED = EndedSeptic
