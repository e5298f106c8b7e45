"""A load with backlash: when it leaves its side and how it strikes, by closed forms and by the free load integrated."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from engine.drive import Load, Mechanism, Part, Stage
from engine.drive.backlash import Backlash
from engine.drive.cycle import DriveCycle
from engine.drive.drivetrain import Drivetrain, Window
from engine.drive.mechanisms.by_angle import PressCrank
from engine.laws import Dwell, law
from engine.motion import Motion, Phase
from tests.engine.drive.machines import LINKAGES

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)

MASS, LIFT, GAP, SPEED = 5.0, 0.2, 2e-4, 8.0
QUARTER = math.pi / 2
TIME = QUARTER / SPEED


def cycle(code, load=None, windows=()):
    """A mass that travels there and back, each in a quarter of the cycle, with rests between."""
    rest = Phase(Dwell(), 0.0, QUARTER)
    phases = [Phase(law(code), LIFT, QUARTER), rest, Phase(law(code), -LIFT, QUARTER), rest]
    mechanism = Mechanism("screw", (Stage("screw", 200.0),), (), load or Load(MASS))
    return DriveCycle(Drivetrain(mechanism, 1e-4, windows=windows), Motion(phases), SPEED)


def test_behind_a_jump_it_strikes_as_under_a_constant_acceleration():
    """The law of constant acceleration turns from a to −a half-way: t = √(2 b/a), Δv = √(2 a b)."""
    a = 4.0 * LIFT / TIME**2
    moments = list(Backlash(cycle("ACS"), GAP).crossings)
    assert [moment.phase for moment in moments] == [0, 2]  # across a rest it stays on its side
    for moment, at in zip(moments, (0.5 * QUARTER, 2.5 * QUARTER), strict=True):
        assert moment.x == pytest.approx(at)
        assert moment.time == pytest.approx(math.sqrt(2.0 * GAP / a))
        assert moment.shock == pytest.approx(math.sqrt(2.0 * a * GAP))


def test_where_the_force_passes_0_it_strikes_as_under_a_constant_jerk():
    """The cycloid passes 0 half-way with the slope (2π)² h/T³; of a small gap Δv = (9/2 b² j)^⅓."""
    jerk, gap = (2.0 * math.pi) ** 2 * LIFT / TIME**3, 1e-9
    moment, _ = Backlash(cycle("CIC"), gap).crossings
    assert moment.time == pytest.approx((6.0 * gap / jerk) ** (1.0 / 3.0), rel=1e-4)
    assert moment.shock == pytest.approx((4.5 * gap**2 * jerk) ** (1.0 / 3.0), rel=1e-4)


@pytest.mark.parametrize("code", ["CIC", "MTP", "PO5", "ACS"])
@pytest.mark.parametrize("friction", [0.0, 12.0])
def test_it_strikes_as_the_free_load_integrated(code, friction):
    driven = cycle(code, Load(MASS, torque=-7.0, friction=friction))
    moment = next(iter(Backlash(driven, GAP).crossings))
    motion, start = driven.motion, moment.x / SPEED

    def at(t):
        return motion.at(np.array([t * SPEED % motion.total]))

    def free(t, both):
        forces = -7.0 + friction * np.sign(at(t).y1[0])
        return [both[1], -forces / MASS]

    def gone(t, both):
        return both[0] - at(t).y[0] - side * GAP

    gone.terminal = True
    begin = [at(start + 1e-12).y[0], at(start + 1e-12).y1[0] * SPEED]
    ahead = at(start + 1e-4).y2[0] * SPEED**2 * MASS - 7.0 + friction * np.sign(at(start + 1e-4).y1[0])
    side = -float(np.sign(ahead))  # driven forward, it falls back against the motion
    solved = solve_ivp(free, (start, start + 2.0 * TIME), begin, events=gone, rtol=1e-10, atol=1e-13, max_step=1e-4)
    (struck,) = solved.t_events[0]
    step = abs(solved.y_events[0][0][1] - at(struck).y1[0] * SPEED)
    assert struck - start == pytest.approx(moment.time, rel=1e-4)
    assert step == pytest.approx(moment.shock, rel=1e-4)


def test_a_process_force_keeps_it_on_its_side():
    """While 400 N resist, more than braking needs, the load is driven forward throughout."""
    first = Window(0.0, QUARTER, 400.0, "moving")
    gap = Backlash(cycle("CIC", windows=(first,)), GAP)
    most = MASS * 2.0 * math.pi * LIFT / TIME**2
    backward, forward = gap.sides(first)
    assert (backward, forward) == (max(0.0, most - 400.0), pytest.approx(400.0 + most))
    half = Window(0.5 * QUARTER, QUARTER, 0.0)
    assert Backlash(cycle("CIC", windows=(half,)), GAP).sides(half) == (
        pytest.approx(most),
        pytest.approx(0.0, abs=1e-6),
    )
    never = Window(1.0, 1.0, 0.0)
    assert Backlash(cycle("CIC", windows=(never,)), GAP).sides(never) == (0.0, 0.0)


def test_a_load_falls_back_where_the_force_turns_again_before_it_is_across():
    """The force is forward for 1 ° only while the rest has weight against it: it is thrown and falls back."""
    push = Window(1.2 * QUARTER, 1.21 * QUARTER, -60.0)
    back = [
        moment for moment in Backlash(cycle("CIC", Load(MASS, 50.0), (push,)), 1e-3).crossings if moment.shock < 0.0
    ]
    assert [moment.phase for moment in back] == [1]
    time = 0.01 * QUARTER / SPEED  # −10 N for so long, then 50 N back
    thrown, place = 10.0 / MASS * time, 5.0 / MASS * time**2
    assert back[0].shock == pytest.approx(-math.sqrt(thrown**2 + 2.0 * 50.0 / MASS * place), rel=1e-6)


@pytest.mark.parametrize("kind", ["press crank", *LINKAGES])
def test_what_it_accelerates_is_what_the_torque_does(kind):
    """Without losses and resistance the work of the torque through the gap is the energy of all behind it."""
    stages = (Stage("reducer", 4.0), Stage("belt", 2.5), Stage(kind, 1.0))
    parts = tuple(Part(f"{shaft}", 0.002 * (1 + shaft), shaft) for shaft in range(3))
    drive = Drivetrain(Mechanism(kind, stages, parts, Load(MASS)), 1e-4)
    if kind == "press crank":
        driven, low, high = replace(drive, by_angle=PressCrank(0.05, 0.2)), 0.0, 5.0
    else:
        make, low, high = LINKAGES[kind]
        driven = replace(drive, linkage=make())
    phases = [Phase(law("CIC"), high - low, 3.0), Phase(law("CIC"), low - high, 2.0 * math.pi - 3.0)]
    backlash = Backlash(DriveCycle(driven, Motion(phases, position=low), SPEED), 1e-3)
    work, seen = 0.0, 0
    for part in backlash.cycle.torque_intervals[:-1]:
        edges = part.samples
        for begin, end in pairwise(edges):
            u, weights = 0.5 * (begin + end) + 0.5 * (end - begin) * NODES, 0.5 * (end - begin) * WEIGHTS
            work += weights @ (part.torque(u, 1) * part.motor_speed(u) / 4.0) / SPEED
        u = np.array([part.high])
        inertia = part.torque(u, 1) * part.motor_speed(u) / 4.0 / part.load(u).v / backlash.acceleration(part, u)
        if abs(part.load(u).v[0]) > 1e-3 and abs(part.torque(u, 1)[0]) > 1e-3:
            seen += 1
            assert work == pytest.approx(0.5 * inertia[0] * part.load(u).v[0] ** 2, rel=1e-6)
    assert seen


def test_what_has_no_inertia_is_told():
    with pytest.raises(ValueError, match="what has no inertia"):
        list(Backlash(cycle("CIC", Load(0.0, 3.0)), GAP).crossings)
