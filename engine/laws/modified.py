"""Laws of two pulses with edges of a quarter sine: MTP, MTS, MSN, SCC, HAC, SGS."""

import math
from dataclasses import dataclass, replace
from typing import Literal

from engine.laws.base import require_finite
from engine.laws.ends import BoundaryValues, EndError
from engine.laws.family import Vendors
from engine.laws.pulse_law import (
    FALLING_SINE,
    SUM_TOLERANCE,
    PulseLaw,
    TwoPulses,
    edged,
    pulses_of,
    require_shares,
    seven_durations,
)

CLASSIC = (1 / 8, 1 / 4, 1 / 8, 0.0, 1 / 8, 1 / 4, 1 / 8)


@dataclass(frozen=True)
class ModifiedTrapezoidal(PulseLaw):
    """Seven stages: a = A sin(πu/2d1), A, A cos(πu/2d3), 0, −B sin(πu/2d5), −B, −B cos(πu/2d7).

    With k = 2/π, m = k d1 + d2 + k d3 and n = k d5 + d6 + k d7, A m = B n = C_v and A = 1/(S_a + m d4 + S_d m/n), where
    S_a and S_d are the travels of the two pulses for unit acceleration. Raises ValueError unless the shares are 0 or
    more, sum to 1 (within 1e-9), and neither the first three nor the last three are all 0.
    """

    code = "MTP"
    number = 6
    name = "Modified trapezoidal"
    aliases = ("ModTVP", "modified trapezoidal acceleration", "modified trapezoid", "mod trap", "MT")
    source = "S1, 'Modified trapezoidal (acceleration) curve (seven parameters)'; S3, figure 2, 'ModTVP'"
    vendors = Vendors(siemens="D_D_MOD_ACCEL_TRAPEZOID (11)", twincat="BESCHLTRAPEZ (13)")

    durations: tuple[float, ...] = CLASSIC  # d1 to d7, shares of the time

    def __post_init__(self) -> None:
        object.__setattr__(self, "durations", seven_durations(self.durations))

    def _pulses(self) -> TwoPulses:
        return pulses_of(self.durations, sine=True)


CLASSIC_PULSE = edged(0.25, 0.5, 0.25)


@dataclass(frozen=True)
class TrapezoidByShare(PulseLaw):
    """The pulses ¼-½-¼ of the modified trapezoid over λ and over 1 − λ; or either of them cut off at a reversal.

    At a reversal the pulse is constant at the law's end, and falls to 0 on a quarter sine at its inner end. Vendors do
    not publish ``edge``; with ½ and λ = ½ both pulses have the same height. Raises ValueError outside the ranges below.
    Source: LCamHdl, ProfileTypes, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D; SolidWorks, modified trapezoid (⅛, ⅜, ⅝, ⅞).
    """

    code = "MTS"
    number = 14
    name = "Modified trapezoid by share"
    aliases = ("modifiziertes Beschleunigungstrapez",)
    source = "LCamHdl, ProfileTypes, D_D_MOD_ACCEL_TRAPEZOID, D_R and R_D"
    vendors = Vendors(siemens="D_D_MOD_ACCEL_TRAPEZOID (11)", twincat="BESCHLTRAPEZ (13)")
    STAGES = (0, 1, 2, 4, 5, 6)

    share: float = 0.5  # λ, between 0 and 1
    reversal: Literal["none", "start", "end"] = "none"  # the end that turns round
    edge: float = 0.5  # share of the pulse at a reversal that is a quarter sine, 0 to 1

    def __post_init__(self) -> None:
        require_shares(share=self.share)
        require_shares(ends=True, edge=self.edge)
        if self.reversal not in ("none", "start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'none', 'start' or 'end'")

    def _pulses(self) -> TwoPulses:
        cut = edged(0.0, 1.0 - self.edge, self.edge)
        rise, fall = (cut if self.reversal == end else CLASSIC_PULSE for end in ("start", "end"))
        return TwoPulses(rise, self.share, 0.0, fall, 1.0 - self.share)


