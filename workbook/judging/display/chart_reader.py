"""Read the charts of a file or of a fresh build: what each draws, its limits, its titles and names."""

from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import NamedTuple
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.display import permitted
from workbook.judging.display.formats import WHITE, Colour, contrast, parse_colour
from workbook.judging.matching import Match
from workbook.reading.rows import tag

Name = Area | str  # a text, or the cell that has it


class Line(NamedTuple):
    """One line of a chart: its columns, the lengths of its strokes, its name, and what is said of it."""

    x: Area | None
    y: Area | None
    strokes: Area | None
    name: Name
    said: frozenset[str]

    def __str__(self) -> str:
        """Return what it draws."""
        return " against ".join("nothing that can be read" if a is None else f"{a.sheet}!{a.a1}" for a in self[1::-1])


class Axis(NamedTuple):
    """An axis: its title, its limits, how its numbers are shown, and what is said of it."""

    title: Name = ""
    ends: Mapping[str, float] = MappingProxyType({})
    code: str = "General"
    said: frozenset[str] = frozenset({"not shown"})


class ChartData(NamedTuple):
    """What is read of a chart."""

    title: Name
    kinds: tuple[str, ...]  # of its plots
    lines: list[Line]
    axes: tuple[Axis, Axis]  # of the first plot
    other_axes: list[Axis]
    codes: list[str]  # the number formats of its labels
    room: tuple[float, float]  # the share of its width and height that its plot has
    visible_only: bool
    odd: list[str]  # what cannot be read in it
    at: Address
    number: int = 0


def read_charts(match: Match, title: str) -> Iterator[ChartData]:
    """Yield the charts of a sheet of the file."""
    inspected = match.file.inspected
    for number, anchor in enumerate(inspected.drawings.get(title, ()) if inspected else ()):
        if anchor.chart is not None:
            at = Address(title, anchor.first.row + 1, anchor.first.column + 1)
            yield ChartReader(at, match.file.contents.area).chart(anchor.chart, number)


class ChartReader:
    """Reads a chart at a cell; ``named`` resolves the names of sheets in its references."""

    def __init__(self, at: Address, named: Callable[[str, str], Area]) -> None:
        self._at, self._named = at, named

    def chart(self, root: Element, number: int = 0) -> ChartData:
        """Return a chart."""
        plot, everything = child(root, "chart", "plotArea"), list(root.iter())
        groups = [one for one in plot if tag(one).endswith("Chart")] if plot is not None else []
        axes = {val_of(one, "axId"): self._axis(one) for one in plot or () if tag(one).endswith("Ax")}
        ids = [str(one.get("val")) for one in groups[0] if tag(one) == "axId"][:2] if groups else []
        first, second = (*(axes.get(name, Axis()) for name in ids), Axis(), Axis())[:2]
        grounds = (paint_colour(child(plot, "spPr")), paint_colour(child(root, "spPr")))
        others = (child(root, "chart", name) for name in ("title", "legend"))
        over = max(share(one, "w", 0.0) * share(one, "h", 0.0) for one in others)
        odd = [said for said, there in (
            ("labels of their own", any(tag(one) == "dLbl" and child(one, "tx") is not None for one in everything)),
            ("points of their own", any(tag(one) == "dPt" and child(one, "spPr") is not None for one in everything)),
            ("texts that cannot be seen", any(tag(one) in ("defRPr", "rPr") and unreadable(one) for one in everything)),
            ("a ground of its own", any(one and contrast(one, WHITE) > permitted.FAINT for one in grounds)),
            ("a title or a legend over it", over > permitted.OVER),
            ("zeros where nothing is", val_of(root, "chart", "dispBlanksAs") == "zero"),
        ) if there]  # fmt: skip
        return ChartData(
            self._text(child(root, "chart", "title", "tx")), tuple(map(tag, groups)),
            [self._line(one) for group in groups for one in group if tag(one) == "ser"], (first, second),
            [one for name, one in axes.items() if name not in ids],
            [form.get("formatCode", "General") for one in everything if tag(one) in ("dLbls", "dLbl")
             for form in one if tag(form) == "numFmt" and form.get("sourceLinked") not in permitted.YES],
            (share(plot, "w", 1.0), share(plot, "h", 1.0)),
            val_of(root, "chart", "plotVisOnly", otherwise="1") in permitted.YES,
            [*sorted({*map(tag, everything)} - {*map(tag, groups)} - permitted.CHART), *odd], self._at, number,
        )  # fmt: skip

    def _axis(self, element: Element) -> Axis:
        scaling, form = child(element, "scaling"), child(element, "numFmt")
        hidden = val_of(element, "delete", otherwise="0") in permitted.YES or val_of(element, "tickLblPos") == "none"
        said = {"backwards": val_of(scaling, "orientation") == "maxMin", "log": bool(val_of(scaling, "logBase")),
                "scaled": child(element, "dispUnits") is not None, "not shown": hidden}  # fmt: skip
        return Axis(
            self._text(child(element, "title", "tx")),
            {end: float(val_of(scaling, end)) for end in ("min", "max") if val_of(scaling, end)},
            form.get("formatCode", "General") if form is not None else "General",
            frozenset(one for one, there in said.items() if there),
        )

    def _line(self, series: Element) -> Line:
        x, y = child(series, "xVal"), child(series, "yVal")
        unmarked = val_of(series, "marker", "symbol", otherwise="none") == "none"
        said = {"not drawn": unmarked and is_invisible(child(series, "spPr", "ln")),
                "bent between its points": val_of(series, "smooth", otherwise="0") in permitted.YES}  # fmt: skip
        return Line(
            self._area(reference_of(x if x is not None else child(series, "cat"))),
            self._area(reference_of(y if y is not None else child(series, "val"))),
            self._area(reference_of(child(series, "errBars", "plus"))),
            self._text(child(series, "tx")),
            frozenset(one for one, there in said.items() if there),
        )

    def _area(self, text: str) -> Area | None:
        """Return what a reference means; None for what is no range of this workbook."""
        try:
            found = reference(text, self._at.sheet, self._named) if "!" in text else None
        except FormulaError:
            return None
        return found._replace(single=found.size == 1) if found else None

    def _text(self, label: Element | None) -> Name:
        """Return a text, or the cell that has it; LibreOffice quotes a text as if it were a reference."""
        text = reference_of(label)
        if text.startswith('"'):
            return text.strip('"').replace('""', '"')
        own = "".join(one.text or "" for one in label.iter() if tag(one) in ("t", "v")) if label is not None else ""
        return (self._area(text) or text) if text else own


