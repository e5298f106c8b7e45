"""Sizing of actuators: torque with losses either way, exact peaks and RMS against fine samples, reserve."""

import math
from math import radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.actuator import Sizing, derating, motor_inertia, thirds
from engine.drive import Drive, Load, Motor, Transmission
from engine.laws import CATALOGUE, ConstantAcceleration, Cycloidal, Dwell, ModifiedTrapezoidal, Piece, PieceLaw
from engine.mechanism import Part, Slide, Stage, conveyor, gear_train, lead_screw, rotary_table
from engine.motion import Phase

ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
laws = st.sampled_from([e.example() for e in CATALOGUE if e.code != "DWL"] + [ASYMMETRIC, thirds(0.1, 0.5, 0.4)])
TRAIN = gear_train(
    [Stage("first", 3.0, 0.8), Stage("second", 5.0, 0.7)],
    [Part("pinion", 1e-4), Part("middle", 1e-3, 1), Part("load", 0.05, 2)],
    torque=1.0,
    friction_torque=0.5,
)


def there_and_back(law, other):
    return [Phase(law, 6.0, 0.2), Phase(Dwell(), 0.0, 0.1), Phase(other, -6.0, 0.3)]


def sampled_rms(sizing, n=40001):
    """Midpoints, phase by phase, so that no sample lies on a jump between phases."""
    total = 0.0
    for begin, end in zip(sizing.motion.edges[:-1], sizing.motion.edges[1:], strict=True):
        step = (end - begin) / n
        middle = begin + step * (np.arange(n) + 0.5)
        total += float((sizing.operating_points(middle).torque ** 2).sum()) * step
    return math.sqrt(total / sizing.motion.total)


@settings(max_examples=30)
@given(laws, laws, st.sampled_from(["physical", "document"]), st.floats(-4.0, 4.0))
def test_rms_and_peak_are_those_of_fine_samples(law, other, method, torque):
    train = gear_train(TRAIN.stages, TRAIN.parts, torque, 0.5)
    sizing = Sizing(train, there_and_back(law, other), 1e-4, method)
    assert sizing.rms_torque == pytest.approx(sampled_rms(sizing), rel=2e-4)
    points = sizing.operating_points(np.linspace(0, sizing.motion.total, 6001))
    assert points.peak_torque <= sizing.peak_torque * (1 + 1e-12)
    assert points.peak_torque == pytest.approx(sizing.peak_torque, rel=1e-3)
    assert points.max_speed == pytest.approx(sizing.max_speed, rel=1e-3)


@pytest.mark.parametrize("law", [Cycloidal(), ASYMMETRIC, ConstantAcceleration()], ids=lambda law: law.code)
def test_the_two_ways_to_the_rms_agree_where_nothing_is_lost(law):
    stages = [Stage("first", 3.0), Stage("second", 5.0)]
    exact = Sizing(gear_train(stages, TRAIN.parts, 1.0, 0.5), there_and_back(law, law), 1e-4)
    nearly = [Stage("first", 3.0, 1.0 - 1e-13), Stage("second", 5.0)]  # takes the way by stages
    by_stages = Sizing(gear_train(nearly, TRAIN.parts, 1.0, 0.5), there_and_back(law, law), 1e-4)
    assert by_stages.rms_torque == pytest.approx(exact.rms_torque, rel=1e-12)


def test_rms_is_exact_where_power_turns_round_within_a_stage():
    sizing = Sizing(TRAIN, [Phase(Cycloidal(), 6.0, 0.2)], 1e-4)
    assert sizing.rms_torque == pytest.approx(sampled_rms(sizing, 400001), rel=1e-9)


@pytest.mark.parametrize("method", ["physical", "document"])
def test_rms_of_a_law_that_does_not_end_at_rest(method):
    half = PieceLaw([Piece(1.0, (1.0, 0.0, 0.0, 0.0))])
    sizing = Sizing(TRAIN, [Phase(half, 6.0, 0.2)], 1e-4, method)
    torque = float(sizing.torque(6.0 / 0.2**2, 1.0))
    assert sizing.rms_torque == pytest.approx(torque, rel=1e-12)


def test_constant_parts_of_a_trapezoid_give_the_rms_by_hand():
    sizing = Sizing(TRAIN, [Phase(thirds(1 / 4, 1 / 2, 1 / 4), 6.0, 0.4), Phase(Dwell(), 0.0, 0.1)], 1e-4)
    up, level, down, held = (part.torque for part in sizing.parts)
    by_hand = math.sqrt((up**2 * 0.1 + level**2 * 0.2 + down**2 * 0.1 + held**2 * 0.1) / 0.5)
    assert sizing.rms_torque == pytest.approx(by_hand, rel=1e-12)


def test_each_stage_loses_where_power_flows_to_the_load():
    a = 2.0
    behind = 1.0 + 0.5 + 0.05 * a
    middle = behind / 0.7 / 5 + 1e-3 * 5 * a
    at_motor = middle / 0.8 / 3 + (1e-4 + 1e-4) * 15 * a
    assert Sizing(TRAIN, [Phase(Cycloidal(), 1, 1)], 1e-4).torque(a, 1.0) == pytest.approx(at_motor, rel=1e-14)


def test_each_stage_helps_where_power_flows_back():
    a = -100.0
    behind = 1.0 + 0.5 + 0.05 * a
    middle = behind * 0.7 / 5 + 1e-3 * 5 * a
    at_motor = middle * 0.8 / 3 + (1e-4 + 1e-4) * 15 * a
    assert Sizing(TRAIN, [Phase(Cycloidal(), 1, 1)], 1e-4).torque(a, 1.0) == pytest.approx(at_motor, rel=1e-14)


