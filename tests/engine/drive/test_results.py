"""Peaks, RMS torque and energy of drives: against dense samples of another route, other units, mirrors, energy."""

import math
from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest

from engine.drive import KINDS, Load, Part, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain, Window
from engine.drive.results import DriveResults
from engine.flying.cut import Cut, rotary_drum
from engine.flying.pieces import cut_pieces
from engine.laws import Dwell, law
from engine.motion import Motion, Phase
from engine.motion.pieces import MotionPieces
from engine.selection.task import Task
from tests.engine.drive.machines import SIZES, drive_cycle_of, electric, sampled
from tests.engine.families import integrals
from tests.engine.selection.tasks import motors_of
from tests.tiers import nights, seed

RPM = 30 / pi
STEEL = 7800.0


def machines(everyday, night=25):
    """Numbers of random machines: a few of each day, and of each night others."""
    return pytest.mark.parametrize("number", [*range(everyday), *nights(night)])


def drawn(request, number, **more):
    """A random machine of a test, by its number."""
    told = f"{request.function.__name__} {number}"
    return drive_cycle_of(seed(told) if request.node.get_closest_marker("nightly") else told, **more)


def drive_cycle(train, degrees_, lifts, laws, rate, **more):
    """A motion over one turn of the master shaft, at so many turns a minute."""
    motion = Motion.from_edges(np.radians(degrees_), lifts, [Dwell() if one == "DWL" else law(one) for one in laws])
    return DriveCycle(train, motion, rate / 60 * 2 * pi, **more)


def screw(lead, load, efficiency=1.0, inertia=0.0):
    return Drivetrain(KINDS["lead screw"].of(load, 1 / lead, efficiency), inertia)


# Figures that are known


def test_one_sided_limits_count_at_an_instant_of_rest():
    """A load that drives, η = 0.7: at rest for an instant the motor is not asked for F/η."""
    train = screw(0.01, Load(0.0, -400.0), 0.7)
    rise = drive_cycle(train, [0, 180, 360], [0.1, -0.1], ["CIC", "CIC"], 60)
    turns, found = 2 * pi / 0.01, DriveResults(rise)
    assert found.torque.lowest.value == pytest.approx(-400 / 0.7 / turns, rel=1e-12)  # going down it is driven up
    only_rise = drive_cycle(train, [0, 180, 360], [0.1, 0.1], ["CIC", "CIC"], 60)
    assert DriveResults(only_rise).torque.lowest.value == pytest.approx(-400 * 0.7 / turns, rel=1e-12)


def drum(tau, inertia):
    """S5's load: an inertia that indexes, by a motor of an inertia through a ratio τ."""
    drive = Drivetrain(KINDS["rotary table"].of(Load(0.02), gears=[Stage("reducer", 1 / tau)]), inertia)
    return DriveCycle(drive, Motion([Phase(law("CIC"), 1.2, 0.08), Phase(Dwell(), 0.0, 0.04)]))


def test_s5_steps_3_and_4():
    """S5, eqs. (14) to (18): the RMS torque is T_M,N at τ_min and τ_max, least at τ_opt; at τ_M,lim it is fastest."""
    inertia, rated, fastest = 3e-4, 5.0, 600.0
    task = Task.of_load(Load(0.02), drum(1.0, inertia).motion.phases)
    ranges = task.ratio_ranges(motors_of(rated, inertia, fastest))
    low, high, best, limit = (float(one[0]) for one in ranges[1:5])
    for tau in (low, high):
        assert DriveResults(drum(tau, inertia)).rms_torque == pytest.approx(rated, rel=1e-11)
    assert DriveResults(drum(limit, inertia)).speed.peak == pytest.approx(fastest, rel=1e-12)
    least = DriveResults(drum(best, inertia)).rms_torque
    assert least < min(DriveResults(drum(best * way, inertia)).rms_torque for way in (0.97, 1.03))
    assert best == pytest.approx(math.sqrt(inertia / 0.02), rel=1e-12)


