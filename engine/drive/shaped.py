"""Laws shaped for their drive: between rests or velocities, in pieces of a degree, of least RMS torque. SI units."""

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from engine.drive.cycle import DriveCycle
from engine.drive.drive_points import DrivePoints
from engine.drive.limits import LimitChecks
from engine.drive.quadrature import LoadPoints
from engine.drive.rate_range import shares_of_phases
from engine.drive.search import gauss_legendre, least_use
from engine.laws import Piece, PieceLaw
from engine.laws.base import Array
from engine.laws.ends import NAMES, REST, BoundaryValues
from engine.motion import Motion

PEAKS = 129  # points at which peaks are taken
NODES, LEAST_NODES = 64, 16  # of Gauss and Legendre over a law, and at least on each piece
MOST = 13  # the highest degree: of a higher one the powers lose digits
HULL = 33  # points at which knots are inserted, so that the hull lies near the law
JERK = 3  # the derivative of the position
FURTHER = 1.0  # of the rise: by so much a law may overshoot that begins or ends backwards
NEAR = 1e-9  # of a bound: by so little a law may miss it
RESTS = (1, 2, 3)  # the highest derivative that both ends have prescribed: of velocity, acceleration, jerk
Torque = Callable[[Array, Array, Array], Array]


class ShapedLaw(NamedTuple):
    """A law shaped for its drive."""

    durations: tuple[float, ...]  # of the pieces, in ξ
    # of each piece, of s by the time since its begin, from the constant term
    powers: tuple[tuple[float, ...], ...]
    rms_torque: float  # over the move (Nm)
    ends: BoundaryValues = REST  # of the rise 1

    @property
    def law(self) -> PieceLaw:
        """The law by its pieces. Raises ValueError where their degree is above 7."""
        rows = [[k * (k - 1) * c for k, c in enumerate(powers)][2:] for powers in self.powers]
        pieces = zip(self.durations, rows, strict=True)
        own = [Piece(duration, (*row, 0.0, 0.0)[: max(4, len(row))]) for duration, row in pieces]
        return PieceLaw(own, self.ends.slopes)


