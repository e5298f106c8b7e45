"""Laws shaped for their drive: between two rests, of pieces of a degree, with the least RMS torque. SI units."""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from engine.drive.cycle import DriveCycle
from engine.drive.drive_points import DrivePoints
from engine.drive.quadrature import LoadPoints
from engine.drive.search import gauss_legendre
from engine.laws import Piece, PieceLaw
from engine.laws.base import Array
from engine.laws.piece import POWERS
from engine.motion import Motion

NODES, LEAST_NODES = 64, 16  # of Gauss and Legendre over a law, and at least on each piece
MOST = 13  # the highest degree: of a higher one the powers lose digits
RESTS = (1, 2, 3)  # the highest derivative that is 0 at both ends: of velocity, acceleration, jerk
Torque = Callable[[Array, Array, Array], Array]


class ShapedLaw(NamedTuple):
    """A law shaped for its drive."""

    durations: tuple[float, ...]  # of the pieces, in ξ
    powers: tuple[tuple[float, ...], ...]  # of each piece, of s by the time since its begin, from the constant one
    rms_torque: float  # over the move (Nm)

    @property
    def law(self) -> PieceLaw:
        """The law by its pieces. Raises ValueError where their degree is above 7."""
        spare = (0.0,) * (POWERS + 2)
        rows = [[k * (k - 1) * c for k, c in enumerate(powers)][2:] for powers in self.powers]
        most = max(POWERS, *map(len, rows))
        pieces = zip(self.durations, rows, strict=True)
        return PieceLaw([Piece(duration, (*row, *spare)[:most]) for duration, row in pieces])


def shape(torque: Torque, lift: float, time: float, degree: int = 9, rest: int = 2, pieces: int = 1) -> ShapedLaw:
    """Return the law from rest to rest, of pieces of a degree, that takes the least RMS torque.

    The position is a B-spline: as many of its first coefficients are 0, and of its last 1, as derivatives rest at the
    ends, the others are those of the least squares of √w T at Gauss points w. A single piece is a polynomial. Pieces
    meet where Chebyshev polynomials are extreme, with all derivatives but the highest. Of a torque that is no linear
    function of the motion it is a local minimum.
    Source: F. Van Oosterwyck et al., CAD based trajectory optimization of PTP motions using Chebyshev polynomials,
    Mech. Mach. Theory 145 (2020); C. de Boor, A Practical Guide to Splines.

    Parameters
    ----------
    torque : callable
        From position (since the begin), velocity and acceleration of the load, arrays (n,) in m or rad and s, to the
        torque of the motor (Nm).
    lift : float, m or rad
    time : float, s
    degree : int
        Of the pieces, at most 13.
    rest : {1, 2, 3}
        The highest derivative that is 0 at both ends: 1 the velocity, 2 the acceleration, 3 the jerk.
    pieces : int
        Their number.

    Returns
    -------
    ShapedLaw

    Raises
    ------
    ValueError
        For a degree or an order of rest that leaves nothing to choose, or is too high.
    """
    from scipy.interpolate import BSpline  # slow to import, as is:
    from scipy.optimize import least_squares

    if rest not in RESTS:
        raise ValueError(f"rest is {rest}; expected one of {', '.join(map(str, RESTS))}")
    free, least = pieces + degree - 2 * (rest + 1), 2 * rest + 3 - pieces
    if free < 1 or not rest < degree <= MOST:
        raise ValueError(f"degree is {degree}; expected {max(least, rest + 1)} to {MOST}")
    edges = edges_of(pieces)
    knots = np.concatenate([np.zeros(degree), edges, np.ones(degree)])
    basis = BSpline(knots, np.eye(pieces + degree), degree)
    xi, roots = gauss_points(edges)
    rates = lift, lift / time, lift / time**2
    tables = [rate * basis(xi, nu=order) for order, rate in enumerate(rates)]

    def controls(chosen: Array) -> Array:
        return np.concatenate([np.zeros(rest + 1), chosen, np.ones(rest + 1)])

    def weighted(chosen: Array) -> Array:
        return np.asarray(roots * torque(*(table @ controls(chosen) for table in tables)))

    start = np.linspace(0.0, 1.0, free + 2)[1:-1]
    solved = least_squares(weighted, start, jac="3-point", method="lm", ftol=1e-14, xtol=1e-14)
    spline, orders = BSpline(knots, controls(solved.x), degree), range(degree + 1)
    powers = np.array([spline(edges[:-1], nu=k) / math.factorial(k) for k in orders]).T.tolist()
    return ShapedLaw(tuple(np.diff(edges).tolist()), tuple(map(tuple, powers)), math.sqrt(2.0 * solved.cost))


def edges_of(pieces: int) -> Array:
    """Return the ξ at which pieces begin and end: where a Chebyshev polynomial is extreme, closer at the ends."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * np.arange(pieces + 1) / pieces))


def gauss_points(edges: Array) -> tuple[Array, Array]:
    """Return the points of Gauss and Legendre between edges, and the roots of their weights."""
    nodes, weights = gauss_legendre(max(LEAST_NODES, NODES // (len(edges) - 1)))
    halves = 0.5 * np.diff(edges)[:, None]
    points = edges[:-1, None] + halves * (1.0 + nodes)
    return points.ravel(), np.sqrt(halves * weights).ravel()


def shape_phase(
    cycle: DriveCycle, motion: Motion, number: int, degree: int = 5, rest: int = 2, pieces: int = 4
) -> ShapedLaw:
    """Return the law of a phase from rest to rest that takes the least RMS torque of the motor.

    Inertia by position, losses by the direction of power, process forces and weight are those of the drive.

    Parameters
    ----------
    cycle : DriveCycle
        The drive at its rate.
    motion : Motion
        Its motion by phases.
    number : int
        Of the phase, from 0.
    degree, rest, pieces : int
        As :func:`shape` takes them.

    Returns
    -------
    ShapedLaw

    Raises
    ------
    OutOfReachError
        If the mechanism cannot reach a position.
    """
    phase, begin, train = motion.phases[number], motion.ends[number].begin.y, cycle.train
    x = float(motion.edges[number]) + phase.duration * gauss_points(edges_of(pieces))[0]
    acting = [train.acting(at + cycle.shift, motion.total) for at in x.tolist()]
    steady, moving = (np.array([train.force(way, loads).level for loads in acting]) for way in (0.0, 1.0))
    rests = np.zeros(x.shape)

    def torque(y: Array, v: Array, a: Array) -> Array:
        position = begin + y
        ratio = train.ratio(position)
        load = LoadPoints(train, x, position, v, a, np.sign(v), steady, moving - steady, *ratio, rests, rests)
        return DrivePoints(load).torque

    return shape(torque, phase.lift, phase.duration / cycle.speed, degree, rest, pieces)
