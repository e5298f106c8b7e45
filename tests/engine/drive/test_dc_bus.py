"""The power of several drives: against each drive's own energy, dense samples, and what the grid may be off by."""

import random
from dataclasses import replace
from math import ceil, pi

import numpy as np
import pytest

from engine.drive import KINDS, Drive, Load
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain
from engine.drive.results import DriveResults
from engine.laws import Dwell, law
from engine.motion import Motion
from tests.engine.drive.drivetrains import Drivetrains
from tests.engine.drive.machines import drive_cycle_of, electric, operated
from tests.tiers import nights, seed

TURN = 2 * pi


def belt(speed=20.0, shift=0.0, names=("CIC", "MTP"), mass=2.0):
    motion = Motion.from_edges([0, 1, 2, TURN], [0.1, -0.1, 0], [*map(law, names), Dwell()])
    return DriveCycle(Drivetrain(Drive(KINDS["belt"].of(Load(mass, 10.0, 5.0), 0.05, 0.9), 1e-3)), motion, speed, shift)


def drawn(told, count=3):
    """Drives of one cycle, of random machines."""
    found = [drive_cycle_of(f"{told} {k}") for k in range(count)]
    time = found[0].time
    return [replace(one, speed=one.motion.total / time) for one in found]


def dense(drive_cycles, efficiency, n=200001):
    """Time, and what each drive draws at it, by the chain's rules sample by sample."""
    time = drive_cycles[0].time
    t = np.linspace(0, time, n)
    rows = []
    for one in drive_cycles:
        begin = one.motion.edges[0]
        x = begin + (t * one.speed - one.shift - begin) % one.motion.total
        speed, torque = operated(one, x)
        power = electric(one.train.drive, speed, torque)
        rows.append(np.where(power > 0, power / efficiency, power * efficiency))
    return t, np.array(rows)


@pytest.mark.parametrize("number", [*range(3), *nights(10)])
@pytest.mark.parametrize("common", [True, False])
def test_power_against_samples_and_the_grid_within_its_bound(request, number, common):
    told = f"bus {number}"
    told = seed(told) if request.node.get_closest_marker("nightly") else told
    drive_cycles = drawn(told, random.Random(told).randint(1, 4))
    machine = Drivetrains(drive_cycles, 0.9)
    exact = machine.supply(common)
    t, rows = dense(drive_cycles, 0.9)
    ups, downs = (
        np.maximum(way * (rows.sum(axis=0, keepdims=True) if common else rows), 0).sum(axis=0) for way in (1, -1)
    )
    scale = np.abs(rows).max()
    expected = [ups.max(), np.trapezoid(ups, t) / t[-1], downs.max(), np.trapezoid(downs, t) / t[-1]]
    assert list(exact) == pytest.approx(expected, rel=1e-2, abs=3e-4 * scale)
    assert exact.mains_peak >= ups.max() - 1e-6 * scale
    for points in (90, 360):
        rough, bound = machine.supply_on_grid(points, common), machine.grid_error(points)
        assert max(abs(a - b) for a, b in zip(rough, exact, strict=True)) <= bound * (1 + 1e-6) + 1e-9 * scale
    fine = ceil(machine.time / min(section.high - section.low for section in machine.sections))
    assert machine.grid_error(360) <= machine.grid_error(90)  # a section shorter than the step has none within
    assert machine.grid_error(2 * fine) == pytest.approx(machine.grid_error(fine) / 4)


def test_alone_each_drive_takes_its_own_energy():
    drive_cycles = [belt(), belt(shift=0.7, mass=5.0), belt(shift=-3.0, names=("CUB", "CIC"))]
    each = [DriveResults(one).energy for one in drive_cycles]
    found = Drivetrains(drive_cycles, 0.8).supply(common=False)
    assert found.mains_mean == pytest.approx(sum(e.driving for e in each) / 0.8 / drive_cycles[0].time, rel=1e-11)
    assert found.resistor_mean == pytest.approx(
        sum(e.regenerated for e in each) * 0.8 / drive_cycles[0].time, rel=1e-11
    )
    common = Drivetrains(drive_cycles, 0.8).supply(common=True)
    assert common.mains_mean < found.mains_mean
    net = found.mains_mean - found.resistor_mean
    assert common.mains_mean - common.resistor_mean == pytest.approx(net, rel=1e-10)


def test_one_drive_alone_is_its_own_bus():
    one = Drivetrains([belt()], 1.0)
    assert one.supply(True) == pytest.approx(one.supply(False), rel=1e-12)
    assert one.supply(True).mains_peak == pytest.approx(DriveResults(belt()).power.highest.value, rel=1e-12)
    assert one.supply(True).resistor_peak == pytest.approx(-DriveResults(belt()).power.lowest.value, rel=1e-12)


def test_drives_shifted_together_are_one_drive_shifted():
    pair = Drivetrains([belt(), belt(mass=4.0, shift=1.1)], 0.9).supply(True)
    moved = Drivetrains([belt(shift=2.5), belt(mass=4.0, shift=3.6)], 0.9).supply(True)
    assert moved == pytest.approx(pair, rel=1e-9)


def test_a_grid_has_all_breaks_and_the_energy_of_a_year_is_that_of_its_hours():
    machine = Drivetrains([belt(), belt(shift=0.35)], 0.9)
    grid = machine.grid(100)
    assert grid[0] == 0.0
    assert grid[-1] == pytest.approx(machine.time)
    for section in machine.sections:
        assert np.count_nonzero(grid == section.low) + np.count_nonzero(grid == section.high) >= 2
    supply = machine.supply(True)
    assert supply.energy_a_year(2000) == pytest.approx(supply.mains_mean * 2000 * 3600)


def test_what_cannot_be_is_refused():
    with pytest.raises(ValueError, match="no cycles"):
        Drivetrains([])
    with pytest.raises(ValueError, match="one time"):
        Drivetrains([belt(), belt(speed=21.0)])
    with pytest.raises(ValueError, match="efficiency"):
        Drivetrains([belt()], 1.1)
