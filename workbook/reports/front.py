"""The front of a study as a picture of SVG: the best designs by two objectives, each with its place in the table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple
from xml.etree.ElementTree import Element, SubElement

import numpy as np

from engine.laws.base import Array
from workbook.reports.plot import BOTTOM, HEIGHT, LEFT, TOP, WIDTH, grid, scale, text
from workbook.visible import visible

POINT = "#1f5fa8"
RADIUS, GAP = 4.0, 7.0
MARGIN = 0.08
"""of an axis, beside the outermost points"""
LETTER, LINE = 6.4, 13.0
"""width and height of a letter"""
RIGHT = 24


class Point(NamedTuple):
    """A design in the picture: what stands beside it, in words where they fit, else ``short``; its two objectives."""

    name: str
    short: str
    x: float
    y: float


class Box(NamedTuple):
    """A rectangle that is taken."""

    left: float
    top: float
    right: float
    bottom: float

    def meets(self, other: Box) -> bool:
        """Whether it has a place in common with another one."""
        beside = self.right < other.left or other.right < self.left
        return not beside and not (self.bottom < other.top or other.bottom < self.top)


def front_picture(title: str, labels: tuple[str, str], points: Sequence[Point]) -> Element:
    """Return the picture. Raises ValueError for no points."""
    if not points:
        raise ValueError("no points are given; expected one or more")
    svg = Element("svg", {"xmlns": "http://www.w3.org/2000/svg", "viewBox": f"0 0 {WIDTH} {HEIGHT}", "role": "img",
                          "font-family": "Segoe UI, Helvetica, Arial, sans-serif", "font-size": "12"})  # fmt: skip
    SubElement(svg, "title").text = visible(title)
    SubElement(svg, "rect", {"width": str(WIDTH), "height": str(HEIGHT), "fill": "#ffffff"})
    x, y = np.array([one.x for one in points]), np.array([one.y for one in points])
    across = scale(wider(x), LEFT, WIDTH - RIGHT, powers=False)
    up = scale(wider(y), HEIGHT - BOTTOM, TOP, powers=False)
    text(svg, title, LEFT, TOP - 14, weight="600")
    grid(svg, across, up, labels)
    places = list(zip(across.at(x).tolist(), up.at(y).tolist(), strict=True))
    taken = [Box(px - RADIUS, py - RADIUS, px + RADIUS, py + RADIUS) for px, py in places]
    for one, (px, py) in zip(points, places, strict=True):
        SubElement(svg, "circle", {"cx": f"{px:.1f}", "cy": f"{py:.1f}", "r": f"{RADIUS}", "fill": POINT})
        found = next(((words, box) for words in (one.name, one.short) for box in around(px, py, words)
                      if not any(box.meets(other) for other in taken)), None)  # fmt: skip
        if found:
            words, box = found
            taken.append(box)
            text(svg, words, box.left, box.bottom - 3.0)
    return svg


def wider(values: Array) -> Array:
    """Return numbers with room at both ends."""
    low, high = float(values.min()), float(values.max())
    room = MARGIN * (high - low)
    return np.array([low - room, high + room])


def around(x: float, y: float, words: str) -> list[Box]:
    """Return the places beside a point at which words are within the picture: right and left, above and below."""
    width, near = LETTER * len(words), 2.0
    found = [
        Box(left, top, left + width, top + LINE)
        for top in (y - LINE / 2, y - LINE - near, y + near)
        for left in (x + GAP, x - GAP - width)
    ]
    return [box for box in found if box.left > LEFT and box.right < WIDTH and TOP < box.top < HEIGHT - BOTTOM - LINE]
