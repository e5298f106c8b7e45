"""A rise of a law in its own units: h in the time t_a."""

from dataclasses import dataclass

from engine.laws.base import Array, Law


@dataclass(frozen=True)
class Rise:
    """A law over a lift h (m; negative for a return) in a time t_a (s)."""

    law: Law
    lift: float
    time: float

    @property
    def velocity(self) -> float:
        """C_v |h|/t_a, the largest velocity (m/s)."""
        return self.law.coefficients.cv * abs(self.lift) / self.time

    @property
    def acceleration(self) -> float:
        """C_a |h|/t_a², the largest acceleration (m/s²)."""
        return self.law.coefficients.ca * abs(self.lift) / self.time**2

    @property
    def acceleration_rms(self) -> float:
        """C_a,rms |h|/t_a² (m/s²)."""
        return self.law.coefficients.ca_rms * abs(self.lift) / self.time**2

    def at(self, xi: Array) -> tuple[Array, Array, Array]:
        """Return y = h s (m), ẏ = h v/t_a (m/s), ÿ = h a/t_a² (m/s²) at ξ, in its shape."""
        s, v, a, _ = self.law.evaluate(xi)
        return self.lift * s, self.lift / self.time * v, self.lift / self.time**2 * a
