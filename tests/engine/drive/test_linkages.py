"""Mechanisms of a changing ratio, against positions worked out here the other way round and differentiated."""

from math import pi, sqrt

import numpy as np
import pytest
from numpy.polynomial import chebyshev

from engine.drive.mechanisms.slides import crank_slider, rocker
from engine.drive.mechanisms.variable_ratio import OutOfReachError, PositionTable
from tests.engine.drive import machines

CRANKS = [
    (0.05, 0.2, offset, zero, branch)
    for offset in (0.0, 0.03, -0.06)
    for zero in ("inner", "outer")
    for branch in ("ahead", "behind")
]
ROCKERS = [
    (0.1, 0.15, 0.1, pi / 2 + 0.1, True, 1),
    (0.1, 0.15, 0.12, 1.2, False, -1),
    (0.1, 0.3, -0.02, 0.9, True, -1),
    (0.2, 0.12, 0.15, 1.2, True, 1),
    (0.08, 0.35, 0.3, 0.4, True, 1),
]
POINTS = [(0.0, 0.0), (1.0, 0.01), (2.0, 0.03), (2.5, 0.031), (4.0, 0.2)]


def crank_way(crank, rod, offset, zero, branch):
    """y over the crank's way from its dead centre, by the loop of lever, rod and slide."""
    start = {"inner": pi + np.arcsin(offset / (rod - crank)), "outer": np.arcsin(offset / (rod + crank))}[zero]
    first = sqrt((rod + (crank if zero == "outer" else -crank)) ** 2 - offset**2)
    turn = {("inner", "ahead"): -1, ("inner", "behind"): 1, ("outer", "ahead"): 1, ("outer", "behind"): -1}

    def y(angle):
        psi = start + turn[zero, branch] * angle
        x = crank * np.cos(psi) + np.sqrt(rod**2 - (crank * np.sin(psi) - offset) ** 2)
        return x - first if zero == "inner" else first - x

    return y


def rocker_way(lever, link, offset, angle, ahead, direction):
    """y over the lever's way, which turns so that y rises."""

    def x(psi):
        return lever * np.cos(psi) + (1 if ahead else -1) * np.sqrt(link**2 - (lever * np.sin(psi) - offset) ** 2)

    sense = 1 if direction * (x(angle + 1e-3) - x(angle - 1e-3)) > 0 else -1
    return lambda phi: direction * (x(angle + sense * phi) - x(angle))


def linkages():
    for given in CRANKS:
        yield pytest.param(crank_slider(*given), crank_way(*given), id=f"crank {given}")
    for given in ROCKERS:
        yield pytest.param(rocker(*given), rocker_way(*given), id=f"rocker {given}")


LINKAGES = list(linkages())


def inside(linkage, n=41, margin=0.02):
    low, high, *_ = linkage.reach
    return np.linspace(low + margin * (high - low), high - margin * (high - low), n)


def derivatives(function, angle, span):
    """First and second derivative of a function at an angle, by a polynomial through its neighbours."""
    t = np.cos(np.pi * (np.arange(14) + 0.5) / 14)
    c = chebyshev.chebfit(t, function(angle + span * t), 13)
    return [chebyshev.chebval(0.0, chebyshev.chebder(c, m)) / span**m for m in (1, 2)]


def test_every_mechanism_of_a_changing_ratio_is_here():
    assert {one.values[0].name for one in LINKAGES} | {"table"} == set(machines.LINKAGES)


@pytest.mark.parametrize(("linkage", "way"), LINKAGES)
def test_the_angle_brings_the_slide_to_its_position(linkage, way):
    y = inside(linkage, margin=1e-3)
    assert way(linkage.shaft(y).angle) == pytest.approx(y, abs=1e-13)


@pytest.mark.parametrize(("linkage", "way"), LINKAGES)
def test_ratio_and_its_change_against_differentiated_positions(linkage, way):
    ends = linkage.shaft(inside(linkage, 2, 1e-6)).angle
    for y in inside(linkage, 9, 0.05):
        angle, first, second = (float(one) for one in linkage.shaft(y))
        rate, bend = derivatives(way, angle, 0.2 * np.abs(ends - angle).min())
        assert first == pytest.approx(1 / rate, rel=1e-9)
        assert second == pytest.approx(-bend / rate**3, rel=1e-8, abs=1e-9 * first**2)
        assert first > 0


