"""The shaft that a motor and a reducer are chosen for: what it asks of them, in figures and in formulas."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from engine.laws.base import Array
from engine.laws.points import POINTS
from engine.selection.point_load import PointLoad
from workbook.book.chart import in_scope
from workbook.book.rows import filled


class Figure(NamedTuple):
    """A figure of a shaft or of its drive: the formula of its cell without ``=``, the engine's value, its scale."""

    name: str
    label: str
    unit: str
    formula: str
    value: float
    scale: float = 0.0


LABELS = {
    "own": ("mean of α²", "rad²/s⁴"), "square": ("mean of S², driving", "Nm²"), "square_back": ("… driven", "Nm²"),
    "product": ("mean of α S, driving", "W/s"), "product_back": ("… driven", "W/s"),
    "way": ("share of the cycle in motion", ""), "way_turning": ("mean of α d", "rad/s²"),
    "way_behind": ("mean of S d, driving", "Nm"), "way_back": ("… driven", "Nm"), "speed": ("largest speed", "rad/s"),
    "mean": ("mean speed", "rad/s"), "smax": ("largest torque", "Nm"), "smean": ("mean torque", "Nm"),
    "cycles": ("cycles an hour", "1/h"), "inertia": ("inertia", "kg m²"), "beside": ("parts beside the motor", "kg m²"),
    "brake": ("held by a brake in every dwell", ""), "by_power": ("losses by the flow of power", ""),
    "left": ("rated torque available at the ambient temperature", ""), "held_j": ("inertia with its motor", "kg m²"),
    "held_jm": ("its motor", "kg m²"), "held_i": ("its reduction", ""), "held_eta": ("its efficiency", ""),
    "held_no_load": ("its no-load torque", "Nm"), "held_rated": ("its continuous torque", "Nm"),
    "held_peak": ("its peak torque", "Nm"), "held_top": ("peak torque demand", "Nm"),
    "held_spare": ("reserve below the motor's curve", "Nm"), "held_nmax": ("its largest speed", "rpm"),
    "held_row": ("its row of motors", ""), "held_gear": ("its row of reducers", ""),
    "turns": ("acceleration of its shaft over that of its points", ""),
}  # fmt: skip
"""of each figure of a shaft and of the pair that drives it, in the order of the sheet: what it is, and its unit"""


def figures(scope: str, found: Mapping[str, tuple[str, float] | tuple[str, float, float]]) -> list[Figure]:
    """Return figures of their formulas, values and scales, ``scope`` in place of @."""
    return [Figure(name, *of, in_scope(found[name][0], scope), *found[name][1:]) for name, of in LABELS.items()]


@dataclass(frozen=True)
class Shaft:
    """A shaft behind a reducer, with the pair that drives it.

    ``title`` is the formula of its axis' name. ``columns`` begins the names of the columns of its points in the book
    (``dir``, ``al``, ``S``, ``n``); they have ``rows`` intervals, spare ones among them. ``rpm`` makes |speed| of the
    shaft (rpm) of the column ``n``. ``turning`` is the scale of ω̇ (rad/s²), ``torque`` that of S (Nm).
    """

    name: str
    number: int
    title: str
    columns: str
    rows: int
    load: PointLoad
    rpm: str
    turning: float
    torque: float
    figures: Sequence[Figure]

    @cached_property
    def values(self) -> dict[str, float]:
        """The engine's value of each figure."""
        return {one.name: one.value for one in self.figures}

    @property
    def product(self) -> float:
        """The scale of means of ω̇ S (W/s)."""
        return self.turning * self.torque

    def by_point(self, values: Array) -> list[float]:
        """Return values of the points as a column; spare rows have that of the last."""
        flat = values.ravel()
        return filled(flat, self.rows * POINTS, float(flat[-1]))


MIXED = "@product/{eta}+@product_back*{eta}+{i}*{own}*@way_turning"
"""the mean of ω̇ S, of the shaft's acceleration and the load's torque before the reducer's losses, with its own"""
SQUARE = "(@square/{eta}^2+@square_back*{eta}^2)/{i}^2+2*{own}*(@way_behind/{eta}+@way_back*{eta})/{i}+{own}^2*@way"
"""the mean square of the load's torque at the motor, with the reducer's own"""


def through(ratio: Any, efficiency: Any) -> tuple[Any, Any]:
    """Return what a reducer makes of a torque behind it at the motor: 1/(η i) of one that drives, else η/i."""
    return 1.0 / (efficiency * ratio), efficiency / ratio


def torque_of(inertia: str, ratio: str, out: str, back: str, own: str) -> str:
    """Return the formula of the torques of a motor at the points of the cycle; ``out`` is 1/(η i), ``back`` η/i."""
    return f"{inertia}*{ratio}*@al+{out}*@out+{back}*@back+{own}*@dir"


def peak_of(inertia: str, ratio: str, out: str, back: str, own: str) -> str:
    """Return the formula of the peak torque of a motor; no program takes ABS of an array in MAX alike."""
    return f"SUMPRODUCT(MAX(({torque_of(inertia, ratio, out, back, own)})^2))^0.5"


def rms_of(inertia: str, ratio: str, mixed: str, square: str) -> str:
    """Return the formula of the RMS torque of a motor: √((J i)² ω̇_rms² + 2 J mean(ω̇ S') + mean(S'²)/i²)."""
    return f"SQRT(MAX(0,({inertia}*{ratio})^2*@own+2*{inertia}*{mixed}+{square}))"
