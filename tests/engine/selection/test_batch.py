"""Many motors behind many reducers at once: each is what the points of its own drive say."""

from dataclasses import replace

import numpy as np
import pytest

from engine.drive.drive_points import DrivePoints, peak
from engine.drive.motor import Motor, TorqueFall
from engine.drive.quadrature import QuadratureCycle
from engine.motion.pieces import motion_pieces
from engine.selection.point_load import DriveBatch, MotorLimits, PairArrays, PointLoad, tops
from tests.engine.drive.machines import drive_cycle_of

INERTIA, RATIO, ETA = np.array([1e-3, 5e-3, 0.0, 2e-2]), np.array([3.0, 8.0, 12.0, 1.0]), np.array([0.9, 0.6, 1.0, 0.8])
NO_LOAD = np.array([0.0, 0.4, 0.02, 3.0])
LIMITS = MotorLimits(np.array([5.0, 80.0, 9.0, 300.0]), np.full(4, 30.0), np.array([0.0, 0.1, 0.0, 0.5]),
                np.array([0.0, 0.5, 20.0, 0.01]))  # fmt: skip


def alone(points, limits, time):
    """What the points of one drive say."""
    power, (top, knee, fall, _) = points.power, limits
    reserve = points.reserve(Motor(1.0, peak_torque=top, falling=TorqueFall(knee, fall))).min()
    works = [points.mean(np.maximum(way * power, 0.0)) * time for way in (1.0, -1.0)]
    ends = [-points.top(-points.torque), points.top(points.torque), -points.top(-power), points.top(power)]
    return [*ends, reserve, *works]


def geared(drive_cycle):
    """Whether a reducer is all that it has before its mechanism."""
    return len(drive_cycle.train.mechanism.stages) == 2


@pytest.mark.parametrize("number", range(8))
def test_each_is_what_its_points_say(number, monkeypatch):
    drive_cycle = next(one for one in map(drive_cycle_of, range(100 * number, 100 * number + 100)) if geared(one))
    load = QuadratureCycle(drive_cycle, motion_pieces(drive_cycle.motion), drive_cycle.motion.tolerance).points()
    drive = drive_cycle.train
    first, *others = drive.mechanism.stages
    monkeypatch.setattr("engine.selection.point_load.AT_ONCE", 2 * load.x.size)
    found = DriveBatch(PointLoad(load, 0.0, 0.0, 0.0), PairArrays(INERTIA, RATIO, ETA, NO_LOAD), LIMITS)
    works = found.works(drive_cycle.time)
    for k in range(len(INERTIA)):
        stage = replace(first, ratio=RATIO[k], efficiency=ETA[k], back_efficiency=None)
        parts = tuple(part for part in drive.mechanism.parts if part.shaft)
        mechanism = replace(drive.mechanism, stages=(stage, *others), parts=parts)
        other = replace(
            drive, mechanism=mechanism, motor_inertia=INERTIA[k], no_load=NO_LOAD[k], copper=LIMITS.copper[k]
        )
        own = replace(load, train=other)
        expected = alone(DrivePoints(own), [one[k] for one in LIMITS], drive_cycle.time)
        here = [*(values[k] for values in found.extremes), works.driving[k], works.regenerated[k]]
        assert here == pytest.approx(expected, rel=1e-11, abs=1e-9 * max(map(abs, expected)))


def test_the_tops_of_many_are_the_tops_of_each():
    rng = np.random.default_rng(1)
    place = np.sort(rng.uniform(0.0, 1.0, (5, 9)), axis=1) + np.arange(5)[:, None]
    values = rng.normal(size=(300, 45)).round(1)
    assert tops(values, place) == pytest.approx([peak(one.reshape(5, 9), place).top for one in values], rel=1e-12)
