"""Timing within bounds, orders and times: against brute force, against the template of an overlap, and aims."""

import json
from itertools import product
from math import degrees

import numpy as np
import pytest

from tests.printed.test_s2 import STATION
from tests.workbook.studies.studied import base
from workbook.book_layout import layout_text
from workbook.errors import InputError
from workbook.fields.paths import table
from workbook.improving import AIMS, Room
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import read_machine
from workbook.studies.design import first_design
from workbook.studies.improve import better
from workbook.studies.plan import changed_machine
from workbook.studies.timing import TimingSearch, best_timing
from workbook.templates import TEMPLATES

PRESS = """
template = "machine"
title = "Indexing mill and die of S2"
[master]
rate = 33.333333333333336
[[axes]]
name = "Mill"
group = "Transfer"
closes = "feed"
phases = [ { start = 0.0, stop = 150.0, lift = 100.0, law = "CIC" } ]
[[axes]]
name = "Die"
group = "Tool"
shift = 70.0
phases = [
  { start = 80.0, stop = 135.0, lift = 50.0, law = "CIC" },
  { start = 135.0, stop = 235.0, lift = 0.0, law = "DWL" },
  { start = 235.0, stop = 290.0, lift = -50.0, law = "CIC" },
]
[[clearances]]
name = "Die in the mill's way"
first = "Mill"
second = "Die"
least = 1.0
pairs = [
  [0.0, 52.0], [0.645107162, 52.0], [0.645107163, 20.0],
  [99.354892836, 20.0], [99.354892837, 52.0], [100.0, 52.0],
]
[timing]
edges = [
  { axis = "Die", phase = 1, edge = "start", earliest = 0.0, latest = 130.0 },
  { axis = "Die", phase = 2, edge = "start", earliest = 60.0, latest = 200.0 },
  { axis = "Die", phase = 3, edge = "stop", earliest = 240.0, latest = 360.0 },
]
lasting = [ { axis = "Die", phase = 2 } ]
"""


def silent(count, total, words):
    """Progress that nobody looks at."""


@pytest.fixture(scope="module")
def press(tmp_path_factory):
    path = tmp_path_factory.mktemp("press") / "press.toml"
    path.write_text(PRESS, encoding="utf-8")
    return read_machine(path)


def with_timing(machine, **timing):
    return changed_machine(machine, table(machine), {("timing",): timing})


def edge(axis, phase, name, earliest, latest):
    return {"axis": axis, "phase": phase, "edge": name, "earliest": earliest, "latest": latest}


def test_the_die_of_s2_comes_out_as_the_overlap_is_worked_out(press) -> None:
    """The die's acceleration falls from 4.154 m/s² as far as the clearance lets it; S2 rounds its 124.73° to 125°."""
    schedule = STATION.overlapping()
    design = first_design(press, AIMS["acceleration"], "Die")
    assert design.cost == pytest.approx(4.154172, abs=1e-6)
    best = best_timing(design, 0, silent)
    assert best.cost == pytest.approx(schedule.peak_acceleration(press.per_minute / 60.0), rel=1e-3)
    way_in, dwell, way_out = best.machine.axes[1].phases
    assert way_in.stop - way_in.start == pytest.approx(degrees(schedule.angle_in), abs=0.03)
    assert way_out.stop - way_out.start == pytest.approx(degrees(schedule.angle_out), abs=0.03)
    assert dwell.stop - dwell.start == 100.0
    assert best.breaks() == set()


def test_no_whole_degrees_of_three_edges_are_better(tmp_path) -> None:
    """The feed may end later, but has passed 290 mm where the punch starts, which moves and lasts its time."""
    machine = with_timing(
        read_machine(TEMPLATES["machine"].description),
        edges=[
            edge("MC01", 1, "stop", 80.0, 98.0),
            edge("MC02", 1, "start", 90.0, 91.0),
            edge("MC02", 1, "stop", 134.0, 136.0),
        ],
        orders=[{"axis": "MC02", "phase": 1, "edge": "start", "other": "MC01", "above": 299.9}],
        lasting=[{"axis": "MC02", "phase": 1, "least": 0.035}],
    )
    design = first_design(machine)
    best = best_timing(design, 0, silent)
    search = TimingSearch(design, design.improving.timing.rooms(machine, machine, design.limiting))
    by_hand = design
    for moves in product(*(np.arange(room.low, room.high + 0.5) for room in search.rooms)):
        other = search.moved(np.array(moves))
        by_hand = other if search.is_better(other, by_hand) else by_hand
    assert best.rate > design.rate * 1.02
    assert by_hand.rate * (1.0 - 1e-4) <= best.rate <= by_hand.rate * 1.02
    feed = best.machine.axes[0].phases[0]
    assert 91.0 < feed.stop < 97.0  # the order holds it, not its bound


