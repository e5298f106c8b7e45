"""Checks of shares that several families have."""

from collections.abc import Sequence

from engine.laws.base import require_finite

SUM_TOLERANCE = 1e-9


def require_share(name: str, value: float, low: float = 0.0, high: float = 1.0) -> None:
    """Raise ValueError unless a share is a number strictly between two others."""
    require_finite(**{name: value})
    if not low < value < high:
        raise ValueError(f"{name} is {value:g}; expected a share between {low:g} and {high:g}")


def require_part(name: str, value: float) -> None:
    """Raise ValueError unless a share is a number from 0 to 1."""
    require_finite(**{name: value})
    if not 0.0 <= value <= 1.0:
        raise ValueError(f"{name} is {value:g}; expected a share from 0 to 1")


def seven_durations(given: Sequence[float]) -> tuple[float, ...]:
    """Return seven durations as floats.

    Raises ValueError unless they are seven, none negative, of sum 1 (within 1e-9), neither the first three nor
    the last three all zero.
    """
    durations = tuple(float(d) for d in given)
    if len(durations) != 7:
        raise ValueError(f"{len(durations)} durations are given; expected seven")
    for i, d in enumerate(durations, 1):
        if not 0.0 <= d <= 1.0 + SUM_TOLERANCE:
            raise ValueError(f"the duration of stage {i} is {d:g}; expected a share from 0 to 1")
    if abs(sum(durations) - 1.0) > SUM_TOLERANCE:
        raise ValueError(f"the seven durations sum to {sum(durations):.12g}; expected 1")
    for stages, part in (("1 to 3", durations[:3]), ("5 to 7", durations[4:])):
        if not sum(part) > 0.0:
            raise ValueError(f"the durations of stages {stages} are all zero; expected one that lasts")
    return durations
