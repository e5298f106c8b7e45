"""The tool's motion over a cycle as a table of pieces, and the drive of its shaft at points of them. SI units.

Source: S5, 'Model of dynamic system', T_M = (J_M/τ) ω̇_L + τ (T_L + J_L ω̇_L), and its step 7 for η and J_T.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drive import KINDS, Drivetrain, Load, Part, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.quadrature import STANDSTILL, Interval, QuadratureCycle
from engine.flying.cut import Cut
from engine.laws import Dwell
from engine.laws.base import BREAK_TOLERANCE
from engine.motion.joining import Joint, Rates, Smoothness, joints
from engine.motion.pieces import MotionPiece, MotionPieces, ScaledLaw


class CutPart(NamedTuple):
    """A part of the cycle: some consecutive pieces of a law with a constant velocity superimposed."""

    scaled: ScaledLaw
    begin: float  # time at which the part begins (s)
    first: int  # number of its first piece of the law, from 0
    used: int  # number of pieces

    def pieces(self, number: int, whole: bool = False) -> list[MotionPiece]:
        """Return its pieces, with ``number`` as that of their phase."""
        pieces = self.scaled.pieces(number, whole)[self.first : self.first + self.used] if self.used else []
        return [replace(piece, begin=max(piece.begin, self.begin)) for piece in pieces]


def cut_parts(cut: Cut, whole: bool = False) -> tuple[CutPart, CutPart, CutPart, CutPart]:
    """Return the parts of a cycle: the law up to the wait, the wait, the rest of the law, and the work at line speed.

    A law interrupted by a wait resumes in the middle of a piece, later by the wait. Without a wait the first part has
    all pieces of the law, the second and the third none; without working time the fourth has none.
    ``whole`` pieces are not cut where the acceleration is largest.
    """
    v, t, h, wait = cut.line_speed, cut.moving_time, cut.superimposed, cut.waiting_time
    begin, end = cut.wait
    begins = [piece.begin / t for piece in ScaledLaw(cut.law, 1.0, t).pieces(whole=whole)]
    peak = cut.fastest if cut.waits else 1.0
    before = sum(xi < peak - BREAK_TOLERANCE for xi in begins)
    again = sum(xi <= min(peak + BREAK_TOLERANCE, 1.0 - BREAK_TOLERANCE) for xi in begins) - 1
    stands = v * cut.fastest * t + h * cut.law.s(cut.fastest) if cut.waits else 0.0
    moved = v * t + h * cut.law.end.s
    return (
        CutPart(ScaledLaw(cut.law, h, t, drift=v), 0.0, 0, before),
        CutPart(ScaledLaw(Dwell(), 0.0, wait, begin, stands), begin, 0, int(cut.waits)),
        CutPart(ScaledLaw(cut.law, h, t, wait, drift=v), end, again, len(begins) - again if cut.waits else 0),
        CutPart(
            ScaledLaw(Dwell(), 0.0, cut.tool_time, cut.repositioning_time, moved, v),
            cut.repositioning_time,
            0,
            int(cut.tool_time > 0.0),
        ),
    )


def cut_joints(cut: Cut, smooth: Smoothness) -> tuple[Joint, ...]:
    """Return the joints of the tool's pieces, with jumps beyond 1e-9 of :func:`rates_of`."""
    pieces = cut_pieces(cut)
    ends = [*(piece.begin for piece in pieces[1:]), cut.cycle_time]
    spans = [(piece.begin - piece.origin, end - piece.origin) for piece, end in zip(pieces, ends, strict=True)]
    return joints(pieces, rates_of(cut), smooth, spans=spans)


def rates_of(cut: Cut) -> Rates:
    """Return the scales of velocity, acceleration and jerk by which jumps are measured: m/s, m/s², m/s³."""
    hardest = cut.max_acceleration
    return Rates(max(abs(v) for v in cut.speed_range), hardest, hardest / cut.moving_time)


