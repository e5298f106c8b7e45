"""Every law of the engine, with default and other parameters: closed form, pieces, quadrature, ends, reversal."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import PieceLaw
from engine.laws.constant_acceleration import ConstantAcceleration
from engine.laws.cubic import Cubic
from engine.laws.cycloidal import Cycloidal
from engine.laws.ends import EndedLaw, EndError, Ends, between, kind, kinds
from engine.laws.harmonic_combination import HarmonicCombination
from engine.laws.modified_sine import ModifiedSine
from engine.laws.modified_trapezoidal import ModifiedTrapezoidal
from engine.laws.piece_extremes import coefficients_of, extremes_of
from engine.laws.piece_rules import reversed_pieces
from engine.laws.polynomial_345 import Polynomial345
from engine.laws.polynomial_4567 import Polynomial4567
from engine.laws.pulse_law import PulseLaw
from engine.laws.s_curve import Limits, SCurve
from engine.laws.simple_harmonic import SimpleHarmonic
from engine.laws.sine_constant_cosine import SineConstantCosine
from engine.laws.sine_ramps import SineRamps
from engine.laws.sine_straight_sine import SineStraightSine
from engine.laws.trapezoid_by_share import TrapezoidByShare
from engine.laws.trapezoidal_velocity import TrapezoidalVelocity
from tests.engine.families import COEFFICIENTS, EXAMPLES, carried, integrals, largest, stages

XI = np.linspace(0, 1, 501)
EVERY = pytest.mark.parametrize("law", [law for _, law in EXAMPLES], ids=[name for name, _ in EXAMPLES])
PULSES = tuple((name, law) for name, law in EXAMPLES if isinstance(law, PulseLaw))
PULSED = pytest.mark.parametrize("law", [law for _, law in PULSES], ids=[name for name, _ in PULSES])
share = st.floats(0.1, 0.9)
number = st.floats(-3.0, 3.0)
pulsed = st.sampled_from([law for _, law in PULSES])


def assert_same(one, other, tolerance=1e-12):
    for value, expected, size in zip(one.evaluate(XI), other.evaluate(XI), largest(other), strict=True):
        assert value == pytest.approx(expected, abs=tolerance * size)
    for name in COEFFICIENTS:
        assert getattr(one.coefficients, name) == pytest.approx(getattr(other.coefficients, name), rel=tolerance), name


@EVERY
def test_closed_form_and_pieces_are_the_same(law):
    sizes = largest(law)
    for xi, values in carried(law):
        for value, expected, size in zip(law.evaluate(xi), values, sizes, strict=True):
            assert value == pytest.approx(expected, abs=1e-12 * size)


@EVERY
def test_position_and_velocity_are_the_integrals(law):
    sizes = largest(law)
    for begin, end, (ds, dv, da, _) in integrals(law):
        one, other = law.evaluate(begin), law.evaluate(end)
        assert other.s - one.s == pytest.approx(ds, abs=1e-12 * sizes[0])
        assert other.v - one.v == pytest.approx(dv, abs=1e-12 * sizes[1])
        inside = law.evaluate(np.array([begin + 1e-11, end - 1e-11]))
        assert inside.a[1] - inside.a[0] == pytest.approx(da, abs=1e-9 * max(sizes))


@EVERY
def test_root_mean_square_is_the_integral(law):
    square = sum(found[3] for _, _, found in integrals(law))
    assert law.coefficients.ca_rms == pytest.approx(math.sqrt(square), rel=1e-12)


@EVERY
def test_coefficients_are_the_extremes_of_the_pieces(law):
    """By the ladder of derivatives and by searching: independent of what a family knows in closed form."""
    ends = (law.start.a, law.end.a) if not isinstance(law, PulseLaw) and "a" in getattr(law, "takes", "") else (0, 0)
    found = coefficients_of(law.as_pieces(), law.start.v, *ends)
    for name in COEFFICIENTS:
        assert getattr(law.coefficients, name) == pytest.approx(getattr(found, name), rel=1e-12, abs=1e-13), name


@EVERY
def test_nothing_between_many_samples_exceeds_the_coefficients(law):
    k = law.coefficients
    hair = 1e-9
    for begin, end in stages(law):
        at = law.evaluate(np.linspace(begin + 1e-12, end - 1e-12, 2001))
        assert np.abs(at.v).max() <= k.cv * (1 + hair) + hair
        assert at.a.max() <= k.ca_max + hair * (1 + k.ca)
        assert at.a.min() >= k.ca_min - hair * (1 + k.ca)
        assert (at.v * at.a).max() <= k.va_max + hair * (1 + k.va)
        assert (at.v * at.a).min() >= k.va_min - hair * (1 + k.va)
        assert np.abs(at.j).max() <= k.cj * (1 + hair) + hair


@EVERY
def test_shapes_make_up_the_root_mean_square(law):
    """∫a² = peak² (flat + sine/2 + ramp/3) on either side."""
    shapes, k = law.shapes(), law.coefficients
    if shapes is None:
        return
    sides = ((k.ca_max, shapes.up), (k.ca_min, shapes.down))
    square = sum(peak**2 * (flat + sine / 2 + ramp / 3) for peak, (flat, sine, ramp) in sides)
    assert math.sqrt(square) == pytest.approx(k.ca_rms, rel=1e-12)


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


@PULSED
def test_a_law_backwards_has_its_pulses_exchanged(law):
    course, ends = law.course, law.ends
    exchanged = Bare(course._replace(rise=course.fall, rise_time=course.fall_time, fall=course.rise,
                                     fall_time=course.rise_time), replace(ends, v0=ends.v1, v1=ends.v0))  # fmt: skip
    k, other = law.coefficients, exchanged.coefficients
    assert (other.cv, other.ca_rms, other.cj) == pytest.approx((k.cv, k.ca_rms, k.cj), rel=1e-12)
    assert (other.ca_max, other.va_max) == pytest.approx((-k.ca_min, -k.va_min), rel=1e-12, abs=1e-13)
    assert (other.ca_min, other.va_min) == pytest.approx((-k.ca_max, -k.va_max), rel=1e-12, abs=1e-13)


class Bare(PulseLaw):
    """Any two pulses."""

    code = name = "bare"

    def __init__(self, course, ends):
        self.ends, self._given = ends, course

    def _course(self):
        return self._given


@given(law=pulsed, stroke=number, v0=number, v1=number)
def test_any_velocities_and_any_stroke_are_met(law, stroke, v0, v1):
    made = Bare(law.course, Ends(stroke, v0, v1))
    size = 1e-12 * (1 + abs(stroke) + abs(v0) + abs(v1)) * largest(law)[1]
    assert (made.start.s, made.end.s) == pytest.approx((0.0, stroke), abs=size)
    assert (made.start.v, made.end.v) == pytest.approx((v0, v1), abs=size)
    for xi, values in carried(made):
        for value, expected, scale in zip(made.evaluate(xi), values, largest(made), strict=True):
            assert value == pytest.approx(expected, abs=1e-12 * scale)
    assert made.coefficients.ca_rms == pytest.approx(
        math.sqrt(sum(found[3] for _, _, found in integrals(made))), rel=1e-11, abs=1e-12
    )


@given(law=pulsed, v=number)
def test_equal_velocities_at_both_ends_shear_the_law(law, v):
    """y = v ξ + (H − v) S(ξ)."""
    plain, sheared = Bare(law.course, Ends()), Bare(law.course, Ends(1.0, v, v))
    at, rest = sheared.evaluate(XI), plain.evaluate(XI)
    assert at.s == pytest.approx(v * XI + (1 - v) * rest.s, abs=1e-11)
    assert at.v == pytest.approx(v + (1 - v) * rest.v, abs=1e-11)


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


def test_the_s_curve_of_least_jerk():
    law = SCurve.of_shares(0.5, 1.0)
    assert law.durations == (0.25, 0, 0.25, 0, 0.25, 0, 0.25)
    assert (law.coefficients.cv, law.coefficients.ca, law.coefficients.cj) == pytest.approx((2, 8, 32), rel=1e-14)


limit = st.floats(0.1, 10.0)


@given(stroke=limit, v=limit, a=limit, b=limit, up=limit, down=limit)
def test_an_s_curve_of_limits_keeps_each_and_touches_enough_of_them(stroke, v, a, b, up, down):
    law, time = SCurve.of_limits(stroke, Limits(v, a, b, up, down))
    k, (rise, fall) = law.coefficients, law.course[::3]
    speed, shape = k.cv * stroke / time, stroke / time**2
    assert speed <= v * (1 + 1e-9)
    for height, top, jerk, greatest, pulse, share in (
        (k.ca_max * shape, a, up, rise.jerk, rise, law.course.rise_time),
        (-k.ca_min * shape, b, down, fall.jerk, fall, law.course.fall_time),
    ):
        assert height <= top * (1 + 1e-9)
        assert height * greatest / (share * time) == pytest.approx(jerk, rel=1e-9)
        assert pulse.flat < 1e-6 or height == pytest.approx(top, rel=1e-9)
    assert law.course.cruise < 1e-9 or speed == pytest.approx(v, rel=1e-9)


@pytest.mark.parametrize("limits", [Limits(0, 1, 1, 1, 1), Limits(1, 1, 1, -1, 1), Limits(1, math.nan, 1, 1, 1)])
def test_an_s_curve_needs_positive_limits(limits):
    with pytest.raises(ValueError, match="expected"):
        SCurve.of_limits(1.0, limits)


@given(v0=number, v1=number, b=st.floats(2.0, 20.0))
def test_a_modified_sine_of_wanted_deceleration_has_it(v0, v1, b):
    ends = Ends(1.0, v0, v1)
    try:
        law = ModifiedSine.with_deceleration(b, ends)
    except EndError:
        return
    assert law.deceleration == pytest.approx(b, rel=1e-9)
    assert (law.end.s, law.end.v) == pytest.approx((1.0, v1), abs=1e-10)


def test_the_classic_deceleration_belongs_to_half():
    law = ModifiedSine.with_deceleration(4 * math.pi**2 / (4 + math.pi), Ends())
    assert law.share == pytest.approx(0.5, rel=1e-14)


@given(b=st.floats(0.5, 40.0))
def test_a_harmonic_combination_of_wanted_end_acceleration_has_it(b):
    """μ = 2Q/((4 + π) + √((4 + π)² + 4(4 − π)Q)), Q = 2π²/B, between rest and reversal."""
    q, sum_, less = 2 * math.pi**2 / b, 4 + math.pi, 4 - math.pi
    late = 2 * q / (sum_ + math.sqrt(sum_**2 + 4 * less * q))
    if late >= 1:
        with pytest.raises(EndError, match="no share"):
            HarmonicCombination().between(Ends(a1=-b))
        return
    law = HarmonicCombination().between(Ends(a1=-b))
    assert law.share == pytest.approx(1 - late, abs=1e-12)
    assert law.end.a == pytest.approx(-b, rel=1e-11)
    back = HarmonicCombination(reversal="start").between(Ends(-1.0, a0=-b))
    assert (back.start.a, back.end.s) == pytest.approx((-b, -1.0), rel=1e-11)


@given(v0=st.floats(0.0, 1.5), b=st.floats(1.0, 20.0))
def test_a_harmonic_combination_from_a_velocity_has_the_wanted_end_acceleration(v0, b):
    try:
        law = HarmonicCombination().between(Ends(1.0, v0, a1=-b))
    except EndError:
        return
    assert (law.start.v, law.end.s, law.end.a) == pytest.approx((v0, 1.0, -b), rel=1e-9, abs=1e-12)


@given(values=st.tuples(*[number] * 7))
def test_a_quintic_and_a_septic_meet_all_their_ends(values):
    ends = Ends(*values)
    septic, quintic = Polynomial4567().between(ends), Polynomial345().between(replace(ends, j0=0.0, j1=0.0))
    cubic = Cubic().between(Ends(*values[:3]))
    for law, upto in ((cubic, 2), (quintic, 3), (septic, 4)):
        begin, end = law.start, law.end
        assert begin[:upto] == pytest.approx([0.0, ends.v0, ends.a0, ends.j0][:upto], abs=1e-12)
        assert end[:upto] == pytest.approx([ends.stroke, ends.v1, ends.a1, ends.j1][:upto], abs=2e-10)


@given(values=st.tuples(*[number] * 5))
def test_the_quintics_acceleration_is_extreme_at_the_roots_of_its_jerk(values):
    """The parabola c1 + 2c2u + 3c3u² in a form that is safe for c3 → 0."""
    law = Polynomial345().between(Ends(*values))
    c0, c1, c2, c3 = law.polynomial
    found, under = [0.0, 1.0], c2 * c2 - 3 * c1 * c3
    if under >= 0:
        q = -(c2 + math.copysign(math.sqrt(under), c2))
        found += [u for u in (q / (3 * c3) if c3 else -1, c1 / q if q else -1) if 0 < u < 1]
    a = [c0 + u * (c1 + u * (c2 + u * c3)) for u in found]
    k = law.coefficients
    size = 1 + max(map(abs, a))
    assert (k.ca_max, k.ca_min) == pytest.approx((max(a), min(a)), abs=1e-12 * size)


@given(v0=number, v1=number, stroke=number)
def test_of_all_motions_between_two_velocities_the_cubic_has_the_least_square(v0, v1, stroke):
    cubic = Cubic().between(Ends(stroke, v0, v1))
    expected = 12 * (stroke - (v0 + v1) / 2) ** 2 + (v1 - v0) ** 2
    assert cubic.coefficients.ca_rms**2 == pytest.approx(expected, rel=1e-9, abs=1e-9)
    for law in (ModifiedSine(), TrapezoidalVelocity(), SCurve(), Cycloidal()):
        assert law.between(Ends(stroke, v0, v1)).coefficients.ca_rms ** 2 >= expected * (1 - 1e-9) - 1e-9


@pytest.mark.parametrize("family", [Cubic, Polynomial345, Polynomial4567])
def test_polynomials_between_rests_are_those_of_the_catalogue(family):
    (whole,) = family().as_pieces()
    assert family.ENDED(Ends()).as_pieces() == (whole,)


def test_half_a_polynomial_345_leads_from_rest_to_a_velocity():
    """H = 8VT/15: the quintic from rest to V is the half of the polynomial 3-4-5."""
    law = Polynomial345().between(Ends(8 / 15, 0.0, 1.0))
    assert law.polynomial == pytest.approx((0.0, 8.0, -12.0, 4.0), abs=1e-12)
    assert law.coefficients.ca == pytest.approx(8 / (3 * math.sqrt(3)), rel=1e-12)


@pytest.mark.parametrize(("ratio", "turns"), [(0.399, True), (0.401, False), (0.599, False), (0.601, True)])
def test_a_quintic_into_a_velocity_is_monotone_between_two_and_three_fifths(ratio, turns):
    law = Polynomial345().between(Ends(ratio, 0.0, 1.0))
    low, high = extremes_of(law.as_pieces(), 0.0).v
    assert (low < -1e-9 or high > 1 + 1e-9) == turns


@pytest.mark.parametrize(
    ("law", "ends", "reason"),
    [
        (ModifiedSine(), Ends(a0=1.0), "Modified sine cannot begin with a prescribed acceleration: it takes velocity"),
        (SCurve(), Ends(j1=1.0), "Jerk-limited S-curve cannot end with a prescribed jerk"),
        (Polynomial345(), Ends(j0=1.0), "Polynomial 3-4-5 cannot begin with a prescribed jerk: it takes velocity and"),
        (Cubic(), Ends(a1=1.0), "Cubic cannot end with a prescribed acceleration"),
        (Polynomial345(0.3), Ends(v1=1.0), "with the share 0.3 is made of two halves that begin and end at rest"),
        (PieceLaw(Polynomial345().as_pieces()), Ends(v0=1.0), "Own law cannot begin with a prescribed velocity: its"),
        (HarmonicCombination(), Ends(a0=1.0), "Harmonic combination cannot begin with a prescribed acceleration"),
        (HarmonicCombination(), Ends(a1=9.0), "no share between 0 and 1 gives a harmonic combination"),
    ],
)
def test_an_end_that_a_law_cannot_have_is_refused_with_the_reason(law, ends, reason):
    with pytest.raises(EndError, match=reason):
        between(law, ends)


@EVERY
def test_between_rests_a_law_is_itself(law):
    assert between(law, Ends(3.0)) == (law, 3.0)


@pytest.mark.parametrize(
    ("law", "expected"),
    [
        (ModifiedSine(), ("RG", "RG")), (ModifiedSine(0.5, 0.25, 0.0), ("RG", "UB")), (SCurve(), ("RG", "RG")),
        (SimpleHarmonic(), ("UB", "UB")), (HarmonicCombination(), ("RG", "UB")),
        (HarmonicCombination(reversal="start"), ("UB", "RG")), (Polynomial345(), ("RGUB", "RGUB")),
        (Polynomial345(0.4), ("R", "R")), (Cubic(), ("UB", "UB")), (Cubic(0.4), ("U", "U")),
    ],
)  # fmt: skip
def test_kinds_of_end(law, expected):
    assert kinds(law) == expected


@pytest.mark.parametrize(("v", "a", "expected"), [(0, 0, "R"), (1, 0, "G"), (0, -1, "U"), (-1, 1, "B")])
def test_kind_of_an_end(v, a, expected):
    assert kind(v, a) == kind(v + 1e-12, a - 1e-12) == expected


@EVERY
def test_the_kinds_of_a_law_are_what_its_ends_show(law):
    """Between rests a law is one of R and U at either end; with a velocity, one of G and B."""
    if not isinstance(law, EndedLaw) or "v" not in law.takes:
        return
    ended = law.between(Ends(1.0, 0.7, 0.4))
    for allowed, at in zip(kinds(law), (ended.start, ended.end), strict=True):
        assert kind(at.v, at.a / (ended.coefficients.ca or 1.0)) in allowed
