"""The motion laws: one class for each family, listed in the catalogue in the order of their numbers in a workbook.

:mod:`workbook.laws.pages` holds what a workbook needs of each. Everything else (tables of pieces, drop-downs,
variations, tests) iterates over the catalogue.
"""

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


_KNOWN = {_key(name): family for family in CATALOGUE for name in (family.code, family.name, *family.aliases)}


def law(name: str, **parameters: Any) -> Law:
    """Return a law of the catalogue.

    Parameters
    ----------
    name : str
        Code, name or alias of the law; upper and lower case are the same.
    **parameters
        Fields of the law's class, dimensionless.

    Returns
    -------
    Law
        The law with these parameters.

    Raises
    ------
    UnknownLawError
        If the catalogue has no law of this name; the message lists the known laws.
    ValueError
        If the law's class rejects a parameter.
    """
    found = _KNOWN.get(_key(name))
    if found is None:
        known = ", ".join(f"{family.code} ({family.name})" for family in CATALOGUE)
        raise UnknownLawError(f"no law is named {name!r}; expected one of {known}")
    return found(**parameters)
