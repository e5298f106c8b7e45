"""Motors by reducers: each pair against a drive that has it, and what a usable one holds."""

import math
from dataclasses import replace

import numpy as np
import pytest

from engine.drive import KINDS, Load, Motor, Part, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain, Window
from engine.drive.results import DriveResults
from engine.laws import Dwell, law
from engine.motion import Motion
from engine.selection.catalogue import Motors, Reducers
from engine.selection.pair_matrix import RANKS, PairMatrix, Requirements
from engine.selection.point_load import PointLoad, ShaftPoints
from tests.engine.drive.machines import points_of

MOTORS = Motors(("small", "large"), np.array([1e-4, 2e-3]), np.array([2.0, 30.0]), np.array([6.0, 90.0]),
                np.array([5000.0, 4000.0]), size=np.array([3.0, np.nan]),
                stall_torque=np.array([np.nan, 55.0]), rated_speed=np.array([np.nan, 2500.0]))  # fmt: skip
REDUCERS = Reducers(("three", "eight"), np.array([3.0, 8.0]), np.array([0.9, 0.75]), np.array([2e-5, 5e-4]),
                    np.array([1e4, 1e4]), np.array([1e4, 1e4]), size=1.0, no_load=np.array([0.0, 0.3]))  # fmt: skip
WIDE = Requirements(1e9, 1e-9, 1e9, 1.0)
BESIDE = Part("coupling", 3e-5, 0)
MOTION = Motion.from_edges(np.radians([0, 30, 120, 200, 330, 360]), [0, 0.05, 0, -0.05, 0],
                           [Dwell(), law("MTP"), Dwell(), law("CIC"), Dwell()])  # fmt: skip


def drive_cycle(inertia=0.0, ratio=1.0, efficiency=1.0, reducer=0.0, no_load=0.0):
    """A screw with friction and a force that drives it back, behind a reducer."""
    parts = [BESIDE, Part("reducer", reducer, 0), Part("pulley", 2e-4, 1)]
    screw = KINDS["lead screw"].of(Load(20.0, 90.0, 40.0), 50.0, 0.7, [Stage("reducer", ratio, efficiency)], parts)
    train = Drivetrain(screw, inertia, no_load=no_load, windows=(Window(0.5, 2.5, -600.0),))
    return DriveCycle(train, MOTION, 12.0)


def grid(wanted=WIDE):
    one = drive_cycle()
    exact = DriveResults(one)
    inertia = one.train.mechanism.inertia() - BESIDE.inertia
    load = PointLoad(points_of(one).load, exact.speed.peak, exact.shaft_torque(1).peak, inertia)
    return PairMatrix(load, MOTORS, REDUCERS, BESIDE.inertia, wanted)


@pytest.mark.parametrize("motor", [0, 1])
@pytest.mark.parametrize("reducer", [0, 1])
def test_a_pair_asks_for_what_a_drive_with_it_does(motor, reducer):
    one, r = grid(), reducer
    own = (float(each[r]) for each in (REDUCERS.reduction, REDUCERS.efficiency, REDUCERS.inertia, REDUCERS.no_load))
    drive = drive_cycle(MOTORS.inertia[motor], *own)
    mechanism = drive.train.mechanism
    found = DriveResults(drive)
    assert one.rms[motor, r] == pytest.approx(points_of(drive).rms_torque, rel=1e-9)
    assert one.rms[motor, r] == pytest.approx(found.rms_torque, rel=1e-3)
    assert one.peak[motor, r] == pytest.approx(found.torque.peak, rel=1e-9)
    assert one.speed[r] == pytest.approx(found.speed.peak, rel=1e-12)
    assert one.inertia_ratio[motor, r] == pytest.approx(mechanism.inertia() / MOTORS.inertia[motor], rel=1e-12)
    m, points = MOTORS, points_of(drive)
    limits = (float(each[motor]) for each in (m.rated_torque, m.peak_torque, m.max_speed, m.stall, m.falls_to))
    own = Motor(m.inertia[motor], *limits)
    of_motor = found.speed.peak / own.max_speed, points.rms_torque / float(own.continuous(found.mean_speed))
    assert one.use(motor, r) == pytest.approx(of_motor, rel=1e-9)


