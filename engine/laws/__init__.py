"""The catalogue of motion laws: what each is called, where it comes from, and what it claims of itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import inf, pi, sqrt
from typing import Any

from engine.laws.base import BREAK_TOLERANCE, Coefficients, Kinematics, Law
from engine.laws.constant_acceleration import ConstantAcceleration
from engine.laws.cubic import Cubic
from engine.laws.cycloidal import Cycloidal
from engine.laws.dwell import Dwell
from engine.laws.modified_trapezoidal import ModifiedTrapezoidal
from engine.laws.pieces import Piece, PieceLaw
from engine.laws.trapezoidal_velocity import TrapezoidalVelocity


class UnknownLawError(ValueError):
    """A name that is no law's; the message lists the known ones."""


@dataclass(frozen=True)
class Claims:
    """What a law says of itself with its default parameters; one test measures it for every law.

    ``rise`` is s(1); ``continuous`` the highest derivative that is continuous inside the rise and joins rest
    at both ends (1: the velocity, 2: the acceleration); ``known`` the published coefficients.
    """

    rise: float = 1.0
    continuous: int = 2
    known: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Entry:
    """One law of the catalogue."""

    law: Callable[..., Law]
    code: str
    name: str
    aliases: tuple[str, ...]
    source: str
    claims: Claims

    def example(self) -> Law:
        """Return the law with its default parameters."""
        return self.law()


def polynomial_345() -> PieceLaw:
    """Return the polynomial 3-4-5 as an example of an own law: s = 10ξ³ − 15ξ⁴ + 6ξ⁵, so a = 60ξ − 180ξ² + 120ξ³."""
    return PieceLaw([Piece(1.0, (0.0, 60.0, -180.0, 120.0))])


def _own(pieces: Any = None) -> PieceLaw:
    return polynomial_345() if pieces is None else PieceLaw(pieces)


CATALOGUE: tuple[Entry, ...] = (
    Entry(Dwell, "DWL", Dwell.name, ("Dwell", "rest"), "S3, law Dwell", Claims(0.0, 2, {"cv": 0, "ca_max": 0})),
    Entry(
        ConstantAcceleration, "ACS", ConstantAcceleration.name,
        ("constant acceleration", "constant acceleration symmetric", "parabolic"), "S3, figure 1",
        Claims(1.0, 1, {"cv": 2, "ca_max": 4, "ca_rms": 4, "cj": inf, "va_max": 8}),
    ),
    Entry(
        TrapezoidalVelocity, "TVP", TrapezoidalVelocity.name,
        ("trapezoidal speed", "asymmetric trapezoidal", "trapezoidal velocity profile"),
        "S1, asymmetric trapezoidal speed profile; S3, function TVP",
        Claims(1.0, 1, {"cv": 1.5, "ca_max": 4.5, "ca_rms": 3.674235, "cj": inf, "va_max": 6.75}),
    ),
    Entry(
        Cycloidal, "CIC", Cycloidal.name, ("cycloid", "sine"), "S2, movement equation; S3",
        Claims(1.0, 2, {"cv": 2, "ca_max": 2 * pi, "ca_rms": 4.442883, "cj": 4 * pi**2, "va_max": 8.162097}),
    ),
    Entry(
        Cubic, "CUB", Cubic.name, ("cubic curve",), "S1; S3, law CUB",
        Claims(1.0, 1, {"cv": 1.5, "ca_max": 6, "ca_rms": 2 * sqrt(3), "cj": inf, "va_max": 3.464102}),
    ),
    Entry(
        ModifiedTrapezoidal, "MTP", ModifiedTrapezoidal.name,
        ("ModTVP", "modified trapezoidal acceleration", "modified trapezoid"), "S1, seven parameters; S3, figure 2",
        Claims(1.0, 2, {"cv": 2, "ca_max": 8 * pi / (2 + pi), "ca_rms": 4.233239, "cj": 61.42598, "va_max": 8.089981}),
    ),
    Entry(
        _own, "OWN", PieceLaw.name, ("own", "pieces"), "the engineer's pieces; as an example, the polynomial 3-4-5",
        Claims(1.0, 2, {"cv": 1.875, "ca_max": 5.773503, "ca_rms": 4.140393, "cj": 60, "va_max": 6.694269}),
    ),
)  # fmt: skip

_BY_NAME = {name.lower(): entry for entry in CATALOGUE for name in (entry.code, entry.name, *entry.aliases)}


def law(name: str, **parameters: Any) -> Law:
    """Return a law by code, name or alias, in any case, with its parameters.

    Raises UnknownLawError for a name that no law has, ValueError for parameters that the law refuses.
    """
    entry = _BY_NAME.get(name.strip().lower())
    if entry is None:
        known = ", ".join(f"{e.code} ({e.name})" for e in CATALOGUE)
        raise UnknownLawError(f"no motion law is named {name!r}; known are {known}")
    return entry.law(**parameters)


__all__ = [
    "BREAK_TOLERANCE",
    "CATALOGUE",
    "Claims",
    "Coefficients",
    "ConstantAcceleration",
    "Cubic",
    "Cycloidal",
    "Dwell",
    "Entry",
    "Kinematics",
    "Law",
    "ModifiedTrapezoidal",
    "Piece",
    "PieceLaw",
    "TrapezoidalVelocity",
    "UnknownLawError",
    "law",
    "polynomial_345",
]
