"""How large things grow in a cycle at most, losses left out: what rounding errors are measured by. SI units."""

from __future__ import annotations

import math
from dataclasses import dataclass

from engine.drivetrain.cycle import Sizing

LEAST = 1e-6
NOTHING = 1e-3
"""N or Nm, where a load asks for nothing"""


@dataclass(frozen=True)
class Magnitudes:
    """Sizes of a cycle's figures; of a unit lift where nothing moves, and never 0."""

    sizing: Sizing

    @property
    def time(self) -> float:
        """Time of the cycle (s)."""
        return self.sizing.motion.total

    @property
    def lift(self) -> float:
        """Largest lift (m or rad)."""
        return max(abs(phase.lift) for phase in self.sizing.phases) or 1.0

    @property
    def speed(self) -> float:
        """Speed of the load (m/s or rad/s)."""
        return self.lift / self._shortest

    @property
    def acceleration(self) -> float:
        """Acceleration of the load (m/s² or rad/s²)."""
        return self.speed / self._shortest

    @property
    def motor_speed(self) -> float:
        """Speed of the motor (rad/s)."""
        return self.sizing.mechanism.ratio * self.speed

    @property
    def motor_acceleration(self) -> float:
        """Acceleration of the motor (rad/s²)."""
        return self.sizing.mechanism.ratio * self.acceleration

    @property
    def force(self) -> float:
        """What drives the load (N or Nm)."""
        m = self.sizing.mechanism
        return self._resisting + m.on_shaft(m.last) * self.acceleration or NOTHING

    @property
    def torque(self) -> float:
        """Torque of the motor (Nm)."""
        inertial = self.sizing.drive.effective_inertia() * self.motor_acceleration
        found = self._resisting / self.sizing.mechanism.ratio + inertial
        return found if math.isfinite(found) and found > 0.0 else NOTHING

    @property
    def least_torque(self) -> float:
        """What a figure of any kind beside the torque is at least measured by: a millionth of it."""
        return self.torque * LEAST

    def shaft_torque(self, shaft: int) -> float:
        """Return the torque that drives the load at a shaft (Nm, N at a load that travels)."""
        return self.force / self.sizing.mechanism.ratio_from(shaft)

    @property
    def power(self) -> float:
        """Power of the motor (W)."""
        return self.torque * self.motor_speed

    @property
    def slope(self) -> float:
        """Torque of the motor per acceleration of the load."""
        return self.torque / self.acceleration

    @property
    def product(self) -> float:
        """Torque times acceleration of the motor (Nm rad/s²)."""
        return self.torque * self.motor_acceleration

    @property
    def torque_square(self) -> float:
        """∫T² dt (N² m² s)."""
        return self.torque**2 * self.time

    @property
    def load_product(self) -> float:
        """∫b T dt, b the acceleration of the load."""
        return self.torque * self.acceleration * self.time

    @property
    def mean_square(self) -> float:
        """⟨b²⟩, b the acceleration of the load."""
        return self.acceleration**2

    @property
    def acceleration_square(self) -> float:
        """∫b² dt."""
        return self.mean_square * self.time

    @property
    def _shortest(self) -> float:
        return min(phase.duration for phase in self.sizing.phases)

    @property
    def _resisting(self) -> float:
        load = self.sizing.mechanism.load
        return abs(load.torque) + load.friction
