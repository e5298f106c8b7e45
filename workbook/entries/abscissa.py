"""What the cycle of a machine is entered and shown over: degrees of its master shaft, or seconds where it has none.

Or an abscissa that does not tell how time passes: degrees or radians of a shaft whose speed nobody says, the travel of
a product. Rates are then by that: y' and y'' in place of velocity and acceleration.

Within, every machine counts its cycle as one turn: what is entered in s becomes degrees once, at the edge, in cells and
for the engine. All that differs is here: units, words, and how places and rates go from the one to the other.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import tau
from typing import Literal, NamedTuple, get_args

from workbook.book.sentence import figure
from workbook.entries.turn import TURN
from workbook.entries.units import DEGREE, MM, Real

Range = tuple[float, float | None, float | None]
TAKEN = "timing_taken"
"""the cell of the cycle by which places become degrees: by it a file tells that they are not entered in them"""
Unit = Literal["s", "°", "rad", "mm"]
UNITS: tuple[Unit, ...] = get_args(Unit)
"""what a cycle can be entered in that has a length"""


class Lift(NamedTuple):
    """How rates show a lift: its unit, what one m or rad is in SI of it, and the end of a formula that makes it one."""

    unit: str
    size: float = 1.0
    shown: str = ""
    taken: str = ""


METRES, RADIANS = Lift("m"), Lift("rad")
ENTERED = {"mm": Lift("mm", MM, "*1000", "/1000"), "°": Lift("°", DEGREE, "*DEGREES(1)", "*RADIANS(1)")}


@dataclass(frozen=True)
class Abscissa:
    """Degrees of a master shaft, entered and shown as they are."""

    unit: str = "°"
    after: str = "°"
    """the unit as it stands behind a figure in sentences"""
    symbol: str = "θ"
    name: str = "master angle"
    cycle: str = "one turn of the master shaft"
    period: str = "turn"
    lasting: str = "t"
    """the symbol of how long something lasts"""
    angle: str = "master angle"
    """what workings in degrees are over"""
    speed: str = "Master shaft"
    """what goes at ω"""
    entered_of: str = "of the master shaft"
    column: str = "theta"
    """of the tables over the cycle: what charts are drawn over"""
    format: str = "0.0##"
    length: float = TURN

    @property
    def measured(self) -> bool:
        """Whether an entry says how long its cycle is, in its unit: places and figures are told by that."""
        return False

    @property
    def paced(self) -> bool:
        """Whether it tells how time passes."""
        return True

    @property
    def symbols(self) -> tuple[str, str, str, str]:
        """Symbols of a position and its rates."""
        return "y", "ẏ", "ÿ", "j"

    @property
    def extremes(self) -> tuple[str, str, str, str]:
        """Symbols of the greatest velocity, acceleration and jerk of a phase, and of its RMS acceleration."""
        return "ẏmax", "ÿmax", "j_max", "ÿrms"

    def lift(self, unit: str) -> Lift:
        """Return how its rates show a lift that is entered in a unit."""
        return METRES if unit == "mm" else RADIANS

    def rates(self, unit: str) -> tuple[str, str, str]:
        """Return the units of velocity, acceleration and jerk of an axis whose lifts are in a unit."""
        lift, per = self.lift(unit).unit, self.unit if self.measured else "s"
        return f"{lift}/{per}", f"{lift}/{per}²", f"{lift}/{per}³"

    @property
    def title(self) -> str:
        """The title of a chart's axis."""
        return f"{self.name} {self.symbol} [{self.unit}]"

    def axis(self, step: float) -> Range:
        """Return the range of a chart's axis, with marks that many degrees apart."""
        return (0, TURN, step)

    def rule(self, table: str, row: int, name: str) -> str:
        """Return who finds a fault of a row of a table, and by which rule: the row itself."""
        return f"{table}.{row - 1}:{name}"

    def degrees(self, x: Real) -> Real:
        """Return in degrees of the turn what is entered."""
        return x

    def shown(self, x: Real) -> Real:
        """Return as it is shown what is in degrees."""
        return x

    def said(self, x: float) -> str:
        """Return what is in degrees as sentences show it."""
        return f"{figure(self.shown(x))}{self.after}"

    def per_rad(self, rate: float, order: int) -> float:
        """Return by rad what is entered of the n-th derivative of a motion."""
        return rate

    def by_unit(self, rate: float, order: int) -> float:
        """Return by its unit a derivative of a motion by rad."""
        return rate

    def in_degrees(self, cell: str) -> str:
        """Return the formula, without its =, of a place in degrees, from the cell in which it is entered."""
        return cell

    def told(self, cell: str) -> str:
        """Return the formula of a place as it is shown, from a cell or formula in degrees."""
        return cell

    def rate(self, cell: str, order: int) -> str:
        """Return the formula of what is entered of a derivative in a cell, by rad."""
        return cell

    def from_rad(self, order: int) -> str:
        """Return the end of a formula that turns a derivative by rad into one by what is shown."""
        return ("", "*PI()/180", "*(PI()/180)^2")[order]