N = 2.0 * math.pi**2 / (4.0 + math.pi)
LATE = (3.0 * math.pi - 4.0) / (4.0 * math.pi)  # κ' of the pulse reversed in time


@dataclass(frozen=True)
class ModifiedSine(PulseLaw):
    """Quarters of a sine: up over β₁λ, down over (1 − β₁)λ, and the like downwards with β₂ and μ = 1 − λ.

    Source: Neklutin's modified sine, as in LCamHdl, ProfileTypes, D_D_MOD_SINE and, between velocities, C_C_MOD_SINE,
    D_C_MOD_SINE, C_D_MOD_SINE; mechdesigner.support, 'Modified-Sinusoid'.
    """

    code = "MSN"
    number = 13
    name = "Modified sine"
    aliases = ("modified sinusoid", "mod sine", "MS", "modifizierte Sinuslinie")
    source = "LCamHdl, ProfileTypes, D_D_MOD_SINE; mechdesigner.support, 'Modified-Sinusoid'"
    vendors = Vendors(
        siemens="D_D_MOD_SINE (12)", twincat="MODSINUSLINIE (11)", codesys="ModifiedSine", sew="MODIFIED_SINE"
    )
    STAGES = (0, 2, 4, 6)

    share: float = 0.5  # λ, between 0 and 1, else ValueError
    # β₁, of its half, 0 to 1: ¼ modified sine, ½ cycloidal, 0 simple harmonic
    rise_edge: float = 0.25
    fall_edge: float = 0.25  # β₂, likewise

    def __post_init__(self) -> None:
        require_shares(share=self.share)
        require_shares(ends=True, rise_edge=self.rise_edge, fall_edge=self.fall_edge)

    def _pulses(self) -> TwoPulses:
        rise = edged(self.rise_edge, 0.0, 1.0 - self.rise_edge)
        fall = edged(self.fall_edge, 0.0, 1.0 - self.fall_edge)
        return TwoPulses(rise, self.share, 0.0, fall, 1.0 - self.share)

    @classmethod
    def with_deceleration(cls, deceleration: float, ends: BoundaryValues) -> "ModifiedSine":
        """Return the classic law whose share λ makes the second pulse B high: the option Ca* of cam editors.

        μ = [N(H − v0) − π(v1 − v0)/2]/[B + Nκ'(v1 − v0)], κ' = (3π − 4)/4π, N = 2π²/(4 + π), with B by ξ². Raises
        EndError if no share between 0 and 1 does. Source: LCamHdl, types, 'Ca*'; CODESYS, SM3_CamBuilder, ModifiedSine.
        """
        gained = ends.v1 - ends.v0
        over = deceleration + N * LATE * gained
        late = (N * (ends.stroke - ends.v0) - math.pi / 2.0 * gained) / over if over else math.inf
        if not 0.0 < late < 1.0:
            raise EndError(f"no share between 0 and 1 gives a modified sine the deceleration {deceleration:g}")
        return replace(cls(1.0 - late), ends=ends)


