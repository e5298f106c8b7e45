"""Coefficients of the families to 13 digits, worked out with forty: quadrature and dense searches refined."""

import math
from dataclasses import dataclass

import pytest

from engine.laws.modified import (
    HarmonicCombination,
    ModifiedSine,
    ModifiedTrapezoidal,
    SineConstantCosine,
    SineStraightSine,
    TrapezoidByShare,
)
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.pulse_law import PulseLaw, TwoPulses, polynomial_pulse
from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, SimpleHarmonic
from tests.engine.extremes import extremes_of

INF = math.inf


@dataclass(frozen=True)
class TwoQuartics(PulseLaw):
    """Two pulses 4x(1 − x): a law of the pulses' formula that no family is."""

    code = name = "two quartics"

    share: float

    def _pulses(self):
        pulse = polynomial_pulse(0.0, 4.0, -4.0)
        return TwoPulses(pulse, self.share, 0.0, pulse, 1.0 - self.share)


def straight(part):
    """Modified sine with a part at constant velocity."""
    return SineConstantCosine((1 - part) / 4, 0.0, 3 * (1 - part) / 4, part)


SYMMETRIC = [
    # law, C_v, C_a, C_a,rms, C_j between jumps, (va), C_j is finite; the catalogue's own stand in claims.py
    (TrapezoidalVelocity(0.25, 0.75), 1.333333333333, 5.333333333333, 3.771236166328, 0, 7.111111111111, False),
    (straight(0.2), 1.527538675879, 5.998630352770, 3.793866951235, 94.22626523932, 5.141368390317, True),
    (straight(1 / 3), 1.404086978319, 6.616604004132, 3.820098102907, 124.7200471866, 5.212709977676, True),
    (straight(0.5), 1.275258172903, 8.012683414843, 4.006341707422, 201.3806988129, 5.733377092131, True),
    (SCurve.of_shares(1 / 3, 0.5), 1.5, 6, 4, 72, 7.5, True),
    (SineRamps(1 / 3, 2 / 3), 1.5, 7.068583470577, 4.081048569527, 66.61982970735, 6.886769461077, True),
    (TwoQuartics(0.5), 2, 6, 4.381780460041, 48, 7.921674282790, True),
    (SCurve.of_shares(0.5, 1.0), 2, 8, 4.618802153517, 32, 8.709296863229, True),
]