@pytest.mark.parametrize(
    ("timing", "words"),
    [
        (
            {"edges": [edge("MC9", 1, "stop", 0.0, 9.0)]},
            r"edges\[1\]: no axis is named 'MC9'; expected one of Mill, Die",
        ),
        ({"edges": [edge("Die", 4, "stop", 0.0, 9.0)]}, r"edges\[1\].phase: Die has 3 phases"),
        ({"edges": [edge("Die", 1, "stop", 0.0, 9.0)]}, r"the stop of Die phase 1 is at 135°; expected bounds"),
        (
            {"orders": [{"axis": "Die", "phase": 1, "edge": "start", "other": "Mill"}]},
            r"orders\[1\]: expected a position",
        ),
        (
            {"orders": [{"axis": "Die", "phase": 1, "edge": "start", "other": "Mill", "below": 30.0}]},
            r"orders\[1\]: Mill is at 100 mm at the start of Die phase 1; expected below 30",
        ),
    ],
)
def test_a_timing_that_does_not_fit_the_machine_says_so(press, timing, words) -> None:
    machine = with_timing(press, **timing)
    with pytest.raises(InputError, match=words):
        best_timing(first_design(machine, AIMS["acceleration"], "Die"), 0, silent)


def test_a_book_keeps_the_timing_by_the_numbers_of_its_axes(press) -> None:
    layout = json.loads(layout_text(press, TEMPLATES["machine"].declare(press)))
    assert [row["axis"] for row in layout["timing"]["edges"]] == [2, 2, 2]
    renamed = {"axes": [{"name": "Mill"}, {"name": "Stamp"}], "timing": layout["timing"]}
    spelled = type(press).expand_short_forms(renamed)["timing"]
    assert spelled["edges"][0] == edge("Stamp", 1, "start", 0.0, 130.0)
    assert spelled["lasting"] == [{"axis": "Stamp", "phase": 2}]


def test_a_move_leaves_the_vibration_of_its_law(press) -> None:
    """The cycloid leaves 16.977 % of its lift behind 1.5 periods of the load, and none behind 2."""
    time = 55.0 / 360.0 / (press.per_minute / 60.0)
    for periods, share in ((1.5, 0.16977), (2.0, 0.0)):
        aim = AIMS["vibration"]._replace(frequency=periods / time)
        assert first_design(press, aim, "Die").cost == pytest.approx(50.0 * share, abs=5e-4)


@pytest.mark.parametrize("aim", ["torque", "power", "energy"])
def test_another_aim_keeps_the_rate_and_has_less(tmp_path, aim) -> None:
    design = first_design(read_machine(base(tmp_path)), AIMS[aim])
    best = next(better(design, ("law",), THIS_PROCESS, silent))
    assert best.cost < design.cost * 0.99
    assert first_design(best.machine).rate >= design.rate * (1.0 - 1e-9)


def test_an_axis_that_is_not_there_is_told(press) -> None:
    with pytest.raises(
        InputError, match="no axis with a greatest acceleration is named 'X'; expected one of Mill, Die"
    ):
        first_design(press, AIMS["acceleration"], "X")
    with pytest.raises(InputError, match="no axis has a drive"):
        first_design(press, AIMS["torque"])


def test_edges_move_by_whole_steps_within_their_room() -> None:
    room = Room("", {}, {}, low=-2.3, high=1.2, step=0.5, after="")
    assert [room.rounded(by) for by in (-9.0, -0.8, 0.74, 9.0)] == [-2.0, -1.0, 0.5, 1.0]
