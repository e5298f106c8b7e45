"""Vibration that a move leaves in an oscillator behind it, and the input shapers that cancel it.

The load hangs on the driven point by a spring: x is its deflection, ẍ + 2ζω ẋ + ω² x = −s̈. After the move of the
time T it swings at ω_d = ω √(1 − ζ²) with the amplitude A = e^(−ζωT) |∫ s̈ e^((ζω + iω_d) t) dt| / ω_d, which decays.
Source: P. Meckl and W. Seering, Minimizing residual vibration, J. Vib. Acoust. 112 (1990), 378.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from engine.laws.extremes import NODES, WEIGHTS, Curve

TOLERABLE = 0.05  # share of the vibration that a shaper may leave within its band


def left_by(velocities: Sequence[tuple[Curve, float, float]], omega: float, damping: float = 0.0) -> float:
    """Return the amplitude of the vibration at the end of a move of several pieces, in the units of its position.

    By parts A = ω |∫ ṡ e^((ζω + iω_d) (t − T)) dt| / ω_d, in which a jump of the velocity needs no term of its own.

    Parameters
    ----------
    velocities : sequence of (Curve, float, float)
        The velocity of each piece over the time from its begin, how long it lasts, and the time from its begin to the
        end of the move; in any unit of time.
    omega : float, in rad over this unit
        Natural angular frequency without damping.
    damping : float, dimensionless
        Damping ratio ζ, from 0 to below 1.

    Returns
    -------
    float
    """
    _require_damping(damping)
    damped, total = math.sqrt(1.0 - damping**2), 0.0 + 0.0j
    for velocity, lasts, until in velocities:
        turned = lasts * (omega + math.fsum(abs(rate) for _, rate, _ in velocity.sines))
        parts = 1 + int(turned / math.pi)
        u = ((np.arange(parts)[:, None] + (NODES + 1.0) / 2.0) * (lasts / parts)).ravel()
        weights = np.tile(WEIGHTS, parts) * (0.5 * lasts / parts)
        total += np.exp(-omega * (damping + 1j * damped) * (until - u)) @ (weights * velocity(u))
    return float(abs(total)) / damped


def _require_damping(damping: float, below: float = 1.0) -> None:
    """Raise ValueError for a damping ratio outside the limits."""
    if not 0.0 <= damping < below:
        raise ValueError(f"damping is {damping:g}; expected a ratio from 0 to below {below:g}")


@dataclass(frozen=True)
class Shaper:
    """Impulses in which a move is given out so that the vibrations that they leave cancel each other.

    They are half a period of the damped oscillator apart. ZV leaves no vibration at the frequency it is made for, ZVD
    has a level minimum there too; EI, for an oscillator without damping, leaves 5 % there and less on both sides.
    Source: W. Singhose, Command shaping for flexible systems, Int. J. Precis. Eng. Manuf. 10 (2009), 153.
    """

    KINDS: ClassVar[tuple[str, ...]] = ("ZV", "ZVD", "EI")
    kind: str  # of KINDS
    damping: float = 0.0  # damping ratio ζ that it is made for, below 0.2; 0 of EI

    def __post_init__(self) -> None:
        if self.kind not in self.KINDS:
            raise ValueError(f"kind is {self.kind!r}; expected {', '.join(self.KINDS)}")
        _require_damping(self.damping, 1e-9 if self.kind == "EI" else 0.2)

    @property
    def shares(self) -> tuple[float, ...]:
        """The share of the move that each impulse gives out; their sum is 1."""
        if self.kind == "EI":
            outer = (1.0 + TOLERABLE) / 4.0
            return outer, 1.0 - 2.0 * outer, outer
        fall = math.exp(-self.damping * math.pi / math.sqrt(1.0 - self.damping**2))
        weights = (1.0, fall) if self.kind == "ZV" else (1.0, 2.0 * fall, fall**2)
        return tuple(weight / math.fsum(weights) for weight in weights)

    @property
    def time(self) -> float:
        """The time by which it lengthens a move, in natural periods of the oscillator without damping."""
        return (len(self.shares) - 1) / 2.0 / math.sqrt(1.0 - self.damping**2)

    def left(self, ratio: float) -> float:
        """Return the share of the vibration that it leaves at a natural frequency over its design frequency."""
        natural = 2.0 * math.pi * ratio * (self.damping + 1j * math.sqrt(1.0 - self.damping**2))
        times = np.linspace(0.0, self.time, len(self.shares))
        return float(abs(np.exp(natural * (times - self.time)) @ np.array(self.shares)))

    @property
    def band(self) -> tuple[float, float]:
        """The natural frequencies, over its design frequency, between which it leaves at most 5 %."""
        from scipy.optimize import brentq  # slow to import

        low, high = (
            float(brentq(lambda ratio: self.left(ratio) - TOLERABLE, 1.0 + 0.01 * way, 1.0 + 0.5 * way))
            for way in (-1.0, 1.0)
        )
        return low, high
