"""Tables are taken apart again: each law of the registry is found from its points, and nothing else for one."""

from itertools import pairwise

import numpy as np
import pytest

from engine import law
from engine.cams.cam_points import CamPoints, precision
from engine.cams.identify import identify, motion_at
from engine.cams.interpolation import quintics, spline
from engine.laws import CATALOGUE, Dwell, PieceLaw
from engine.motion import Motion, Phase
from engine.motion.joining import Rates
from engine.motion.joining import join_phases as join
from engine.motion.profile import profile_of_motion

MOVING = [entry for entry in CATALOGUE if entry not in (Dwell, PieceLaw)]


def motion(entry) -> Motion:
    rest, rise, back = law("dwell"), entry(), law("MTP")
    return Motion([Phase(rest, 0.0, 33.3), Phase(rise, 50.0, 91.7), Phase(rest, 0.0, 55.0), Phase(back, -50.0, 120.0),
                   Phase(rest, 0.0, 60.0)])  # fmt: skip


def found_in(x: np.ndarray, y: np.ndarray):
    return identify(CamPoints(x, y, None, None, precision(y)), spline(x, y, "natural")).phases


@pytest.mark.parametrize("digits", [None, 6, "REAL"])
@pytest.mark.parametrize("entry", MOVING, ids=lambda entry: entry.code)
def test_a_law_is_found_between_points_at_equal_steps(entry, digits) -> None:
    of = profile_of_motion(motion(entry))
    x = np.linspace(0.0, 360.0, 722)
    y = of.at(x).y
    y = y if digits is None else y.astype(np.float32).astype(float) if digits == "REAL" else np.round(y, digits)
    one, other = found_in(x, y)
    same = one.law.s(np.linspace(0.0, 1.0, 101)) - entry().s(np.linspace(0.0, 1.0, 101))
    assert np.abs(same).max() < 1e-7, one.law.name
    assert (one.begin, one.end, one.lift) == pytest.approx((33.3, 125.0, 50.0), abs=2e-3 if digits else 1e-4)
    assert other.law.code == "MTP"
    assert max(one.residual, other.residual) <= {None: 5e-8, 6: 1e-6, "REAL": 1e-5}[digits]


def test_laws_that_are_one_curve_count_as_one_and_the_first_is_named() -> None:
    smooth = [entry() for entry in MOVING]
    at = np.linspace(0.0, 1.0, 51)
    curves = [one.s(at) for one in smooth]
    first = {k: next(i for i, other in enumerate(curves) if np.abs(other - one).max() < 1e-12)
             for k, one in enumerate(curves)}  # fmt: skip
    for k, one in enumerate(smooth):
        of = profile_of_motion(
            Motion([Phase(law("dwell"), 0.0, 90.0), Phase(one, 10.0, 90.0), Phase(law("dwell"), 0.0, 180.0)])
        )
        x = np.linspace(0.0, 360.0, 721)
        (found,) = found_in(x, of.at(x).y)
        assert found.law.name == smooth[first[k]].name


def test_breaks_are_exact_where_points_stand_on_them_with_their_rates() -> None:
    of = profile_of_motion(motion(MOVING[4]))
    at = of.at(of.edges)
    points = CamPoints(of.edges, at.y, at.y1, at.y2, precision(at.y))
    one, other = identify(points, quintics(of.edges, at.y, at.y1, at.y2)).phases
    assert (one.law.code, one.begin, one.end) == (MOVING[4].code, 33.3, 125.0)
    assert (other.begin, other.end, other.lift) == (180.0, 300.0, -50.0)


def bumpy(x: np.ndarray) -> np.ndarray:
    """A rise that no law of the registry is."""
    xi = np.clip((x - 60.0) / 120.0, 0.0, 1.0)
    return 20.0 * (law("polynomial 3-4-5").s(xi) + 0.05 * np.sin(2.0 * np.pi * xi) ** 4 * xi)


@pytest.mark.parametrize("share", [1e-2, 1e-4, 1e-6])
def test_what_keeps_to_no_law_is_a_spline_thinned_to_the_tolerance(share) -> None:
    x = np.linspace(0.0, 360.0, 721)
    y = bumpy(x)
    (one,) = identify(CamPoints(x, y, None, None, precision(y)), spline(x, y, "natural"), share=share).phases
    assert (one.law.code, one.known, one.begin, one.end, one.lift) == ("SPL", False, 60.0, 180.0, 20.0)
    inside = (x >= 60.0) & (x <= 180.0)
    off = np.abs(20.0 * one.law.s((x[inside] - 60.0) / 120.0) - y[inside]).max()
    assert off == pytest.approx(one.residual, rel=1e-6, abs=1e-12)
    assert share * 0.05 * 20.0 < one.residual <= share * 20.0
    assert len(one.law.points) <= {1e-2: 10, 1e-4: 24, 1e-6: 70}[share]


