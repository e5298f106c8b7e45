"""The motor: its limits, where a cycle brings it, what its surroundings leave of it. SI units."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drive.chain import require_not_negative
from engine.laws.base import Array

STANDSTILL = 1e-9  # rad/s (m/s of a load that travels); a slower shaft counts as standing


class TorqueFall(NamedTuple):
    """The speed beyond which a peak torque falls (rad/s), and by how much (Nm s): 0 where it does not."""

    knee: float = 0.0
    fall: float = 0.0

    @classmethod
    def between(cls, knee: float, peak_torque: float, fastest: float, end_torque: float) -> "TorqueFall":
        """Return how a peak torque (Nm) falls from a knee to ``end_torque`` at the largest speed, if it is less."""
        return cls(knee, max(0.0, peak_torque - end_torque) / (fastest - knee)) if knee < fastest else cls()

    def corner(self, peak_torque: float) -> float:
        """Return the falling line at no speed (Nm); no limit where it does not fall."""
        return peak_torque + self.fall * self.knee if self.fall else math.inf

    def reserve(self, peak_torque: float, torque: Array, speed: Array) -> Array:
        """Return what a motor of a peak torque (Nm) has left at speeds (rad/s) at which it gives torques (Nm)."""
        curve = peak_torque - self.fall * np.maximum(0.0, np.abs(speed) - self.knee)
        return np.asarray(curve - np.abs(torque))


class TorqueCurve(NamedTuple):
    """Largest torque (Nm) of a servo-motor against its speed (rad/s): corners, speeds rising from 0."""

    speed: Array
    torque: Array

    def at(self, speed: ArrayLike) -> Array:
        """Return T_M,max at a speed of either direction; 0 beyond the last corner."""
        return np.asarray(np.interp(np.abs(speed), self.speed, self.torque, right=0.0))


RATED_AT = 25.0  # °C at which a motor's rated torque holds in S4
WINDING_LIMIT = 175.0  # °C; inferred from S4, problem 2, where 35 °C lowers the torque from 0.147 to 0.142 Nm
UPPER = ((-1, 3), (-1, 2), (-1, 1), (0, 0), (1, 1), (1, 2), (1, 3))
CORNERS = (*((*one, 1) for one in UPPER), *((*one, -1) for one in reversed(UPPER)), (-1, 3, 1))
"""of the limits in the plane of speed and torque: side; which speed (0: none, 1 and 2: where the continuous torque and
the peak torque change their slope, the lower first, 3: the largest); above or below"""


@dataclass(frozen=True)
class Motor:
    """A motor and its limits, infinite where none is given. Raises ValueError for a limit not above 0."""

    inertia: float  # kg m²
    rated_torque: float = math.inf  # Nm, given continuously at the rated speed
    peak_torque: float = math.inf  # Nm, for a short time
    max_speed: float = math.inf  # rad/s
    stall_torque: float = 0.0  # Nm, continuously at standstill; it counts where it is larger
    rated_speed: float = math.inf  # rad/s

    def __post_init__(self) -> None:
        require_not_negative("motor", inertia=self.inertia)
        for name in ("rated_torque", "peak_torque", "max_speed", "rated_speed"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"motor: {name} is {getattr(self, name):g}; expected more than 0")

    def continuous(self, speed: ArrayLike) -> Array:
        """Return the torque (Nm) that it can give all the time at a mean speed (rad/s): see :func:`continuous`."""
        return continuous(self.rated_torque, self.stall_torque, self.rated_speed, speed)

    def corners(self, lowest_speed: float, knee: float = 0.0, fall: float = 0.0) -> "LimitCorners":
        """Return the limits as a line round the plane of speed and torque, from the upper left corner.

        It begins at speed 0, or on the other side too where ``lowest_speed`` (rad/s) says that the motor turns
        backward. The peak torque falls beyond ``knee`` (rad/s) by ``fall`` (Nm s), or not at all.
        """
        side, which, up = np.array(CORNERS).T
        begins = knee if fall else self.max_speed
        bends = sorted((min(self.rated_speed, self.max_speed), begins))
        speed = side * np.array([0.0, *bends, self.max_speed])[which]
        speed = speed if lowest_speed < -STANDSTILL else np.maximum(speed, 0.0)
        peak = self.peak_torque - fall * np.maximum(0.0, np.abs(speed) - begins)
        return LimitCorners(side > 0, speed, up * peak, up * self.continuous(speed))


class LimitCorners(NamedTuple):
    """A motor's limits by speed (rad/s) and torque (Nm), arrays of shape (15,); ``right`` where speed is above 0."""

    right: NDArray[np.bool_]
    speed: Array
    peak: Array
    continuous: Array

    @property
    def bends(self) -> Array:
        """The speeds (rad/s) at which the continuous and the peak torque change their slope, the lower first."""
        return self.speed[[CORNERS.index((1, which, 1)) for which in (1, 2)]]


