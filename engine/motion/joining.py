"""Phases that hand over at speed: what each end has to meet, and which laws can."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from engine.laws import Dwell
from engine.laws.ends import EndedLaw, EndError, Ends, between, kind
from engine.laws.straight_line import StraightLine
from engine.motion.motion import Motion
from engine.motion.phase import Phase


class Rates(NamedTuple):
    """y', y'' and y''' at one place of a motion."""

    v: float = 0.0
    a: float = 0.0
    j: float = 0.0


@dataclass(frozen=True)
class EndedPhase(Phase):
    """A phase whose law has the lift in itself, as its ends are prescribed."""

    @property
    def scale(self) -> float:
        """What the law's s is multiplied by: 1."""
        return 1.0


class Fault(NamedTuple):
    """A phase, counted from 0, whose law cannot have the ends that are asked for, or that an entry contradicts."""

    phase: int
    reason: str


@dataclass(frozen=True)
class Joined:
    """A motion of phases with the ends that their neighbours and the entries ask for.

    The laws that ``faults`` names are carried out between rests. ``kinds`` are the begin and the end of each phase
    as VDI 2143 names them: R rest, G constant velocity, U reversal, B general motion.
    """

    motion: Motion
    faults: tuple[Fault, ...]
    kinds: tuple[tuple[str, str], ...]


class _Side(NamedTuple):
    """One end of a curved phase: what it has to meet, whether that is settled, and whether nothing lies beyond."""

    asked: Rates
    settled: bool
    open: bool


def slope(phase: Phase) -> float | None:
    """Return y' of a phase that is a straight line, 0 of a dwell; None of a curved one."""
    if isinstance(phase.law, Dwell):
        return 0.0
    return phase.lift / phase.duration if isinstance(phase.law, StraightLine) else None


def joined(
    phases: Sequence[Phase],
    through: Mapping[int, Rates] | None = None,
    periodic: bool = True,
    start: float = 0.0,
    position: float = 0.0,
) -> Joined:
    """Return the motion of phases, each of which meets its neighbours, across the end of the cycle too.

    Beside a straight line or a dwell a curved phase takes its velocity, and no acceleration. Between two curved
    phases ``through`` says what y', y'' and y''' are, by the number of the phase that begins there (of the last
    end of a motion that is not periodic, the number of phases); else they are 0, or what the laws have of
    themselves. Two straight lines keep their slopes: where these differ, the motion jumps.
    """
    entered = dict(through or {})
    made, faults, kinds = [], [], []
    for k, phase in enumerate(phases):
        following = (k + 1) % len(phases) if periodic else k + 1
        before = phases[k - 1] if k or periodic else None
        after = phases[following] if following < len(phases) else None
        here, there = entered.get(k), entered.get(following)
        constant = slope(phase)
        if constant is not None:
            made.append(phase)
            faults += [Fault(k, reason) for reason in _contradictions(constant, (here, there))]
            kinds.append(_straight_kinds(constant))
            continue
        sides = _side(before, here), _side(after, there)
        try:
            made.append(_between(phase, *sides))
        except EndError as error:
            made.append(phase)
            faults.append(Fault(k, str(error)))
        kinds.append(_kinds(made[-1], sides))
    return Joined(Motion(made, start, position), tuple(faults), tuple(kinds))


def _side(neighbour: Phase | None, entered: Rates | None) -> _Side:
    if neighbour is None:
        return _Side(entered or Rates(), True, entered is None)
    constant = slope(neighbour)
    if constant is not None:
        return _Side(Rates(constant), True, False)
    return _Side(entered or Rates(), entered is not None, False)


def _between(phase: Phase, begin: _Side, end: _Side) -> Phase:
    """Return a curved phase between its ends; raise EndError if its law cannot have them."""
    d, law = phase.duration, phase.law
    if isinstance(law, EndedLaw):
        law = law.opened(begin.open, end.open)
    one, other = begin.asked, end.asked
    ends = Ends(phase.lift, one.v * d, other.v * d, one.a * d**2, other.a * d**2, one.j * d**3, other.j * d**3)
    made, _ = between(law, ends)
    return Phase(made, phase.lift, d) if ends.at_rest else EndedPhase(made, phase.lift, d)


def _contradictions(constant: float, entered: Sequence[Rates | None]) -> list[str]:
    return [
        f"a straight line has y' = {constant:g} and no acceleration; {rates.v:g}, {rates.a:g}, {rates.j:g} are entered"
        for rates in entered
        if rates is not None and rates != Rates(constant)
    ]


def _straight_kinds(constant: float) -> tuple[str, str]:
    found = kind(constant, 0.0)
    return found, found


def _kinds(phase: Phase, sides: tuple[_Side, _Side]) -> tuple[str, str]:
    """Return the kinds of what is asked for at both ends; where nothing settles it, of what the law has there."""
    law, d = phase.law, phase.duration
    size = law.coefficients
    begin, end = (
        kind(v / (size.cv or 1.0), a / (size.ca or 1.0))
        for v, a in (
            (side.asked.v * d, side.asked.a * d**2) if side.settled else at[1:3]
            for side, at in zip(sides, (law.start, law.end), strict=True)
        )
    )
    return begin, end
