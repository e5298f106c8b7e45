"""Phases that hand over at speed: what each end has to meet, which laws can, and every jump that is left."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from engine.laws import Dwell, Law
from engine.laws.ends import STILL, BoundaryLaw, BoundaryValues, EndError, kind, law_with_ends, require_ends
from engine.laws.polynomials import BoundaryLine
from engine.laws.simple import StraightLine
from engine.motion.motion import Motion
from engine.motion.phase import Phase
from engine.motion.pieces import MotionPiece, motion_pieces


class Rates(NamedTuple):
    """y', y'' and y''' at one place of a motion."""

    v: float = 0.0
    a: float = 0.0
    j: float = 0.0


@dataclass(frozen=True)
class BoundaryPhase(Phase):
    """A phase whose law has prescribed ends, and the lift in it; ``origin`` is the law named, ``scale`` times s."""

    origin: Law
    scale: float = 1.0

    @property
    def named(self) -> Law:
        """The law as it is named: between two rests."""
        return self.origin

    @property
    def moves(self) -> bool:
        """Whether it moves: also where it comes back to where it began."""
        return True


class Fault(NamedTuple):
    """A phase, counted from 0, whose law cannot have the ends that are asked for, or that an entry contradicts."""

    phase: int
    reason: str


class EndCondition(NamedTuple):
    """One end of a phase."""

    required: Rates  # what it has to meet
    settled: bool  # whether that is settled
    open: bool  # whether nothing lies beyond


@dataclass(frozen=True)
class JoinedMotion:
    """A motion of phases with the ends that their neighbours and the entries ask for."""

    motion: Motion
    faults: tuple[Fault, ...]  # their laws are carried out between rests
    kinds: tuple[tuple[str, str], ...]  # of begin and end, by VDI 2143: R rest, G constant velocity, U reversal, B any
    required: tuple[tuple[EndCondition, EndCondition], ...]  # what each is asked for


def slope(phase: Phase) -> float | None:
    """Return y' of a phase that is a straight line, 0 of a dwell; None of a curved one."""
    if isinstance(phase.law, Dwell):
        return 0.0
    return phase.lift / phase.duration if isinstance(phase.law, StraightLine) else None


def join_phases(
    phases: Sequence[Phase], through: Mapping[int, Rates] | None = None, periodic: bool = True, start: float = 0.0,
    position: float = 0.0,
) -> JoinedMotion:  # fmt: skip
    """Return the motion of phases, each of which meets its neighbours, across the end of the cycle too.

    Beside a straight line or a dwell a curved phase takes its velocity, and no acceleration. Between two curved
    phases ``through`` says what y', y'' and y''' are, by the number of the phase that begins there (of the last
    end of a motion that is not periodic, the number of phases); else they are 0, or what the laws have of
    themselves. Two straight lines keep their slopes: where these differ, the motion jumps.
    """
    entered = dict(through or {})
    made, faults, kinds, asked = [], [], [], []
    for k, phase in enumerate(phases):
        following = (k + 1) % len(phases) if periodic else k + 1
        before = phases[k - 1] if k or periodic else None
        after = phases[following] if following < len(phases) else None
        here, there = entered.get(k), entered.get(following)
        constant = slope(phase)
        if constant is not None:
            made.append(phase)
            faults += [Fault(k, reason) for reason in _contradictions(constant, (here, there))]
            kinds.append((kind(abs(constant) and 1.0, 0.0),) * 2)
            asked.append((EndCondition(Rates(constant), True, False),) * 2)
            continue
        sides = _side(before, here), _side(after, there)
        try:
            made.append(_between(phase, *sides))
        except EndError as error:
            made.append(phase)
            faults.append(Fault(k, str(error)))
        kinds.append(_kinds(made[-1], sides))
        asked.append(sides)
    return JoinedMotion(Motion(made, start, position), tuple(faults), tuple(kinds), tuple(asked))


def _side(neighbour: Phase | None, entered: Rates | None) -> EndCondition:
    if neighbour is None:
        return EndCondition(entered or Rates(), True, entered is None)
    constant = slope(neighbour)
    if constant is not None:
        return EndCondition(Rates(constant), True, False)
    return EndCondition(entered or Rates(), entered is not None, False)


def _between(phase: Phase, begin: EndCondition, end: EndCondition) -> Phase:
    """Return a curved phase between its ends; raise EndError if its law cannot have them."""
    d, law = phase.duration, phase.law
    one, other = begin.required, end.required
    if isinstance(law, BoundaryLaw) and law.fixes_ends:
        require_ends(law, BoundaryValues(a0=one.a, a1=other.a, j0=one.j, j1=other.j), "")  # it keeps its velocities
        return Phase(law, phase.lift, d)
    if isinstance(law, BoundaryLaw):
        law = law.with_open_ends(begin.open, end.open)
    v, a, j = ((first * d**n, last * d**n) for n, (first, last) in enumerate(zip(one, other, strict=True), 1))
    ends = BoundaryValues(phase.lift, *v, *a, *j)
    made, _ = law_with_ends(law, ends)
    if ends.at_rest:
        return Phase(made, phase.lift, d)
    return BoundaryPhase(BoundaryLine(ends) if ends.straight else made, phase.lift, d, phase.law)


