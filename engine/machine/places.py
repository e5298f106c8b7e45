"""A drive at places of a motion, and what is found from them alone: reversals, extremes. SI units.

It is how a table of cells works a drive of a changing ratio, or with viscous friction, out;
:mod:`engine.machine.demand` goes another way. In a stretch direction and process force stay as they are, so everything
in it is smooth but where power turns round.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from engine.drivetrain.losses import loss_factor
from engine.laws.base import Array
from engine.machine.bent import Scales
from engine.machine.demand import Demand
from engine.machine.train import Force, Motion3, Train
from engine.motion import Phase
from engine.motion.pieces import MotionPiece

LOST = 1e-9
"""of a quantity's size: what is smaller has no sign"""
LOOKS = np.linspace(0.0, 1.0, 7)
"""places of a stretch, as shares of it, at which it is asked which way power goes"""
LONG = 0.3
"""of a phase: a longer piece is halved"""
GAUSS = 18
_RULE = np.polynomial.legendre.leggauss(GAUSS)
NODES = np.array([-1.0, *_RULE[0], 1.0])
"""places of a section from −1 to 1: its ends, and those of Gauss's rule"""
WEIGHTS = np.array([0.0, *_RULE[1], 0.0])
LAST = (GAUSS - 0.5) * WEIGHTS * np.polynomial.legendre.legval(NODES, [0.0] * (GAUSS - 1) + [1.0])
"""by which values at the nodes give the last coefficient of their series of Legendre's polynomials"""
_DISTANCES = NODES[:, None] - NODES + np.eye(NODES.size)
INTERPOLATING = np.abs(np.prod(_DISTANCES, axis=1)).min() / np.prod(_DISTANCES, axis=1)
"""weights of the barycentric formula. Source: J.-P. Berrut, L. N. Trefethen, Barycentric Lagrange interpolation, SIAM
Review 46 (2004) 501–517"""
FIRST = 2.0 ** np.arange(NODES.size - 1, -1, -1)
"""powers of 2, which tell the first of several places"""
WIDTHS = 0.02, 0.005, 0.001
"""of half a section: how far apart the places of three parabolas are, one after the other"""
FARTHEST = (*(1.0 - width - WIDTHS[-1] for width in WIDTHS[:-1]), 1.0 - 1e-5)
"""how far from the middle the places of each lie at most: those of the last may lie beside an end of the section"""
LEVEL = 0.01
"""of what is next to nothing: how little a section's values may differ to be level"""
KNOWN = 2e4
"""on a nearly level top a place is known to two parts: 1e-9 of this"""
FINE = 1e5
"""parts of half a section; places lie in one, never on a node"""
WITHIN = 0.25
"""of a part: where places lie in it, and 0 too, which a top of symmetric values is but for rounding"""
FAR, BEYOND = 20.0, 1.5
"""how far from their places, in their distance, both parabolas are taken to hold"""
FLAT = 0.1
"""of what is next to nothing: how little the last parabola may bend"""
SUFFICES = 5e-8
"""of the largest torque: the greatest last coefficient with which the nodes suffice; extremes are 50 times better"""


class Worked(NamedTuple):
    """A drive at places: position, speed and acceleration of the load; φ', φ'' and φ̈ of the mechanism's shaft.

    Then what drives the load (N, or Nm), the torque behind the reducer and the motor's (Nm).
    """

    y: Array
    v: Array
    a: Array
    first: Array
    second: Array
    turning: Array
    force: Array
    behind: Array
    torque: Array

    @property
    def rate(self) -> Array:
        """Speed of the mechanism's shaft (rad/s)."""
        return np.asarray(self.first * self.v)

    @property
    def power(self) -> Array:
        """Torque of the motor times speed of the mechanism's shaft (W, over the reducer's ratio)."""
        return np.asarray(self.torque * self.rate)


