"""A load over the phases of a cycle, without losses: mean squares in closed form, from C_a,rms."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from engine.drive.chain import Load
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

    @property
    def moving_shares(self) -> list[float]:
        """Share of the cycle that each phase moves in: none for a dwell."""
        return [share if p.moves else 0.0 for share, p in zip(self.shares, self.phases, strict=True)]

    @property
    def moving(self) -> float:
        """Share of the cycle in motion."""
        return math.fsum(self.moving_shares)

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
