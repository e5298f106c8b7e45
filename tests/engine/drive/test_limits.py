"""Limits, and the highest rate that holds them: against closed forms, samples and its own meaning."""

import math
import random
from dataclasses import replace
from math import pi

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Load, Motor, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.limits import BELOW, NO_LIMITS, LimitChecks, ReducerLimits, at_speed
from engine.drive.motor import LEVEL, TorqueFall
from engine.drive.rate_estimates import power_through, use_below
from engine.drive.rate_range import rate_range
from engine.drive.results import DriveResults
from engine.laws import Dwell, law
from engine.motion import Motion
from tests.engine.drive.machines import LINKAGES, SIZES, drive_cycle_of, sampled
from tests.tiers import nights, seed

TURN = 2 * pi


MASS = Load(2.0)


def judged(motor, reducer=NO_LIMITS, load=MASS, inertia=1e-3, speed=20.0, gears=()):
    motion = Motion.from_edges([0, 1, 2, TURN], [0.1, -0.1, 0], [law("CIC"), law("CIC"), Dwell()])
    drive = Drivetrain(KINDS["belt"].of(load, 0.05, gears=gears), inertia)
    return LimitChecks(DriveCycle(drive, motion, speed), motor, reducer)


def checked(one):
    return {check.name: check for check in one.checks}


def test_every_limit_is_checked_in_its_unit():
    gears = [Stage("gear", 4.0, 0.9)]
    one = judged(Motor(1e-3, 3.0, 9.0, 900.0), ReducerLimits(40.0, 20.0, 400.0), gears=gears)
    found, results = checked(one), DriveResults(one.drive_cycle)
    assert found["RMS torque"].value == results.rms_torque
    assert found["motor speed"].value == found["reducer input speed"].value == results.speed.peak
    assert found["reducer peak torque"].value == pytest.approx(results.shaft_torque(1).peak)
    assert found[BELOW].value == pytest.approx(results.torque.peak, rel=1e-9)
    assert found[BELOW].limit == pytest.approx(9.0)
    assert [check.limit for check in one.checks] == pytest.approx([3.0, 9.0, 900.0, 400.0, 40.0, 20.0])


def test_the_least_reserve_under_a_curve_against_samples():
    motor = Motor(1e-3, 100.0, 9.0, 200.0, falling=TorqueFall.between((60.0, 9.0), (200.0, 1.0)))
    one = judged(motor, speed=30.0)
    rows = sampled(one.drive_cycle, 40001)
    curve = [np.interp(np.abs(speed), [60.0, 200.0], [9.0, 1.0]) for _, speed, _ in rows]
    reserve = min(float((one - np.abs(row[2])).min()) for one, row in zip(curve, rows, strict=True))
    found = checked(one)[BELOW]
    assert found.limit - found.value == pytest.approx(reserve, abs=1e-6)
    assert found.limit - found.value <= reserve + 1e-9
    assert found.ok == (reserve >= 0)


def test_beyond_the_largest_speed_the_speed_fails_and_not_the_curve():
    one = judged(Motor(1e-3, 100.0, 900.0, 50.0, falling=TorqueFall.between((40.0, 900.0), (50.0, 800.0))))
    assert checked(one)[BELOW].ok
    assert checked(one)["motor speed"].limit == 50.0
    assert not one.ok
    assert one.worst.name == "motor speed"


# The range of rates


def test_the_highest_rate_of_a_speed_and_of_an_inertia_in_closed_form():
    one = judged(Motor(1e-3, math.inf, math.inf, 500.0))
    found = rate_range(one)
    assert found.high == pytest.approx(20.0 * 500.0 / DriveResults(one.drive_cycle).speed.peak, rel=1e-9)
    assert found.high_limit == "motor speed"
    other = judged(Motor(1e-3, 3.0))
    expected = 20.0 * math.sqrt(3.0 / DriveResults(other.drive_cycle).rms_torque)
    assert rate_range(other).high == pytest.approx(expected, rel=1e-9)


