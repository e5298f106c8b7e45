"""Phases that meet at speed: the conditions at their ends, the laws that meet them, and every jump that is left."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from engine.laws import Dwell
from engine.laws.ends import STILL, BoundaryValues, EndError, kind, law_with_ends
from engine.laws.polynomials import BoundaryLine
from engine.laws.simple import StraightLine
from engine.motion.motion import Motion
from engine.motion.phase import Phase
from engine.motion.pieces import MotionPiece, motion_pieces


class Rates(NamedTuple):
    """Derivatives by the abscissa at a place of a motion, in its units."""

    v: float = 0.0  # y'
    a: float = 0.0  # y''
    j: float = 0.0  # y'''


class Fault(NamedTuple):
    """A phase whose law cannot meet its end conditions, or a straight line with other rates than those entered."""

    phase: int  # number, from 0
    reason: str


class EndCondition(NamedTuple):
    """The condition at an end of a phase."""

    required: Rates
    settled: bool  # whether a neighbour or an entry determines the rates


@dataclass(frozen=True)
class JoinedMotion:
    """A motion of phases that meet the conditions of their neighbours and of the entries."""

    motion: Motion
    faults: tuple[Fault, ...]  # curved phases among them keep their law between rests
    # of begin and end, by VDI 2143: R rest, G constant velocity, U reversal, B any
    kinds: tuple[tuple[str, str], ...]
    required: tuple[tuple[EndCondition, EndCondition], ...]  # at begin and end of each phase

    def ends_of(self, number: int) -> BoundaryValues:
        """Return the conditions at the ends of a phase, from 0, that lifts, for its law: of the rise 1, by ξ."""
        phase = self.motion.phases[number]
        return _ends_of(phase, *self.required[number], phase.lift)


def slope(phase: Phase) -> float | None:
    """Return y' of a phase that is a straight line or a dwell; None of a curved phase."""
    if isinstance(phase.law, Dwell):
        return 0.0
    return phase.lift / phase.duration if isinstance(phase.law, StraightLine) else None


def join_phases(
    phases: Sequence[Phase],
    through: Mapping[int, Rates] | None = None,
    periodic: bool = True,
    start: float = 0.0,
    position: float = 0.0,
) -> JoinedMotion:
    """Return the motion of phases, each of which meets its neighbours.

    Next to a straight line or a dwell a curved phase takes over the velocity, with no acceleration. Between two curved
    phases the rates are those of ``through``, else 0 or the laws' own. Two straight lines keep their slopes.

    Parameters
    ----------
    phases : sequence of Phase
        In their order; their laws are between rests.
    through : mapping of int to Rates, optional
        Rates by the number of the phase that begins there, from 0; the number of phases stands for the last end.
    periodic : bool
        Whether the last phase meets the first.
    start, position : float
        Where the abscissa begins, and y there, in their units.

    Returns
    -------
    JoinedMotion
        The motion with a fault for each phase that cannot meet its conditions; no error is raised for these.
    """
    entered = dict(through or {})
    joined, faults, kinds, asked = [], [], [], []
    for k, phase in enumerate(phases):
        following = (k + 1) % len(phases) if periodic else k + 1
        before = phases[k - 1] if k or periodic else None
        after = phases[following] if following < len(phases) else None
        here, there = entered.get(k), entered.get(following)
        constant = slope(phase)
        if constant is not None:
            joined.append(phase)
            faults += [Fault(k, reason) for reason in _contradictions(constant, (here, there))]
            kinds.append((kind(abs(constant) and 1.0, 0.0),) * 2)
            asked.append((EndCondition(Rates(constant), True),) * 2)
            continue
        sides = _side(before, here), _side(after, there)
        try:
            joined.append(_between(phase, *sides))
        except EndError as error:
            joined.append(phase)
            faults.append(Fault(k, str(error)))
        kinds.append(_kinds(joined[-1], sides))
        asked.append(sides)
    return JoinedMotion(Motion(joined, start, position), tuple(faults), tuple(kinds), tuple(asked))


def _side(neighbour: Phase | None, entered: Rates | None) -> EndCondition:
    if neighbour is None:
        return EndCondition(entered or Rates(), True)
    constant = slope(neighbour)
    if constant is not None:
        return EndCondition(Rates(constant), True)
    return EndCondition(entered or Rates(), entered is not None)


def _between(phase: Phase, begin: EndCondition, end: EndCondition) -> Phase:
    """Return a curved phase that meets its end conditions; raise EndError if its law cannot."""
    ends = _ends_of(phase, begin, end)
    if phase.law.fixes_ends or ends.at_rest:  # it keeps its rates: joints tell where they jump
        return Phase(phase.law, phase.lift, phase.duration)
    law = law_with_ends(phase.law, ends)
    return Phase(BoundaryLine(ends=ends) if ends.straight else law, phase.lift, phase.duration, phase.law)


