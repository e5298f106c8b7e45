"""The parts as drawn: where they stand follows from the strokes, and nothing leaves the frame."""

from math import radians

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.laws.simple import Cycloidal
from engine.overlap.picture import Scene, lane
from engine.overlap.plan import Station
from engine.overlap.schedule import Passage, Tool, Transfer

TOOLS = (0.05, 0.03, 0.08)  # strokes
MILL = Transfer(Cycloidal(), 0.1, radians(150))
SCENE = Scene([Station(MILL, Tool(Cycloidal(), h, 0.0), Passage(0.01, 0.04)) for h in TOOLS])


@pytest.mark.parametrize("i", range(3))
def test_a_tool_s_lower_end_is_as_far_above_the_work_as_it_has_to_go(i):
    x, z = SCENE.punch(i, 0.01)
    assert z.min() == pytest.approx(TOOLS[i] - 0.01)
    assert z.max() - z.min() == pytest.approx(1.5 * TOOLS[i])
    assert (x.min() + x.max()) / 2 == pytest.approx(0.25 * i, abs=1e-15)
    assert SCENE.punch(i, TOOLS[i]).z.min() == pytest.approx(0.0, abs=1e-15)


def test_the_transfer_stands_where_the_tool_would_touch_it_once_it_has_gone_its_clearance():
    assert SCENE.tops == pytest.approx([0.01, 0.0, 0.04])


@given(st.floats(0, 0.1), st.floats(0, 1))
def test_all_parts_stay_within_the_frame(moved, share):
    frame = SCENE.frame()
    for x, z in (SCENE.walls(moved), *(SCENE.punch(i, share * h) for i, h in enumerate(TOOLS))):
        assert frame.x.min() - 1e-12 <= x.min() <= x.max() <= frame.x.max() + 1e-12
        assert frame.z.min() - 1e-12 <= z.min() <= z.max() <= frame.z.max() + 1e-12


def test_at_both_ends_of_its_stroke_the_transfer_leaves_the_station_open_for_the_tool():
    """The opening is the tool's width and the remaining share on both sides; half way there is a wall."""
    for travel, is_open in ((0.0, True), (0.1, True), (0.001, True), (0.05, False)):
        x, _ = SCENE.walls(travel)
        edges = np.unique(x[:12])
        at_tool = (np.array([-0.015, 0.015]), np.array([0.0]))
        covered = [(a, b) for a, b in zip(x[0:12:4], x[3:12:4], strict=True) if b > a]
        touched = any(a < p < b for points in at_tool for p in points for a, b in covered)
        assert touched is not is_open, (travel, edges)


def test_lanes_lie_one_above_the_other():
    assert lane(2, np.array([0.0, 0.5, 1.0])) == pytest.approx([2.0, 2.4, 2.8])
