"""Phases of a machine's axes that hand velocity over, beside rests and lines, and what drives make of them."""

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from workbook.reading.descriptions import counted_from_1, validated
from workbook.templates import TEMPLATES

MACHINE = TEMPLATES["machine"]
NAMED = ("LIN", "PO5", "PO7", "MSN", "SCV")
SMALL = {"cycle": 36, "law": 4, "phases": 6}


def phase(start, stop, lift, law, **passing):
    return {"start": start, "stop": stop, "lift": lift, "law": law, **passing}


def axis(name, *phases, **more):
    return {"name": name, "group": "Group", "phases": list(phases)} | more


def machine(*axes, **sizes):
    data = {"template": "machine", "title": "AxisHandover over", "master": {"rate": 60.0}, "axes": list(axes)}
    return validated(
        MACHINE, data | {"laws": {code: {"family": code} for code in NAMED}, "sizes": SMALL | sizes}, counted_from_1
    )


OUT, STEP, BACK = phase(0.0, 90.0, 30.0, "PO5"), phase(90.0, 130.0, 20.0, "LIN"), phase(130.0, 300.0, -50.0, "PO5")
CARRIAGE = (phase(0.0, 40.0, 20.0, "LIN"), phase(40.0, 200.0, -10.0, "MSN"), phase(200.0, 360.0, -10.0, "PO5"))


def test_rise_to_line_speed_run_in_step_and_return_is_three_phases():
    one = machine(axis("Pusher", OUT, STEP, BACK), axis("Carriage", *CARRIAGE, shift=25.0))
    assert disagreeing(MACHINE, one)[0] == []
    assert entered(MACHINE, one) == (one, [])
    value = computed(MACHINE, one)
    assert value("overall") == "OK"
    kinds = list(zip(value("axis1", "begins"), value("axis1", "ends"), strict=True))
    assert kinds == [("R", "G"), ("G", "G"), ("G", "R"), *[("", "")] * 3]
    assert value("cycle1", "y")[9:14] == pytest.approx([30.0, 35.0, 40.0, 45.0, 50.0], rel=1e-12)  # every 10°
    assert value("cycle1", "v")[9:13] == pytest.approx([0.18] * 4, rel=1e-12)  # 20 mm in 40° of a second
    assert (value("axis2", "begins")[:3], value("axis2", "ends")[:3]) == (["G", "G", "R"], ["G", "R", "G"])
