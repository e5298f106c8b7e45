"""Random machines, and what tests of drives share."""

import random
from dataclasses import replace
from itertools import pairwise
from math import pi, radians

import numpy as np

from engine.drive import KINDS, Part, Slide, Stage
from engine.drive.cycle import DriveCycle
from engine.drive.drive_points import DrivePoints
from engine.drive.drivetrain import Drivetrain, Window
from engine.drive.mechanisms.slides import crank_slider, rocker
from engine.drive.mechanisms.variable_ratio import PositionTable
from engine.drive.quadrature import QuadratureCycle
from engine.laws import Dwell
from engine.motion import Motion, Phase
from engine.motion.joining import Rates, join_phases
from engine.motion.pieces import motion_pieces
from tests.engine.families import ENTRIES

TURN = 2 * pi
SIZES = {"lead screw": (50, 200), "conveyor": (0.05, 0.3), "rack and pinion": (0.03, 0.1), "belt": (0.03, 0.1),
         "rotary table": (1, 1), "gear train": (1, 1), "feed rollers": (0.05, 0.2)}  # fmt: skip
LINKAGES = {
    "crank-slider": (lambda: crank_slider(0.05, 0.2, 0.02), 0.02, 0.06),
    "rocker": (lambda: rocker(0.1, 0.15, 0.1, 1.6), -0.05, 0.05),
    "table": (lambda: PositionTable([(k / 9, 0.05 - 0.05 * np.cos(0.2 + k / 9)) for k in range(25)]), 0.005, 0.09),
}
RISING = [law for entry in ENTRIES for law in entry.examples if abs(law.end.s - 1) < 1e-9]
LAWS = [law for law in RISING if abs(law.start.v) + abs(law.end.v) < 1e-9]
"""those from rest to rest: others would jump, and no motor follows a jump"""
STRAIGHT = [entry for entry in ENTRIES if entry.code == "LIN"]


def motion_of(rng, low, high):
    """A motion within two positions: rises, returns and dwells of any law, from rest to rest, or handing over."""
    phases, y, start = [], low, low + rng.random() * (high - low)
    y = start
    for _ in range(rng.randint(1, 4)):
        if rng.random() < 0.5:
            phases.append(Phase(Dwell(), 0.0, rng.uniform(0.2, 1)))
        goal = low + rng.random() * (high - low)
        phases.append(Phase(rng.choice(LAWS), goal - y, rng.uniform(0.3, 1)))
        y = goal
    phases.append(Phase(rng.choice(LAWS), start - y, rng.uniform(0.3, 1)))
    total = sum(phase.duration for phase in phases)
    phases = [replace(phase, duration=phase.duration / total * TURN) for phase in phases]
    return Motion(phases, position=start)


def handing_over(rng, low, high):
    """A motion of quintics and straight lines that hand over at speed; within two positions, more or less."""
    law = next(law for law in LAWS if law.code == "PO5")
    straight = STRAIGHT[0].examples[0]
    h = 0.2 * (high - low)
    phases = [Phase(law, h, 1.2), Phase(straight, h, 0.9), Phase(law, 0.3 * h, 1.0), Phase(Dwell(), 0.0, 0.8),
              Phase(law, -0.9 * h, 1.1), Phase(law, -1.4 * h, TURN - 5.0)]  # fmt: skip
    made = join_phases(phases, {5: Rates(-0.3 * h, rng.uniform(-0.2, 0.2) * h)}, position=low + 0.3 * (high - low))
    assert not made.faults
    return made.motion


def train_of(rng, kind, method="physical", lossless=False):
    """A drive of any kind, and a motion's lowest and highest position for it."""
    eta = (lambda: 1.0) if lossless else (lambda: rng.choice([1.0, rng.uniform(0.5, 1)]))
    gears = [Stage(f"gear {k}", rng.uniform(1, 8), eta()) for k in range(rng.randint(0, 2))]
    gears = rubbing(gears) if len(gears) == 2 and not lossless else gears
    parts = [Part(f"part {k}", rng.uniform(0, 1e-3), k) for k in range(len(gears) + 1)]
    load = Slide(rng.uniform(0.5, 20), rng.uniform(0, 0.3), rng.uniform(-0.5, 0.5), rng.uniform(-50, 50)).load
    if kind in LINKAGES:
        make, low, high = LINKAGES[kind]
        mechanism, linkage = KINDS[kind].of(load, 1.0, eta(), gears, parts), make()
    else:
        mechanism, linkage = KINDS[kind].of(load, rng.uniform(*SIZES[kind]), eta(), gears, parts, 1.0), None
        low, high = (0.0, 0.3) if KINDS[kind].turns else (0.0, radians(90))
    windows = [Window(rng.uniform(0, TURN), rng.uniform(0, TURN), rng.uniform(-100, 100),
                      rng.choice(["always", "moving"])) for _ in range(rng.randint(0, 2))]  # fmt: skip
    inertia = rng.uniform(0, 2e-3)
    own = method, rng.choice(["motor", "brake"]), 200.0 * inertia if gears else 0.0
    copper, viscous = 500.0 * inertia if len(gears) == 1 else 0.0, rng.choice([0.0, rng.uniform(0, 100)])
    more = {"linkage": linkage, "viscous": viscous, "windows": tuple(windows)}
    return Drivetrain(mechanism, inertia, *own, copper, **more), low, high


