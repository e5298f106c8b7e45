"""The engineer's own law: other laws entered piece by piece, mixed pieces against quadrature and samples."""

import math

import numpy as np
import pytest

from engine.laws import Piece, PieceLaw
from engine.laws.piece import gains

TURN = 2 * math.pi


@pytest.mark.parametrize("omega", [0.0, 1e-12, 1e-6, 1e-3, 0.3, 0.999, 1.0, 1.001, 4.0, 40.0])
@pytest.mark.parametrize("phase", [0.0, 0.7, math.pi / 2, -2.0])
def test_integrals_of_a_sine_are_right_from_no_turn_to_many(omega, phase):
    """Against Gauss-Legendre: v = ∫a dt, s = ∫(u − t)a dt."""
    nodes, weights = np.polynomial.legendre.leggauss(64)
    for u in (1e-3, 0.4, 1.0):
        t = u * (nodes + 1) / 2
        a = np.sin(omega * t + phase)
        row = np.array(Piece(u, amplitude=1.0, omega=omega, phase=phase).row)[:, None]
        s, v, _, _ = gains(np.array([u]), row)
        assert v[0] == pytest.approx(u / 2 * weights @ a, rel=1e-12, abs=1e-15)
        assert s[0] == pytest.approx(u / 2 * weights @ (a * (u - t)), rel=1e-12, abs=1e-15)


def test_extremes_of_a_mixed_piece_are_refined():
    """a = 6 − 12u + sin(20u): stationary where cos 20u = 0.6."""
    law = PieceLaw([Piece(1.0, (6, -12, 0, 0), amplitude=1.0, omega=20.0)])
    u = math.acos(0.6) / 20
    assert law.coefficients.ca_max == pytest.approx(6 - 12 * u + math.sin(20 * u), rel=1e-14)


@pytest.mark.parametrize(
    ("pieces", "infinite"),
    [
        ([Piece(1.0, amplitude=TURN, omega=TURN)], False),
        ([Piece(1.0, amplitude=TURN, omega=TURN, phase=0.1)], True),
        ([Piece(0.5, (0, 8, 0, 0)), Piece(0.5, (4, -8, 0, 0))], False),
        ([Piece(0.5, (0, 8, 0, 0)), Piece(0.0, (99, 0, 0, 0)), Piece(0.5, (4, -8, 0, 0))], False),
        ([Piece(0.5, (0, 8, 0, 0)), Piece(0.5, (4.001, -8.002, 0, 0))], True),
        ([Piece(1.0, (0, 1, 0, 0))], True),
    ],
    ids=["smooth", "at the begin", "kink only", "zero piece is no jump", "at the joint", "at the end"],
)
def test_jerk_is_infinite_where_the_acceleration_jumps(pieces, infinite):
    assert math.isinf(PieceLaw(pieces).coefficients.cj) == infinite
