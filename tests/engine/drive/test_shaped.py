"""Laws shaped for their drive: a measured machine, a constant inertia, and a drive with losses and process forces."""

import math
import time
from itertools import pairwise

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from engine.drive import Mechanism, Motor, Slide, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain, Window
from engine.drive.limits import LimitChecks
from engine.drive.shaped import Splines
from engine.laws import Dwell, law
from engine.laws.ends import REST, BoundaryValues
from engine.laws.pieces import moved_to
from engine.motion import Motion, Phase

LIFT, TIME = 3.0299, 0.07375  # rad, s
INERTIA = Polynomial([3.62477004e-3, -8.11242143e-5, 1.54632995e-2, -1.01883497e-2, 1.68396654e-3])  # kg m²
LOAD = Polynomial([0.10244372, 1.22240552, -0.13085737, -1.22211419, 0.62392123, -0.08375826])  # Nm


def bolt_torque(y, v, a):
    """The torque of the machine of Van Oosterwyck et al., by its measured inertia and load."""
    return LOAD(y) + INERTIA(y) * a + 0.5 * INERTIA.deriv()(y) * v**2


def shape(torque, lift, time, *family, **more):
    return Splines(*family, **more).shape(torque, lift, time)


def shape_phase(checks, motion, number):
    return Splines(5, pieces=8).shape_phase(checks, motion, number)


def rms_of(move) -> float:
    """By Simpson's rule, piece by piece of the law."""
    total, edges = 0.0, [0.0, *move.breaks, 1.0]
    for low, high in pairwise(edges):
        xi = np.linspace(low + 1e-8, high - 1e-8, 4001)
        s, v, a, _ = move.evaluate(xi)
        squares = bolt_torque(LIFT * s, LIFT / TIME * v, LIFT / TIME**2 * a) ** 2
        weights = np.full(xi.size, 2.0)
        weights[1::2], weights[0], weights[-1] = 4.0, 1.0, 1.0
        total += float(weights @ squares) * (high - low) / (3.0 * (xi.size - 1))
    return math.sqrt(total)


@pytest.mark.parametrize(("name", "printed"), [("TVP", 17.145), ("PO5", 22.502), ("PO7", 28.475)])
def test_the_torque_of_the_measured_machine_is_as_printed(name: str, printed: float) -> None:
    assert round(rms_of(law(name)), 3) == printed


@pytest.mark.parametrize(("degree", "rest", "printed"), [(7, 2, 13.788), (9, 2, 12.479), (9, 3, 16.134)])
def test_a_law_shaped_for_the_measured_machine_takes_the_printed_torque(degree: int, rest: int, printed: float) -> None:
    shaped = shape(bolt_torque, LIFT, TIME, degree, rest)
    assert round(shaped.rms_torque, 3) == printed
    (powers,) = shaped.powers
    s = Polynomial(powers)
    assert s(1.0) == pytest.approx(1.0, abs=1e-9)
    for k in range(1, rest + 1):
        assert [s.deriv(k)(0.0), s.deriv(k)(1.0)] == pytest.approx([0.0, 0.0], abs=1e-7)


@pytest.mark.parametrize("degree", [7, 9, 11, 13])
def test_eight_pieces_of_degree_5_take_less_torque_than_one_of_a_higher_degree(degree: int) -> None:
    begin = time.process_time()
    shaped = shape(bolt_torque, LIFT, TIME, degree)
    assert time.process_time() - begin < 0.3
    assert shape(bolt_torque, LIFT, TIME, 5, pieces=8).rms_torque < shaped.rms_torque


@pytest.mark.parametrize(("degree", "pieces"), [(5, 8), (9, 1)])
@pytest.mark.parametrize("jerk", [math.inf, 200.0, 60.0])
def test_a_shaped_law_neither_overshoots_nor_has_more_jerk_than_its_bound(
    degree: int, pieces: int, jerk: float
) -> None:
    def pulling(y, v, a):
        """The torque of a spring that swings faster than the law: without a bound the law would overshoot."""
        return a + 12000.0 * (y - 1.0)

    for torque in (bolt_torque, pulling):
        shaped, free = (shape(torque, 1.0, TIME, degree, pieces=pieces, jerk=each) for each in (jerk, math.inf))
        assert shaped.rms_torque >= free.rms_torque * (1.0 - 1e-9)
        for duration, powers in zip(shaped.durations, shaped.powers, strict=True):
            s = Polynomial(powers)
            at = np.linspace(0.0, duration, 301)
            assert -1e-9 <= s(at).min() <= s(at).max() <= 1.0 + 1e-9
            assert np.abs(s.deriv(3)(at)).max() <= jerk * (1.0 + 1e-9)


