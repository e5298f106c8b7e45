"""A motor, gears, a mechanism of any ratio and all that acts on the load over a cycle. SI units."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from engine.drive.chain import Load, Method, Resists, require_not_negative, resisting
from engine.drive.drive import Drive
from engine.drive.mechanisms.slides import ByAngle
from engine.drive.mechanisms.variable_ratio import Linkage
from engine.laws.base import Array, require_finite


@dataclass(frozen=True)
class Window:
    """A process force (N, or Nm) at the load from one place of the cycle to another, in units of its abscissa.

    It resists ``always`` in one direction, also at rest, or ``moving``: it opposes the motion. A window whose end
    is not behind its begin runs across the end of the cycle. Source: S1, 'Feeding group', F_r.
    """

    begin: float
    end: float
    force: float
    resists: Resists = "always"

    def __post_init__(self) -> None:
        require_finite(begin=self.begin, end=self.end, force=self.force)
        _ = self.load

    @property
    def load(self) -> Load:
        """The force as a load without mass."""
        return resisting(self.force, self.resists)

    def acts_at(self, x: float, cycle: float) -> bool:
        """Whether it acts at x of a cycle that is so long."""
        lasts = self.end - self.begin
        return math.isclose(lasts, cycle) or (x - self.begin) % cycle < lasts % cycle


class Motion3(NamedTuple):
    """Position, speed and acceleration of a load (m or rad, per s)."""

    y: Array
    v: Array
    a: Array


class ShaftMotion(NamedTuple):
    """φ' (1/m or 1) of the mechanism's own shaft and its speed (rad/s) and acceleration (rad/s²)."""

    first: Array
    speed: Array
    acceleration: Array


class Force(NamedTuple):
    """What drives a load (N, or Nm): ``mass`` · a + ``viscous`` · v + ``level``; of a load by angle at its axis."""

    mass: float
    viscous: float
    level: float
    by_angle: ByAngle | None = None

    def at(self, motion: Motion3) -> Array:
        """Return the force of a motion; of a load by angle the torque at its axis, x' F and the weight of an arm."""
        y, v, a = motion
        if self.by_angle is None:
            return np.asarray(self.mass * a + self.viscous * v + self.level)
        first, second = self.by_angle.slopes(y)
        force = self.mass * (first * a + second * v**2) + self.viscous * first * v + self.level
        return np.asarray(first * force + self.by_angle.weight(y))


class Weights(NamedTuple):
    """The torque of a shaft (Nm): ``force`` · F/φ' + ``inertia`` · φ̈, φ the angle of the mechanism's own shaft."""

    force: float
    inertia: float


@dataclass(frozen=True)
class Train:
    """A drive, and what it does not know of itself: a ratio that depends on position, and the rest of the load.

    ``linkage`` takes the place of the last stage's ratio, which is then 1 (its efficiency counts). ``viscous`` is a
    resistance in N per m/s (Nm per rad/s). ``by_angle`` is what a load does that follows the angle of its axis.
    Raises ValueError for a negative viscous friction, or a last stage whose ratio is not 1 where there is a linkage.
    """

    drive: Drive
    linkage: Linkage | None = None
    viscous: float = 0.0
    windows: tuple[Window, ...] = field(default=())
    by_angle: ByAngle | None = None

    def __post_init__(self) -> None:
        require_not_negative("load", viscous=self.viscous)
        object.__setattr__(self, "windows", tuple(self.windows))
        last = self.drive.mechanism.stages[-1]
        if self.linkage and last.ratio != 1.0:
            raise ValueError(f"{last.name}: ratio is {last.ratio:g} before a {self.linkage.name}; expected 1")

    @property
    def method(self) -> Method:
        """How losses are counted."""
        return self.drive.method

    def shaft(self, load: Motion3, within: float | None = None) -> ShaftMotion:
        """Return the motion of the mechanism's own shaft, φ̇ = φ' ẏ, φ̈ = φ'' ẏ² + φ' ÿ.

        ``within`` and errors as of :meth:`engine.drive.mechanisms.variable_ratio.Linkage.shaft`.
        """
        first, second = self.ratio(load.y, within)
        return ShaftMotion(first, first * load.v, second * load.v**2 + first * load.a)

    def ratio(self, y: Array, within: float | None = None) -> tuple[Array, Array]:
        """Return φ' and φ'' at positions of the load; ``within`` and errors as of :meth:`shaft`."""
        if self.linkage is None:
            return np.full(y.shape, self.drive.mechanism.stages[-1].ratio), np.zeros(y.shape)
        _, first, second = self.linkage.shaft(y, within)
        return first, second

    @property
    def gear(self) -> float:
        """Speed of the motor over that of the mechanism's own shaft."""
        return self.drive.mechanism.ratio_to(self.drive.mechanism.last - 1)

    @property
    def inertia_varies(self) -> bool:
        """Whether the load's inertia at the mechanism's shaft changes with the position."""
        return self.linkage is not None or (self.by_angle is not None and self.by_angle.slides)

    def cuts(self, low: float, high: float) -> Sequence[float]:
        """Return the positions between two at which the torque changes its formula: knots of a ratio, dead centres."""
        if self.by_angle:
            return self.by_angle.dead_centres(low, high)
        return self.linkage.knots if self.linkage else ()

    def sense(self, y: float) -> float:
        """Return 1, or −1 where the load goes backward while its axis, at y, goes forward: beyond a dead centre."""
        return float(np.sign(self.by_angle.slopes(np.asarray(y))[0])) if self.by_angle else 1.0

    def force(self, direction: float, x: float, cycle: float) -> Force:
        """Return what drives the load in a direction (1, −1, or 0 at rest) at a place x of the cycle."""
        m = self.drive.mechanism
        loads = [m.load, *(window.load for window in self.windows if window.acts_at(x, cycle))]
        level = math.fsum(float(load.resisting(direction)) for load in loads)
        return Force(m.on_shaft(m.last), self.viscous, level, self.by_angle)

    def weights(self, factors: Sequence[float]) -> list[Weights]:
        """Return the torque of each shaft but the load's, from the motor's, with the motor's own inertia in the first.

        ``factors`` are those of the rule of losses, of each stage from the motor's.
        """
        m = self.drive.mechanism
        last = m.last - 1
        found = [Weights(factors[last], m.on_shaft(last))]
        for k in reversed(range(last)):
            stage, behind = m.stages[k], found[0]
            through = factors[k] / stage.ratio
            turns = math.prod(one.ratio for one in m.stages[k:last])
            found.insert(0, Weights(through * behind.force, through * behind.inertia + m.on_shaft(k) * turns))
        own = self.drive.motor_inertia * self.gear
        return [Weights(found[0].force, found[0].inertia + own), *found[1:]]
