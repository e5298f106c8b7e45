"""The motion laws: a line a family in the catalogue, in the order of their numbers in a workbook.

What a workbook needs of each stands in :mod:`workbook.laws.pages`. All else (the stack of pieces, drop-downs,
variations, tests) goes through the catalogue.
"""

from collections.abc import Sequence
from typing import Any

from engine.laws.base import Coefficients, Kinematics
from engine.laws.family import Law
from engine.laws.modified import (
    HarmonicCombination,
    ModifiedSine,
    ModifiedTrapezoidal,
    SineConstantCosine,
    SineStraightSine,
    TrapezoidByShare,
)
from engine.laws.piece import Piece
from engine.laws.pieces import PieceLaw
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, Dwell, SimpleHarmonic, StraightLine
from engine.laws.spline import Spline

__all__ = ["CATALOGUE", "Coefficients", "Dwell", "Kinematics", "Law", "Piece", "PieceLaw", "UnknownLawError", "law"]
CATALOGUE: tuple[type[Law], ...] = (
    Dwell, ConstantAcceleration, TrapezoidalVelocity, Cycloidal, Cubic, ModifiedTrapezoidal, PieceLaw, StraightLine,
    SimpleHarmonic, DoubleHarmonic, Polynomial345, Polynomial4567, ModifiedSine, TrapezoidByShare, SineConstantCosine,
    HarmonicCombination, SineStraightSine, SineRamps, SCurve, Spline,
)  # fmt: skip


class UnknownLawError(ValueError):
    """No law of the catalogue has this name."""


def _key(name: str) -> str:
    return " ".join(name.casefold().split())


def by_name(laws: Sequence[type[Law]]) -> dict[str, type[Law]]:
    """Return the laws by code, name and aliases; raise ValueError where one name means two laws."""
    found: dict[str, type[Law]] = {}
    for one in laws:
        for key in {_key(name) for name in (one.code, one.name, *one.aliases)}:
            if key in found:
                raise ValueError(f"{key!r} names two laws: {found[key].__name__} and {one.__name__}")
            found[key] = one
    return found


_KNOWN = by_name(CATALOGUE)


def law(name: str, **parameters: Any) -> Law:
    """Return a law of the catalogue.

    Parameters
    ----------
    name : str
        Its code, name or alias, in capitals or not.
    **parameters
        Those of the law's class.

    Returns
    -------
    Law
        The law, made with its parameters.

    Raises
    ------
    UnknownLawError
        For a name that is not in the catalogue; it lists the known laws.
    ValueError
        What the law itself raises for its parameters.
    """
    found = _KNOWN.get(_key(name))
    if found is None:
        known = ", ".join(f"{one.code} ({one.name})" for one in CATALOGUE)
        raise UnknownLawError(f"no law is named {name!r}; expected one of {known}")
    return found(**parameters)
