"""Charts as far as they are read, of a file or of a fresh build: what each draws, between which limits, how called."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.matching import Match
from workbook.judging.shown import taste
from workbook.judging.shown.colours import WHITE, contrast, parsed
from workbook.reading.package import tag


class Line(NamedTuple):
    """One line of a chart: its columns, the lengths of its strokes, and its name, a text or the cell that has it.

    ``seen`` is whether it, or signs at its points, are drawn; ``smooth`` whether it is bent between them.
    """

    x: Area | None
    y: Area | None
    strokes: Area | None
    name: Area | str
    seen: bool
    smooth: bool

    def __str__(self) -> str:
        """Return what it draws."""
        return " against ".join("nothing that can be read" if a is None else f"{a.sheet}!{a.a1}" for a in self[1::-1])


class Axis(NamedTuple):
    """An axis: its title, limits and scale, and how its numbers are shown."""

    title: Area | str = ""
    ends: Mapping[str, float] = MappingProxyType({})
    backwards: bool = False
    log: bool = False
    code: str = "General"
    scaled: bool = False
    gone: bool = True


class Drawn(NamedTuple):
    """A chart: ``kinds`` are its plots, ``axes`` the two of the first, ``odd`` what no fresh build has."""

    title: Area | str
    kinds: tuple[str, ...]
    lines: list[Line]
    axes: tuple[Axis, Axis]
    other_axes: list[Axis]
    visible_only: bool
    odd: list[str]
    at: Address
    number: int = 0


def drawn(match: Match, title: str) -> Iterator[Drawn]:
    """Yield the charts of a sheet of the file."""
    inspected = match.file.inspected
    for number, anchor in enumerate(inspected.drawings.get(title, ()) if inspected else ()):
        if anchor.chart is not None:
            at = Address(title, anchor.first.row + 1, anchor.first.column + 1)
            yield Reader(at, match.file.contents.area).chart(anchor.chart, number)


class Reader:
    """What reads a chart at a cell; ``named`` resolves the names of sheets in its references."""

    def __init__(self, at: Address, named: Callable[[str, str], Area]) -> None:
        self._at, self._named = at, named

    def chart(self, root: Element, number: int = 0) -> Drawn:
        """Return a chart."""
        shown = child(root, "chart")
        plot = child(shown, "plotArea")
        groups = [one for one in plot if tag(one).endswith("Chart")] if plot is not None else []
        axes = {value(one, "axId"): self._axis(one) for one in plot or () if tag(one).endswith("Ax")}
        ids = [str(one.get("val")) for one in groups[0] if tag(one) == "axId"][:2] if groups else []
        first, second = (*(axes.get(name, Axis()) for name in ids), Axis(), Axis())[:2]
        odd = sorted({tag(one) for one in root.iter()} - taste.CHART - {tag(group) for group in groups})
        if any(tag(one) == "dLbl" and child(one, "tx") is not None for one in root.iter()):
            odd.append("labels of their own")
        if any(tag(one) in ("defRPr", "rPr") and clear(one) for one in root.iter()):
            odd.append("texts that cannot be seen")
        return Drawn(
            self._text(child(shown, "title", "tx")), tuple(map(tag, groups)),
            [self._line(one) for group in groups for one in group if tag(one) == "ser"], (first, second),
            [one for name, one in axes.items() if name not in ids], value(shown, "plotVisOnly", "1") in taste.YES, odd,
            self._at, number,
        )  # fmt: skip

    def _axis(self, element: Element) -> Axis:
        scaling, form = child(element, "scaling"), child(element, "numFmt")
        return Axis(
            self._text(child(element, "title", "tx")),
            {end: float(value(scaling, end)) for end in ("min", "max") if value(scaling, end)},
            value(scaling, "orientation") == "maxMin", bool(value(scaling, "logBase")),
            form.get("formatCode", "General") if form is not None else "General",
            child(element, "dispUnits") is not None,
            value(element, "delete", "0") in taste.YES or value(element, "tickLblPos") == "none",
        )  # fmt: skip

    def _line(self, series: Element) -> Line:
        x, y = child(series, "xVal"), child(series, "yVal")
        return Line(
            self._area(source(x if x is not None else child(series, "cat"))),
            self._area(source(y if y is not None else child(series, "val"))),
            self._area(source(child(series, "errBars", "plus"))), self._text(child(series, "tx")),
            not clear(child(series, "spPr", "ln")) or value(child(series, "marker"), "symbol", "none") != "none",
            value(series, "smooth", "0") in taste.YES,
        )  # fmt: skip

    def _area(self, text: str) -> Area | None:
        """Return what a reference means; None for what is no range of this workbook."""
        try:
            found = reference(text, self._at.sheet, self._named) if "!" in text else None
        except FormulaError:
            return None
        return found._replace(single=found.size == 1) if found else None

    def _text(self, label: Element | None) -> Area | str:
        """Return a text, or the cell that has it; LibreOffice quotes a text as if it were a reference."""
        text = source(label)
        if text.startswith('"'):
            return text.strip('"').replace('""', '"')
        own = "".join(one.text or "" for one in label.iter() if tag(one) in ("t", "v")) if label is not None else ""
        return (self._area(text) or text) if text else own


def child(element: Element | None, *path: str) -> Element | None:
    """Return the element that a path of names leads to."""
    for name in path:
        element = next((one for one in element if tag(one) == name), None) if element is not None else None
    return element


def value(element: Element | None, name: str, otherwise: str = "") -> str:
    """Return the attribute ``val`` of a child."""
    found = child(element, name)
    return otherwise if found is None else str(found.get("val", "1"))


def source(data: Element | None) -> str:
    """Return the reference from which a chart takes its figures, or a text."""
    numbers = child(data, "numRef", "f")
    found = numbers if numbers is not None else child(data, "strRef", "f")
    return (found.text or "") if found is not None else ""


def clear(paint: Element | None) -> bool:
    """Whether a line or a text is painted with nothing, or in a colour that cannot be seen on white."""
    colour, themed = (child(paint, "solidFill", name) for name in ("srgbClr", "schemeClr"))
    if themed is not None:
        return themed.get("val") in ("bg1", "lt1") and not len(themed)
    ink = parsed(colour.get("val", "")) if colour is not None else None
    faint = colour is not None and int(value(colour, "alpha") or 100_000) < 10_000
    return child(paint, "noFill") is not None or faint or (ink is not None and contrast(ink, WHITE) < taste.UNSEEN)


def word(name: Any) -> str:
    """Return a name, or the cell that has it."""
    return name if isinstance(name, str) else f"the text of {name.sheet}!{name.a1}"
