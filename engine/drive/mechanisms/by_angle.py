"""Loads by the angle of their axis: a crank that turns full circles against a slide, an arm that swings."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np

from engine.drive.chain import require_not_negative, require_positive
from engine.drive.mechanisms.slides import slopes
from engine.laws.base import Array, require_finite


class ByAngle(ABC):
    """A load x(φ) that depends on the angle φ of its axis."""

    steps: int = 1  # equal parts of a cycle that the rule of points needs
    slides: bool = False  # whether its mass travels by x(φ); else it turns with the axis

    @abstractmethod
    def slopes(self, angle: Array) -> tuple[Array, Array]:
        """Return x' and x'' (m/rad, m/rad²) at angles of the axis (rad); 1 and 0 of a load that turns with it."""

    def weight(self, angle: Array) -> Array:
        """Return the torque (Nm) that holds the load's weight at angles of the axis (rad)."""
        return np.zeros(np.shape(angle))

    def dead_centres(self, low: float, high: float) -> list[float]:
        """Return the angles (rad) between two at which x is extreme."""
        return []


@dataclass(frozen=True)
class Arm(ByAngle):
    """An arm in a vertical plane, of the torque m g r cos(φ + φ_0). Raises ValueError for a negative moment."""

    moment: float  # m g r (Nm)
    angle: float = 0.0  # φ_0, from the horizontal (rad)

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
    """A crank that drives a slide through its dead centres. Raises ValueError unless l > r + |e|. Source: VDI 2727."""

    crank: float  # r (m)
    rod: float  # l (m)
    offset: float = 0.0  # e (m)
    start: float = 0.0  # φ_0 (rad), of the crank's angle ψ = φ + φ_0 from the line of the slide
    steps = 24
    slides = True

    def __post_init__(self) -> None:
        require_positive("press crank", crank=self.crank, rod=self.rod)
        require_finite(offset=self.offset, start=self.start)
        least = self.crank + abs(self.offset)
        if not self.rod > least:
            raise ValueError(f"press crank: rod is {self.rod:g} m; expected more than crank and offset, {least:g} m")

    def position(self, angle: Array) -> Array:
        """Return x = r cos ψ + √(l² − (r sin ψ − e)²) (m), from the shaft, at angles of the axis (rad)."""
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
        angles = []
        for centre in (outer - self.start, inner - self.start):
            first = math.ceil((low - centre) / turn)
            angles += [centre + turn * k for k in range(first, math.floor((high - centre) / turn) + 1)]
        return sorted(angles)
