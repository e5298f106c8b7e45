"""Figures of S2, 'Timing Diagram (Part 3 – Cycloid Cam Profile Analysis)': indexing mill and die.

Those printed stand in ``figures.py``, with the digits that the formulas give; figures here are the formulas' too.
"""

from math import degrees, radians

import pytest

from engine.laws.simple import Cycloidal
from engine.overlap.plan import Station
from engine.overlap.schedule import Passage, Schedule, Tool, Transfer

RATE = 2000 / 3600  # pieces a second
MILL = Transfer(Cycloidal(), stroke=0.1, angle=radians(150))
DIE = Tool(Cycloidal(), stroke=0.05, dwell=radians(100))
PASSAGE = Passage(remaining=Cycloidal().s(0.1), clearance=0.02, margin=0.001)
STATION = Station(MILL, DIE, PASSAGE)


def rounded(schedule, angle):
    """The document goes on with whole degrees."""
    return Schedule(DIE, radians(angle), radians(angle), schedule.arrival)


def test_effective_angle_of_the_mill_is_120_degrees_and_70_remain_each_way():
    begin, end, *_ = STATION.left
    assert (degrees(begin), degrees(end)) == pytest.approx((15, 135), abs=1e-10)
    held = Station(MILL, DIE, Passage(PASSAGE.remaining, clearance=0.001, margin=0.001)).overlapping()
    assert (degrees(held.angle_in), degrees(held.angle_out)) == pytest.approx((70, 70), abs=1e-10)
    assert degrees(held.edges[0]) == pytest.approx(135, abs=1e-10)
    assert degrees(held.arrival) == pytest.approx(205, abs=1e-10)


def test_new_angle_is_125_degrees_and_120_with_the_allowance():
    after = STATION.overlapping()
    assert degrees(after.angle_in) == pytest.approx(124.8369, abs=5e-5)
    assert after.angle_out == pytest.approx(after.angle_in, rel=1e-12)
    assert after.limit == "clearance"
    set_off = Station(MILL, DIE, Passage(PASSAGE.remaining, 0.02, 0.001, allowance=radians(5))).overlapping()
    assert degrees(after.angle_in - set_off.angle_in) == pytest.approx(5, abs=1e-12)
    assert degrees(set_off.angle_in) == pytest.approx(120, abs=0.5)
    assert set_off.arrival == after.arrival


def test_the_document_s_rounding_up_to_125_degrees_costs_some_of_the_margin():
    after = rounded(STATION.overlapping(), 125)
    found = STATION.clearance(after, 0.0)
    assert found.minimum == pytest.approx(0.02 - 0.05 * Cycloidal().s(1 - 70 / 125), abs=1e-12)
    assert 0.0 < found.minimum < 0.001
    assert not found.meets_margin
    assert not found.collides
