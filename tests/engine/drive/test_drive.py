"""The drive: reflected inertia, load, losses both ways, energy over a cycle, RMS in closed form, limits."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from engine.drive import (
    KINDS,
    NEAR,
    STANDSTILL,
    Drive,
    Load,
    Motor,
    Part,
    Stage,
    resisting,
)
from engine.drive.motor import TorqueFall, reserve
from engine.laws import Cubic, Cycloidal, Dwell, ModifiedTrapezoidal, Piece, PieceLaw
from engine.motion import Motion, Phase
from tests.engine.sizing import (
    OperatingPoints,
    Sizing,
    direction,
    effective_inertia,
    from_shaft,
    lossless_rms,
    operating_points,
    reduced,
)

RADIUS = 0.134
ROLLERS = KINDS["feed rollers"]
PHASES = [
    Phase(ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1)), 0.3, 0.2),
    Phase(Dwell(), 0.0, 0.1),
    Phase(Cubic(), -0.2, 0.15),
    Phase(Dwell(), 0.0, 0.15),
]
MOTOR = Motor(0.0065, rated_torque=60.0, peak_torque=160.0, max_speed=300.0)


def drive(torque=67.0, resists="always", ratio=1 / 8, efficiency=1.0, motor=MOTOR):
    """S1's feeding group behind a reducer: J_tot = 1.164 kg m² and C_r = ``torque`` at the rollers."""
    gears, parts = [Stage("reducer", 1 / ratio, efficiency)], [Part("rollers", 1.164, 1)]
    chain = ROLLERS.of(resisting(torque / RADIUS, resists), RADIUS, gears=gears, parts=parts)
    return Drive(chain, motor.inertia)


LOSSY = Stage("gear", 1.0, 0.8)


def at_rollers(one, w, dw):
    """Direction, resisting torque, total torque and loss factor for speeds and accelerations of the rollers."""
    going = direction(w)
    load = one.mechanism.load.resisting(going) / one.mechanism.ratio_from(1)
    total = one.mechanism.torques(np.multiply(dw, RADIUS), going, one.method)[1]
    return going, load, total, one.mechanism.stages[0].factor(total, going)


def torque(one, w, dw):
    return one.torque(np.multiply(dw, RADIUS), direction(w))


def sampled(phases=PHASES, n=400_000):
    """Time, roller speed and acceleration over the phases."""
    motion = Motion(phases)
    time = np.linspace(0.0, motion.total, n + 1)
    at = motion.at(time)
    return time, at.y1 / RADIUS, at.y2 / RADIUS


def points_of(one, phases=PHASES, n=400_000):
    time, w, dw = sampled(phases, n)
    return operating_points(one, w * RADIUS, dw * RADIUS, direction(w), time)


def exact_rms(one, phases=PHASES):
    """The RMS torque in closed form, for an efficiency of 1."""
    behind = from_shaft(one.mechanism, 1)
    ratio = one.mechanism.stages[0].ratio
    return lossless_rms(behind, phases, effective_inertia(one, 1) * ratio) / ratio


def test_reflected_inertia_weighs_with_the_square_of_speed():
    fast = Part("fast shaft", 0.007, speed_ratio=90 / 45)
    parts = [Part("rollers", 0.284, count=4), fast, Part("slow", 1.0, count=3, speed_ratio=0.1)]
    assert math.fsum(part.reflected for part in parts) == pytest.approx(4 * 0.284 + 4 * 0.007 + 0.03, rel=1e-15)


def test_a_geared_part_counts_on_its_shaft_and_at_the_motor():
    parts = [Part("rollers", 0.284, 1, 4), Part("fast shaft", 0.007, 1, 1, 90 / 45)]
    chain = ROLLERS.of(resisting(500.0, "always"), RADIUS, gears=[Stage("reducer", 8.0)], parts=parts)
    assert chain.on_shaft(1) == pytest.approx(1.164, rel=1e-15)
    assert chain.inertia() == pytest.approx(1.164 / 64, rel=1e-15)


def test_load_that_always_resists_acts_at_rest_too():
    assert at_rollers(drive(), [-2.0, 0.0, 2.0], 0.0)[1] == pytest.approx([67.0, 67.0, 67.0], rel=1e-15)


def test_load_that_resists_moving_turns_with_the_motion_and_is_zero_at_standstill():
    speeds = [-2.0, -STANDSTILL / 2, 0.0, STANDSTILL / 2, 2.0]
    found = at_rollers(drive(resists="moving"), speeds, 0.0)[1]
    assert found == pytest.approx([-67.0, 0.0, 0.0, 0.0, 67.0], rel=1e-15)


