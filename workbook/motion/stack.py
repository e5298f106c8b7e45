"""What a motion's pieces take from those of the laws, stacked on the sheet Laws: the one place that names them."""

from __future__ import annotations

from typing import NamedTuple

POWERS = 6
"""of a law's acceleration: the stack has c0 … c5"""


class Sine(NamedTuple):
    """A sine in the stack by its columns: P/ω², ω, φ; ``mark`` ends the names of the motion's columns of it."""

    ps: str
    omega: str
    phi: str
    mark: str


SINES = (Sine("ps", "omega", "phi", ""),)

FIRST = "=MATCH([no],piece_number,0)"
"""the row of the first piece of a phase's law"""
LAST = "MATCH(2*[no]+1-break_tolerance,piece_key,1)"
"""the row of the last that begins before the law ends: the spare rows of an own law do not"""


def of_law(column: str) -> str:
    """Return the formula of an entry of the law's piece, in the row ``m`` of the stack."""
    return f"INDEX(piece_{column},[m])"