def _contradictions(constant: float, entered: Sequence[Rates | None]) -> list[str]:
    return [
        f"a straight line has y' = {constant:g} and no acceleration; {rates.v:g}, {rates.a:g}, {rates.j:g} are entered"
        for rates in entered
        if rates is not None and not agrees(rates, constant)
    ]


def agrees(rates: Rates, constant: float) -> bool:
    """Whether rates are those of a straight line of a slope, but for rounding."""
    near = abs(rates.v - constant) <= STILL * (abs(rates.v) + abs(constant))
    return near and not rates.a and not rates.j


def _kinds(phase: Phase, sides: tuple[EndCondition, EndCondition]) -> tuple[str, str]:
    """Return the kinds of what is asked for at both ends; where nothing settles it, of what the law has there."""
    v, a, d = phase.y1_max or 1.0, phase.y2_max or 1.0, phase.duration
    begin, end = (
        kind(side.required.v / v, side.required.a / a)
        if side.settled
        else kind(phase.scale * at.v / d / v, phase.scale * at.a / d**2 / a)
        for side, at in zip(sides, (phase.law.start, phase.law.end), strict=True)
    )
    return begin, end


Smoothness = Literal["velocity", "acceleration", "jerk"]
ORDERS: tuple[Smoothness, ...] = ("velocity", "acceleration", "jerk")
JUMP = 1e-9  # of what a motion's jumps are measured by: a smaller one is rounding


class Joint(NamedTuple):
    """Where a piece of a motion begins. What does not last takes over what is before it."""

    x: float
    piece_count: int  # pieces that last, up to here
    phase: int  # that of the last of these
    end: Rates  # its rates at its end
    before: int  # phase of the one before
    jump: Rates  # what jumps
    order: int  # the least derivative asked for that jumps; 0 where none does

    @property
    def size(self) -> float:
        """The jump of that derivative."""
        return self.jump[self.order - 1] if self.order else 0.0


def joints(
    pieces: Sequence[MotionPiece], scales: Rates, smooth: Smoothness, periodic: bool = True,
    spans: Sequence[tuple[float, float]] = (),
) -> tuple[Joint, ...]:  # fmt: skip
    """Return where pieces begin, cyclic if ``periodic``; ``spans`` are their begins and ends, where not whole."""
    found: list[Joint] = []
    asked = ORDERS.index(smooth) + 1
    whole = spans or [(0.0, piece.duration) for piece in pieces]
    lasting = [(piece, span) for piece, span in zip(pieces, whole, strict=True) if piece.duration > 0.0]
    last = Joint(0.0, 0, lasting[-1][0].phase, _ends(*lasting[-1])[1], -1, Rates(), 0)
    before = last._replace(phase=-1, end=Rates())
    for piece, span in zip(pieces, whole, strict=True):
        if piece.duration > 0.0:
            one = last if before.piece_count == 0 else before
            begin, end = _ends(piece, span)
            joined = periodic or before.piece_count > 0
            jump = Rates(*(y - x for x, y in zip(one.end, begin, strict=True))) if joined else Rates()
            jumps = (n for n in range(asked) if abs(jump[n]) > JUMP * scales[n])
            order = next(jumps, -1) + 1
            before = Joint(piece.begin, before.piece_count + 1, piece.phase, end, one.phase, jump, order)
        else:
            before = before._replace(x=piece.begin, before=-1, jump=Rates(), order=0)
        found.append(before)
    return tuple(found)


def _ends(piece: MotionPiece, span: tuple[float, float]) -> tuple[Rates, Rates]:
    _, v, a, j = piece.at(np.array(span))
    begin, end = (Rates(*values) for values in zip(v.tolist(), a.tolist(), j.tolist(), strict=True))
    return begin, end


def scales_of(motion: Motion) -> Rates:
    """Return what jumps are measured by: the largest |y'| and |y''| of any phase, and the latter by its 1/δ."""
    peaks = motion.peaks
    return Rates(peaks.y1, peaks.y2, peaks.y2 * max(phase.rate for phase in motion.phases))


def shortfalls(motion: Motion, smooth: Smoothness, periodic: bool = True) -> tuple[Joint, ...]:
    """Return where a motion is less smooth than asked, within its laws too; periodic, from end to begin."""
    found = joints(motion_pieces(motion), scales_of(motion), smooth, periodic)
    return tuple(joint for joint in found if joint.order)
