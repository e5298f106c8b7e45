"""Inertia and loads of each mechanism against the formulas that textbooks give for it."""

from math import pi, radians, sin

import pytest

from engine.mechanism import (
    GRAVITY,
    Mechanism,
    Part,
    Slide,
    Stage,
    belt_axis,
    conveyor,
    cylinder,
    gear_train,
    lead_screw,
    rack_and_pinion,
    rotary_table,
)

LOAD = Slide(mass=12.0, friction=0.2, slope=radians(30), force=40.0)


def test_cylinder_is_half_m_r_squared_and_a_bore_takes_its_share():
    mass = 7800 * pi * 0.05**2 * 0.2
    assert cylinder(0.05, 0.2, 7800) == pytest.approx(0.5 * mass * 0.05**2, rel=1e-14)
    hollow = cylinder(0.05, 0.2, 7800, bore=0.03)
    assert hollow == pytest.approx(cylinder(0.05, 0.2, 7800) - cylinder(0.03, 0.2, 7800), rel=1e-14)


def test_slide_has_gravity_and_force_always_and_friction_with_the_motion():
    assert LOAD.steady == pytest.approx(40 + 12 * GRAVITY * 0.5, rel=1e-14)
    assert LOAD.rubbing == pytest.approx(0.2 * 12 * GRAVITY * 0.75**0.5, rel=1e-14)
    assert Slide(12.0, slope=-0.3).steady == pytest.approx(-12 * GRAVITY * sin(0.3), rel=1e-14)


def test_lead_screw():
    machine = lead_screw(200.0, 3e-4, LOAD, efficiency=0.8, coupling_inertia=5e-5)
    pitch = 1 / 200
    assert machine.inertia() == pytest.approx(3.5e-4 + 12 * (pitch / (2 * pi)) ** 2, rel=1e-14)
    assert machine.inertia(losses=True) == pytest.approx(3.5e-4 + 12 * (pitch / (2 * pi)) ** 2 / 0.8, rel=1e-14)


@pytest.mark.parametrize("build", [conveyor, belt_axis])
def test_conveyor_and_belt_axis(build):
    machine = build(0.04, 2e-3, 1.5, LOAD, 5.0, 0.9, 3.0, gear_inertia=1e-4)
    behind = (3 * 2e-3 + (1.5 + 12) * 0.04**2) / 25
    assert machine.ratio == pytest.approx(5 / 0.04, rel=1e-14)
    assert machine.inertia() == pytest.approx(1e-4 + behind, rel=1e-14)
    assert machine.inertia(losses=True) == pytest.approx(1e-4 + behind / 0.9, rel=1e-14)
    assert machine.steady == LOAD.steady  # the belt's own weight balances itself


def test_rack_and_pinion():
    machine = rack_and_pinion(0.03, 4e-4, LOAD, reduction=4.0)
    assert machine.inertia() == pytest.approx((4e-4 + 12 * 0.03**2) / 16, rel=1e-14)


def test_rotary_table():
    machine = rotary_table(0.6, 0.4, torque=3.0, friction_torque=2.0, reduction=20.0, gear_inertia=2e-4)
    assert machine.inertia() == pytest.approx(2e-4 + 1.0 / 400, rel=1e-14)
    assert (machine.steady, machine.rubbing) == (3.0, 2.0)


def test_gear_train_reflects_each_shaft_by_the_stages_before_it():
    stages = [Stage("first", 3.0, 0.9), Stage("second", 4.0, 0.8)]
    parts = [Part("pinion", 1e-4), Part("middle", 2e-3, 1, 2.0), Part("load", 0.3, 2)]
    machine = gear_train(stages, parts)
    assert machine.ratio == pytest.approx(12.0)
    assert machine.efficiency == pytest.approx(0.72)
    assert machine.inertia() == pytest.approx(1e-4 + 4e-3 / 9 + 0.3 / 144, rel=1e-14)
    assert machine.inertia(losses=True) == pytest.approx(1e-4 + 4e-3 / 9 / 0.9 + 0.3 / 144 / 0.72, rel=1e-14)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Stage("gear", 0.0), "gear: ratio is 0"),
        (lambda: Stage("gear", 3.0, 1.2), "gear: efficiency is 1.2"),
        (lambda: Part("roller", -1.0), "roller: inertia is -1"),
        (lambda: Slide(-1.0), "load: mass is -1"),
        (lambda: Slide(1.0, slope=2.0), "slope is 114.592 degrees"),
        (lambda: cylinder(0.1, 1.0, 7800, bore=0.1), "bore is 0.1 m; expected less than the radius"),
        (lambda: lead_screw(0.0, 1e-4, LOAD), "turns_per_metre is 0"),
        (lambda: rack_and_pinion(0.0, 1e-4, LOAD), "radius is 0"),
        (lambda: gear_train([], []), "no stages"),
        (lambda: gear_train([Stage("gear", 3.0)], [Part("load", 1.0, 2)]), "shaft is 2; expected 0 to 1"),
        (lambda: Mechanism("m", (Stage("gear", 1.0),), (), rubbing=-1.0), "rubbing is -1"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
