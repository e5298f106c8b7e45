"""A motor's brake: the dwells that it holds, by hand; what it holds, by the formula of the static load."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from engine.drive import KINDS, Load, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Brake, Drivetrain, dwell_times
from engine.drive.results import DriveResults
from engine.laws import Dwell, law
from engine.motion import Motion
from tests.engine.drive.machines import points_of

TURN = 2 * pi


@pytest.mark.parametrize(
    ("durations", "direction", "expected"),
    [
        ([1, 2, 3, 4], [1, 0, 0, -1], [0, 5, 5, 0]),
        ([1, 2, 3, 4], [0, 1, 0, 0], [8, 0, 8, 8]),  # across the end of the cycle
        ([1, 2, 3, 4], [0, 1, 0, -1], [1, 0, 3, 0]),
        ([1, 2], [0, 0], [3, 3]),
        ([1, 2], [1, -1], [0, 0]),
    ],
)
def test_parts_at_rest_that_follow_each_other_are_one_dwell(durations, direction, expected):
    assert dwell_times(np.array(durations, float), np.array(direction, float)) == pytest.approx(expected)


def exact(drive_cycle):
    """The largest torque that a brake holds in dwells, at the motor's shaft (Nm)."""
    held = [one for one in drive_cycle.torque_intervals if one.braked]
    return max((abs(replace(one, braked=False).torque(np.array([one.low]))[0]) for one in held), default=0.0)


def cycle_of(brake, speed=TURN, holding="brake", efficiency=0.9):
    """Rack and pinion Ø100, 4,000 N always: dwells of 0.1 and 0.3 of the cycle behind a reducer of 2."""
    edges = [0.0, 0.3 * TURN, 0.4 * TURN, 0.7 * TURN, TURN]
    motion = Motion.from_edges(edges, [0.1, 0.0, -0.1, 0.0], [law("CIC"), Dwell(), law("CIC"), Dwell()])
    rack = KINDS["rack and pinion"].of(Load(2.0, 4000.0), 0.1, efficiency, gears=[Stage("reducer", 2.0, 0.95)])
    return DriveCycle(Drivetrain(rack, 1e-3, holding=holding, brake=brake), motion, speed)


STATIC = 4000 * 0.05 / 0.9 / 2.0 / 0.95


@pytest.mark.parametrize(("time", "share"), [(0.0, 0.0), (0.1, 0.0), (0.11, 0.1), (0.3, 0.1), (0.31, 0.4)])
def test_the_motor_holds_in_dwells_that_are_shorter_than_the_brake_takes(time, share):
    """∫T² of the dwells that the motor holds is that of the static torque, exact and by points."""
    by_motor, by_brake = cycle_of(Brake(), holding="motor"), cycle_of(Brake(200.0, time))
    none = DriveResults(cycle_of(Brake())).rms_torque ** 2
    assert DriveResults(by_motor).rms_torque ** 2 - none == pytest.approx(0.4 * STATIC**2)
    found = DriveResults(by_brake)
    assert found.rms_torque**2 - none == pytest.approx(share * STATIC**2, abs=1e-9)
    points = points_of(by_brake)
    assert points.rms_torque == pytest.approx(found.rms_torque, rel=1e-9)
    held = STATIC if share < 0.4 else 0.0
    assert exact(found.drive_cycle) == pytest.approx(held)
    assert points.brake_torque == pytest.approx(held)


def test_a_faster_cycle_leaves_the_brake_no_time():
    assert exact(cycle_of(Brake(200.0, 0.1), speed=1.01 * TURN)) > 0.0
    dwells = [cycle_of(Brake(200.0, 0.1), speed=n * TURN) for n in (1.0, 1.01, 3.1)]
    assert [sum(one.braked for one in cycle.torque_intervals) for cycle in dwells] == [2, 1, 0]


@pytest.mark.parametrize(("figures", "said"), [((0.0,), "torque is 0"), ((5.0, -1.0), "time is -1")])
def test_wrong_figures_are_told(figures, said):
    with pytest.raises(ValueError, match=said):
        Brake(*figures)