@dataclass(frozen=True)
class Held:
    """A piece of motion in one direction (1, −1, or 0 at rest) under one force, over an abscissa of a speed (1/s).

    ``within`` is a position of it, which says on which side of a knot its ends are.
    """

    train: Train
    piece: MotionPiece
    speed: float
    going: float
    force: Force
    within: float

    @property
    def acts(self) -> float:
        """1 where the motor acts, 0 at rest behind a brake."""
        return 0.0 if not self.going and self.train.drive.holding == "brake" else 1.0

    def turns_back(self, span: tuple[float, float], fastest: float) -> bool:
        """Whether it moves against its direction at an end of a span, beside a largest |y'|."""
        return bool((self.going * self.piece.derivative(1, np.array(span))).min() < -LOST * fastest)

    def argument(self, u: float) -> float:
        """Return the argument of the piece's first sine at a place (rad)."""
        _, omega, phi = self.piece.sines[0]
        return omega * u + phi

    def at(self, u: Array) -> Worked:
        """Return the drive at places of the piece: power goes through each stage by the sign of what is behind it."""
        train, m = self.train, self.train.drive.mechanism
        y, v, a = (self.piece.derivative(k, u) * self.speed**k for k in range(3))
        first, second = train.ratio(y, self.within)
        turning = second * v**2 + first * a
        force, (before, last) = self.force.at(Motion3(y, v, a)), m.stages
        through = loss_factor(force, self.going, last.efficiency, train.method, 0.0)
        behind = through * force / first + m.on_shaft(1) * turning
        own = (train.drive.motor_inertia + m.on_shaft(0)) * before.ratio * turning
        torque = loss_factor(behind, self.going, before.efficiency, train.method, 0.0) * behind / before.ratio + own
        return Worked(y, v, a, first, second, turning, force, self.acts * behind, self.acts * torque)


def half(piece: MotionPiece, phase: Phase) -> float:
    """Return where the middle of a piece is that takes more than :data:`LONG` of a phase that lifts; 0 of others."""
    return piece.begin + piece.duration / 2.0 if phase.lift and piece.duration > LONG * phase.duration else 0.0


def carried(values: Array, lost: float) -> list[float]:
    """Return the sign of each value, of one that has none that of the last before it; 0 before the first."""
    found: list[float] = []
    for value in values.tolist():
        before = found[-1] if found else 0.0
        found.append(before if abs(value) <= lost else math.copysign(1.0, value))
    return found


class Top(NamedTuple):
    """The largest of a section's values, found from those at its nodes.

    ``node`` is the number, from 1, of the largest; ``fa`` to ``fc`` are its own and its neighbours' values, and how
    their parabola bends; then a place and the values around it, three times; the largest value.
    """

    node: int
    fa: float
    fb: float
    fc: float
    bend: float
    x1: float
    a1: float
    b1: float
    c1: float
    x2: float
    a2: float
    b2: float
    c2: float
    x3: float
    a3: float
    b3: float
    c3: float
    rise: float
    value: float


@dataclass(frozen=True)
class Polynomial:
    """The polynomial through values at the nodes of a section; ``lost`` is what of them is next to nothing."""

    values: Array
    lost: float

    def at(self, x: float) -> float:
        """Return its value at a place that is no node."""
        shares = INTERPOLATING / (x - NODES)
        return float(shares @ self.values / shares.sum())

    @property
    def node(self) -> int:
        """The number, from 1, of the first node whose value is the largest."""
        largest = self.values >= self.values.max() - self.lost
        return int(NODES.size - math.floor(math.log(float(FIRST @ largest)) / math.log(2.0) + LOST))

    @cached_property
    def middle(self) -> int:
        """The number, from 0, of that node, or of the one beside it that has two neighbours."""
        return max(2, min(NODES.size - 1, self.node)) - 1

    @property
    def three(self) -> tuple[float, float, float]:
        """The values there and at both neighbours."""
        fa, fb, fc = self.values[self.middle - 1 : self.middle + 2].tolist()
        return fa, fb, fc

    @cached_property
    def bend(self) -> float:
        """How much the parabola through them bends: above 0 where it has a highest point."""
        (a, b, c), (fa, fb, fc) = NODES[self.middle - 1 : self.middle + 2], self.three
        return float((b - a) * (fb - fc) - (b - c) * (fb - fa))

    @cached_property
    def vertex(self) -> float:
        """Where that parabola is highest; the node of the largest value where it is not."""
        (a, b, c), (fa, fb, fc) = NODES[self.middle - 1 : self.middle + 2], self.three
        if self.bend <= self.lost:
            return float(NODES[self.node - 1])
        return float(b - ((b - a) ** 2 * (fb - fc) - (b - c) ** 2 * (fb - fa)) / (2.0 * self.bend))

    def around(self, x: float, far: float) -> tuple[float, float, float]:
        """Return the values at a place and beside it."""
        return self.at(x - far), self.at(x), self.at(x + far)

    @cached_property
    def top(self) -> Top:
        """Its largest value in the section."""
        places, around = [beside(self.vertex, FARTHEST[0])], []
        for width, farthest in zip(WIDTHS, FARTHEST[1:], strict=False):
            around.append(self.around(places[-1], width))
            places.append(beside(places[-1] + width * highest(around[-1], self.lost), farthest))
        around.append(self.around(places[-1], WIDTHS[-1]))
        rise = above(around[-1], places[-1], FLAT * self.lost)
        (x1, x2, x3), (one, other, last) = places, around
        value = max(last[1] + rise, float(self.values.max()))
        return Top(self.node, *self.three, self.bend, x1, *one, x2, *other, x3, *last, rise, value)


