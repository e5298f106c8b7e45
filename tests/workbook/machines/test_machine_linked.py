"""Drives of a ratio that depends on position, in cells: against positions differentiated, energy, other samples."""

import math

import numpy as np
import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from workbook.errors import InputError
from workbook.reading.descriptions import validated

CRANK = {
    "kind": "crank-slider",
    "efficiency": 1.0,
    "crank_radius": 50.0,
    "rod_length": 200.0,
    "offset": 10.0,
    "start": 15.0,
}
ROCKER = {
    "kind": "rocker",
    "efficiency": 1.0,
    "lever_length": 90.0,
    "link_length": 240.0,
    "offset": 95.0,
    "start_angle": 80.0,
}
POINTS = [{"angle": 30.0 * k, "position": 13.0 * k + 0.2 * k * k} for k in range(6)]
TABLE = {"kind": "table", "efficiency": 1.0, "points": POINTS}
RISE = ((20, 140, 60.0, "CIC"), (190, 330, -60.0, "MTP"))
MOTOR = {"inertia": 8.0, "rated_torque": 9.0, "peak_torque": 30.0, "max_speed": 4500.0}
FIGURES = ("tmax", "tmin", "rms", "speed", "mean", "smax", "smean", "energy", "returned", "power", "jtot", "ok_peak")


def linked(*phases, mechanism=CRANK, **entries):
    """An axis on a mechanism."""
    more = {"mechanism": mechanism, "load": {"mass": 12.0}, "motor": MOTOR}
    return axis(1, *(phases or RISE)) | more | entries


def small(one, **sizes):
    """A machine of one axis with little room."""
    return described([one], **{"phases": 2, "rotors": 2} | sizes)


LOSSY = {
    "load": {"mass": 12.0, "friction": 0.1, "slope": 30.0,
             "windows": [{"start": 100.0, "stop": 150.0, "force": 400.0}]},
    "parts": [{"name": "Crank", "count": 1.0, "inertia": 40.0, "shaft": "mechanism"}],
    "reducer": {"ratio": 5.0, "efficiency": 0.9}, "shift": 33.0,
}  # fmt: skip


def test_cells_agree_with_the_engine_and_entries_come_back():
    machine = small(linked(mechanism=CRANK | {"efficiency": 0.85}, **LOSSY))
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert entered(TEMPLATE, machine) == (machine, [])


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("mechanism", "lift"), [(CRANK, 60.0), (ROCKER, 25.0), (TABLE, 60.0)], ids=["crank", "rocker", "table"]
)
def test_over_a_cycle_the_motor_does_the_work_of_friction_and_process_force(mechanism, lift):
    """∮ T dφ = μ m g · 2 h + F Δy: without other losses, whatever the mechanism does in between."""
    load = {"mass": 12.0, "friction": 0.1, "windows": [{"start": 10.0, "stop": 150.0, "force": 500.0}]}
    phases = ((20, 140, lift, "CIC"), (190, 330, -lift, "MTP"))
    value = computed(TEMPLATE, small(linked(*phases, mechanism=mechanism, load=load), positions=6))
    net, way = value("drive1_energy") - value("drive1_returned"), lift / 1000
    work = 0.1 * 12.0 * 9.81 * 2 * way + 500.0 * way
    assert net == pytest.approx(work, abs=1e-5 * value("drive1_energy"))


