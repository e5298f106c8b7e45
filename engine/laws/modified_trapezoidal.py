"""Modified trapezoidal acceleration with seven durations (MTP)."""

from dataclasses import dataclass

from engine.laws.ends import REST, Ends
from engine.laws.entry import Claims, Entry, Vendors, formulas
from engine.laws.pulse import sine_edged
from engine.laws.pulse_law import PulseLaw, TwoPulses, pulses_of, seven_durations

CLASSIC = (1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8)


@dataclass(frozen=True)
class ModifiedTrapezoidal(PulseLaw):
    """Seven stages: a = A sin(πu/2d1), A, A cos(πu/2d3), 0, −B sin(πu/2d5), −B, −B cos(πu/2d7).

    ``durations`` are the seven shares of the rise: not negative, of sum 1 (within 1e-9), neither the first
    three nor the last three all zero; else ValueError. With k = 2/π, m = k d1 + d2 + k d3 and
    n = k d5 + d6 + k d7, A m = B n = C_v and A = 1/(S_a + m d4 + S_d m/n), where S_a and S_d are the travels
    of the two lobes for unit acceleration.
    Source: S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'; S3, figure 2, 'ModTVP'.
    """

    code = "MTP"
    name = "Modified trapezoidal"

    durations: tuple[float, ...] = CLASSIC
    ends: Ends = REST

    def __post_init__(self) -> None:
        object.__setattr__(self, "durations", seven_durations(self.durations))

    def _pulses(self) -> TwoPulses:
        return pulses_of(self.durations, sine_edged)


ENTRY = Entry(
    law=ModifiedTrapezoidal,
    aliases=("ModTVP", "modified trapezoidal acceleration", "modified trapezoid"),
    source="S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'; S3, figure 2, 'ModTVP'",
    vendors=Vendors(siemens="D_D_MOD_ACCEL_TRAPEZOID (11)", twincat="BESCHLTRAPEZ (13)"),
    claims=Claims(
        order_ends=2,
        order_inside=3,  # with equal sines at the middle; else 2
        where={"y": "2/(1 + pi + sqrt((1 + pi)**2 + 8))"},  # sin x where v·a is greatest
        coefficients=formulas(
            "cv = 2; ca_max = 8*pi/(2 + pi); ca_min = -ca_max; ca_rms = ca_max*sqrt(3)/2; cj = 4*pi*ca_max; "
            "va_max = ca_max**2/(4*pi)*(1 + pi + y)*sqrt(1 - y**2); va_min = -va_max"
        ),
    ),
    example=ModifiedTrapezoidal,
    others=tuple(
        ModifiedTrapezoidal(durations)
        for durations in (
            (0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1),
            (0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2),
            (0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0),
            (0.0, 0.0, 0.4, 0.1, 0.0, 0.5, 0.0),
        )
    ),
    beyond=(ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1), Ends(2.0, 1.0, -0.5)),),
)
