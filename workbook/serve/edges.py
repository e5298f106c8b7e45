"""The edges of phases in a description's text, and their handles in the timing diagram, by which they are dragged."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from workbook.reports.plot import Line, Scales

AXIS = re.compile(r"(?m)^\[\[axes\]\]")
HEADER = re.compile(r"(?m)^\s*\[")
TABLE = re.compile(r"(?m)^\s*\[\[axes\.phases\]\]")
INLINE = re.compile(r"(?m)^\s*phases\s*=\s*\[")
ENTRY = re.compile(r"\b(?:start|stop)\s*=\s*(-?\d[\d.]*)")
STEP = 360
"""steps of a cycle: of one in degrees, a degree"""
RADIUS = "6"


class Edge(NamedTuple):
    """Where phases of an axis begin or end: as entered, and where in the text the numbers of it stand."""

    axis: str
    value: float
    places: list[tuple[int, int]]


def edges(text: str, machine: Any) -> Iterator[Edge]:
    """Yield the edges of all axes whose phases stand in the text as the machine has them."""
    marks = [found.start() for found in AXIS.finditer(text)]
    axes = getattr(machine, "axes", [])
    for axis, begin, end in zip(axes, marks, [*marks[1:], len(text)], strict=False):
        found = [(float(one[1]), one.span(1)) for one in entries(text, begin, end)]
        entered = [value for phase in axis.phases for value in (phase.start, phase.stop)]
        if [value for value, _ in found] == entered and len(marks) == len(axes):
            for value in dict.fromkeys(entered):
                yield Edge(axis.name, value, [place for one, place in found if one == value])


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
    """Add a handle to the timing diagram for each edge, on the line of its axis."""
    drawn = {line.name: line for line in lines}
    svg.set("role", "group")
    for edge in found:
        line = drawn.get(edge.axis)
        if line is None:
            continue
        begin, cycle = float(line.x[0]), float(np.ptp(line.x))
        later = edge.value + shifts[edge.axis] - begin
        at = np.array([begin + (later if 0.0 <= later <= cycle else later % cycle)])
        width = scales.across.end - scales.across.begin
        handle = SubElement(svg, "circle", {
            "class": "edge", "tabindex": "0", "role": "slider", "r": RADIUS,
            "cx": f"{scales.across.at(at)[0]:.1f}", "cy": f"{scales.up.at(np.interp(at, line.x, line.y))[0]:.1f}",
            "aria-label": f"{edge.axis}, edge of a phase", "aria-valuenow": f"{edge.value:g}",
            "data-edge": f"{edge.axis} {edge.value:g}", "data-value": f"{edge.value!r}",
            "data-step": f"{10.0 ** round(np.log10(cycle / STEP)):g}", "data-across": f"{cycle / width!r}",
            "data-places": " ".join(f"{low}-{high}" for low, high in edge.places),
        })  # fmt: skip
        SubElement(handle, "title").text = f"{edge.axis}: {edge.value:g}"