def test_where_nothing_binds_and_where_nothing_helps():
    assert rate_range(judged(Motor(1e-3))) == (0.0, math.inf, "", "")
    held = judged(Motor(1e-3, 1.0), load=Load(2.0, 500.0))
    assert rate_range(held) == (0.0, 0.0, "RMS torque", "RMS torque")


def limits_of(rng, drive_cycle):
    """Limits near to what a cycle asks for, below and above."""
    results = DriveResults(drive_cycle)

    def near(value):
        return max(value, 1e-6) * rng.uniform(0.7, 2.5) if rng.random() < 0.7 else math.inf

    peak, fastest = (
        max(results.torque.peak, 1e-3) * rng.uniform(0.8, 2),
        max(results.speed.peak, 1e-3) * rng.uniform(0.8, 3),
    )
    rated, stall = near(results.rms_torque), results.rms_torque * rng.uniform(0.5, 4.0)
    falling = TorqueFall.between((0.4 * fastest, peak), (fastest, rng.uniform(0.2, 1) * peak))
    speed = rng.uniform(0.3, 1.0) * fastest
    motor = Motor(1e-3, rated, peak, fastest, stall, speed, falling=rng.choice([falling, LEVEL]))
    reducer = ReducerLimits(near(results.shaft_torque(1).peak), near(results.mean_shaft_torque(1)), near(fastest))
    return motor, reducer


@pytest.mark.parametrize("number", [*range(3), *nights(15)])
def test_at_the_highest_rate_all_hold_and_above_it_the_named_one_fails(request, number):
    told = f"rate {number}"
    told = seed(told) if request.node.get_closest_marker("nightly") else told
    drive_cycle = drive_cycle_of(told, kinds=list(SIZES) if number < 2 else [*SIZES, *LINKAGES])
    one = LimitChecks(drive_cycle, *limits_of(random.Random(told), drive_cycle))
    found = rate_range(one)
    if found.high == 0.0:
        assert not at_speed(one, drive_cycle.speed * 1e-5).ok
        return
    assert found.high < math.inf
    there, above = at_speed(one, found.high), at_speed(one, found.high * 1.001)
    assert all(check.ok for check in there.checks)
    assert not checked(above)[found.high_limit].ok
    assert checked(there)[found.high_limit].use == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize("full", [0.5, 1.2, 9.0])
def test_beyond_its_cycles_a_reducer_s_torque_counts_over_the_factor(full):
    """S grows with the square of the rate, and meets T at N: T/4 at N/2. Up to ``full`` N no factor counts."""
    free = judged(Motor(1e-3), reducer=ReducerLimits(40.0))
    meets = rate_range(free).high
    factored = ReducerLimits(40.0, full_rate=full * meets / TURN, cycle_factor=4.0)
    found = rate_range(judged(Motor(1e-3), reducer=factored))
    assert (found.high, found.high_limit) == (pytest.approx(min(1.0, full) * meets, rel=1e-8), "reducer peak torque")
    early = replace(factored, full_rate=0.3 * meets / TURN)
    assert rate_range(judged(Motor(1e-3), reducer=early)).high == pytest.approx(meets / 2, rel=1e-8)
    assert (factored.peak_at(factored.full_rate), factored.peak_at(1.001 * factored.full_rate)) == (40.0, 10.0)


def test_limits_that_cannot_be_are_refused():
    for name in ("peak_torque", "mean_torque", "input_speed", "full_rate", "cycle_factor"):
        with pytest.raises(ValueError, match=name):
            ReducerLimits(**{name: 0.0})


@pytest.mark.parametrize("factor", [4e-8, 0.98, 1.02, 50.0])
def test_a_use_that_does_not_grow_from_standstill_tells_the_same_power_whatever_its_last_digits(factor):
    near = [0.7 + k * math.ulp(0.7) for k in range(-8, 9)]
    powers = [power_through(use_below(0.7, use, 2.5), use, 2.5, factor) for use in near]
    assert powers == pytest.approx([powers[0]] * len(near), rel=1e-12)
