"""Charts of a file or of a fresh build: what each draws, its axes, its texts, and what may hide them."""

from collections.abc import Callable, Iterator
from typing import NamedTuple
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.display.looks import LEAST_SIZE, SIGNS, UNSEEN, contrast
from workbook.judging.matching import Match
from workbook.reading.rows import tag

YES = ("1", "true")
DRAWN = frozenset(  # the elements by which a chart draws more than its lines and axes
    ["trendline", "upDownBars", "dropLines", "hiLowLines", "dTable", "view3D", "pivotFmts", "userShapes"]
)

Name = Area | str  # a text, or the cell that has it


class Line(NamedTuple):
    """One line of a chart: its columns, the lengths of its strokes, its name, how it is drawn."""

    x: Area | None
    y: Area | None
    strokes: Area | None
    name: Name
    is_seen: bool
    is_bent: bool

    def __str__(self) -> str:
        """Return what it draws."""
        return " against ".join("nothing that can be read" if a is None else f"{a.sheet}!{a.a1}" for a in self[1::-1])


class Axis(NamedTuple):
    """An axis: its title, and how it shows numbers."""

    title: Name = ""
    least: str = ""
    most: str = ""
    number_format: str = "General"
    direction: str = "minMax"
    log_base: str = ""
    unit: str = ""
    is_shown: bool = False


class ChartData(NamedTuple):
    """What is read of a chart."""

    title: Name
    kinds: tuple[str, ...]  # of its plots
    lines: list[Line]
    axes: tuple[Axis, Axis]  # of the first plot
    other_axes: tuple[Axis, ...]
    label_formats: tuple[str, ...]
    additions: tuple[str, ...]  # what it draws besides, and texts or grounds that hide it
    visible_only: bool
    room: tuple[float, float]  # the share of its width and height that its plot has
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
        parts = [] if plot is None else list(plot)
        groups = [part for part in parts if tag(part).endswith("Chart")]
        axes = {val_of(part, "axId"): self._axis(part) for part in parts if tag(part).endswith("Ax")}
        ids = [str(part.get("val")) for part in groups[0] if tag(part) == "axId"][:2] if groups else []
        first, second = (*(axes.get(name, Axis()) for name in ids), Axis(), Axis())[:2]
        grounds = (paint_colour(child(plot, "spPr")), paint_colour(child(root, "spPr")))
        overlays = (child(root, "chart", name) for name in ("title", "legend"))
        additions = {tag(part) for part in everything} & DRAWN
        bars = sum(tag(part) == "errBars" for part in everything)
        for name, is_there in (
            (f"{bars} error bars", bars > 0),
            ("points of their own", any(tag(p) == "dPt" and child(p, "spPr") is not None for p in everything)),
            ("labels of their own", any(tag(p) == "dLbl" and child(p, "tx") is not None for p in everything)),
            ("texts that cannot be seen", any(tag(p) in ("defRPr", "rPr") and is_unreadable(p) for p in everything)),
            ("a dark ground", any(ground and contrast(ground, "FFFFFF") > 2.0 for ground in grounds)),
            ("a title or legend over it", any(share(p, "w", 0) * share(p, "h", 0) > 0.25 for p in overlays)),
            ("zeros where nothing is", val_of(root, "chart", "dispBlanksAs") == "zero"),
        ):
            additions |= {name} if is_there else set()
        return ChartData(
            self._text(child(root, "chart", "title", "tx")),
            tuple(map(tag, groups)),
            [self._line(part) for group in groups for part in group if tag(part) == "ser"],
            (first, second),
            tuple(axis for name, axis in axes.items() if name not in ids),
            tuple(
                form.get("formatCode", "General")
                for part in everything
                if tag(part) in ("dLbls", "dLbl")
                for form in part
                if tag(form) == "numFmt" and form.get("sourceLinked") not in YES
            ),
            tuple(sorted(additions)),
            val_of(root, "chart", "plotVisOnly", default="1") in YES,
            (share(plot, "w", 1.0), share(plot, "h", 1.0)),
            self._at,
            number,
        )

    def _axis(self, element: Element) -> Axis:
        scaling, form, unit = (child(element, name) for name in ("scaling", "numFmt", "dispUnits"))
        is_hidden = val_of(element, "delete", default="0") in YES or val_of(element, "tickLblPos") == "none"
        least, most = (f"{float(end):.9g}" if end else "" for end in (val_of(scaling, "min"), val_of(scaling, "max")))
        return Axis(
            self._text(child(element, "title", "tx")),
            least,
            most,
            form.get("formatCode", "General") if form is not None else "General",
            val_of(scaling, "orientation", default="minMax"),
            val_of(scaling, "logBase"),
            val_of(unit, "builtInUnit", default="own") if unit is not None else "",
            not is_hidden,
        )

    def _line(self, series: Element) -> Line:
        x, y = (child(series, name) for name in ("xVal", "yVal"))
        is_unmarked = val_of(series, "marker", "symbol", default="none") == "none"
        return Line(
            self._area(reference_of(x if x is not None else child(series, "cat"))),
            self._area(reference_of(y if y is not None else child(series, "val"))),
            self._area(reference_of(child(series, "errBars", "plus"))),
            self._text(child(series, "tx")),
            not (is_unmarked and is_invisible(child(series, "spPr", "ln"))),
            val_of(series, "smooth", default="0") in YES,
        )

    def _area(self, text: str) -> Area | None:
        """Return what a reference means; None for what is no range of this workbook."""
        try:
            area = reference(text, self._at.sheet, self._named) if "!" in text else None
        except FormulaError:
            return None
        return area._replace(single=area.size == 1) if area else None

    def _text(self, label: Element | None) -> Name:
        """Return a text, or the cell that has it; LibreOffice quotes a text as if it were a reference."""
        text = reference_of(label)
        if text.startswith('"'):
            return text.strip('"').replace('""', '"')
        own = "".join(part.text or "" for part in label.iter() if tag(part) in ("t", "v")) if label is not None else ""
        return (self._area(text) or text) if text else own