def test_splines_that_part_a_movement_meet_with_one_velocity() -> None:
    """There and back without a rest, and so long that a hundred points do not do."""
    x = np.linspace(0.0, 360.0, 2881)
    there = np.where(x < 120.0, 0.0, 30.0 * np.sin(np.pi * (x - 120.0) / 240.0) ** 2)
    waves = there * (1.0 + 0.05 * np.sin(1.3 * x))
    found = found_in(x, waves)
    assert len(found) >= 3
    assert {one.law.code for one in found} == {"SPL"}
    for one, other in pairwise(found):
        assert one.end == other.begin
        assert one.rates(1)[0] == pytest.approx(other.rates(0)[0], rel=1e-9)
    assert max(one.residual for one in found) <= 1e-4 * np.ptp(waves)


def test_what_follows_points_of_noise_does_not_fit() -> None:
    x = np.linspace(0.0, 360.0, 3000)
    y = np.where((x > 60.0) & (x < 300.0), np.random.default_rng(3).uniform(-1.0, 1.0, x.size), 0.0)
    assert not all(one.fits for one in found_in(x, y))


PASSING = {
    "to line speed, in step, and back": ([("PO5", 30.0, 90.0), ("LIN", 20.0, 40.0), ("PO5", -50.0, 170.0),
                                          ("DWL", 0.0, 60.0)], {}),
    "laws of pulses": ([("DWL", 0.0, 33.3), ("MSN", 30.0, 90.0), ("LIN", 20.0, 40.0), ("MTP", -50.0, 136.7),
                        ("DWL", 0.0, 60.0)], {}),
    "two lines": ([("LIN", 20.0, 50.0), ("PO5", 5.0, 100.0), ("LIN", -40.0, 60.0), ("CUB", 15.0, 150.0)], {}),
    "through a point": ([("PO5", 30.0, 90.0), ("PO5", -30.0, 150.0), ("DWL", 0.0, 120.0)], {1: Rates(0.3, 0.002)}),
    "begins on the way": ([("PO5", 30.0, 90.0), ("PO5", -30.0, 270.0)], {0: Rates(0.3, 0.0), 1: Rates(0.1, 0.0)}),
}  # fmt: skip


EVERY_DAY = ("laws of pulses", "through a point")


@pytest.mark.parametrize(
    ("name", "equidistant"),
    [
        pytest.param(name, equal, marks=[] if name in EVERY_DAY or not equal else pytest.mark.nightly)
        for name in PASSING for equal in (False, True)
    ],
)  # fmt: skip
def test_phases_that_meet_at_speed_are_told_as_they_were(name: str, equidistant: bool) -> None:
    given, through = PASSING[name]
    whole = join([Phase(law(code), lift, span) for code, lift, span in given], through)
    assert not whole.faults
    of = profile_of_motion(whole.motion)
    x = np.linspace(0.0, 360.0, 361) if equidistant else np.unique([*of.edges, *np.linspace(0.0, 360.0, 37)])
    at = of.at(x)
    y, rates = at.y, (None, None) if equidistant else (at.y1, at.y2)
    rebuilt = spline(x, y, "not-a-knot") if equidistant else quintics(x, y, at.y1, at.y2)
    found = identify(CamPoints(x, y, *rates, precision(y)), rebuilt).phases
    meant = [phase for phase in given if phase[0] != "DWL"]
    if equidistant and through:  # where two curved phases meet is not to be seen in positions alone
        assert max(one.residual for one in found) <= 1e-4 * np.ptp(y)
        return
    assert [one.law.code for one in found] == [phase[0] for phase in meant]
    for one, (_, lift, span) in zip(found, meant, strict=True):
        assert (one.lift, one.end - one.begin) == pytest.approx((lift, span), abs=1e-4 if equidistant else 1e-8)
        assert one.residual < 1e-6


def test_a_cycle_that_begins_on_the_way_is_told_from_its_dwell_on() -> None:
    of = profile_of_motion(motion(MOVING[4])).shifted(200.0)
    x = np.linspace(0.0, 360.0, 721)
    y = of.at(x).y
    points = CamPoints(x, y, None, None, precision(y))
    read = identify(points, spline(x, y, "periodic"), turns=True)
    one, other = read.phases
    assert (one.law.code, other.law.code) == (MOVING[4].code, "MTP")
    begins = sorted((phase.begin + read.delay) % 360.0 for phase in (one, other))
    assert begins == pytest.approx(sorted([233.3, 20.0]), abs=1e-3)


def test_precision_is_that_of_the_numbers() -> None:
    y = np.random.default_rng(5).uniform(0.0, 100.0, 50)
    assert precision(np.round(y, 3)) == 0.0005
    assert precision(y.astype(np.float32).astype(float)) == pytest.approx(100.0 * 2**-24, rel=0.1)
    assert precision(y) < 1e-12


def zigzag(*corners):
    """A motion of straight lines, by its corners."""
    x, y = np.array(corners, dtype=float).T
    return lambda at: np.interp(at, x, y)


