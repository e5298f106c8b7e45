"""The engineer's own law: other laws entered piece by piece, mixed pieces against quadrature and samples."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws import Piece, PieceLaw
from engine.laws.base import BREAK_TOLERANCE
from engine.laws.piece import gains

XI = np.linspace(0, 1, 1001)
HAIR = 2 * BREAK_TOLERANCE
TURN = 2 * math.pi
number = st.floats(-10, 10)


@st.composite
def own_laws(draw):
    """Laws of one to four pieces, polynomial, sine or both; zero pieces too."""
    shares = draw(st.lists(st.sampled_from([0.0, 0.2, 0.5, 1.0]), min_size=1, max_size=4).filter(any))
    kinds = [draw(st.sampled_from(["polynomial", "sine", "both"])) for _ in shares]
    made = []
    for share, kind in zip(shares, kinds, strict=True):
        c = tuple(draw(number) for _ in range(4)) if kind != "sine" else (0.0,) * 4
        p, w, phi = (draw(number), draw(st.floats(-25, 25)), draw(number)) if kind != "polynomial" else (0,) * 3
        made.append(Piece(share / sum(shares), c, p, w, phi))
    return PieceLaw(made)


def samples_by_piece(law, n=4001):
    """ξ within the pieces, the ends left out by a hair, and the weights of a trapezoidal rule."""
    begin, xi, weights = 0.0, [], []
    for piece in law.pieces:
        end = min(begin + piece.duration, 1.0)
        if piece.duration > 0:
            xi.append(np.linspace(begin + HAIR, end - HAIR, n))
            weights.append(np.full(n, piece.duration / (n - 1)))
            weights[-1][[0, -1]] /= 2
        begin = end
    return np.concatenate(xi), np.concatenate(weights)


@given(own_laws())
def test_coefficients_are_what_samples_show(law):
    k = law.coefficients
    xi, weights = samples_by_piece(law)
    at = law.evaluate(xi)
    power = at.v * at.a
    scale = 1e-3 + np.abs(at.a).max()
    assert np.abs(at.v).max() == pytest.approx(k.cv, abs=1e-4 * scale)
    assert (at.a.max(), at.a.min()) == pytest.approx((k.ca_max, k.ca_min), abs=1e-4 * scale)
    assert math.sqrt(weights @ at.a**2) == pytest.approx(k.ca_rms, abs=1e-4 * scale)
    room = 1e-4 * (1e-3 + np.abs(power).max() + scale * scale)
    assert (power.max(), power.min()) == pytest.approx((k.va_max, k.va_min), abs=room)
    hair = 1e-9 * (1 + scale)
    assert k.cv >= np.abs(at.v).max() - hair
    assert k.ca_max >= at.a.max() - hair * 30
    assert k.va_max >= power.max() - hair * 30 * scale


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
