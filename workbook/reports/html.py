"""Pages of HTML from templates; pictures of SVG: lines over an abscissa, each with its name, the front of a study."""

import math
import re
from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from tornado.escape import xhtml_escape
from tornado.template import Loader

from engine.laws.base import Array
from workbook.book.chart import COLOURS
from workbook.errors import visible

STYLE = "".join(
    f"\n{Path(__file__).with_name(name).read_text(encoding='utf-8')}" for name in ("colors.css", "page.css")
)
WIDTH, HEIGHT = 720, 400
LEFT, RIGHT, TOP, BOTTOM = 78, 170, 34, 50
INK = "#1a1a1a"
TICKS = 6
APART = 14  # between two names
POINT = "#1f5fa8"
RADIUS, GAP = 4.0, 7.0
MARGIN = 0.08  # of an axis, beside the outermost points
LETTER, LINE = 6.4, 13.0  # width and height of a letter
BREAK = re.compile(r" ?[0-9.]+,nan ?")
ROOM = 24  # beside the front, to the right
Box = tuple[float, float, float, float]  # left, top, right and bottom of what is taken


def document(title: str, template: str, above: str = "", /, **values: Any) -> str:
    """Return a page of HTML: a template filled with values, which has the title too, and HTML ``above`` it."""
    body = render(template, title=title, **values)
    return render("reports/document.html", title=title, style=STYLE, body=body, above=above)


def render(template: str, /, **values: Any) -> str:
    """Return a template beside the modules, such as ``reports/page.html``, filled with values; texts are escaped.

    It imports what it calls.
    """
    return PAGES.load(template).generate(**values).decode()


def shown(text: str | bytes) -> str:
    """Return a text as HTML."""
    return xhtml_escape(xml_safe(text if isinstance(text, str) else text.decode()))


def as_bytes(text: str | bytes) -> bytes:
    """Return a text as Tornado's templates hold it, also halves of characters."""
    return text if isinstance(text, bytes) else text.encode(errors="backslashreplace")


def table(headings: Sequence[str], rows: Iterable[Sequence[str]], numbers: Container[int]) -> str:
    """Return a table whose columns ``numbers`` stand to the right."""
    css = [' class="number"' if k in numbers else "" for k in range(len(headings))]
    return render("reports/table.html", headings=headings, rows=rows, css=css)


def xml_safe(text: str) -> str:
    """Return a text with a visible escape for each character that neither XML nor a file in UTF-8 can hold."""
    return visible(text, safe="\t\n")


FOLDER = str(Path(__file__).parents[1])
PAGES = Loader(FOLDER, autoescape="shown", namespace={"shown": shown, "table": table, "_tt_utf8": as_bytes})


class Line(NamedTuple):
    """A line: its name, and the points that it goes through, with gaps at nan; ``points`` are shown by themselves."""

    name: str
    x: Array
    y: Array
    points: bool = False


@dataclass(frozen=True)
class Scale:
    """The scale from an axis onto the picture."""

    low: float
    high: float
    begin: float
    end: float
    powers: bool

    def at(self, values: ArrayLike) -> Array:
        """Return the places of numbers; what lies beyond the axis is put at its end."""
        x, ends = np.asarray(values), np.array([self.low, self.high])
        if self.powers:
            x, ends = np.log(np.maximum(x, self.low)), np.log(ends)
        return np.asarray(np.interp(x, ends, (self.begin, self.end)))

    @property
    def marks(self) -> list[tuple[str, float]]:
        """The numbers at the axis in words, each with its place."""
        places = np.round(self.at(np.array(self.ticks)), 1).tolist()
        return [(figure(value), place) for value, place in zip(self.ticks, places, strict=True)]

    @property
    def ticks(self) -> list[float]:
        """The numbers that are written at the axis."""
        if self.powers:
            powers = range(round(math.log10(self.low)), round(math.log10(self.high)) + 1)
            every = max(1, math.ceil(len(powers) / (TICKS + 3)))
            return [10.0**k for k in powers[::every]]
        rough = (self.high - self.low) / TICKS
        power = 10.0 ** math.floor(math.log10(rough))
        step = next(k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= rough)
        first = math.ceil(self.low / step - 1e-9)
        return [k * step for k in range(first, math.floor(self.high / step + 1e-9) + 1)]


