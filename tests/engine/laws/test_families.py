"""Every law of the engine, with default and other parameters: pieces, quadrature, ends, reversal."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import PieceLaw
from engine.laws.base import BREAK_TOLERANCE
from engine.laws.ends import BoundaryValues
from engine.laws.modified import (
    HarmonicCombination,
    ModifiedSine,
    ModifiedTrapezoidal,
    SineConstantCosine,
    SineStraightSine,
    TrapezoidByShare,
)
from engine.laws.piece import reversed_pieces
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.pulse_law import PulseLaw, TwoPulses
from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal, SimpleHarmonic
from tests.engine.families import COEFFICIENTS, EXAMPLES, carried, integrals, largest

XI = np.linspace(0, 1, 501)
HAIR = 2 * BREAK_TOLERANCE  # so far from a break a sample is on its own side
EVERY = pytest.mark.parametrize("law", [law for _, law in EXAMPLES], ids=[name for name, _ in EXAMPLES])
share = st.floats(0.1, 0.9)
number = st.floats(-3.0, 3.0)
pulsed = st.sampled_from([law for _, law in EXAMPLES if isinstance(law, PulseLaw)])


def assert_same(one, other, tolerance=1e-12):
    for value, expected, size in zip(one.evaluate(XI), other.evaluate(XI), largest(other), strict=True):
        assert value == pytest.approx(expected, abs=tolerance * size)
    for name in COEFFICIENTS:
        assert getattr(one.coefficients, name) == pytest.approx(getattr(other.coefficients, name), rel=tolerance), name


@EVERY
def test_the_law_is_its_pieces_one_after_the_other(law):
    sizes = largest(law)
    for xi, values in carried(law):
        for value, expected, size in zip(law.evaluate(xi), values, sizes, strict=True):
            assert value == pytest.approx(expected, abs=1e-12 * size)


@EVERY
def test_position_and_velocity_are_the_integrals(law):
    sizes = largest(law)
    for begin, end, (ds, dv, da, *_) in integrals(law):
        one, other = law.evaluate(begin), law.evaluate(end)
        assert other.s - one.s == pytest.approx(ds, abs=1e-12 * sizes[0])
        assert other.v - one.v == pytest.approx(dv, abs=1e-12 * sizes[1])
        inside = law.evaluate(np.array([begin + HAIR, end - HAIR]))
        assert inside.a[1] - inside.a[0] == pytest.approx(da, abs=4 * HAIR * sizes[3] + 1e-12 * sizes[2])


@EVERY
def test_pieces_told_backwards_are_the_law_backwards(law):
    """s'(ξ) = s(1) − s(1 − ξ), v' = v(1 − ξ), a' = −a(1 − ξ), j' = j(1 − ξ)."""
    backwards, back = reversed_pieces(law.as_pieces()), law.end
    sizes = largest(law)
    told = [*carried(Told(backwards, back.v))]
    for xi, (s, v, a, j) in told:
        at = law.evaluate(1.0 - xi)
        for value, expected, size in zip((s, v, a, j), (back.s - at.s, at.v, -at.a, at.j), sizes, strict=True):
            assert value == pytest.approx(expected, abs=3e-12 * size)


class Told:
    """Pieces with the velocity that they are entered with: what ``carried`` needs of a law."""

    def __init__(self, pieces, v):
        self.pieces = pieces
        self.start = PieceLaw([replace(pieces[0], duration=1.0)]).start._replace(v=v)

    def as_pieces(self):
        return self.pieces


@dataclass(frozen=True)
class Bare(PulseLaw):
    """Any two pulses."""

    code = name = "bare"

    given: TwoPulses

    def _pulses(self):
        return self.given


@given(law=pulsed, stroke=number, v0=number, v1=number)
def test_any_velocities_and_any_stroke_are_met(law, stroke, v0, v1):
    made = Bare(law.pulses, ends=BoundaryValues(stroke, v0, v1))
    size = 1e-12 * (1 + abs(stroke) + abs(v0) + abs(v1)) * largest(law)[1]
    assert (made.start.s, made.end.s) == pytest.approx((0.0, stroke), abs=size)
    assert (made.start.v, made.end.v) == pytest.approx((v0, v1), abs=size)
    for xi, values in carried(made):
        for value, expected, scale in zip(made.evaluate(xi), values, largest(made), strict=True):
            assert value == pytest.approx(expected, abs=1e-12 * scale)
    assert made.coefficients.ca_rms == pytest.approx(
        math.sqrt(sum(found[3] for _, _, found in integrals(made))), rel=1e-11, abs=1e-12
    )


SHIFTED = (ConstantAcceleration, Cubic, SimpleHarmonic, Cycloidal, Polynomial345, Polynomial4567, ModifiedSine,
           TrapezoidByShare)  # fmt: skip


@pytest.mark.parametrize("family", SHIFTED)
@given(share=share)
def test_a_share_shifts_the_inflection_along_the_diagonal(family, share):
    """s = 2λ S(ξ/2λ), then 1 − 2μ S((1 − ξ)/2μ): s(λ) = λ, and the coefficients follow."""
    law, half = family(share=share), family()
    rest = 1 - share
    xi = share * np.linspace(0, 1, 33)[:-1]
    assert law.s(xi) == pytest.approx(2 * share * half.s(xi / (2 * share)), abs=1e-12)
    xi = 1 - rest * np.linspace(0, 1, 33)
    assert law.s(xi) == pytest.approx(1 - 2 * rest * half.s((1 - xi) / (2 * rest)), abs=1e-12)
    k, one = law.coefficients, half.coefficients
    assert (law.s(share), k.cv) == pytest.approx((share, one.cv), rel=1e-12)
    assert (k.ca_max, k.ca_min) == pytest.approx((one.ca_max / (2 * share), one.ca_min / (2 * rest)), rel=1e-12)
    assert (k.va_max, k.va_min) == pytest.approx((one.va_max / (2 * share), one.va_min / (2 * rest)), rel=1e-12)
    assert k.ca_rms == pytest.approx(one.ca_rms / (2 * math.sqrt(share * rest)), rel=1e-12)
    if math.isfinite(one.cj):
        assert k.cj == pytest.approx(one.cj / (4 * min(share, rest) ** 2), rel=1e-12)


def seven(*durations):
    return ModifiedTrapezoidal(durations)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (seven(0, 0.3, 0, 0, 0, 0.7, 0), ConstantAcceleration(0.3)),
        (seven(0, 0, 0.3, 0, 0.7, 0, 0), SimpleHarmonic(0.3)),
        (seven(0.15, 0, 0.15, 0, 0.35, 0, 0.35), Cycloidal(0.3)),
        (seven(0.075, 0, 0.225, 0, 0.525, 0, 0.175), ModifiedSine(0.3)),
        (seven(0.075, 0.15, 0.075, 0, 0.175, 0.35, 0.175), TrapezoidByShare(0.3)),
        (seven(0, 0.2, 0, 0.5, 0, 0.3, 0), TrapezoidalVelocity(0.2, 0.7)),
        (seven(0.1, 0, 0.1, 0.5, 0.15, 0, 0.15), SineRamps(0.2, 0.7)),
        (seven(0, 0, 0.12, 0.7, 0.18, 0, 0), SineStraightSine(0.3, 0.4)),
        (SineConstantCosine(0, 1, 0), ConstantAcceleration()),
        (SineConstantCosine(0.25, 0.5, 0.25, share=0.3), TrapezoidByShare(0.3)),
        (SineConstantCosine(0, 0, 1), SimpleHarmonic()),
        (SineConstantCosine(0.25, 0, 0.75), ModifiedSine()),
        (SineConstantCosine(0.5, 0, 0.5), Cycloidal()),
        (SineConstantCosine(0.25, 0, 0.25, 0.5), SineRamps()),
        (ModifiedSine(0.3, 0.0, 0.0), SimpleHarmonic(0.3)),
        (ModifiedSine(0.3, 0.5, 0.5), Cycloidal(0.3)),
        (ModifiedSine(0.3, 0.25, 0.0), HarmonicCombination(0.3)),
        (ModifiedSine(0.3, 0.0, 0.25), HarmonicCombination(0.3, "start")),
        (SineStraightSine(1.0, 0.3), SimpleHarmonic(0.3)),
        (SCurve.of_shares(0.5, 0.0), ConstantAcceleration()),
        (SCurve.of_shares(0.25, 0.0), TrapezoidalVelocity(0.25, 0.75)),
        (SCurve((0, 0, 0.3, 0, 0.7, 0, 0)), Cubic(0.3)),
        (TrapezoidalVelocity(0.3, 0.3), ConstantAcceleration(0.3)),
        (SineRamps(0.3, 0.3), Cycloidal(0.3)),
        (TrapezoidByShare(0.5, "end", 1.0), seven(0.125, 0.25, 0.125, 0, 0.5, 0, 0)),
        (TrapezoidByShare(0.4, "start", 0.0), seven(0, 0.4, 0, 0, 0.15, 0.3, 0.15)),
    ],
)  # fmt: skip
def test_a_family_contains(one, other):
    assert_same(one, other)
