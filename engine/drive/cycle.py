"""The cycle of a drive: its motion in time, cut into intervals in which the torque has a single formula. SI units."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from engine.drive.drivetrain import Drivetrain, Force, LoadMotion, ShaftMotion, TorqueCoefficients, dwell_times
from engine.drive.search import NOISE, crossings, sign_changes
from engine.laws.base import Array
from engine.laws.extremes import Curve, largest_size
from engine.motion import Motion
from engine.motion.pieces import MotionPiece, MotionPieces

NARROW = 1e-9  # share of a piece: shorter parts are left out
NODES = 32  # parts, of an interval and of each half turn of its sines, in which functions are searched by samples


@dataclass(frozen=True)
class TorqueInterval:
    """A part of a piece with a constant direction of motion, process force, and direction of power in each stage."""

    train: Drivetrain
    piece: MotionPiece
    speed: float  # of the abscissa (units per s)
    low: float  # u of its begin, from the begin of the piece, in units of the abscissa
    high: float  # u of its end
    direction: float  # 1, −1, or 0 at rest
    force: Force  # at the load
    # of each shaft but the load's, from the motor's
    torque_coefficients: tuple[TorqueCoefficients, ...]
    braked: bool = False  # whether a brake holds the motor's shaft

    @property
    def samples(self) -> Array:
        """Every u at which a function is sampled before it is searched: the ends of equal parts."""
        fastest = max((abs(w) for a, w, _ in self.piece.sines if a), default=0.0)
        angle = fastest * (self.high - self.low)
        if self.force.by_angle:
            angle += abs(self.piece.curves[0](self.high) - self.piece.curves[0](self.low))
        return np.linspace(self.low, self.high, NODES * (1 + int(angle / np.pi)) + 1)

    def load(self, u: Array) -> LoadMotion:
        """Return the motion of the load at u."""
        y, velocity, acceleration = (curve(u) for curve in self.piece.curves[:3])
        return LoadMotion(y, velocity * self.speed, acceleration * self.speed**2)

    def shaft(self, u: Array) -> ShaftMotion:
        """Return the motion of the mechanism's own shaft at u."""
        return self.train.shaft(self.load(u), self.within)

    @cached_property
    def within(self) -> float:
        """The load's position in the middle of the interval: at a knot of the mechanism, φ'' on this side counts."""
        return self.piece.curves[0](0.5 * (self.low + self.high))

    def motor_speed(self, u: Array) -> Array:
        """Return the speed of the motor (rad/s) at u."""
        return np.asarray(self.train.gear * self.shaft(u).speed)

    def torque(self, u: Array, shaft: int = 0) -> Array:
        """Return the torque (Nm) that drives a shaft at u: 0 is the motor's, the last the load's (N if it travels)."""
        load = self.load(u)
        if shaft == len(self.torque_coefficients):
            return self.force.at(load)
        if shaft == 0 and self.braked:
            return np.zeros(load.y.shape)
        turning = self.train.shaft(load, self.within)
        weights = self.torque_coefficients[shaft]
        torque = weights.force * self.force.at(load) / turning.first + weights.inertia * turning.acceleration
        return np.asarray(torque + weights.friction * self.direction)

    def power(self, u: Array) -> Array:
        """Return the power (W) of the motor at u, with the losses of its winding: T ω + (P_N/T_N²) T²."""
        torque = self.torque(u)
        return np.asarray(torque * (self.motor_speed(u) + self.train.copper * torque))

    def curve(self, shaft: int = 0) -> Curve | None:
        """Return the torque of a shaft as a curve over u (Nm, or N); None if it depends on the position."""
        if self.force.by_angle:
            return None
        if shaft == len(self.torque_coefficients):
            return self._force_curve(1.0, 0.0, 0.0)
        if self.train.linkage:
            return None
        ratio = self.train.mechanism.stages[-1].ratio
        weights = TorqueCoefficients(0.0, 0.0, 0.0) if shaft == 0 and self.braked else self.torque_coefficients[shaft]
        return self._force_curve(weights.force / ratio, weights.inertia * ratio, weights.friction * self.direction)

    def _force_curve(self, share: float, inertia: float, more: float) -> Curve:
        """Return ``share`` · F + ``inertia`` · ÿ + ``more`` as a curve over u, F the force at the load."""
        _, velocity, acceleration, _ = self.piece.curves
        level, c = share * self.force.level + more, share * self.force.viscous * self.speed
        m = (share * self.force.mass + inertia) * self.speed**2
        both = [*(m * c2 for c2 in acceleration.c), 0.0]
        polynomial = [c * c1 + other for c1, other in zip(velocity.c, both, strict=True)]
        polynomial[0] += level
        sines = [(m * p, w, phi) for p, w, phi in acceleration.sines]
        sines += [(c * p, w, phi) for p, w, phi in velocity.sines] if c else []
        merged = []  # a sine for each ω
        for w in dict.fromkeys(w for _, w, _ in sines):
            phasor = sum(p * np.exp(1j * phi) for p, other, phi in sines if other == w)
            merged.append((float(abs(phasor)), w, float(np.angle(phasor))))
        return Curve(tuple(polynomial), tuple(merged))

    def crossings(self, shaft: int) -> list[float]:
        """Return every u at which the torque of a shaft changes its sign."""
        curve = self.curve(shaft)
        if curve is None:
            return crossings(lambda u: self.torque(u, shaft), self.samples)
        return sign_changes(curve, self.low, self.high)