class Splines:
    """The laws between two ends, of pieces of a degree, by the coefficients of a B-spline that are free.

    The first and the last coefficients are those of the derivatives at the ends, at rest 0 and 1. A single piece is a
    polynomial. Pieces meet where Chebyshev polynomials are extreme, with all derivatives but the highest. A spline lies
    within the hull of its coefficients: those of the position are within 0 and 1, those of the jerk within its bound. A
    law that begins or ends backwards must overshoot.
    Source: F. Van Oosterwyck et al., CAD based trajectory optimization of PTP motions using Chebyshev polynomials,
    Mech. Mach. Theory 145 (2020); C. de Boor, A Practical Guide to Splines.

    Parameters
    ----------
    degree : int
        Of the pieces, at most 13.
    rest : {1, 2, 3}
        The highest derivative that both ends have prescribed: 1 the velocity, 2 the acceleration, 3 the jerk.
    pieces : int
        Their number.
    jerk : float
        What a law's d³s/dξ³ is at most, as c_j.
    ends : BoundaryValues
        The derivatives there, by ξ, of the rise 1.

    Raises
    ------
    ValueError
        For a degree or an order of rest that leaves nothing to choose, or is too high.
    """

    def __init__(
        self, degree: int = 9, rest: int = 2, pieces: int = 1, jerk: float = math.inf, ends: BoundaryValues = REST
    ) -> None:
        from scipy.interpolate import BSpline  # slow to import

        if rest not in RESTS:
            raise ValueError(f"rest is {rest}; expected one of {', '.join(map(str, RESTS))}")
        free, least = pieces + degree - 2 * (rest + 1), max(2 * rest + 3 - pieces, rest + 1)
        if free < 1 or not least <= degree <= MOST:
            raise ValueError(f"degree is {degree}; expected {least} to {MOST}")
        self.degree, self.rest, self.edges = degree, rest, edges_of(pieces)
        knots = np.concatenate([np.zeros(degree), self.edges, np.ones(degree)])
        self.basis = BSpline(knots, np.eye(pieces + degree), degree)
        hull = self.basis
        for at in np.linspace(0.0, 1.0, HULL)[1:-1].tolist():
            hull = hull.insert_knot(at)
        self.hull = hull.c
        self.jerk, self.jerks = jerk, hull.derivative(JERK).c
        self.ends = ends
        self.first, self.last = outer = self.outer(0), self.outer(1)
        backwards = np.min(outer) < -NEAR or np.max(outer) > 1.0 + NEAR
        self.low, self.high = (-FURTHER, 1.0 + FURTHER) if backwards else (0.0, 1.0)
        self.even = np.linspace(self.first[-1], self.last[0], free + 2)[1:-1]  # coefficients to begin with
        nodes, weights = gauss_legendre(max(LEAST_NODES, NODES // pieces))
        halves = 0.5 * np.diff(self.edges)[:, None]
        self.inner = (self.edges[:-1, None] + halves * (1.0 + nodes)).ravel()
        """points of Gauss and Legendre, and their weights"""
        self.weights = (halves * weights).ravel()

    def shape(self, torque: Torque, lift: float, time: float) -> ShapedLaw:
        """Return the law that takes the least RMS torque: least squares of √w T at Gauss points of the weights w.

        Of a torque that is no linear function of the motion it is a local minimum. Raises ValueError for a jerk that no
        such law has.

        Parameters
        ----------
        torque : callable
            From position (since the begin), velocity and acceleration of the load, arrays (n,) in m or rad and s, to
            the torque of the motor (Nm).
        lift : float, m or rad
        time : float, s
        """
        tables = self.tables(self.inner, (lift, lift / time, lift / time**2))
        chosen = self.least_torque(torque, tables)
        return self.law(chosen, self.torque_over(torque, tables, chosen))

    def shape_phase(self, checks: LimitChecks, motion: Motion, number: int, least_torque: bool = False) -> ShapedLaw:
        """Return the law of a phase with which the drive uses its limits least at the rate of its cycle.

        The largest use among RMS torque, peak torque and speed is as small as it can be: a minimum near the law of the
        least RMS torque. Inertia by position, losses by the direction of power, process forces and weight are those of
        the drive; peaks are taken at 129 points.

        Parameters
        ----------
        checks : LimitChecks
            The drive at its rate, with its limits.
        motion : Motion
            Its motion by phases.
        number : int
            Of the phase, from 0.
        least_torque : bool
            Whether only the RMS torque over the phase is to be least.

        Raises
        ------
        OutOfReachError, ValueError
            If the mechanism cannot reach a position; as :meth:`shape` does.
        """
        cycle, motor = checks.drive_cycle, checks.motor
        even = np.linspace(0.0, 1.0, PEAKS)
        inner, spread = (PhaseLoad(cycle, motion, number, self, xi) for xi in (self.inner, even))
        tables = self.tables(self.inner, inner.rates)
        tables_of_peaks = self.tables(even, spread.rates)
        share = motion.phases[number].duration / motion.total
        others = checks.results.rms_torque**2 * (1.0 - shares_of_phases(checks.results, 0).get(number, 0.0))
        fastest = min(motor.max_speed, checks.reducer.input_speed)

        def rms(chosen: Array) -> float:
            return self.torque_over(inner.torque_at, tables, chosen)

        def uses(chosen: Array) -> Array:
            at = spread.motor_points(*self.moved(tables_of_peaks, chosen))
            peaks = at.torque / motor.peak_at(np.minimum(np.abs(at.speed), motor.max_speed))
            lasting = math.sqrt(others + share * rms(chosen) ** 2) / checks.continuous
            return np.concatenate([[lasting], peaks, -peaks, at.speed / fastest, -at.speed / fastest])

        start = self.least_torque(inner.torque_at, tables)
        chosen = start if least_torque else self.least_use(uses, start)
        return self.law(chosen, rms(chosen))

    def outer(self, end: int) -> Array:
        """Return the first coefficients (0), or the last (1), by position and derivatives at that end."""
        n = self.rest + 1
        asked = [float(end), *(self.ends.both(name)[end] for name in [*NAMES][: self.rest])]
        rows = np.array([self.basis(float(end), nu=k) for k in range(n)])
        return np.asarray(np.linalg.solve(rows[:, -n:] if end else rows[:, :n], asked))

    def controls(self, chosen: Array) -> Array:
        """Return all coefficients: the first and the last are those of the ends."""
        return np.concatenate([self.first, chosen, self.last])

    def tables(self, xi: Array, rates: Sequence[float]) -> list[Array]:
        """Return the shares of all coefficients in position, velocity and acceleration at ξ, times their rates."""
        return [rate * self.basis(xi, nu=n) for n, rate in enumerate(rates)]

    def moved(self, tables: Sequence[Array], chosen: Array) -> list[Array]:
        """Return position, velocity and acceleration of a law by tables of its family."""
        return [table @ self.controls(chosen) for table in tables]

    def torque_over(self, torque: Torque, tables: Sequence[Array], chosen: Array) -> float:
        """Return the RMS torque over a law, by its tables at the inner points."""
        return math.sqrt(float(self.weights @ torque(*self.moved(tables, chosen)) ** 2))

    def least_torque(self, torque: Torque, tables: Sequence[Array]) -> Array:
        """Return the coefficients of the law with the least RMS torque, by its tables at the inner points.

        Raises ValueError where no law has so little jerk.
        """
        from scipy.optimize import least_squares  # slow to import

        roots = np.sqrt(self.weights)

        def weighted(chosen: Array) -> Array:
            return np.asarray(roots * torque(*self.moved(tables, chosen)))

        chosen = least_squares(weighted, self.even, jac="3-point", method="lm", ftol=1e-14, xtol=1e-14).x
        if self.margins(chosen).min() < -NEAR:
            within = np.clip(chosen, self.low, self.high)
            least = self.torque_over(torque, tables, within)
            chosen = least_use(
                lambda each: np.array([self.torque_over(torque, tables, each) / least]), within, self.margins
            )
        if self.margins(chosen).min() < -NEAR:
            raise ValueError(f"jerk is {self.jerk:g}; no law of these pieces has so little, expected more")
        return np.asarray(chosen)

    def margins(self, chosen: Array) -> Array:
        """Return by how much a law stays within its bounds: not below 0 where it neither overshoots nor jerks more."""
        position, share = (table @ self.controls(chosen) for table in (self.hull, self.jerks / self.jerk))
        return np.concatenate([position - self.low, self.high - position, 1.0 - NEAR - share, 1.0 - NEAR + share])

    def least_use(self, uses: Callable[[Array], Array], start: Array) -> Array:
        """Return the coefficients near some at which the largest of several uses is least; these if none is less."""
        chosen = least_use(uses, start, self.margins)
        is_less = uses(chosen).max() < uses(start).max() and self.margins(chosen).min() >= -NEAR
        return chosen if is_less else start

    def law(self, chosen: Array, rms_torque: float) -> ShapedLaw:
        """Return a law by its pieces."""
        orders, begins = range(self.degree + 1), self.edges[:-1]
        powers = [self.basis(begins, nu=n) @ self.controls(chosen) / math.factorial(n) for n in orders]
        durations = tuple(np.diff(self.edges).tolist())
        return ShapedLaw(durations, tuple(map(tuple, np.array(powers).T.tolist())), rms_torque, self.ends)


def edges_of(pieces: int) -> Array:
    """Return the ξ at which pieces begin and end: where a Chebyshev polynomial is extreme, closer at the ends."""
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * np.arange(pieces + 1) / pieces))


