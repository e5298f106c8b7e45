"""S1: the cutting machine's movements, the feeding group's inertia and torque."""

import math
from typing import NamedTuple

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Part
from engine.drive.chain import resisting
from engine.drive.cycle import DriveCycle
from engine.drive.results import DriveResults
from engine.laws import Dwell
from engine.laws.modified import ModifiedTrapezoidal
from engine.laws.polynomials import Cubic
from engine.laws.ramps import TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal
from engine.motion import Motion, Phase
from engine.timing import shaft_speed

MTP = ModifiedTrapezoidal()
RADIUS = 0.134  # m


class Movement(NamedTuple):
    """One rise or return of an axis, where the abscissa advances at a speed."""

    axis: str
    of: Phase
    speed: float

    @property
    def v_max(self):
        return self.of.y1_max * self.speed

    @property
    def a_max(self):
        return self.of.y2_max * self.speed**2


def axis(degrees, lifts, law):
    laws = [law if lift else Dwell() for lift in lifts]
    return Motion.from_edges(np.deg2rad([0.0, *degrees]), lifts, laws)


def machine(law=MTP):
    """'Timing diagram for a cutting machine': MC01, MC02, MC03 in m over rad, by name."""
    return {
        "MC01": axis((80, 360), (0.3, 0.0), law),
        "MC02": axis((90, 135, 305, 350, 360), (0.0, 0.02, 0.0, -0.02, 0.0), law),
        "MC03": axis((145, 225, 235, 295, 360), (0.0, 0.08, 0.0, -0.08, 0.0), law),
    }


def movements(law, rate):
    """The movements of all axes at a rate in pieces a second."""
    found = ((name, phase) for name, one in machine(law).items() for phase in one.phases if phase.moves)
    return [Movement(*one, shaft_speed(rate)) for one in found]


# --- Asymmetric trapezoidal speed profile ---------------------------------------------------------


@pytest.mark.parametrize(("av", "aw"), [(0.25, 0.6), (1 / 3, 2 / 3), (0.4, 0.4), (0.05, 0.9)])
def test_asymmetric_trapezoidal_heights(av, aw):
    """A/B = (α_s − α_w)/α_v and h = A α_v δ with δ = (α_s − α_v + α_w)/2, for h = α_s = 1."""
    law = TrapezoidalVelocity(av, aw)
    a, b = law.coefficients.ca_max, -law.coefficients.ca_min
    assert a / b == pytest.approx((1 - aw) / av, rel=1e-14)
    assert a * av * (1 - av + aw) / 2 == pytest.approx(1.0, rel=1e-14)


# --- Timing diagram for a cutting machine ---------------------------------------------------------


@pytest.mark.parametrize(
    ("law", "y1", "y2", "v", "a"),
    [
        (ConstantAcceleration(), 0.42972, 0.61553, 9.0000, 270.000),
        (TrapezoidalVelocity(), 0.32229, 0.69247, 6.7500, 303.750),
        (Cubic(), 0.32229, 0.92329, 6.7500, 405.000),
        (Cycloidal(), 0.42972, 0.96687, 9.0000, 424.115),
        (MTP, 0.42972, 0.75219, 9.0000, 329.948),
    ],
    ids=lambda value: getattr(value, "code", None),
)
def test_mc01_rise_with_each_law(law, y1, y2, v, a):
    rise = movements(law, 200 / 60)[0]
    assert (rise.of.y1_max, rise.of.y2_max) == pytest.approx((y1, y2), abs=5e-6)
    assert (rise.v_max, rise.a_max) == pytest.approx((v, a), abs=5e-4)


@pytest.mark.parametrize(
    ("number", "name", "y1", "y2", "v", "a"),
    [
        (1, "MC02", 0.05093, 0.15849, 1.0667, 69.520),
        (2, "MC02", 0.05093, 0.15849, 1.0667, 69.520),
        (3, "MC03", 0.11459, 0.20058, 2.4000, 87.986),
        (4, "MC03", 0.15279, 0.35659, 3.2000, 156.420),
    ],
    ids=["MC02 rise", "MC02 return", "MC03 rise", "MC03 return"],
)
def test_movements_with_the_modified_trapezoidal_law(number, name, y1, y2, v, a):
    movement = movements(MTP, 200 / 60)[number]
    assert movement.axis == name
    assert (movement.of.y1_max, movement.of.y2_max) == pytest.approx((y1, y2), abs=5e-6)
    assert movement.v_max == pytest.approx(v, abs=5e-5)
    assert movement.a_max == pytest.approx(a, abs=5e-4)


# --- Feeding group --------------------------------------------------------------------------------


def feeding_group():
    """Load at the roller shaft; S1 leaves motor and ratio open: J_m = 0, τ = 1."""
    rotors = [Part("rollers", 0.284, count=4), Part("fast shaft", 0.007, speed_ratio=90 / 45)]
    return Drivetrain(KINDS["feed rollers"].of(resisting(500.0, "always"), RADIUS, parts=rotors), 0.0)


def results(law):
    """The feeding group over a cycle at 100 pieces a minute, 0.6 s."""
    train = feeding_group()
    return DriveResults(DriveCycle(train, machine(law)["MC01"], shaft_speed(100 / 60)))


@pytest.mark.parametrize(
    ("law", "acceleration", "highest", "lowest"),
    [
        (ConstantAcceleration(), 503.7313, 653.3433, -519.3433),
        (MTP, 615.5753, 783.5297, -649.5297),
        (Cycloidal(), 791.2593, 988.0259, -854.0259),
    ],
    ids=lambda value: getattr(value, "code", None),
)
def test_torque_at_the_roller_shaft(law, acceleration, highest, lowest):
    """The torques were computed from the rounded accelerations: half a digit times 1.164 more room."""
    rise = movements(law, 100 / 60)[0]
    assert rise.a_max / RADIUS == pytest.approx(acceleration, abs=5e-5)
    exact = results(law).torque
    assert (exact.highest.value, exact.lowest.value) == pytest.approx((highest, lowest), abs=1.1e-4)


def test_exact_rms_torque_over_the_cycle():
    """C_m,rms² = (J_tot ω̇_rms)² · 80/360 + C_r², as the rise takes what it gives back."""
    inertial = 1.164 * MTP.coefficients.ca_rms * 0.3 / RADIUS / (0.6 * 80 / 360) ** 2
    exact = math.sqrt(inertial**2 * 80 / 360 + 67.0**2)
    assert results(MTP).rms_torque == pytest.approx(exact, rel=1e-12)
