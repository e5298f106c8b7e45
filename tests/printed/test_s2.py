"""Figures of S2, 'Timing Diagram (Part 3 – Cycloid Cam Profile Analysis)': indexing mill and die.

Figures here were computed from the formulas, not by the engine; those printed stand in ``figures.py``.
"""

from math import degrees, radians

import numpy as np
import pytest

from engine.laws.inverse import inverse
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
    return Schedule(MILL, DIE, radians(angle), radians(angle), schedule.arrival)


def test_a_tenth_of_the_time_moves_065_percent():
    assert Cycloidal().s(0.1) == pytest.approx(0.00645107, abs=5e-9)
    assert inverse(Cycloidal(), PASSAGE.remaining) == pytest.approx(0.1, abs=1e-12)


def test_without_overlap_55_degrees_and_4154_metres_per_second_squared():
    before = STATION.one_after_the_other()
    assert degrees(before.angle_in) == pytest.approx(55, abs=1e-12)
    assert before.peak_acceleration(RATE) == pytest.approx(4.154172, abs=5e-7)


def test_effective_angle_of_the_mill_is_120_degrees_and_70_remain_each_way():
    begin, end, *_ = STATION.left
    assert (degrees(begin), degrees(end)) == pytest.approx((15, 135), abs=1e-10)
    held = Station(MILL, DIE, Passage(PASSAGE.remaining, clearance=0.001, margin=0.001)).overlapping()
    assert (degrees(held.angle_in), degrees(held.angle_out)) == pytest.approx((70, 70), abs=1e-10)
    assert degrees(held.edges[0]) == pytest.approx(135, abs=1e-10)
    assert degrees(held.arrival) == pytest.approx(205, abs=1e-10)


def test_38_percent_are_reached_at_44_percent_of_the_time():
    assert inverse(Cycloidal(), 0.38) == pytest.approx(0.4392684, abs=5e-8)


def test_new_angle_is_125_degrees_and_120_with_the_allowance():
    after = STATION.overlapping()
    assert degrees(after.angle_in) == pytest.approx(124.8369, abs=5e-5)
    assert after.angle_out == pytest.approx(after.angle_in, rel=1e-12)
    assert after.limit == "clearance"
    set_off = Station(MILL, DIE, Passage(PASSAGE.remaining, 0.02, 0.001, allowance=radians(5))).overlapping()
    assert degrees(after.angle_in - set_off.angle_in) == pytest.approx(5, abs=1e-12)
    assert degrees(set_off.angle_in) == pytest.approx(120, abs=0.5)
    assert set_off.arrival == after.arrival


def test_time_of_the_movement_and_peak_acceleration_at_125_degrees():
    after = rounded(STATION.overlapping(), 125)
    assert after.peak_acceleration(RATE) == pytest.approx(0.804248, abs=5e-7)


def test_the_acceleration_falls_5_17_times():
    before = STATION.one_after_the_other().peak_acceleration(RATE)
    after = rounded(STATION.overlapping(), 125).peak_acceleration(RATE)
    assert before / after == pytest.approx(5.1653, abs=5e-5)


def test_the_margin_of_one_millimetre_is_what_stays_free():
    after = STATION.overlapping()
    found = STATION.clearance(after, np.linspace(0, 2 * np.pi, 721))
    assert found.minimum == pytest.approx(0.001, abs=1e-12)
    assert found.meets_margin
    assert found.free[found.allowed == PASSAGE.clearance].min() >= found.minimum


def test_the_document_s_rounding_up_to_125_degrees_costs_some_of_the_margin():
    after = rounded(STATION.overlapping(), 125)
    found = STATION.clearance(after, 0.0)
    assert found.minimum == pytest.approx(0.02 - 0.05 * Cycloidal().s(1 - 70 / 125), abs=1e-12)
    assert 0.0 < found.minimum < 0.001
    assert not found.meets_margin
    assert not found.collides


def test_the_sweep_has_the_document_s_case_in_it():
    sweep = STATION.sweep([0.0, 0.001, 0.02], RATE)
    assert degrees(sweep.angle_in[1]) == pytest.approx(124.8369, abs=5e-5)
    assert degrees(sweep.angle_in[2]) == pytest.approx(70, abs=1e-10)
    assert sweep.ratio[1] == pytest.approx((124.8369147 / 55) ** 2, rel=1e-8)
