"""The front of a study as a picture of SVG: the best designs by two objectives, each with its place in the table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from workbook.reports.plot import BOTTOM, HEIGHT, INK, LEFT, RIGHT, TOP, WIDTH, grid, scale, text
from workbook.visible import visible

POINT = "#1f5fa8"
OTHER = "#c0571a"
RADIUS = 4.0
APART = 13.0


class Point(NamedTuple):
    """A design in the picture: what stands beside it, and its two objectives; ``marked`` in another colour."""

    name: str
    x: float
    y: float
    marked: bool = False


def front_picture(title: str, labels: tuple[str, str], points: Sequence[Point]) -> Element:
    """Return the picture. Raises ValueError for no points."""
    if not points:
        raise ValueError("no points are given; expected one or more")
    svg = Element("svg", {"xmlns": "http://www.w3.org/2000/svg", "viewBox": f"0 0 {WIDTH} {HEIGHT}", "role": "img",
                          "font-family": "Segoe UI, Helvetica, Arial, sans-serif", "font-size": "12"})  # fmt: skip
    SubElement(svg, "title").text = visible(title)
    SubElement(svg, "rect", {"width": str(WIDTH), "height": str(HEIGHT), "fill": "#ffffff"})
    x, y = np.array([one.x for one in points]), np.array([one.y for one in points])
    across, up = scale(x, LEFT, WIDTH - RIGHT, powers=False), scale(y, HEIGHT - BOTTOM, TOP, powers=False)
    text(svg, title, LEFT, TOP - 14, weight="600")
    grid(svg, across, up, labels)
    taken: list[tuple[float, float]] = []
    for one, px, py in zip(points, across.at(x).tolist(), up.at(y).tolist(), strict=True):
        colour = OTHER if one.marked else POINT
        SubElement(svg, "circle", {"cx": f"{px:.1f}", "cy": f"{py:.1f}", "r": f"{RADIUS}", "fill": colour})
        place = py - RADIUS
        while any(abs(place - other) < APART and abs(px - beside) < WIDTH / 3 for beside, other in taken):
            place -= APART / 2
        if place > TOP:
            taken.append((px, place))
            text(svg, one.name, px + RADIUS + 3, place, colour=INK)
    return svg