ASYMMETRIC = [
    # law, C_v, C_a+, C_a-, C_a,rms, C_j between jumps, (va)+, (va)-
    (DoubleHarmonic(), 2.040524284763, 5.551652475613, -9.869604401089, 4.934802200545, 42.41372003138,
     7.751569170075, -9.894846852688),
    (SimpleHarmonic(0.3), 1.570796326795, 8.224670334241, -3.524858714675, 3.807282554722, 43.06427316708,
     6.459640975062, -2.768417560741),
    (Cycloidal(0.3), 2.0, 10.47197551197, -4.487989505128, 4.847582706652, 109.6622711232, 13.60349523176,
     -5.830069385039),
    (Cubic(0.3), 1.5, 10.0, -4.285714285714, 3.779644730092, 33.33333333333, 5.773502691896, -2.474358296527),
    (ConstantAcceleration(0.3), 2.0, 6.666666666667, -2.857142857143, 4.36435780472, 0.0, 13.33333333333,
     -5.714285714286),
    (Polynomial345(0.3), 1.875, 9.622504486494, -4.123930494212, 4.517539514526, 166.6666666667, 11.15711454583,
     -4.78162051964),
    (Polynomial4567(0.3), 2.1875, 12.521980674, -5.366563145999, 5.504818825632, 145.8333333333, 17.91704360671,
     -7.678732974305),
    (ModifiedSine(0.3), 1.759603385954, 9.21326178424, -3.948540764674, 4.264911472158, 192.9621035798,
     9.096254604532, -3.898394830514),
    (TrapezoidByShare(0.3), 2.0, 8.146872938022, -3.491516973438, 4.618842805039, 170.6277078121, 13.48330163719,
     -5.778557844509),
    (TwoQuartics(0.3), 2.0, 10.0, -4.285714285714, 4.780914437338, 133.3333333333, 13.20279047132, -5.658338773421),
    (ModifiedSine(0.3, 0.25, 0.4), 1.85315683808, 9.703106514101, -4.158474220329, 4.491665520494, 203.2213876113,
     10.08921513547, -4.699078141165),
    (SineRamps(0.2, 0.7), 1.333333333333, 10.47197551197, -6.981317007977, 4.27516610054, 164.4934066848,
     9.068996821171, -6.045997880781),
    (TrapezoidalVelocity(0.2, 0.7), 1.333333333333, 6.666666666667, -4.444444444444, 3.849001794598, 0.0,
     8.888888888889, -5.925925925926),
    (SCurve.of_shares(0.3, 0.4), 1.428571428571, 5.952380952381, -5.952380952381, 3.948362845661, 99.20634920635,
     7.440476190476, -7.440476190476),
    (ModifiedTrapezoidal((0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2)), 1.714218375908, 5.801215507610, -4.833578128229,
     4.032855208420, 182.250560206, 8.073228158859, -5.958798342942),
    (SCurve((0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2)), 1.705426356589, 6.201550387597, -5.684754521964,
     4.141896674629, 124.0310077519, 8.653326122228, -6.463286794998),
    (SineConstantCosine(0.1, 0.6, 0.3), 1.873879575450, 4.385149851380, -4.385149851380, 3.922197263683,
     137.7635455798, 6.622837385730, -6.622837385730),
    (HarmonicCombination(), 1.659847930380, 5.214566064158, -5.214566064158, 3.687255024911, 65.52816975527,
     4.856471927851, -4.327693344711),
    (HarmonicCombination(0.3), 1.623042512402, 8.498230722375, -3.642098881018, 3.933916407640, 177.9865280395,
     7.739142096100, -2.955640659131),
    (SineStraightSine(0.3, 0.4), 1.122352176853, 14.69155563975, -9.794370426501, 4.645877819271, 192.3120136152,
     8.244549726813, -5.496366484542),
    (TrapezoidByShare(0.5, "end"), 1.848293503297, 4.517343697060, -4.517343697060, 3.912134399279, 56.76661508970,
     None, None),
]  # fmt: skip


def digits(wanted):
    """Half a unit of the thirteenth digit."""
    unit = 10.0 ** (math.floor(math.log10(abs(wanted))) - 12) if wanted else 1e-12
    return pytest.approx(wanted, rel=0, abs=0.501 * unit)


def jerk_between_jumps(law):
    return max(map(abs, extremes_of(law.as_pieces(), law.start.v).j))


@pytest.mark.parametrize("row", SYMMETRIC, ids=lambda row: f"{row[0].code} {row[1]}")
def test_figures_of_symmetric_laws(row):
    law, cv, ca, rms, cj, va, finite = row
    k = law.coefficients
    for got, wanted in ((k.cv, cv), (k.ca_max, ca), (-k.ca_min, ca), (k.ca_rms, rms), (k.va_max, va), (-k.va_min, va)):
        assert got == digits(wanted)
    assert jerk_between_jumps(law) == digits(cj)
    assert math.isfinite(k.cj) == finite
    assert k.cj == (pytest.approx(jerk_between_jumps(law), rel=1e-12) if finite else INF)


@pytest.mark.parametrize("row", ASYMMETRIC, ids=lambda row: f"{row[0].code} {row[1]} {row[2]}")
def test_figures_of_asymmetric_laws(row):
    law, cv, *figures, cj, va_max, va_min = row
    k = law.coefficients
    for got, wanted in zip((k.cv, k.ca_max, k.ca_min, k.ca_rms, k.va_max, k.va_min), (cv, *figures, va_max, va_min),
                           strict=True):  # fmt: skip
        assert wanted is None or got == digits(wanted)
    assert jerk_between_jumps(law) == digits(cj)
