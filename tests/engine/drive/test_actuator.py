"""Sizing of actuators: torque with losses either way, exact peaks and RMS against fine samples, reserve."""

import math
from dataclasses import replace
from math import radians

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from engine.drive import KINDS, Drive, Load, Motor, Part, Slide, Stage, derating, resisting
from engine.laws import CATALOGUE, ConstantAcceleration, Cycloidal, Dwell, ModifiedTrapezoidal, Piece, PieceLaw
from engine.motion import Phase
from tests.engine.profiles import thirds
from tests.engine.sizing import Sizing, shafts

ASYMMETRIC = ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1))
laws = st.sampled_from([e() for e in CATALOGUE if e.code != "DWL"] + [ASYMMETRIC, thirds(0.1, 0.5, 0.4)])
STAGES = (Stage("first", 3.0, 0.8), Stage("second", 5.0, 0.7))


def train(stages=STAGES, torque=1.0, friction=0.5):
    """Two gears, with inertia on each shaft."""
    parts = [Part("pinion", 1e-4), Part("middle", 1e-3, 1)]
    return KINDS["gear train"].of(Load(0.05, torque, friction), gears=stages, parts=parts)


TRAIN = train()


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
    sizing = Sizing(train(torque=torque), there_and_back(law, other), 1e-4, method)
    assert sizing.rms_torque == pytest.approx(sampled_rms(sizing), rel=2e-4)
    points = sizing.operating_points(np.linspace(0, sizing.motion.total, 6001))
    assert points.peak_torque <= sizing.peak_torque * (1 + 1e-12)
    assert points.peak_torque == pytest.approx(sizing.peak_torque, rel=1e-3)
    assert points.max_speed == pytest.approx(sizing.max_speed, rel=1e-3)


@pytest.mark.parametrize("law", [Cycloidal(), ASYMMETRIC, ConstantAcceleration()], ids=lambda law: law.code)
def test_the_two_ways_to_the_rms_agree_where_nothing_is_lost(law):
    stages = [Stage("first", 3.0), Stage("second", 5.0)]
    exact = Sizing(train(stages), there_and_back(law, law), 1e-4)
    nearly = [Stage("first", 3.0, 1.0 - 1e-13), Stage("second", 5.0)]  # takes the way by stages
    by_stages = Sizing(train(nearly), there_and_back(law, law), 1e-4)
    assert by_stages.rms_torque == pytest.approx(exact.rms_torque, rel=1e-12)


def test_rms_is_exact_where_power_turns_round_within_a_stage():
    sizing = Sizing(TRAIN, [Phase(Cycloidal(), 6.0, 0.2)], 1e-4)
    assert sizing.rms_torque == pytest.approx(sampled_rms(sizing, 400001), rel=1e-9)


@pytest.mark.parametrize("method", ["physical", "document"])
def test_rms_of_a_law_that_does_not_end_at_rest(method):
    half = PieceLaw([Piece(1.0, (1.0, 0.0, 0.0, 0.0))])
    sizing = Sizing(TRAIN, [Phase(half, 6.0, 0.2)], 1e-4, method)
    torque = float(sizing.drive.torque(6.0 / 0.2**2, 1.0))
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
    assert Drive(TRAIN, 1e-4).torque(a, 1.0) == pytest.approx(at_motor, rel=1e-14)


def test_each_stage_helps_where_power_flows_back():
    a = -100.0
    behind = 1.0 + 0.5 + 0.05 * a
    middle = behind * 0.7 / 5 + 1e-3 * 5 * a
    at_motor = middle * 0.8 / 3 + (1e-4 + 1e-4) * 15 * a
    assert Drive(TRAIN, 1e-4).torque(a, 1.0) == pytest.approx(at_motor, rel=1e-14)


def test_power_is_lost_and_never_gained():
    sizing = Sizing(TRAIN, there_and_back(ASYMMETRIC, Cycloidal()), 1e-4)
    without = Sizing(train([Stage(s.name, s.ratio) for s in STAGES]), sizing.phases, 1e-4)
    time = np.linspace(0, sizing.motion.total, 2001)
    assert (sizing.operating_points(time).power >= without.operating_points(time).power - 1e-12).all()


def test_a_geared_table_is_s1_s_equation_with_losses():
    """C_m = (J_m/τ) ω̇_r + τ f (C_r + J_tot ω̇_r), written out."""
    table = KINDS["rotary table"].of(Load(0.2, 3.0), gears=[Stage("gear", 8.0, 0.85)], parts=[Part("table", 0.6, 1)])
    sizing = Sizing(table, [Phase(Cycloidal(), 1.0, 0.4), Phase(Dwell(), 0.0, 0.1)], 2e-3)
    time = np.linspace(1e-3, 0.5, 200)
    motion = sizing.motion.at(time)
    total = 3.0 + 0.8 * motion.y2
    f = np.where(total * motion.y1 >= 0, 1 / 0.85, 0.85)
    assert sizing.operating_points(time).torque == pytest.approx(2e-3 * 8 * motion.y2 + total * f / 8, rel=1e-12)


