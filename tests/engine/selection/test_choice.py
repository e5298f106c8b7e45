"""The load's task, the ratios that motors accept for it, catalogues and torque–speed curves."""

import math
from dataclasses import astuple, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from engine.drive import Load, Motor
from engine.drive.motor import STANDSTILL
from engine.laws import Dwell, Piece, PieceLaw
from engine.laws.simple import Cycloidal
from engine.motion import Motion, Phase
from engine.selection.catalogue import Motors, Reducers
from engine.selection.task import Task, accelerating_factor
from tests.engine.selection.tasks import motors_of, rms_torque, sampled_task

TASK = Task(acceleration_rms=300.0, torque_rms=9.0, power_rate_mean=1100.0, max_speed=30.0)
AT_REST = Task(acceleration_rms=0.0, torque_rms=9.0, power_rate_mean=0.0, max_speed=30.0)
UNFINISHED = PieceLaw([Piece(1.0, (1.0, 0.0, 0.0, 0.0))])


def motors(n=40, seed=3):
    rng = np.random.default_rng(seed)
    rated = np.geomspace(0.3, 40.0, n)
    inertia = 6e-5 * rated**1.6 * rng.lognormal(0, 0.4, n)
    names = tuple(f"M{k}" for k in range(n))
    return Motors(names, inertia, rated, 3 * rated, rng.uniform(200, 600, n), rng.uniform(1, 9, n), rated * 100)


@given(st.floats(1, 1e3), st.floats(0.1, 1e2), st.floats(-1, 1), st.floats(0.3, 1), st.floats(1e-5, 1e-1))
def test_rms_torque_has_its_minimum_at_tau_opt(acceleration, torque, correlation, efficiency, inertia):
    task = Task(acceleration, torque, correlation * acceleration * torque, 1.0)
    best = task.ratio_ranges(motors_of(1e6, inertia, 1e6), efficiency).tau_opt
    least = rms_torque(task, inertia, best, efficiency)
    around = rms_torque(task, inertia, best * np.array([0.9, 1.1]), efficiency)
    assert (around >= least).all()
    needed = task.load_factor / efficiency
    assert least**2 / inertia == pytest.approx(needed, rel=1e-6, abs=1e-9 * acceleration * torque / efficiency)


def test_a_motor_below_beta_is_rejected_whatever_the_ratio():
    weak = 0.99 * math.sqrt(TASK.load_factor * 1e-3)
    found = TASK.ratio_ranges(motors_of([weak], 1e-3, 1e4))
    assert found.accelerating_factor[0] < TASK.load_factor
    assert np.isnan(found.tau_min[0])
    assert not found.accepted[0]
    assert rms_torque(TASK, 1e-3, np.geomspace(1e-3, 10, 999)).min() > weak


def test_a_motor_that_is_too_slow_is_not_accepted():
    torque, inertia = 12.0, 3e-3
    found = TASK.ratio_ranges(motors_of(torque, inertia, [1e4, 15.0]))
    assert found.accepted.tolist() == [True, False]
    assert found.tau_max[1] < found.lowest[1] == 2.0


def test_for_a_load_at_rest_nothing_is_found():
    m = motors()
    found = AT_REST.ratio_ranges(m)
    assert not AT_REST.moves
    assert AT_REST.load_factor == 0.0
    assert not found.accepted.any()
    assert not found.strong.any()
    assert np.isnan([found.tau_min, found.tau_max, found.tau_opt, found.tau_limit, found.lowest]).all()
    assert found.accelerating_factor == pytest.approx(accelerating_factor(m.rated_torque, m.inertia))
    curves = AT_REST.ratio_curves(Motor(1e-3, 5.0), 1.0, 9, (0.01, 0.1))
    assert np.isnan([curves.tau_min, curves.tau_opt, curves.tau_max]).all()
    assert (curves.rate_factor == 0.0).all()


