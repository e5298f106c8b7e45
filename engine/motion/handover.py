"""What a phase becomes of its law where its neighbours hand velocity over to it: halves of the law, or a polynomial."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from math import perm

from engine.laws import Law
from engine.laws.ends import BoundaryLaw, BoundaryValues
from engine.laws.piece import POWERS
from engine.laws.polynomials import BoundaryLine, BoundaryPolynomial, HalvedPolynomial
from engine.laws.pulse_law import PulseLaw
from engine.motion.joining import BoundaryPhase, EndCondition, JoinedMotion, Rates, agrees, slope
from engine.motion.phase import Phase

STRAIGHT, NEVER, PULSES, FIXED = -1, 0, 1, 2
"""ways in which laws meet their neighbours: they have a velocity; take none; take one by the heights of two pulses;
keep the velocities that they have at their ends"""
LINE = 2  # of how a phase is carried out: its ends are those of a straight line


def end_mode(law: Law) -> int:
    """Return how a law meets its neighbours: as :data:`STRAIGHT` and so on, or by a polynomial of degree 3, 5 or 7."""
    if slope(Phase(law, 0.0, 1.0)) is not None:
        return STRAIGHT
    if isinstance(law, BoundaryLaw) and law.fixes_ends:
        return FIXED
    if isinstance(law, HalvedPolynomial):
        return 1 + 2 * len(law.takes) if law.takes else NEVER
    return PULSES if isinstance(law, PulseLaw) else NEVER


def early_of(law: Law) -> int:
    """Return how many pieces of a law are of its first pulse, if it meets its neighbours by pulses; else 0."""
    return law.early if end_mode(law) == PULSES and isinstance(law, PulseLaw) else 0


@dataclass(frozen=True)
class Handover:
    """A phase as it is carried out, and what its neighbours ask of it."""

    phase: Phase
    begin: EndCondition  # what is asked for there
    end: EndCondition  # and at its end
    kinds: tuple[str, str]
    fault: str  # why it cannot have that, if so
    entered: Rates | None = None  # for its begin
    contrary: bool = False  # whether a straight line or a dwell at its begin has other rates

    @property
    def end_mode(self) -> int:
        """How the law that is named meets its neighbours."""
        return end_mode(self.phase.named)

    @property
    def slope(self) -> float:
        """Slope y' of a straight line; 0 of all else."""
        return slope(self.phase) or 0.0

    @property
    def ended(self) -> bool:
        """Whether its ends are prescribed."""
        return isinstance(self.phase, BoundaryPhase)

    @property
    def mode(self) -> int:
        """How it is carried out: 0 as the law between rests, :data:`LINE`, else its :attr:`way`."""
        if not self.ended:
            return 0
        return LINE if isinstance(self.phase.law, BoundaryLine) else self.end_mode

    @cached_property
    def halves(self) -> tuple[float, float]:
        """What the law that is named is multiplied by in either half, beside v0 and v1; 0 of a polynomial."""
        made, law = self.phase.law, self.phase.named
        if not self.ended:
            return self.phase.lift, self.phase.lift
        if self.mode == PULSES and isinstance(made, PulseLaw) and isinstance(law, PulseLaw):
            return made.acceleration / law.acceleration, made.deceleration / law.deceleration
        return 0.0, 0.0

    @property
    def drifts(self) -> tuple[float, float]:
        """The velocities that are added in either half; 0 of a law between rests."""
        return (self.begin.required.v, self.end.required.v) if self.ended else (0.0, 0.0)

    @property
    def early(self) -> int:
        """Pieces before its second pulse, of a law of two pulses; 0 of all else."""
        return early_of(self.phase.named) if self.mode == PULSES else 0

    def base(self, late: bool, y: float) -> float:
        """Return the position from which its law is counted in a half, ``y`` being the one that it begins at."""
        lift, drift = self.halves[1], self.drifts[1]
        return y + self.phase.lift - lift - drift * self.phase.duration if late else y

    @cached_property
    def powers(self) -> tuple[float, ...]:
        """e0, e1, e2 … of y = Σ e_n ξⁿ from the begin of a polynomial with prescribed ends; 0 of all else."""
        law = self.phase.law
        if not isinstance(law, BoundaryPolynomial):
            return (0.0,) * (POWERS + 2)
        c = (*law.polynomial, *(0.0,) * POWERS)[:POWERS]
        higher = [value / perm(n, 2) for n, value in enumerate(c, 2)]
        return (0.0, law.ends.v0, *higher)

    @property
    def hermite(self) -> BoundaryValues:
        """The ends of a polynomial, per unit of ξ; at rest and without a stroke of all else."""
        law = self.phase.law
        return law.ends if isinstance(law, BoundaryPolynomial) else BoundaryValues(stroke=0.0)

    @property
    def reversing(self) -> float:
        """Velocity y' between the two pulses; 0 of all else."""
        law = self.phase.law
        return law.top / self.phase.duration if self.mode == PULSES and isinstance(law, PulseLaw) else 0.0


def handovers(found: JoinedMotion, through: Mapping[int, Rates], periodic: bool) -> tuple[Handover, ...]:
    """Return what each phase of a motion becomes of its law; ``through`` and ``periodic`` as it was joined."""
    slopes = [slope(phase) for phase in found.motion.phases]
    reasons = {fault.phase: fault.reason for fault in found.faults if slopes[fault.phase] is None}

    def contrary(k: int) -> bool:
        beside = slopes[k], slopes[k - 1] if k or periodic else None
        return k in through and any(one is not None and not agrees(through[k], one) for one in beside)

    both = zip(found.motion.phases, found.required, found.kinds, strict=True)
    return tuple(
        Handover(phase, *asked, kinds, reasons.get(k, ""), through.get(k), contrary(k))
        for k, (phase, asked, kinds) in enumerate(both)
    )
