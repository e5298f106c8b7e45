"""Where motions turn round inside pieces: by even points and a parabola, against each change of the velocity's sign."""

import pytest

from engine.drive.search import sign_changes
from engine.drive.turning import directions, turns_of
from engine.laws import Dwell, law
from engine.motion import Motion
from engine.motion.joining import join_phases
from engine.motion.phase import Phase
from engine.motion.pieces import motion_pieces
from tests.engine.drive.machines import STRAIGHT, drive_cycle_of
from tests.tiers import nights


def found(piece):
    """Places at which a piece turns round, as shares of it."""
    return [(turn.at - piece.begin) / piece.duration for turn in turns_of([piece], [directions(piece)])]


@pytest.mark.parametrize("number", [*range(20), *nights(40)])
def test_a_piece_turns_round_where_its_velocity_changes_its_sign(number):
    motion = drive_cycle_of(f"turning {number}").motion
    for piece in filter(lambda piece: piece.duration and any(piece.curves[1].c), motion_pieces(motion)):
        exact = [u / piece.duration for u in sign_changes(piece.curves[1], 0.0, piece.duration)]
        assert found(piece) == pytest.approx(exact, abs=1e-6)


def overshooting(lift):
    """A quintic between two straight lines that both go forward: with a lift below 0 it goes back between them."""
    line = STRAIGHT[0].examples[0]
    steps = [Phase(line, 1.0, 1.0), Phase(law("PO5"), lift, 1.0), Phase(line, 1.0, 1.0), Phase(law("PO5"), -5.0, 2.0)]
    return join_phases(steps, {}, periodic=False).motion


@pytest.mark.parametrize("lift", [-0.5, 0.1, 0.4])
def test_a_phase_may_turn_round_twice(lift):
    piece = next(piece for piece in motion_pieces(overshooting(lift)) if piece.phase == 1)
    assert found(piece) == pytest.approx([1.0 - share for share in reversed(found(piece))], abs=1e-9)
    exact = [u / piece.duration for u in sign_changes(piece.curves[1], 0.0, piece.duration)]
    assert found(piece) == pytest.approx(exact, abs=1e-6)
    assert len(exact) == 2


def test_a_motion_that_turns_round_at_rests_has_none_inside_pieces():
    motion = Motion([Phase(law("CIC"), 1.0, 1.0), Phase(Dwell(), 0.0, 1.0), Phase(law("MSN"), -1.0, 1.0)])
    pieces = motion_pieces(motion)
    assert turns_of(pieces, [directions(piece) for piece in pieces]) == []
