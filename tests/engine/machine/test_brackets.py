"""Where a figure changes its sign, in four places: of sines also beside their tops, and where it is 0 already."""

import math
import random

import pytest

from engine.machine.brackets import Bracket, Point


def found(function, low, high, lost=1e-9):
    """The last of four places, as the cells find them."""
    bracket = Bracket(low, high, function(low), function(high), lost)
    one = Point(bracket.first, function(bracket.first))
    u = bracket.step(bracket.begin, bracket.end, one, bracket.rise).place
    two = Point(u, function(u))
    u = bracket.step(bracket.begin, one, two, bracket.rise).place
    return bracket.step(one, two, Point(u, function(u)), bracket.rise).place


@pytest.mark.parametrize("number", range(50))
def test_a_part_of_a_sine_to_a_hundred_millionth_wherever_its_top_lies(number):
    """A sixth of a rise and return at most; that of the inverse parabola and two chords was up to 6 % off."""
    drawn = random.Random(f"bracket {number}")
    turns, phase, share = drawn.uniform(0.05, 0.8), drawn.uniform(0, 2 * math.pi), drawn.random()
    level = math.sin(turns * share + phase)

    def function(u):
        return math.sin(turns * u + phase) - level

    if function(0.0) * function(1.0) < 0.0:
        assert function(found(function, 0.0, 1.0)) == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("share", [1e-6, 0.3, 0.9999])
def test_a_parabola_in_one_step(way, share):
    def function(u):
        return way * ((1.0 - share) ** 2 - (1.0 - u) ** 2)

    bracket = Bracket(0.0, 1.0, function(0.0), function(1.0), 1e-9)
    one = Point(bracket.first, function(bracket.first))
    assert bracket.step(bracket.begin, bracket.end, one, bracket.rise).place == pytest.approx(share, abs=1e-9)
    assert found(function, 0.0, 1.0) == pytest.approx(share, abs=1e-9)


def test_no_step_is_taken_from_where_it_is_0_nor_in_a_spare_row():
    bracket = Bracket(0.0, 1.0, -1.0, 1e-20, 1e-9)
    last = Point(1.0 - 1e-16, -1e-16)
    assert bracket.step(bracket.begin, bracket.end, last, 1).place == last.u
    level = Bracket(0.0, 1.0, 0.0, 0.0, 1e-9)
    assert level.step(level.begin, level.end, level.begin, 0).place == 0.0