def beside(x: float, farthest: float) -> float:
    """Return the place of the part in which another lies, no farther out than a limit."""
    return (math.floor(max(-farthest, min(farthest, x)) * FINE + WITHIN) + WITHIN) / FINE


def highest(values: tuple[float, float, float], lost: float) -> float:
    """Return where the parabola through three values is highest, in their distance from the middle; 0 if nowhere."""
    a, b, c = values
    bend = 2.0 * b - a - c
    return max(-FAR, min(FAR, (c - a) / (2.0 * bend))) if bend > lost else 0.0


def above(values: tuple[float, float, float], x: float, lost: float) -> float:
    """Return by how much the parabola through values at and around a place rises above it within the section."""
    a, b, c = values
    bend, slope, width = 2.0 * b - a - c, c - a, WIDTHS[-1]
    if bend <= lost:
        return 0.0
    high = min(BEYOND, (1.0 - x) / width, slope / (2.0 * bend))
    far = max(-BEYOND, (-1.0 - x) / width, high)
    return far * (slope - far * bend) / 2.0


def scales_of(demand: Demand, torque: float, behind: float) -> Scales:
    """Return what the integrals of a cycle are measured by, from the largest torques of motor and reducer (Nm)."""
    fastest, time = max(demand.speed.peak, LOST), demand.course.time
    return Scales(torque**2, torque * fastest * time, behind**3 * fastest, torque * fastest)


def lost(size: float) -> float:
    """Return what is next to nothing beside a size."""
    return LOST * size


def level(size: float) -> float:
    """Return by how little values differ that are level, beside their size."""
    return LEVEL * lost(size)


def largest(values: Array) -> float:
    """Return the largest size of values."""
    return float(np.abs(values).max())


def section(span: tuple[float, float], shares: Array, begin: float = 0.0) -> Array:
    """Return places of a span by their shares, which run from ``begin`` to 1."""
    low, high = span
    return np.asarray(low + (high - low) * (shares - begin) / (1.0 - begin))


class Sums(NamedTuple):
    """Of a section ∫T² (Nm² rad), the work at the motor's shaft (J), ∫|S|³ |φ̇| and ∫|φ̇| over the abscissa.

    ``rest`` is the last coefficient of its torque (Nm).
    """

    square: float
    work: float
    cube: float
    way: float
    rest: float


def sums(held: Held, worked: Worked, span: tuple[float, float]) -> Sums:
    """Return the integrals of a section from the drive at its nodes."""
    weights, turning = WEIGHTS * (span[1] - span[0]) / 2.0, worked.rate
    work = weights @ (worked.torque * turning) * held.train.gear / held.speed
    cube = weights @ (np.abs(worked.behind) ** 3 * np.abs(turning))
    found = weights @ worked.torque**2, work, cube, weights @ np.abs(turning), abs(LAST @ worked.torque)
    return Sums(*map(float, found))


def suffices(last: float, torques: Array) -> bool:
    """Whether nodes suffice by the greatest last coefficient of a section's torque (Nm)."""
    return last <= SUFFICES * largest(torques)