def test_torque_is_the_documents_equation_without_losses():
    d, dw = drive(), np.array([-500.0, 0.0, 300.0])
    expected = 0.0065 * 8 * dw + (67.0 + 1.164 * dw) / 8
    assert torque(d, np.array([1.0, 1.0, -1.0]), dw) == pytest.approx(expected, rel=1e-14)
    assert effective_inertia(d, 1) == pytest.approx(0.0065 * 8 + 1.164 / 8)
    assert d.mechanism.inertia() == pytest.approx(1.164 / 64)
    assert operating_points(d, 3.0 * RADIUS, 0.0).speed == pytest.approx(24.0, rel=1e-15)


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
    assert at_rollers(d, w, dw)[3] == factor
    load_side = (67.0 + 1.164 * dw) / 8
    assert torque(d, w, dw) == pytest.approx(0.0065 * 8 * dw + load_side * factor, rel=1e-14)


@pytest.mark.parametrize(
    ("torque", "going", "factor"),
    [
        (0.0, 1.0, 1 / 0.8),
        (-NEAR / 2, 1.0, 1 / 0.8),  # rounding
        (NEAR / 2, -1.0, 1 / 0.8),
        (-2 * NEAR, 1.0, 0.8),
        (2 * NEAR, -1.0, 0.8),
        (-2 * NEAR, 0.0, 1 / 0.8),
    ],
)
def test_rounding_never_decides_the_losses(torque, going, factor):
    assert LOSSY.factor(torque, going) == factor
    assert LOSSY.factor(torque, going, "document") == 1 / 0.8


def test_the_document_counts_losses_against_the_motor_always():
    chain = drive(efficiency=0.8).mechanism
    documented = Drive(chain, 0.0, "document")
    assert documented.torque(-100.0 * RADIUS, 1.0) == pytest.approx((67.0 - 116.4) / 8 / 0.8, rel=1e-14)


@given(
    st.floats(-50, 50), st.floats(-2000, 2000), st.floats(0, 200), st.floats(0.05, 1), st.floats(0.01, 20),
    st.sampled_from(["always", "moving"]),
)  # fmt: skip
def test_power_is_lost_never_won(w, dw, resistance, efficiency, ratio, resists):
    """What enters the transmission less what leaves it is (1 − η) of what enters, whichever way it flows."""
    assume(abs(w) >= STANDSTILL)
    d = drive(resistance, resists, ratio, efficiency)
    going, _, total, _ = at_rollers(d, w, dw)
    out = float(total) * w
    assume(total * going >= 0 or total * going < -NEAR)
    power = float(operating_points(d, w * RADIUS, dw * RADIUS, going).power)
    enters = power - MOTOR.inertia * dw / ratio * w / ratio
    room = 1e-9 * (1 + abs(enters) + abs(out) + abs(power))
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
    _, resistance, total, _ = at_rollers(d, w, dw)
    load, through = resistance * w, total * w
    lost = np.where(through > 0, through * (1 / efficiency - 1), -through * (1 - efficiency))
    energy, work, losses = (np.trapezoid(p, time) for p in (points_of(d).power, load, lost))
    assert energy == pytest.approx(work + losses, rel=1e-5)
    path = 0.1 if resists == "always" else 0.5  # m: there less back, there and back
    assert work == pytest.approx(67.0 / RADIUS * path, rel=1e-5)
    assert (losses > 0) == (efficiency < 1)


@pytest.mark.parametrize("resists", ["always", "moving"])
@pytest.mark.parametrize("resistance", [0.0, 67.0])
def test_exact_rms_is_what_dense_samples_show(resists, resistance):
    d = drive(resistance, resists)
    assert exact_rms(d) == pytest.approx(points_of(d).rms_torque, rel=1e-5)


@pytest.mark.parametrize("resists", ["always", "moving"])
@pytest.mark.parametrize("resistance", [0.0, 67.0])
def test_exact_rms_is_that_of_the_cycle_by_phases(resists, resistance):
    """Two closed forms: mean squares of the whole cycle, and T = A a + B integrated phase by phase."""
    d = drive(resistance, resists)
    assert exact_rms(d) == pytest.approx(Sizing(d.mechanism, PHASES, d.motor_inertia).rms_torque, rel=1e-13)


