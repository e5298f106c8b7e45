"""A motion as one table of pieces: the same y, y', y'', y''' as by the laws' closed forms."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import Dwell, Piece, PieceLaw
from engine.laws.modified import ModifiedSine, ModifiedTrapezoidal
from engine.laws.polynomials import Polynomial4567
from engine.laws.ramps import SCurve
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, StraightLine
from engine.motion import Motion, Phase
from engine.motion.pieces import MotionPieces, ScaledLaw, motion_pieces
from tests.engine.families import ENTRIES

LAWS = [law for entry in ENTRIES for law in entry.examples] + [
    PieceLaw(
        [Piece(0.4, (3.0, 1.5, -2.0, 0.7), 1.2, 7.0, 0.4), Piece(0.0, (5.0, 0, 0, 0)), Piece(0.6, (1, 0, 0, 2.0))]
    ),
    PieceLaw([Piece(1.0, (3.0, 0.0, 0.0, 0.0), 1.2, 0.0, 0.4)]),
    ModifiedTrapezoidal((0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0)),
    DoubleHarmonic(),
    ModifiedSine(),
    Polynomial4567(),
    SCurve(),
    StraightLine(),
]


def agree(motion: Motion, x: np.ndarray) -> None:
    exact, found = motion.at(x), MotionPieces(motion_pieces(motion), motion.edges[-1]).at(x)
    sizes = [max(np.abs(y).max(), motion.size(n)) for n, y in enumerate(exact)]
    for one, other, size in zip(exact, found, sizes, strict=True):
        assert np.abs(one - other).max() <= 1e-12 * size


@st.composite
def motions(draw):
    phases = []
    for _ in range(draw(st.integers(1, 5))):
        law = draw(st.sampled_from(LAWS))
        lift = 0.0 if isinstance(law, Dwell) else draw(st.floats(-50, 50).filter(lambda h: abs(h) > 1e-3))
        phases.append(Phase(law, lift, draw(st.floats(0.2, 9.0))))
    return Motion(phases, draw(st.floats(-3, 3)), draw(st.floats(-9, 9)))


@given(motions())
def test_pieces_give_what_the_closed_forms_give(motion):
    agree(motion, np.linspace(*motion.edges[[0, -1]], 301))


@pytest.mark.parametrize("law", [Cycloidal(), ModifiedTrapezoidal(), ConstantAcceleration()], ids=lambda law: law.code)
def test_on_every_break_a_sample_has_the_later_piece_and_at_the_end_the_left_limit(law):
    motion = Motion([Phase(Dwell(), 0.0, 30.0), Phase(law, 12.0, 90.0), Phase(law, -12.0, 240.0)])
    pieces = motion_pieces(motion)
    begins = np.array([piece.begin for piece in pieces])
    last = [int(np.flatnonzero(begins == begin)[-1]) for begin in begins]
    for shift in (-1e-10, 0.0, 1e-10):
        assert MotionPieces(pieces, 360.0).located(begins + shift).piece.tolist() == last
    agree(motion, np.append(begins, 360.0))


def test_what_moves_besides_adds_its_velocity():
    one, *_ = ScaledLaw(Dwell(), 0.0, 2.0, 1.0, 5.0, 3.0).pieces()
    at = one.at(np.array([0.0, 0.5]))
    assert (at.y.tolist(), at.y1.tolist(), at.y2.tolist()) == ([5.0, 6.5], [3.0, 3.0], [0.0, 0.0])
    moving = ScaledLaw(Cycloidal(), 2.0, 4.0, 0.0, 0.0, 3.0).pieces()
    x = np.linspace(0.0, 4.0, 33)
    assert MotionPieces(moving, 4.0).at(x).y == pytest.approx(2.0 * Cycloidal().s(x / 4.0) + 3.0 * x, abs=1e-13)


def test_pieces_of_no_length_at_the_end_are_left_out():
    law = PieceLaw([Piece(0.5, (4.0, 0, 0, 0)), Piece(0.0), Piece(0.5, (-4.0, 0, 0, 0)), Piece(0.0), Piece(0.0)])
    assert [(p.number, p.begin, p.duration) for p in ScaledLaw(law, 1.0, 2.0).pieces()] == [
        (0, 0.0, 1.0), (1, 1.0, 0.0), (2, 1.0, 1.0),
    ]  # fmt: skip
