"""What sheets show of a law beside its figures: the table of its pieces, its rise in its own units, its samples."""

import math

import numpy as np
import pytest

from engine.laws import Piece
from engine.laws.piece import located, placed_pieces
from engine.laws.points import piece_ends
from engine.laws.pulse_law import LINE_DOWN, PulseLaw
from tests.engine.families import ENTRIES

EXAMPLES = [law for entry in ENTRIES for law in entry.examples]
LAWS = pytest.mark.parametrize("law", EXAMPLES, ids=str)


@LAWS
def test_the_table_of_pieces_evaluates_the_law_by_one_formula_each(law):
    rows = placed_pieces(law.as_pieces(), law.entry_velocity)
    xi = np.linspace(0, 1, 401)
    place = located(law.as_pieces(), xi)
    for x, k, u, angle, angle2 in zip(xi, *place, strict=True):
        row = rows[k]
        c = row.piece.row[:6]
        ((ps, pv, _), (ps2, pv2, _)), (s0, s1) = row.amplitudes, row.constants
        s = s0 + s1 * u - ps * math.sin(angle) - ps2 * math.sin(angle2)
        v = s1 - pv * math.cos(angle) - pv2 * math.cos(angle2)
        s += sum(c[i] * u ** (i + 2) / ((i + 1) * (i + 2)) for i in range(6))
        v += sum(c[i] * u ** (i + 1) / (i + 1) for i in range(6))
        at = law.evaluate(float(x))
        assert (s, v) == pytest.approx((at.s, at.v), abs=1e-13)


def test_a_sample_near_a_break_is_on_it_and_the_last_in_the_last_piece_that_lasts():
    pieces = [Piece(0.25), Piece(0.0), Piece(0.75, omega=4.0, amplitude=1.0, phase=0.5), Piece(0.0)]
    place = located(pieces, np.array([0.0, 0.25 - 1e-9, 0.25 - 1e-8, 0.5, 1.0]))
    assert place.piece.tolist() == [0, 2, 0, 2, 2]
    assert place.u[3:] == pytest.approx([0.25, 0.75])
    assert place.angle[3:] == pytest.approx([1.5, 3.5])


def test_accelerations_at_the_ends_of_pieces_pass_over_those_of_no_duration():
    pieces = [Piece(0.5, (1.0, 2.0, 0.0, 0.0)), Piece(0.0, (9.0, 0, 0, 0)), Piece(0.5, (0.5, 0.0, 0.0, 4.0))]
    assert [tuple(one) for one in piece_ends(pieces)] == [
        (1.0, 2.0, 2.0, 1.0),
        (9.0, 9.0, 2.0, 0.0),
        (0.5, 1.0, 1.0, 1.5),
    ]
    sine = piece_ends([Piece(1.0, (1.0, 0, 0, 0), 2.0, math.pi, math.pi / 6)])[0]
    assert (sine.begin, sine.end) == pytest.approx((2.0, 0.0))


EDGED = [law for law in EXAMPLES if isinstance(law, PulseLaw)]


@pytest.mark.parametrize("law", EDGED, ids=str)
def test_the_power_of_a_pulse_is_greatest_where_its_inner_edge_says(law):
    c = law.pulses
    sides = zip(law.inner_edges, (c.rise, c.fall), (law.acceleration, law.deceleration), strict=True)
    powers = law.coefficients.va_max, -law.coefficients.va_min
    x = np.linspace(0.0, 1.0, 10_001)
    for (edge, pulse, height), greatest in zip(sides, powers, strict=True):
        if len(pulse.pieces) == 1 and pulse is not LINE_DOWN:  # it has no such edge
            continue
        a, v = (np.sqrt(1.0 - x * x), x) if edge.sine else (x, 1.0 - x * x)
        power = height * a * (edge.velocity + edge.gain * v)
        assert edge.velocity + edge.gain == pytest.approx(law.top, rel=1e-12)
        assert power.max() == pytest.approx(greatest, rel=1e-7)
        if edge.gain:
            assert x[power.argmax()] == pytest.approx(edge.at, abs=2e-4)
