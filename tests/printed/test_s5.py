"""Equations (4) to (20) of S5, 'A unified design procedure for flying machining operations'.

The document prints no numbers: the figures here are its equations, written out for one machine.
"""

from math import pi, radians, sqrt

import numpy as np
import pytest

from engine.drive import Motor
from engine.flying.cut import Cut, rotary_drum
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.simple import Cycloidal
from engine.selection.task import Task, accelerating_factor
from tests.engine.selection.tasks import inertial_task, motors_of, rms_torque

RADIUS, LINE, INERTIA = 0.12, 1.5, 0.02
DRUM = rotary_drum(3, RADIUS, radians(30))
L0, LT = 2 * pi / 3 * RADIUS, pi / 6 * RADIUS
SHORT, LONG = 0.18, 0.32
LAWS = [(Cycloidal(), 2.0, 2 * pi, pi * sqrt(2)), (ModifiedTrapezoidal(), 2.0, 8 * pi / (2 + pi), 4.233239)]


@pytest.mark.parametrize("length", [SHORT, LONG])
def test_lengths_times_and_displacement(length):
    cut = Cut(DRUM, length, LINE, Cycloidal())
    assert (DRUM.design_length, DRUM.tool_length) == pytest.approx((L0, LT), rel=1e-14)
    assert DRUM.repositioning_length == pytest.approx(L0 - LT, rel=1e-14)
    assert cut.cycle_time == pytest.approx(length / LINE, rel=1e-14)
    assert cut.tool_time == pytest.approx(LT / LINE, rel=1e-14)
    assert cut.repositioning_time == pytest.approx((length - LT) / LINE, rel=1e-14)
    assert cut.displacement == pytest.approx(L0 - length, rel=1e-14)


@pytest.mark.parametrize(("law", "cv", "ca", "ca_rms"), LAWS, ids=["CIC", "MTP"])
@pytest.mark.parametrize("length", [SHORT, LONG])
def test_equations_10_to_13(law, cv, ca, ca_rms, length):
    cut = Cut(DRUM, length, LINE, law)
    rest, h = length - LT, L0 - length
    assert cut.speed_change == pytest.approx(cv * h / rest * LINE, rel=1e-12)
    assert cut.max_acceleration == pytest.approx(ca * abs(h) / rest**2 * LINE**2, rel=1e-12)
    assert cut.max_angular_acceleration == pytest.approx(ca * abs(h) / rest**2 * LINE**2 / RADIUS, rel=1e-12)
    rms = ca_rms * abs(h) / rest**2 * sqrt(rest / length) * LINE**2
    assert cut.rms_acceleration == pytest.approx(rms, rel=2e-7)
    assert cut.rms_angular_acceleration == pytest.approx(rms / RADIUS, rel=2e-7)


def test_three_cases_by_the_sign_of_h():
    changes = [Cut(DRUM, length, LINE, Cycloidal()).speed_change for length in (SHORT, L0, LONG)]
    assert changes[0] > changes[1] == 0.0 > changes[2]  # faster, constant speed, slower
    assert Cut(DRUM, L0, LINE, Cycloidal()).rms_acceleration == pytest.approx(0.0, abs=1e-12)


def test_limit_length_brings_the_drum_to_standstill():
    limit = Cut(DRUM, LONG, LINE, Cycloidal()).limit_length
    assert limit == pytest.approx(2 * L0 - LT, rel=1e-14)
    assert Cut(DRUM, limit, LINE, Cycloidal()).speed_range[0] == pytest.approx(0.0, abs=1e-12)


def task_of_the_drum(line=LINE):
    cut = Cut(DRUM, SHORT, line, Cycloidal())
    return inertial_task(INERTIA, cut.rms_angular_acceleration, cut.max_angular_speed)


def test_equation_19_is_13_in_17():
    cut = Cut(DRUM, SHORT, LINE, Cycloidal())
    shape = (L0 - SHORT) ** 2 / (SHORT * (SHORT - LT) ** 3)
    beta = 4 * INERTIA * (pi * sqrt(2) * LINE**2 / RADIUS) ** 2 * shape
    assert task_of_the_drum().load_factor == pytest.approx(beta, rel=1e-12)
    assert task_of_the_drum().load_factor == pytest.approx(4 * INERTIA * cut.rms_angular_acceleration**2, rel=1e-14)


