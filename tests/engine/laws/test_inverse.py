"""The inverse of a law: there and back for any law, the ends, stages at rest, and what is refused."""

import math
from dataclasses import replace

import numpy as np
import pytest

from engine.laws import CATALOGUE, Dwell, Piece, PieceLaw
from engine.laws.inverse import breaks, inverse, is_monotone, velocity_extremes
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.polynomials import Cubic
from engine.laws.simple import Cycloidal

MOVING = [entry() for entry in CATALOGUE if entry.code != "DWL"]
ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
UP, DOWN = Piece(0.2, (12.5, 0.0, 0.0, 0.0)), Piece(0.2, (-12.5, 0.0, 0.0, 0.0))
WITH_A_HALT = PieceLaw([UP, DOWN, Piece(0.2), UP, DOWN])
BACKWARDS = PieceLaw([Piece(0.5, (-4.0, 0, 0, 0)), Piece(0.5, (12.0, 0, 0, 0))])


@pytest.mark.parametrize("law", [*MOVING, ASYMMETRIC], ids=lambda law: law.code)
def test_there_and_back_to_the_digits_that_s_holds(law):
    xi = np.linspace(0.0, 1.0, 2001)
    at = law.evaluate(xi)
    back = inverse(law, at.s)
    assert np.abs(law.s(back) - at.s).max() <= 4e-15  # what s itself is good for
    firm = at.v > 0.01
    assert np.abs(back - xi)[firm].max() <= 4e-15 / 0.01


def test_ends_are_exact_and_shapes_are_kept():
    assert inverse(Cycloidal(), 0.0) == 0.0
    assert inverse(Cycloidal(), 1.0) == 1.0
    assert isinstance(inverse(Cubic(), 0.5), float)
    assert inverse(Cubic(), np.full((2, 3), 0.5)).shape == (2, 3)
    assert inverse(Cubic(), np.empty(0)).shape == (0,)


def test_where_the_law_halts_the_first_instant_counts():
    assert WITH_A_HALT.end.s == pytest.approx(1.0)
    assert inverse(WITH_A_HALT, 0.5) == pytest.approx(0.4, abs=1e-7)  # v = 0 there: ξ to the root of the digits


@pytest.mark.parametrize("s", [-0.01, 1.01, math.nan])
def test_a_share_outside_the_rise_is_refused(s):
    with pytest.raises(ValueError, match="expected numbers from 0 to 1"):
        inverse(Cycloidal(), s)


@pytest.mark.parametrize("law", [Dwell(), BACKWARDS])
def test_a_law_that_does_not_rise_throughout_is_refused(law):
    with pytest.raises(ValueError, match="never moves backwards"):
        inverse(law, 0.5)


def test_a_short_motion_backwards_is_seen():
    assert is_monotone(ASYMMETRIC)
    assert not is_monotone(PieceLaw([Piece(0.004, (-1.0, 0, 0, 0)), Piece(0.996, (2.0, 0, 0, 0))]))


def test_breaks_of_the_seven_stages_leave_out_those_of_no_length():
    law = ModifiedTrapezoidal((0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0))
    assert breaks(law) == pytest.approx([0.0, 0.5, 1.0])


@pytest.mark.parametrize("law", MOVING, ids=str)
def test_a_jump_through_zero_at_a_break_is_no_root_beside_it(law):
    edges = breaks(law)
    found = np.setdiff1d(velocity_extremes(law), edges)
    assert all(abs(xi - edge) > 1e-6 for xi in found for edge in edges)


@pytest.mark.parametrize("law", MOVING, ids=str)
def test_last_digits_of_a_law_make_no_extremes_and_take_none(law):
    """A zero that a only touches, as at the end of a rise without jerk, is one or none by the last digit."""
    expected, draw = velocity_extremes(law), np.random.default_rng(59)
    for _ in range(50):
        rounded = [
            replace(p, c=tuple(c * (1.0 + 4e-16 * draw.uniform(-1.0, 1.0)) for c in p.c)) for p in law.as_pieces()
        ]
        found = velocity_extremes(PieceLaw(rounded))
        assert found == pytest.approx(expected, abs=1e-6)
