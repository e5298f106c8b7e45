"""An own law that misses its rise or rest, normalized by scaling its entries."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import Piece, PieceLaw
from engine.laws.modified import ModifiedSine, ModifiedTrapezoidal
from engine.laws.pieces import POLYNOMIAL_345, Misses, misses, normalized
from engine.laws.ramps import SCurve
from engine.laws.simple import Cycloidal

factor = st.floats(0.2, 5.0)
WHOLE = pytest.mark.parametrize("law", [ModifiedTrapezoidal(), ModifiedSine(0.3), SCurve(), Cycloidal(0.6)])


def times(piece, k):
    return Piece(piece.duration, tuple(k * c for c in piece.c), k * piece.amplitude, piece.omega, piece.phase)


@WHOLE
@given(up=factor, down=factor)
def test_a_law_whose_pulses_were_entered_too_high_or_too_low_is_itself_again(law, up, down):
    entered = [times(piece, down if k >= len(law.as_pieces()) // 2 else up) for k, piece in enumerate(law.as_pieces())]
    found = normalized(entered)
    for one, expected in zip(found, law.as_pieces(), strict=True):
        assert (*one.c, one.amplitude) == pytest.approx((*expected.c, expected.amplitude), rel=1e-9, abs=1e-12)
    end = PieceLaw(found).end
    assert (end.s, end.v) == pytest.approx((1.0, 0.0), abs=1e-12)


@given(factor)
def test_one_piece_at_rest_is_scaled_as_a_whole(k):
    entered = [times(POLYNOMIAL_345[0], k)]
    assert misses(entered) == Misses(pytest.approx(k - 1, abs=1e-13), pytest.approx(0.0, abs=1e-13))
    assert normalized(entered)[0].c == pytest.approx(POLYNOMIAL_345[0].c, rel=1e-12)


def test_what_a_law_misses():
    assert misses([Piece(0.5, (4.0, 0, 0, 0)), Piece(0.5, (-3.0, 0, 0, 0))]) == Misses(
        pytest.approx(0.125), pytest.approx(0.5)
    )


def test_a_sine_that_gains_nothing_keeps_its_place():
    pieces = [Piece(0.3, (4.0, 0, 0, 0)), Piece(0.4, amplitude=1.0, omega=5 * math.pi), Piece(0.3, (-3.0, 0, 0, 0))]
    end = PieceLaw(normalized(pieces)).end
    assert (end.s, end.v) == pytest.approx((1.0, 0.0), abs=1e-13)


@pytest.mark.parametrize(
    "pieces",
    [
        [Piece(1.0, (1.0, 0, 0, 0))],
        [Piece(1.0)],
        [Piece(0.5, (-4.0, 0, 0, 0)), Piece(0.5, (4.0, 0, 0, 0))],
        [Piece(1.0, (0.0, -60.0, 180.0, -120.0))],
        [Piece(0.5, (1e-8, 0, 0, 0)), Piece(0.5, (-4.0, 0, 0, 0))],
        [Piece(0.5, amplitude=1.0, omega=4.0 * math.pi), Piece(0.5, (-2.0, 0, 0, 0))],
    ],
    ids=["only speeds up", "stands", "falls", "falls in one piece", "gains next to nothing", "slows down from rest"],
)
def test_a_law_that_no_scale_mends(pieces):
    with pytest.raises(ValueError, match="expected it to speed up, then slow down"):
        normalized(pieces)