def test_less_jerk_than_any_law_has_is_refused() -> None:
    with pytest.raises(ValueError, match="jerk is 31; no law"):  # c_j of a law whose a is 0 at both ends is at least 32
        shape(bolt_torque, LIFT, TIME, 5, pieces=8, jerk=31.0)


@pytest.mark.parametrize(("degree", "pieces"), [(7, 1), (5, 4), (7, 2)])
def test_the_pieces_of_a_law_take_the_same_torque(degree: int, pieces: int) -> None:
    shaped = shape(bolt_torque, LIFT, TIME, degree, pieces=pieces)
    assert rms_of(shaped.law) == pytest.approx(shaped.rms_torque, rel=1e-6)
    assert shaped.law.end == pytest.approx((1.0, 0.0, 0.0, shaped.law.end.j), abs=1e-9)
    assert shaped.law.coefficients.cj < math.inf


@pytest.mark.parametrize("rest", [1, 2, 3])
def test_no_law_takes_less_of_a_constant_inertia_than_the_cubic(rest: int) -> None:
    each = [shape(lambda y, v, a: a, 1.0, 1.0, degree, rest).rms_torque for degree in (9, 11, 13)]
    each = [round(rms, 12) for rms in each]
    assert each == sorted(each, reverse=True)
    assert min(each) >= math.sqrt(12.0) - 1e-12
    if rest == 1:
        assert each == pytest.approx([math.sqrt(12.0)] * 3)


ENDS = [BoundaryValues(v0=1.0), BoundaryValues(v0=0.4, v1=1.5, a0=3.0, a1=-2.0), BoundaryValues(v0=-0.5, v1=0.3)]


@pytest.mark.parametrize("ends", ENDS)
def test_a_law_between_velocities_has_them_and_takes_less_torque_than_its_neighbours(ends: BoundaryValues) -> None:
    shaped = shape(bolt_torque, LIFT, TIME, 5, pieces=8, ends=ends)
    move = shaped.law
    assert move.start[:3] == pytest.approx((0.0, ends.v0, ends.a0), abs=1e-9)
    assert move.end[:3] == pytest.approx((1.0, ends.v1, ends.a1), abs=1e-9)
    assert rms_of(move) == pytest.approx(shaped.rms_torque, rel=1e-6)
    s = move.s(np.linspace(0.0, 1.0, 2001))
    assert s.max() <= 1.0 + 1e-9
    assert s.min() >= -1e-9 or ends.v0 < 0.0
    for other in (0.99, 1.01) if ends.v0 > 0.0 else ():  # of its rates, and back: other laws between the same ends
        values = BoundaryValues(1.0, *(other * value for value in ends.values[1:]))
        neighbour = moved_to(shape(bolt_torque, LIFT, TIME, 5, pieces=8, ends=values).law, ends)
        assert neighbour.end[:3] == pytest.approx(move.end[:3], abs=1e-9)
        assert rms_of(neighbour) > shaped.rms_torque


@pytest.mark.parametrize("ends", [REST, *ENDS])
def test_no_law_between_velocities_takes_less_of_a_constant_inertia_than_the_cubic(ends: BoundaryValues) -> None:
    v0, v1 = ends.both("v")
    least = math.sqrt(12.0 * (1.0 - v0 - v1) + 4.0 * (v0**2 + v0 * v1 + v1**2))
    assert shape(lambda y, v, a: a, 1.0, 1.0, 7, 1, ends=ends).rms_torque == pytest.approx(least, rel=1e-9)


