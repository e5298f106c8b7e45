"""What a drive carries at the points of its cycle, by hand."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Load, Stage
from engine.drive.cycle import DriveCycle
from engine.laws import Dwell, law
from engine.motion import Motion
from tests.engine.drive.machines import points_of

RISE = Motion.from_edges(np.radians([0, 90, 180, 270, 360]), [0.05, 0.0, -0.05, 0.0],
                         [law("CIC"), Dwell(), law("CIC"), Dwell()])  # fmt: skip


@pytest.mark.parametrize("holding", ["motor", "brake"])
def test_a_reducer_carries_what_stands_whoever_holds_the_motor(holding):
    """4,000 N on a pinion of 100 mm: 200 Nm at its shaft, 222.2 Nm behind the reducer with η = 0.9."""
    rack = KINDS["rack and pinion"].of(Load(0.0, 4000.0), 0.1, 0.9, [Stage("reducer", 5.0, 1.0)], [])
    drive_cycle = DriveCycle(Drivetrain(rack, 1e-3, holding=holding), RISE, 1.0)
    resting = points_of(drive_cycle).load
    assert resting.output_torque[resting.direction == 0.0] == pytest.approx(200.0 / 0.9, rel=1e-12)
    torque = points_of(drive_cycle).torque[resting.direction == 0.0]
    assert torque == pytest.approx(0.0 if holding == "brake" else 200.0 / 0.9 / 5.0, rel=1e-12)


def test_a_lossy_screw_is_driven_down_and_holds_its_load():
    """100 kg upright on a lead of 4 mm, η = 0.45: backward 2 − 1/η = −0.2222, down −0.139 Nm, at rest nothing."""
    screw = KINDS["lead screw"].of(Load(100.0, 981.0), 250.0, 0.45, [Stage("reducer", 1.0, 1.0)], [])
    *gears, last = screw.stages
    screw = replace(screw, stages=(*gears, replace(last, back_efficiency=-2.0 / 9.0)))
    points = points_of(DriveCycle(Drivetrain(screw, 0.0), RISE, 1e-4))
    down, rest = points.load.direction < 0.0, points.load.direction == 0.0
    assert points.torque[down] == pytest.approx(-2.0 / 9.0 * 981.0 * 0.004 / (2.0 * pi), rel=1e-5)
    assert points.torque[down].mean() == pytest.approx(-0.139, abs=5e-4)
    assert points.torque[rest] == pytest.approx(0.0)
    assert (points.power >= -1e-12).all()
