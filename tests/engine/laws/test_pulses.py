"""What is known of a pulse, against quadrature of its pieces; what is refused."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws.extremes import coefficients_of, square_integral
from engine.laws.piece import Piece, backwards, gains, reversed_pieces
from engine.laws.pulse_law import (
    CONSTANT,
    HALF_345,
    HALF_4567,
    HALF_SINE,
    LINE_DOWN,
    edged,
    polynomial_pulse,
)

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
QUARTIC = polynomial_pulse(0.0, 4.0, -4.0)
WHOLE = (CONSTANT, HALF_SINE, HALF_345, HALF_4567, LINE_DOWN, QUARTIC)


@st.composite
def shares(draw):
    parts = [draw(st.sampled_from([0.0, 1e-6, 0.3, 1.0])) + draw(st.sampled_from([0.0, 0.01, 0.2])) for _ in range(3)]
    total = sum(parts) or 1.0
    return tuple(p / total for p in parts) if sum(parts) else (1.0, 0.0, 0.0)


pulses = st.one_of(
    st.sampled_from(WHOLE),
    st.builds(lambda d: edged(*d), shares()),
    st.builds(lambda d: edged(*d, sine=False), shares()),
)


def moments(pulse):
    """∫p, ∫(1 − x)p and ∫p² over the pieces."""
    begin, found = 0.0, np.zeros(3)
    for piece in pulse.pieces:
        half = piece.duration / 2
        u = half * (NODES + 1)
        p = gains(u, np.array(piece.row)[:, None])[2]
        found += half * np.array([WEIGHTS @ p, WEIGHTS @ ((1 - begin - u) * p), WEIGHTS @ (p * p)])
        begin += piece.duration
    return found


@given(pulses)
def test_gain_and_lead_are_the_integrals(pulse):
    area, travel, square = moments(pulse)
    assert (pulse.gain, pulse.lead) == pytest.approx((area, travel / area), rel=1e-12)
    assert sum(map(square_integral, pulse.pieces)) == pytest.approx(square, rel=1e-12)


@given(pulses)
def test_a_pulse_is_of_height_1_and_nowhere_negative(pulse):
    lasting = tuple(piece for piece in pulse.pieces if piece.duration)
    found = coefficients_of(lasting)
    assert found.ca_max == pytest.approx(1.0, abs=1e-13)
    assert found.ca_min >= -1e-13


@given(pulses)
def test_the_pieces_last_one(pulse):
    assert math.fsum(piece.duration for piece in pulse.pieces) == pytest.approx(1.0, rel=1e-14)


@pytest.mark.parametrize(
    ("pulse", "gain", "lead", "square", "power"),
    [
        (CONSTANT, 1, 1 / 2, 1, 1),
        (HALF_SINE, 2 / math.pi, 1 / 2, 1 / 2, 3 * math.sqrt(3) / (4 * math.pi)),
        (edged(1, 0, 0), 2 / math.pi, 1 - 2 / math.pi, 1 / 2, 2 / math.pi),
        (edged(0, 0, 1), 2 / math.pi, 2 / math.pi, 1 / 2, 1 / math.pi),
        (edged(1 / 4, 0, 3 / 4), 2 / math.pi, (math.pi + 4) / (4 * math.pi), 1 / 2, 2.244369709691 / math.tau),
        (edged(1 / 4, 1 / 2, 1 / 4), 1 / 2 + 1 / math.pi, 1 / 2, 3 / 4, None),
        (edged(0.2, 0.6, 0.2, sine=False), 0.8, 1 / 2, 1 - 0.8 / 3, 0.7),
        (edged(0.5, 0.0, 0.5, sine=False), 0.5, 1 / 2, 1 / 3, 0.5 * (2 / 3) ** 1.5),
        (LINE_DOWN, 1 / 2, 2 / 3, 1 / 3, math.sqrt(3) / 9),
        (HALF_345, 3 * math.sqrt(3) / 8, 8 / 15, 18 / 35, 2 * 6075 / (343 * math.sqrt(7)) * 3 / 100),
        (HALF_4567, 25 * math.sqrt(5) / 96, 16 / 35, 625 / 1386, None),
        (QUARTIC, 2 / 3, 1 / 2, 8 / 15, 8 * 0.165034880891 / 3),
    ],
)
def test_known_pulses(pulse, gain, lead, square, power):
    assert (pulse.gain, pulse.lead) == pytest.approx((gain, lead), rel=1e-13)
    found = coefficients_of(pulse.pieces)
    assert found.ca_rms**2 == pytest.approx(square, rel=1e-13)
    assert power is None or found.va_max == pytest.approx(power, rel=1e-11)


@pytest.mark.parametrize("given_", [(0.5, 0.6, -0.1), (0.5, 0.4, 0.0), (0.0, math.nan, 1.0)])
@pytest.mark.parametrize("sine", [True, False])
def test_shares_of_a_pulse_that_cannot_be(sine, given_):
    with pytest.raises(ValueError, match="expected three, none negative, of sum 1"):
        edged(*given_, sine=sine)


SINES = Piece(0.7, (1.0, -2.0, 3.0, 0.5, -1.0, 2.0), 1.5, 4.0, 0.3, -0.5, 9.0, 1.0)


def test_a_piece_backwards_is_its_negative_from_the_end_and_itself_twice():
    u = np.linspace(0, 0.7, 41)
    row, back = (np.array(piece.row)[:, None] for piece in (SINES, backwards(SINES)))
    assert gains(u, back)[2] == pytest.approx(-gains(0.7 - u, row)[2], abs=1e-13)
    assert gains(u, np.array(backwards(backwards(SINES)).row)[:, None])[2] == pytest.approx(gains(u, row)[2], abs=1e-13)


def test_a_stretched_piece():
    u = np.linspace(0, 0.7, 41)
    wide = SINES.scaled(-2.0, 3.0)
    row, other = (np.array(piece.row)[:, None] for piece in (SINES, wide))
    assert wide.duration == pytest.approx(2.1)
    assert gains(3 * u, other)[2] == pytest.approx(-2 * gains(u, row)[2], abs=1e-12)
    with pytest.raises(ValueError, match="expected more than 0"):
        SINES.scaled(1.0, 0.0)


@given(pulses)
def test_a_pulse_turned_is_told_from_its_inner_end(pulse):
    """The pieces of −p(1 − x) are those of the pulse, each and all backwards."""
    back = [piece for piece in reversed_pieces(pulse.pieces) if piece.duration]
    turned = [piece for piece in pulse.mirrored if piece.duration]
    assert [piece.duration for piece in turned] == pytest.approx([piece.duration for piece in back])
    for one, other in zip(turned, back, strict=True):
        u = one.duration * np.linspace(0, 1, 21)
        p, expected = (gains(u, np.array(piece.row)[:, None])[2] for piece in (one, other))
        assert p == pytest.approx(-expected, abs=1e-12)