def test_what_a_pair_fails_first_is_told():
    def told(**more):
        strong = replace(MOTORS, rated_torque=np.array([20.0, 200.0]), peak_torque=np.array([60.0, 600.0]))
        pairs = replace(grid(WIDE._replace(**more)), motors=strong)
        words = set(pairs.verdicts.ravel())
        # beyond its limit by what it is said to use of it
        least, most = {"yes": (0, 0), "reducer": (0, 0), "large": (0, 1)}.get("".join(words), (1, np.inf))
        assert ((pairs.failing_uses >= least) & (pairs.failing_uses <= most)).all()
        return words

    assert told() == {"yes"}
    assert told(least_margin=1e9) == {"RMS"}
    assert told(greatest_margin=1e-9) == {"large"}
    assert told(inertia_ratio=1e-9) == {"inertia"}
    assert told(torque_factor=1e9) == {"reducer"}
    assert (told(least_peak=1e9), told(least_speed=1e9)) == ({"peak"}, {"speed"})
    assert told(most_mass=1e-9) == {"mass"}
    weak, slow = (replace(grid(), motors=replace(MOTORS, **{name: np.full(2, 1e-3)}))
                  for name in ("peak_torque", "max_speed"))  # fmt: skip
    assert (set(weak.verdicts.ravel()), set(slow.verdicts.ravel())) == ({"peak"}, {"speed"})
    gentle = replace(grid(), reducers=replace(grid().reducers, max_mean_torque=np.full(2, 1e-3)))
    assert set(gentle.verdicts.ravel()) == {"reducer"}
    thick = replace(grid(), motors=replace(MOTORS, shaft=np.full(2, 0.024)))
    narrow = replace(thick, reducers=replace(thick.reducers, hub=np.array([0.024, 0.019])))
    assert set(narrow.verdicts[:, 1]) == {"shaft"}
    assert (narrow.verdicts[:, 0] == thick.verdicts[:, 0]).all()


def test_a_reducer_carries_less_at_more_cycles_than_its_torque_is_given_for():
    one = grid()
    rated = replace(one.reducers, max_output_torque=np.full(2, 1.5 * one.output_torque), full_rate=np.array([2.0, 3.0]),
                    cycle_factor=np.array([1.4, 1.6]))  # fmt: skip

    def fits(rate):
        return replace(one, reducers=rated, rate=rate).fits.tolist()

    assert (fits(0.0), fits(3.0), fits(3.1)) == ([True, True], [True, True], [True, False])
    assert replace(one, reducers=replace(rated, cycle_factor=1.6), rate=3.0).fits.tolist() == [False, True]


def test_the_smallest_motor_comes_first_and_with_it_the_reducer_that_asks_less_of_it():
    strong = replace(MOTORS, rated_torque=np.array([500.0, 900.0]), peak_torque=np.array([1e4, 1e4]))
    wide = replace(grid(), motors=replace(strong, max_speed=np.array([1e4, 1e4])))
    assert [m for m, _ in wide.best("smallest motor")] == [0, 0, 1, 1]
    first, second = (wide.rms[pair] for pair in wide.best("smallest motor")[:2])
    assert first < second
    assert {m for m, _ in wide.best("mass")} == {0}  # of the other none is given
    assert wide.best("cost") == []
    match = wide.best("inertia match")[0]
    best = min(((m, r) for m in (0, 1) for r in (0, 1)), key=lambda p: abs(math.log(
        wide.balance[p[1]] / wide.inertias[p])))  # fmt: skip
    assert match == best
    assert len(RANKS) == 5


class Held:
    """A load of points: torque (Nm) that it is driven with, or that drives it, and the speed there (rad/s)."""

    def __init__(self, acceleration, driving, driven, speed):
        self.points = ShaftPoints(*(np.array(one) for one in (acceleration, driving, driven, speed, np.sign(speed))))
        self.torques, self.peak = PointLoad.torques.__get__(self), PointLoad.peak.__get__(self)
        self.speed, self.inertia, self.torque, self.mean_torque = max(speed), 0.0, 0.0, 0.0

    def reserve(self, knee, end, reducer=(1.0, 1.0, 0.0)):
        """What a motor of 1 kg m² and 80 Nm to a knee, ``end`` at 200 rad/s, has left: with i, η and T_nl."""
        motor = Motors(("M",), 1.0, 1.0, 80.0, 200.0, full_torque_to=knee, end_torque=end)
        ratio, efficiency, no_load = reducer
        reducers = Reducers(("R",), ratio, efficiency, 0.0, np.inf, np.inf, no_load=no_load)
        return PairMatrix(self, motor, reducers, 0.0, Requirements(1.0, 1.0, 1.0, 1.0)).reserve(0, 0)


def test_the_reserve_is_what_is_left_below_the_curve_at_the_points():
    """80 − 30 below the knee; beyond, 80 − 0.2 (150 − 100) − 30; of a load that drives η/i of its torque; T_nl less."""
    part = Held([10.0, 0.0], [20.0, 20.0], [0.0, 0.0], [150.0, 150.0])
    assert part.reserve(150.0, 70.0) == pytest.approx(50.0)
    assert part.reserve(100.0, 60.0) == pytest.approx(40.0)
    held = Held([0.0], [0.0], [-20.0], [0.0])
    assert held.reserve(1.0, 80.0, (2.0, 0.5, 3.0)) == pytest.approx(75.0)
    assert part.reserve(150.0, 70.0, (1.0, 1.0, 3.0)) == pytest.approx(47.0)
