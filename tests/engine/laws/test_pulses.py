"""What is known of a pulse, against quadrature of its pieces; what is refused."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws.extremes import square_integral
from engine.laws.piece import gains
from engine.laws.pulse_law import CONSTANT, HALF_345, HALF_4567, HALF_SINE, LINE_DOWN, edged, polynomial_pulse

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


@pytest.mark.parametrize("given_", [(0.5, 0.6, -0.1), (0.5, 0.4, 0.0), (0.0, math.nan, 1.0)])
@pytest.mark.parametrize("sine", [True, False])
def test_shares_of_a_pulse_that_cannot_be(sine, given_):
    with pytest.raises(ValueError, match="expected three, none negative, of sum 1"):
        edged(*given_, sine=sine)
