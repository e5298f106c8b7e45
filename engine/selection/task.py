"""What a load asks for at its own shaft: its accelerations and torques over a cycle, and β. SI units.

Misprint of S5 mended here: T*²_L,rms is printed without the square.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.drive import Load
from engine.motion import Motion, Phase


def at_shaft(phases: Sequence[Phase], ratio: float, speed: float = 1.0) -> list[Phase]:
    """Return the phases of a load as those of a shaft in time (rad, in s).

    ``ratio`` is the speed of the shaft over that of the load (rad/m or 1), ``speed`` that of the abscissa (1/s).
    """
    return [p.rescaled(ratio, speed) for p in phases]


def direction_of(phase: Phase) -> float:
    """Return 1 forward, −1 backward, 0 for a dwell; 1 of a phase that comes back to where it began."""
    return float(np.sign(phase.lift)) or float(phase.moves)


@dataclass(frozen=True)
class LosslessCycle:
    """A load on a shaft, and phases of the shaft's motion (rad, in s).

    What resists and what accelerates do not correlate: ∫ sign(ω) ω̇ dt is what |ω| gains, and ω̇ gains nothing over a
    cycle either, so long as no speed jumps, which no torque could follow. Raises ValueError for no phases.
    """

    load: Load
    phases: Sequence[Phase]

    def __post_init__(self) -> None:
        if not self.phases:
            raise ValueError("no phases are given; expected at least one")

    @cached_property
    def time(self) -> float:
        """Time of the cycle (s)."""
        return math.fsum(p.duration for p in self.phases)

    @property
    def shares(self) -> list[float]:
        """Share of the cycle that each phase takes."""
        return [p.duration / self.time for p in self.phases]

    @cached_property
    def acceleration(self) -> float:
        """ω̇_rms (rad/s²): sqrt(Σ C_a,rms² h²/t³ / t_c)."""
        return Motion(self.phases).y2_rms

    @property
    def resisting_square(self) -> float:
        """Mean square of what resists (N² m²): in a movement the torque and the friction, at rest the torque."""
        held = [float(self.load.resisting(direction_of(p))) ** 2 for p in self.phases]
        return math.fsum(share * square for share, square in zip(self.shares, held, strict=True))

    @property
    def torque(self) -> float:
        """T*_rms (Nm), T* = T + J ω̇: sqrt((J ω̇_rms)² + ⟨T²⟩)."""
        return self.rms_torque(self.load.inertia, 1.0)

    @property
    def product(self) -> float:
        """⟨ω̇ T*⟩ = J ω̇_rms² (Nm rad/s²)."""
        return self.load.inertia * self.acceleration**2

    def rms_torque(self, inertia: float, transmission: float) -> float:
        """Return the RMS torque (Nm) in front of a reducer of ratio τ: sqrt((J_m/τ + τ J)² ω̇_rms² + τ² ⟨T²⟩).

        ``inertia`` is the motor's torque per ω̇ of the shaft, J_m/τ + τ J (kg m²).
        Source: S1, 'Feeding group', last equation, squared.
        """
        return math.sqrt((inertia * self.acceleration) ** 2 + transmission**2 * self.resisting_square)


AT_REST = 1e-9
"""of the mean velocity of a phase"""
NOTHING = 1e-9
"""rad/s², Nm, rad/s: an acceleration, a torque, a speed no larger than this comes from rounding"""


@dataclass(frozen=True)
class Task:
    """What the load asks for, at its own shaft, over a cycle.

    ``acceleration_rms`` ω̇_L,rms (rad/s²), ``torque_rms`` T*_L,rms (Nm) of the generalized load torque
    T*_L = T_L + J_L ω̇_L, ``power_rate_mean`` (ω̇_L T*_L)_mean (Nm rad/s²), ``max_speed`` ω_L,max (rad/s).
    Raises ValueError unless the acceleration, the torque and the speed are 0 or more, and |mean| ≤ ω̇_rms T*_rms.
    Source: S5, eqs. (14), (15).
    """

    acceleration_rms: float
    torque_rms: float
    power_rate_mean: float
    max_speed: float

    def __post_init__(self) -> None:
        for name in ("acceleration_rms", "torque_rms", "max_speed"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) >= 0.0):
                raise ValueError(f"load: {name} is {getattr(self, name):g}; expected a finite number, 0 or more")
        bound = self.acceleration_rms * self.torque_rms
        if not abs(self.power_rate_mean) <= bound * (1.0 + 1e-9):
            raise ValueError(f"load: power_rate_mean is {self.power_rate_mean:g}; expected −{bound:g} to {bound:g}")

    @classmethod
    def of_figures(cls, acceleration_rms: float, torque_rms: float, power_rate_mean: float, max_speed: float) -> "Task":
        """Return the task of figures that were found apart: the mean at most ±ω̇_rms T*_rms.

        Past that rounding, and the samples of an own law, may put it.
        """
        bound = acceleration_rms * torque_rms
        return cls(acceleration_rms, torque_rms, max(-bound, min(bound, power_rate_mean)), max_speed)

    @classmethod
    def of_load(cls, load: Load, phases: Sequence[Phase], radius: float = 1.0) -> "Task":
        """Return the task of a load over phases (m and s on a wheel of ``radius`` (m), or rad), exact by the laws.

        As :class:`engine.selection.task.LosslessCycle` has them.
        For phases that begin and end at rest. Raises ValueError where one does not, or no phases are given.
        """
        if not phases or not (math.isfinite(radius) and radius > 0.0):
            raise ValueError(f"{len(phases)} phases and radius {radius:g}; expected a phase and a radius above 0")
        for k, phase in enumerate(phases, 1):
            if phase.lift != 0.0 and max(abs(phase.law.start.v), abs(phase.law.end.v)) > AT_REST:
                raise ValueError(f"phase {k}: {phase.law.name} does not begin and end at rest")
        asked = LosslessCycle(load, at_shaft(phases, 1.0 / radius))
        fastest = max(p.law.coefficients.cv * abs(p.lift) / p.duration for p in phases) / radius
        return cls(asked.acceleration, asked.torque, asked.product, fastest)

    @property
    def moves(self) -> bool:
        """Whether the load accelerates and has a torque: without, there is nothing to choose a motor for."""
        return min(self.acceleration_rms, self.torque_rms, self.max_speed) > NOTHING

    @property
    def load_factor(self) -> float:
        """β = 2 (ω̇_L,rms T*_L,rms + (ω̇_L T*_L)_mean), in Nm rad/s²; 0 of a load that does not move.

        Source: S5, eq. (15).
        """
        return 2.0 * (self.acceleration_rms * self.torque_rms + self.power_rate_mean) if self.moves else 0.0

    def required_accelerating_factor(self, efficiency: float = 1.0) -> float:
        """Return β/η: a motor with a smaller α cannot do the task with any ratio.

        Source: S5, step 3 (η = 1); Giberti, Cinquemani, Legnani, 'Effects of transmission mechanical
        characteristics on the choice of a motor-reducer', Mechatronics 20 (2010).
        """
        return self.load_factor / efficiency
