"""Many motors behind many reducers at many rates: each is what its own course says, found by its stretches."""

import random
from math import pi

import numpy as np
import pytest

from engine.drivetrain import KINDS, Drive, Load, Part, Stage
from engine.laws import Dwell, law
from engine.machine.course import Course
from engine.machine.demand import Demand
from engine.machine.geared import Geared, Gears, constant
from engine.machine.train import Train, Window
from engine.motion import Motion
from tests.engine.machine.machines import course_of
from tests.tiers import nights, seed

TURN = 2 * pi
NAMES = ["CIC", "MTP", "CUB", "PO5", "ACS", "TVP", "SHM", "SCC"]
INERTIA, RATIO, ETA = np.array([1e-3, 5e-3, 0.0]), np.array([3.0, 8.0, 12.0]), np.array([0.9, 0.6, 1.0])
SPEEDS = np.array([0.5, 20.0, 60.0])


def drawn(rng):
    """A motion, a load and process forces; what makes a drive of it, by the number of motor and reducer."""
    first, second = rng.choices(NAMES, k=2)
    edges = [0.0, 1.0, rng.uniform(1.1, 2.0), rng.uniform(3.0, 4.0), TURN]
    motion = Motion.from_edges(edges, [0.1, 0.0, -0.1, 0.0], [law(first), Dwell(), law(second), Dwell()])
    load = Load(rng.choice([0.0, rng.uniform(0.1, 5.0)]), rng.uniform(-100.0, 100.0), rng.choice([0.0, 30.0]))
    windows = [Window(0.3, 1.5, rng.uniform(-200.0, 200.0), rng.choice(["always", "moving"]))]
    holding, parts = rng.choice(["brake", "motor"]), [Part("pulley", 1e-3, 1)]

    def course(k, speed):
        kind = KINDS["belt"].of(load, 0.05, 0.8, [Stage("gear", RATIO[k], ETA[k])], parts)
        return Course(Train(Drive(kind, INERTIA[k], holding=holding), windows=windows), motion, speed)

    return course


def figures(found, gears):
    """All that is found at once, a row a figure."""
    torques, works = found.torques(gears), found.works(gears)
    return np.array([
        torques.lowest, torques.highest, found.rms_torque(gears), works.driving, works.regenerated, found.speed(gears),
        found.mean_speed(gears), found.behind[gears.rate], found.moments.mean[gears.rate], found.inertia(gears.ratio),
    ])  # fmt: skip


def alone(demand):
    """The same of one drive."""
    return [
        demand.torque.lowest.value, demand.torque.highest.value, demand.rms_torque, demand.energy.driving,
        demand.energy.regenerated, demand.speed.peak, demand.mean_speed, demand.shaft_torque(1).peak,
        demand.mean_shaft_torque(1), demand.course.train.drive.mechanism.inertia(),
    ]  # fmt: skip


@pytest.mark.parametrize("number", nights(60))
def test_what_is_found_at_once_is_what_each_course_says_by_night(number):
    require_alike(random.Random(seed(number)))


@pytest.mark.parametrize("number", range(6))
def test_what_is_found_at_once_is_what_each_course_says(number):
    require_alike(random.Random(number))


def require_alike(rng):
    course = drawn(rng)
    each = [(k, r) for k in range(len(RATIO)) for r in range(len(SPEEDS))]
    motors, rates = (np.array(places) for places in zip(*each, strict=True))
    found = figures(Geared(course(0, 7.0), SPEEDS), Gears(INERTIA[motors], RATIO[motors], ETA[motors], rates))
    expected = np.array([alone(Demand(course(k, SPEEDS[r]))) for k, r in each]).T
    size = np.abs(expected).max(axis=1, keepdims=True)
    assert found == pytest.approx(expected, rel=1e-11, abs=1e-12 * float(size.max()))


def test_parts_of_many_motors_are_what_all_are_at_once(monkeypatch):
    course = drawn(random.Random(3))
    count = np.arange(40)
    gears = Gears(1e-4 * count, 1.0 + count, np.full(40, 0.9), count % 3)
    whole = figures(Geared(course(0, 7.0), SPEEDS), gears)
    monkeypatch.setattr("engine.machine.geared.AT_ONCE", 700)
    assert figures(Geared(course(0, 7.0), SPEEDS), gears) == pytest.approx(whole, rel=1e-12, abs=1e-12)


def test_a_ratio_that_changes_is_refused():
    one = course_of(0, kinds=("crank-slider",))
    assert not constant(one)
    with pytest.raises(ValueError, match="expected constant ratios"):
        Geared(one, SPEEDS)