def test_the_rollers_of_the_cutting_machine_and_an_actuator_are_one_chain():
    """A reducer and a roller of radius R, or a conveyor of twice that diameter, without belt."""
    gears, parts, load = [Stage("reducer", 8.0, 0.9)], [Part("rollers", 0.3, 1, 4)], resisting(500.0, "moving")
    rollers = KINDS["feed rollers"].of(load, 0.134, gears=gears, parts=parts)
    belt = KINDS["conveyor"].of(load, 0.268, gears=gears, parts=parts)
    phases = there_and_back(ASYMMETRIC, Cycloidal())
    one, other = (Sizing(machine, phases, 0.0065) for machine in (rollers, belt))
    assert one.rms_torque == pytest.approx(other.rms_torque, rel=1e-14)
    time = np.linspace(0.0, one.motion.total, 500)
    assert one.operating_points(time).torque == pytest.approx(other.operating_points(time).torque, rel=1e-13)


@settings(max_examples=15)
@given(laws, laws, st.floats(-4.0, 4.0))
def test_energy_over_a_closed_cycle(law, other, torque):
    """∮ T dφ is the work of the load plus what each stage loses; the inertias give back what they take."""
    sizing = Sizing(train(torque=torque), there_and_back(law, other), 1e-4)
    machine, n = sizing.mechanism, 30000  # so that every jump of the laws lies between two samples
    turned = work = lost = 0.0
    for begin, end, phase in zip(sizing.motion.edges[:-1], sizing.motion.edges[1:], sizing.phases, strict=True):
        time = begin + (end - begin) / n * (np.arange(n) + 0.5)
        at, going = sizing.motion.at(time), sizing.going(time)
        each = shafts(sizing.drive, at.y1, at.y2, going)
        step = (end - begin) / n
        turned += float(sizing.operating_points(time).power.sum()) * step
        work += torque * phase.lift + 0.5 * abs(phase.lift)
        for k, stage in enumerate(machine.stages):
            behind = each[k + 1].torque * each[k + 1].speed
            lost += (
                float(np.where(behind > 0, behind * (1 / stage.efficiency - 1), -behind * (1 - stage.efficiency)).sum())
                * step
            )
    assert turned == pytest.approx(work + lost, rel=1e-6)
    assert lost > 0


def test_the_limit_of_a_perfect_chain_is_the_lossless_one():
    phases = there_and_back(ASYMMETRIC, Cycloidal())
    perfect = Sizing(train([Stage(s.name, s.ratio) for s in STAGES]), phases, 1e-4).rms_torque
    gaps = [
        Sizing(train([Stage(s.name, s.ratio, 1 - loss) for s in STAGES]), phases, 1e-4).rms_torque / perfect - 1
        for loss in (1e-2, 1e-4, 1e-6)
    ]
    assert gaps[0] == pytest.approx(1e2 * gaps[1], rel=0.1)
    assert gaps[1] == pytest.approx(1e2 * gaps[2], rel=1e-2)


def test_a_descending_load_drives_the_motor():
    parts = [Part("rollers", 1.0, 1, 2.0)]
    load = Slide(150, slope=radians(-20)).load
    machine = KINDS["conveyor"].of(load, 0.3, gears=[Stage("gear", 50, 0.9)], parts=parts, belt=10)
    sizing = Sizing(machine, [Phase(thirds(0.1, 0.8, 0.1), 0.5, 30)], 1e-3)
    level = {part.name: part.torque for part in sizing.parts}["uniform"]
    assert level == pytest.approx(-150 * 9.81 * math.sin(radians(20)) * 0.15 / 50 * 0.9, rel=1e-12)


def test_the_load_is_held_by_the_motor_or_by_a_brake():
    machine = KINDS["lead screw"].of(Slide(6, 0.1, radians(90)).load, 500, 0.5, parts=[Part("screw", 1e-5)])
    phases = [Phase(Cycloidal(), 0.008, 0.2), Phase(Dwell(), 0.0, 0.1)]
    held = {holding: Sizing(machine, phases, 1e-5, holding=holding) for holding in ("motor", "brake")}
    assert held["brake"].parts[-1].torque == 0.0
    assert held["motor"].parts[-1].torque == pytest.approx(6 * 9.81 / (2 * math.pi * 500) / 0.5, rel=1e-12)
    assert held["motor"].rms_torque > held["brake"].rms_torque


def test_a_return_accelerates_towards_the_other_side():
    sizing = Sizing(TRAIN, [Phase(Cycloidal(), -6.0, 0.3)], 1e-4)
    by_name = {part.name: part.torque for part in sizing.parts}
    assert by_name["accelerating"] < by_name["uniform"] < by_name["decelerating"]


def test_derating_is_one_up_to_the_rated_temperature_and_falls_to_zero():
    assert derating(25) == 1.0
    assert derating(-10) == 1.0
    assert derating(60, limit=155, rated_at=40) == pytest.approx(math.sqrt(95 / 115), rel=1e-14)
    assert derating(155 - 1e-9, limit=155) == pytest.approx(0.0, abs=1e-5)


def test_reserve_uses_the_derated_torque():
    sizing = Sizing(TRAIN, there_and_back(Cycloidal(), Cycloidal()), 1e-4)
    motor = Motor(1e-4, rated_torque=sizing.rms_torque * 1.01, peak_torque=20.0, max_speed=1000.0)
    assert [check.ok for check in sizing.reserve(motor)] == [True, True, True]
    derated = replace(motor, rated_torque=motor.rated_torque * derating(45))
    assert [check.ok for check in sizing.reserve(derated)] == [False, True, True]


def test_thirds_are_thirds():
    assert (thirds().rise_end, thirds().fall_start) == pytest.approx((1 / 3, 2 / 3), rel=1e-15)
    assert thirds(0.5, 0.0, 0.5).coefficients.cv == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
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
