"""What sheets show of a law beside its figures: the table of its pieces, its rise in its own units, its samples."""

import math

import numpy as np
import pytest

from engine.laws import CATALOGUE, ModifiedTrapezoidal, Piece, PieceLaw
from engine.laws.piece import gains
from engine.laws.piece_integrals import ends, squares
from engine.laws.rise import Rise
from engine.laws.sampled import SampledPieceLaw, abscissae
from engine.laws.table import begins, carried, key, located

EXAMPLES = [law for entry in CATALOGUE for law in entry.examples]
LAWS = pytest.mark.parametrize("law", EXAMPLES, ids=str)
MIXED = EXAMPLES[-1].pieces


@LAWS
def test_the_table_of_pieces_evaluates_the_law_by_one_formula_each(law):
    rows = carried(law, law.as_pieces())
    xi = np.linspace(0, 1, 401)
    place = located(law.as_pieces(), xi)
    for x, k, u, angle in zip(xi, *place, strict=True):
        row = rows[k]
        c0, c1, c2, c3 = row.piece.c
        s = (
            row.position_constant + row.position_slope * u
            + u**2 * (c0 / 2 + u * (c1 / 6 + u * (c2 / 12 + u * c3 / 20))) - row.position_sine * math.sin(angle)
        )  # fmt: skip
        v = (
            row.position_slope
            + u * (c0 + u * (c1 / 2 + u * (c2 / 3 + u * c3 / 4)))
            - row.velocity_cosine * math.cos(angle)
        )
        at = law.evaluate(float(x))
        assert (s, v) == pytest.approx((at.s, at.v), abs=1e-13)


@LAWS
def test_what_a_piece_gains_is_the_integral_of_its_acceleration(law):
    for row in carried(law, law.as_pieces()):
        d = row.piece.duration
        s, v, _, _ = (float(x[0]) for x in gains(np.array([d]), np.array(row.piece.row)[:, None]))
        assert (row.ds, row.dv) == pytest.approx((row.v * d + s, v), abs=1e-14)


def test_a_sample_near_a_break_is_on_it_and_the_last_in_the_last_piece_that_lasts():
    pieces = [Piece(0.25), Piece(0.0), Piece(0.75, omega=4.0, amplitude=1.0, phase=0.5), Piece(0.0)]
    place = located(pieces, np.array([0.0, 0.25 - 1e-9, 0.25 - 1e-8, 0.5, 1.0]))
    assert place.piece.tolist() == [0, 2, 0, 2, 2]
    assert place.u[3:] == pytest.approx([0.25, 0.75])
    assert place.angle[3:] == pytest.approx([1.5, 3.5])


def test_keys_of_all_laws_rise_in_one_order():
    keys = [key(number, xi) for number in (1, 2, 3) for xi in begins([Piece(0.5), Piece(0.5), Piece(0.0)])]
    assert keys == [2.0, 2.5, 3.0, 4.0, 4.5, 5.0, 6.0, 6.5, 7.0]


@LAWS
def test_a_rise_in_its_own_units(law):
    rise, k = Rise(law, -0.3, 0.2), law.coefficients
    xi = np.linspace(0, 1, 7)
    y, v, a = rise.at(xi)
    at = law.evaluate(xi)
    assert y == pytest.approx(-0.3 * at.s)
    assert v == pytest.approx(-1.5 * at.v)
    assert a == pytest.approx(-7.5 * at.a)
    assert (rise.velocity, rise.acceleration) == pytest.approx((1.5 * k.cv, 7.5 * max(k.ca_max, -k.ca_min)))
    assert rise.acceleration_rms == pytest.approx(7.5 * k.ca_rms)


def test_an_own_law_has_the_coefficients_of_its_samples_and_the_exact_rms():
    own, exact = SampledPieceLaw(MIXED, 7), PieceLaw(MIXED).coefficients
    at = own.evaluate(abscissae(7))
    assert abscissae(7)[3] == 3 / 7
    assert own.coefficients.cv == np.abs(at.v).max() < exact.cv
    assert (own.coefficients.ca_max, own.coefficients.ca_min) == (at.a.max(), at.a.min())
    assert own.powers == pytest.approx(at.v * at.a)
    assert (own.coefficients.va_max, own.coefficients.va_min) == (own.powers.max(), own.powers.min())
    assert (own.coefficients.ca_rms, own.coefficients.cj) == (exact.ca_rms, math.inf)


def test_a_smooth_own_law_has_the_jerk_of_its_samples():
    own = SampledPieceLaw([Piece(1.0, (0.0, 60.0, -180.0, 120.0))], 3)
    assert own.coefficients.cj == pytest.approx(60.0)
    assert own.coefficients.ca_max == pytest.approx(own.a(1 / 3))


@pytest.mark.parametrize("piece", [*MIXED, Piece(0.8, (1.0, -2.0, 3.0, -4.0), 5.0, 300.0, 0.7)], ids=str)
def test_the_parts_of_the_square_of_a_piece_against_fine_samples(piece):
    u = (np.arange(200_000) + 0.5) / 200_000 * piece.duration
    p = np.polyval(piece.c[::-1], u)
    q = piece.amplitude * np.sin(piece.omega * u + piece.phase)
    wanted = [np.mean(one) * piece.duration for one in (p * p, 2 * p * q, q * q)]
    assert squares(piece) == pytest.approx(wanted, rel=1e-7, abs=1e-8)


def test_the_parts_of_the_squares_of_all_pieces_make_the_rms():
    total = sum(sum(squares(piece)) for piece in MIXED)
    assert math.sqrt(total) == pytest.approx(PieceLaw(MIXED).coefficients.ca_rms, rel=1e-13)


def test_accelerations_at_the_ends_of_pieces_pass_over_those_of_no_duration():
    pieces = [Piece(0.5, (1.0, 2.0, 0.0, 0.0)), Piece(0.0, (9.0, 0, 0, 0)), Piece(0.5, (0.5, 0.0, 0.0, 4.0))]
    assert [tuple(one) for one in ends(pieces)] == [(1.0, 2.0, 2.0, 1.0), (9.0, 9.0, 2.0, 0.0), (0.5, 1.0, 1.0, 1.5)]
    sine = ends([Piece(1.0, (1.0, 0, 0, 0), 2.0, math.pi, math.pi / 6)])[0]
    assert (sine.begin, sine.end) == pytest.approx((2.0, 0.0))


@pytest.mark.parametrize("law", [law for law in EXAMPLES if isinstance(law, ModifiedTrapezoidal)], ids=str)
def test_the_power_of_seven_stages_is_greatest_where_its_quarter_sine_says(law):
    drive, brake = law.quarters
    d = law.durations
    assert drive.velocity == pytest.approx(law.v(d[0] + d[1]), abs=1e-12)
    assert brake.velocity == pytest.approx(law.v(1.0 - d[5] - d[6]), abs=1e-12)
    assert (drive.velocity + drive.gain, brake.velocity + brake.gain) == pytest.approx([law.coefficients.cv] * 2)
    for quarter, height, greatest in (
        (drive, law.acceleration, law.coefficients.va_max), (brake, law.deceleration, -law.coefficients.va_min),
    ):  # fmt: skip
        x = np.linspace(0.0, math.pi / 2, 10_001)
        power = height * np.cos(x) * (quarter.velocity + quarter.gain * np.sin(x))
        assert power.max() == pytest.approx(greatest, rel=1e-7)
        assert np.sin(x[power.argmax()]) == pytest.approx(quarter.sin if quarter.gain else 0.0, abs=2e-4)
