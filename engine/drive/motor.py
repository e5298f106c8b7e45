"""The motor: its limits, the reserves of a cycle against them, derating by temperature. SI units."""

import math
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive.chain import require_not_negative
from engine.laws.base import Array

STANDSTILL = 1e-9  # rad/s (m/s of a load that travels); a slower shaft counts as standing


class TorqueFall(NamedTuple):
    """The straight line on which a peak torque falls beyond a speed; by default it does not fall."""

    knee: float = 0.0  # speed at which the fall begins (rad/s)
    fall: float = 0.0  # decrease of torque by speed (Nm s)

    @classmethod
    def between(cls, knee: tuple[float, float], end: tuple[float, float]) -> "TorqueFall":
        """Return the fall between two points of speed (rad/s) and peak torque (Nm): the knee, and the largest speed."""
        (begins, full), (fastest, least) = knee, end
        return cls(begins, max(0.0, full - least) / (fastest - begins)) if begins < fastest else cls()

    def corner(self, peak_torque: float) -> float:
        """Return the torque (Nm) of the falling line extended to speed 0; infinite if it does not fall."""
        return peak_torque + self.fall * self.knee if self.fall else math.inf

    def fallen(self, speed: ArrayLike) -> Array:
        """Return the torque (Nm) by which it has fallen at speeds (rad/s) of either direction."""
        return np.asarray(self.fall * np.maximum(0.0, np.abs(speed) - self.knee))


LEVEL = TorqueFall()  # of a peak torque that does not fall


RATED_AT = 25.0  # °C of the surroundings, to which a motor's rated torque applies in S4
# °C; inferred from S4, problem 2, where 35 °C lowers the torque from 0.147 to 0.142 Nm
WINDING_LIMIT = 175.0
UPPER = ((-1, 3), (-1, 2), (-1, 1), (0, 0), (1, 1), (1, 2), (1, 3))
CORNERS = (*((*corner, 1) for corner in UPPER), *((*corner, -1) for corner in reversed(UPPER)), (-1, 3, 1))
"""corners of the limits in the plane of speed and torque: sign of the speed; which speed (0: 0; 1, 2: the lower and the
higher of those at which continuous and peak torque change their slope; 3: the largest); sign of the torque"""


@dataclass(frozen=True)
class Motor:
    """A motor and its limits, by default infinite. Raises ValueError for a limit that is not above 0."""

    inertia: float  # of the rotor (kg m²)
    rated_torque: float = math.inf  # continuous, at the rated speed (Nm)
    peak_torque: float = math.inf  # for a short time (Nm)
    max_speed: float = math.inf  # rad/s
    # continuous, at standstill (Nm); ignored unless it is above the rated torque
    stall_torque: float = 0.0
    rated_speed: float = math.inf  # rad/s
    falling: TorqueFall = field(default=LEVEL, kw_only=True)  # of the peak torque

    def __post_init__(self) -> None:
        require_not_negative("motor", inertia=self.inertia)
        for name in ("rated_torque", "peak_torque", "max_speed", "rated_speed"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"motor: {name} is {getattr(self, name):g}; expected more than 0")

    def continuous(self, speed: ArrayLike) -> Array:
        """Return the continuous torque (Nm) at a mean speed (rad/s): see :func:`continuous`."""
        return continuous(self.rated_torque, self.stall_torque, self.rated_speed, speed)

    def peak_at(self, speed: ArrayLike) -> Array:
        """Return the peak torque (Nm) at speeds (rad/s) of either direction."""
        return np.asarray(self.peak_torque - self.falling.fallen(speed))

    def corners(self, lowest_speed: float) -> "LimitCorners":
        """Return the limits as a closed line in the plane of speed and torque, from its upper left corner.

        It extends to negative speeds only if ``lowest_speed`` (rad/s) is negative.
        """
        side, which, up = np.array(CORNERS).T
        begins = min(self.falling.knee, self.max_speed) if self.falling.fall else self.max_speed
        bends = sorted((min(self.rated_speed, self.max_speed), begins))
        speed = side * np.array([0.0, *bends, self.max_speed])[which]
        speed = speed if lowest_speed < -STANDSTILL else np.maximum(speed, 0.0)
        return LimitCorners(side > 0, speed, up * self.peak_at(speed), up * self.continuous(speed))


