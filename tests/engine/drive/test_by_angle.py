"""A slide on a crank that turns full circles, a swinging arm: textbook figures, differentiated positions, energy."""

import random
from math import asin, cos, degrees, pi, radians, sin, sqrt

import numpy as np
import pytest

from engine.drive import KINDS, Drive, Load, Part, Slide, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.drive_points import DrivePoints
from engine.drive.drivetrain import Drivetrain, Window
from engine.drive.mechanisms.by_angle import Arm, PressCrank
from engine.drive.quadrature import QuadratureCycle
from engine.drive.results import DriveResults
from engine.laws import Dwell, law
from engine.motion import Motion
from engine.motion.pieces import motion_pieces
from tests.tiers import nights, seed

R, ROD, TURN = 0.06, 0.24, 2 * pi
PRESS = PressCrank(R, ROD)
ROUND = Motion.from_edges([0.0, TURN], [TURN], [law("LIN")])
"""one turn at constant speed"""


def cycle_of(by_angle, load, motion=ROUND, speed=TURN, *, eta=1.0, inertia=0.0, windows=(), **more):
    """A crank or an arm behind a reducer of 5, over a cycle."""
    parts = [Part("flywheel", inertia, 1)]
    mechanism = KINDS["press crank"].of(load, 1.0, eta, [Stage("reducer", 5.0, eta)], parts)
    return DriveCycle(Drivetrain(Drive(mechanism, 0.0, **more), None, 0.0, tuple(windows), by_angle), motion, speed)


def points_of(drive_cycle):
    pieces = motion_pieces(drive_cycle.motion)
    return DrivePoints(QuadratureCycle(drive_cycle, pieces, 3e-9 * drive_cycle.unshifted.total).points())


def test_the_acceleration_in_the_dead_centres_is_that_of_the_textbook():
    """At 300 rpm r ω² (1 ± λ), λ = r/l = 1/4: 74.02 m/s² towards the shaft and 44.41 m/s² away from it."""
    w = 300 * pi / 30
    slope, bend = PRESS.slopes(np.array([0.0, pi]))
    assert bend * w**2 == pytest.approx([-R * w**2 * 1.25, R * w**2 * 0.75], rel=1e-14)
    assert bend * w**2 == pytest.approx([-74.02, 44.41], abs=0.005)
    assert slope == pytest.approx(0.0, abs=1e-16)


def test_the_speed_of_the_slide_is_that_of_the_textbook_series():
    """x' = −r (sin φ + λ/2 sin 2φ), the series broken off behind λ², right to r λ³/5."""
    at = np.linspace(0.0, TURN, 73)
    assert PRESS.slopes(at)[0] == pytest.approx(-R * (np.sin(at) + np.sin(2 * at) / 8), abs=R * 0.25**3 / 5)


@pytest.mark.parametrize("crank", [PRESS, PressCrank(R, ROD, 0.03, 1.1), PressCrank(R, 0.07, -0.008, -2.0)])
def test_slopes_are_those_of_positions_and_are_0_in_the_dead_centres(crank):
    at, h = np.linspace(-7.0, 7.0, 98), 1e-4
    before, here, after = (crank.position(at + way * h) for way in (-1, 0, 1))
    slope, bend = crank.slopes(at)
    assert slope == pytest.approx((after - before) / (2 * h), abs=1e-7)
    assert bend == pytest.approx((after - 2 * here + before) / h**2, abs=1e-5)
    centres = crank.dead_centres(-7.0, 7.0)
    assert crank.slopes(np.array(centres))[0] == pytest.approx(0.0, abs=1e-15)
    signs = np.sign(slope)
    assert len(centres) == int((signs[1:] != signs[:-1]).sum())


def test_without_losses_the_torque_is_the_change_of_energy_by_angle():
    """T = d/dφ ½ m x'² ω², by differences of energies along the turn."""
    drive_cycle = cycle_of(PRESS, Load(20.0), speed=30.0)
    at, h = np.linspace(0.05, 6.2, 60), 1e-5
    low, high = (10.0 * (PRESS.slopes(at + way * h)[0] * 30.0) ** 2 for way in (-1, 1))
    torque = 5.0 * np.concatenate(
        [one.torque(at[(at > one.low) & (at < one.high)]) for one in drive_cycle.torque_intervals]
    )
    assert torque == pytest.approx((high - low) / (2 * h), abs=1e-3)