@pytest.mark.parametrize("efficiency", [1.0, 0.8])
def test_curves_against_the_load_factor_are_the_ranges_at_each_pace(efficiency):
    rated, inertia = 12.0, 3e-3
    alpha = float(accelerating_factor(rated, inertia))
    curves = TASK.ratio_curves(Motor(inertia, rated), efficiency, 20, (0.001, 0.1))
    assert curves.share[[0, -1]] == pytest.approx([min(0.1, TASK.load_factor / efficiency / alpha), 1.0])
    assert (np.diff(curves.share) > 0.0).all()
    for k in range(19):
        p = curves.rate_factor[k]
        task = Task(300.0 * p, 9.0 * p, 1100.0 * p**2, 30.0)
        found = task.ratio_ranges(motors_of(rated, inertia, 1e4), efficiency)
        assert task.load_factor == pytest.approx(curves.load_factor[k], rel=1e-12)
        assert (curves.tau_min[k], curves.tau_max[k]) == pytest.approx((found.tau_min[0], found.tau_max[0]), rel=1e-9)
        assert (curves.root[k], curves.wide[k]) == pytest.approx((found.root[0], found.wide[0]), rel=1e-9)
    assert curves.tau_min[-1] == pytest.approx(curves.tau_max[-1], rel=1e-12)
    assert curves.tau_opt == pytest.approx(np.sqrt(curves.tau_min * curves.tau_max), rel=1e-12)


@pytest.mark.parametrize(("rated", "first"), [(0.1, 0.1), (1e4, 0.001)])
def test_curves_begin_within_the_shares_given(rated, first):
    assert TASK.ratio_curves(Motor(1e-3, rated), 1.0, 9, (0.001, 0.1)).share[0] == pytest.approx(first)


@pytest.mark.parametrize("resists", ["always", "moving"])
def test_task_of_a_load_is_that_of_its_samples(resists):
    load = Load(0.05, 4.0) if resists == "always" else Load(0.05, friction=4.0)
    phases = [Phase(Cycloidal(), 0.2, 0.3), Phase(Dwell(), 0.0, 0.2), Phase(Cycloidal(), -0.2, 0.4)]
    time = np.linspace(0.0, 0.9, 90001)
    _, y1, y2, _ = Motion(phases).at(time)
    w, dw = y1 / 0.1, y2 / 0.1
    sampled = sampled_task(time, w, dw, load.resisting(np.where(np.abs(w) < STANDSTILL, 0.0, np.sign(w))) + 0.05 * dw)
    exact = Task.of_load(load, [replace(one, lift=one.lift / 0.1) for one in phases])
    assert astuple(exact) == pytest.approx(astuple(sampled), rel=1e-4)


def test_knee_and_fall_are_those_of_the_curve():
    m = Motors(
        ("level", "falling"), 1e-3, 2.0, np.array([6.0, 8.0]), 300.0,
        full_torque_to=np.array([np.nan, 100.0]), end_torque=np.array([np.nan, 4.0]),
    )  # fmt: skip
    assert m.knee.tolist() == [300.0, 100.0]
    assert m.fall == pytest.approx([0.0, 0.02])
    between = np.interp([100.0, 200.0, 300.0], [0.0, 100.0, 300.0], [8.0, 8.0, 4.0])
    assert between == pytest.approx(8.0 - m.fall[1] * np.array([0.0, 100.0, 200.0]))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Task(-1.0, 1.0, 0.0, 1.0), "acceleration_rms is -1; expected a finite number, 0 or more"),
        (lambda: Task(1.0, 1.0, 2.0, 1.0), "power_rate_mean is 2; expected −1 to 1"),
        (lambda: Task.of_load(Load(1.0, 0.0), []), "0 phases"),
        (
            lambda: Task.of_load(Load(1.0, 0.0), [Phase(UNFINISHED, 1.0, 1.0)]),
            "phase 1: Own law does not begin and end",
        ),
        (lambda: TASK.ratio_ranges(motors(), efficiency=1.1), "efficiency is 1.1"),
        (lambda: Motors(("A", "B"), 1e-3, np.array([1.0, -2.0]), 3.0, 400.0), "motor 'B': rated_torque is -2"),
        (lambda: Motors(("A", "B"), np.ones(3), 1.0, 3.0, 400.0), "2 motors are named and 3 values of inertia given"),
        (
            lambda: Reducers(("A",), 10.0, 1.2, 0.0, 1.0, 1.0),
            "reducer 'A': efficiency is 1.2; expected a number at most 1",
        ),
        (
            lambda: Reducers(("A",), 10.0, 0.9, -1.0, 1.0, 1.0),
            "reducer 'A': inertia is -1; expected a number 0 or more",
        ),
        (lambda: Motors(("A",), 1e-3, 1.0, 2.0, 9.0, end_torque=1.0), "motor 'A': end_torque is 1"),
        (
            lambda: Motors(("A",), 1e-3, 1.0, 2.0, 9.0, full_torque_to=9.0, end_torque=1.0),
            "full_torque_to is 9; expected a number below max_speed",
        ),
        (lambda: Motors(("A",), 1e-3, 1.0, 2.0, 9.0, size=-1.0), "size is -1; expected a number 0 or more"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
