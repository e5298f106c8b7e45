"""Drives of phases that move there and back, and of the seventh degree: cells, engine, dense samples, energy."""

import numpy as np
import pytest

from engine.machine.demand import Demand
from tests.engine.machine.machines import sampled
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine_handing import (
    BACK,
    DRIVE,
    MACHINE,
    OUT,
    SMALL,
    STEP,
    axis,
    phase,
)
from workbook.laws.library import laws
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.view import Whole
from workbook.reading.descriptions import checked, counted

SEPTIC = (phase(0.0, 90.0, 30.0, "PO7"), STEP, phase(130.0, 300.0, -50.0, "PO7"))
PULSES = (phase(0.0, 90.0, 30.0, "MSN"), STEP, phase(130.0, 300.0, -50.0, "SCV"))
RESTS = (phase(0.0, 80.0, 30.0, "PO7"), phase(100.0, 300.0, -30.0, "PO7"))
TURNING = (
    phase(0.0, 100.0, 10.0, "PO7"),
    phase(100.0, 220.0, -10.0, "PO7", velocity=0.0, acceleration=-0.03),
    phase(220.0, 330.0, 4.0, "PO5", velocity=0.02),
    phase(330.0, 360.0, -4.0, "HAC"),
)
WINDOWS = [
    {"start": 20.0, "stop": 150.5, "force": 300.0, "resists": "moving"},
    {"start": 340.0, "stop": 10.0, "force": -200.0, "resists": "always"},
]
CASES = {"quintic": (OUT, STEP, BACK), "septic": SEPTIC, "pulses": PULSES, "rests": RESTS, "turning": TURNING}


LAWS = ("LIN", "PO5", "PO7", "MSN", "SCV", "HAC")


def machine(*axes, **more):
    """A machine whose laws may hand over."""
    sizes = SMALL | {"motion_pieces": 40} | more.pop("sizes", {})
    data = {
        "template": "machine",
        "title": "There and back",
        "master": {"rate": 60.0},
        "axes": list(axes),
        "sizes": sizes,
    }
    return checked(MACHINE, data | {"laws": {code: {"family": code} for code in LAWS}} | more, counted)


def moved(phases, **more):
    """A machine of one axis whose load process forces act upon."""
    load = DRIVE["load"] | {"windows": WINDOWS}
    return machine(axis("A", *phases, shift=17.0, **(DRIVE | {"load": load} | more)))


def course_of(one):
    """The drive of a machine's first axis over its motion."""
    whole = Whole(one, laws(one.laws))
    return Driven(whole.axes[0], one.selection).demand.course


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", CASES)
def test_cells_come_to_what_the_engine_says(name):
    one = moved(CASES[name])
    assert one.design.faults == ()
    assert disagreeing(MACHINE, one)[0] == []


@pytest.mark.parametrize("name", CASES)
def test_torque_power_and_energy_by_dense_samples(name):
    """Of the motion's closed forms and the chain alone; and of energy, what friction and process forces take."""
    course = course_of(moved(CASES[name]))
    found, rows = Demand(course), sampled(course, 20001)
    speed, torque = (np.concatenate([row[k] for row in rows]) for k in (1, 2))
    power = speed * torque
    assert found.torque.highest.value == pytest.approx(torque.max(), rel=1e-5)
    assert found.torque.lowest.value == pytest.approx(torque.min(), rel=1e-5)
    assert found.power.highest.value == pytest.approx(power.max(), rel=1e-5)
    square = sum(np.trapezoid(row[2] ** 2, row[0]) for row in rows)
    assert found.rms_torque == pytest.approx(np.sqrt(square / course.told.total), rel=1e-5)
    work = sum(np.trapezoid(row[1] * row[2], row[0]) for row in rows) / course.speed
    assert found.energy.net == pytest.approx(work, rel=1e-5)


BACK_AND_FORTH = {"OWN": {"pieces": [{"duration": 1.0, "c0": -12.0, "c1": 60.0, "c2": -48.0}]}}
POINTS = [{"angle": at, "position": y} for at, y in ((-60.0, -20.0), (0.0, 0.0), (40.0, 30.0), (200.0, 100.0))]
REFUSED = {
    "a law of one's own that turns back": lambda: machine(
        axis("A", phase(0.0, 90.0, 30.0, "OWN"), **DRIVE), laws=BACK_AND_FORTH
    ),
    "a phase that turns back behind a table of positions": lambda: moved(
        CASES["quintic"], mechanism={"kind": "table", "efficiency": 0.9, "points": POINTS}
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_a_drive_does_not_take_leaves_the_design_unfinished(name):
    assert [fault.rule for fault in REFUSED[name]().design.faults] == ["shaped1"]


@pytest.mark.nightly
@pytest.mark.parametrize("name", REFUSED)
def test_the_sheet_says_what_a_drive_does_not_take(name):
    assert computed(MACHINE, REFUSED[name]())("drive1_ok_laws") == "FAIL"
