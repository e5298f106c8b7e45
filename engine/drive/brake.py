"""A brake on the motor's shaft: what it holds, and the dwells that are long enough for it. SI units."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.laws.base import Array

SAME = 1e-9
"""s; a dwell that is shorter than the brake's time by less is as long"""


@dataclass(frozen=True)
class Brake:
    """A brake that holds the motor's shaft in dwells.

    Parameters
    ----------
    torque : float, Nm
        What it holds at the motor's shaft; above 0.
    time : float, s
        What it takes to close and to open; 0 or more. The motor holds in a shorter dwell.

    Raises
    ------
    ValueError
        For a figure outside these limits.
    """

    torque: float = math.inf
    time: float = 0.0

    def __post_init__(self) -> None:
        if not self.torque > 0.0:
            raise ValueError(f"brake: torque is {self.torque:g}; expected more than 0")
        if not 0.0 <= self.time < math.inf:
            raise ValueError(f"brake: time is {self.time:g}; expected a finite number, 0 or more")

    def holds(self, direction: ArrayLike, dwell: ArrayLike) -> NDArray[np.bool_]:
        """Return where it holds: in directions (1, −1, or 0 at rest) of dwells that last so long (s)."""
        return np.logical_and(np.equal(direction, 0.0), np.greater_equal(dwell, self.time - SAME))


def dwell_times(durations: Array, direction: Array) -> Array:
    """Return how long the dwell lasts that each part of a cycle belongs to.

    Parameters
    ----------
    durations : (n,) array, s
        Of the parts, in the order of the cycle.
    direction : (n,) array
        1, −1, or 0 at rest.

    Returns
    -------
    (n,) array, s
        Of parts at rest that follow each other, also across the end of the cycle, the sum; 0 of a part that moves.
    """
    moves = direction != 0.0
    before = np.cumsum(moves) % max(1, int(moves.sum()))
    return np.where(moves, 0.0, np.bincount(before, weights=np.where(moves, 0.0, durations))[before])
