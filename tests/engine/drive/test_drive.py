"""The drive: losses both ways, reserves and limits of its motor, what is refused."""

import math
from dataclasses import replace

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Load, Motor, Part, Stage
from engine.drive.chain import resisting
from engine.drive.drive_points import DrivePoints
from engine.drive.motor import STANDSTILL, TorqueFall, reserve
from engine.drive.quadrature import LoadPoints

RADIUS = 0.134
ROLLERS = KINDS["feed rollers"]
MOTOR = Motor(0.0065, rated_torque=60.0, peak_torque=160.0, max_speed=300.0)


def drive(torque=67.0, resists="always", ratio=1 / 8, efficiency=1.0, motor=MOTOR):
    """S1's feeding group behind a reducer: J_tot = 1.164 kg m² and C_r = ``torque`` at the rollers."""
    gears, parts = [Stage("reducer", 1 / ratio, efficiency)], [Part("rollers", 1.164, 1)]
    chain = ROLLERS.of(resisting(torque / RADIUS, resists), RADIUS, gears=gears, parts=parts)
    return Drivetrain(chain, motor.inertia)


def torque(one, w, dw):
    """The motor's torque at a speed and an acceleration of the rollers."""
    at, (steady, moving) = np.zeros(1), (one.force(way).level for way in (0.0, 1.0))
    v, a = at + w * RADIUS, at + dw * RADIUS
    load = LoadPoints(one, at, at, v, a, np.sign(v), at + steady, at + moving - steady, *one.ratio(at), at, at)
    return DrivePoints(load).torque.item()


@pytest.mark.parametrize(
    ("w", "dw", "factor"),
    [
        (5.0, 10.0, 1 / 0.8),  # driving forward
        (-5.0, -100.0, 1 / 0.8),  # driving backward
        (5.0, -100.0, 0.8),  # braking forward
        (-5.0, 10.0, 0.8),  # braking backward
        (0.0, -100.0, 1 / 0.8),  # standing
    ],
)
def test_losses_add_when_driving_and_help_when_braking(w, dw, factor):
    d = drive(efficiency=0.8)
    load_side = (67.0 + 1.164 * dw) / 8
    assert torque(d, w, dw) == pytest.approx(0.0065 * 8 * dw + load_side * factor, rel=1e-14)


@pytest.mark.parametrize(("torque", "going", "factor"), [(0, 1, 1 / 0.8), (-1, 1, 0.8), (1, -1, 0.8), (-1, 0, 1 / 0.8)])
def test_what_the_load_gives_back_loses_on_the_way(torque, going, factor):
    gear = Stage("gear", 1.0, 0.8)
    assert gear.factor(torque, going, "physical") == factor
    assert gear.factor(torque, going, "document") == 1 / 0.8


def test_the_document_counts_losses_against_the_motor_always():
    chain = drive(efficiency=0.8).mechanism
    documented = Drivetrain(chain, 0.0, "document")
    assert torque(documented, 1.0, -100.0) == pytest.approx((67.0 - 116.4) / 8 / 0.8, rel=1e-14)


def test_reserve_against_the_motors_limits():
    asked = 20.0, 100.0, 250.0
    found = reserve(MOTOR, *asked, 80.0)
    assert [(c.name, c.limit) for c in found] == [("RMS torque", 60), ("peak torque", 160), ("speed", 300)]
    assert [c.value for c in found] == [*asked]
    assert found.speed.reserve == 300 / 250
    weak = Motor(0.0065, 20.0, 99.9, 249.9)
    assert [c.ok for c in reserve(weak, *asked, 80.0)] == [True, False, False]
    assert all(c.ok for c in reserve(Motor(0.0065), *asked, 80.0))
    assert reserve(MOTOR, 0.0, 0.0, 0.0, 0.0).rms_torque.reserve == 0.0


