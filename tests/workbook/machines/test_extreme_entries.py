"""Entries at the ends of what a machine may have: cells and engine still agree."""

import copy
import random

import pytest

from tests.tiers import seed
from tests.workbook.cells import disagreeing
from workbook.build import build
from workbook.judging.verify import verify
from workbook.reading.descriptions import make_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
PHASE = {"start": 10.0, "stop": 90.0, "lift": 50.0, "law": "MTP"}
AXIS = {
    "name": "MC01", "group": "Pressing group",
    "phases": [PHASE, {"start": 200.0, "stop": 300.0, "lift": -50.0, "law": "CIC"}],
    "mechanism": {"kind": "lead screw", "efficiency": 0.9, "lead": 20.0},
    "load": {"mass": 25.0, "friction": 0.05},
    "motor": {"inertia": 12.0, "rated_torque": 16.0, "peak_torque": 48.0, "max_speed": 4500.0},
}  # fmt: skip
LAWS = ("ACS", "TVP", "CIC", "CUB", "MTP", "OWN")
SIZES = {"cycle": 24, "law": 8, "phases": 8, "rotors": 6, "pieces": 8, "motors": 20, "reducers": 20}
LEAST_PHASE = 360 * 1e-6  # degrees


def entered(rate=100.0, lift=50.0, stop=90.0, mass=25.0, law="MTP"):
    axis = copy.deepcopy(AXIS)
    axis["phases"][0] |= {"stop": stop, "lift": lift, "law": law}
    axis["phases"][1]["lift"] = -lift
    axis["load"]["mass"] = mass
    data = {"template": "machine", "title": "Press", "master": {"rate": rate}, "axes": [axis], "sizes": SIZES}
    return make_machine(TEMPLATE, data, lambda key: key)


@pytest.mark.parametrize(
    "entries",
    [
        {"lift": 1e-6}, {"lift": 1e-7, "law": "CUB"}, {"lift": 1e8}, {"stop": 10 + LEAST_PHASE},
        {"stop": 10 + 1e-3 * LEAST_PHASE, "law": "CUB"}, {"mass": 1e-12}, {"rate": 60 / 1e8}, {"rate": 1e7},
    ],
    ids=str,
)  # fmt: skip
@pytest.mark.sample(4)
def test_cells_and_engine_agree_at_tiny_and_huge_entries(entries):
    wrong, cells = disagreeing(TEMPLATE, entered(**entries))
    assert wrong == []
    assert cells > 4_000


def phases(drawn, lifts):
    """Phases of these lifts, in drawn order, at drawn places and by drawn laws."""
    places = sorted(drawn.sample(range(0, 360, 5), 2 * len(lifts)))
    ordered = drawn.sample(lifts, len(lifts))
    return [
        {"start": float(start), "stop": float(stop), "lift": lift, "law": drawn.choice(LAWS)}
        for start, stop, lift in zip(places[::2], places[1::2], ordered, strict=True)
    ]


@pytest.mark.parametrize("number", range(30))
@pytest.mark.sample(1)
def test_a_small_lift_beside_a_large_one_is_no_finding(number, tmp_path):
    """What is added up leaves the rounding of its largest part: of travels, jumps, gaps and what a drive carries."""
    drawn = random.Random(f"{seed(number)}")
    large = 10.0 ** drawn.uniform(3.0, 6.0)
    both, turning = [large, 1.0, -large, -1.0], [large, 1.0, large * 1e-9]
    axes = [
        {"name": "A", "group": "G", "phases": phases(drawn, both), "position": drawn.uniform(-1.0, 1.0)},
        {"name": "B", "group": "G", "unit": "°", "phases": phases(drawn, turning), "closes": "feed"},
        AXIS | {"phases": phases(drawn, both), "name": "C"},
    ]
    gap = {"name": "gap", "first": "A", "second": "C", "offset": 3.0 * large}
    data = {"template": "machine", "title": "Press", "axes": axes, "clearances": [gap]}
    data["sizes"] = SIZES
    build(make_machine(TEMPLATE, data | {"master": {"rate": 1.0}}, str), tmp_path / "book.xlsx")
    assert verify(tmp_path / "book.xlsx").findings == []
