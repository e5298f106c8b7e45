"""The abscissa of a cycle (a shaft's degrees, time, an angle, a travel), and its conversion to degrees of a turn."""

from dataclasses import dataclass, replace
from math import inf, tau
from typing import Literal, NamedTuple, get_args

from workbook.book.sentence import figure
from workbook.entries.phase import TURN
from workbook.fields.units import DEGREE, MM, Real

Range = tuple[float, float | None, float | None]
TAKEN = "timing_taken"  # the cell by which places become degrees
Unit = Literal["s", "°", "rad", "mm"]
PLACE = "° or the cycle's unit"  # of entries that are places of a cycle
UNITS: tuple[Unit, ...] = get_args(Unit)  # what a cycle can be entered in that has a length


class Lift(NamedTuple):
    """Display of rates of a lift: its unit, the size of a m or rad in it, and the end of a formula that converts."""

    unit: str
    size: float = 1.0
    shown: str = ""
    taken: str = ""


METRES, RADIANS = Lift("m"), Lift("rad")
ENTERED = {"mm": Lift("mm", MM, "*1000", "/1000"), "°": Lift("°", DEGREE, "*DEGREES(1)", "*RADIANS(1)")}


@dataclass(frozen=True)
class Abscissa:
    """The abscissa of a cycle: by default degrees of a master shaft, entered and shown without conversion."""

    unit: str = "°"
    after: str = "°"  # the unit as it stands behind a figure in sentences
    symbol: str = "θ"
    name: str = "master angle"
    cycle: str = "one turn of the master shaft"
    period: str = "turn"
    lasting: str = "t"  # the symbol of how long something lasts
    angle: str = "master angle"  # what workings in degrees are over
    speed: str = "Master shaft"  # what goes at ω
    entered_of: str = "of the master shaft"
    column: str = "theta"  # of the tables over the cycle: what charts are drawn over
    format: str = "0.0##"
    length: float = TURN
    # the largest place that a cell takes: as a cycle is as long as is entered, any there
    upper_limit: float = 360
    measured: bool = False  # with a length that is entered, in its unit
    timed: bool = True  # whether rates are over time: in s, or in degrees of a shaft at a rate
    symbols: tuple[str, str, str, str] = ("y", "ẏ", "ÿ", "j")  # of a position and its rates
    extremes: tuple[str, str, str, str] = ("ẏmax", "ÿmax", "j_max", "ÿrms")
    """symbols of the greatest velocity, acceleration and jerk of a phase, and of its RMS acceleration"""

    def lift(self, unit: str) -> Lift:
        """Return the unit of lifts in velocity and acceleration: m or rad over time, else as entered."""
        return (METRES if unit == "mm" else RADIANS) if self.timed else ENTERED[unit]

    def rates(self, unit: str) -> tuple[str, str, str]:
        """Return the units of velocity, acceleration and jerk of an axis whose lifts are in a unit."""
        lift, per = self.lift(unit).unit, self.unit if self.measured else "s"
        return f"{lift}/{per}", f"{lift}/{per}²", f"{lift}/{per}³"

    @property
    def words(self) -> dict[str, str]:
        """The label, symbol, unit and format of a column of places."""
        return {"label": self.name, "symbol": self.symbol, "unit": self.unit, "format": self.format}

    @property
    def title(self) -> str:
        """The title of a chart's axis."""
        return f"{self.name} {self.symbol} [{self.unit}]"

    def axis(self, step: float) -> Range:
        """Return the range of a chart's axis, with marks that many degrees apart; an entered end is the program's."""
        return (0, None, None) if self.measured else (0, TURN, step)

    def degrees(self, x: Real) -> Real:
        """Return a place of the cycle, as entered, in degrees of a turn."""
        return x / self.length * TURN if self.measured else x

    def shown(self, x: Real) -> Real:
        """Return a place in degrees in the unit of the abscissa."""
        return x / TURN * self.length if self.measured else x

    def text(self, x: float) -> str:
        """Return a place in degrees as sentences show it."""
        return f"{figure(self.shown(x))}{self.after}"

    def per_rad(self, rate: float, order: int) -> float:
        """Return an entered derivative of a motion per rad^order; with -order the other way round."""
        return rate / float((tau / self.length) ** order) if self.measured else rate

    def degrees_formula(self, cell: str) -> str:
        """Return the formula, without its =, of a place in degrees, from the cell in which it is entered."""
        return f"{cell}/{TAKEN}*360" if self.measured else cell

    def shown_formula(self, cell: str) -> str:
        """Return the formula of a place as it is shown, from a cell or formula in degrees."""
        return f"({cell})/360*{TAKEN}" if self.measured else cell

    def per_rad_formula(self, cell: str, order: int) -> str:
        """Return the formula of an entered derivative, per rad^order."""
        return f"{cell}/omega^{order}" if self.measured else cell

    def from_rad(self, order: int) -> str:
        """Return the end of a formula that turns a derivative by rad into a derivative by what is shown."""
        if self.measured:
            return f"*omega^{order}" if order else ""
        return ("", "*PI()/180", "*(PI()/180)^2")[order]


ANGLE = Abscissa()
NAMED = {  # how each is written behind a figure, its symbol and name
    "s": (" s", "t", "time"), "°": ("°", "θ", "angle"), "rad": (" rad", "θ", "angle"), "mm": (" mm", "x", "travel"),
}  # fmt: skip
# symbols of a position and its rates by another abscissa than time
BY_X = ("y", "y'", "y''", "y'''")


def length_abscissa(unit: str, length: float) -> Abscissa:
    """Return the abscissa of a cycle of a length in a unit."""
    (after, symbol, name), timed = NAMED[unit], unit == "s"
    abscissa = Abscissa(
        unit,
        after,
        symbol,
        name,
        "one cycle",
        "cycle",
        "t" if timed else "δ",
        "angle of a turn a cycle",
        "A turn a cycle",
        "of the cycle",
        "time",
        "0.0####",
        length,
        inf,
        measured=True,
        timed=timed,
    )
    return abscissa if timed else replace(abscissa, symbols=BY_X, extremes=(*BY_X[1:], BY_X[2]))