@pytest.mark.parametrize("resists", ["always", "moving"])
def test_exact_rms_of_phases_that_do_not_end_at_rest(resists):
    """The mixed term ⟨ω̇ C_r⟩ counts: thrown forward to a speed, then back to another one."""
    thrown = PieceLaw([Piece(1.0, (2.0, 0, 0, 0))])
    phases = [Phase(thrown, 0.3, 0.2), Phase(thrown, -0.1, 0.3), Phase(Cycloidal(), 0.1, 0.1)]
    d = drive(resists=resists)
    exact = Sizing(d.mechanism, phases, d.motor_inertia).rms_torque
    assert exact == pytest.approx(points_of(d, phases).rms_torque, rel=1e-4)


def test_exact_rms_leaves_the_efficiency_out():
    assert exact_rms(drive(efficiency=0.5)) == exact_rms(drive())


def test_a_mechanism_without_losses_is_reduced_to_one_load():
    one = reduced(drive().mechanism)
    assert (one.inertia, one.torque, one.friction) == pytest.approx((1.164 / 64, 67.0 / 8, 0.0), rel=1e-14)


def test_operating_points_tell_peak_speed_and_rms():
    torques, speed = np.array([3.0, -5.0, 1.0]), np.array([-7.0, 2.0, 4.0])
    points = OperatingPoints(speed, torques, torques * speed)
    assert (points.peak_torque, points.max_speed) == (5.0, 7.0)
    assert points.rms_torque == pytest.approx(math.sqrt((9 / 2 + 25 + 1 / 2) / 2))


def test_rms_counts_unequal_steps_by_their_time():
    torques = np.array([2.0, 2.0, 0.0, 0.0])
    points = OperatingPoints(torques, torques, torques, np.array([0.0, 3.0, 3.0, 4.0]))
    assert points.rms_torque == pytest.approx(math.sqrt(3.0))


def held(points, motor):
    return reserve(motor, points.rms_torque, points.peak_torque, points.max_speed, points.max_speed / 3)


def test_reserve_against_the_motors_limits():
    points = points_of(drive(), n=2000)
    found = held(points, MOTOR)
    assert [(c.name, c.limit) for c in found] == [("RMS torque", 60), ("peak torque", 160), ("speed", 300)]
    assert [c.value for c in found] == [points.rms_torque, points.peak_torque, points.max_speed]
    assert found.speed.reserve == 300 / points.max_speed
    weak = Motor(0.0065, points.rms_torque, points.peak_torque * 0.999, points.max_speed * 0.999)
    assert [c.ok for c in held(points, weak)] == [True, False, False]
    assert all(c.ok for c in held(points, Motor(0.0065)))
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
        (lambda: Part("roller", -0.1), "roller: inertia is -0.1"),
        (lambda: Part("roller", 0.1, speed_ratio=math.inf), "speed_ratio is inf"),
        (lambda: Load(-1.0), "load: inertia is -1"),
        (lambda: Load(1.0, math.nan), "torque is nan"),
        (lambda: Load(1.0, 0.0, math.inf), "friction is inf"),
        (lambda: resisting(1.0, "sometimes"), "resists is 'sometimes'; expected 'always' or 'moving'"),
        (lambda: drive(ratio=-0.1), "reducer: ratio is -10; expected a finite number above 0"),
        (lambda: drive(efficiency=0.0), "reducer: efficiency is 0; expected more than 0 and at most 1"),
        (lambda: drive(efficiency=1.1), "efficiency is 1.1"),
        (lambda: drive(motor=Motor(-1.0)), "motor: inertia is -1"),
        (lambda: Drive(drive().mechanism, -1.0), "motor: inertia is -1"),
        (lambda: Drive(drive().mechanism, 1.0, "exact"), "method is 'exact'"),
        (lambda: Drive(drive().mechanism, 1.0, holding="hand"), "holding is 'hand'"),
        (lambda: Motor(0.1, rated_torque=0.0), "motor: rated_torque is 0"),
        (lambda: Motor(0.1, max_speed=math.nan), "motor: max_speed is nan"),
    ],
)
def test_what_cannot_be_is_refused(made, message):
    with pytest.raises(ValueError, match=message):
        made()


def test_beside_a_large_torque_what_rounding_leaves_of_a_small_one_is_none():
    assert LOSSY.factor(-0.01, 1.0, near=3e9 * NEAR) == 1 / 0.8
    assert LOSSY.factor(-4.0, 1.0, near=3e9 * NEAR) == 0.8
