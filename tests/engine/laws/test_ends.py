"""Laws between prescribed ends: what they meet, what they are wanted to have, what is refused, kinds of end."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import PieceLaw
from engine.laws.ends import BoundaryLaw, BoundaryValues, EndError, kind, kinds, law_with_ends
from engine.laws.modified import HarmonicCombination, ModifiedSine
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.ramps import Limits, SCurve, TrapezoidalVelocity
from engine.laws.simple import Cycloidal
from tests.engine.families import EXAMPLES

EVERY = pytest.mark.parametrize("law", [law for _, law in EXAMPLES], ids=[name for name, _ in EXAMPLES])
number = st.floats(-3.0, 3.0)

limit = st.floats(0.1, 10.0)


@given(stroke=limit, v=limit, a=limit, b=limit, up=limit, down=limit)
def test_an_s_curve_of_limits_keeps_each_and_touches_enough_of_them(stroke, v, a, b, up, down):
    law, time = SCurve.of_limits(stroke, Limits(v, a, b, up, down))
    k, (rise, fall) = law.coefficients, law.pulses[::3]
    speed, shape = k.cv * stroke / time, stroke / time**2
    assert speed <= v * (1 + 1e-9)
    for height, top, jerk, pulse, share in (
        (k.ca_max * shape, a, up, rise, law.pulses.rise_time),
        (-k.ca_min * shape, b, down, fall, law.pulses.fall_time),
    ):
        assert height <= top * (1 + 1e-9)
        assert height / (pulse.pieces[0].duration * share * time) == pytest.approx(jerk, rel=1e-9)
        assert pulse.pieces[1].duration < 1e-6 or height == pytest.approx(top, rel=1e-9)
    assert law.pulses.cruise < 1e-9 or speed == pytest.approx(v, rel=1e-9)


@pytest.mark.parametrize("limits", [Limits(0, 1, 1, 1, 1), Limits(1, 1, 1, -1, 1), Limits(1, math.nan, 1, 1, 1)])
def test_an_s_curve_needs_positive_limits(limits):
    with pytest.raises(ValueError, match="expected"):
        SCurve.of_limits(1.0, limits)


@given(v0=number, v1=number, b=st.floats(2.0, 20.0))
def test_a_modified_sine_of_wanted_deceleration_has_it(v0, v1, b):
    ends = BoundaryValues(1.0, v0, v1)
    try:
        law = ModifiedSine.with_deceleration(b, ends)
    except EndError:
        return
    assert law.deceleration == pytest.approx(b, rel=1e-9)
    assert (law.end.s, law.end.v) == pytest.approx((1.0, v1), abs=1e-10)


@given(values=st.tuples(*[number] * 7))
def test_a_quintic_and_a_septic_meet_all_their_ends(values):
    ends = BoundaryValues(*values)
    septic, quintic = Polynomial4567().between(ends), Polynomial345().between(replace(ends, j0=0.0, j1=0.0))
    cubic = Cubic().between(BoundaryValues(*values[:3]))
    for law, upto in ((cubic, 2), (quintic, 3), (septic, 4)):
        begin, end = law.start, law.end
        assert begin[:upto] == pytest.approx([0.0, ends.v0, ends.a0, ends.j0][:upto], abs=1e-12)
        assert end[:upto] == pytest.approx([ends.stroke, ends.v1, ends.a1, ends.j1][:upto], abs=2e-10)


@given(v0=number, v1=number, stroke=number)
def test_of_all_motions_between_two_velocities_the_cubic_has_the_least_square(v0, v1, stroke):
    cubic = Cubic().between(BoundaryValues(stroke, v0, v1))
    expected = 12 * (stroke - (v0 + v1) / 2) ** 2 + (v1 - v0) ** 2
    assert cubic.coefficients.ca_rms**2 == pytest.approx(expected, rel=1e-9, abs=1e-9)
    for law in (ModifiedSine(), TrapezoidalVelocity(), SCurve(), Cycloidal()):
        assert law.between(BoundaryValues(stroke, v0, v1)).coefficients.ca_rms ** 2 >= expected * (1 - 1e-9) - 1e-9


@pytest.mark.parametrize("family", [Cubic, Polynomial345, Polynomial4567])
def test_polynomials_between_rests_are_those_of_the_catalogue(family):
    whole, halved, xi = family.ENDED(ends=BoundaryValues()), family(), np.linspace(0.0, 1.0, 101)
    assert len(whole.as_pieces()) == 1
    for one, other in zip(whole.evaluate(xi), halved.evaluate(xi), strict=True):
        assert one == pytest.approx(other, abs=1e-11)


@pytest.mark.parametrize(
    ("law", "ends", "reason"),
    [
        (
            ModifiedSine(),
            BoundaryValues(a0=1.0),
            "Modified sine cannot begin with a prescribed acceleration: it takes velocity",
        ),
        (SCurve(), BoundaryValues(j1=1.0), "Jerk-limited S-curve cannot end with a prescribed jerk"),
        (
            Polynomial345(),
            BoundaryValues(j0=1.0),
            "Polynomial 3-4-5 cannot begin with a prescribed jerk: it takes velocity and",
        ),
        (Cubic(), BoundaryValues(a1=1.0), "Cubic cannot end with a prescribed acceleration"),
        (
            Polynomial345(0.3),
            BoundaryValues(v1=1.0),
            "with the share 0.3 is made of two halves that begin and end at rest",
        ),
        (
            PieceLaw(Polynomial345().as_pieces()),
            BoundaryValues(v0=1.0),
            "Own law cannot begin with a prescribed velocity: its",
        ),
        (
            HarmonicCombination(),
            BoundaryValues(a0=1.0),
            "Harmonic combination cannot begin with a prescribed acceleration",
        ),
    ],
)
def test_an_end_that_a_law_cannot_have_is_refused_with_the_reason(law, ends, reason):
    with pytest.raises(EndError, match=reason):
        law_with_ends(law, ends)


@EVERY
def test_the_kinds_of_a_law_are_what_its_ends_show(law):
    """Between rests a law is one of R and U at either end; with a velocity, one of G and B."""
    if not isinstance(law, BoundaryLaw) or "v" not in law.takes:
        return
    ended = law.between(BoundaryValues(1.0, 0.7, 0.4))
    for allowed, at in zip(kinds(law), (ended.start, ended.end), strict=True):
        assert kind(at.v, at.a / (ended.coefficients.ca or 1.0)) in allowed