@dataclass(frozen=True)
class Measured(Abscissa):
    """An abscissa whose cycle has a ``length`` that is entered, in its unit."""

    cycle: str = "one cycle"
    period: str = "cycle"
    angle: str = "angle of a turn a cycle"
    speed: str = "A turn a cycle"
    entered_of: str = "of the cycle"
    column: str = "time"
    format: str = "0.0####"

    @property
    def measured(self) -> bool:
        """Whether an entry says how long its cycle is."""
        return True

    def axis(self, step: float) -> Range:
        """Return the range of a chart's axis: its end, an entry, is left to the program."""
        return (0, None, None)

    def rule(self, table: str, row: int, name: str) -> str:
        """Return who finds a fault of a row of a table, and by which rule: the machine, which knows the cycle."""
        return f":{name}{row}"

    def degrees(self, x: Real) -> Real:
        """Return in degrees of the turn what is entered."""
        return x / self.length * TURN

    def shown(self, x: Real) -> Real:
        """Return in its unit what is in degrees."""
        return x / TURN * self.length

    def per_rad(self, rate: float, order: int) -> float:
        """Return by rad what is entered by its unit."""
        return rate / float((tau / self.length) ** order)

    def by_unit(self, rate: float, order: int) -> float:
        """Return by its unit a derivative of a motion by rad."""
        return rate * float((tau / self.length) ** order)

    def in_degrees(self, cell: str) -> str:
        """Return the formula of a place in degrees."""
        return f"{cell}/{TAKEN}*360"

    def told(self, cell: str) -> str:
        """Return the formula of a place in its unit."""
        return f"({cell})/360*{TAKEN}"

    def rate(self, cell: str, order: int) -> str:
        """Return the formula of a derivative by rad."""
        return f"{cell}/timing_omega^{order}"

    def from_rad(self, order: int) -> str:
        """Return the end of a formula that turns a derivative by rad into one by its unit."""
        return f"*timing_omega^{order}" if order else ""


@dataclass(frozen=True)
class Seconds(Measured):
    """Seconds of a cycle."""

    unit: str = "s"
    after: str = " s"
    symbol: str = "t"
    name: str = "time"


@dataclass(frozen=True)
class Way(Measured):
    """An abscissa that does not tell how time passes: an angle, or the travel of a product."""

    symbol: str = "x"
    name: str = "abscissa"
    lasting: str = "δ"

    @property
    def paced(self) -> bool:
        """Whether it tells how time passes."""
        return False

    @property
    def symbols(self) -> tuple[str, str, str, str]:
        """Symbols of a position and its rates."""
        return "y", "y'", "y''", "y'''"

    @property
    def extremes(self) -> tuple[str, str, str, str]:
        """Symbols of the greatest velocity, acceleration and jerk of a phase, and of its RMS acceleration."""
        _, first, second, third = self.symbols
        return first, second, third, second

    def lift(self, unit: str) -> Lift:
        """Return how its rates show a lift: as it is entered."""
        return ENTERED[unit]


ANGLE = Abscissa()
WAYS: dict[str, tuple[str, str, str]] = {
    "°": ("°", "θ", "angle"), "rad": (" rad", "θ", "angle"), "mm": (" mm", "x", "travel"),
}  # fmt: skip
"""how each is written behind a figure, its symbol and name"""


def measured(unit: str, length: float) -> Abscissa:
    """Return the abscissa of a cycle of a length in a unit."""
    if unit == "s":
        return Seconds(length=length)
    after, symbol, name = WAYS[unit]
    return Way(unit=unit, after=after, symbol=symbol, name=name, length=length)


def in_unit(unit: str) -> str:
    """Return the name of the cell that says what a cycle is over: by it a file tells that."""
    return f"timing_in_{MARKS[unit]}"


MARKS: dict[str, str] = {"s": "s", "°": "deg", "rad": "rad", "mm": "mm"}