@dataclass(frozen=True)
class SineConstantCosine(PulseLaw):
    """Norton's family: sine edges at the dwells, constants, cosine edges inside, and a part at constant velocity.

    Raises ValueError unless the shares b, c, d and e sum to 1 (within 1e-9). With λ = ½ and e = 0,
    C_a = 4π²/[(π² − 8)(b² − d²) − 2π(π − 2)b + π²]. It contains constant acceleration (0, 1, 0), the modified trapezoid
    (¼, ½, ¼), simple harmonic (0, 0, 1), modified sine (¼, 0, ¾) and cycloidal motion (½, 0, ½).
    """

    code = "SCC"
    number = 15
    name = "Sine-constant-cosine"
    aliases = ("SCCA",)
    source = "PTC Creo, 'SCCA'; mechdesigner.support, 'Sine-Constant-Cosine'"

    sine: float = 1 / 3  # b, share of the whole time, not negative
    constant: float = 1 / 3  # c, likewise
    cosine: float = 1 / 3  # d, likewise
    straight: float = 0.0  # e, likewise, below 1
    share: float = 0.5  # λ, the first pulse's share of what is not straight, between 0 and 1

    def __post_init__(self) -> None:
        parts = {name: getattr(self, name) for name in ("sine", "constant", "cosine", "straight")}
        require_shares(ends=True, **parts)
        total = math.fsum(parts.values())
        if abs(total - 1.0) > SUM_TOLERANCE:
            raise ValueError(f"the shares {', '.join(parts)} sum to {total:.12g}; expected 1")
        if not self._bent > 0.0:
            raise ValueError("straight is 1; expected time to speed up and slow down")
        require_shares(share=self.share)

    @property
    def _bent(self) -> float:
        return self.sine + self.constant + self.cosine

    def _pulses(self) -> TwoPulses:
        bent = self._bent
        pulse = edged(self.sine / bent, self.constant / bent, self.cosine / bent)
        return TwoPulses(pulse, self.share * bent, self.straight, pulse, (1.0 - self.share) * bent)


REST_SIDE = edged(0.25, 0.0, 0.75)


@dataclass(frozen=True)
class HarmonicCombination(PulseLaw):
    """A modified sine at an end, and at the other, where it turns round, a quarter of a sine.

    Source: LCamHdl, ProfileTypes, D_R_, R_D_, C_R_ and R_C_HARMONIC_COMBI; camdoku of i-halbritter.
    """

    code = "HAC"
    number = 16
    name = "Harmonic combination"
    aliases = ("harmonische Kombination",)
    source = "LCamHdl, ProfileTypes, D_R_, R_D_, C_R_ and R_C_HARMONIC_COMBI"
    vendors = Vendors(siemens="D_R_HARMONIC_COMBINATION (20)")
    STAGES = (0, 2, 4, 6)

    share: float = 0.5  # λ, between 0 and 1, else ValueError
    # which end turns round; the other is a rest or a velocity
    reversal: Literal["start", "end"] = "end"

    def __post_init__(self) -> None:
        require_shares(share=self.share)
        if self.reversal not in ("start", "end"):
            raise ValueError(f"reversal is {self.reversal!r}; expected 'start' or 'end'")

    def _pulses(self) -> TwoPulses:
        rise, fall = (REST_SIDE, FALLING_SINE) if self.reversal == "end" else (FALLING_SINE, REST_SIDE)
        return TwoPulses(rise, self.share, 0.0, fall, 1.0 - self.share)


@dataclass(frozen=True)
class SineStraightSine(PulseLaw):
    """A quarter cosine over cλ, a straight line over 1 − c, a quarter sine over c(1 − λ), for a motion to and fro.

    V = π/(π − (π − 2)c). Its acceleration is not 0 at the ends, so a dwell beside it makes a jump.
    """

    code = "SGS"
    number = 17
    name = "Sine-straight-sine"
    aliases = ("modified velocity trapezoid", "Sinus-Gerade-Kombination")
    source = "LCamHdl, ProfileTypes, R_R_MOD_VELO_TRAPEZOID; Lenze Engineer 2.21, p. 286"
    vendors = Vendors(siemens="R_R_MOD_VELO_TRAPEZOID (14)", twincat="SINUS_GERADE_KOMBI (16)")
    STAGES = (2, 3, 4)

    curved: float = 0.5  # c, more than 0 and at most 1 (the simple harmonic law), else ValueError
    share: float = 0.5  # λ, between 0 and 1, else ValueError

    def __post_init__(self) -> None:
        require_finite(curved=self.curved)
        if not 0.0 < self.curved <= 1.0:
            raise ValueError(f"curved is {self.curved:g}; expected a share of more than 0 and at most 1")
        require_shares(share=self.share)

    def _pulses(self) -> TwoPulses:
        late = self.curved * (1.0 - self.share)
        return TwoPulses(FALLING_SINE, self.curved * self.share, 1.0 - self.curved, FALLING_SINE, late)
