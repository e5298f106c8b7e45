"""Whole catalogues of motors and reducers against one task: usable pairs, ranked, and the checks of one pair."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.drivetrain import LimitCheck, OperatingPoints, direction, loss_factor
from engine.laws.base import Array
from engine.selection import Task

Criterion = Literal["margin", "inertia match", "size", "cost"]
Index = NDArray[np.intp]
BLOCK = 16384
"""pairs judged at a time, so that what lies between stays in the cache"""


@dataclass(frozen=True)
class Motors:
    """A catalogue of motors, one array each: J_M (kg m²), T_M,N, T_M,max (Nm), ω_M,max (rad/s); size (kg), cost.

    A single number stands for all. Raises ValueError for lengths that differ or a figure that is not above 0
    (that names the motor).
    """

    names: tuple[str, ...]
    inertia: Array
    rated_torque: Array
    peak_torque: Array
    max_speed: Array
    size: Array | None = None
    cost: Array | None = None

    def __post_init__(self) -> None:
        _columns(self, "motor", ("inertia", "rated_torque", "peak_torque", "max_speed"), ("size", "cost"))


@dataclass(frozen=True)
class Reducers:
    """A catalogue of reducers: τ = ω_L/ω_M, η, J_T (kg m², at the motor's shaft), largest input speed (rad/s) and
    output torque (Nm), infinite where not given; size (kg), cost.

    A single number stands for all. Raises ValueError for lengths that differ, τ not above 0, η not above 0 and
    at most 1, or J_T below 0 (that names the reducer).
    """

    names: tuple[str, ...]
    ratio: Array
    efficiency: Array
    inertia: Array
    max_input_speed: Array
    max_output_torque: Array
    size: Array | None = None
    cost: Array | None = None

    def __post_init__(self) -> None:
        positive = ("ratio", "efficiency", "max_input_speed", "max_output_torque")
        _columns(self, "reducer", positive, ("inertia", "size", "cost"))
        _require_each("reducer", self.names, "efficiency", self.efficiency <= 1.0, self.efficiency, "at most 1")


@dataclass(frozen=True)
class Pairs:
    """Usable pairs, best first: index of motor and reducer, and what each pair does with the task."""

    motor: Index
    reducer: Index
    rms_torque: Array
    """Nm, with the reducer's efficiency and inertia"""
    margin: Array
    """T_M,N/T_M,rms"""
    mismatch: Array
    """τ/τ_opt or its inverse, whichever is above 1"""
    score: Array
    """what the pairs are ranked by, the lowest best"""

    def __len__(self) -> int:
        return int(self.motor.size)


def usable(task: Task, motors: Motors, reducers: Reducers) -> tuple[Index, Index, Array]:
    """Return motor, reducer and squared RMS torque of every pair with T_M,rms ≤ T_M,N that is not driven too fast.

    With η = 1 and J_T = 0 these are the pairs with τ in :func:`engine.selection.ratio_ranges`; with the reducer's
    own η and J_T, step 7's check of the RMS torque is in it. Source: S5, steps 3 to 5 and 7.
    """
    found = list(_usable_by_block(task, motors, reducers))
    motor, reducer, square = (np.concatenate(column) for column in zip(*found, strict=True))
    return motor, reducer, square


def _usable_by_block(task: Task, motors: Motors, reducers: Reducers) -> Iterator[tuple[Index, Index, Array]]:
    """Judge block by block: T² = J (J p + q) + r, J = J_M + J_T, where p, q, r hang on the reducer alone."""
    count = len(reducers.names)
    p = (task.acceleration_rms / reducers.ratio) ** 2
    q = 2.0 * task.power_rate_mean / reducers.efficiency
    r = (reducers.ratio * task.torque_rms / reducers.efficiency) ** 2
    speed = task.max_speed / reducers.ratio
    speed = np.where(speed <= reducers.max_input_speed, speed, np.inf)
    rows = max(1, BLOCK // max(count, 1))
    for begin in range(0, max(len(motors.names), 1), rows):
        here = slice(begin, begin + rows)
        inertia = motors.inertia[here, None] + reducers.inertia
        square = inertia * p
        square += q
        square *= inertia
        square += r
        fits = square <= motors.rated_torque[here, None] ** 2
        fits &= speed <= motors.max_speed[here, None]
        row = np.repeat(np.arange(len(fits)), np.count_nonzero(fits, axis=1))
        flat = np.flatnonzero(fits)
        yield row + begin, flat - row * count, square.ravel()[flat]


def rank(
    task: Task, motors: Motors, reducers: Reducers, criterion: Criterion = "margin", best: int | None = None
) -> Pairs:
    """Return the usable pairs, best first (the ``best`` of them, or all); equals in the catalogues' order.

    margin: the largest T_M,N/T_M,rms; inertia match: τ nearest to τ_opt = √((J_M + J_T) ω̇_rms η/T*_rms), as a
    ratio; size, cost: the smallest sum of motor and reducer. Raises ValueError for another criterion, or one
    for which the catalogues have no figures. Source: S5, step 6.
    """
    if criterion not in get_args(Criterion):
        raise ValueError(f"criterion is {criterion!r}; expected one of {', '.join(get_args(Criterion))}")
    motor, reducer, square = usable(task, motors, reducers)
    score = _score(task, motors, reducers, criterion, motor, reducer, square)
    order = _lowest(score, best)
    motor, reducer, rms = motor[order], reducer[order], np.sqrt(square[order])
    margin = motors.rated_torque[motor] / rms
    return Pairs(motor, reducer, rms, margin, _mismatch(task, motors, reducers, motor, reducer), score[order])


def _score(
    task: Task, motors: Motors, reducers: Reducers, criterion: Criterion, motor: Index, reducer: Index, square: Array
) -> Array:
    if criterion == "margin":
        return np.asarray(square / (motors.rated_torque**2)[motor])
    if criterion == "inertia match":
        return _mismatch(task, motors, reducers, motor, reducer)
    one, other = (motors.size, reducers.size) if criterion == "size" else (motors.cost, reducers.cost)
    if one is None or other is None:
        raise ValueError(f"the catalogues give no {criterion} of each motor and reducer; expected both")
    return np.asarray(one[motor] + other[reducer])


def _mismatch(task: Task, motors: Motors, reducers: Reducers, motor: Index, reducer: Index) -> Array:
    wanted = (reducers.ratio**2 / reducers.efficiency * (task.torque_rms / task.acceleration_rms))[reducer]
    x = wanted / (motors.inertia[motor] + reducers.inertia[reducer])
    return np.asarray(np.sqrt(np.maximum(x, 1.0 / x)))


def _lowest(score: Array, best: int | None) -> Index:
    """Return the order of the lowest scores, equals as they stand."""
    if best is None or best >= score.size:
        order = np.argsort(score)  # several times as fast as a stable sort, and the same where no two are equal
        rising = score[order]
        return np.argsort(score, kind="stable") if (rising[1:] == rising[:-1]).any() else order
    if best < 1:
        raise ValueError(f"best is {best}; expected 1 or more")
    bound = np.partition(score, best - 1)[best - 1]
    candidates = np.flatnonzero(score <= bound)
    return candidates[np.argsort(score[candidates], kind="stable")[:best]]


class TorqueCurve(NamedTuple):
    """Largest torque (Nm) of a servo-motor against its speed (rad/s): corners, speeds rising from 0."""

    speed: Array
    torque: Array

    def at(self, speed: ArrayLike) -> Array:
        """Return T_M,max at a speed of either direction; 0 beyond the last corner."""
        return np.asarray(np.interp(np.abs(speed), self.speed, self.torque, right=0.0))


def _level(torque: float, max_speed: float) -> TorqueCurve:
    return TorqueCurve(np.array([0.0, max_speed]), np.array([torque, torque]))


def operating_points(
    motors: Motors,
    reducers: Reducers,
    pair: tuple[int, int],
    time: ArrayLike,
    speed: ArrayLike,
    acceleration: ArrayLike,
    torque: ArrayLike,
) -> OperatingPoints:
    """Return speed, torque and power of a pair's motor for samples of ω_L, ω̇_L and T*_L (rad/s, rad/s², Nm).

    T_M = (J_M + J_T) ω̇_L/τ + τ T*_L f, f = 1/η where the load is driven or stands, η where it drives.
    Source: S5, step 7; f as in :func:`engine.drivetrain.losses.loss_factor`.
    """
    m, r = pair
    w, dw, load = (np.asarray(values, dtype=np.float64) for values in (speed, acceleration, torque))
    tau, eta = float(reducers.ratio[r]), float(reducers.efficiency[r])
    own = (motors.inertia[m] + reducers.inertia[r]) / tau * dw
    at_motor = own + tau * load * loss_factor(load, direction(w), eta)
    return OperatingPoints(w / tau, at_motor, at_motor * w / tau, np.asarray(time, dtype=np.float64))


def checks(
    motors: Motors,
    reducers: Reducers,
    pair: tuple[int, int],
    points: OperatingPoints,
    torque: ArrayLike,
    curve: TorqueCurve | None = None,
) -> tuple[LimitCheck, ...]:
    """Return step 7's checks of a pair: RMS, peak torque against the curve, speeds, the reducer's torque T*_L.

    Without a ``curve`` the peak torque holds up to the largest speed. Source: S5, step 7.
    """
    m, r = pair
    given = curve or _level(float(motors.peak_torque[m]), float(motors.max_speed[m]))
    available = given.at(points.speed)
    use = np.divide(np.abs(points.torque), available, out=np.full(available.shape, math.inf), where=available > 0.0)
    found = (
        ("RMS torque", points.rms_torque, float(motors.rated_torque[m])),
        ("peak torque, share of the curve", float(use.max()), 1.0),
        ("motor speed", points.max_speed, float(motors.max_speed[m])),
        ("reducer input speed", points.max_speed, float(reducers.max_input_speed[r])),
        ("reducer output torque", float(np.abs(torque).max()), float(reducers.max_output_torque[r])),
    )
    return tuple(LimitCheck(name, value, limit, value <= limit) for name, value, limit in found)


def _columns(catalogue: Motors | Reducers, kind: str, positive: tuple[str, ...], other: tuple[str, ...]) -> None:
    """Turn what is given into arrays, one value a name, and refuse what cannot be."""
    names = tuple(catalogue.names)
    object.__setattr__(catalogue, "names", names)
    for column in (*positive, *other):
        given = getattr(catalogue, column)
        if given is None:
            continue
        values = np.asarray(given, dtype=np.float64)
        if values.shape not in ((), (len(names),)):
            raise ValueError(f"{len(names)} {kind}s are named and {values.size} values of {column} given")
        values = np.broadcast_to(values, (len(names),))
        object.__setattr__(catalogue, column, values)
        holds, expected = (values > 0.0, "above 0") if column in positive else (values >= 0.0, "0 or more")
        _require_each(kind, names, column, holds, values, expected)


def _require_each(
    kind: str, names: tuple[str, ...], column: str, holds: NDArray[np.bool_], values: Array, expected: str
) -> None:
    if not holds.all():
        k = int(np.argmin(holds))
        raise ValueError(f"{kind} {names[k]!r}: {column} is {values[k]:g}; expected a number {expected}")
