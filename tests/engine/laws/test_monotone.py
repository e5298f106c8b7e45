"""The pieces that a workbook lists: the law itself, cut so that the acceleration is monotone on each."""

import itertools

import numpy as np
import pytest

from engine.laws import PieceLaw
from engine.laws.ends import BoundaryValues
from engine.laws.extremes import acceleration, zeros
from engine.laws.polynomials import BoundaryPolynomial
from engine.laws.pulse_law import PulseLaw
from engine.motion.handover import PULSES, end_mode
from tests.engine.families import ENTRIES

LAWS = [law for entry in ENTRIES for law in (*entry.examples, *entry.others, *entry.beyond)]
REGISTERED = [law for law in LAWS if not isinstance(law, PieceLaw | BoundaryPolynomial)]
EDGE = 1e-7
"""of a piece: a peak so near to its end lies at it"""


@pytest.mark.parametrize("law", LAWS, ids=repr)
def test_the_monotone_pieces_are_the_law(law):
    whole, cut = PieceLaw(law.as_pieces()), PieceLaw(law.monotone_pieces())
    xi = np.linspace(0.0, 1.0, 401)
    for one, other in zip(whole.evaluate(xi), cut.evaluate(xi), strict=True):
        np.testing.assert_allclose(other, one, atol=1e-9 * max(1.0, float(np.abs(one).max())))


@pytest.mark.parametrize("law", REGISTERED, ids=repr)
def test_the_acceleration_turns_at_no_place_within_a_piece(law):
    for piece in law.monotone_pieces():
        d = piece.duration
        turns = zeros(acceleration(piece).slope, d) if d > 0.0 else []
        assert not [u for u in turns if EDGE * d < u < (1.0 - EDGE) * d]


@pytest.mark.parametrize(
    "law", [law for law in REGISTERED if isinstance(law, PulseLaw) and end_mode(law) == PULSES], ids=repr
)
def test_between_prescribed_ends_two_pulses_have_the_same_pieces(law):
    rest = law.monotone_pieces()
    ended = law.between(BoundaryValues(v0=0.4, v1=-0.2)).monotone_pieces()
    assert [piece.duration for piece in ended] == pytest.approx([piece.duration for piece in rest], abs=1e-15)
    begins = [*itertools.accumulate((piece.duration for piece in rest), initial=0.0)]
    turning = law.pulses.rise_time
    assert begins[law.early] == pytest.approx(turning, abs=1e-12)