def scale(values: Array, begin: float, end: float, powers: bool) -> Scale:
    """Return the axis of numbers: whole powers of ten, or from the lowest to the highest."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    if powers:
        low, high = (10.0 ** f(math.log10(value)) for f, value in ((math.floor, low), (math.ceil, high)))
    if high <= low:
        low, high = (low, low * 10.0) if powers else (low - 0.5, low + 0.5)
    return Scale(low, high, begin, end, powers)


def plot(title: str, labels: tuple[str, str], lines: Sequence[Line], powers: tuple[bool, bool] = (False, False)) -> str:
    """Return the picture of lines; raise ValueError for none."""
    if not lines:
        raise ValueError("no lines are given; expected one or more")
    x, y = (np.concatenate([getattr(line, name) for line in lines]) for name in "xy")
    across, up = scale(x, LEFT, WIDTH - RIGHT, powers[0]), scale(y, HEIGHT - BOTTOM, TOP, powers[1])
    curves, points, names = list[Any](), list[Any](), list[Any]()
    for k, (line, height) in enumerate(zip(lines, name_heights(lines, up), strict=True)):
        colour = f"#{COLOURS[k % len(COLOURS)].removeprefix('#')}"
        places = (across.at(line.x), up.at(line.y))
        if line.points:
            points += [(*place, 3, colour, "") for place in zip(*places, strict=True)]
        else:
            curves += [(part, colour) for part in BREAK.split(path(*places))]
        names.append((line.name, WIDTH - RIGHT + 8, height + 4, colour))
    return picture(title, labels, across, up, curves=curves, points=points, names=names)


def name_heights(lines: Sequence[Line], up: Scale) -> list[float]:
    """Return the heights in the picture at which the names of lines stand, at their ends but clear of each other."""
    heights: list[float] = []
    for line in lines:
        place = float(up.at(line.y[-1]))
        while any(abs(place - other) < APART for other in heights):
            place += APART / 2
        heights.append(place)
    return heights


def path(x: Array, y: Array) -> str:
    """Return a line through points; a level stretch goes by its ends."""
    height = np.round(y, 1)
    bends = np.ones(len(height), dtype=bool)
    bends[1:-1] = (height[1:-1] != height[:-2]) | (height[1:-1] != height[2:])
    flat = np.stack([x[bends], height[bends]], axis=1).ravel().tolist()
    return " ".join(["%.1f,%.1f"] * (len(flat) // 2)) % tuple(flat)


def picture(title: str, labels: tuple[str, str], across: Scale, up: Scale, **drawn: Any) -> str:
    """Return a picture of what is drawn between two axes; no numbers stand at an axis without a name."""
    given = {"title": title, "labels": labels, "across": across, "up": up}
    given |= {"width": WIDTH, "height": HEIGHT, "curves": ()}
    return render("reports/picture.svg", **given | drawn)


def figure(value: float) -> str:
    """Return a number as it is written at an axis."""
    return f"{value:.4g}" if value == 0.0 or 1e-3 <= abs(value) < 1e5 else f"{value:.0e}"


def front_picture(
    title: str, labels: tuple[str, str], names: Sequence[str], values: Array, links: Sequence[str] = ()
) -> str:
    """Return the picture of designs with room beside the outermost; each leads to the link given for it.

    ``values`` are their two objectives, a row each. Beside a design stands its name, or its number where that fits not.
    """
    margins = MARGIN * np.ptp(values, axis=1, keepdims=True)
    x, y = np.hstack([values - margins, values + margins])
    across = scale(x, LEFT, WIDTH - ROOM, powers=False)
    up = scale(y, HEIGHT - BOTTOM, TOP, powers=False)
    places = np.array([across.at(values[0]), up.at(values[1])]).T.tolist()
    taken = [(px - RADIUS, py - RADIUS, px + RADIUS, py + RADIUS) for px, py in places]
    written = []
    for number, (name, (px, py)) in enumerate(zip(names, places, strict=True), 1):
        for words, box in ((text, box) for text in (name, str(number)) for box in around(px, py, text)):
            if all(box[k + 2] < other[k] or other[k + 2] < box[k] for other in taken for k in (0, 1)):
                taken.append(box)
                written.append((words, box[0], box[3] - 3.0, INK))
                break
    leads = links or [""] * len(places)  # a picture by itself may have no links in it
    circles = [(*place, RADIUS, POINT, link) for place, link in zip(places, leads, strict=True)]
    return picture(title, labels, across, up, points=circles, names=written)


def around(x: float, y: float, words: str) -> list[Box]:
    """Return the places beside a point at which words are within the picture: right and left, above and below."""
    width, near = LETTER * len(words), 2.0
    return [
        (left, top, left + width, top + LINE)
        for top in (y - LINE / 2, y - LINE - near, y + near)
        for left in (x + GAP, x - GAP - width)
        if left > LEFT and left + width < WIDTH and TOP < top < HEIGHT - BOTTOM - LINE
    ]