class LimitCheck(NamedTuple):
    """A quantity against the motor's limit, in the limit's unit."""

    name: str
    value: float
    limit: float

    @property
    def ok(self) -> bool:
        """Whether it is within the limit."""
        return self.value <= self.limit

    @property
    def reserve(self) -> float:
        """The limit over the quantity; 0 where nothing is asked for."""
        return self.limit / self.value if self.value else 0.0

    @property
    def use(self) -> float:
        """The share of the limit that is asked for; infinite of a limit of 0."""
        return self.value / self.limit if self.limit > 0.0 else math.inf


class Reserve(NamedTuple):
    """What a cycle asks of a motor against its limits."""

    rms_torque: LimitCheck
    peak_torque: LimitCheck
    speed: LimitCheck


def continuous(rated: ArrayLike, stall: ArrayLike, rated_speed: ArrayLike, speed: ArrayLike) -> Array:
    """Return the torque (Nm) that motors can give all the time at a mean speed (rad/s).

    A straight line from the stall torque (Nm) to the rated torque at the rated speed (rad/s), level beyond; level
    throughout where the stall torque is not larger. RMS torque is compared with it at the mean of |ω|: losses by
    current count by the square of the torque, those by speed about in proportion to it.
    Source: Siemens, SINAMICS S210, operating instructions 12/2017, 3.3, effective torque and average speed of a duty
    cycle; SIMOTICS S-1FK2, configuration manual 02/2022, 6.1, the S1 characteristic that falls from the stall torque.
    """
    drop = np.maximum(0.0, np.asarray(stall) - rated)
    return np.asarray(rated + drop * (1.0 - np.minimum(1.0, np.abs(speed) / np.asarray(rated_speed))))


def reserve(motor: Motor, rms_torque: float, peak_torque: float, speed: float, mean_speed: float) -> Reserve:
    """Return RMS torque (Nm) at the mean speed, peak torque and largest speed (rad/s), each against its limit."""
    return Reserve(
        LimitCheck("RMS torque", rms_torque, float(motor.continuous(mean_speed))),
        LimitCheck("peak torque", peak_torque, motor.peak_torque),
        LimitCheck("speed", speed, motor.max_speed),
    )


def derating(temperature: float, limit: float = WINDING_LIMIT, rated_at: float = RATED_AT) -> float:
    """Return the share of its rated torque that a motor can give at a temperature (°C) of its surroundings.

    sqrt((T_max − T)/(T_max − T_rated)), and no more than 1 where it is colder: 0.9661 at 35 °C.
    Raises ValueError unless both temperatures are below ``limit`` (T_max). Source: S4, problem 2, last lines.
    """
    if not max(temperature, rated_at) < limit:
        raise ValueError(f"{temperature:g} °C, rated at {rated_at:g} °C; expected less than the limit, {limit:g} °C")
    return min(1.0, math.sqrt((limit - temperature) / (limit - rated_at)))
