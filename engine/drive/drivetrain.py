"""A drivetrain: a motor on a mechanism of constant or changing ratio, and the forces on its load. SI units."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive.chain import Load, Mechanism, Method, Resists, require_not_negative, resisting
from engine.drive.mechanisms.by_angle import ByAngle
from engine.drive.mechanisms.variable_ratio import Linkage
from engine.laws.base import Array, require_finite

Holding = Literal["motor", "brake"]
SAME = 1e-9  # s by which a dwell may be shorter than the brake's time


@dataclass(frozen=True)
class Brake:
    """A brake that holds the motor's shaft in dwells. Raises ValueError for figures outside the limits below."""

    torque: float = math.inf  # Nm, above 0
    time: float = 0.0  # to close and to open (s), 0 or more; in a shorter dwell the motor holds

    def __post_init__(self) -> None:
        if not self.torque > 0.0:
            raise ValueError(f"brake: torque is {self.torque:g}; expected more than 0")
        if not 0.0 <= self.time < math.inf:
            raise ValueError(f"brake: time is {self.time:g}; expected a finite number, 0 or more")

    def holds(self, direction: ArrayLike, dwell: ArrayLike) -> NDArray[np.bool_]:
        """Return whether it holds, by the direction (1, −1, or 0 at rest) and the duration of the dwell (s)."""
        return np.logical_and(np.equal(direction, 0.0), np.greater_equal(dwell, self.time - SAME))


ANY = Brake()


def dwell_times(durations: Array, direction: Array) -> Array:
    """Return the duration (s) of the dwell to which each part of a cycle belongs, across its end too; 0 if it moves."""
    moves = direction != 0.0
    before = np.cumsum(moves) % max(1, int(moves.sum()))
    return np.where(moves, 0.0, np.bincount(before, weights=np.where(moves, 0.0, durations))[before])


@dataclass(frozen=True)
class Window:
    """A process force at the load over part of the cycle. Source: S1, 'Feeding group', F_r."""

    begin: float  # in units of the abscissa
    end: float  # likewise; unless it is after the begin, the window runs over the end of the cycle
    force: float  # N, or Nm
    # against positive motion, also at rest; or "moving", against the motion
    resists: Resists = "always"

    def __post_init__(self) -> None:
        require_finite(begin=self.begin, end=self.end, force=self.force)
        _ = self.load

    @property
    def load(self) -> Load:
        """The force as a load without mass."""
        return resisting(self.force, self.resists)

    def acts_at(self, x: float, cycle: float) -> bool:
        """Return whether it acts at x, in a cycle of a length in units of the abscissa."""
        duration = self.end - self.begin
        return math.isclose(duration, cycle) or (x - self.begin) % cycle < duration % cycle


class LoadMotion(NamedTuple):
    """Motion of a load, arrays of equal shape."""

    y: Array  # m, or rad
    v: Array  # m/s, or rad/s
    a: Array  # m/s², or rad/s²


class ShaftMotion(NamedTuple):
    """Motion of the mechanism's own shaft, arrays of equal shape."""

    first: Array  # φ' (rad/m, or 1)
    speed: Array  # rad/s
    acceleration: Array  # rad/s²


class Force(NamedTuple):
    """The force that drives a load (N, or Nm): ``mass`` · a + ``viscous`` · v + ``level``."""

    mass: float  # kg, or kg m²
    viscous: float  # N per m/s, or Nm per rad/s
    level: float  # N, or Nm
    # of a load by the angle of its axis; then a and v are those of x
    by_angle: ByAngle | None = None

    def at(self, motion: LoadMotion) -> Array:
        """Return the force (N, or Nm) for a motion; of a load by angle the torque at its axis, with its weight."""
        y, v, a = motion
        if self.by_angle is None:
            return np.asarray(self.mass * a + self.viscous * v + self.level)
        first, second = self.by_angle.slopes(y)
        force = self.mass * (first * a + second * v**2) + self.viscous * first * v + self.level
        return np.asarray(first * force + self.by_angle.weight(y))


class TorqueCoefficients(NamedTuple):
    """Coefficients of a shaft's torque (Nm), ``force`` · F/φ' + ``inertia`` · φ̈ ± ``friction``.

    φ is the angle of the mechanism's own shaft; the friction has the sign of the motion.
    """

    force: float  # dimensionless
    inertia: float  # kg m²
    friction: float  # Nm