class LimitCorners(NamedTuple):
    """A motor's limits in the plane of speed and torque, arrays of shape (15,)."""

    right: NDArray[np.bool_]  # whether the corner is at positive speed
    speed: Array  # rad/s
    peak: Array  # Nm
    continuous: Array  # Nm

    @property
    def bends(self) -> Array:
        """The speeds (rad/s) at which the continuous and the peak torque change their slope, the lower first."""
        return self.speed[[CORNERS.index((1, which, 1)) for which in (1, 2)]]


class LimitCheck(NamedTuple):
    """A quantity of a cycle against its limit, both in the same unit."""

    name: str
    value: float
    limit: float

    @property
    def ok(self) -> bool:
        """Whether it is within the limit."""
        return self.value <= self.limit

    @property
    def reserve(self) -> float:
        """The limit over the quantity; 0 if the quantity is 0."""
        return self.limit / self.value if self.value else 0.0

    @property
    def use(self) -> float:
        """The quantity over the limit; infinite if the limit is 0."""
        return self.value / self.limit if self.limit > 0.0 else math.inf


class Reserve(NamedTuple):
    """The quantities of a cycle against a motor's limits."""

    rms_torque: LimitCheck
    peak_torque: LimitCheck
    speed: LimitCheck


def continuous(rated: ArrayLike, stall: ArrayLike, rated_speed: ArrayLike, speed: ArrayLike) -> Array:
    """Return the continuous torque of motors at a mean speed.

    It falls in a straight line from the stall torque to the rated torque at the rated speed, constant beyond. The RMS
    torque is compared with it at the mean of |ω|: copper losses grow with the square of the torque, losses by speed
    about in proportion to speed. Source: Siemens, SINAMICS S210, operating instructions 12/2017, 3.3, effective torque
    and average speed of a duty cycle; SIMOTICS S-1FK2, configuration manual 02/2022, 6.1, the S1 characteristic that
    falls from the stall torque.

    Parameters
    ----------
    rated, stall : array_like, Nm
        Continuous at the rated speed and at standstill; a stall torque that is not larger is ignored.
    rated_speed, speed : array_like, rad/s
        The rated speed, and the mean of |ω| over the cycle.

    Returns
    -------
    array, Nm
    """
    drop = np.maximum(0.0, np.asarray(stall) - rated)
    return np.asarray(rated + drop * (1.0 - np.minimum(1.0, np.abs(speed) / np.asarray(rated_speed))))


def reserve(motor: Motor, rms_torque: float, peak_torque: float, speed: float, mean_speed: float) -> Reserve:
    """Return the quantities of a cycle against the limits of a motor.

    Parameters
    ----------
    motor : Motor
    rms_torque, peak_torque : float, Nm
    speed, mean_speed : float, rad/s
        The largest |ω|, and the mean, at which the continuous torque limits the RMS torque.

    Returns
    -------
    Reserve
        Of the peak torque against the motor's own up to its largest speed, not against a curve.
    """
    return Reserve(
        LimitCheck("RMS torque", rms_torque, float(motor.continuous(mean_speed))),
        LimitCheck("peak torque", peak_torque, motor.peak_torque),
        LimitCheck("speed", speed, motor.max_speed),
    )


def derating(temperature: float, limit: float = WINDING_LIMIT, rated_at: float = RATED_AT) -> float:
    """Return the share of its rated torque that a motor can give at a temperature of its surroundings.

    It is √((T_max − T)/(T_max − T_rated)), at most 1: 0.9661 at 35 °C. Source: S4, problem 2, last lines.

    Parameters
    ----------
    temperature, rated_at : float, °C
        T of the surroundings, and T_rated, to which the rated torque applies.
    limit : float, °C
        T_max of the winding.

    Returns
    -------
    float
        Dimensionless.

    Raises
    ------
    ValueError
        Unless both temperatures are below the limit.
    """
    if not max(temperature, rated_at) < limit:
        raise ValueError(f"{temperature:g} °C, rated at {rated_at:g} °C; expected less than the limit, {limit:g} °C")
    return min(1.0, math.sqrt((limit - temperature) / (limit - rated_at)))
