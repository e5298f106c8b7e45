"""The charts of a file as far as they are read: what each draws, between which limits, under which names."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.matching import Match
from workbook.judging.shown.colours import UNSEEN, WHITE, contrast, parsed
from workbook.reading.package import tag

PLAIN = frozenset([
    "alpha", "auto", "autoTitleDeleted", "axId", "axPos", "backward", "baseTimeUnit", "bodyPr", "bubble3D",
    "c14:style", "category", "chart", "chartSpace", "c", "crossAx", "crossBetween", "crosses", "crossesAt", "dLbl",
    "dLblPos", "dLbls", "date1904", "dPt", "defRPr", "delete", "dispBlanksAs", "dispEq", "dispRSqr", "effectLst",
    "endParaRPr", "errBarType", "errBars", "errDir", "errValType", "ext", "extLst", "f", "formatCode", "formatting",
    "forward", "grouping", "h", "hMode", "headerFooter", "idx", "invertIfNegative", "lang", "layout",
    "layoutTarget", "legend", "legendPos", "ln", "lstStyle", "lvl", "majorGridlines", "majorTickMark", "majorUnit",
    "manualLayout", "marker", "max", "min", "minorGridlines", "minorTickMark", "minorUnit", "noEndCap", "noFill",
    "noMultiLvlLbl", "numCache", "numFmt", "numRef", "order", "orientation", "overlay", "p", "pPr", "pageMargins",
    "pageSetup", "plotArea", "plotVisOnly", "plus", "printSettings", "protection", "prstDash", "pt", "ptCount", "r",
    "rPr", "rich", "round", "roundedCorners", "scaling", "scatterChart", "scatterStyle", "schemeClr", "selection",
    "separator", "ser", "showBubbleSize", "showCatName", "showDLblsOverMax", "showLeaderLines", "showLegendKey",
    "showPercent", "showSerName", "showVal", "size", "smooth", "solidFill", "spPr", "srgbClr", "strCache", "strRef",
    "style", "sysClr", "symbol", "t", "tickLblPos", "title", "tx", "txPr", "uniqueId", "v", "valAx", "varyColors",
    "w", "wMode", "x", "xMode", "xVal", "y", "yMode", "yVal", "latin", "ea", "cs", "cap", "miter", "bevel",
    "headEnd", "tailEnd", "logBase", "lumMod", "lumOff", "clrMapOvr", "AlternateContent", "Choice", "Fallback",
    "shade", "tint", "avLst", "prstGeom", "xfrm", "gapWidth", "legendEntry15", "layoutTarget",
])  # fmt: skip
"""the elements by which programs write an XY chart; what is none of them is told"""
GROUNDS = ("bg1", "lt1")
"""the theme's colours of a page"""


class Line(NamedTuple):
    """One line of a chart: its columns, the lengths of its strokes, and its name, a text or the cell that has it.

    ``seen`` is whether it, or signs at its points, are drawn; ``smooth`` whether it is bent between them.
    """

    x: Area | None
    y: Area | None
    strokes: Area | None
    name: Area | str
    seen: bool = True
    smooth: bool = False


class Axis(NamedTuple):
    """An axis: its title, limits and scale, and how its numbers are shown."""

    title: Area | str
    ends: dict[str, float]
    backwards: bool
    log: bool
    code: str
    scaled: bool
    gone: bool


class Drawn(NamedTuple):
    """A chart of the file: ``kinds`` are its plots, ``axes`` the two of the first, ``odd`` what a fresh one has not."""

    title: Area | str
    kinds: tuple[str, ...]
    lines: list[Line]
    axes: tuple[Axis | None, Axis | None]
    other_axes: list[Axis]
    visible_only: bool
    odd: tuple[str, ...]
    at: Address
    number: int


def drawn(match: Match, title: str) -> Iterator[Drawn]:
    """Yield the charts of a sheet of the file."""
    inspected = match.file.inspected
    for number, anchor in enumerate(inspected.drawings.get(title, ()) if inspected else ()):
        if anchor.chart is None:
            continue
        first = anchor.first
        yield chart(match, Address(title, first.row + 1, first.column + 1), anchor.chart, number)


