"""Where a book has the load that a motor is chosen for."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class LoadCells:
    """Where a template has the load at its own shaft, in the notation of :mod:`workbook.book.declare`.

    ``time`` (s), ``speed`` (rad/s), ``acceleration`` (rad/s²) and ``torque`` (Nm, T*_L = T_L + J_L ω̇_L) are columns
    of one table, such as ``[drive.w]``; the other four are formulas without ``=``, such as ``drive_wrms``.
    """

    time: str
    speed: str
    acceleration: str
    torque: str
    acceleration_rms: str
    torque_rms: str
    power_rate_mean: str
    max_speed: str