class PhaseLoad:
    """The motor over a phase, for any law of a family, at the rate of a cycle."""

    def __init__(self, cycle: DriveCycle, motion: Motion, number: int, family: Splines, xi: Array) -> None:
        phase, self.train = motion.phases[number], cycle.train
        self.begin, time = motion.ends[number].begin.y, phase.duration / cycle.speed
        self.low, self.high = sorted((family.low * phase.lift, family.high * phase.lift))
        self.rates = phase.lift, phase.lift / time, phase.lift / time**2
        self.x = float(motion.edges[number]) + phase.duration * xi
        acting = [self.train.acting(at + cycle.shift, motion.total) for at in self.x.tolist()]
        levels = [np.array([self.train.force(way, loads).level for loads in acting]) for way in (0.0, 1.0)]
        self.steady, self.friction = levels[0], levels[1] - levels[0]

    def motor_points(self, y: Array, v: Array, a: Array) -> DrivePoints:
        """Return the motor at positions since the begin, velocities and accelerations of the load.

        A search may try laws that go further: the mechanism, which may not reach so far, counts as at the bounds.
        """
        position = self.begin + np.clip(y, self.low, self.high)
        ratio, rests = self.train.ratio(position), np.zeros(y.shape)
        where = self.train, self.x, position, v, a, np.sign(v)
        return DrivePoints(LoadPoints(*where, self.steady, self.friction, *ratio, rests, rests))

    def torque_at(self, y: Array, v: Array, a: Array) -> Array:
        """Return the torque of the motor (Nm)."""
        return self.motor_points(y, v, a).torque
