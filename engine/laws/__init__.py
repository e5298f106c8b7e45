"""The motion laws: one family a file, each with its claims; :mod:`engine.laws.registry` lists them."""

from typing import Any

from engine.laws.base import Coefficients, Kinematics, Law
from engine.laws.dwell import Dwell
from engine.laws.entry import Claims, Entry
from engine.laws.piece import Piece
from engine.laws.pieces import PieceLaw
from engine.laws.registry import CATALOGUE, UnknownLawError, law

__all__ = [
    "CATALOGUE", "Claims", "Coefficients", "Dwell", "Entry", "Kinematics", "Law", "Piece", "PieceLaw",
    "UnknownLawError", "law",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    """Return the class of any registered law by its name, as in ``from engine.laws import Cubic``."""
    for entry in CATALOGUE:
        if entry.law.__name__ == name:
            return entry.law
    raise AttributeError(f"engine.laws has no {name}")
