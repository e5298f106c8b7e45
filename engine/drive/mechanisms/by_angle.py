"""Loads of a turning axis whose torque depends on its angle: a slide on a crank that turns full circles, an arm.

The motion is that of the axis, φ; the load follows by x(φ), and its torque at the axis is the virtual work
T = x' F: x' = dx/dφ passes through 0 in the dead centres, and nothing divides by it. SI units.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from engine.drive.chain import require_not_negative, require_positive
from engine.drive.mechanisms.slides import slopes
from engine.laws.base import Array, require_finite


class ByAngle(ABC):
    """A load that follows the angle of its axis."""

    steps: int = 1
    """equal parts of a cycle in which a rule of points is exact enough"""
    slides: bool = False
    """whether its mass travels by x(φ); else it turns with the axis"""

    @abstractmethod
    def slopes(self, angle: Array) -> tuple[Array, Array]:
        """Return x' and x'' (m per rad, and per rad²) at angles of the axis; 1 and 0 of a load that turns with it."""

    def weight(self, angle: Array) -> Array:
        """Return the torque (Nm) that holds its weight at angles of the axis, beside what acts on x."""
        return np.zeros(np.shape(angle))

    def dead_centres(self, low: float, high: float) -> list[float]:
        """Return the angles between two at which x turns round."""
        return []


@dataclass(frozen=True)
class Arm(ByAngle):
    """An arm that swings in a vertical plane: m g r (Nm), and its angle from the horizontal where the axis is at 0.

    The torque is m g r cos(φ + φ_0). Raises ValueError for a negative moment.
    """

    moment: float
    angle: float = 0.0

    def __post_init__(self) -> None:
        require_not_negative("arm", moment=self.moment)
        require_finite(angle=self.angle)

    def slopes(self, angle: Array) -> tuple[Array, Array]:
        """Return 1 and 0: its inertia turns with the axis."""
        return np.ones(np.shape(angle)), np.zeros(np.shape(angle))

    def weight(self, angle: Array) -> Array:
        """Return m g r cos(φ + φ_0) (Nm)."""
        return np.asarray(self.moment * np.cos(angle + self.angle))


@dataclass(frozen=True)
class PressCrank(ByAngle):
    """A crank r that drives a slide by a rod l through its dead centres, full circles or not; offset e (all m).

    The slide is at x = r cos ψ + √(l² − (r sin ψ − e)²) from the shaft, ψ = φ + φ_0 the crank's angle from the line of
    the slide. Raises ValueError unless l > r + |e|. Source: VDI 2727, crank-slider.
    """

    crank: float
    rod: float
    offset: float = 0.0
    start: float = 0.0
    steps = 24
    slides = True

    def __post_init__(self) -> None:
        require_positive("press crank", crank=self.crank, rod=self.rod)
        require_finite(offset=self.offset, start=self.start)
        least = self.crank + abs(self.offset)
        if not self.rod > least:
            raise ValueError(f"press crank: rod is {self.rod:g} m; expected more than crank and offset, {least:g} m")

    def position(self, angle: Array) -> Array:
        """Return x (m) at angles of the axis."""
        psi = angle + self.start
        height = self.crank * np.sin(psi) - self.offset
        return np.asarray(self.crank * np.cos(psi) + np.sqrt(self.rod**2 - height**2))

    def slopes(self, angle: Array) -> tuple[Array, Array]:
        """Return x' and x'' at angles of the axis."""
        return slopes(self.crank, self.offset, angle + self.start, self.position(angle))

    def dead_centres(self, low: float, high: float) -> list[float]:
        """Return the angles between two at which crank and rod are in line."""
        outer = math.asin(self.offset / (self.rod + self.crank))
        inner = math.pi + math.asin(self.offset / (self.rod - self.crank))
        turn = 2.0 * math.pi
        found = []
        for centre in (outer - self.start, inner - self.start):
            first = math.ceil((low - centre) / turn)
            found += [centre + turn * k for k in range(first, math.floor((high - centre) / turn) + 1)]
        return sorted(found)
