"""The motor: its limits, where a cycle brings it, what its surroundings leave of it. SI units."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from engine.drivetrain.chain import require_not_negative
from engine.drivetrain.losses import STANDSTILL
from engine.laws.base import Array

RATED_AT = 25.0
"""°C at which a motor's rated torque holds in S4"""

WINDING_LIMIT = 175.0
"""°C; inferred from S4, problem 2, where 35 °C lowers the torque from 0.147 to 0.142 Nm"""

CORNERS = (
    (0, 0, -1),
    (1, 0, -1),
    (1, 1, -1),
    (1, 1, 1),
    (1, 0, 1),
    (0, 0, 1),
    (0, 1, 1),
    (0, 1, -1),
    (0, 0, -1),
)
"""of the limits in the plane of speed and torque: right side; at the largest speed, or where the peak torque begins to
fall; above or below"""


@dataclass(frozen=True)
class Motor:
    """Inertia (kg m²), rated and peak torque (Nm) and largest speed (rad/s); no limit is given by infinity.

    Raises ValueError for a negative inertia or a limit that is not above 0.
    """

    inertia: float
    rated_torque: float = math.inf
    peak_torque: float = math.inf
    max_speed: float = math.inf

    def __post_init__(self) -> None:
        require_not_negative("motor", inertia=self.inertia)
        for name in ("rated_torque", "peak_torque", "max_speed"):
            if not getattr(self, name) > 0.0:
                raise ValueError(f"motor: {name} is {getattr(self, name):g}; expected more than 0")

    def derated(self, share: float) -> Motor:
        """Return the motor with a share of its rated torque left: see :func:`derating`."""
        return replace(self, rated_torque=self.rated_torque * share)

    def corners(self, lowest_speed: float, knee: float = 0.0, fall: float = 0.0) -> Corners:
        """Return the limits as a line round the plane of speed and torque, from the lower left corner.

        It begins at speed 0, or on the other side too where ``lowest_speed`` (rad/s) says that the motor turns
        backward. The peak torque falls beyond ``knee`` (rad/s) by ``fall`` (Nm s), or not at all.
        """
        right, outer, up = np.array(CORNERS, dtype=np.float64).T
        left = -1.0 if lowest_speed < -STANDSTILL else 0.0
        begins = knee if fall else self.max_speed
        speed = np.where(right > 0.0, 1.0, left) * np.where(outer > 0.0, self.max_speed, begins)
        peak = self.peak_torque - fall * np.maximum(0.0, np.abs(speed) - begins)
        return Corners(right > 0.0, speed, up * peak, up * self.rated_torque)


class Corners(NamedTuple):
    """A motor's limits in the plane of speed (rad/s) and torque (Nm): arrays of shape (9,).

    ``right`` says of each corner whether it is at the largest speed.
    """

    right: NDArray[np.bool_]
    speed: Array
    peak: Array
    rated: Array


class LimitCheck(NamedTuple):
    """A quantity against the motor's limit, in the limit's unit."""

    name: str
    value: float
    limit: float
    ok: bool

    @property
    def reserve(self) -> float:
        """The limit over the quantity; 0 where nothing is asked for."""
        return self.limit / self.value if self.value else 0.0

    @property
    def use(self) -> float:
        """The share of the limit that is asked for."""
        return self.value / self.limit


class Reserve(NamedTuple):
    """What a cycle asks of a motor against its limits."""

    rms_torque: LimitCheck
    peak_torque: LimitCheck
    speed: LimitCheck


def reserve(motor: Motor, rms_torque: float, peak_torque: float, speed: float) -> Reserve:
    """Return RMS torque (Nm), peak torque (Nm) and speed (rad/s), each against the motor's limit."""
    found = (
        ("RMS torque", rms_torque, motor.rated_torque),
        ("peak torque", peak_torque, motor.peak_torque),
        ("speed", speed, motor.max_speed),
    )
    return Reserve(*(LimitCheck(name, value, limit, value <= limit) for name, value, limit in found))


def derating(temperature: float, limit: float = WINDING_LIMIT, rated_at: float = RATED_AT) -> float:
    """Return the share of its rated torque that a motor can give at a temperature (°C) of its surroundings.

    sqrt((T_max − T)/(T_max − T_rated)), and no more than 1 where it is colder: 0.9661 at 35 °C.
    Raises ValueError unless both temperatures are below ``limit`` (T_max). Source: S4, problem 2, last lines.
    """
    if not max(temperature, rated_at) < limit:
        raise ValueError(f"{temperature:g} °C, rated at {rated_at:g} °C; expected less than the limit, {limit:g} °C")
    return min(1.0, math.sqrt((limit - temperature) / (limit - rated_at)))
