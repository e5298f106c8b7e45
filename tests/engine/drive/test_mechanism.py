"""Inertia and loads of each mechanism against the formulas that textbooks give for it."""

from math import pi, radians, sin

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Load, Mechanism, Part, Slide, Stage, cylinder
from engine.drive.chain import GRAVITY
from engine.drive.cycle import DriveCycle
from engine.laws import law
from engine.motion import Motion, Phase

LOAD = Slide(mass=12.0, friction=0.2, slope=radians(30), force=40.0)


def test_cylinder_is_half_m_r_squared_and_a_bore_takes_its_share():
    mass = 7800 * pi * 0.05**2 * 0.2
    assert cylinder(0.1, 0.2, 7800) == pytest.approx(0.5 * mass * 0.05**2, rel=1e-14)
    hollow = cylinder(0.1, 0.2, 7800, bore=0.06)
    assert hollow == pytest.approx(cylinder(0.1, 0.2, 7800) - cylinder(0.06, 0.2, 7800), rel=1e-14)


def test_slide_has_gravity_and_force_always_and_friction_with_the_motion():
    assert LOAD.load.torque == pytest.approx(40 + 12 * GRAVITY * 0.5, rel=1e-14)
    assert LOAD.load.friction == pytest.approx(0.2 * 12 * GRAVITY * 0.75**0.5, rel=1e-14)
    assert Slide(12.0, slope=-0.3).load.torque == pytest.approx(-12 * GRAVITY * sin(0.3), rel=1e-14)


def test_lead_screw():
    parts = [Part("coupling", 5e-5), Part("screw", 3e-4)]
    machine = KINDS["lead screw"].of(LOAD.load, 200.0, 0.8, parts=parts)
    pitch = 1 / 200
    assert machine.inertia() == pytest.approx(3.5e-4 + 12 * (pitch / (2 * pi)) ** 2, rel=1e-14)
    assert machine.inertia("document") == pytest.approx(3.5e-4 + 12 * (pitch / (2 * pi)) ** 2 / 0.8, rel=1e-14)


@pytest.mark.parametrize("kind", ["conveyor", "belt"])
def test_conveyor_and_belt_axis(kind):
    parts = [Part("gear", 1e-4), Part("rollers", 2e-3, 1, 3.0)]
    machine = KINDS[kind].of(LOAD.load, 0.08, gears=[Stage("gear", 5.0, 0.9)], parts=parts, belt=1.5)
    behind = (3 * 2e-3 + (1.5 + 12) * 0.04**2) / 25
    assert machine.ratio == pytest.approx(5 / 0.04, rel=1e-14)
    assert machine.inertia() == pytest.approx(1e-4 + behind, rel=1e-14)
    assert machine.inertia("document") == pytest.approx(1e-4 + behind / 0.9, rel=1e-14)
    assert machine.load.torque == LOAD.load.torque  # the belt's own weight balances itself


def test_gear_train_reflects_each_shaft_by_the_stages_before_it():
    stages = [Stage("first", 3.0, 0.9), Stage("second", 4.0, 0.8)]
    parts = [Part("pinion", 1e-4), Part("middle", 2e-3, 1, 2.0)]
    machine = KINDS["gear train"].of(Load(0.3), gears=stages, parts=parts)
    assert machine.ratio == pytest.approx(12.0)
    assert machine.inertia() == pytest.approx(1e-4 + 4e-3 / 9 + 0.3 / 144, rel=1e-14)
    assert machine.inertia("document") == pytest.approx(1e-4 + 4e-3 / 9 / 0.9 + 0.3 / 144 / 0.72, rel=1e-14)


@pytest.mark.parametrize("kind", KINDS.values(), ids=lambda kind: kind.name)
def test_power_through_every_mechanism_is_kept_where_nothing_is_lost(kind):
    """Virtual work: the motor's power is the load's force times its speed, and what the inertias take."""
    load = Load(2.0, 30.0, 4.0)
    machine = kind.of(load, 0.3, gears=[Stage("gear", 7.0)], parts=[Part("a", 1e-3), Part("b", 0.02, 1)], belt=0.7)
    slowing = DriveCycle(Drivetrain(machine, 0.0), Motion([Phase(law("ACS"), 0.375, 1.0)])).torque_intervals[-1]
    u, v, a = 0.1, 0.6, -1.5
    moved = 2.0 + (0.7 if kind.belt else 0.0)
    energy = moved * v * a + 0.02 * (machine.ratio_from(1) ** 2) * v * a + 1e-3 * machine.ratio**2 * v * a
    assert slowing.power(np.array([u])).item() == pytest.approx(34.0 * v + energy, rel=1e-12)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Stage("gear", 0.0), "gear: ratio is 0"),
        (lambda: Stage("gear", 3.0, 1.2), "gear: efficiency is 1.2"),
        (lambda: Part("roller", -1.0), "roller: inertia is -1"),
        (lambda: Slide(-1.0), "load: mass is -1"),
        (lambda: Slide(1.0, slope=2.0), "slope is 114.592 degrees"),
        (lambda: cylinder(0.1, 1.0, 7800, bore=0.1), "bore is 0.1 m; expected less than the diameter"),
        (lambda: KINDS["lead screw"].of(LOAD.load, 0.0), "lead screw: size is 0"),
        (lambda: KINDS["rack and pinion"].of(LOAD.load, 0.0), "rack and pinion: size is 0"),
        (lambda: KINDS["belt"].of(LOAD.load, 0.1, belt=-1.0), "belt: belt is -1"),
        (lambda: Mechanism("m", (), (), LOAD.load), "no stages"),
        (lambda: Mechanism("m", (Stage("gear", 3.0),), (Part("b", 1.0, 2),), LOAD.load), "shaft is 2; expected 0 to 1"),
        (lambda: Slide(1.0, friction=-1.0), "friction is -1"),
        (lambda: Slide(1.0, bed=-1.0), "bed"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()
