"""Sizing examples that manufacturers print, with all their inputs, through the engine's cycles.

Figures are copied with the digits they are printed with. All three count the friction over the mechanism's efficiency
and the inertia without it, so that what moves counts here as an inertia on the motor's shaft.

E-V-MD      Yaskawa, E-V-MD series, user's manual, 2.2.2 'Selection Calculations', page 2-5
SGMVH       Yaskawa, Sigma II series SGMVH, user's manual, 11.1.1 'Selection Example for Speed Control', page 11-2
WISE        Weihong, WISE WSDV servo, user's manual, 3.5.2.1 'Example of Motor Selection for Ball Screw System',
            pages 25 to 27. It rounds 0.3/0.9 m/s up to 0.334, and so has 1002 min⁻¹ for 1000.
"""

from math import pi

import pytest

from engine.drive import KINDS, Drivetrain, Load, Part, Stage, cylinder
from engine.drive.cycle import DriveCycle
from engine.drive.results import DriveResults
from engine.laws import Dwell
from engine.motion import Motion, Phase
from tests.engine.profiles import thirds

G = 9.8
RPM = 30 / pi


def reflected(mass, lead, gear=1.0):
    """Inertia of what travels, at the motor's shaft."""
    return mass * (lead / (2 * pi * gear)) ** 2


def feeding(mechanism, inertia, distance, times, rest):
    """A feed that accelerates, goes on, slows for so many seconds, and rests."""
    move = sum(times)
    phases = [Phase(thirds(*(t / move for t in times)), distance, move), Phase(Dwell(), 0.0, rest)]
    return DriveResults(DriveCycle(Drivetrain(mechanism, inertia), Motion(phases)))


@pytest.mark.parametrize(
    ("mass", "length", "diameter", "gear", "coupling", "printed"),
    [
        pytest.param(250, 1.0, 0.02, 2, 0.40e-4, (3000, 0.43, 1.58e-4, 0.31e-4, 2.29e-4), id="E-V-MD"),
        pytest.param(500, 1.4, 0.04, 1, 1 / 8 * 0.06**2, (1500, 1.73, 12.7e-4, 27.7e-4, 44.9e-4), id="SGMVH"),
    ],
)
def test_yaskawa_ball_screws(mass, length, diameter, gear, coupling, printed):
    """15 m/min, 40 times a minute 0.275 m in 1.2 s, lead 0.01 m, μ = 0.2, η = 0.9, steel 7870 kg/m³."""
    speed, friction_torque, load_inertia, screw_inertia, inertia = printed
    screw = cylinder(diameter, length, 7870) / gear**2
    moved = reflected(mass, 0.01, gear)
    parts = [Part("screw", screw), Part("coupling", coupling), Part("table", moved)]
    gears = [Stage("gear", gear)] if gear != 1 else []
    mechanism = KINDS["lead screw"].of(Load(0.0, friction=0.2 * mass * G), 100, 0.9, gears, parts)
    found = feeding(mechanism, 0.0, 0.275, (0.1, 1.0, 0.1), 0.3)
    digits = 5e-7 if gear == 2 else 5e-6
    assert found.speed.highest.value * RPM == pytest.approx(speed, abs=0.5)
    assert found.drive_cycle.time == pytest.approx(60 / 40)
    assert moved == pytest.approx(load_inertia, abs=digits)
    assert screw == pytest.approx(screw_inertia, abs=digits)
    assert mechanism.inertia() == pytest.approx(inertia, abs=digits)
    rises, falls = found.torque.highest.value, found.torque.lowest.value
    assert (rises + falls) / 2 == pytest.approx(friction_torque, abs=5e-3)
    if gear == 2:  # 'Load moving power', worked out there from 0.43 Nm
        assert (rises + falls) / 2 * found.speed.highest.value == pytest.approx(135, abs=135 * 5e-3 / 0.43)


def test_weihong_ball_screw():
    """10 kg, screw Ø 0.02 × 0.5 m, lead 0.02 m, η = 0.9, μ = 0.1, 0.3 m in 0.1 + 0.8 + 0.1 s, every 2 s."""
    screw, moved, motor = cylinder(0.02, 0.5, 7900), reflected(10, 0.02), 0.14e-4
    parts = [Part("screw", screw), Part("coupling", 1e-5), Part("part", moved)]
    mechanism = KINDS["lead screw"].of(Load(0.0, friction=0.1 * 10 * G), 50, 0.9, parts=parts)
    found = feeding(mechanism, motor, 0.3, (0.1, 0.8, 0.1), 1.0)
    assert mechanism.inertia() == pytest.approx(1.73e-4, abs=5e-7)
    assert mechanism.inertia() / motor == pytest.approx(12.3, abs=0.1)  # 1.73/0.14 = 12.36, cut there
    assert found.drive_cycle.motion.peaks.y1 == pytest.approx(0.334, abs=1e-3)
    assert found.speed.highest.value * RPM == pytest.approx(1002, abs=2.1)
    assert found.torque.highest.value == pytest.approx(0.231, abs=1e-3)
    assert found.torque.lowest.value == pytest.approx(-0.161, abs=1e-3)
    assert (found.torque.highest.value + found.torque.lowest.value) / 2 == pytest.approx(0.035, abs=5e-4)
    assert found.rms_torque == pytest.approx(0.067, abs=5e-4)
