"""By how much results of a drive at its points may be off the exact engine's: what sheets state, judges and tests read.

Measured on random machines of each kind, with hand-overs at speed, laws that swing, process forces, losses.
"""

from typing import NamedTuple

from engine.drive.drivetrain import Drivetrain
from engine.drive.mechanisms.variable_ratio import PositionTable


class Bounds(NamedTuple):
    """Largest errors as shares: of the largest torque, of the speed, of the largest power, of energies together."""

    peak_torque: float = 5e-3  # highest and lowest, of motor and reducer
    rms_torque: float = 1e-3
    mean_torque: float = 2e-3  # cubic mean behind the reducer
    speed: float = 5e-3  # the largest
    mean_speed: float = 1e-3
    peak_power: float = 0.03  # highest and lowest
    mean_power: float = 0.01
    energy: float = 0.03  # driven, and regenerated, of both together


# without viscous friction peaks are exact, if the acceleration is monotone in each piece
CONSTANT = Bounds()
CHANGING = Bounds()
TABLE = Bounds(peak_torque=2e-2, rms_torque=1.5e-2, mean_torque=1e-2, speed=1e-2)
"""of a table of positions, whose ratio bends at each of its points"""
BY_ANGLE = Bounds(peak_torque=2.5e-2)  # of an axis that turns most of the way in one interval


def stated_bounds(train: Drivetrain) -> Bounds:
    """Return the bounds of a drivetrain."""
    if isinstance(train.linkage, PositionTable):
        return TABLE
    return BY_ANGLE if train.by_angle else CHANGING if train.linkage else CONSTANT
