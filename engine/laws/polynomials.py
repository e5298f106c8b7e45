"""Polynomials by boundary values of v (CUB, cubic), of v and a (PO5, quintic) and of v, a and j (PO7, septic)."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from engine.laws.ends import REST, BoundaryLaw, BoundaryValues, EndError
from engine.laws.family import Vendors
from engine.laws.piece import Piece
from engine.laws.pulse_law import HALF_345, HALF_4567, LINE_DOWN
from engine.laws.simple import HalvedLaw

Table = tuple[tuple[int, ...], ...]


@dataclass(frozen=True)
class BoundaryPolynomial(BoundaryLaw):
    """The polynomial of least degree that meets boundary values."""

    TABLE: ClassVar[Table]  # times the column stroke, v0, v1, a0, a1, j0, j1 it is c0, c1 … of a(ξ)

    @property
    def polynomial(self) -> tuple[float, ...]:
        """c0, c1, … of a(ξ)."""
        table = np.array(self.TABLE)
        return tuple((table @ self.ends.values[: table.shape[1]]).tolist())

    @property
    def adjacent_accelerations(self) -> tuple[float, float]:
        """The law's own accelerations at its ends, also those that follow from stroke and velocities."""
        return self.start.a, self.end.a

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return a piece."""
        return (Piece(1.0, self.polynomial),)


class BoundaryLine(BoundaryPolynomial):
    """A straight line, y'' = 0, in place of any law whose boundary values it meets."""

    code = "LIN"
    name = "Straight line"
    TABLE = ((0,),) * 4


class BoundaryCubic(BoundaryPolynomial):
    """c0 = 6H − 4v0 − 2v1, c1 = −12H + 6(v0 + v1): the motion of least ∫a² with these boundary values.

    Its accelerations at the ends follow from stroke and velocities; C_j counts no jump there.
    Source: LCamHdl, ProfileTypes, POLY_3; TwinCAT, POLYNOM3_VV.
    """

    code = "CUB"
    name = "Cubic"
    TABLE = ((6, -4, -2), (-12, 6, 6), (0, 0, 0), (0, 0, 0))


class BoundaryQuintic(BoundaryPolynomial):
    """c0 = a0; c1, c2, c3 meet stroke, v1 and a1: LCamHdl, POLY_5; TwinCAT, POLYNOM5_MM; CODESYS, Poly5."""

    code = "PO5"
    name = "Polynomial 3-4-5"
    TAKES = "va"
    TABLE = ((0, 0, 0, 1, 0), (60, -36, -24, -9, 3), (-180, 96, 84, 18, -12), (120, -60, -60, -10, 10))


class BoundarySeptic(BoundaryPolynomial):
    """c0 = a0, c1 = j0; c2 … c5 meet stroke, v1, a1, j1: LCamHdl, POLY_7; TwinCAT, POLYNOM7_MM; CODESYS, Poly7."""

    code = "PO7"
    name = "Polynomial 4-5-6-7"
    TAKES = "vaj"
    TABLE = (
        (0, 0, 0, 1, 0, 0, 0),
        (0, 0, 0, 0, 0, 1, 0),
        (420, -240, -180, -60, 30, -8, -2),
        (-1680, 900, 780, 200, -140, 20, 10),
        (2100, -1080, -1020, -225, 195, -20, -15),
        (-840, 420, 420, 84, -84, 7, 7),
    )


@dataclass(frozen=True)
class HalvedPolynomial(HalvedLaw):
    """Two halves of a symmetric polynomial S: s = 2λ S(ξ/2λ) up to ξ = λ, then s = 1 − 2μ S((1 − ξ)/2μ), μ = 1 − λ.

    The halves meet at s(λ) = λ, with the polynomial's C_v and a = 0. With λ = ½ the law is the polynomial; only
    then may it have boundary values, which the polynomial of the same degree meets.
    """

    ends: ClassVar[BoundaryValues] = REST  # type: ignore[misc]  # with others it is another law
    ENDED: ClassVar[type[BoundaryPolynomial]]

    @property
    def takes(self) -> str:
        """The quantities of the polynomial's boundary values; none if λ is not ½."""
        return self.ENDED.TAKES if self.share == 0.5 else ""

    def between(self, ends: BoundaryValues) -> BoundaryPolynomial:
        """Return the polynomial of this degree with these boundary values; raise EndError if λ is not ½."""
        ends.require_taken(self, self.ENDED.TAKES)
        if self.share != 0.5:
            raise EndError(
                f"{self.name} with the share {self.share:g} is made of two halves that begin and end at rest; "
                "with the share 0.5 its ends can be prescribed"
            )
        return self.ENDED(ends=ends)


@dataclass(frozen=True)
class Cubic(HalvedPolynomial):
    """The cubic that starts and ends at rest: s = ξ²(3 − 2ξ); v = 6ξ(1 − ξ); a = 6 − 12ξ; j = −12.

    With the share λ, a falls from 3/λ to 0 and on to −3/(1 − λ).
    """

    code = "CUB"
    number = 5
    name = "Cubic"
    aliases = ("cubic curve", "poly 3", "polynomial of degree 3", "Polynom 3. Grades")
    source = "S1, 'Cubic curve'; S3, 'CUB'"
    vendors = Vendors(siemens="POLY_3 (4)", twincat="POLYNOM3 (3)", sew="POLYNOM_3")
    HALF = LINE_DOWN
    ENDED = BoundaryCubic


@dataclass(frozen=True)
class Polynomial345(HalvedPolynomial):
    """s = 10ξ³ − 15ξ⁴ + 6ξ⁵; v = 30ξ²(1 − ξ)²; a = 60ξ − 180ξ² + 120ξ³."""

    code = "PO5"
    number = 11
    name = "Polynomial 3-4-5"
    aliases = ("3-4-5", "poly 3-4-5", "poly 5", "quintic", "polynomial of degree 5", "Polynom 5. Grades")
    source = "LCamHdl, ProfileTypes, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'"
    vendors = Vendors(siemens="POLY_5 (5)", twincat="POLYNOM5 (5)", codesys="Poly5", sew="POLYNOM_5")
    HALF = HALF_345
    ENDED = BoundaryQuintic


@dataclass(frozen=True)
class Polynomial4567(HalvedPolynomial):
    """s = 35ξ⁴ − 84ξ⁵ + 70ξ⁶ − 20ξ⁷; v = 140ξ³(1 − ξ)³; a = 420ξ² − 1680ξ³ + 2100ξ⁴ − 840ξ⁵."""

    code = "PO7"
    number = 12
    name = "Polynomial 4-5-6-7"
    aliases = ("4-5-6-7", "poly 4-5-6-7", "poly 7", "septic", "polynomial of degree 7", "Polynom 7. Grades")
    source = "LCamHdl, ProfileTypes, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'"
    vendors = Vendors(siemens="POLY_7 (6), of two sextics", twincat="POLYNOM7 (7)", codesys="Poly7", sew="POLYNOM_7")
    HALF = HALF_4567
    ENDED = BoundarySeptic
