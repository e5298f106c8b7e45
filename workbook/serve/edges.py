"""Edges of phases and shifts of axes in a description's text, and their handles in the timing diagram."""

import re
from collections.abc import Iterator
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from workbook.reports.plot import Line, Scales
from workbook.visible import visible

AXIS = re.compile(r"(?m)^\[\[axes\]\]")
HEADER = re.compile(r"(?m)^\s*\[")
TABLE = re.compile(r"(?m)^\s*\[\[axes\.phases\]\]")
INLINE = re.compile(r"(?m)^\s*phases\s*=\s*\[")
ENTRY = re.compile(r"\b(?:start|stop)\s*=\s*(-?\d[\d.]*)")
SHIFT = re.compile(r"(?m)^\s*shift\s*=\s*(-?\d[\d.]*)")
NAME = re.compile(r"(?m)^\s*name\s*=.*$")
STEP = 360  # steps of a cycle: of one in degrees, a degree
RADIUS = "6"


class Edge(NamedTuple):
    """What is dragged in the diagram: where phases of an axis begin or end, or its whole lane.

    ``value`` is as entered; ``places`` are where its numbers stand in the text. A lane without a shift in the text has
    the place for one, and ``before`` is what is to be written before its number.
    """

    axis: str
    value: float
    places: list[tuple[int, int]]
    lane: bool = False
    before: str = ""

    @property
    def key(self) -> str:
        """What the page finds its handle by, also in the next picture."""
        return f"{self.axis} {'lane' if self.lane else format(self.value, 'g')}"


def edges(text: str, machine: Any) -> Iterator[Edge]:
    """Yield the lane and the edges of each axis whose entries stand in the text as the machine has them."""
    marks = [found.start() for found in AXIS.finditer(text)]
    axes = getattr(machine, "axes", [])
    if len(marks) != len(axes):
        return
    for axis, begin, end in zip(axes, marks, [*marks[1:], len(text)], strict=False):
        yield from lane(text, axis, begin, end)
        found = [(float(one[1]), one.span(1)) for one in entries(text, begin, end)]
        entered = [value for phase in axis.phases for value in (phase.start, phase.stop)]
        if [value for value, _ in found] == entered:
            for value in dict.fromkeys(entered):
                yield Edge(axis.name, value, [place for one, place in found if one == value])


def lane(text: str, axis: Any, begin: int, end: int) -> Iterator[Edge]:
    """Yield the lane of an axis: its shift in its part of a text, or where there is room for one."""
    following = HEADER.search(text, text.index("\n", begin), end)
    end = following.start() if following else end
    shift, name = SHIFT.search(text, begin, end), NAME.search(text, begin, end)
    if shift and float(shift[1]) == axis.shift:
        yield Edge(axis.name, axis.shift, [shift.span(1)], lane=True)
    elif not shift and not axis.shift and name:
        yield Edge(axis.name, 0.0, [(name.end(), name.end())], lane=True, before="\nshift = ")


def entries(text: str, begin: int, end: int) -> Iterator[re.Match[str]]:
    """Yield the numbers of the phases in the part of a text that describes an axis, but for comments."""
    for low, high in phases(text, begin, end):
        for found in ENTRY.finditer(text, low, high):
            if "#" not in text[text.rfind("\n", 0, found.start()) + 1 : found.start()]:
                yield found


def phases(text: str, begin: int, end: int) -> Iterator[tuple[int, int]]:
    """Yield where phases stand: a list in one entry, or a table each."""
    for found in INLINE.finditer(text, begin, end):
        depth, at = 1, found.end()
        while depth and at < end:
            depth += {"[": 1, "]": -1}.get(text[at], 0)
            at += 1
        yield found.end(), at
    for found in TABLE.finditer(text, begin, end):
        following = HEADER.search(text, found.end(), end)
        yield found.end(), following.start() if following else end


def add_handles(svg: Element, scales: Scales, lines: list[Line], found: list[Edge], shifts: dict[str, float]) -> None:
    """Add a handle to the timing diagram for each edge, on the line of its axis; a lane's is the name at its line."""
    across, up = scales
    drawn = {line.name: line for line in lines}
    names = {one.text: one for one in svg.iter("text")}
    svg.set("role", "group")
    for edge in found:
        line = drawn.get(edge.axis)
        if line is None:
            continue
        begin, cycle = float(line.x[0]), float(np.ptp(line.x))
        width = across.end - across.begin
        if edge.lane:
            handle = names[visible(edge.axis)]
        else:
            later = edge.value + shifts[edge.axis] - begin
            at = np.array([begin + (later if 0.0 <= later <= cycle else later % cycle)])
            x, y = across.at(at)[0], up.at(np.interp(at, line.x, line.y))[0]
            handle = SubElement(svg, "circle", {"r": RADIUS, "cx": f"{x:.1f}", "cy": f"{y:.1f}"})
            SubElement(handle, "title").text = f"{edge.axis}: {edge.value:g}"
        handle.attrib.update({
            "class": "lane" if edge.lane else "edge", "tabindex": "0", "role": "slider",
            "aria-label": f"{edge.axis}, {'shift' if edge.lane else 'edge of a phase'}",
            "aria-valuenow": f"{edge.value:g}", "data-edge": edge.key, "data-value": f"{edge.value!r}",
            "data-step": f"{10.0 ** round(np.log10(cycle / STEP)):g}", "data-across": f"{cycle / width!r}",
            "data-places": " ".join(f"{low}-{high}" for low, high in edge.places), "data-before": edge.before,
        })  # fmt: skip
