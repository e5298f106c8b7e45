"""Laws shaped for their drive: the polynomial between two rests that takes the least RMS torque. SI units."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

from engine.drive.cycle import DriveCycle
from engine.drive.drive_points import DrivePoints
from engine.drive.quadrature import LoadPoints
from engine.drive.search import gauss_legendre
from engine.laws import Piece, PieceLaw
from engine.laws.base import Array
from engine.laws.piece import POWERS
from engine.motion import Motion

NODES = 64  # of Gauss and Legendre, at which the torque is asked for
MOST = 13  # the highest degree: of a higher one the powers of ξ lose digits
BASES = {
    1: (0.0, 0.0, 3.0, -2.0),
    2: (0.0, 0.0, 0.0, 10.0, -15.0, 6.0),
    3: (0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0),
}
"""by the highest derivative that is 0 at both ends: the law of least degree, the cubic, 3-4-5 and 4-5-6-7"""
UNIT = (0.0, 1.0)
Torque = Callable[[Array, Array, Array], Array]


class ShapedLaw(NamedTuple):
    """A law shaped for its drive."""

    coefficients: tuple[float, ...]  # of s(ξ), from the constant one
    rms_torque: float  # over the move (Nm)

    @property
    def law(self) -> PieceLaw:
        """The law as a single piece. Raises ValueError where its degree is above 7."""
        powers = Polynomial(self.coefficients).deriv(2).coef
        return PieceLaw([Piece(1.0, tuple(np.pad(powers, (0, max(0, POWERS - powers.size))).tolist()))])


def shape(torque: Torque, lift: float, time: float, degree: int = 9, rest: int = 2) -> ShapedLaw:
    """Return the polynomial law from rest to rest that takes the least RMS torque.

    s = s_0 + (ξ(1 − ξ))ⁿ Σ c_k T_k(2ξ − 1), with s_0 of least degree and n one more than ``rest``: the least squares of
    √w T at Gauss points w. Of a torque that is no linear function of the motion it is a local minimum, that near s_0.
    Source: F. Van Oosterwyck et al., CAD based trajectory optimization of PTP motions using Chebyshev polynomials,
    Mech. Mach. Theory 145 (2020).

    Parameters
    ----------
    torque : callable
        From position (since the begin), velocity and acceleration of the load, arrays (n,) in m or rad and s, to the
        torque of the motor (Nm).
    lift : float, m or rad
    time : float, s
    degree : int
        Of the law, from 2n to 13.
    rest : {1, 2, 3}
        The highest derivative that is 0 at both ends: 1 the velocity, 2 the acceleration, 3 the jerk.

    Returns
    -------
    ShapedLaw

    Raises
    ------
    ValueError
        For another degree, or another order of rest.
    """
    from scipy.optimize import least_squares  # slow to import

    if rest not in BASES:
        raise ValueError(f"rest is {rest}; expected one of {', '.join(map(str, BASES))}")
    free = degree - 2 * rest - 1
    if free < 1 or degree > MOST:
        raise ValueError(f"degree is {degree}; expected {2 * rest + 2} to {MOST}")
    base, hull = Polynomial(BASES[rest]), Polynomial((0.0, 1.0, -1.0)) ** (rest + 1)
    shapes = [base.convert(kind=Chebyshev, domain=UNIT)]
    shapes += [hull.convert(kind=Chebyshev, domain=UNIT) * Chebyshev.basis(k, domain=UNIT) for k in range(free)]
    nodes, weights = gauss_legendre(NODES)
    xi, roots = 0.5 * (nodes + 1.0), np.sqrt(0.5 * weights)
    scales = lift, lift / time, lift / time**2
    tables = [scale * np.array([f.deriv(n)(xi) for f in shapes]) for n, scale in enumerate(scales)]

    def weighted(c: Array) -> Array:
        return np.asarray(roots * torque(*(table[0] + c @ table[1:] for table in tables)))

    solved = least_squares(weighted, np.zeros(free), jac="3-point", method="lm", ftol=1e-14, xtol=1e-14)
    law = sum((c * f for c, f in zip(solved.x.tolist(), shapes[1:], strict=True)), shapes[0])
    powers = law.convert(kind=Polynomial, domain=[-1.0, 1.0])
    return ShapedLaw(tuple(powers.coef.tolist()), float(np.sqrt(2.0 * solved.cost)))


def shape_phase(cycle: DriveCycle, motion: Motion, number: int, degree: int = 7, rest: int = 2) -> ShapedLaw:
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
    degree, rest : int
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
    nodes, _ = gauss_legendre(NODES)
    x = float(motion.edges[number]) + phase.duration * 0.5 * (nodes + 1.0)
    acting = [train.acting(at + cycle.shift, motion.total) for at in x.tolist()]
    steady, moving = (np.array([train.force(way, loads).level for loads in acting]) for way in (0.0, 1.0))
    rests = np.zeros(x.shape)

    def torque(y: Array, v: Array, a: Array) -> Array:
        position = begin + y
        ratio = train.ratio(position)
        load = LoadPoints(train, x, position, v, a, np.sign(v), steady, moving - steady, *ratio, rests, rests)
        return DrivePoints(load).torque

    return shape(torque, phase.lift, phase.duration / cycle.speed, degree, rest)