@pytest.mark.parametrize("length", [0.18, 0.32])
@pytest.mark.parametrize("name", ["CIC", "MTP"])
def test_s5_drum(length, name):
    """S5, eqs. (10) to (13): an inertial load asks for J_L ω̇; the tool's law rides on the speed of the line."""
    cut = Cut(rotary_drum(3, 0.12, radians(30)), length, 1.5, law(name))
    drive = Drivetrain(KINDS["belt"].of(Load(0.0), 0.24, parts=[Part("drum", 0.02)]), 0.0)
    found = DriveResults(DriveCycle(drive, MotionPieces(tuple(cut_pieces(cut)), cut.cycle_time)))
    assert found.speed.highest.value == pytest.approx(cut.max_angular_speed, rel=1e-12)
    assert found.torque.peak == pytest.approx(0.02 * cut.max_angular_acceleration, rel=1e-11)
    assert found.rms_torque == pytest.approx(0.02 * cut.rms_angular_acceleration, rel=1e-11)
    assert found.energy.driving == pytest.approx(found.energy.regenerated, rel=1e-10)


# Another route


@machines(4)
def test_random_machines_against_samples_of_closed_forms(request, number):
    one = drawn(request, number)
    found, rows = DriveResults(one), sampled(one)
    _, speed, torque = (np.concatenate(column) for column in zip(*rows, strict=True))
    power = electric(one.train, speed, torque)
    for bounds, values in ((found.speed, speed), (found.torque, torque), (found.power, power)):
        scale = np.abs(values).max()
        assert bounds.highest.value == pytest.approx(values.max(), rel=2e-3, abs=2e-3 * scale)
        assert bounds.lowest.value == pytest.approx(values.min(), rel=2e-3, abs=2e-3 * scale)
        assert bounds.highest.value >= values.max() - 1e-8 * scale
        assert bounds.lowest.value <= values.min() + 1e-8 * scale
    squares = sum(np.trapezoid(t**2, x) for x, _, t in rows)
    assert found.rms_torque == pytest.approx(math.sqrt(squares / one.motion.total), rel=2e-4)
    drive = one.train
    driving = sum(np.trapezoid(np.maximum(electric(drive, s, t), 0), x) for x, s, t in rows) / one.speed
    assert found.energy.driving == pytest.approx(driving, rel=2e-4, abs=1e-5 * np.abs(power).max() * one.time)


# Energy


def friction_work(one):
    """Work of all that resists in a cycle (J), by closed forms and the way alone; in the motor itself by means."""
    train, w, total = one.train, one.speed, 0.0
    load = train.mechanism.load
    for stretch in one.torque_intervals:
        a, b = (one.motion.at(stretch.piece.begin + u).y for u in (stretch.low, stretch.high))
        way = abs(b - a)
        level = load.torque * stretch.direction + load.friction
        for window in train.windows:
            x = stretch.piece.begin + (stretch.low + stretch.high) / 2 + one.shift
            if (x - window.begin) % one.motion.total < (window.end - window.begin) % one.motion.total:
                level += window.load.torque * stretch.direction + window.load.friction
        total += level * way
    viscous = 0.0
    for phase in one.motion.phases:
        per = phase.scale / phase.duration * w
        square = sum(found[4] for *_, found in integrals(phase.law))
        viscous += train.viscous * per**2 * square * phase.duration / w
    found, drive = DriveResults(one), train
    return total + viscous + (drive.no_load * found.mean_speed + drive.copper * found.rms_torque**2) * one.time


@machines(4)
def test_what_a_lossless_motor_gives_is_the_work_of_loads_and_friction(request, number):
    one = drawn(request, number, lossless=True)
    found = DriveResults(one)
    most = found.energy.driving + found.energy.regenerated
    assert found.energy.net == pytest.approx(friction_work(one), rel=1e-9, abs=1e-9 * most)


# Invariance


def figures(one):
    found = DriveResults(one)
    return [found.speed.highest.value, found.speed.lowest.value, found.torque.highest.value, found.torque.lowest.value,
            found.power.highest.value, found.power.lowest.value, found.rms_torque, *found.energy,
            found.mean_shaft_torque(0)]  # fmt: skip