def _ends_of(phase: Phase, begin: EndCondition, end: EndCondition, unit: float = 1.0) -> BoundaryValues:
    """Return the conditions at the ends of a phase by its ξ, in a unit of y."""
    both = enumerate(zip(begin.required, end.required, strict=True), 1)
    rates = [rate * phase.duration**n / unit for n, ends in both for rate in ends]
    return BoundaryValues(phase.lift / unit, *rates)


def _contradictions(constant: float, entered: Sequence[Rates | None]) -> list[str]:
    return [
        f"a straight line has y' = {constant:g} and no acceleration; {rates.v:g}, {rates.a:g}, {rates.j:g} are entered"
        for rates in entered
        if rates is not None and not agrees(rates, constant)
    ]


def agrees(rates: Rates, constant: float) -> bool:
    """Return whether rates are those of a straight line of the slope ``constant``, but for rounding."""
    near = abs(rates.v - constant) <= STILL * (abs(rates.v) + abs(constant))
    return near and not rates.a and not rates.j


def _kinds(phase: Phase, sides: tuple[EndCondition, EndCondition]) -> tuple[str, str]:
    """Return the kinds of the conditions at both ends; of the law itself at an end that is not settled."""
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
JUMP = 1e-9  # share of a motion's scale of a derivative: a smaller jump is rounding


class Joint(NamedTuple):
    """The joint at which a piece of a motion begins. A piece without duration repeats the figures before it."""

    x: float  # abscissa
    piece_count: int  # number of pieces of any duration up to here, this included
    phase: int  # number of the phase of the last of these, from 0
    end: Rates  # at the end of the last of these
    before: int  # number of the phase of the piece before it; −1 for a piece without duration
    jump: Rates  # of y', y'' and y'''
    order: int  # of the least derivative that jumps though it should not: 1 to 3; 0 if none does

    @property
    def size(self) -> float:
        """The jump of that derivative."""
        return self.jump[self.order - 1] if self.order else 0.0


def joints(
    pieces: Sequence[MotionPiece],
    scales: Rates,
    smooth: Smoothness,
    periodic: bool = True,
    spans: Sequence[tuple[float, float]] = (),
) -> tuple[Joint, ...]:
    """Return the joints of pieces.

    Parameters
    ----------
    pieces : sequence of MotionPiece
    scales : Rates
        Largest rates of the motion: jumps over 1e-9 of them count.
    smooth : {"velocity", "acceleration", "jerk"}
        The highest derivative of which jumps count.
    periodic : bool
        Whether the last piece meets the first.
    spans : sequence of (float, float), optional
        From which u to which each piece is used, if not whole.
    """
    listed: list[Joint] = []
    asked = ORDERS.index(smooth) + 1
    whole = spans or [(0.0, piece.duration) for piece in pieces]
    lasting = [(piece, span) for piece, span in zip(pieces, whole, strict=True) if piece.duration > 0.0]
    last = Joint(0.0, 0, lasting[-1][0].phase, _ends(*lasting[-1])[1], -1, Rates(), 0)
    before = last._replace(phase=-1, end=Rates())
    for piece, span in zip(pieces, whole, strict=True):
        if piece.duration > 0.0:
            previous = last if before.piece_count == 0 else before
            begin, end = _ends(piece, span)
            joined = periodic or before.piece_count > 0
            jump = Rates(*(y - x for x, y in zip(previous.end, begin, strict=True))) if joined else Rates()
            jumps = (n for n in range(asked) if abs(jump[n]) > JUMP * scales[n])
            order = next(jumps, -1) + 1
            before = Joint(piece.begin, before.piece_count + 1, piece.phase, end, previous.phase, jump, order)
        else:
            before = before._replace(x=piece.begin, before=-1, jump=Rates(), order=0)
        listed.append(before)
    return tuple(listed)


def _ends(piece: MotionPiece, span: tuple[float, float]) -> tuple[Rates, Rates]:
    _, v, a, j = piece.at(np.array(span))
    begin, end = (Rates(*values) for values in zip(v.tolist(), a.tolist(), j.tolist(), strict=True))
    return begin, end


def scales_of(motion: Motion) -> Rates:
    """Return the scales of jumps: the largest |y'| and |y''| of any phase, and the latter by its 1/δ."""
    peaks = motion.peaks
    return Rates(peaks.y1, peaks.y2, peaks.y2 * max(phase.rate for phase in motion.phases))


def shortfalls(motion: Motion, smooth: Smoothness, periodic: bool = True) -> tuple[Joint, ...]:
    """Return where a motion is less smooth than asked, within its laws too.

    Parameters
    ----------
    motion : Motion
    smooth : {"velocity", "acceleration", "jerk"}
        The highest derivative that must not jump.
    periodic : bool
        Whether the end meets the begin.
    """
    every = joints(motion_pieces(motion), scales_of(motion), smooth, periodic)
    return tuple(joint for joint in every if joint.order)
