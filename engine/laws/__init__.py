"""The catalogue of motion laws: one family a file, each with its claims."""

from __future__ import annotations

from typing import Any

from engine.laws import (
    constant_acceleration,
    cubic,
    cycloidal,
    dwell,
    modified_trapezoidal,
    pieces,
    trapezoidal_velocity,
)
from engine.laws.base import Claims, Coefficients, Entry, Kinematics, Law
from engine.laws.constant_acceleration import ConstantAcceleration
from engine.laws.cubic import Cubic
from engine.laws.cycloidal import Cycloidal
from engine.laws.dwell import Dwell
from engine.laws.modified_trapezoidal import ModifiedTrapezoidal
from engine.laws.piece import Piece
from engine.laws.pieces import PieceLaw
from engine.laws.trapezoidal_velocity import TrapezoidalVelocity

__all__ = [
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
]

CATALOGUE: tuple[Entry, ...] = (
    dwell.ENTRY,
    constant_acceleration.ENTRY,
    trapezoidal_velocity.ENTRY,
    cycloidal.ENTRY,
    cubic.ENTRY,
    modified_trapezoidal.ENTRY,
    pieces.ENTRY,
)


class UnknownLawError(ValueError):
    """No law of the catalogue has this name."""


def _key(name: str) -> str:
    return " ".join(name.casefold().split())


_KNOWN = {_key(name): entry for entry in CATALOGUE for name in entry.names}


def law(name: str, **parameters: Any) -> Law:
    """Return the law of this code, name or alias (in capitals or not), made with its parameters.

    Raises UnknownLawError, which lists the known laws, and what the law itself raises for its parameters.
    """
    entry = _KNOWN.get(_key(name))
    if entry is None:
        known = ", ".join(f"{e.code} ({e.name})" for e in CATALOGUE)
        raise UnknownLawError(f"no law is named {name!r}; expected one of {known}")
    return entry.law(**parameters)
