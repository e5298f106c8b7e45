"""Charts of a file against those of a fresh build: what each draws, its axes, its texts, and whether it can be seen."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from workbook.book.address import Address
from workbook.book.declare import Sheet
from workbook.book.formula import Area, FormulaError, reference
from workbook.judging.display.groups import Differences
from workbook.judging.display.looks import LEAST_SIZE, SIGNS, UNSEEN, contrast, format_sections, plain_number
from workbook.judging.display.sight import SheetView
from workbook.judging.display.texts import TELLING, is_other_unit, split_unit
from workbook.judging.matching import Match
from workbook.reading.rows import tag
from workbook.writing.charts import draw
from workbook.writing.write import chart_size

YES = ("1", "true")
CM = 360_000  # EMU
SMALL = 0.4  # of the width or height of a fresh build, below which a chart can hardly be read
BEHIND = 0.5  # of a chart that another drawing may cover
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


def check_charts(match: Match, views: Mapping[str, SheetView], differences: Differences) -> None:
    """Enter declared charts that draw something else, cannot be seen, or are gone."""
    for sheet, title in match.sheets:
        pairs = list(pair_charts(match, sheet, list(read_charts(match, title))))
        for (chart, _, *place), expected, held in pairs:
            what = f"the chart {chart.title!r}"
            if held is not None:
                others = [other.title for _, other, _ in pairs if other is not expected]
                compare_charts(match, expected, held, others, what, differences)
                check_chart_sight(match, expected, held, chart_size(*place), views, what, differences)
            elif match.file.inspected:
                differences.add(Address(title, 1, 1), "chart", chart.title, "nothing", what, misleads=False)


def pair_charts(match: Match, sheet: Sheet, held: list[ChartData]) -> Iterator[tuple[Any, ChartData, ChartData | None]]:
    """Yield each declared chart of a sheet, as a fresh build has it, with the one of the file that is most like it."""
    reader = ChartReader(Address(sheet.title, 1, 1), match.declared_area)
    drawings: list[Any] = [draw(chart, match.declared, *chart_size(*place)) for chart, _, *place in sheet.charts]
    expected = [reader.chart(drawing._write()) for drawing in drawings]
    likeness = sorted(
        ((similarity(match, ours, theirs), -i, -k) for i, ours in enumerate(expected) for k, theirs in enumerate(held)),
        reverse=True,
    )
    taken: dict[int, int] = {}
    for alike, i, k in likeness:
        if alike > 0 and -i not in taken and -k not in taken.values():
            taken[-i] = -k
    for i, chart in enumerate(sheet.charts):
        yield chart, expected[i], held[taken[i]] if i in taken else None


def similarity(match: Match, fresh: ChartData, held: ChartData) -> float:
    """Return how like a chart of a fresh build one of the file is: by what it draws, and by its title."""
    same = sum(any(is_same_line(match, ours, theirs) for theirs in held.lines) for ours in fresh.lines)
    return 2 * same / max(len(fresh.lines), len(held.lines), 1) + (fresh.title == held.title)


def is_same_line(match: Match, fresh: Line, held: Line) -> bool:
    """Whether two lines draw the same columns."""
    return all(match.same(*areas) for areas in zip(fresh[:3], held[:3], strict=True))


def compare_charts(
    match: Match, fresh: ChartData, held: ChartData, others: list[Name], what: str, differences: Differences
) -> None:
    """Enter what of a chart is not as in a fresh build."""

    def enter(attribute: str, expected: object, found: object, misleads: bool) -> None:
        differences.add(held.at, attribute, expected, found, what, misleads)

    if fresh.kinds != held.kinds:
        misleads = set(fresh.kinds) != set(held.kinds) or not all(axis.is_shown for axis in held.other_axes)
        enter("kind", ", ".join(fresh.kinds), ", ".join(held.kinds), misleads)
    if fresh.additions != held.additions:
        enter("drawing", ", ".join(fresh.additions) or "none", ", ".join(held.additions) or "none", False)
    if not is_same_name(match, fresh.title, held.title):
        texts = name_text(fresh.title), name_text(held.title)
        more = set(TELLING.findall(texts[1])) - set(TELLING.findall(texts[0]))
        enter("title", *texts, held.title in others or bool(more))
    odd_formats = [code for code in held.label_formats if plain_number(format_sections(code)) != ("N",)]
    if odd_formats:
        enter("format of labels", "as built", ", ".join(odd_formats), True)
    compare_lines(match, fresh.lines, held.lines, enter)
    for n, (ours, theirs) in enumerate(zip(fresh.axes, held.axes, strict=True)):
        axis = "xy"[n]
        if not is_same_name(match, ours.title, theirs.title):
            texts = declared_text(match, ours.title), name_text(theirs.title)
            units = [split_unit(text)[1] if "[" in text else "" for text in texts]
            other = declared_text(match, fresh.axes[1 - n].title)
            misleads = texts[1] == other or (all(units) and is_other_unit(units[1], units[0]))
            enter(f"title of its axis {axis}", *texts, misleads)
        for name in Axis._fields[1:]:
            expected, found = getattr(ours, name), getattr(theirs, name)
            sections = [format_sections(code) for code in (expected, found)] if name == "number_format" else []
            if expected == found or (sections and sections[0][:3] == sections[1][:3]):
                continue
            bare = plain_number(sections[1]) == plain_number(sections[0]) if sections else name == "is_shown"
            is_free = name in ("least", "most") and not found  # the program then shows all points
            attribute = f"{name.replace('_', ' ')} of its axis {axis}"
            enter(attribute, expected or "none", found or "none", not (bare or is_free))


def compare_lines(match: Match, fresh: list[Line], held: list[Line], enter: Callable[..., None]) -> None:
    """Enter which lines draw something else, are gone, are called otherwise, or cannot be seen."""
    if any(match.lost(area) for line in fresh for area in line[:2]):
        return
    free, missing = list(held), []
    for line in fresh:
        if (same := next((other for other in free if is_same_line(match, line, other)), None)) is None:
            missing.append(line)
            continue
        free.remove(same)
        if not is_same_name(match, line.name, same.name) and (same.name or len(fresh) > 1):
            exchanged = any(is_same_name(match, other.name, same.name) for other in fresh if other is not line)
            enter("name of a line", name_text(line.name), name_text(same.name), exchanged)
        for words, ours, theirs in (
            (("drawn", "not drawn"), line.is_seen, same.is_seen),
            (("bent between its points", "straight"), line.is_bent, same.is_bent),
        ):
            if ours != theirs:
                enter(f"line {declared_text(match, line.name)!r}", words[not ours], words[not theirs], False)
    for line in missing:
        named = [other for other in free if other.name == line.name] or free
        if named:
            free.remove(named[0])
        enter(f"line {declared_text(match, line.name)!r}", line, named[0] if named else "nothing", bool(named))
    for line in free:
        called = bool(line.name) and any(is_same_name(match, other.name, line.name) for other in fresh)
        enter("another line", "none", line, called)


def check_chart_sight(
    match: Match,
    fresh: ChartData,
    held: ChartData,
    cm: tuple[float, float],
    views: Mapping[str, SheetView],
    what: str,
    differences: Differences,
) -> None:
    """Enter that a chart can hardly be seen: shrunk, behind another drawing, or by hidden rows; ``cm`` is its size."""
    areas = views[held.at.sheet].areas
    own = areas[held.number]
    ends = own.right - own.left, own.bottom - own.top
    rooms = [min(1.0, theirs / ours) for theirs, ours in zip(held.room, fresh.room, strict=True)]
    share = min(room * end / (whole * CM) for room, end, whole in zip(rooms, ends, cm, strict=True))
    if share < SMALL:
        differences.add(held.at, "size", "as built", f"{share:.0%} of it", what, share < SMALL / 3)
    above = [k for k in range(held.number + 1, len(areas)) if own.shared(areas[k]) > BEHIND]
    if above:
        titles = {chart.number: chart.title for chart in read_charts(match, held.at.sheet)}
        alike = any(titles.get(k, held.title) == held.title for k in above)
        differences.add(held.at, "sight", "in sight", "behind another drawing", what, alike)
    columns = [area for line in held.lines for area in line[:2] if area is not None and area.sheet in views]
    hidden = max((count_hidden_rows(views[area.sheet], area) for area in columns), default=0)
    if held.visible_only and hidden:
        differences.add(held.at, "rows that it draws", "all", f"without {hidden:,} hidden rows", what, True)


def count_hidden_rows(view: SheetView, area: Area) -> int:
    """Return how many rows of an area are hidden."""
    return sum(not view.rows[row] for row in range(area.top, area.bottom + 1))


def is_same_name(match: Match, fresh: Name, held: Name) -> bool:
    """Whether a name is that of a fresh build; one that follows a cell becomes its text where LibreOffice saves it."""
    if isinstance(held, str):
        return held == declared_text(match, fresh)
    return not isinstance(fresh, str) and match.same(fresh, held)


def declared_text(match: Match, name: Name) -> str:
    """Return a name of a fresh build; of one that follows a cell, the cell's text."""
    return name if isinstance(name, str) else str(match.declared_value(name.first))


def name_text(name: Name) -> str:
    """Return a name, or the cell that has it."""
    return name if isinstance(name, str) else f"the text of {name.sheet}!{name.a1}"


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
        groups = [part for part in plot if tag(part).endswith("Chart")] if plot is not None else []
        axes = {val_of(part, "axId"): self._axis(part) for part in plot or () if tag(part).endswith("Ax")}
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
