"""The parts of a chart, and a label, as sheets declare them."""

from dataclasses import dataclass, replace
from typing import Literal, NamedTuple, Self

COLOURS = ("0072B2", "D55E00", "009E73", "CC79A7", "E69F00", "56B4E9", "374151")
"""Of the lines of a chart in their order, where they name none: told apart without red and green (Okabe, Ito 2008)."""


def colour(number: int) -> str:
    """Return the colour that a thing, such as an axis, has in all charts of a book, by its number from 1."""
    return COLOURS[(number - 1) % len(COLOURS)]


def in_scope(text: str, scope: str) -> str:
    """Return a name, a reference or a formula with ``scope`` for each ``@``."""
    return text.replace("@", scope)


@dataclass(frozen=True)
class Series:
    """One line of a chart; columns are written as ``[samples.xi]``."""

    # beside it; ``=tool1_name`` shows that cell, ``=tool1_name:tool1_unit`` the cells from it to another,
    # ``[table.c0:c1.3]`` those of a table's row
    name: str
    x: str
    y: str
    dashed: bool = False
    points: bool = False  # drawn in place of a line
    color: str = ""  # hexadecimal; empty for the next of the palette
    marker: Literal["none", "circle", "diamond", "dash"] = "none"  # at each point
    up: str = ""  # the lengths of strokes up from each point
    right: str = ""  # and to the right
    thick: bool = False  # as bars are
    is_note: bool = False  # only its name is shown, at its point

    def within(self, scope: str) -> Self:
        """Return the line with ``scope`` for each ``@`` in its references."""
        name, x, y, up, right = (in_scope(text, scope) for text in (self.name, self.x, self.y, self.up, self.right))
        return replace(self, name=name, x=x, y=y, up=up, right=right)


@dataclass(frozen=True)
class Chart:
    """An XY chart: straight lines between points."""

    title: str
    x: str  # the title of the axis, with unit; ``=name`` shows the cell of that name, "" none
    y: str
    series: tuple[Series, ...]
    about: str  # what it shows, for those who cannot see it
    # least, largest and step; a largest or a step of None is left to the program
    x_range: tuple[float, float | None, float | None] | None = None
    y_range: tuple[float, float | None, float | None] | None = None
    # each line in a lane of its own, named where it begins; heights have no figures
    lanes: bool = False
    notes: tuple[Series, ...] = ()  # beside the lines where it is large, on the first sheet
    is_lane: bool = False  # low, one of several below each other: its title beside it, places without figures
    log_y: bool = False
    legend: bool = True  # whether several lines have their names beside them; else the title says what they are

    def within(self, scope: str) -> Self:
        """Return the chart with ``scope`` for each ``@`` in the references of its lines."""
        if scope:
            return replace(self, series=tuple(series.within(scope) for series in self.series))
        return self


class Text(NamedTuple):
    """A label on the sheet, with the style it takes; ``link`` names a sheet to jump to, at a cell of it.

    Without a text it links the declared cell in its place. The head of a column stands to the ``side`` of its cells.
    """

    row: int
    column: int
    text: str
    style: str
    link: str = ""
    linked_cell: str = "A1"
    side: str = ""