def test_at_both_ends_of_14_the_rms_torque_is_the_rated_one():
    task = Task(acceleration_rms=300.0, torque_rms=9.0, power_rate_mean=1100.0, max_speed=30.0)
    found = task.ratio_ranges(motors_of([5.0, 12.0], [8e-4, 3e-3], [500.0, 400.0]))
    for tau in (found.tau_min, found.tau_max):
        assert rms_torque(task, [8e-4, 3e-3], tau) == pytest.approx([5.0, 12.0], rel=1e-12)
    assert found.tau_opt == pytest.approx(np.sqrt(found.tau_min * found.tau_max), rel=1e-12)
    assert found.tau_limit == pytest.approx([30 / 500, 30 / 400], rel=1e-14)


def test_equation_16_bounds_the_same_motors():
    task = Task(300.0, 9.0, 1100.0, 30.0)
    tau, inertia = np.geomspace(0.005, 1.0, 200), 8e-4
    bracket = task.torque_rms * tau / sqrt(inertia) - task.acceleration_rms * sqrt(inertia) / tau
    alpha = task.load_factor + bracket**2
    assert np.sqrt(alpha * inertia) == pytest.approx(rms_torque(task, inertia, tau), rel=1e-12)


def test_equations_18_and_20_with_their_roots():
    task, inertia = task_of_the_drum(), 1.2e-3
    found = task.ratio_ranges(motors_of(sqrt(3.0 * task.load_factor * inertia), inertia, 600.0))
    assert found.accelerating_factor / task.load_factor == pytest.approx(3.0, rel=1e-12)
    optimum = sqrt(inertia / INERTIA)
    assert found.tau_max == pytest.approx(optimum * (sqrt(3.0) + sqrt(2.0)), rel=1e-12)
    assert found.tau_min == pytest.approx(optimum * (sqrt(3.0) - sqrt(2.0)), rel=1e-12)
    assert found.tau_max - found.tau_min == pytest.approx(2 * optimum * sqrt(2.0), rel=1e-12)
    assert found.tau_opt == pytest.approx(optimum, rel=1e-12)


def test_figure_12_is_18_and_closes_where_beta_reaches_alpha():
    alpha = float(accelerating_factor(4.0, 1e-3))
    task = inertial_task(INERTIA, sqrt(0.05 * alpha / 4 / INERTIA), 1.0)
    curves = task.ratio_curves(Motor(1e-3, 4.0), 1.0, 40, (0.001, 0.1))
    k, optimum = alpha / curves.load_factor, sqrt(1e-3 / INERTIA)
    assert k[[0, -1]] == pytest.approx([20.0, 1.0], rel=1e-12)
    spread = np.sqrt(np.maximum(k - 1.0, 0.0))
    assert curves.tau_max == pytest.approx(optimum * (np.sqrt(k) + spread), rel=1e-7)
    assert curves.tau_min == pytest.approx(optimum * (np.sqrt(k) - spread), rel=1e-7)
    assert curves.tau_opt == pytest.approx(np.full(40, optimum), rel=1e-12)
    assert np.diff(curves.tau_max - curves.tau_min).max() < 0.0
    assert curves.tau_min[-1] == pytest.approx(curves.tau_max[-1], rel=1e-12)


@pytest.mark.parametrize("efficiency", [1.0, 0.8, 0.5])
def test_with_losses_a_motor_needs_alpha_of_beta_over_eta(efficiency):
    task = Task(300.0, 9.0, 1100.0, 30.0)
    needed = sqrt(task.load_factor / efficiency * 1e-3)
    found = task.ratio_ranges(motors_of(np.array([0.999999, 1.000001]) * needed, 1e-3, 1e4), efficiency)
    assert found.accepted.tolist() == [False, True]
    assert rms_torque(task, 1e-3, found.tau_opt[1], efficiency) == pytest.approx(needed, rel=1e-12)