class Span(NamedTuple):
    """A part of a piece with a constant direction of motion and process force."""

    piece: MotionPiece
    low: float  # u of its begin, in units of the abscissa
    high: float  # u of its end
    direction: float  # 1, −1, or 0 at rest
    force: Force
    dwell: float = 0.0  # duration of its dwell (s); 0 if it moves


@dataclass(frozen=True)
class DriveCycle:
    """A drivetrain over the cycle of its load's motion. Raises ValueError unless the speed is finite and above 0."""

    train: Drivetrain
    # of the load: phases, or pieces (of a flying tool); y in m or rad
    motion: Motion | MotionPieces
    speed: float = 1.0  # of the abscissa (units per s)
    shift: float = 0.0  # y(x) = y0(x − shift), in units of the abscissa; windows are not shifted

    def __post_init__(self) -> None:
        if not 0.0 < self.speed < np.inf:
            raise ValueError(f"speed is {self.speed:g}; expected a finite number above 0")

    @property
    def time(self) -> float:
        """Time of the cycle (s)."""
        return self.unshifted.total / self.speed

    @cached_property
    def unshifted(self) -> MotionPieces:
        """The pieces of the motion."""
        return self.motion if isinstance(self.motion, MotionPieces) else MotionPieces.of(self.motion)

    @cached_property
    def torque_intervals(self) -> tuple[TorqueInterval, ...]:
        """All torque intervals, in the order of the unshifted motion. Raises OutOfReachError."""
        last = len(self.train.mechanism.stages)
        return tuple(interval for span in self.spans for interval in self._through(span, [1.0] * last, last))

    @cached_property
    def spans(self) -> tuple[Span, ...]:
        """All spans, in the order of the unshifted motion. Raises OutOfReachError."""
        spans = [span for piece in self.unshifted.moved for span in self._of(piece)]
        lasts, direction = np.array([((span.high - span.low) / self.speed, span.direction) for span in spans]).T
        dwells = dwell_times(lasts, direction).tolist()
        return tuple(span._replace(dwell=dwell) for span, dwell in zip(spans, dwells, strict=True))

    def _of(self, piece: MotionPiece) -> Iterator[Span]:
        """Yield the spans of a piece."""
        velocity = piece.curves[1]
        moves = largest_size(velocity, piece.duration) > NOISE * self.unshifted.fastest
        edges = [edge for window in self.train.windows for edge in (window.begin, window.end)]
        places = ((edge - self.shift - piece.begin) % self.unshifted.total for edge in edges)
        cuts = [0.0, piece.duration, *(u for u in places if u < piece.duration)]
        if moves:
            turns = sign_changes(velocity, 0.0, piece.duration)
            cuts += [*turns, *self._knots(piece, turns)]
        for low, high in parts(cuts, piece.duration):
            middle = 0.5 * (low + high)
            direction = float(np.sign(velocity(middle))) if moves else 0.0
            sense = direction * self.train.sense(piece.curves[0](middle))
            acting = self.train.acting(piece.begin + middle + self.shift, self.unshifted.total)
            force = self.train.force(sense, acting)
            yield Span(piece, low, high, direction, force)

    def _knots(self, piece: MotionPiece, turns: Sequence[float]) -> Iterator[float]:
        """Yield every u at which a piece that reverses at ``turns`` passes a position of :meth:`Drivetrain.cuts`."""
        y = piece.curves[0]
        ends = [y(u) for u in (0.0, *turns, piece.duration)]
        for knot in self.train.cuts(min(ends), max(ends)):
            yield from sign_changes(Curve((y.c[0] - knot, *y.c[1:]), y.sines), 0.0, piece.duration)

    def _through(self, span: Span, factors: list[float], shaft: int) -> Iterator[TorqueInterval]:
        """Yield the torque intervals of a span; the factors of the stages behind ``shaft`` are known."""
        here = self._interval(span, factors)
        cuts = [span.low, span.high, *(here.crossings(shaft) if span.direction else ())]
        for low, high in parts(cuts, span.piece.duration):
            part = span._replace(low=low, high=high)
            if shaft == 0:
                yield self._interval(part, factors)
                continue
            stage = self.train.mechanism.stages[shaft - 1]
            behind = here.torque(np.array([0.5 * (low + high)]), shaft)
            factor = float(stage.factor(behind, span.direction, self.train.method)[0])
            yield from self._through(part, [*factors[: shaft - 1], factor, *factors[shaft:]], shaft - 1)

    def _interval(self, span: Span, factors: Sequence[float]) -> TorqueInterval:
        weights, train = tuple(self.train.torque_coefficients(factors)), self.train
        # a brake is on the motor's shaft: gears carry the load
        piece, low, high, direction, force, dwell = span
        braked = train.holding == "brake" and bool(train.brake.holds(direction, dwell))
        return TorqueInterval(train, piece, self.speed, low, high, direction, force, weights, braked)


def parts(cuts: Sequence[float], width: float) -> Iterator[tuple[float, float]]:
    """Yield the parts between cuts in order, without those shorter than :data:`NARROW` of the width."""
    edges: list[float] = []
    for cut in sorted(cuts):
        if not edges or cut - edges[-1] > NARROW * width:
            edges.append(cut)
    edges[-1] = max(cuts)
    yield from pairwise(edges)
