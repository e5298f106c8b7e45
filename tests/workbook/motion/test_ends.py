"""Phases that hand velocity over, in cells: what they take, what they come to, what FAILs."""

import math
import random
import tomllib
from pathlib import Path

import pytest

from tests.workbook.cells import computed, disagreeing
from workbook.build import build, inputs
from workbook.judging.verify import verify
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["cutting-machine"]
IN_STEP = tomllib.loads((Path(__file__).parent / "in_step.toml").read_text(encoding="utf-8"))
SIZES = {"cycle": 36, "law": 4, "own_law": 4}
FAMILIES = ("MSN", "MTS", "SCC", "SCV", "SHM", "SRT", "SGS", "HAC", "PO5", "PO7", "DHM")
HALVES = ("ACS", "TVP", "CIC", "CUB", "MTP", "LIN", "LIN", "DWL", "MSN", "MTS", "SCC", "SCV", "SHM", "SRT", "PO5",
          "PO7", "OWN", "shifted", "HAC", "SGS", "DHM")  # fmt: skip


def machine_of(*axes, **entries):
    """A cutting machine in step with its line, of other phases: (stop, lift, law) of each, axis by axis."""
    data = IN_STEP | {"sizes": SIZES} | entries
    named = {law for phases in axes for *_, law in phases} | {"LIN", "PO5", "MSN"}
    data["laws"] = {code: {"family": code} for code in ("LIN", *FAMILIES) if code in named}
    data["laws"] |= {"shifted": {"family": "PO5", "share": 0.4}} if "shifted" in named else {}
    timing = data["timing"]
    told = []
    for given, phases in zip(timing["axes"], axes, strict=False):
        starts = [0.0, *(stop for stop, *_ in phases)]
        told.append(given | {"phases": [
            {"start": start, "stop": stop, "lift": lift, "law": law}
            for start, (stop, lift, law) in zip(starts, phases, strict=False)
        ]})  # fmt: skip
    data["timing"] = timing | {"axes": [*told, *timing["axes"][len(told) :]]}
    return TEMPLATE.model.model_validate(data)


def drawn(seed):
    """Phases of every kind, straight lines and dwells among them, with lifts of either sign and none."""
    dice = random.Random(seed)
    axes = []
    for _ in range(3):
        count = dice.randint(1, 8)
        stops = [*sorted(dice.sample(range(5, 356), count - 1)), 360.0]
        phases = []
        for stop in stops:
            law = dice.choice(HALVES)
            lift = 0.0 if law == "DWL" else dice.choice((0.0, *(dice.uniform(-80.0, 80.0) for _ in range(5))))
            phases.append((float(stop), lift, law))
        axes.append(phases)
    return axes


@pytest.mark.parametrize("seed", range(6))
def test_random_phases_come_to_what_the_engine_says(seed):
    wrong, count = disagreeing(TEMPLATE, machine_of(*drawn(seed)))
    assert wrong == []
    assert count > 9000


def mirrored(phases):
    return [(stop, -lift, law) for stop, lift, law in phases]


STEP = [(90.0, 30.0, "PO5"), (130.0, 20.0, "LIN"), (300.0, -50.0, "PO5"), (360.0, 0.0, "DWL")]


def test_rise_to_line_speed_run_in_step_and_return_is_three_phases(tmp_path):
    path = tmp_path / "book.xlsx"
    machine = machine_of()
    build(machine, path)
    assert verify(path, ["pycel", "formualizer"]).findings == []
    assert inputs(path) == (machine, [])
    value = computed(TEMPLATE, machine)
    assert value("overall") == "OK"
    assert list(zip(value("axis1", "begins"), value("axis1", "ends"), strict=True))[:4] == [
        ("R", "G"), ("G", "G"), ("G", "R"), ("R", "R")]  # fmt: skip
    assert value("cycle", "y1")[9:14] == pytest.approx([30.0, 35.0, 40.0, 45.0, 50.0], rel=1e-12)  # every 10°
    speed = 0.02 / math.radians(40)
    assert value("cycle", "g1")[9:13] == pytest.approx([speed] * 4, rel=1e-12)
    assert value("cycle", "gg1")[9:13] == pytest.approx([0.0] * 4, abs=1e-12)


