"""Phases that take over velocity from their neighbours: as two halves of their law, as a polynomial, or as a line."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from math import perm

from engine.laws import Law
from engine.laws.ends import BoundaryValues
from engine.laws.piece import POWERS
from engine.laws.polynomials import BoundaryLine, BoundaryPolynomial, HalvedPolynomial
from engine.laws.pulse_law import PulseLaw
from engine.motion.joining import EndCondition, JoinedMotion, Rates, agrees, slope
from engine.motion.phase import Phase

STRAIGHT, NEVER, PULSES, FIXED = -1, 0, 1, 2
"""how a law meets its neighbours: at its own constant velocity; only at rest; at any velocity by the heights of its two
pulses; at its own end rates"""
LINE = 2  # mode of a phase whose boundary values a straight line meets


def end_mode(law: Law) -> int:
    """Return how a law meets its neighbours: :data:`STRAIGHT` to :data:`FIXED`, or 3, 5, 7, a polynomial's degree."""
    if slope(Phase(law, 0.0, 1.0)) is not None:
        return STRAIGHT
    if law.fixes_ends:
        return FIXED
    if isinstance(law, HalvedPolynomial):
        return 1 + 2 * len(law.takes) if law.takes else NEVER
    return PULSES if isinstance(law, PulseLaw) else NEVER


def early_of(law: Law) -> int:
    """Return the number of pieces of the first pulse of a law of mode :data:`PULSES`; 0 of all others."""
    return law.early if end_mode(law) == PULSES and isinstance(law, PulseLaw) else 0


@dataclass(frozen=True)
class Handover:
    """A phase with its law as carried out, and the conditions at its ends."""

    phase: Phase
    begin: EndCondition  # at its begin
    end: EndCondition  # at its end
    kinds: tuple[str, str]  # of begin and end by VDI 2143: letters of "RGUB"
    fault: str  # why the law cannot meet the conditions; empty if it can
    entered: Rates | None = None  # y', y'', y''' entered for its begin
    # whether a straight line or dwell at its begin has other rates than the entered
    contrary: bool = False

    @property
    def end_mode(self) -> int:
        """The way in which its law meets its neighbours: see :func:`end_mode`."""
        return end_mode(self.phase.named)

    @property
    def slope(self) -> float:
        """Slope y' of a straight line; 0 of all other laws."""
        return slope(self.phase) or 0.0

    @property
    def ended(self) -> bool:
        """Whether it is carried out with boundary values."""
        return self.phase.origin is not None

    @property
    def mode(self) -> int:
        """The way in which it is carried out: 0 as the law between rests, :data:`LINE`, else its :attr:`end_mode`."""
        if not self.ended:
            return 0
        return LINE if isinstance(self.phase.law, BoundaryLine) else self.end_mode

    @cached_property
    def halves(self) -> tuple[float, float]:
        """Factors of its law in both halves, in units of y, besides the end velocities; 0 of a polynomial."""
        joined, law = self.phase.law, self.phase.named
        if not self.ended:
            return self.phase.lift, self.phase.lift
        if self.mode == PULSES and isinstance(joined, PulseLaw) and isinstance(law, PulseLaw):
            return joined.acceleration / law.acceleration, joined.deceleration / law.deceleration
        return 0.0, 0.0

    @property
    def drifts(self) -> tuple[float, float]:
        """Velocities y' that are added in both halves; 0 of a law between rests."""
        return (self.begin.required.v, self.end.required.v) if self.ended else (0.0, 0.0)

    @property
    def early(self) -> int:
        """Number of pieces of the first pulse of a law of two pulses; 0 of all others."""
        return early_of(self.phase.named) if self.mode == PULSES else 0

    def base(self, late: bool, y: float) -> float:
        """Return the position at which its law has s = 0 in the first or the ``late`` half; it begins at ``y``."""
        lift, drift = self.halves[1], self.drifts[1]
        return y + self.phase.lift - lift - drift * self.phase.duration if late else y

    @cached_property
    def powers(self) -> tuple[float, ...]:
        """e0, e1, e2 … of y = Σ e_n ξⁿ from the begin of a polynomial with boundary values; 0 of all others."""
        law = self.phase.law
        if not isinstance(law, BoundaryPolynomial):
            return (0.0,) * (POWERS + 2)
        c = (*law.polynomial, *(0.0,) * POWERS)[:POWERS]
        higher = [value / perm(n, 2) for n, value in enumerate(c, 2)]
        return (0.0, law.ends.v0, *higher)

    @property
    def jerk_powers(self) -> tuple[float, float, float]:
        """A, B, C of A + B ξ + C ξ², with which the jerk of a polynomial changes its sign between its ends; else 0.

        Of degree 5 it is the jerk; of degree 7 the jerk over ξ (1 − ξ), for it is 0 at both ends.
        """
        e = self.powers
        if self.mode == 5:
            return 6.0 * e[3], 24.0 * e[4], 60.0 * e[5]
        return (24.0 * e[4], 60.0 * e[5] + 24.0 * e[4], -210.0 * e[7]) if self.mode == 7 else (0.0, 0.0, 0.0)

    @property
    def jerk_root(self) -> float:
        """W = −(B ± √(B² − 4 A C))/2, by which both zeros are W/C and A/W; 0 where there are none."""
        a, b, c = self.jerk_powers
        square = b**2 - 4.0 * a * c
        return -0.5 * (b + math.copysign(math.sqrt(square), b)) if square >= 0.0 else 0.0

    @property
    def bends(self) -> tuple[float, float]:
        """Shares ξ at which the acceleration of a polynomial is largest or lowest; 0, or beyond 0 to 1, for none."""
        (a, _, c), w = self.jerk_powers, self.jerk_root
        return w / c if c else 0.0, a / w if w else 0.0

    @property
    def hermite(self) -> BoundaryValues:
        """The boundary values of a polynomial; all 0 of all others."""
        law = self.phase.law
        return law.ends if isinstance(law, BoundaryPolynomial) else BoundaryValues(stroke=0.0)

    @property
    def reversing(self) -> float:
        """Velocity y' between two pulses with boundary values; 0 of all others."""
        law = self.phase.law
        return law.top / self.phase.duration if self.mode == PULSES and isinstance(law, PulseLaw) else 0.0


def handovers(joined: JoinedMotion, through: Mapping[int, Rates], periodic: bool) -> tuple[Handover, ...]:
    """Return the handover of each phase of a joined motion.

    Parameters
    ----------
    joined : JoinedMotion
    through : mapping of int to Rates
        The prescribed rates, as :func:`join_phases` takes them.
    periodic : bool
        Whether the last phase meets the first.
    """
    slopes = [slope(phase) for phase in joined.motion.phases]
    reasons = {fault.phase: fault.reason for fault in joined.faults if slopes[fault.phase] is None}

    def contrary(k: int) -> bool:
        beside = slopes[k], slopes[k - 1] if k or periodic else None
        return k in through and any(rate is not None and not agrees(through[k], rate) for rate in beside)

    both = zip(joined.motion.phases, joined.required, joined.kinds, strict=True)
    return tuple(
        Handover(phase, *asked, kinds, reasons.get(k, ""), through.get(k), contrary(k))
        for k, (phase, asked, kinds) in enumerate(both)
    )
