"""What a load asks for at its own shaft: its accelerations and torques over a cycle, and β. SI units.

Misprint of S5 mended here: T*²_L,rms is printed without the square.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from engine.drive import Load
from engine.motion import Motion, Phase

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
    def of_load(cls, load: Load, phases: Sequence[Phase], radius: float = 1.0) -> "Task":
        """Return the task of a load over phases (m and s on a wheel of ``radius`` (m), or rad), exact by the laws.

        Its friction resists in a movement, its torque always. What resists and what accelerates do not correlate:
        ∫ sign(ω) ω̇ dt is what |ω| gains, and ω̇ gains nothing over a cycle either.
        Raises ValueError where a phase does not begin and end at rest, or no phases are given.
        """
        if not phases or not (math.isfinite(radius) and radius > 0.0):
            raise ValueError(f"{len(phases)} phases and radius {radius:g}; expected a phase and a radius above 0")
        for k, phase in enumerate(phases, 1):
            if phase.lift != 0.0 and max(abs(phase.law.start.v), abs(phase.law.end.v)) > AT_REST:
                raise ValueError(f"phase {k}: {phase.law.name} does not begin and end at rest")
        per = 1.0 / radius
        motion = Motion([replace(p, lift=p.lift * per) for p in phases])
        time, acceleration = math.fsum(p.duration for p in phases), motion.y2_rms
        held = [load.torque + load.friction * np.sign(p.lift) for p in phases]
        square = math.fsum(p.duration / time * float(one) ** 2 for p, one in zip(phases, held, strict=True))
        fastest = max(p.law.coefficients.cv * abs(p.lift) / p.duration for p in phases) / radius
        torque = math.sqrt((load.inertia * acceleration) ** 2 + square)
        return cls(acceleration, torque, load.inertia * acceleration**2, fastest)

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
