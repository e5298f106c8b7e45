"""Loads: masses on guides, cylinders. SI units."""

import math
from dataclasses import dataclass
from typing import Literal

from engine.drive.chain import Load, require_not_negative
from engine.laws.base import require_finite

GRAVITY = 9.81
"""m/s², as S4 has it"""

Resists = Literal["always", "moving"]


@dataclass(frozen=True)
class Slide:
    """A ``mass`` (kg) on a guide, with the coefficient of ``friction`` μ, both 0 or more.

    ``slope`` (rad) is the guide's, rising with positive travel, within a right angle either way; ``force`` (N) acts
    against positive travel, always; ``gravity`` is g (m/s²). Raises ValueError for a figure outside these limits.
    """

    mass: float
    friction: float = 0.0
    slope: float = 0.0
    force: float = 0.0
    gravity: float = GRAVITY

    def __post_init__(self) -> None:
        require_not_negative("load", mass=self.mass, friction=self.friction, gravity=self.gravity)
        require_finite(slope=self.slope, force=self.force)
        if abs(self.slope) > math.pi / 2 + 1e-12:
            raise ValueError(f"slope is {math.degrees(self.slope):g} degrees; expected −90 to 90")

    @property
    def load(self) -> Load:
        """The load at the end of a chain: F + m g sin θ in one direction, also at rest; μ m g cos θ against motion."""
        weight = self.mass * self.gravity
        rubbing = self.friction * self.mass * self.gravity * abs(math.cos(self.slope))
        return Load(self.mass, self.force + weight * math.sin(self.slope), rubbing)


def resisting(force: float, resists: Resists) -> Load:
    """Return a load without mass of a force F_r (N), or a torque (Nm).

    ``always``: it acts in one direction, also at rest, like a weight. ``moving``: it opposes the motion, and is
    zero at standstill, like friction. Raises ValueError for another word. Source: S1, 'Feeding group'.
    """
    if resists not in ("always", "moving"):
        raise ValueError(f"resists is {resists!r}; expected 'always' or 'moving'")
    return Load(0.0, force) if resists == "always" else Load(0.0, friction=force)


def cylinder(diameter: float, length: float, density: float, bore: float = 0.0) -> float:
    """Return the inertia of a solid or hollow cylinder about its axis, ½ ρ π (R⁴ − r⁴) L, in kg m².

    ``diameter``, ``length`` and ``bore`` (the inner diameter) in m, ``density`` in kg/m³.
    Raises ValueError for a negative quantity, or a bore that is not smaller than the diameter.
    Source: S4, problem 1, 'a. J_leadscrew'.
    """
    require_not_negative("cylinder", diameter=diameter, length=length, density=density, bore=bore)
    if bore > 0.0 and bore >= diameter:
        raise ValueError(f"cylinder: bore is {bore:g} m; expected less than the diameter, {diameter:g} m")
    return 0.5 * density * math.pi * ((diameter / 2.0) ** 4 - (bore / 2.0) ** 4) * length
