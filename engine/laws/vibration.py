"""Vibration that a move leaves in an oscillator behind it, and the input shapers that cancel it.

The load hangs on the driven point by a spring: x is its deflection, ẍ + 2ζω ẋ + ω² x = −s̈. After the move of the
time T it swings at ω_d = ω √(1 − ζ²) with the amplitude A = e^(−ζωT) |∫ s̈ e^((ζω + iω_d) t) dt| / ω_d, which decays.
Source: P. Meckl and W. Seering, Minimizing residual vibration, J. Vib. Acoust. 112 (1990), 378.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

import numpy as np

from engine.laws.extremes import NODES, WEIGHTS, Curve
from engine.laws.family import Law
from engine.laws.piece import Piece, gains, located
from engine.laws.pieces import PieceLaw

TOLERABLE = 0.05  # share of the vibration that a shaper may leave within its band
SHORTEST = 0.01  # of a move: so much at least is left to the law that is given out in impulses
NEAR = 1e-3  # of the largest acceleration: so near are the cubics of a law that is given out in impulses
APART = 1e-9  # of a move: breaks of laws that are nearer are the same
SHARES = np.linspace(0.0, 1.0, 9)  # of a cubic, at which it is compared
# what a cubic adds to a(0), by its powers 1, 2 and 3: at its end, to the gain of v and to that of s
ADDS = np.array([[1.0, 1.0, 1.0], [1 / 2, 1 / 3, 1 / 4], [1 / 6, 1 / 12, 1 / 20]])


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
    has a level minimum there too; EI, whose shares are those without damping, leaves 5 % there and less on both sides.
    Source: W. Singhose, Command shaping for flexible systems, Int. J. Precis. Eng. Manuf. 10 (2009), 153.
    """

    KINDS: ClassVar[tuple[str, ...]] = ("ZV", "ZVD", "EI")
    kind: str  # of KINDS
    damping: float = 0.0  # damping ratio ζ that it is made for, below 0.2; of EI below 0.05

    def __post_init__(self) -> None:
        if self.kind not in self.KINDS:
            raise ValueError(f"kind is {self.kind!r}; expected {', '.join(self.KINDS)}")
        _require_damping(self.damping, 0.05 if self.kind == "EI" else 0.2)

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

    def law(self, base: Law, periods: float, room: int) -> PieceLaw:
        """Return the law from rest to rest that gives another out in the impulses, by cubics of the acceleration.

        Each impulse begins the other law, times its share, in the time that the last of them leaves. The cubics go from
        break to break of their sum, with its s, v and a at both ends; they are halved until they are near it.

        Parameters
        ----------
        base : Law
            From rest to rest.
        periods : float
            How many natural periods of the oscillator without damping the move lasts.
        room : int
            Pieces at most.

        Returns
        -------
        PieceLaw
            Of cubics whose acceleration is within 0.1 % of the largest.

        Raises
        ------
        ValueError
            For a move that is too short for the impulses; where there is no room for so many pieces.
        """
        lasts = 1.0 - self.time / periods
        if lasts < SHORTEST:
            least, move = self.time / (1.0 - SHORTEST), f"the move lasts {periods:.4g} natural periods of its load"
            raise ValueError(f"{move}; expected at least {least:.4g}, as {self.kind} needs")
        laws = []
        for share, wait in zip(self.shares, np.linspace(0.0, 1.0 - lasts, len(self.shares)).tolist(), strict=True):
            moves = (piece.scaled(share / lasts**2, lasts) for piece in base.as_pieces())
            laws.append(PieceLaw([Piece(wait), *moves, Piece(max(0.0, 1.0 - wait - lasts))]))
        breaks = np.unique([each for law in laws for each in law.breaks if APART < each < 1.0 - APART])
        edges = [0.0, *breaks[np.diff(breaks, prepend=0.0) > APART].tolist(), 1.0]
        while len(edges) <= room + 1:
            pieces, largest, off = zip(*(cubic_near(laws, *ends) for ends in pairwise(edges)), strict=True)
            far = np.array(off) > NEAR * max(largest)
            if not far.any():
                return PieceLaw(pieces)
            edges = sorted([*edges, *(np.array([*map(sum, pairwise(edges))])[far] / 2.0).tolist()])
        raise ValueError(f"a law of more than {room} pieces; expected another to be given out by {self.kind}")


def cubic_near(laws: Sequence[PieceLaw], begin: float, end: float) -> tuple[Piece, float, float]:
    """Return a cubic with s, v and a of the sum of laws at two ξ, the largest a between these, and how far it is off.

    None of the laws has a break between them.
    """
    lasts, ends, a = end - begin, np.zeros((2, 2)), np.zeros_like(SHARES)
    for law in laws:
        at, between = law.evaluate(np.array([begin, end])), located(law.pieces, np.array([0.5 * (begin + end)]))
        row = np.array(law.pieces[between.piece[0]].row)
        ends, a = np.add(ends, [at.s, at.v]), a + gains(between.u + (SHARES - 0.5) * lasts, row)[2]
    (s0, s1), (v0, v1) = ends
    adds = a[-1] - a[0], (v1 - v0) / lasts - a[0], (s1 - s0 - v0 * lasts) / lasts**2 - 0.5 * a[0]
    powers = [a[0], *np.linalg.solve(ADDS, adds)]
    off = abs(np.polynomial.polynomial.polyval(SHARES, powers) - a).max()
    return Piece(lasts, tuple(c / lasts**k for k, c in enumerate(powers))), float(abs(a).max()), float(off)
