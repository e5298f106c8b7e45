"""The power of a motor over a section of its drive, as the polynomial through its values at nodes. SI units.

It is how a table of cells knows the power of a drive of a changing ratio, or with viscous friction, everywhere.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from engine.laws.base import Array
from engine.machine.places import NODES, Held, Polynomial, Worked

INSIDE = 1.0 - 1e-12
"""how far from the middle places lie at most: the ends are nodes, at which the barycentric formula has no value"""
_BEFORE, _BEHIND, _BOTH = NODES[1:-1] - NODES[:-2], NODES[2:] - NODES[1:-1], NODES[2:] - NODES[:-2]
BEND = np.array([2.0 / (_BEFORE * _BOTH), -2.0 / (_BEFORE * _BEHIND), 2.0 / (_BEHIND * _BOTH)])
"""of three nodes one after the other: the weights of their values in twice the divided difference"""
ORDER = 4
"""of the mean of these: it is never below the largest, and above it by no more than a factor of 18^(1/4) = 2.1"""


@dataclass(frozen=True)
class Interpolated:
    """Power (W) at the nodes of a section, which is from ``low`` to ``high`` of the motion (rad)."""

    values: Array
    low: float
    high: float

    @classmethod
    def of(cls, held: Held, worked: Worked, low: float, high: float) -> Interpolated:
        """Return it of a drive at the nodes of a section."""
        return cls(worked.power * held.train.gear, low, high)

    @property
    def ends(self) -> tuple[float, float]:
        """The power at begin and end: the limits from inside (W)."""
        return float(self.values[0]), float(self.values[-1])

    def place(self, x: float) -> float:
        """Return where between −1 and 1 a place of the motion (rad) lies."""
        found = 2.0 * (x - self.low) / (self.high - self.low) - 1.0
        return max(-INSIDE, min(INSIDE, found))

    def over(self, middle: float, half: float) -> tuple[float, float]:
        """Return the power (W) at both ends of a part of the section, by the middle and half the width of that."""
        through = Polynomial(self.values, 0.0)
        return through.at(self.place(middle - half)), through.at(self.place(middle + half))

    @property
    def bend(self) -> float:
        """The largest |P''| (W) over the place between −1 and 1, or somewhat more.

        A divided difference of three values is half of P'' between them. Source: P. J. Davis, Interpolation and
        Approximation, 3.2.
        """
        first, second, third = BEND
        each = first * self.values[:-2] + second * self.values[1:-1] + third * self.values[2:]
        return float((each**ORDER).sum() ** (1.0 / ORDER))

    def off(self, step: float, efficiency: float) -> float:
        """Return by how much straight lines over steps (rad) are off at most (W), of what its drive draws.

        |P''| δ²/8, as of :meth:`engine.machine.powering.Powering.off`; in a section power keeps its way.
        """
        short = 2.0 * min(1.0, step / (self.high - self.low))
        return self.bend * short**2 / 8.0 / efficiency