def test_speed_and_torque_against_differentiated_angles():
    """φ by the law of cosines over time, differentiated; T = dE/dφ of mass and motor where nothing resists."""
    value = computed(TEMPLATE, small(linked(), cycle=720))
    time, r, rod, e = 0.3 / 720, 0.05, 0.2, 0.01
    inner = math.sqrt((rod - r) ** 2 - e**2) + 0.015

    def angle(y):
        """The crank from where the motion begins, of positions in m."""
        x = inner + np.array([0.0, *y])
        found = np.arctan2(e, x) + np.arccos((r**2 + x**2 + e**2 - rod**2) / (2 * r * np.hypot(x, e)))
        return found[0] - found[1:]

    assert value("drive1_pt", "phi") == pytest.approx(angle(value("drive1_pt", "y")), abs=1e-12)
    told = np.gradient(angle(np.array(value("cycle1", "y")) / 1000), time)
    places = np.linspace(0.0, 360.0, len(told))
    rates = np.array(value("drive1_pt", "v")) * value("drive1_pt", "g")
    assert rates == pytest.approx(np.interp(value("drive1_pt", "theta"), places, told), abs=0.05)
    assert value("drive1_cycle", "n") == pytest.approx(told * 30 / np.pi, abs=0.02 * np.abs(told).max() * 30 / np.pi)


@pytest.mark.parametrize("slide", ["ahead", "behind"])
@pytest.mark.parametrize("direction", ["forward", "backward"])
@pytest.mark.sample(1)
def test_a_rocker_agrees_with_the_engine_and_comes_back(slide, direction):
    told = ROCKER | {"efficiency": 0.8, "slide": slide, "direction": direction}
    phases = ((20, 140, 25.0, "CIC"), (190, 330, -25.0, "MTP"))
    machine = small(linked(*phases, mechanism=told, **LOSSY))
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert entered(TEMPLATE, machine) == (machine, [])


def test_a_rocker_out_of_reach_fails_by_row_and_amount():
    data = small(linked(mechanism=ROCKER)).model_dump()
    data["axes"][0]["phases"][0]["lift"] = 120.0
    machine = validated(TEMPLATE, data, str)
    (fault,) = machine.design.faults
    assert fault.message.startswith("A1 row 1 reaches 120 mm, ")
    assert fault.message.endswith("mm beyond the dead centre of lever and link")
    assert computed(TEMPLATE, machine)("drive1_ok_reach") == "FAIL"


@pytest.mark.sample(1)
@pytest.mark.parametrize(
    ("changed", "check", "said"),
    [
        ({"start": 0.0}, "reach", "A1 row 1 reaches 0 mm, 0 mm beyond the inner dead centre"),
        ({"start": 45.0}, "reach", "A1 row 1 reaches 60 mm, 4.8664 mm beyond the outer dead centre"),
        ({"rod_length": 40.0}, "linked", "the rod is not longer than crank and offset: the crank cannot turn round"),
        ({"rod_length": None}, "sized", "a size of the mechanism is empty"),
    ],
)
def test_what_cannot_be_is_built_and_fails_by_row_and_amount(changed, check, said):
    data = small(linked(mechanism=CRANK)).model_dump()
    data["axes"][0]["mechanism"] |= changed
    machine = validated(TEMPLATE, data, str)
    assert machine.design.faults[0].message.startswith(said)
    value = computed(TEMPLATE, machine, by_cells=True)
    assert value(f"drive1_ok_{check}") == "FAIL"
    if check != "sized":  # where too little is entered, cells have nothing to compute from
        assert all(isinstance(one, float | int) for one in [*value("drive1_pt", "T"), *value("drive1_cycle", "phi")])


def test_an_axis_that_does_not_come_back_fails():
    machine = small(linked((20, 140, 60.0, "CIC"), (190, 330, -30.0, "MTP"), closes="feed"))
    assert computed(TEMPLATE, machine)("drive1_ok_back") == "FAIL"


def test_entries_of_another_mechanism_are_refused():
    data = small(linked(mechanism={"kind": "lead screw", "lead": 10.0, "efficiency": 1.0})).model_dump()
    data["axes"][0]["mechanism"]["crank_radius"] = 5.0
    with pytest.raises(InputError) as refused:
        validated(TEMPLATE, data, str)
    (line,) = refused.value.lines
    assert line.startswith("axes.0.mechanism.crank_radius: unknown entry; expected one of kind, efficiency, lead; ")