@dataclass(frozen=True)
class Drivetrain:
    """A motor on a mechanism, and what acts on its load. Raises ValueError for figures outside the limits below."""

    mechanism: Mechanism
    motor_inertia: float  # J_m (kg m²), 0 or more
    # losses by the direction of power; or "document": always over η, as in S4
    method: Method = "physical"
    # what holds the load at rest; S4 counts no torque there, as with a brake
    holding: Holding = "motor"
    no_load: float = 0.0  # T_nl (Nm), against the rotation of the motor's shaft, 0 or more
    copper: float = 0.0  # copper losses over the square of the torque, P_N/T_N² (W/(Nm)²), 0 or more
    brake: Brake = ANY  # by default of any torque, in any dwell
    # replaces the ratio of the last stage, which has to be 1; its efficiency counts
    linkage: Linkage | None = None
    viscous: float = 0.0  # viscous friction (N per m/s, or Nm per rad/s), 0 or more
    windows: tuple[Window, ...] = ()  # process forces
    by_angle: ByAngle | None = None  # a load that follows the angle of its axis

    def __post_init__(self) -> None:
        require_not_negative("motor", inertia=self.motor_inertia, no_load=self.no_load, copper=self.copper)
        require_not_negative("load", viscous=self.viscous)
        for name, words in (("method", get_args(Method)), ("holding", get_args(Holding))):
            if getattr(self, name) not in words:
                raise ValueError(f"{name} is {getattr(self, name)!r}; expected {' or '.join(map(repr, words))}")
        object.__setattr__(self, "windows", tuple(self.windows))
        last = self.mechanism.stages[-1]
        if self.linkage and last.ratio != 1.0:
            raise ValueError(f"{last.name}: ratio is {last.ratio:g} before a {self.linkage.name}; expected 1")

    def shaft(self, load: LoadMotion, within: float | None = None) -> ShaftMotion:
        """Return the motion of the mechanism's own shaft, φ̇ = φ' ẏ, φ̈ = φ'' ẏ² + φ' ÿ; see :meth:`Linkage.shaft`."""
        first, second = self.ratio(load.y, within)
        return ShaftMotion(first, first * load.v, second * load.v**2 + first * load.a)

    def ratio(self, y: Array, within: float | None = None) -> tuple[Array, Array]:
        """Return φ' and φ'' at positions of the load; see :meth:`Linkage.shaft`."""
        if self.linkage is None:
            return np.full(y.shape, self.mechanism.stages[-1].ratio), np.zeros(y.shape)
        _, first, second = self.linkage.shaft(y, within)
        return first, second

    @property
    def gear(self) -> float:
        """Speed of the motor over that of the mechanism's own shaft."""
        return self.mechanism.ratio_to(self.mechanism.last - 1)

    @property
    def has_constant_ratio(self) -> bool:
        """Whether the load moves in step with its shaft."""
        return self.linkage is None and self.by_angle is None

    @property
    def is_viscous(self) -> bool:
        """Whether the load has viscous friction."""
        return self.viscous > 0.0

    @property
    def inertia_varies(self) -> bool:
        """Whether the load's inertia at the mechanism's shaft depends on the position."""
        return self.linkage is not None or (self.by_angle is not None and self.by_angle.slides)

    def cuts(self, low: float, high: float) -> Sequence[float]:
        """Return the positions between two at which the torque's formula changes: knots of a linkage, dead centres."""
        centres = self.by_angle.dead_centres(low, high) if self.by_angle else ()
        return [*centres, *(self.linkage.knots if self.linkage else ())]

    def sense(self, y: float) -> float:
        """Return 1, or −1 if the load moves backward while its axis moves forward from y, beyond a dead centre."""
        return float(np.sign(self.by_angle.slopes(np.asarray(y))[0])) if self.by_angle else 1.0

    def acting(self, x: float, cycle: float) -> list[Load]:
        """Return the process forces that act at the abscissa x of a cycle's length."""
        return [window.load for window in self.windows if window.acts_at(x, cycle)]

    def force(self, direction: float, acting: Sequence[Load] = ()) -> Force:
        """Return the force on the load in its direction (1, −1, or 0 at rest) with the process forces that act."""
        m = self.mechanism
        level = math.fsum(float(load.resisting(direction)) for load in (m.load, *acting))
        return Force(m.on_shaft(m.last), self.viscous, level, self.by_angle)

    def torque_coefficients(self, factors: Sequence[float]) -> list[TorqueCoefficients]:
        """Return the coefficients of all shafts but the load's, from the motor's, by the factor of each stage."""
        m = self.mechanism
        last = m.last - 1
        rows = [TorqueCoefficients(factors[last], m.on_shaft(last), m.friction_on(last))]
        for k in reversed(range(last)):
            stage, behind = m.stages[k], rows[0]
            through = factors[k] / stage.ratio
            turns = math.prod(later.ratio for later in m.stages[k:last])
            own = TorqueCoefficients(0.0, m.on_shaft(k) * turns, m.friction_on(k))
            rows.insert(0, TorqueCoefficients(*(through * a + b for a, b in zip(behind, own, strict=True))))
        first = TorqueCoefficients(0.0, self.motor_inertia * self.gear, self.no_load)
        return [TorqueCoefficients(*map(sum, zip(rows[0], first, strict=True))), *rows[1:]]