ZIGZAGS = {
    "triangle": ((0, 0), (180, 20), (360, 0)),
    "its apex between points": ((0, 0), (133.3, 20), (360, 0)),
    "tenths a step": ((0, 0), (180, 18), (360, 0)),  # of numbers of one decimal: each step could be rounding
    "saw": ((0, 0), (90, 7), (95, 0), (185, 7), (190, 0), (360, 0.0)),
    "three slopes": ((0, 5), (100, 15), (200, 65), (360, 5)),
    "between dwells": ((0, 0), (60, 0), (160, 10), (200, 10), (300, 0), (360, 0)),
    "from the middle of a line": ((0, 11), (80, 20), (260, 0), (360, 11)),
}  # fmt: skip


@pytest.mark.parametrize("step", [0.5, 1.0, 5.0])
@pytest.mark.parametrize("name", ZIGZAGS)
def test_lines_that_join_without_a_rest_are_told_each_by_itself(name: str, step: float) -> None:
    corners = ZIGZAGS[name]
    x = np.arange(0.0, 360.0 + step, step)
    y = zigzag(*corners)(x)
    found = identify(CamPoints(x, y, None, None, precision(y)), spline(x, y, "not-a-knot")).phases
    meant = [(a, b, z - w) for (a, w), (b, z) in pairwise(corners) if z != w]
    assert [one.law.code for one in found] == ["LIN"] * len(meant)
    near = [pytest.approx(one, abs=1e-6) for one in meant]
    assert [(one.begin, one.end, one.lift) for one in found] == near


SHARP = {
    "a law back": [("LIN", 20.0, 100.0), ("CIC", -20.0, 160.0), ("DWL", 0.0, 100.0)],
    "a law there": [("DWL", 0.0, 40.0), ("MTP", 20.0, 120.0), ("LIN", -20.0, 200.0)],
    "farther": [("LIN", 20.0, 100.0), ("PO5", 30.0, 100.0), ("LIN", -50.0, 160.0)],
    "farther and back": [("DWL", 0.0, 20.0), ("LIN", 20.0, 80.0), ("MSN", 30.0, 100.0), ("PO5", -50.0, 160.0)],
}


@pytest.mark.parametrize("digits", [5, 12])
@pytest.mark.parametrize("name", SHARP)
def test_a_law_that_meets_a_line_at_a_corner_is_told_as_the_law(name: str, digits: int) -> None:
    """Its own end is at rest there, not as fast as the line."""
    x, y, at, level, meant = np.linspace(0.0, 360.0, 361), np.zeros(361), 0.0, 0.0, []
    for code, lift, span in SHARP[name]:
        if code != "DWL":
            y = np.where(x > at, level + lift * law(code).s(np.clip((x - at) / span, 0.0, 1.0)), y)
            meant.append((code, at, at + span, lift))
        at, level = at + span, level + lift
    found = found_in(x, np.round(y, digits))
    assert [one.law.code for one in found] == [code for code, *_ in meant]
    for one, (_, *figures) in zip(found, meant, strict=True):
        assert (one.begin, one.end, one.lift) == pytest.approx(figures, abs=1e-6 if digits > 9 else 0.01)


TRIANGLE = ((0, 0), (90, 10), (180, 20), (270, 10), (360, 0))


@pytest.mark.parametrize("corners", [TRIANGLE, ((0, 0), (180, 20), (360, 0)), ((0, 0), (350, 20), (360, 0)),
                                     ((0, 0), (90, 10), (180, 10), (360, 0))])  # fmt: skip
def test_few_points_at_speed_are_joined_by_lines(corners) -> None:
    x, y = np.array(corners, dtype=float).T
    found = found_in(x, y)
    assert {one.law.code for one in found} == {"LIN"}
    assert motion_at(found, x, 0.0) == pytest.approx(y, abs=1e-12)


def test_points_that_creep_are_no_dwell() -> None:
    """A slope of half of the last decimal a point: no two neighbours differ by more than their rounding."""
    x = np.linspace(0.0, 360.0, 361)
    y = np.round(0.0005 * x, 3)
    found = found_in(x, y)
    assert np.abs(motion_at(found, x, y[0]) - y).max() <= 0.001
    assert sum(one.lift for one in found) == pytest.approx(0.18, abs=0.001)


@pytest.mark.parametrize("number", range(12))
def test_the_motion_that_is_told_goes_through_every_point(number: int) -> None:
    """Tables of laws, lines and waves at random, of few digits and of many, at equal steps."""
    drawn = np.random.default_rng(number)
    corners = np.sort(np.append(drawn.uniform(10.0, 350.0, 3), [0.0, 360.0]))
    levels = np.append(np.round(drawn.uniform(-20.0, 20.0, 4), 1), 0.0)
    x = np.linspace(0.0, 360.0, int(drawn.choice([37, 181, 361])))
    y = zigzag(*zip(corners, levels, strict=True))(x) + drawn.choice([0.0, 1.0]) * np.sin(np.radians(x)) ** 2
    y = np.round(y, int(drawn.choice([2, 3, 12])))
    read = identify(CamPoints(x, y, None, None, precision(y)), spline(x, y, "not-a-knot"))
    assert not all(one.fits for one in read.phases) or np.abs(motion_at(read.phases, x, y[0]) - y).max() <= read.allowed
    assert read.allowed <= max(1e-4 * np.ptp(y), 6.0 * precision(y))