def test_a_process_force_asks_for_its_work_and_friction_for_its_way():
    """2 kN over the last 60° before the outer dead centre; μ m g over two strokes of 2 r."""
    crank = PressCrank(R, ROD, 0.0, pi)
    window = Window(radians(120), radians(180), 2000.0)
    found = DriveResults(cycle_of(crank, Slide(20.0, 0.2).load, windows=[window]))
    way = float(crank.position(np.array(pi)) - crank.position(np.array(radians(120))))
    assert way == pytest.approx(R * (1 - cos(radians(60))) + ROD - sqrt(ROD**2 - (R * sin(radians(60))) ** 2))
    assert found.energy.net == pytest.approx(2000.0 * way + 0.2 * 20.0 * 9.81 * 4 * R, rel=1e-9)


def test_a_weight_asks_for_nothing_over_a_turn_but_for_the_losses_both_ways():
    """m g 2r up through 1/η² and down through η²."""
    found = DriveResults(cycle_of(PRESS, Slide(20.0, 0.0, pi / 2).load, eta=0.8, speed=1e-3))
    work = 20.0 * 9.81 * 2 * R
    assert found.energy.driving == pytest.approx(work / 0.64, rel=1e-6)
    assert found.energy.regenerated == pytest.approx(work * 0.64, rel=1e-6)


def test_an_arm_asks_for_its_moment_by_the_cosine():
    """10 kg at 0.3 m: up to 29.43 Nm, RMS over a turn 29.43/√2, and no work."""
    moment = 10.0 * 9.81 * 0.3
    drive_cycle = cycle_of(Arm(moment, radians(30)), Load(0.9))
    found = DriveResults(drive_cycle)
    assert 5.0 * found.torque.peak == pytest.approx(29.43, abs=1e-9)
    assert degrees(found.torque.highest.x) == pytest.approx(330.0, abs=1e-4)
    assert 5.0 * found.rms_torque == pytest.approx(moment / sqrt(2), rel=1e-9)
    assert found.energy.net == pytest.approx(0.0, abs=1e-9)
    assert points_of(drive_cycle).rms_torque == pytest.approx(found.rms_torque, rel=1e-4)


def test_an_arm_that_stands_is_held():
    drive_cycle = cycle_of(Arm(30.0, radians(60)), Load(0.9), Motion.from_edges([0.0, TURN], [0.0], [Dwell()]))
    assert DriveResults(drive_cycle).torque.peak == pytest.approx(30.0 / 2 / 5, rel=1e-12)


def random_press(told):
    """A press or an arm of any size, of a whole turn in two movements of a quarter of the cycle or more, and a rest."""
    drawn = random.Random(f"by angle {told}")
    r = drawn.uniform(0.02, 0.2)
    offset = drawn.choice([0.0, drawn.uniform(-0.5, 0.5) * r])
    crank = PressCrank(r, drawn.uniform(2.5, 6.0) * r + abs(offset), offset, drawn.uniform(-4, 4))
    load = Slide(drawn.uniform(1, 50), drawn.uniform(0, 0.2), drawn.uniform(-1.5, 1.5), drawn.uniform(-200, 200)).load
    by_angle = crank if drawn.random() < 0.7 else Arm(drawn.uniform(1, 100), drawn.uniform(-4, 4))
    load = load if by_angle is crank else Load(drawn.uniform(0.1, 2), drawn.uniform(-9, 9), drawn.uniform(0, 3))
    edges = [0.0, drawn.uniform(1.6, 2.4), drawn.uniform(2.6, 4.6), TURN]
    first = drawn.uniform(1.0, 5.0)
    laws = [law(drawn.choice(["MTP", "CIC", "PO5"])), Dwell(), law(drawn.choice(["MSN", "CIC", "PO5"]))]
    motion = Motion.from_edges(edges, [first, 0.0, TURN - first], laws)
    begin = drawn.uniform(0, TURN)
    window = Window(begin, begin + drawn.uniform(0.3, 2), drawn.uniform(-500, 500), drawn.choice(["always", "moving"]))
    holding, eta = drawn.choice(["motor", "brake"]), drawn.choice([1.0, drawn.uniform(0.6, 1)])
    return cycle_of(by_angle, load, motion, drawn.uniform(1, 20), eta=eta, inertia=drawn.uniform(0, 0.3),
                    windows=[window], holding=holding, no_load=drawn.choice([0.0, 0.2]))  # fmt: skip


