"""What goes in and out of a law: numbers, arrays of any shape, and what is refused."""

import math

import numpy as np
import pytest

from engine.laws import CATALOGUE, Dwell, Piece, PieceLaw
from engine.laws.base import BREAK_TOLERANCE, ROUNDING
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.ramps import TrapezoidalVelocity

LAWS = pytest.mark.parametrize("law", [e() for e in CATALOGUE], ids=[e.code for e in CATALOGUE])


@LAWS
@pytest.mark.parametrize("xi", [0, 1, 0.3, np.float64(0.3), np.float32(0.5)])
def test_a_number_gives_floats(law, xi):
    assert {type(x) for x in law.evaluate(xi)} == {float}
    assert type(law.s(xi)) is type(law.v(xi)) is type(law.a(xi)) is type(law.j(xi)) is float


@LAWS
@pytest.mark.parametrize("shape", [(), (0,), (1,), (5,), (2, 3), (2, 0), (2, 1, 4)])
def test_an_array_gives_arrays_of_its_shape(law, shape):
    xi = np.random.default_rng(0).random(shape)
    values = law.evaluate(np.asarray(xi))
    assert all(isinstance(x, np.ndarray) and x.shape == shape and x.dtype == float for x in values)
    for i in np.ndindex(shape):
        assert [x[i] for x in values] == pytest.approx(law.evaluate(float(np.asarray(xi)[i])), abs=1e-13)


@LAWS
def test_samples_are_left_as_they_were(law):
    xi = np.array([-1e-13, 0.5, 1 + 1e-13])
    law.evaluate(xi)
    assert xi.tolist() == [-1e-13, 0.5, 1 + 1e-13]


@LAWS
@pytest.mark.parametrize("xi", [-0.1, 1.1, 1 + 1e-11, math.inf, -math.inf, [0.2, 1.5]])
def test_abscissae_outside_are_refused(law, xi):
    with pytest.raises(ValueError, match="expected numbers from 0 to 1"):
        law.evaluate(np.array(xi))


@LAWS
def test_nan_is_refused_by_name(law):
    with pytest.raises(ValueError, match="holds NaN"):
        law.evaluate(np.array([0.1, math.nan]))


@LAWS
def test_rounding_beyond_the_ends_counts_as_the_end(law):
    assert law.evaluate(-ROUNDING) == law.start
    assert law.evaluate(1 + ROUNDING) == law.end


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda: TrapezoidalVelocity(0.0, 0.5), "rise_end is 0"),
        (lambda: TrapezoidalVelocity(0.6, 0.5), "expected 0 < rise_end <= fall_start < 1"),
        (lambda: TrapezoidalVelocity(0.5, 1.0), "fall_start 1"),
        (lambda: TrapezoidalVelocity(math.nan, 0.5), "rise_end is nan"),
        (lambda: ModifiedTrapezoidal((0.5, 0.5)), "2 durations are given; expected seven"),
        (lambda: ModifiedTrapezoidal((0.5, -0.5, 0.5, 0, 0.5, 0, 0)), "stage 2 is -0.5"),
        (lambda: ModifiedTrapezoidal((math.nan, 0, 0, 0, 0, 0, 1)), "stage 1 is nan"),
        (lambda: ModifiedTrapezoidal((0.1,) * 7), "sum to 0.7"),
        (lambda: ModifiedTrapezoidal((0, 0, 0, 0.5, 0.5, 0, 0)), "stages 1 to 3 are all zero"),
        (lambda: ModifiedTrapezoidal((0.5, 0, 0, 0.5, 0, 0, 0)), "stages 5 to 7 are all zero"),
        (lambda: Piece(-0.1), "duration of a piece is -0.1"),
        (lambda: Piece(1.0, (1.0, 2.0)), "2 coefficients .* expected c0 to c3, c4 or c5"),
        (lambda: Piece(1.0, (0.0,) * 7), "7 coefficients"),
        (lambda: Piece(1.0, omega=math.inf), "omega is inf"),
        (lambda: PieceLaw([]), "0 pieces sum to 0"),
        (lambda: PieceLaw([Piece(0.5), Piece(0.4)]), "2 pieces sum to 0.9"),
    ],
)
def test_what_cannot_be_is_refused_with_what_was_expected(made, message):
    with pytest.raises(ValueError, match=message):
        made()


def test_laws_are_values():
    assert ModifiedTrapezoidal() == ModifiedTrapezoidal([1 / 8, 1 / 4, 1 / 8, 0, 1 / 8, 1 / 4, 1 / 8])
    assert len({Dwell(), Dwell(), TrapezoidalVelocity(), TrapezoidalVelocity(0.2, 0.8)}) == 3


@LAWS
def test_a_sample_as_near_to_a_break_as_rounding_brings_it_is_on_it(law):
    for xi in law.breaks:
        a = law.evaluate(xi).a
        assert law.evaluate(max(xi - 0.9 * BREAK_TOLERANCE, 0.0)).a == pytest.approx(a, abs=1e-6)
        assert law.evaluate(min(xi + 0.9 * BREAK_TOLERANCE, 1.0)).a == pytest.approx(a, abs=1e-6)
