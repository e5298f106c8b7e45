"""Units at the edge: what is entered and shown in them, in SI within; a sheet's figures are scaled here alone."""

from math import pi, tau
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

MM = 1e-3  # m
MS = 1e-3  # s
MM_PER_TURN = MM / tau  # m/rad
PERCENT = 1e-2
KW = 1e3  # W
KG_CM2 = 1e-4  # kg m²
DEGREE = pi / 180  # rad
RPM = tau / 60  # rad/s
PER_MINUTE = 1 / 60  # 1/s
PER_HOUR = 1 / 3600  # 1/s
PER_RPM = 1 / RPM  # s/rad: of a slope over speed

Real = TypeVar("Real", float, NDArray[np.float64])


def si(value: Real, unit: float) -> Real:
    """Return in SI what is given in a unit."""
    return value * unit


def shown(value: Real, unit: float) -> Real:
    """Return in a unit what is in SI."""
    return value / unit
