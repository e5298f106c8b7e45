"""A slide on a crank that turns full circles, a swinging arm: textbook figures, differentiated positions, energy."""

from math import asin, degrees, pi, radians, sqrt

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Load, Part, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.mechanisms.by_angle import Arm, PressCrank
from engine.drive.results import DriveResults
from engine.laws import Dwell, law
from engine.motion import Motion
from tests.engine.drive.machines import points_of

R, ROD, TURN = 0.06, 0.24, 2 * pi
PRESS = PressCrank(R, ROD)
ROUND = Motion.from_edges([0.0, TURN], [TURN], [law("LIN")])
"""one turn at constant speed"""


def cycle_of(by_angle, load, motion=ROUND, speed=TURN, *, eta=1.0, inertia=0.0, windows=(), **more):
    """A crank or an arm behind a reducer of 5, over a cycle."""
    parts = [Part("flywheel", inertia, 1)]
    mechanism = KINDS["press crank"].of(load, 1.0, eta, [Stage("reducer", 5.0, eta)], parts)
    return DriveCycle(Drivetrain(mechanism, 0.0, windows=tuple(windows), by_angle=by_angle, **more), motion, speed)


def test_the_acceleration_in_the_dead_centres_is_that_of_the_textbook():
    """At 300 rpm r ω² (1 ± λ), λ = r/l = 1/4: 74.02 m/s² towards the shaft and 44.41 m/s² away from it."""
    w = 300 * pi / 30
    slope, bend = PRESS.slopes(np.array([0.0, pi]))
    assert bend * w**2 == pytest.approx([-R * w**2 * 1.25, R * w**2 * 0.75], rel=1e-14)
    assert bend * w**2 == pytest.approx([-74.02, 44.41], abs=0.005)
    assert slope == pytest.approx(0.0, abs=1e-16)


def test_the_speed_of_the_slide_is_that_of_the_textbook_series():
    """x' = −r (sin φ + λ/2 sin 2φ), the series broken off behind λ², right to r λ³/5."""
    at = np.linspace(0.0, TURN, 73)
    assert PRESS.slopes(at)[0] == pytest.approx(-R * (np.sin(at) + np.sin(2 * at) / 8), abs=R * 0.25**3 / 5)


@pytest.mark.parametrize("crank", [PRESS, PressCrank(R, ROD, 0.03, 1.1), PressCrank(R, 0.07, -0.008, -2.0)])
def test_slopes_are_those_of_positions_and_are_0_in_the_dead_centres(crank):
    at, h = np.linspace(-7.0, 7.0, 98), 1e-4
    before, here, after = (crank.position(at + way * h) for way in (-1, 0, 1))
    slope, bend = crank.slopes(at)
    assert slope == pytest.approx((after - before) / (2 * h), abs=1e-7)
    assert bend == pytest.approx((after - 2 * here + before) / h**2, abs=1e-5)
    centres = crank.dead_centres(-7.0, 7.0)
    assert crank.slopes(np.array(centres))[0] == pytest.approx(0.0, abs=1e-15)
    signs = np.sign(slope)
    assert len(centres) == int((signs[1:] != signs[:-1]).sum())


def test_an_arm_asks_for_its_moment_by_the_cosine():
    """10 kg at 0.3 m: up to 29.43 Nm, RMS over a turn 29.43/√2, and no work."""
    moment = 10.0 * 9.81 * 0.3
    drive_cycle = cycle_of(Arm(moment, radians(30)), Load(0.9))
    found = DriveResults(drive_cycle)
    assert 5.0 * found.torque.peak == pytest.approx(29.43, abs=1e-9)
    assert degrees(found.torque.highest.x) == pytest.approx(330.0, abs=1e-4)
    assert 5.0 * found.rms_torque == pytest.approx(moment / sqrt(2), rel=1e-9)
    assert found.energy.net == pytest.approx(0.0, abs=1e-9)
    assert points_of(drive_cycle).rms_torque == pytest.approx(found.rms_torque, rel=1e-4)


def test_an_arm_that_stands_is_held():
    drive_cycle = cycle_of(Arm(30.0, radians(60)), Load(0.9), Motion.from_edges([0.0, TURN], [0.0], [Dwell()]))
    assert DriveResults(drive_cycle).torque.peak == pytest.approx(30.0 / 2 / 5, rel=1e-12)


def test_a_rod_that_is_too_short_is_refused():
    with pytest.raises(ValueError, match="expected more than crank and offset"):
        PressCrank(0.06, 0.07, -0.02)


def test_the_angles_of_the_dead_centres_of_an_offset_slide():
    crank = PressCrank(0.05, 0.2, 0.03)
    assert crank.dead_centres(0.0, TURN) == pytest.approx([asin(0.03 / 0.25), pi + asin(0.03 / 0.15)])
