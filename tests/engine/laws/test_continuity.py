"""How smooth a law is by its pieces is what its closed form is measured to be, and what it says."""

import math

import numpy as np
import pytest

from engine.laws import Piece, PieceLaw
from engine.laws.base import BREAK_TOLERANCE
from engine.laws.inverse import SMOOTH, continuity, joint_code, law_joints
from tests.engine.families import ENTRIES

LAWS = pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.code)


@LAWS
def test_a_law_is_as_smooth_as_it_claims(entry):
    claimed = entry.order_ends, entry.order_inside
    law = entry.law()
    assert continuity(law_joints(law, law.as_pieces())) == tuple(min(order, SMOOTH) for order in claimed)


@LAWS
def test_pieces_meet_where_the_closed_form_has_the_same_rates_on_either_side(entry):
    """Right of a break and left of it, each by a straight line through two places, so that no slope adds to a jump."""
    for law in entry.examples:
        at, step = 0.0, 40 * BREAK_TOLERANCE
        scales = np.array([law.coefficients.cv, *(max(1.0, law.coefficients.ca * 50),) * 2])
        for one in law_joints(law, law.as_pieces()):
            if one.duration > 4 * step and not one.outer:
                left, right = (
                    2 * np.array(law.evaluate(at + side * step)[1:]) - np.array(law.evaluate(at + 2 * side * step)[1:])
                    for side in (-1, 1)
                )
                assert np.abs(right - left - np.array(one.jump)).max() <= 1e-6 * scales.max()
            at += one.duration


CONSTANT = [Piece(0.5, (4.0, 0.0, 0.0, 0.0)), Piece(0.5, (-4.0, 0.0, 0.0, 0.0))]
LASTING = [Piece(0.5, (0.0, 1.0, 0.0, 0.0)), Piece(0.5, (0.5, -1.0, 0.0, 0.0))]
AT_SPEED = [LASTING[0], Piece(0.5, (0.5, 1.0, 0.0, 0.0))]
PIECES = {
    "constant acceleration": (CONSTANT, (1, 1)),
    "cycloidal": ([Piece(1.0, amplitude=2 * math.pi, omega=2 * math.pi)], (2, 3)),
    "it ends at speed": (AT_SPEED, (0, 3)),
    "a piece of no duration between": ([LASTING[0], Piece(0.0, (9.0, 9.0, 0.0, 0.0)), LASTING[1]], (0, 2)),
}


@pytest.mark.parametrize(("pieces", "expected"), PIECES.values(), ids=PIECES)
def test_what_jumps_least_decides(pieces, expected):
    assert continuity(law_joints(PieceLaw(tuple(pieces)), pieces)) == expected


def test_a_meeting_in_one_number():
    law = PieceLaw(tuple(CONSTANT))
    assert [joint_code(3, one) for one in law_joints(law, law.as_pieces())] == [24 + 4 + 1, 24 + 1, 24 + 4 + 1]
