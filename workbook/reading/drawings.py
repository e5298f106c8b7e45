"""What lies over the cells of a sheet: charts, pictures, shapes, and notes that are always shown."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple
from xml.etree.ElementTree import Element

from workbook.reading.package import links
from workbook.reading.rows import LAST_COLUMN, LAST_ROW, tag

OPAQUE = ("graphicFrame", "pic", "sp")
"""what an anchor may hold that hides the cells behind it (ISO/IEC 29500-1, 20.5.2)"""
PIXEL = 9525  # EMU
NOTHING = Element("nothing")


class Corner(NamedTuple):
    """A point of a sheet: cells to the right and down, from 0, and what is beyond their begin (EMU)."""

    column: int
    row: int
    right: int
    down: int


class Anchor(NamedTuple):
    """Where a drawing lies: from a corner to another, or over a width and a height (EMU); the root of its chart."""

    first: Corner
    last: Corner | None
    size: tuple[int, int]
    chart: Element | None = None


def anchored(parts: Mapping[str, Element], sheet: str) -> list[Anchor]:
    """Return the drawings on a sheet that hide what is behind them, the lowest first; ``parts`` are roots by names."""
    found = []
    for link in links(parts, sheet):
        if link.kind == "drawing":
            charts = {one.id: parts.get(one.target, NOTHING) for one in links(parts, link.target)}
            found += list(anchors(parts.get(link.target, NOTHING), charts))
        elif link.kind == "vmlDrawing":
            found += notes(parts.get(link.target, NOTHING))
    return found


def anchors(root: Element, charts: Mapping[str, Element]) -> Iterator[Anchor]:
    """Yield the anchors of a drawing that hold what hides; ``charts`` are the roots to which its links lead."""
    for element in root.iter():  # one that newer programs alone know stands within an alternative
        if not tag(element).endswith("Anchor"):
            continue
        held = {tag(child): child for child in element}
        if any(one.get("hidden") in ("1", "true") for one in element.iter() if tag(one) == "cNvPr"):
            continue
        if not any(tag(one) in OPAQUE and not see_through(one) for one in element.iter()):
            continue
        ids = [value for one in element.iter() if tag(one) == "chart" for value in one.attrib.values()]
        yield Anchor(
            corner(held["from"]) if "from" in held else Corner(0, 0, *pair(held.get("pos"), "x", "y")),
            corner(held["to"]) if "to" in held else None,
            pair(held.get("ext"), "cx", "cy"),
            next((charts[name] for name in ids if name in charts), None),
        )


def see_through(shape: Element) -> bool:
    """Whether a shape has neither a fill nor a text."""
    if tag(shape) != "sp" or any(tag(one) == "t" and (one.text or "").strip() for one in shape.iter()):
        return False
    look = next((child for child in shape if tag(child) == "spPr"), None)
    return look is not None and any(tag(child) == "noFill" for child in look)


def notes(root: Element) -> Iterator[Anchor]:
    """Yield where the notes and buttons of a sheet lie that are always shown (VML; ISO/IEC 29500-4, 19.4)."""
    for shape in root.iter():
        if tag(shape) != "shape" or "visibility:hidden" in shape.get("style", "").replace(" ", ""):
            continue
        place = next((one.text or "" for one in shape.iter() if tag(one) == "Anchor"), "")
        numbers = [whole(text) for text in place.split(",")]
        if len(numbers) == 8:
            left, right, top, down, *rest = numbers
            ends = (left, top, right * PIXEL, down * PIXEL), (rest[0], rest[2], rest[1] * PIXEL, rest[3] * PIXEL)
            yield Anchor(Corner(*ends[0]), Corner(*ends[1]), (0, 0))


def corner(element: Element) -> Corner:
    """Return a corner of an anchor."""
    held = {tag(child): whole(child.text) for child in element}
    column, row = min(held.get("col", 0), LAST_COLUMN), min(held.get("row", 0), LAST_ROW)
    return Corner(max(column, 0), max(row, 0), held.get("colOff", 0), held.get("rowOff", 0))


def pair(element: Element | None, one: str, other: str) -> tuple[int, int]:
    """Return two numbers of an element; 0 where it has none."""
    return (0, 0) if element is None else (whole(element.get(one)), whole(element.get(other)))


def whole(text: str | None) -> int:
    """Return a number of a drawing; 0 for what is none, or beyond all sheets."""
    digits = (text or "").strip()
    return int(digits) if digits.lstrip("-").isdecimal() and digits.isascii() and len(digits) < 16 else 0
