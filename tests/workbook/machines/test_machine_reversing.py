"""Drives of phases that move there and back, and of the seventh degree: cells, engine, dense samples, energy."""

from dataclasses import replace

import numpy as np
import pytest

from engine.drive.results import DriveResults
from tests.engine.drive.machines import sampled
from tests.workbook.cells import disagreeing
from tests.workbook.machines.test_machine_handover import BACK, DRIVE, MACHINE, OUT, SMALL, STEP, axis, phase
from workbook.law_sheets.library import laws
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.view import MachineView
from workbook.reading.descriptions import counted_from_1, validated

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
CASES = {"turning": TURNING, "septic": SEPTIC, "pulses": PULSES, "rests": RESTS, "quintic": (OUT, STEP, BACK)}


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
    return validated(MACHINE, data | {"laws": {code: {"family": code} for code in LAWS}} | more, counted_from_1)


def moved(phases, **more):
    """A machine of one axis whose load process forces act upon."""
    load = DRIVE["load"] | {"windows": WINDOWS}
    return machine(axis("A", *phases, shift=17.0, **(DRIVE | {"load": load} | more)))


def course_of(one):
    """The drive of a machine's first axis over its motion."""
    axis = MachineView(one, laws(one.laws)).axes[0]
    return replace(Driven(axis, one).results.drive_cycle, motion=axis.motion)


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", CASES)
def test_cells_come_to_what_the_engine_says(name):
    one = moved(CASES[name])
    assert one.design.faults == ()
    assert disagreeing(MACHINE, one)[0] == []


@pytest.mark.parametrize("name", CASES)
def test_torque_power_and_energy_by_dense_samples(name):
    """Of the motion's closed forms and the chain alone; and of energy, what friction and process forces take."""
    drive_cycle = course_of(moved(CASES[name]))
    found, rows = DriveResults(drive_cycle), sampled(drive_cycle, 20001)
    speed, torque = (np.concatenate([row[k] for row in rows]) for k in (1, 2))
    power = speed * torque
    assert found.torque.highest.value == pytest.approx(torque.max(), rel=1e-5)
    assert found.torque.lowest.value == pytest.approx(torque.min(), rel=1e-5)
    assert found.power.highest.value == pytest.approx(power.max(), rel=1e-5)
    square = sum(np.trapezoid(row[2] ** 2, row[0]) for row in rows)
    assert found.rms_torque == pytest.approx(np.sqrt(square / drive_cycle.unshifted.total), rel=1e-5)
    work = sum(np.trapezoid(row[1] * row[2], row[0]) for row in rows) / drive_cycle.speed
    assert found.energy.net == pytest.approx(work, rel=1e-5)


BACK_AND_FORTH = {"OWN": {"pieces": [{"duration": 1.0, "c0": -12.0, "c1": 60.0, "c2": -48.0}]}}
POINTS = [{"angle": at, "position": y} for at, y in ((-60.0, -20.0), (0.0, 0.0), (40.0, 30.0), (200.0, 100.0))]
WAVES = {"duration": 0.5, "c0": 4.0, "amplitude": 1.5, "omega": 50.26548245744}
MANY = {"OWN": {"pieces": [WAVES, WAVES | {"c0": -4.0, "amplitude": -1.5}]}}
TAKEN = {
    "a sine of more than three half turns": lambda: machine(
        axis("A", phase(0.0, 90.0, 30.0, "OWN"), closes="feed", **DRIVE), laws=MANY
    ),
    "a law of one's own that turns back": lambda: machine(
        axis("A", phase(0.0, 90.0, 30.0, "OWN"), closes="feed", **DRIVE), laws=BACK_AND_FORTH
    ),
    "a phase that turns back behind a table of positions": lambda: moved(
        CASES["quintic"], mechanism={"kind": "table", "efficiency": 0.9, "points": POINTS}
    ),
}


@pytest.mark.parametrize("name", TAKEN)
@pytest.mark.sample(1)
def test_every_law_is_taken_by_a_drive(name):
    """Those too that an earlier sheet could not integrate."""
    one = TAKEN[name]()
    assert one.design.faults == ()
    assert disagreeing(MACHINE, one)[0] == []
