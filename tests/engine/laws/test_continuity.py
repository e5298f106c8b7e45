"""How smooth a law is by its pieces is what its closed form is measured to be, and what it says."""

import math

import pytest

from engine.laws import Piece, PieceLaw
from engine.laws.inverse import SMOOTH, continuity, joint_code, law_joints
from tests.engine.families import ENTRIES

LAWS = pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.code)


@LAWS
def test_a_law_is_as_smooth_as_it_claims(entry):
    law = entry.law()
    assert continuity(law_joints(law, law.as_pieces())) == tuple(min(order, SMOOTH) for order in entry.orders)


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
