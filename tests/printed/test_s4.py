"""Figures of S4, 'Actuator Sizing': lead screw and conveyor, by the document's method and by the physical one.

Those printed stand in ``figures.py``, with the digits that the formulas give; figures here are the formulas' too.
Misprints: J_machine of the screw (1.65e-5), the acceleration from 0.033 s, the conveyor's RMS (0.147).
"""

from dataclasses import replace
from math import pi, radians
from typing import NamedTuple

import numpy as np
import pytest

from engine.drive import KINDS, Drivetrain, Part, Slide, Stage, cylinder
from engine.drive.cycle import DriveCycle
from engine.drive.results import DriveResults
from engine.laws import Dwell
from engine.motion import Motion, Phase
from tests.engine.profiles import thirds

STEEL = 7800.0
PRINTED_G = 9.8 / 9.81  # the printed torques were worked out with g = 9.8


def lead_screw():
    load = Slide(mass=6, friction=0.1, slope=radians(10)).load
    return KINDS["lead screw"].of(load, 500, 0.45, parts=[Part("screw", cylinder(0.014, 0.5, STEEL))])


def conveyor():
    load = Slide(mass=150, slope=radians(20)).load
    rollers = Part("rollers", cylinder(0.3, 1.0, STEEL), 1, 2)
    return KINDS["conveyor"].of(load, 0.3, gears=[Stage("gear", 50)], parts=[rollers], belt=10)


class Sized(NamedTuple):
    """A drive and the motion of its load in s, with the figures that S4 has of them."""

    drive: Drivetrain
    motion: Motion

    @property
    def results(self):
        return DriveResults(DriveCycle(self.drive, self.motion))

    @property
    def max_speed(self):
        return self.drive.mechanism.ratio * self.motion.peaks.y1

    @property
    def max_acceleration(self):
        return self.drive.mechanism.ratio * self.motion.peaks.y2

    @property
    def torques(self):
        """The torque in the middle of each part of the cycle (Nm)."""
        parts = self.results.drive_cycle.torque_intervals
        torques = [part.torque(np.array([0.5 * (part.low + part.high)])).item() for part in parts]
        return dict(zip(("accelerating", "uniform", "decelerating", "dwell"), torques, strict=True))

    @property
    def total_inertia(self):
        """At the motor's shaft, what is behind the screw over η (kg m²)."""
        return self.drive.motor_inertia + self.drive.mechanism.inertia("document")


def sized(mechanism, inertia_ratio, share, lift, time, rest):
    """A drive sized as S4 does: its way of counting losses, a brake at rest."""
    motion = Motion([Phase(thirds(share, 1 - 2 * share, share), lift, time), Phase(Dwell(), 0.0, rest)])
    return Sized(Drivetrain(mechanism, mechanism.inertia("document") / inertia_ratio, "document", "brake"), motion)


def sized_screw():
    return sized(lead_screw(), 4, 1 / 6, 0.008, 0.2, 0.1)


def sized_conveyor():
    return sized(conveyor(), 1, 1 / 10, 0.5, 30, 3)


screw, screw_sizing = pytest.fixture(lead_screw, name="screw"), pytest.fixture(sized_screw, name="screw_sizing")
belt_sizing = pytest.fixture(sized_conveyor, name="belt_sizing")


def reflected(machine):
    """The inertia of each part and of the load at the motor's shaft, as S4 has it."""
    parts = {part.name: part.reflected / machine.inertia_divisor(part.shaft, "document") for part in machine.parts}
    return parts | {"load": machine.load.inertia / machine.inertia_divisor(machine.last, "document")}


def test_screw_torques(screw_sizing):
    torque = screw_sizing.results.torque
    assert screw_sizing.torques["dwell"] == 0.0
    assert (torque.highest.value, torque.lowest.value) == pytest.approx((0.1021457, -0.0794856), abs=5e-8)


def test_screw_by_the_physical_method_is_the_same_as_long_as_the_load_resists(screw, screw_sizing):
    physical = screw_sizing._replace(drive=replace(screw_sizing.drive, method="physical"))
    assert physical.torques["uniform"] == pytest.approx(screw_sizing.torques["uniform"], rel=1e-14)
    assert physical.torques["accelerating"] == pytest.approx(screw_sizing.torques["accelerating"], rel=1e-14)
    slowed = (screw.load.torque + screw.load.friction - 6 * 1.44) / screw.ratio  # the load still resists while it slows
    front = physical.drive.motor_inertia + cylinder(0.014, 0.5, STEEL)
    assert physical.torques["decelerating"] == pytest.approx(slowed / 0.45 - front * 1440 * pi, rel=1e-12)


def test_the_conveyor_never_drives_back(belt_sizing):
    assert belt_sizing.results.torque.lowest.value == pytest.approx(0.0, abs=5e-7)