@pytest.mark.parametrize(("lowest", "left"), [(0.0, 0.0), (-STANDSTILL / 2, 0.0), (-1.0, -300.0)])
def test_limits_are_a_closed_line_on_the_sides_that_the_motor_turns_to(lowest, left):
    right, speed, peak, rated = MOTOR.corners(lowest)
    assert speed.tolist() == [*[left] * 3, 0.0, *[300.0] * 6, 0.0, *[left] * 4]
    assert peak.tolist() == [*[160.0] * 7, *[-160.0] * 7, 160.0]
    assert (rated / peak).tolist() == [60 / 160] * 15
    assert right.tolist() == [False] * 4 + [True] * 6 + [False] * 5
    motor = replace(MOTOR, stall_torque=90.0, rated_speed=200.0, falling=TorqueFall(100.0, 0.2))
    falling = motor.corners(lowest)
    assert falling.speed[3:7].tolist() == [0.0, 100.0, 200.0, 300.0]
    assert falling.peak[3:7].tolist() == [160.0, 160.0, 140.0, 120.0]
    assert falling.continuous[3:7].tolist() == [90.0, 75.0, 60.0, 60.0]
    assert falling.continuous[7:11].tolist() == [-60.0, -60.0, -75.0, -90.0]


def test_the_continuous_torque_is_a_line_from_stall_to_rated_torque():
    hdt = Motor(0.02536, 48.4, 410.0, 2000.0, 116.5, 2000.0)
    assert hdt.continuous(0.0) == 116.5
    assert hdt.continuous(2000.0) == hdt.continuous(2500.0) == 48.4
    assert hdt.continuous(-1000.0) == pytest.approx((116.5 + 48.4) / 2)
    half = replace(hdt, rated_torque=24.2, stall_torque=58.25)
    assert half.continuous(500.0) == pytest.approx(0.5 * (0.75 * 116.5 + 0.25 * 48.4))
    assert Motor(1.0, 10.0, stall_torque=8.0, rated_speed=100.0).continuous(0.0) == 10.0
    assert math.isinf(Motor(1.0).continuous(5.0))


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda: Part("roller", 0.1, count=-1), "roller: count is -1; expected a finite number, 0 or more"),
        (lambda: Part("roller", 0.1, speed_ratio=math.inf), "speed_ratio is inf"),
        (lambda: Load(-1.0), "load: inertia is -1"),
        (lambda: Load(1.0, math.nan), "torque is nan"),
        (lambda: Load(1.0, 0.0, math.inf), "friction is inf"),
        (lambda: resisting(1.0, "sometimes"), "resists is 'sometimes'; expected 'always' or 'moving'"),
        (lambda: drive(ratio=-0.1), "reducer: ratio is -10; expected a finite number above 0"),
        (lambda: drive(efficiency=0.0), "reducer: efficiency is 0; expected more than 0 and at most 1"),
        (lambda: drive(motor=Motor(-1.0)), "motor: inertia is -1"),
        (lambda: Drivetrain(drive().mechanism, -1.0), "motor: inertia is -1"),
        (lambda: Drivetrain(drive().mechanism, 1.0, "exact"), "method is 'exact'"),
        (lambda: Drivetrain(drive().mechanism, 1.0, holding="hand"), "holding is 'hand'"),
        (lambda: Motor(0.1, rated_torque=0.0), "motor: rated_torque is 0"),
        (lambda: Motor(0.1, max_speed=math.nan), "motor: max_speed is nan"),
    ],
)
def test_what_cannot_be_is_refused(made, message):
    with pytest.raises(ValueError, match=message):
        made()


def test_a_no_load_torque_resists_either_way_and_not_at_rest():
    one = Drivetrain(KINDS["lead screw"].of(Load(0.0), 100.0), 0.0, no_load=0.3)
    assert [torque(one, w, 0.0) for w in (1.0, 0.0, -1.0)] == pytest.approx([0.3, 0.0, -0.3])