def child(element: Element | None, *path: str) -> Element | None:
    """Return the element that a path of names leads to."""
    for name in path:
        element = next((one for one in element if tag(one) == name), None) if element is not None else None
    return element


def val_of(element: Element | None, *path: str, otherwise: str = "") -> str:
    """Return the attribute ``val`` of the element that a path of names leads to."""
    found = child(element, *path)
    return otherwise if found is None else str(found.get("val", "1"))


def share(part: Element | None, end: str, otherwise: float) -> float:
    """Return which share of a chart's width or height one of its parts has by hand."""
    return float(val_of(part, "layout", "manualLayout", end) or otherwise)


def reference_of(data: Element | None) -> str:
    """Return the reference from which a chart takes its figures, or a text."""
    numbers = child(data, "numRef", "f")
    found = numbers if numbers is not None else child(data, "strRef", "f")
    return (found.text or "") if found is not None else ""


def paint_colour(paint: Element | None) -> Colour | None:
    """Return the colour with which a line, a text or a ground is painted, where its digits say it."""
    colour = child(paint, "solidFill", "srgbClr")
    return parse_colour(colour.get("val", "")) if colour is not None else None


def is_invisible(paint: Element | None) -> bool:
    """Whether a line or a text is painted with nothing, or in a colour that cannot be seen on white."""
    themed, colour = child(paint, "solidFill", "schemeClr"), paint_colour(paint)
    if themed is not None:
        return themed.get("val") in ("bg1", "lt1") and not len(themed)
    faint = int(val_of(paint, "solidFill", "srgbClr", "alpha") or 100_000) < 10_000
    unseen = colour is not None and contrast(colour, WHITE) < permitted.UNSEEN
    return child(paint, "noFill") is not None or faint or unseen


def unreadable(font: Element) -> bool:
    """Whether a text of a chart is painted with nothing, is tiny or struck out, or in a font of signs."""
    face, small = child(font, "latin"), 0 < float(font.get("sz") or 0) < 100 * permitted.LEAST_SIZE
    signs = face is not None and face.get("typeface", "").casefold().startswith(permitted.SIGNS)
    return is_invisible(font) or small or signs or font.get("strike", "noStrike") != "noStrike"


def name_text(name: Name) -> str:
    """Return a name, or the cell that has it."""
    return name if isinstance(name, str) else f"the text of {name.sheet}!{name.a1}"
