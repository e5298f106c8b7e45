"""Trapezoidal velocity (TVP), symmetric or not."""

from dataclasses import dataclass

from engine.laws.base import require_finite
from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, formulas
from engine.laws.pulse import CONSTANT
from engine.laws.pulse_law import PulseLaw, TwoPulses


@dataclass(frozen=True)
class TrapezoidalVelocity(PulseLaw):
    """Constant acceleration A up to ξ = α_v, uniform velocity A α_v, constant deceleration B from ξ = α_w on.

    A = 2/(α_v (1 − α_v + α_w)), B = 2/((1 − α_w)(1 − α_v + α_w)).
    ``rise_end`` is α_v and ``fall_start`` α_w, both as shares of the rise (α_s = 1):
    0 < α_v ≤ α_w < 1, else ValueError.
    Source: S1, 'Asymmetric trapezoidal speed profile', equations of A and B; S3, function TVP (e_v = 1/3).
    """

    code = "TVP"
    name = "Trapezoidal velocity"

    rise_end: float = 1 / 3
    fall_start: float = 2 / 3
    ends: Ends = REST

    def __post_init__(self) -> None:
        require_breaks(self.rise_end, self.fall_start)

    def _pulses(self) -> TwoPulses:
        return TwoPulses(CONSTANT, self.rise_end, self.fall_start - self.rise_end, CONSTANT, 1.0 - self.fall_start)


def require_breaks(rise_end: float, fall_start: float) -> None:
    """Raise ValueError unless 0 < rise_end ≤ fall_start < 1."""
    require_finite(rise_end=rise_end, fall_start=fall_start)
    if not 0.0 < rise_end <= fall_start < 1.0:
        raise ValueError(
            f"rise_end is {rise_end:g} and fall_start {fall_start:g}; expected 0 < rise_end <= fall_start < 1"
        )


ENTRY = Entry(
    law=TrapezoidalVelocity,
    aliases=("trapezoidal speed", "asymmetric trapezoidal", "asymmetric trapezoidal speed profile", "s-shape"),
    source="S1, 'Asymmetric trapezoidal speed profile'; S3, function TVP",
    claims=Claims(
        order_ends=1,
        order_inside=1,
        coefficients=formulas(
            "cv = 3/2; ca_max = 9/2; ca_min = -9/2; ca_rms = 9/2*sqrt(2/3); cj = inf; va_max = 27/4; va_min = -27/4"
        ),
    ),
    example=TrapezoidalVelocity,
    others=(TrapezoidalVelocity(0.1, 0.7), TrapezoidalVelocity(0.45, 0.45), TrapezoidalVelocity(0.02, 0.98)),
    beyond=(TrapezoidalVelocity(0.2, 0.7, Ends(0.5, 1.0, 0.3)),),
)
