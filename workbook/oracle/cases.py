"""Values of the inputs at which a workbook is compared: as entered, at the ends of ranges, and between."""

import math
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import Any

import numpy as np
from scipy.stats import qmc

from workbook.oracle.declared import Input

ROUNDING, SMALLEST = 1e-9, 1e-12  # of two values that are the same: a relative and an absolute deviation


def close(found: Any, expected: Any, allowed: float) -> bool:
    """Whether a value deviates from the expected one by no more than is allowed; a text must be the same."""
    if is_number(found) and is_number(expected):
        return math.isfinite(found) and abs(found - expected) <= allowed + SMALLEST
    return type(found) is type(expected) and bool(found == expected)


def same(found: Any, expected: Any) -> bool:
    """Whether two values are the same but for rounding."""
    return close(found, expected, ROUNDING * size(expected))


def size(value: Any) -> float:
    """Return the magnitude of a number, else 0."""
    return abs(float(value)) if is_number(value) else 0.0


def is_number(value: Any) -> bool:
    """Whether a value is a number, and not a truth value."""
    return isinstance(value, int | float | np.number) and not isinstance(value, bool)


Case = dict[Input, Any]


def cases(inputs: Sequence[Input], entered: Case, number: int, seed: int = 0) -> list[Case]:
    """Return so many cases, no more: as entered, each range at its ends, pairs of choices, Sobol's sequence.

    Source: A. B. Owen, Scrambled Sobol' and Niederreiter–Xing points, J. Complexity 14 (1998), in scipy.stats.qmc.
    """
    varied = [one for one in inputs if options(one)]
    found = [entered]
    for one in varied:
        found += [entered | {one: value} for value in options(one)]
    for one, other in combinations([one for one in varied if one.choices], 2):
        found += [entered | {one: a, other: b} for a in one.choices for b in other.choices]
    if varied and len(found) < number:
        found += [entered | case for case in between(varied, number - len(found), seed)]
    return found[:number]


def options(one: Input) -> Sequence[Any]:
    """Return the choices of an input, or the ends of its range; nothing of one that stays as it is."""
    if one.choices:
        return one.choices
    return [] if one.low is None or one.high is None else [one.low, one.high]


def between(varied: Sequence[Input], number: int, seed: int) -> Iterator[Case]:
    """Yield points of Sobol's sequence in the ranges and choices of inputs."""
    sequence = qmc.Sobol(len(varied), scramble=True, seed=seed)
    for point in sequence.random_base2((number - 1).bit_length())[:number]:
        yield {one: at(one, float(share)) for one, share in zip(varied, point, strict=True)}


def at(one: Input, share: float) -> Any:
    """Return the value of an input at a share of its range, from 0 to 1."""
    if one.choices:
        return one.choices[min(int(share * len(one.choices)), len(one.choices) - 1)]
    low, high = float(one.low or 0.0), float(one.high or 0.0)
    return low + share * (high - low)
