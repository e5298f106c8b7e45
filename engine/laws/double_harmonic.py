"""Double harmonic (DHM): the law of two sines."""

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from engine.laws.base import Array, Coefficients, Law, Vendors
from engine.laws.piece import Piece, cut, reversed_pieces

HALF_PI = math.pi / 2.0
FROM_REST = Piece(
    1.0,
    amplitude=2.0 * HALF_PI**2,
    omega=math.pi,
    phase=HALF_PI,
    amplitude2=-2.0 * HALF_PI**2,
    omega2=math.tau,
    phase2=HALF_PI,
)


@dataclass(frozen=True)
class DoubleHarmonic(Law):
    """s = sin⁴(πξ/2), from rest to a reversal: a = (π²/2)(cos πξ − cos 2πξ).

    At its end v = 0 and a = −π²: its mirror image has to follow, never a dwell. ``reversal`` says which end turns
    round, "end" or "start" (s = 1 − cos⁴(πξ/2)); else ValueError. Its beginning is as smooth as that of the
    polynomial 4-5-6-7.
    Source: LCamHdl, ADD_PROFILE, D_R_DOUBLE_HARMONIC and R_D_DOUBLE_HARMONIC; saltire.com, cam functions.
    """

    code = "DHM"
    name = "Double harmonic"
    source = "LCamHdl, ADD_PROFILE, D_R_DOUBLE_HARMONIC; saltire.com, cam functions"
    vendors = Vendors(siemens="D_R_DOUBLE_HARMONIC (60)")

    reversal: Literal["start", "end"] = "end"

    def __post_init__(self) -> None:
        if self.reversal not in ("start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'start' or 'end'")

    def _block(self, xi: Array) -> tuple[Array, Array, Array, Array]:
        ahead = self.reversal == "end"
        x = HALF_PI * (xi if ahead else 1.0 - xi)
        sin, cos = np.sin(x), np.cos(x)
        square = sin * sin
        s, v = square * square, 2.0 * math.pi * square * sin * cos
        a = math.pi**2 * square * (4.0 * cos * cos - 1.0)  # 3 cos² − sin²
        j = math.pi**3 * sin * cos * (4.0 * cos * cos - 1.0 - 4.0 * square)
        return (s, v, a, j) if ahead else (1.0 - s, v, -a, j)

    def _coefficients(self) -> Coefficients:
        greatest, power, braking = 9.0 / 16.0 * math.pi**2, math.pi**3 / 4.0, 675.0 * math.sqrt(15.0) / 8192.0
        up, down = (greatest, power), (math.pi**2, braking * math.pi**3)
        if self.reversal == "start":
            up, down = down, up
        return Coefficients(
            cv=3.0 * math.sqrt(3.0) * math.pi / 8.0,
            ca_max=up[0],
            ca_min=-down[0],
            ca_rms=math.pi**2 / 2.0,
            cj=math.inf,
            va_max=up[1],
            va_min=-down[1],
        )

    def as_pieces(self) -> tuple[Piece, ...]:
        """Return one piece of two sines."""
        return (FROM_REST,) if self.reversal == "end" else reversed_pieces((FROM_REST,))

    def monotone_pieces(self) -> tuple[Piece, ...]:
        """Return two pieces, which meet where the acceleration at the end at rest is largest: cos πξ = ¼."""
        peak = math.acos(0.25) / math.pi
        return tuple(cut(self.as_pieces()[0], [peak if self.reversal == "end" else 1.0 - peak]))