def child(element: Element | None, *path: str) -> Element | None:
    """Return the element that a path of names leads to."""
    for name in path:
        element = next((part for part in element if tag(part) == name), None) if element is not None else None
    return element


def val_of(element: Element | None, *path: str, default: str = "") -> str:
    """Return the attribute ``val`` of the element that a path of names leads to."""
    end = child(element, *path)
    return default if end is None else str(end.get("val", "1"))


def share(part: Element | None, end: str, default: float) -> float:
    """Return which share of a chart's width or height one of its parts has by hand."""
    return float(val_of(part, "layout", "manualLayout", end) or default)


def reference_of(data: Element | None) -> str:
    """Return the reference from which a chart takes its figures, or a text."""
    numbers = child(data, "numRef", "f")
    source = numbers if numbers is not None else child(data, "strRef", "f")
    return (source.text or "") if source is not None else ""


def paint_colour(paint: Element | None) -> str:
    """Return the colour with which a line, a text or a ground is painted, where its digits say it."""
    colour = child(paint, "solidFill", "srgbClr")
    return colour.get("val", "") if colour is not None else ""


def is_invisible(paint: Element | None) -> bool:
    """Whether a line or a text is painted with nothing, or in a colour that cannot be seen on white."""
    themed, colour = child(paint, "solidFill", "schemeClr"), paint_colour(paint)
    if themed is not None:
        return themed.get("val") in ("bg1", "lt1") and not len(themed)
    is_faint = int(val_of(paint, "solidFill", "srgbClr", "alpha") or 100_000) < 10_000
    return child(paint, "noFill") is not None or is_faint or bool(colour and contrast(colour, "FFFFFF") < UNSEEN)


def is_unreadable(font: Element) -> bool:
    """Whether a text of a chart is painted with nothing, is tiny or struck out, or in a font of signs."""
    face, is_small = child(font, "latin"), 0 < float(font.get("sz") or 0) < 100 * LEAST_SIZE
    in_signs = face is not None and face.get("typeface", "").casefold().startswith(SIGNS)
    return is_invisible(font) or is_small or in_signs or font.get("strike", "noStrike") != "noStrike"