def sampled(drive_cycle, n=200001):
    """Torque and speed of the motor by energy and virtual work alone, positions differentiated by time."""
    train, total = drive_cycle.train, drive_cycle.unshifted.total
    m, by = train.drive.mechanism, train.by_angle
    x = (np.arange(n) + 0.5) * total / n
    h = total / n / 8

    def course(at):
        """Angle of the axis and position of the load at places of the cycle."""
        angle = drive_cycle.motion.at(np.clip(at, 0.0, total)).y
        return angle, by.position(angle) if isinstance(by, PressCrank) else angle

    before, here, after = (course(x + way * h) for way in (-1, 0, 1))
    dt, angle = h / drive_cycle.speed, here[0]
    w = (after[0] - before[0]) / (2 * dt)
    alpha, acc = ((q2 - 2 * q1 + q0) / dt**2 for q0, q1, q2 in zip(before, here, after, strict=True))
    moves = np.array([phase.moves for phase in drive_cycle.motion.phases])
    going = np.where(moves[np.searchsorted(drive_cycle.motion.edges[1:-1], x)], np.sign(w), 0.0)
    slope = by.slopes(angle)[0]
    level = m.load.torque + m.load.friction * np.sign(slope) * going
    for window in train.windows:
        on = (x - window.begin) % total < (window.end - window.begin) % total
        level = level + np.where(on, window.load.torque + window.load.friction * np.sign(slope) * going, 0.0)
    torque = slope * (m.load.inertia * acc + level) + by.weight(angle)
    for k, stage in ((1, m.stages[1]), (0, m.stages[0])):
        torque = np.where(torque * going < 0, stage.efficiency, 1 / stage.efficiency) * torque / stage.ratio
        torque = torque + m.on_shaft(k) * (alpha if k == 1 else 5.0 * alpha)
    torque = torque + train.drive.no_load * going
    return np.where((going == 0) & (train.drive.holding == "brake"), 0.0, torque), 5.0 * w


@pytest.mark.parametrize("number", [*range(8), *nights(25)])
def test_exact_results_against_sums_over_differentiated_positions(request, number):
    drive_cycle = random_press(seed(number) if request.node.get_closest_marker("nightly") else number)
    torque, speed = sampled(drive_cycle)
    found = DriveResults(drive_cycle)
    peak = np.abs(torque).max()
    assert found.torque.peak == pytest.approx(peak, rel=2e-3)
    assert found.rms_torque == pytest.approx(sqrt((torque**2).mean()), abs=1e-3 * peak)
    assert found.speed.peak == pytest.approx(np.abs(speed).max(), rel=1e-4)
    power, time = torque * speed, drive_cycle.time
    scale = np.abs(power).mean() * time
    assert found.energy.driving == pytest.approx(np.maximum(power, 0).mean() * time, abs=1e-3 * scale)
    assert found.energy.regenerated == pytest.approx(np.maximum(-power, 0).mean() * time, abs=1e-3 * scale)


@pytest.mark.parametrize("number", [*range(12), *nights(40)])
def test_points_are_right_to_what_the_sheets_state(request, number):
    """T_rms to 0.1 % of the peak torque, peaks to 1 %, energies to 3 %."""
    drive_cycle = random_press(seed(number) if request.node.get_closest_marker("nightly") else number)
    exact, points = DriveResults(drive_cycle), points_of(drive_cycle)
    peak = exact.torque.peak
    assert points.rms_torque == pytest.approx(exact.rms_torque, abs=1e-3 * peak)
    assert points.size(points.torque) == pytest.approx(peak, rel=1e-2)
    assert points.size(points.load.output_torque) == pytest.approx(exact.shaft_torque(1).peak, rel=1e-2)
    driving = points.mean(np.maximum(points.power, 0.0)) * drive_cycle.time
    assert driving == pytest.approx(exact.energy.driving, abs=0.03 * exact.energy.driving)


def test_a_rod_that_is_too_short_is_refused():
    with pytest.raises(ValueError, match="expected more than crank and offset"):
        PressCrank(0.06, 0.07, -0.02)


def test_the_angles_of_the_dead_centres_of_an_offset_slide():
    crank = PressCrank(0.05, 0.2, 0.03)
    assert crank.dead_centres(0.0, TURN) == pytest.approx([asin(0.03 / 0.25), pi + asin(0.03 / 0.15)])