@pytest.mark.parametrize(("linkage", "way"), LINKAGES)
def test_the_reach_ends_where_the_ratio_grows_beyond_all_bounds_or_vanishes(linkage, way):
    for end, sign in ((linkage.reach.low, 1), (linkage.reach.high, -1)):
        span = linkage.reach.high - linkage.reach.low
        near, nearer = (float(linkage.shaft(end + sign * span * d).first) for d in (1e-4, 1e-6))
        assert nearer > 5 * near or nearer < near / 5


def test_the_stroke_of_a_crank_slider():
    assert crank_slider(0.05, 0.2).reach.high == pytest.approx(0.1, rel=1e-14)
    assert crank_slider(0.05, 0.2, 0.03).reach.high == pytest.approx(sqrt(0.0616) - sqrt(0.0216), rel=1e-14)


# A table


def test_a_table_passes_through_its_points_and_rises():
    table = PositionTable(POINTS)
    angle, y = np.array(POINTS).T
    assert table.shaft(y).angle == pytest.approx(angle, abs=1e-14)
    found = table.shaft(np.linspace(0, 0.2, 20001))
    assert (np.diff(found.angle) > 0).all()
    assert (found.first > 0).all()


def test_a_tables_ratio_is_continuous_and_its_derivatives_are_those_of_its_angle():
    table = PositionTable(POINTS)
    for knot in table.knots:
        left, right = (float(table.shaft(knot * (1 + way * 1e-13)).first) for way in (-1, 1))
        assert left == pytest.approx(right, rel=1e-8)
    y, h = np.array([0.005, 0.02, 0.0305, 0.1, 0.17]), 1e-6
    middle, above, below = table.shaft(y), table.shaft(y + h), table.shaft(y - h)
    assert middle.first == pytest.approx((above.angle - below.angle) / (2 * h), rel=1e-4)
    assert middle.second == pytest.approx((above.first - below.first) / (2 * h), rel=1e-3, abs=1e-3)


def test_a_table_rises_on_steep_points():
    """Its ratio is positive everywhere, and continuous with its derivative at each point."""
    table = PositionTable([(0.0, 0.0), (1.0, 0.001), (2.0, 1.0), (3.0, 1.001)])
    assert (table.shaft(np.linspace(0.0, 1.001, 20001)).first > 0.0).all()
    for knot in table.knots:
        before, after = (table.shaft(knot * (1 + way * 1e-12)) for way in (-1, 1))
        assert before.first == pytest.approx(after.first, rel=1e-6)
        assert before.second == pytest.approx(after.second, rel=1e-6, abs=1.0)  # of 1e6 1/m²


# Out of reach


def test_a_position_out_of_reach_is_told_with_its_amount():
    table = PositionTable(POINTS)
    with pytest.raises(OutOfReachError, match=r"end of the table, by 0\.01"):
        table.shaft([0.1, 0.21])
    assert table.beyond(0.2) is None
    crank = crank_slider(0.05, 0.2)
    assert crank.beyond(0.05) is None
    assert crank.beyond(0.0).by == 0.0
    assert crank.beyond(0.0).end == "inner dead centre"
    assert crank.beyond(0.13).by == pytest.approx(0.03)
    assert crank_slider(0.05, 0.2, zero="outer").beyond(-0.01).end == "outer dead centre"


def test_what_cannot_be_is_refused():
    for given, words in (
        ((0.05, 0.05), "more than crank and offset"),
        ((0.05, 0.1, 0.06), "more than crank and offset"),
        ((-0.05, 0.1), "above 0"),
    ):
        with pytest.raises(ValueError, match=words):
            crank_slider(*given)
    with pytest.raises(ValueError, match="reaches"):
        rocker(0.1, 0.05, -0.1, pi / 2)
    with pytest.raises(ValueError, match="out of line"):
        rocker(0.1, 0.15, 0.0, 0.0)
    with pytest.raises(ValueError, match="point 3"):
        PositionTable([(0, 0), (1, 1), (2, 1)])
    with pytest.raises(ValueError, match="at least two"):
        PositionTable([(0, 0)])