def test_the_parts_of_a_law_shaped_between_its_own_rates_take_no_more_torque_than_it() -> None:
    whole = shape(bolt_torque, LIFT, TIME)
    s = Polynomial(whole.powers[0])
    y, v, a = s(0.5), 0.5 * s.deriv()(0.5), 0.25 * s.deriv(2)(0.5)
    first = shape(bolt_torque, y * LIFT, TIME / 2.0, ends=BoundaryValues(v1=v / y, a1=a / y))
    rest, ends = 1.0 - y, BoundaryValues(v0=v / (1.0 - y), a0=a / (1.0 - y))
    second = shape(lambda z, v, a: bolt_torque(z + y * LIFT, v, a), rest * LIFT, TIME / 2.0, ends=ends)
    parts = math.sqrt(0.5 * (first.rms_torque**2 + second.rms_torque**2))
    assert 0.9 * whole.rms_torque < parts <= whole.rms_torque


@pytest.mark.parametrize(("degree", "rest", "match"), [(5, 2, "expected 6 to 13"), (15, 2, "13"), (9, 4, "rest is 4")])
def test_another_degree_is_refused(degree: int, rest: int, match: str) -> None:
    with pytest.raises(ValueError, match=match):
        shape(bolt_torque, LIFT, TIME, degree, rest)


def test_a_law_of_too_high_a_degree_is_no_piece() -> None:
    with pytest.raises(ValueError, match="coefficients"):
        _ = shape(bolt_torque, LIFT, TIME, 9).law


def screw(windows=()) -> Drivetrain:
    """A screw up a slope, with losses either way."""
    stages = Stage("reducer", 5.0, 0.8), Stage("screw", 300.0, 0.9)
    mechanism = Mechanism("screw", stages, (), Slide(40.0, 0.1, 0.3, 200.0, 9.81, 0.0).load)
    return Drivetrain(mechanism, 1e-3, no_load=0.1, windows=windows)


def checks_of(move, lift: float, motor: Motor, windows=()) -> tuple[Motion, LimitChecks]:
    motion = Motion([Phase(move, lift, 2.0), Phase(Dwell(), 0.0, 2.0), Phase(law("PO5"), -lift, 2.0)])
    return motion, LimitChecks(DriveCycle(screw(windows), motion, 4.0), motor)


@pytest.mark.parametrize("lift", [0.3, -0.3])
def test_a_phase_whose_rms_torque_limits_has_the_law_of_least_rms_by_the_exact_engine(lift: float) -> None:
    motor, windows = Motor(1e-3, rated_torque=1.0), [Window(0.5, 1.0, 300.0, "moving")]

    def rms(move) -> float:
        return checks_of(move, lift, motor, windows)[1].results.rms_torque

    motion, checks = checks_of(law("MSN"), lift, motor, windows)
    shaped = Splines(7).shape_phase(checks, motion, 0)
    assert rms(shaped.law) < rms(law("MSN"))
    bump = Polynomial([0.0, 1.0, -1.0]) ** 3
    for size in (-0.2, 0.2):
        other = shaped._replace(powers=[(Polynomial(shaped.powers[0]) + size * bump).coef.tolist()])
        assert rms(other.law) > rms(shaped.law)


def test_a_phase_whose_peak_torque_limits_uses_it_less_than_the_law_of_least_rms_torque() -> None:
    _, checks = checks_of(law("PO5"), 0.3, Motor(1e-3))
    peak = checks.results.torque.peak

    def most_use(move, motor: Motor) -> float:
        return checks_of(move, 0.3, motor)[1].worst.use

    by_rms, by_peak = Motor(1e-3, 1.0), Motor(1e-3, 1e3, peak)
    shaped = {motor: shape_phase(*reversed(checks_of(law("PO5"), 0.3, motor)), 0).law for motor in (by_rms, by_peak)}
    assert most_use(shaped[by_peak], by_peak) < 0.97 * most_use(shaped[by_rms], by_peak)
    assert most_use(shaped[by_rms], by_rms) < most_use(shaped[by_peak], by_rms)


@pytest.mark.parametrize("lift", [0.3, -0.3])
def test_a_phase_whose_speed_limits_is_slower_at_its_fastest_whichever_way_it_goes(lift: float) -> None:
    motors = Motor(1e-3, rated_torque=1.0), Motor(1e-3, 1e3, 1e6, max_speed=10.0)
    by_rms, by_speed = (shape_phase(*reversed(checks_of(law("PO5"), lift, motor)), 0).law for motor in motors)
    assert by_speed.coefficients.cv < 0.97 * by_rms.coefficients.cv