def chart(match: Match, at: Address, root: Element, number: int) -> Drawn:
    """Return a chart that lies at a cell."""
    shown = child(root, "chart")
    plot = child(shown, "plotArea")
    groups = [one for one in plot if tag(one).endswith("Chart")] if plot is not None else []
    axes = {value(one, "axId"): axis(match, at.sheet, one) for one in plot or () if tag(one).endswith("Ax")}
    ids = [str(one.get("val")) for one in groups[0] if tag(one) == "axId"] if groups else []
    first, second = ((*(axes.get(name) for name in ids[:2]), None, None))[:2]
    lines = [line(match, at.sheet, one) for group in groups for one in group if tag(one) == "ser"]
    odd = sorted({tag(one) for one in root.iter()} - PLAIN - {tag(group) for group in groups})
    texts = [one for one in root.iter() if tag(one) == "dLbl" and child(one, "tx") is not None]
    faint = [one for one in root.iter() if tag(one) in ("defRPr", "rPr") and clear(one)]
    others = [one for name, one in axes.items() if name not in ids[:2]]
    return Drawn(
        named(match, at.sheet, child(shown, "title")), tuple(tag(group) for group in groups), lines, (first, second),
        others, value(shown, "plotVisOnly", "1") not in ("0", "false"),
        (*odd, *(["labels of their own"] if texts else []), *(["texts that cannot be seen"] if faint else [])),
        at, number,
    )  # fmt: skip


def child(element: Element | None, *path: str) -> Element | None:
    """Return the element that a path of names leads to."""
    for name in path:
        element = next((one for one in element if tag(one) == name), None) if element is not None else None
    return element


def value(element: Element | None, name: str, otherwise: str = "") -> str:
    """Return the attribute ``val`` of a child."""
    found = child(element, name)
    return otherwise if found is None else str(found.get("val", "1"))


def axis(match: Match, title: str, element: Element) -> Axis:
    """Return an axis."""
    scaling, form = child(element, "scaling"), child(element, "numFmt")
    ends = {end: float(value(scaling, end)) for end in ("min", "max") if value(scaling, end)}
    return Axis(
        named(match, title, child(element, "title")), ends, value(scaling, "orientation") == "maxMin",
        bool(value(scaling, "logBase")), form.get("formatCode", "General") if form is not None else "General",
        child(element, "dispUnits") is not None,
        value(element, "delete", "0") in ("1", "true") or value(element, "tickLblPos") == "none",
    )  # fmt: skip


def line(match: Match, title: str, series: Element) -> Line:
    """Return a line."""
    x, y = (first(series, *names) for names in (("xVal", "cat"), ("yVal", "val")))
    strokes = source(child(series, "errBars", "plus"))
    return Line(
        area(match, title, source(x)), area(match, title, source(y)),
        area(match, title, strokes) if strokes else None, name_of(match, title, child(series, "tx")), seen(series),
        value(series, "smooth", "0") in ("1", "true"),
    )  # fmt: skip


def first(element: Element, *names: str) -> Element | None:
    """Return the first child of one of some names."""
    return next((one for name in names if (one := child(element, name)) is not None), None)


def seen(series: Element) -> bool:
    """Whether a line, or signs at its points, are drawn so that they can be seen on white."""
    return not clear(child(series, "spPr", "ln")) or value(child(series, "marker"), "symbol", "none") != "none"


def clear(paint: Element | None) -> bool:
    """Whether a line or a text is painted with nothing, or in a colour that cannot be seen on white."""
    colour, themed = (child(paint, "solidFill", name) for name in ("srgbClr", "schemeClr"))
    if themed is not None:
        return themed.get("val") in GROUNDS and not len(themed)
    ink = parsed(colour.get("val", "")) if colour is not None else None
    faint = colour is not None and int(value(colour, "alpha") or 100_000) < 10_000
    return child(paint, "noFill") is not None or faint or (ink is not None and contrast(ink, WHITE) < UNSEEN)


def source(data: Element | None) -> str:
    """Return the reference from which a chart takes its figures."""
    found = first(data, "numRef", "strRef") if data is not None else None
    formula = child(found, "f")
    return formula.text or "" if formula is not None else ""


def area(match: Match, title: str, text: str) -> Area | None:
    """Return what a reference of a chart means; None for what is no range of this workbook."""
    try:
        found = reference(text, title, match.file.contents.area) if "!" in text else None
    except FormulaError:
        return None
    return found._replace(single=found.size == 1) if found else None


def name_of(match: Match, title: str, label: Element | None) -> Area | str:
    """Return the name of a line, or the cell that has it; LibreOffice quotes a text as if it were a reference."""
    text = source(label)
    if not text:
        plain = child(label, "v")
        return plain.text or "" if plain is not None else ""
    return text.strip('"').replace('""', '"') if text.startswith('"') else area(match, title, text) or text


def named(match: Match, title: str, found: Element | None) -> Area | str:
    """Return a title of a chart or an axis, or the cell that has it."""
    text = child(found, "tx")
    if linked := source(text):
        return area(match, title, linked) or linked
    return "".join(one.text or "" for one in text.iter() if tag(one) == "t") if text is not None else ""


def said(line: Line) -> str:
    """Return what a line draws."""
    return " against ".join("nothing that can be read" if a is None else f"{a.sheet}!{a.a1}" for a in (line.y, line.x))


def word(name: Any) -> str:
    """Return a name, or the cell that has it."""
    return name if isinstance(name, str) else f"the text of {name.sheet}!{name.a1}"