@machines(4)
def test_a_cycle_that_begins_elsewhere_asks_for_the_same(request, number):
    one = drawn(request, number)
    moved = tuple(replace(w, begin=w.begin + 1.0, end=w.end + 1.0) for w in one.train.windows)
    other = replace(one, train=replace(one.train, windows=moved), shift=one.shift + 1.0)
    assert figures(other) == pytest.approx(figures(one), rel=1e-8, abs=1e-8)


@machines(4)
def test_a_mirrored_machine_asks_for_the_mirrored(request, number):
    one = drawn(request, number, from_rest=True, kinds=list(SIZES))
    m, drive = one.motion, one.train
    motion = Motion([replace(p, lift=-p.lift) for p in m.phases], position=-m.position)
    mechanism = drive.mechanism
    load = replace(mechanism.load, torque=-mechanism.load.torque)
    windows = tuple(replace(w, force=w.force * (-1 if w.resists == "always" else 1)) for w in one.train.windows)
    mirrored = replace(drive, mechanism=replace(mechanism, load=load), windows=windows)
    found = figures(DriveCycle(mirrored, motion, one.speed, one.shift))
    back = figures(one)
    expected = [-back[1], -back[0], -back[3], -back[2], *back[4:]]
    assert found == pytest.approx(expected, rel=1e-9, abs=1e-9)


# Windows, brakes


def test_a_window_counts_where_it_is_and_across_the_end_of_the_cycle():
    train = screw(0.01, Load(0.0))
    for begin, end, torque in ((10, 20, 1.0), (350, 40, 1.0), (200, 300, 0.0)):
        window = Window(radians(begin), radians(end), 2 * pi / 0.01)
        one = drive_cycle(replace(train, windows=(window,)), [0, 90, 360], [0.1, 0.0], ["CIC", "DWL"], 60)
        moving = [s for s in one.torque_intervals if s.direction]
        torques = {round(float(s.torque(np.array([(s.low + s.high) / 2]))[0]), 9) for s in moving}
        assert max(torques) == pytest.approx(torque)
    assert not Window(1.0, 1.0, 5.0).acts_at(1.0, 6.0)


def test_the_cubic_mean_of_a_constant_torque_is_that_torque():
    drive = Drivetrain(KINDS["lead screw"].of(Load(0.0, 200.0), 100, gears=[Stage("gear", 3.0)]), 0.0)
    one = drive_cycle(drive, [0, 90, 360], [0.1, 0.0], ["CIC", "DWL"], 60)
    assert DriveResults(one).mean_shaft_torque(1) == pytest.approx(200 * 0.01 / (2 * pi), rel=1e-12)


def test_what_cannot_be_is_refused():
    train = screw(0.01, Load(1.0))
    with pytest.raises(ValueError, match="speed"):
        drive_cycle(train, [0, 90, 360], [0.1, 0.0], ["CIC", "DWL"], 0)
    with pytest.raises(ValueError, match="viscous"):
        replace(train, viscous=-1.0)
    with pytest.raises(ValueError, match="resists"):
        Window(0.0, 1.0, 1.0, "sometimes")


@pytest.mark.parametrize("rounding", [-2e-15, 0.0, 2e-15])
@pytest.mark.parametrize("begin", [0.0, 211.174, 359.9])
def test_a_force_over_the_whole_cycle_acts_everywhere(begin, rounding):
    """Also where the cycle, a sum of phases, is longer or shorter than a turn by its rounding."""
    whole = Window(radians(begin), radians(begin + 360.0), 300.0)
    cycle = 2.0 * pi * (1.0 + rounding)
    assert all(whole.acts_at(x, cycle) for x in np.linspace(0.0, cycle, 50))
    none = Window(radians(begin), radians(begin), 300.0)
    assert not any(none.acts_at(x, cycle) for x in np.linspace(0.0, cycle, 50))