def rubbing(gears):
    """The same stages with friction on their outputs, the last with an efficiency backward of its own."""
    drawn = random.Random(str(gears))
    *gears, last = [replace(gear, friction=drawn.choice([0.0, drawn.uniform(0, 3)])) for gear in gears]
    return [*gears, replace(last, back_efficiency=drawn.choice([None, -0.2, drawn.uniform(-1, last.efficiency)]))]


def drive_cycle_of(number, lossless=False, from_rest=False, kinds=(*SIZES, *LINKAGES, *LINKAGES)):
    """A machine of one axis, drawn by a number or a text."""
    rng = random.Random(str(number))
    train, low, high = train_of(rng, rng.choice(kinds), rng.choice(["physical", "physical", "document"]), lossless)
    make = motion_of if from_rest or rng.random() < 0.7 else handing_over
    motion = make(rng, low, high)
    while train.linkage and not reaches(train.linkage, motion):  # some laws go beyond their ends, and motions at speed
        motion = make(rng, low, high)
    return DriveCycle(train, motion, rng.uniform(1, 20), rng.choice([0.0, rng.uniform(-7, 7)]))


def reaches(linkage, motion):
    """Whether a linkage reaches all positions of a motion."""
    low, high, *_ = linkage.reach
    return bool(np.all(np.clip(y := motion.at(np.linspace(0, TURN, 2000)).y, low, high) == y))


def points_of(drive_cycle):
    """A drive at the points of its cycle."""
    pieces = motion_pieces(drive_cycle.motion)
    return DrivePoints(QuadratureCycle(drive_cycle, pieces, 3e-9 * drive_cycle.unshifted.total).points())


def sampled(drive_cycle, n=4001):
    """Motor speed, torque and power within every stretch of the phases, by the laws' closed forms and the chain alone.

    Of each stretch between breaks of law and edges of windows a row; a hair off its ends.
    """
    m, cycle = drive_cycle.motion, drive_cycle.motion.total
    cuts = [m.edges[k] + p.duration * b for k, p in enumerate(m.phases) for b in (0.0, *p.law.breaks)]
    edges = [edge - drive_cycle.shift for window in drive_cycle.train.windows for edge in (window.begin, window.end)]
    cuts += [m.edges[0] + (edge - m.edges[0]) % cycle for edge in edges]
    cuts = np.unique([*cuts, m.edges[-1]])
    cuts = cuts[np.concatenate([[True], np.diff(cuts) > 1e-6 * cycle])]
    rows = []
    for low, high in pairwise(cuts):
        x = low + 4e-8 * cycle + (high - low - 8e-8 * cycle) * np.linspace(0, 1, n)
        rows.append((x, *operated(drive_cycle, x)))
    return rows


def operated(drive_cycle, x):
    """Speed and torque of the motor at x, by the chain's own rules, sample by sample."""
    train, w = drive_cycle.train, drive_cycle.speed
    m = train.mechanism
    y, v, a, _ = drive_cycle.motion.at_speed(x, w)
    motion = drive_cycle.motion
    phase = np.clip(np.searchsorted(motion.edges, x + motion.tolerance, side="right") - 1, 0, len(motion.phases) - 1)
    moving = np.array([not isinstance(p.law, Dwell) and p.lift != 0 for p in drive_cycle.motion.phases])[phase]
    going = np.where(moving, np.sign(v), 0.0)
    force = m.load.resisting(going) + train.viscous * v + m.on_shaft(m.last) * a
    for window in train.windows:
        cycle = drive_cycle.motion.total
        on = (x + drive_cycle.shift - window.begin) % cycle < (window.end - window.begin) % cycle
        force = force + np.where(on, window.load.resisting(going), 0.0)
    if train.linkage:
        _, first, second = train.linkage.shaft(y)
    else:
        first, second = np.full(x.shape, m.stages[-1].ratio), np.zeros(x.shape)
    speed, acceleration = first * v, second * v**2 + first * a
    torque, ratio = force, first
    for k in reversed(range(m.last)):
        eta = m.stages[k].efficiency
        back = (torque * going < 0) & (train.method == "physical")
        one = m.stages[k].back_efficiency
        backward = eta if one is None or train.method == "document" else one
        torque = np.where(back, backward, np.where((going == 0) & (backward <= 0), 0.0, 1 / eta)) * torque / ratio
        if k < m.last - 1:
            speed, acceleration = speed * m.stages[k].ratio, acceleration * m.stages[k].ratio
        torque = torque + m.on_shaft(k) * acceleration + (m.stages[k - 1].friction * going if k else 0.0)
        ratio = m.stages[k - 1].ratio
    torque = torque + train.motor_inertia * acceleration + train.no_load * going
    return speed, np.where((going == 0) & (train.holding == "brake"), 0.0, torque)


def electric(drive, speed, torque):
    """Power of a motor with the losses of its winding."""
    return speed * torque + drive.copper * torque**2
