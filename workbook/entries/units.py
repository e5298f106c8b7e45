"""Units at the edge, in SI: everything within is SI."""

from __future__ import annotations

import math

MM = 1e-3  # m
RPM = 2 * math.pi / 60  # rad/s
PER_MINUTE = 1 / 60  # 1/s