def cut_pieces(cut: Cut, whole: bool = False) -> list[MotionPiece]:
    """Return the pieces of the tool's motion over the cycle, in m and s; ``whole`` as in :func:`cut_parts`."""
    parts = enumerate(cut_parts(cut, whole))
    return [piece for number, part in parts for piece in part.pieces(number, whole)]


class Stretch(NamedTuple):
    """A part of a piece, before or behind the slowest instant, in which the tool turns round if it ever does."""

    after: float  # direction behind the turn: −1 where the tool turns back, 1 where it moves forward again
    piece: int  # number of the piece, from 0
    begin: float  # s
    end: float  # s


@dataclass(frozen=True)
class CutCycle(QuadratureCycle):
    """The cycle of a cut: each piece of the tool's motion is an interval, also without duration.

    Until ``slowest`` the tool's speed falls, then it rises: the tool turns round twice, or never.
    """

    still: float = 0.0  # speed up to which the tool counts as at rest (m/s)
    slowest: float = 0.0  # when the law is fastest (s)
    turns: int = 0  # 2 if the tool moves backward then, else 0

    @cached_property
    def stretches(self) -> tuple[Stretch, Stretch]:
        """The part, on the turn's side of the slowest instant, of the last piece that begins before each turn."""
        v = np.array([piece.curves[1](piece.begin - piece.origin) for piece in self.pieces])
        begin, duration = np.array([(piece.begin, piece.duration) for piece in self.pieces]).T
        before, end = begin < self.slowest, begin + duration
        back = int(((v > self.still) & before).sum()) - 1
        forward = int(((v < -self.still) | before).sum()) - 1
        return (
            Stretch(-1.0, back, float(begin[back]), min(float(end[back]), self.slowest)),
            Stretch(1.0, forward, max(float(begin[forward]), self.slowest), float(end[forward])),
        )

    @cached_property
    def intervals(self) -> list[Interval]:
        """The pieces, in order, cut exactly where the tool turns round."""
        cuts = [(k, piece.begin) for k, piece in enumerate(self.pieces)]
        for _, k, begin, end in self.stretches[: self.turns]:
            origin, velocity = self.pieces[k].origin, self.pieces[k].curves[1]
            cuts.append((k, origin + velocity.root(begin - origin, end - origin)))
        numbers, places = zip(*sorted(cuts), strict=True)
        begins = np.maximum.accumulate(places).tolist()
        ends = [*begins[1:], self.drive_cycle.unshifted.total]
        return [Interval(*bounds) for bounds in zip(begins, ends, numbers, strict=True)]


def train_of(cut: Cut, load: Load, pair: tuple[float, float, float, float] = (0.0, 1.0, 1.0, 0.0)) -> Drivetrain:
    """Return the tool's shaft with its load, motor and reducer.

    Parameters
    ----------
    cut : Cut
    load : Load
        Inertia J_L (kg m²) and torque T_L (Nm) at the shaft.
    pair : (float, float, float, float)
        Motor and reducer: J_M + J_T (kg m²), i, η and no-load torque (Nm); by default the bare shaft.
    """
    inertia, ratio, efficiency, no_load = pair
    radius, stage = cut.tool.radius, Stage("reducer", ratio, efficiency)
    shaft = Part("shaft", load.inertia, 1)
    rollers = KINDS["feed rollers"].of(Load(0.0, load.torque / radius), radius, 1.0, [stage], [shaft])
    return Drivetrain(rollers, inertia, no_load=no_load)


def cycle_of(cut: Cut, train: Drivetrain) -> CutCycle:
    """Return the drive cycle of a cut's shaft, at nine points of each piece of the tool's motion."""
    pieces, still = cut_pieces(cut), STANDSTILL * max(map(abs, cut.speed_range))
    drive_cycle = DriveCycle(train, MotionPieces(tuple(pieces), cut.cycle_time))
    turns = 2 if cut.slowest_speed < -still else 0
    return CutCycle(drive_cycle, pieces, cut.time_tolerance, (), still, cut.slowest, turns)
