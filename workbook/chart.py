"""What a chart is made of, as sheets declare it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Series:
    """One line of a chart; ``x`` and ``y`` are column references such as ``[samples.xi]``.

    ``points`` draws no line, ``marker`` a sign at each point; ``up`` and ``right`` are columns of lengths, of the
    strokes that go up or to the right from each point: separate lines, none of them a series of its own.
    """

    name: str
    x: str
    y: str
    dashed: bool = False
    points: bool = False
    color: str = ""
    marker: Literal["none", "circle", "diamond", "dash"] = "none"
    up: str = ""
    right: str = ""


@dataclass(frozen=True)
class Chart:
    """An XY chart: lines between points, never splines. An axis title ``=name`` shows the cell of that name.

    A range is least, largest and step; a largest or a step of None is left to the program.
    """

    title: str
    x: str
    y: str
    series: tuple[Series, ...]
    about: str
    x_range: tuple[float, float | None, float | None] | None = None
    y_range: tuple[float, float | None, float | None] | None = None
    hide_y: bool = False
    log_y: bool = False
