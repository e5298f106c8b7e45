"""Coefficients of own laws by nine points a piece, against their exact ones: within the bounds that a sheet states."""

import math
import random

import numpy as np
import pytest

from engine.laws import Piece, PieceLaw
from engine.laws.extremes import reach_of
from engine.laws.inverse import velocity_peak
from engine.laws.pieces import POLYNOMIAL_345
from engine.laws.points import POINTS, SHARES, WEIGHTS, PointedLaw, Points, fastest, reach, slowest
from tests.engine.extremes import extremes_of

PEAKS, POWER, RMS = 1e-2, 4e-2, 1e-6
"""bounds of s, v, a and j, of v·a, and of the RMS acceleration; relative to the largest size"""
TURN = 2.0 * math.pi
"""of a sine on its piece, at most"""


def drawn(seed):
    dice = random.Random(seed)
    lengths = [dice.random() + 0.05 for _ in range(dice.randint(1, 5))]
    pieces = []
    for length in lengths:
        d, turn = length / sum(lengths), dice.choice((0.0, dice.uniform(0.1, TURN)))
        c = tuple(dice.uniform(-20, 20) / d**i for i in range(4))
        sine = (dice.uniform(-20, 20), turn / d, dice.uniform(-3, 3)) if turn else (0.0, 0.0, 0.0)
        pieces.append(Piece(d, c, *sine))
    return pieces


def test_points_and_weights_are_those_of_gauss_and_lobatto():
    assert (SHARES[0], SHARES[-1]) == (0.0, 1.0)
    for power in range(2 * POINTS - 2):
        assert float(WEIGHTS @ SHARES**power) == pytest.approx(1.0 / (power + 1), rel=1e-13)


def test_the_bounds_hold_on_random_laws():
    for seed in range(300):
        pieces = tuple(drawn(seed))
        exact, law = PieceLaw(pieces).coefficients, PointedLaw(pieces)
        found, true = law.coefficients, extremes_of(pieces, 0.0)
        assert found.cv == pytest.approx(exact.cv, rel=PEAKS)
        a = found.ca_max - max(0.0, exact.ca_max), found.ca_min - min(0.0, exact.ca_min)
        assert max(map(abs, a)) <= PEAKS * exact.ca
        assert max(map(abs, law.points.extremes("j"))) == pytest.approx(max(map(abs, true.j)), rel=PEAKS)
        power = found.va_max - max(0.0, exact.va_max), found.va_min - min(0.0, exact.va_min)
        assert max(map(abs, power)) <= POWER * exact.va
        assert found.ca_rms == pytest.approx(exact.ca_rms, rel=RMS)
        low, high = reach_of(pieces, 0.0)
        assert reach(law) == pytest.approx((low, high), abs=PEAKS * (high - low))
        assert slowest(law) == pytest.approx(true.v[0], abs=PEAKS * exact.cv)


def test_a_symmetric_law_is_exact_where_it_is_fastest():
    law = PointedLaw(POLYNOMIAL_345)
    assert fastest(law) == velocity_peak(PieceLaw(POLYNOMIAL_345)) == 0.5
    assert law.coefficients.cv == pytest.approx(1.875, rel=1e-14)
    assert law.points.wrong_way.max() < 1e-14


def test_pieces_that_do_not_last_count_for_nothing():
    gap = (Piece(0.0, (99.0, 9.0, 9.0, 9.0)), *POLYNOMIAL_345, Piece(0.0))
    assert PointedLaw(gap).coefficients == PointedLaw(POLYNOMIAL_345).coefficients


def test_a_step_the_wrong_way_is_found():
    pieces = [
        Piece(0.3, (8.0, 0, 0, 0)),
        Piece(0.2, (-4.0, 0, 0, 0)),
        Piece(0.2, (8.0, 0, 0, 0)),
        Piece(0.3, (-10, 0, 0, 0)),
    ]
    at = Points(pieces)
    assert at.peak == pytest.approx(0.7)
    assert at.wrong_way.max() > 0.1
    assert float(np.sum(at.wrong_way)) == pytest.approx(0.8)
