"""Extremes refined from points on the pieces of a law, against the ladder of derivatives that misses none."""

import random

import numpy as np
import pytest

from engine.laws import Piece, PieceLaw
from engine.laws.piece_extremes import extremes_of, reach_of
from engine.laws.pieces import MIXED, POLYNOMIAL_345
from engine.laws.points import CHAINS, Spread, extreme
from engine.laws.table import carried

GAP = (Piece(0.0, (9.0, 0.0, 0.0, 0.0)), *POLYNOMIAL_345, Piece(0.0))


def spread(pieces, points=121):
    return Spread(tuple(pieces), tuple((row.s, row.v) for row in carried(PieceLaw(pieces), pieces)), points)


def drawn(seed):
    dice = random.Random(seed)
    lengths = [dice.random() + 0.05 for _ in range(dice.randint(1, 4))]
    return [
        Piece(length / sum(lengths), tuple(dice.uniform(-20, 20) for _ in range(4)), dice.uniform(-5, 5) * turns,
              dice.uniform(0.5, 20) * turns, dice.uniform(-3, 3) * turns)
        for length in lengths for turns in (dice.randint(0, 1),)
    ]  # fmt: skip


def backing(seed):
    """A law that begins against its way, or goes beyond its end: it turns between a rest and the next point."""
    dice = random.Random(seed)
    back, length = 10.0 ** dice.uniform(-0.9, 0.5), dice.uniform(0.3, 0.7)
    first = Piece(length, (-back, dice.uniform(200, 400), 0.0, 0.0))
    last = Piece(1.0 - length, (-dice.uniform(50, 90), dice.uniform(100, 300), 0.0, 0.0))
    pieces = [first, last]
    if seed % 2:
        return pieces
    at_end = first.c[0] + first.c[1] * length
    return [Piece(1.0 - length, (-at_end, 0.0, 0.0, 0.0)), Piece(length, (at_end, -first.c[1], 0.0, 0.0))]


def steepest(tops):
    return max(abs(top.value) for top in tops)


def found(at):
    a, power = at.tops("a"), at.tops("va")
    return (
        steepest(at.tops("v")), extreme(a, 1).value, extreme(a, -1).value, steepest(at.tops("j")),
        extreme(power, 1).value, extreme(power, -1).value, extreme(at.tops("s"), -1).value,
        extreme(at.tops("s"), 1).value,
    )  # fmt: skip


@pytest.mark.parametrize("pieces", [POLYNOMIAL_345, MIXED, GAP, *map(drawn, range(60)), *map(backing, range(40))])
def test_the_refined_extremes_are_those_of_the_ladder(pieces):
    at, k = spread(pieces), PieceLaw(pieces).coefficients
    jerk = max(map(abs, extremes_of(pieces, 0.0).j))
    assert at.suffices
    known = k.cv, k.ca_max, k.ca_min, jerk, k.va_max, k.va_min, *reach_of(pieces, 0.0)
    assert found(at) == pytest.approx(known, rel=1e-11, abs=1e-12)


@pytest.mark.parametrize("what", ["s", "v", "a", "j", "va"])
def test_an_extreme_between_two_points_is_estimated_beyond_both(what):
    """Else one just before a piece's end loses to the points at that end, which are no brackets."""
    beyond = []
    for seed in range(120):
        at = spread(drawn(seed))
        value, slope = (getattr(at.rates, name) for name in CHAINS[what][:2])
        rows = np.flatnonzero(at.crosses(what))
        side = np.where(np.abs(slope[rows - 1]) > 1e-9, np.sign(slope[rows - 1]), -np.sign(slope[rows]))
        beyond += [*(side * (at.estimates(what)[rows] - np.maximum(side * value[rows - 1], side * value[rows]) * side))]
    assert len(beyond) > 20
    assert min(beyond) > 0.0


def test_points_lie_on_the_pieces_that_last_at_equal_steps():
    at = spread(MIXED, 61)
    assert (at.used, at.each, at.counted) == (3, 20, [1, 1, 2, 3])
    assert {*at.piece.tolist()} == {0, 2, 3}
    for piece in (0, 2, 3):
        u = at.u[at.piece == piece]
        assert np.diff(u)[:18] == pytest.approx([MIXED[piece].duration / 19] * 18)
        assert (u[0], u[-1]) == (0.0, MIXED[piece].duration)
    assert at.rates.v == pytest.approx(PieceLaw(MIXED).v(np.minimum(at.xi, 1.0)), abs=1e-12)


@pytest.mark.parametrize(("omega", "points", "enough"), [(20.0, 121, True), (40.0, 121, False), (1.0, 4, False)])
def test_too_few_points_for_a_sine_are_told(omega, points, enough):
    assert spread([Piece(1.0, amplitude=1.0, omega=omega)], points).suffices == enough


def test_steps_the_wrong_way_are_none_of_a_law_that_speeds_up_once():
    assert spread(POLYNOMIAL_345).wrong_way(0.5).max() < 1e-15
    twice = [Piece(0.25, (8.0, 0, 0, 0)), Piece(0.25, (-8.0, 0, 0, 0)), Piece(0.25, (8.0, 0, 0, 0)),
             Piece(0.25, (-8.0, 0, 0, 0))]  # fmt: skip
    assert spread(twice).wrong_way(0.25).max() == pytest.approx(2.0 / 29, rel=1e-9)
