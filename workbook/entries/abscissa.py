"""What the cycle of a machine is entered and shown over: degrees of its master shaft, or seconds where it has none.

Within, every machine counts its cycle as one turn: what is entered in s becomes degrees once, at the edge, in cells and
for the engine. All that differs is here: units, words, and how places go from the one to the other.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import tau

from workbook.book.sentence import figure
from workbook.entries.turn import TURN
from workbook.entries.units import Real

Range = tuple[float, float | None, float | None]
TAKEN = "timing_taken"
"""the cell of the cycle by which times become degrees: by it a file tells that they are entered in s"""


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
    angle: str = "master angle"
    """what workings in degrees are over"""
    speed: str = "Master shaft"
    """what goes at ω"""
    entered_of: str = "of the master shaft"
    column: str = "[cycle.theta]"
    """of the table over the cycle: what charts are drawn over"""
    format: str = "0.0##"
    length: float = TURN

    @property
    def timed(self) -> bool:
        """Whether it is time."""
        return False

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
class Seconds(Abscissa):
    """Seconds of a cycle of a ``length``."""

    unit: str = "s"
    after: str = " s"
    symbol: str = "t"
    name: str = "time"
    cycle: str = "one cycle"
    period: str = "cycle"
    angle: str = "angle of a turn a cycle"
    speed: str = "A turn a cycle"
    entered_of: str = "of the cycle"
    column: str = "[cycle.time]"
    format: str = "0.0####"

    @property
    def timed(self) -> bool:
        """Whether it is time."""
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
        """Return in s what is in degrees."""
        return x / TURN * self.length

    def per_rad(self, rate: float, order: int) -> float:
        """Return by rad what is entered by s."""
        return rate / float((tau / self.length) ** order)

    def by_s(self, rate: float, order: int) -> float:
        """Return by s a derivative of a motion by rad."""
        return rate * float((tau / self.length) ** order)

    def in_degrees(self, cell: str) -> str:
        """Return the formula of a place in degrees."""
        return f"{cell}/{TAKEN}*360"

    def told(self, cell: str) -> str:
        """Return the formula of a place in s."""
        return f"({cell})/360*{TAKEN}"

    def rate(self, cell: str, order: int) -> str:
        """Return the formula of a derivative by rad."""
        return f"{cell}/timing_omega^{order}"

    def from_rad(self, order: int) -> str:
        """Return the end of a formula that turns a derivative by rad into one by s."""
        return f"*timing_omega^{order}" if order else ""


ANGLE = Abscissa()
