"""The tool's shaft, and a motor behind a reducer on it, at points of each piece of the cycle. SI units.

Source: S5, 'Model of dynamic system', T_M = (J_M/τ) ω̇_L + τ (T_L + J_L ω̇_L), and its step 7 for η and J_T.
"""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drive import KINDS, Drive, Load, Part, Stage
from engine.drive.cycle import DriveCycle, MotionPieces
from engine.drive.quadrature import STANDSTILL, Cycle, Interval, LoadPoints
from engine.drive.train import Train
from engine.flying.cut import Cut
from engine.flying.pieces import cut_pieces
from engine.laws.base import Array


@dataclass(frozen=True)
class CutCycle(Cycle):
    """The cycle of a cut: each piece of the tool's motion is an interval, those of no length too."""

    standing: float = 0.0
    """speed up to which the tool counts as at rest (m/s)"""

    @cached_property
    def intervals(self) -> list[Interval]:
        """The pieces, in order."""
        begins = [piece.begin for piece in self.pieces]
        ends = [*begins[1:], self.drive_cycle.unshifted.total]
        return [Interval(*one) for one in zip(begins, ends, range(len(begins)), strict=True)]

    @property
    def still(self) -> float:
        """The speed up to which the tool counts as at rest (m/s)."""
        return self.standing


def train_of(cut: Cut, load: Load, pair: tuple[float, float, float, float] = (0.0, 1.0, 1.0, 0.0)) -> Train:
    """Return the tool's shaft with a load J_L (kg m²), T_L (Nm) behind a motor and its reducer.

    ``pair`` is J_M + J_T (kg m²), i, η and the no-load torque of the reducer (Nm).
    """
    inertia, ratio, efficiency, no_load = pair
    radius, stage = cut.tool.radius, Stage("reducer", ratio, efficiency)
    shaft = Part("shaft", load.inertia, 1)
    rollers = KINDS["feed rollers"].of(Load(0.0, load.torque / radius), radius, 1.0, [stage], [shaft])
    return Train(Drive(rollers, inertia, no_load=no_load))


def cycle_of(cut: Cut, train: Train) -> CutCycle:
    """Return the cycle of a cut's shaft: nine points of each piece of the tool's motion."""
    pieces = cut_pieces(cut)
    drive_cycle = DriveCycle(train, MotionPieces(tuple(pieces), 0.0, cut.cycle_time))
    return CutCycle(drive_cycle, pieces, cut.time_tolerance, STANDSTILL * max(map(abs, cut.speed_range)))


def furthest(load: LoadPoints, still: float) -> tuple[Array, Array]:
    """Return the share of the step to each point at which the tool stands, and its position (m) there.

    Between two points of opposite speeds v_0, v_1 it stands at about x = v_0/(v_0 − v_1) of the step, at the position
    of the cubic through both; else 0 and the position of the point itself. To 0.1 % of the stroke.
    """
    s, v, t = (one.ravel() for one in (load.position, load.velocity, load.x))
    s0, v0, step = (np.concatenate([one[:1], one[:-1]]) for one in (s, v, t))
    step = t - step
    turns = (v0 * v < 0.0) & (np.minimum(np.abs(v0), np.abs(v)) > still) & (step > 0.0)
    x = np.divide(v0, v0 - v, out=np.zeros(v.shape), where=turns)
    chord = s0 + v0 * x * step / 2.0
    return x, np.where(turns, chord + x**2 * (3.0 - 2.0 * x) * (s - s0 - (v0 + v) * step / 2.0), s)


class Sizes(NamedTuple):
    """Sizes in SI: of lengths, and of what the line speed over such a length makes of speeds, accelerations, β."""

    length: float
    speed: float
    acceleration: float
    angle: float
    angular_speed: float
    angular_acceleration: float
    torque: float
    power_rate: float


def sizes(cut: Cut, inertia: float, torque: float) -> Sizes:
    """Return the sizes for a load of J_L (kg m²) and T_L (Nm): a = v_L²/L, β = J_L (a/R_t)²."""
    length, radius = max(cut.tool.design_length, cut.product_length), cut.tool.radius
    acceleration = cut.line_speed**2 / length
    turning = acceleration / radius
    return Sizes(
        length, cut.line_speed, acceleration, length / radius, cut.line_speed / radius, turning,
        math.hypot(inertia * turning, torque), inertia * turning**2,
    )  # fmt: skip