def test_a_velocity_is_handed_over_across_the_end_of_the_cycle():
    value = computed(TEMPLATE, machine_of())
    speed = 0.02 / math.radians(40)
    assert value("axis2", "v1")[2] == value("axis2", "v0")[0] == pytest.approx(speed, rel=1e-12)
    assert (value("axis2", "begins")[:3], value("axis2", "ends")[:3]) == (["G", "G", "R"], ["G", "R", "G"])
    assert sum(value("axis2", "h")) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("law", ["ACS", "CUB", "MTP", "MSN", "SCV", "PO7", "HAC"])
def test_what_is_mirrored_comes_to_the_same(law):
    phases = [(stop, lift, law if name == "PO5" else name) for stop, lift, name in STEP]
    machine = machine_of(phases, mirrored(phases))
    assert disagreeing(TEMPLATE, machine)[0] == []
    value = computed(TEMPLATE, machine)
    for column in ("y1", "y2", "rms"):
        assert value("axis1", column) == pytest.approx(value("axis2", column), rel=1e-9)
    for one, other in zip(value("axis1", "y3"), value("axis2", "y3"), strict=True):
        assert one == other or one == pytest.approx(other, rel=1e-9)
    assert value("axes", "high")[0] == pytest.approx(-value("axes", "low")[1], rel=1e-9)


def said_of(value, check):
    return value(check), value(f"{check}_says")


@pytest.mark.parametrize("law", ["OWN", "DHM", "shifted"])
def test_a_law_that_cannot_take_a_velocity_fails_by_row_and_reason(law):
    phases = [(90.0, 30.0, law), *STEP[1:]]
    machine = machine_of(phases)
    assert disagreeing(TEMPLATE, machine)[0] == []
    value = computed(TEMPLATE, machine)
    reason = f"MC01 row 1: {law} cannot end with a velocity: it begins and ends at rest"
    assert said_of(value, "axis1_meets") == ("FAIL", reason)
    assert value("axis1_velocity") == "FAIL"


@pytest.mark.parametrize(
    ("phases", "smooth"),
    [
        ([(100.0, 20.0, "LIN"), (360.0, -20.0, "LIN")], "FAIL"),  # two slopes: each keeps its own
        ([(100.0, 20.0, "LIN"), (360.0, 52.0, "LIN")], "OK"),  # one slope: a feed
        ([(360.0, 72.0, "LIN")], "OK"),
        ([(360.0, 72.0, "MTP")], "OK"),
        ([(360.0, 0.0, "MSN")], "OK"),
        ([(180.0, 20.0, "LIN"), (360.0, 0.0, "MSN")], "OK"),  # comes back to where it began
        ([(359.999999, 20.0, "LIN"), (360.0, -20.0, "PO5")], "OK"),
        ([(90.0, 20.0, "LIN"), (200.0, 0.0, "DWL"), (360.0, -20.0, "LIN")], "FAIL"),
    ],
)
def test_straight_lines_and_single_phases(phases, smooth):
    machine = machine_of(phases)
    assert disagreeing(TEMPLATE, machine)[0] == []
    value = computed(TEMPLATE, machine)
    assert (value("axis1_smooth"), value("axis1_meets")) == (smooth, "OK")


def test_no_sample_is_beyond_the_extremes_of_its_phases():
    for seed in range(3):
        value = computed(TEMPLATE, machine_of(*drawn(seed), sizes=SIZES | {"cycle": 360}))
        for i in (1, 2, 3):
            for peak, column in (("y1", "g"), ("y2", "gg")):
                most = max(abs(x) for x in value("cycle", f"{column}{i}"))
                assert most <= max(value(f"axis{i}", peak)) * (1 + 1e-9)
            low, high = min(value(f"axis{i}", "low")), max(value(f"axis{i}", "high"))
            reached = [y / 1000 for y in value("cycle", f"y{i}")]
            assert low - 1e-9 * (high - low) <= min(reached)
            assert max(reached) <= high + 1e-9 * (high - low)
