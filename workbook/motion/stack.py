"""What a motion's pieces take from those of the laws, stacked on the sheet Laws: the one place that names them."""

from typing import NamedTuple

from workbook.laws.sampling import Pieces


class Sine(NamedTuple):
    """A sine in the stack by its columns: P/ω², ω, φ; ``mark`` ends the names of the motion's columns of it."""

    ps: str
    omega: str
    phi: str
    mark: str


SINES = (Sine("ps", "omega", "phi", ""), Sine("ps2", "omega2", "phi2", "2"))


def sines(stack: Pieces) -> tuple[Sine, ...]:
    """Return the sines that the laws of a book have: two where any law has a second."""
    return SINES if any(piece.omega2 for pieces in stack.pieces.values() for piece in pieces) else SINES[:1]


def powers(stack: Pieces) -> int:
    """Return how many powers of u the position of a motion has by the laws of a book: two more than accelerations."""
    return max(len(piece.c) for pieces in stack.pieces.values() for piece in pieces) + 2


FIRST = "=MATCH([no],piece_number,0)"
"""the row of the first piece of a phase's law"""


def last_before(number: str, xi: str) -> str:
    """Return the formula of the row of a law's last piece that begins before ξ: before 1, no spare row does."""
    return f"MATCH(2*{number}+{xi}-break_tolerance,piece_key,1)"


def of_law(column: str) -> str:
    """Return the formula of an entry of the law's piece, in the row ``m`` of the stack."""
    return f"INDEX(piece_{column},[m])"
