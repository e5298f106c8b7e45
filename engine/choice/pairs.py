"""Whole catalogues of motors and reducers against one task: which pairs can do it, and the best of them. SI units."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from engine.choice.catalogue import Motors, Reducers
from engine.choice.task import Task
from engine.laws.base import Array

Criterion = Literal["margin", "inertia match", "size", "cost"]
Index = NDArray[np.intp]
BLOCK = 16384
"""pairs judged at a time, so that what lies between stays in the cache"""


class LoadAtMotor(NamedTuple):
    """What each reducer makes of a load at the motor's shaft, arrays over the reducers."""

    speed: Array
    """ω_L,max/τ, rad/s"""
    torque_rms: Array
    """τ T*_rms/η, Nm"""
    acceleration_rms: Array
    """ω̇_rms/τ, rad/s²"""
    product: Array
    """2 (ω̇_L T*_L)_mean/η, Nm rad/s²"""
    balancing: Array
    """τ² T*_rms/(η ω̇_rms), kg m²: the J_M + J_T for which τ is τ_opt; NaN for a load that does not move"""
    strong: NDArray[np.bool_]
    """whether the reducer holds the load's torque"""
    fits: NDArray[np.bool_]
    """and its speed"""


def load_at_motor(task: Task, reducers: Reducers, output_torque: float = 0.0) -> LoadAtMotor:
    """Return what each reducer makes of the load at the motor's shaft; it must hold ``output_torque`` (Nm).

    T_M,rms² = (τ T*_rms/η)² + (J ω̇_rms/τ)² + J · 2 (ω̇_L T*_L)_mean/η, J = J_M + J_T, as
    :func:`engine.choice.ratios.rms_torque`. Source: S5, steps 5 and 7.
    """
    ratio, eta = reducers.ratio, reducers.efficiency
    speed = task.max_speed / ratio
    inertia = task.torque_rms / task.acceleration_rms if task.moves else np.nan
    strong = reducers.max_output_torque >= output_torque
    return LoadAtMotor(
        speed,
        ratio * task.torque_rms / eta,
        task.acceleration_rms / ratio,
        2.0 * task.power_rate_mean / eta,
        ratio**2 / eta * inertia,
        strong,
        strong & (speed <= reducers.max_input_speed),
    )


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
    """what the pairs are ranked by, the lowest best: T_M,rms/T_M,N for the margin"""

    def __len__(self) -> int:
        return int(self.motor.size)


def usable(task: Task, motors: Motors, reducers: Reducers, output_torque: float = 0.0) -> tuple[Index, Index, Array]:
    """Return motor, reducer and squared RMS torque of every pair with T_M,rms ≤ T_M,N that is not driven too fast,
    and whose reducer holds ``output_torque`` (Nm); none for a load that does not move.

    With η = 1 and J_T = 0 these are the pairs with τ in :func:`engine.choice.ratios.ratio_ranges`; with the
    reducer's own η and J_T, step 7's check of the RMS torque is in it. Source: S5, steps 3 to 5 and 7.
    """
    found = list(_usable_by_block(task, motors, load_at_motor(task, reducers, output_torque), reducers.inertia))
    motor, reducer, square = (np.concatenate(column) for column in zip(*found, strict=True))
    return motor, reducer, square


def _usable_by_block(
    task: Task, motors: Motors, load: LoadAtMotor, inertias: Array
) -> Iterator[tuple[Index, Index, Array]]:
    """Judge block by block: T² = J (J p + q) + r, J = J_M + J_T, where p, q, r hang on the reducer alone."""
    count = inertias.size
    p, q, r = load.acceleration_rms**2, load.product, load.torque_rms**2
    speed = np.where(load.fits & task.moves, load.speed, np.inf)
    rows = max(1, BLOCK // max(count, 1))
    for begin in range(0, max(len(motors.names), 1), rows):
        here = slice(begin, begin + rows)
        inertia = motors.inertia[here, None] + inertias
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
    task: Task,
    motors: Motors,
    reducers: Reducers,
    criterion: Criterion = "margin",
    best: int | None = None,
    output_torque: float = 0.0,
) -> Pairs:
    """Return the usable pairs, best first (the ``best`` of them, or all); equals in the catalogues' order.

    margin: the largest T_M,N/T_M,rms; inertia match: τ nearest to τ_opt = √((J_M + J_T) ω̇_rms η/T*_rms), as a
    ratio; size, cost: the smallest sum of motor and reducer, of the pairs of which both are given.
    Raises ValueError for another criterion. Source: S5, step 6.
    """
    if criterion not in get_args(Criterion):
        raise ValueError(f"criterion is {criterion!r}; expected one of {', '.join(get_args(Criterion))}")
    load = load_at_motor(task, reducers, output_torque)
    motor, reducer, square = _with_figures(usable(task, motors, reducers, output_torque), motors, reducers, criterion)
    score = _score(motors, reducers, load, criterion, motor, reducer, square)
    order = _lowest(score, best)
    motor, reducer, rms = motor[order], reducer[order], square[order]
    np.sqrt(np.maximum(rms, 0.0, out=rms), out=rms)
    margin = motors.rated_torque[motor] / rms
    score = 1.0 / margin if criterion == "margin" else score[order]
    return Pairs(motor, reducer, rms, margin, _mismatch(motors, reducers, load, motor, reducer), score)


def _figures(motors: Motors, reducers: Reducers, criterion: Criterion) -> tuple[Array, Array]:
    return (motors.size, reducers.size) if criterion == "size" else (motors.cost, reducers.cost)


def _with_figures(
    found: tuple[Index, Index, Array], motors: Motors, reducers: Reducers, criterion: Criterion
) -> tuple[Index, Index, Array]:
    """Leave out the pairs of which the criterion's figures are not given."""
    if criterion not in ("size", "cost"):
        return found
    one, other = (~np.isnan(figures) for figures in _figures(motors, reducers, criterion))
    if one.all() and other.all():
        return found
    motor, reducer, square = found
    known = one[motor] & other[reducer]
    return motor[known], reducer[known], square[known]


def _score(
    motors: Motors, reducers: Reducers, load: LoadAtMotor, criterion: Criterion,
    motor: Index, reducer: Index, square: Array,
) -> Array:  # fmt: skip
    if criterion == "margin":  # squared: a million roots that the order does not need
        return np.asarray(square / (motors.rated_torque**2)[motor])
    if criterion == "inertia match":
        return _mismatch(motors, reducers, load, motor, reducer)
    one, other = _figures(motors, reducers, criterion)
    return np.asarray(one[motor] + other[reducer])


def _mismatch(motors: Motors, reducers: Reducers, load: LoadAtMotor, motor: Index, reducer: Index) -> Array:
    balancing = load.balancing[reducer]
    x = balancing / (motors.inertia[motor] + reducers.inertia[reducer])
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


def counted_in(pairs: Pairs, criterion: Criterion) -> float:
    """Return what scores are counted in: sizes and costs in the largest of them, the others in 1."""
    return (float(pairs.score.max()) or 1.0) if criterion in ("size", "cost") and len(pairs) else 1.0


def sorting_keys(pairs: Pairs, criterion: Criterion, place: ArrayLike, parts: int, rows: int) -> Array:
    """Return whole numbers that rise as the pairs rank for an engineer: the scores in whole ``parts`` of
    their unit (halves up), then the ``place`` of each pair among ``rows`` of a table, so that the first of equals comes
    first.
    """
    rounded = np.floor(pairs.score / counted_in(pairs, criterion) * parts + 0.5)
    return np.asarray(rounded * rows + place)
