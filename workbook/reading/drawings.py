"""Where drawings lie over the cells of a sheet: charts, pictures, and shapes that are filled."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple
from xml.etree.ElementTree import Element, ParseError, fromstring

from workbook.reading.package import links, tag
from workbook.reading.refusal import SAVE_AS, Refusal, shown
from workbook.reading.rows import LAST_COLUMN, LAST_ROW

OPAQUE = ("graphicFrame", "pic", "sp")
"""what an anchor may hold that hides the cells behind it (ISO/IEC 29500-1, 20.5.2)"""


class Corner(NamedTuple):
    """A point of a sheet: cells to the right and down, from 0, and what is beyond their begin (EMU)."""

    column: int
    row: int
    right: int
    down: int


class Anchor(NamedTuple):
    """Where a drawing lies: from a corner to another, or over a width and a height (EMU)."""

    first: Corner
    last: Corner | None
    size: tuple[int, int]


def anchored(parts: Mapping[str, bytes], sheet: str, read: Callable[[str], bytes]) -> list[Anchor]:
    """Return where the drawings of a sheet lie that hide what is behind them.

    ``sheet`` is its part, ``parts`` are those with relationships, and ``read`` gives any, empty for one that is none.
    """
    drawings = [read(link.target) for link in links(parts, sheet) if link.kind == "drawing"]
    try:
        return [anchor for data in drawings if data for anchor in anchors(fromstring(data))]
    except ParseError:
        raise Refusal(f"damaged: a drawing of the sheet in {shown(sheet)} is no XML; {SAVE_AS}") from None


def anchors(root: Element) -> Iterator[Anchor]:
    """Yield the anchors of a drawing that hold what hides."""
    for element in root.iter():  # one that newer programs alone know stands within an alternative
        if not tag(element).endswith("Anchor"):
            continue
        held = {tag(child): child for child in element}
        if not any(tag(one) in OPAQUE and not see_through(one) for one in element.iter()):
            continue
        yield Anchor(
            corner(held["from"]) if "from" in held else Corner(0, 0, *pair(held.get("pos"), "x", "y")),
            corner(held["to"]) if "to" in held else None,
            pair(held.get("ext"), "cx", "cy"),
        )


def see_through(shape: Element) -> bool:
    """Whether a shape has no fill."""
    if tag(shape) != "sp":
        return False
    look = next((child for child in shape if tag(child) == "spPr"), None)
    return look is not None and any(tag(child) == "noFill" for child in look)


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
