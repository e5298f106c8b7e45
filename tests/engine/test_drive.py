"""The drive: reflected inertia, load, losses both ways, energy over a cycle, exact RMS, limits."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from engine.drive import (
    RETURNED,
    STANDSTILL,
    Drive,
    Inertia,
    Load,
    Motor,
    OperatingPoints,
    Transmission,
    checks,
    reflected_inertia,
    rms_lossless,
)
from engine.laws import Cubic, Cycloidal, Dwell, ModifiedTrapezoidal, Piece, PieceLaw
from engine.motion import Motion, Phase

RADIUS = 0.134
PHASES = [
    Phase(ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1)), 0.3, 0.2),
    Phase(Dwell(), 0.0, 0.1),
    Phase(Cubic(), -0.2, 0.15),
    Phase(Dwell(), 0.0, 0.15),
]
MOTOR = Motor(0.0065, rated_torque=60.0, peak_torque=160.0, max_speed=300.0)


def drive(torque=67.0, resists="always", ratio=1 / 8, efficiency=1.0, motor=MOTOR):
    return Drive(Load(1.164, torque, resists), Transmission(ratio, efficiency), motor)


def sampled(phases=PHASES, n=400_000):
    """Time, roller speed and acceleration over the phases."""
    motion = Motion(phases)
    time = np.linspace(0.0, motion.total, n + 1)
    at = motion.at(time)
    return time, at.y1 / RADIUS, at.y2 / RADIUS


def test_reflected_inertia_weighs_with_the_square_of_speed():
    parts = [Inertia("rollers", 4, 0.284), Inertia("fast shaft", 1, 0.007, 2.0), Inertia("slow", 3, 1.0, 0.1)]
    assert reflected_inertia(parts) == pytest.approx(4 * 0.284 + 4 * 0.007 + 0.03, rel=1e-15)
    assert reflected_inertia([]) == 0.0


def test_load_that_always_resists_acts_at_rest_too():
    assert drive().load_torque([-2.0, 0.0, 2.0]).tolist() == [67.0, 67.0, 67.0]


def test_load_that_resists_moving_turns_with_the_motion_and_is_zero_at_standstill():
    speeds = [-2.0, -STANDSTILL / 2, 0.0, STANDSTILL / 2, 2.0]
    assert drive(resists="moving").load_torque(speeds).tolist() == [-67.0, 0.0, 0.0, 0.0, 67.0]


def test_torque_is_the_documents_equation_without_losses():
    d, dw = drive(), np.array([-500.0, 0.0, 300.0])
    expected = 0.0065 * 8 * dw + (67.0 + 1.164 * dw) / 8
    assert d.motor_torque(np.array([1.0, 1.0, -1.0]), dw) == pytest.approx(expected, rel=1e-14)
    assert d.effective_inertia == pytest.approx(0.0065 * 8 + 1.164 / 8)
    assert d.motor_speed(3.0) == 24.0


@pytest.mark.parametrize(
    ("w", "dw", "factor"),
    [
        (5.0, 10.0, 1 / 0.8),  # driving forward
        (-5.0, -100.0, 1 / 0.8),  # driving backward
        (5.0, -100.0, 0.8),  # braking forward
        (-5.0, 10.0, 0.8),  # braking backward
        (0.0, -100.0, 1 / 0.8),  # standing
        (STANDSTILL / 2, -100.0, 1 / 0.8),
    ],
)
def test_losses_add_when_driving_and_help_when_braking(w, dw, factor):
    d = drive(efficiency=0.8)
    assert d.loss_factor(w, dw) == factor
    load_side = (67.0 + 1.164 * dw) / 8
    assert d.motor_torque(w, dw) == pytest.approx(0.0065 * 8 * dw + load_side * factor, rel=1e-14)


@given(
    st.floats(-50, 50), st.floats(-2000, 2000), st.floats(0, 200), st.floats(0.05, 1), st.floats(0.01, 20),
    st.sampled_from(["always", "moving"]),
)  # fmt: skip
def test_power_is_lost_never_won(w, dw, torque, efficiency, ratio, resists):
    """What enters the transmission less what leaves it is (1 − η) of what enters, whichever way it flows."""
    assume(abs(w) >= STANDSTILL)
    d = drive(torque, resists, ratio, efficiency)
    out = float(d.total_load_torque(w, dw)) * w
    assume(out >= 0 or out < -RETURNED)
    enters = float(d.power(w, dw)) - MOTOR.inertia * dw / ratio * w / ratio
    room = 1e-9 * (1 + abs(enters) + abs(out) + abs(float(d.power(w, dw))))
    if out >= 0:
        assert enters * efficiency == pytest.approx(out, abs=room)
    else:
        assert enters == pytest.approx(out * efficiency, abs=room)
    assert enters - out >= -room


@pytest.mark.parametrize("resists", ["always", "moving"])
@pytest.mark.parametrize("efficiency", [1.0, 0.85])
def test_energy_over_a_cycle(resists, efficiency):
    """Motor energy = work against the load + losses; what the inertias take they give back."""
    d = drive(resists=resists, efficiency=efficiency)
    time, w, dw = sampled()
    load, through = d.load_torque(w) * w, d.total_load_torque(w, dw) * w
    lost = np.where(through > 0, through * (1 / efficiency - 1), -through * (1 - efficiency))
    energy, work, losses = (np.trapezoid(p, time) for p in (d.power(w, dw), load, lost))
    assert energy == pytest.approx(work + losses, rel=1e-5)
    path = 0.1 if resists == "always" else 0.5  # m: there less back, there and back
    assert work == pytest.approx(67.0 / RADIUS * path, rel=1e-5)
    assert (losses > 0) == (efficiency < 1)


@pytest.mark.parametrize("resists", ["always", "moving"])
@pytest.mark.parametrize("torque", [0.0, 67.0])
def test_exact_rms_is_what_dense_samples_show(resists, torque):
    d = drive(torque, resists)
    time, w, dw = sampled()
    points = d.operating_points(w, dw, time)
    assert rms_lossless(d, PHASES, RADIUS) == pytest.approx(points.rms_torque, rel=1e-5)


@pytest.mark.parametrize("resists", ["always", "moving"])
def test_exact_rms_of_phases_that_do_not_end_at_rest(resists):
    """The mixed term ⟨ω̇ C_r⟩ counts: thrown forward to a speed, then back to another one."""
    thrown = PieceLaw([Piece(1.0, (2.0, 0, 0, 0))])
    phases = [Phase(thrown, 0.3, 0.2), Phase(thrown, -0.1, 0.3), Phase(Cycloidal(), 0.1, 0.1)]
    d = drive(resists=resists)
    time, w, dw = sampled(phases)
    assert rms_lossless(d, phases, RADIUS) == pytest.approx(d.operating_points(w, dw, time).rms_torque, rel=1e-4)


def test_exact_rms_leaves_the_efficiency_out():
    assert rms_lossless(drive(efficiency=0.5), PHASES, RADIUS) == rms_lossless(drive(), PHASES, RADIUS)


@pytest.mark.parametrize(("phases", "radius"), [([], 0.1), (PHASES, 0.0), (PHASES, math.nan)])
def test_exact_rms_needs_phases_and_a_wheel(phases, radius):
    with pytest.raises(ValueError, match="expected a phase and a radius above 0"):
        rms_lossless(drive(), phases, radius)


def test_operating_points_tell_peak_lowest_speed_and_rms():
    torque, speed = np.array([3.0, -5.0, 1.0]), np.array([-7.0, 2.0, 4.0])
    points = OperatingPoints(speed, torque, torque * speed)
    assert (points.peak_torque, points.highest_torque, points.lowest_torque) == (5.0, 3.0, -5.0)
    assert points.max_speed == 7.0
    assert points.rms_torque == pytest.approx(math.sqrt((9 / 2 + 25 + 1 / 2) / 2))


def test_rms_counts_unequal_steps_by_their_time():
    torque = np.array([2.0, 2.0, 0.0, 0.0])
    points = OperatingPoints(torque, torque, torque, np.array([0.0, 3.0, 3.0, 4.0]))
    assert points.rms_torque == pytest.approx(math.sqrt(3.0))


def test_checks_against_the_motors_limits():
    time, w, dw = sampled(n=2000)
    d = drive()
    points = d.operating_points(w, dw, time)
    found = checks(points, MOTOR)
    assert [(c.name, c.limit) for c in found] == [("RMS torque", 60), ("peak torque", 160), ("speed", 300)]
    assert [c.value for c in found] == [points.rms_torque, points.peak_torque, points.max_speed]
    weak = Motor(0.0065, points.rms_torque, points.peak_torque * 0.999, points.max_speed * 0.999)
    assert [c.ok for c in checks(points, weak)] == [True, False, False]
    assert all(c.ok for c in checks(points, Motor(0.0065)))


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda: Inertia("roller", -1, 0.1), "roller: count is -1; expected a finite number, 0 or more"),
        (lambda: Inertia("roller", 1, -0.1), "roller: J is -0.1"),
        (lambda: Inertia("roller", 1, 0.1, math.inf), "speed_ratio is inf"),
        (lambda: Load(-1.0, 0.0), "load: inertia is -1"),
        (lambda: Load(1.0, math.nan), "torque is nan"),
        (lambda: Load(1.0, 1.0, "sometimes"), "resists is 'sometimes'; expected 'always' or 'moving'"),
        (lambda: Transmission(0.0), "ratio is 0; expected more than 0"),
        (lambda: Transmission(1.0, 0.0), "efficiency is 0; expected more than 0 and at most 1"),
        (lambda: Transmission(1.0, 1.1), "efficiency is 1.1"),
        (lambda: Motor(-1.0), "motor: inertia is -1"),
        (lambda: Motor(0.1, rated_torque=0.0), "motor: rated_torque is 0"),
        (lambda: Motor(0.1, max_speed=math.nan), "motor: max_speed is nan"),
    ],
)
def test_what_cannot_be_is_refused(made, message):
    with pytest.raises(ValueError, match=message):
        made()
