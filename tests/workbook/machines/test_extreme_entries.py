"""Entries at the ends of what a machine may have: cells and engine still agree."""

import copy

import pytest

from tests.workbook.cells import disagreeing
from workbook.reading.descriptions import validated
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
LEAST_PHASE = 360 * 1e-6  # degrees


def entered(rate=100.0, lift=50.0, stop=90.0, mass=25.0, law="MTP"):
    axis = copy.deepcopy(AXIS)
    axis["phases"][0] |= {"stop": stop, "lift": lift, "law": law}
    axis["phases"][1]["lift"] = -lift
    axis["load"]["mass"] = mass
    data = {
        "template": "machine",
        "title": "Press",
        "master": {"rate": rate},
        "axes": [axis],
        "sizes": {"cycle": 24, "law": 8, "phases": 8, "rotors": 6, "pieces": 8, "motors": 20, "reducers": 20},
    }
    return validated(TEMPLATE, data, lambda key: key)


@pytest.mark.parametrize(
    "entries",
    [
        {"lift": 1e-6}, {"lift": 1e-7, "law": "CUB"}, {"lift": 1e8}, {"stop": 10 + LEAST_PHASE},
        {"stop": 10 + 1e-3 * LEAST_PHASE, "law": "CUB"}, {"mass": 1e-12}, {"rate": 60 / 1e8}, {"rate": 1e7},
    ],
    ids=str,
)  # fmt: skip
def test_cells_and_engine_agree_at_tiny_and_huge_entries(entries):
    wrong, cells = disagreeing(TEMPLATE, entered(**entries))
    assert wrong == []
    assert cells > 4_000
