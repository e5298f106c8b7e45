"""The motion laws, grouped by the pulses that they are made of; :mod:`engine.laws.registry` lists them."""

from typing import Any

from engine.laws.base import Coefficients, Kinematics
from engine.laws.family import Law
from engine.laws.piece import Piece
from engine.laws.pieces import PieceLaw
from engine.laws.registry import CATALOGUE, UnknownLawError, law
from engine.laws.simple import Dwell

__all__ = ["CATALOGUE", "Coefficients", "Dwell", "Kinematics", "Law", "Piece", "PieceLaw", "UnknownLawError", "law"]


def __getattr__(name: str) -> Any:
    """Return the class of any registered law by its name, as in ``from engine.laws import Cubic``."""
    for one in CATALOGUE:
        if one.__name__ == name:
            return one
    raise AttributeError(f"engine.laws has no {name}")
