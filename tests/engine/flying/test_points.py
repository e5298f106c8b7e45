"""The tool's shaft at points: its closed figures, its stroke, and motors with reducers on it."""

import random
from dataclasses import replace
from math import pi, radians

import numpy as np
import pytest

from engine.drive import Load
from engine.drive.cycle import DriveCycle, MotionPieces
from engine.drive.drive_points import DrivePoints
from engine.drive.results import DriveResults
from engine.flying.cut import Cut, flying_saw, rotary_drum
from engine.flying.pieces import cut_pieces, cycle_of, furthest, train_of
from engine.laws import law
from engine.selection.pair_matrix import PairMatrix, Requirements
from engine.selection.point_load import PointLoad
from workbook.selection.catalogue_files import committed_motors, committed_reducers
from workbook.selection.pair_selection import engine_motors, engine_reducers

DRUM, LOAD = rotary_drum(3, 0.12, radians(30)), Load(0.02)
SMOOTH = ("ACS", "TVP", "CIC", "CUB", "MTP", "SHM", "MSN", "PO5", "PO7")
ANY = Requirements(1e9, 1.0, 1e9, 1.0)


def cuts(count, seed):
    """Random drums and saws that reverse."""
    drawn = random.Random(seed)
    while count:
        one = law(drawn.choice(SMOOTH))
        if drawn.random() < 0.5:
            tool, length = flying_saw(drawn.uniform(0.02, 0.9), 0.01), drawn.uniform(1.0, 3.0)
        else:
            tool, length = rotary_drum(drawn.randint(1, 6), 0.2, radians(drawn.uniform(0, 50))), drawn.uniform(1.3, 6)
        cut = Cut(tool, length, drawn.uniform(0.1, 5.0), one, "reversal")
        if cut.reverses:
            count -= 1
            yield cut


def asked(cut, load=LOAD):
    points = cycle_of(cut, train_of(cut, load)).points()
    return PointLoad(points, cut.max_angular_speed, float(np.abs(points.output_torque).max()), load.inertia)


def grid(cut, wanted=ANY, **reducer):
    """All pairs of the committed catalogues, of reducers without a no-load torque and with other figures."""
    reducers = engine_reducers([row.model_copy(update={"no_load_torque": 0.0} | reducer)
                                for row in committed_reducers()])  # fmt: skip
    return PairMatrix(asked(cut), engine_motors(committed_motors()), reducers, 0.0, wanted)


@pytest.mark.parametrize("name", SMOOTH)
@pytest.mark.parametrize("length", [0.18, 0.32, 0.9])
def test_means_and_peaks_at_points_are_the_closed_ones(name, length):
    """S5, eqs. (11) to (13), also where a drum waits in the middle of a piece."""
    cut = Cut(DRUM, length, 1.5, law(name))
    load = asked(cut)
    assert load.squares.own == pytest.approx(cut.rms_angular_acceleration**2, rel=1e-6)
    assert load.torque == pytest.approx(0.02 * cut.max_angular_acceleration, rel=1e-12)
    assert np.abs(load.load.speed).max() == pytest.approx(cut.max_angular_speed, rel=5e-3)
    assert load.load.share.sum() == pytest.approx(1.0, rel=1e-12)
    assert load.squares.mixed + load.squares.mixed_back == pytest.approx(0.02 * load.squares.own, rel=1e-12)


def test_the_stroke_by_points_is_within_a_thousandth_of_the_exact():
    off = [abs(np.ptp(furthest(one.points(), one.still)[1]) / cut.stroke - 1.0)
           for cut in cuts(200, 5) for one in [cycle_of(cut, train_of(cut, LOAD))]]  # fmt: skip
    assert max(off) < 1e-3
    assert np.median(off) < 1e-5


def test_one_rule_of_losses_leaves_192_pairs():
    """Counted by the flow of power, as the drive does; with 1/η both ways they were 191.

    Without the fall of the continuous torque from stall to rated torque; with it three more fail.
    """
    found = grid(Cut(DRUM, 0.18, 1.5, law("CIC")))
    level = replace(found, motors=replace(found.motors, rated_torque=found.motors.stall))
    assert (level.verdicts == "yes").sum() == 192
    assert (found.verdicts == "yes").sum() == 189


def test_a_pair_asks_for_what_the_exact_drive_with_it_does():
    cut, pair = Cut(DRUM, 0.32, 1.5, law("MTP")), (1e-3, 7.0, 0.9, 0.2)
    train = train_of(cut, Load(0.02, 3.0), pair)
    exact = DriveResults(DriveCycle(train, MotionPieces(tuple(cut_pieces(cut)), 0.0, cut.cycle_time)))
    found = DrivePoints(cycle_of(cut, train).points())
    assert found.rms_torque == pytest.approx(exact.rms_torque, rel=1e-3)
    assert np.abs(found.torque).max() == pytest.approx(exact.torque.peak, rel=1e-9)


def test_without_losses_and_own_inertia_the_pairs_are_those_in_the_ranges_of_14():
    cut = Cut(DRUM, 0.18, 1.5, law("CIC"))
    found = grid(cut, efficiency=1.0, inertia=None, max_speed=None, max_torque=None)
    m, r = found.motors, found.reducers
    ranges = found.task.ratio_ranges(m)
    inside = (r.ratio >= ranges.lowest[:, None]) & (r.ratio <= ranges.tau_max[:, None])
    able = (found.rms <= m.rated_torque[:, None]) & (found.speed <= m.max_speed[:, None])
    assert (able == inside).all()
    assert 50 < inside.sum() < inside.size


def test_where_the_shaft_stands_counts_as_held_by_the_motor():
    cut = Cut(flying_saw(0.5, 0.04 / (2 * pi)), 2.0, 0.5, law("MTP"))
    cycle = cycle_of(cut, train_of(cut, LOAD))
    assert set(np.unique(cycle.points().direction)) == {-1.0, 1.0}
    assert cycle.still == pytest.approx(1e-9 * max(map(abs, cut.speed_range)))