def test_power_is_lost_and_never_gained():
    sizing = Sizing(TRAIN, there_and_back(ASYMMETRIC, Cycloidal()), 1e-4)
    without = Sizing(
        gear_train([Stage(s.name, s.ratio) for s in TRAIN.stages], TRAIN.parts, 1.0, 0.5), sizing.phases, 1e-4
    )
    time = np.linspace(0, sizing.motion.total, 2001)
    assert (sizing.operating_points(time).power >= without.operating_points(time).power - 1e-12).all()


def test_one_stage_is_the_drive_of_the_cutting_machine():
    table = rotary_table(0.6, 0.2, torque=3.0, reduction=8.0, efficiency=0.85)
    sizing = Sizing(table, [Phase(Cycloidal(), 1.0, 0.4), Phase(Dwell(), 0.0, 0.1)], 2e-3)
    drive = Drive(Load(0.8, 3.0), Transmission(1 / 8, 0.85), Motor(2e-3))
    time = np.linspace(1e-3, 0.5, 200)
    motion = sizing.motion.at(time)
    assert sizing.operating_points(time).torque == pytest.approx(drive.motor_torque(motion.y1, motion.y2), rel=1e-12)


def test_a_descending_load_drives_the_motor():
    machine = conveyor(0.15, 1.0, 10, Slide(150, slope=radians(-20)), reduction=50, efficiency=0.9)
    sizing = Sizing(machine, [Phase(thirds(0.1, 0.8, 0.1), 0.5, 30)], 1e-3)
    level = {part.name: part.torque for part in sizing.parts}["uniform"]
    assert level == pytest.approx(-150 * 9.81 * math.sin(radians(20)) * 0.15 / 50 * 0.9, rel=1e-12)


def test_the_load_is_held_by_the_motor_or_by_a_brake():
    machine = lead_screw(500, 1e-5, Slide(6, 0.1, radians(90)), efficiency=0.5)
    phases = [Phase(Cycloidal(), 0.008, 0.2), Phase(Dwell(), 0.0, 0.1)]
    held = {holding: Sizing(machine, phases, 1e-5, holding=holding) for holding in ("motor", "brake")}
    assert held["brake"].parts[-1].torque == 0.0
    assert held["motor"].parts[-1].torque == pytest.approx(6 * 9.81 / (2 * math.pi * 500) / 0.5, rel=1e-12)
    assert held["motor"].rms_torque > held["brake"].rms_torque


def test_a_return_accelerates_towards_the_other_side():
    sizing = Sizing(TRAIN, [Phase(Cycloidal(), -6.0, 0.3)], 1e-4)
    by_name = {part.name: part.torque for part in sizing.parts}
    assert by_name["accelerating"] < by_name["uniform"] < by_name["decelerating"]


def test_motor_inertia_of_a_ratio():
    assert motor_inertia(TRAIN, 4.0) == pytest.approx(TRAIN.inertia() / 4, rel=1e-14)
    assert motor_inertia(TRAIN, 4.0, "document") == pytest.approx(TRAIN.inertia(losses=True) / 4, rel=1e-14)


def test_derating_is_one_up_to_the_rated_temperature_and_falls_to_zero():
    assert derating(25) == 1.0
    assert derating(-10) == 1.0
    assert derating(60, limit=155, rated_at=40) == pytest.approx(math.sqrt(95 / 115), rel=1e-14)
    assert derating(155 - 1e-9, limit=155) == pytest.approx(0.0, abs=1e-5)


def test_reserve_uses_the_derated_torque():
    sizing = Sizing(TRAIN, there_and_back(Cycloidal(), Cycloidal()), 1e-4)
    motor = Motor(1e-4, rated_torque=sizing.rms_torque * 1.01, peak_torque=20.0, max_speed=1000.0)
    assert [check.ok for check in sizing.reserve(motor)] == [True, True, True]
    assert [check.ok for check in sizing.reserve(motor, derating(45))] == [False, True, True]


def test_thirds_are_thirds():
    assert (thirds().rise_end, thirds().fall_start) == pytest.approx((1 / 3, 2 / 3), rel=1e-15)
    assert thirds(0.5, 0.0, 0.5).coefficients.cv == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: thirds(0.2, 0.2, 0.2), "expected a sum of 1"),
        (lambda: motor_inertia(TRAIN, 0.0), "inertia ratio is 0"),
        (lambda: derating(180), "180 °C, rated at 25 °C; expected less than the limit, 175 °C"),
        (lambda: Sizing(TRAIN, [], 1e-4), "no phases"),
        (lambda: Sizing(TRAIN, [Phase(Cycloidal(), 1, 1)], -1.0), "motor: inertia is -1"),
        (lambda: Sizing(TRAIN, [Phase(Cycloidal(), 1, 1)], 1.0, "exact"), "method is 'exact'"),
        (lambda: Sizing(TRAIN, [Phase(Cycloidal(), 1, 1)], 1.0, holding="hand"), "holding is 'hand'"),
        (
            lambda: Sizing(
                TRAIN, [Phase(PieceLaw([Piece(0.5, (-4.0, 0, 0, 0)), Piece(0.5, (12.0, 0, 0, 0))]), 1, 1)], 1.0
            ),
            "phase 1: Own law moves backwards",
        ),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
