"""A cam table as a controller holds it, and the motions that rules make of it."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

import numpy as np

from engine.cams import interpolation
from engine.cams.cam_points import CamPoints
from engine.laws.base import Array, Flags
from engine.motion.profile import CamProfile
from workbook.errors import TargetError

MOST_POINTS = 100_000
T = TypeVar("T")


@dataclass(frozen=True)
class Table:
    """Points of a cam, with derivatives by x; raises TargetError for what is not finite, or an x that does not rise."""

    x: Array
    y: Array
    v: Array | None = None
    a: Array | None = None
    j: Array | None = None
    slopes: tuple[float, float] | None = None  # at both ends of a clamped spline
    straight: Flags | None = None  # which way from a point is a line
    profile: CamProfile | None = None  # the motion itself where the controller is given polynomials
    steps: tuple[float, float] = (1.0, 1.0)  # what whole numbers of x and y count

    def __post_init__(self) -> None:
        if not 2 <= len(self.x) <= MOST_POINTS:
            raise TargetError(f"{len(self.x):,} points; expected 2 to {MOST_POINTS:,}")
        for name, column in self.columns.items():
            if len(column) != len(self.x):
                raise TargetError(f"{len(column)} values of {name} for {len(self.x)} points; expected one each")
            if not np.all(np.isfinite(column)):
                k = int(np.argmin(np.isfinite(column)))
                raise TargetError(f"point {k + 1}: {name} is {column[k]}; expected a finite number")
        rises = np.diff(self.x) > 0.0
        if not rises.all():
            k = int(np.argmin(rises)) + 1
            message = f"point {k + 1}: x is {self.x[k]:.9g} after {self.x[k - 1]:.9g}"
            raise TargetError(f"{message}; expected the master to rise from point to point")

    @property
    def columns(self) -> dict[str, Array]:
        """The columns that it has, by name."""
        named = {"x": self.x, "y": self.y, "y'": self.v, "y''": self.a, "y'''": self.j}
        return {name: column for name, column in named.items() if column is not None}


def equidistant(x: Array) -> bool:
    """Whether places are at equal steps."""
    return bool(np.allclose(x, np.linspace(x[0], x[-1], len(x)), rtol=0.0, atol=1e-9 * float(x[-1] - x[0])))


class Rule(NamedTuple):
    """A way between points: what makes it, the degree of its polynomials and 1, and the steps a stretch needs."""

    rebuild: Callable[[Table], CamProfile]
    order: int
    least: int = 1


def _clamped(table: Table) -> CamProfile:
    """Return the clamped spline, which lines part; with slopes that nobody gave it goes on as its points do."""
    slopes = table.slopes
    if slopes is None:
        points = CamPoints(table.x, table.y, None, None, 0.0)
        near, other = (points.rate_at(side)[0] if points.moves_at(side) else 0.0 for side in (0, -1))
        slopes = near, other
    if table.straight is None or not table.straight.any():
        return interpolation.spline(table.x, table.y, slopes)
    return interpolation.parted_spline(table.x, table.y, slopes, table.straight)


def required_part(part: T | None, part_name: str) -> T:
    """Return a part of a table; raise TargetError where it has none."""
    if part is None:
        raise TargetError(f"the table has no {part_name}")
    return part


BOTH = "y' and y''; expected both, for polynomials of degree 5"

RULES: dict[str, Rule] = {  # what is between the points, by name
    "straight lines": Rule(lambda t: interpolation.lines(t.x, t.y), 2),
    "clamped cubic spline": Rule(_clamped, 4, 2),
    "natural cubic spline": Rule(lambda t: interpolation.spline(t.x, t.y, "natural"), 4, 2),
    "not-a-knot cubic spline": Rule(lambda t: interpolation.spline(t.x, t.y, "not-a-knot"), 4, 2),
    "periodic cubic spline": Rule(lambda t: interpolation.spline(t.x, t.y, "periodic"), 4, 2),
    "cubics by neighbours": Rule(lambda t: interpolation.parabolas(t.x, t.y), 4, 2),
    "cubics by the line between neighbours": Rule(lambda t: interpolation.central(t.x, t.y), 4, 2),
    "quintics": Rule(lambda t: interpolation.quintics(t.x, t.y, required_part(t.v, BOTH), required_part(t.a, BOTH)), 6),
    "polynomials": Rule(lambda t: required_part(t.profile, "polynomials; expected them"), 6),
}
SPLINES = tuple(name for name in RULES if "spline" in name)
