"""Charts: whether each declared one still draws its columns, between its limits, under its names."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet
from workbook.book.formula import Area, FormulaError, area_of, reference
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, Report
from workbook.judging.shown import units
from workbook.judging.shown.formats import plain, problem
from workbook.judging.shown.words import sheet_of

UNIT = re.compile(r"\[([^\]]*)\]")
COLUMN = re.compile(r"\[(\w+)\.(\w+)\]")


class Line(NamedTuple):
    """One line of a chart: its columns, the lengths of its strokes, and its name, a text or the cell that has it.

    ``seen`` is whether it, or signs at its points, are drawn.
    """

    x: Area | None
    y: Area | None
    strokes: Area | None
    name: Area | str
    seen: bool = True


class Drawn(NamedTuple):
    """A chart of the file as far as it can be read."""

    title: Area | str
    lines: list[Line]
    axes: tuple[Any, Any]
    titles: tuple[Area | str, Area | str]
    at: Address


def charts(match: Match, report: Report) -> None:
    """Enter declared charts that draw something else, and as notices those that are gone or are called otherwise."""
    for sheet in match.declared.sheets:
        title = sheet_of(match, sheet)
        if title is None or not sheet.charts:
            continue
        held = list(drawn(match, title))
        for chart, found in paired(match, sheet, held):
            if found is None:
                report.say(Address(title, 1, 1), NOTICE, None, chart.title, "a chart")
            else:
                Judge(match, sheet, chart, found, report).judge()


def paired(match: Match, sheet: Sheet, held: list[Drawn]) -> Iterator[tuple[Chart, Drawn | None]]:
    """Yield each declared chart of a sheet with the one of the file that is most like it, if any is."""
    declared = [chart for chart, *_ in sheet.charts]
    left = list(range(len(held)))
    likeness = {(i, k): like(match, chart, held[k]) for i, chart in enumerate(declared) for k in left}
    found: dict[int, int] = {}
    for (i, k), size in sorted(likeness.items(), key=lambda entry: -entry[1]):
        if size > 0 and i not in found and k in left:
            found[i] = k
            left.remove(k)
    for i, chart in enumerate(declared):
        yield chart, held[found[i]] if i in found else None


def like(match: Match, chart: Chart, found: Drawn) -> float:
    """Return how like a declared chart one of the file is: by what it draws, and by its title."""
    columns = {line[:2] for line in found.lines}
    same = sum(expected(match, series)[:2] in columns for series in chart.series)
    return 2 * same / max(len(chart.series), len(found.lines), 1) + (found.title == chart.title)


def expected(match: Match, series: Series) -> Line:
    """Return a declared line with its columns as the file has them."""
    name: Area | str = series.name
    if series.name.startswith("="):
        name = scalar(match, series.name[1:]) or series.name
    strokes = series.up or series.right
    return Line(column(match, series.x), column(match, series.y), column(match, strokes) if strokes else None, name)


def column(match: Match, text: str) -> Area | None:
    """Return where the file has a declared column, ``[table.column]``."""
    table, name = text.strip("[]").split(".")
    place = match.file.places.get(table)
    if place is None:
        return None
    block = match.declared.blocks[table]
    j = block.columns[name] - block.column
    return area_of(place.part(j)) if place.part(j).column else None


def scalar(match: Match, name: str) -> Area | None:
    """Return where the file has the cell of a name."""
    place = match.file.places.get(name)
    return None if place is None else area_of(place)


class Judge:
    """A declared chart held against that of the file."""

    def __init__(self, match: Match, sheet: Sheet, chart: Chart, found: Drawn, report: Report) -> None:
        self.match, self.sheet, self.chart, self.found, self.report = match, sheet, chart, found, report
        self.what = f"the chart {chart.title!r}"

    def judge(self) -> None:
        """Enter what is wrong with it."""
        self.lines()
        self.title()
        limits = (self.chart.x_range, self.chart.y_range)
        for n, (axis, limit) in enumerate(zip(self.found.axes, limits, strict=True)):
            self.axis("xy"[n], axis, limit, self.chart.log_y if n else False, self.chart.lanes if n else False)
            self.axis_title("xy"[n], self.found.titles[n], (self.chart.x, self.chart.y)[n])

    def say(self, kind: str, found: Any, expected: Any, what: str) -> None:
        """Enter a finding or a notice at the chart's corner."""
        self.report.say(self.found.at, kind, found, expected, f"{self.what}, {what}")

    def lines(self) -> None:
        """Compare what is drawn, and under which name."""
        ours = [expected(self.match, series) for series in self.chart.series]
        if any(line.x is None or line.y is None for line in ours):
            return
        free = list(self.found.lines)
        missing = []
        for line, series in zip(ours, self.chart.series, strict=True):
            same = next((held for held in free if held[:3] == line[:3]), None)
            if same is None:
                missing.append((line, series))
            else:
                free.remove(same)
                self.name(same, line, ours)
                if line.strokes is None and not same.seen:
                    self.say(NOTICE, "not drawn", "drawn", f"its line {series.name!r}")
        self.elsewhere(missing, free)
        for held in free:
            if held.name and held.name in [line.name for line in ours]:
                self.say("shown", said(held), "a name of its own", f"another line called {word(held.name)!r}")

    def elsewhere(self, missing: list[tuple[Line, Series]], free: list[Line]) -> None:
        """Tell the lines that point elsewhere from those that are gone."""
        for line, series in missing:
            named = next((held for held in free if held.name == line.name), free[0] if free else None)
            if named is None:
                self.say(NOTICE, None, said(line), f"its line {series.name!r}")
            else:
                free.remove(named)
                self.say("shown", said(named), said(line), f"its line {series.name!r}")

    def name(self, held: Line, line: Line, ours: list[Line]) -> None:
        """Compare the name of a line: another's misleads, other words do not."""
        if held.name == line.name or (len(ours) == 1 and not held.name):
            return
        others = [other.name for other in ours if other is not line]
        self.say("shown" if held.name in others else NOTICE, word(held.name), word(line.name), "the name of a line")

    def title(self) -> None:
        """Compare the title."""
        found, chart = self.found.title, self.chart
        if found != chart.title:
            others = [other.title for other, *_ in self.sheet.charts if other is not chart]
            self.say("shown" if found in others else NOTICE, word(found), chart.title, "its title")

    def axis(self, name: str, axis: Any, limits: Any, log: bool, bare: bool) -> None:
        """Compare the limits and the scale of an axis."""
        if axis is None:
            return
        least, largest, _ = limits or (None, None, None)
        scaling = axis.scaling
        if scaling.orientation == "maxMin":
            self.say("shown", "from right to left, or downwards", "in the usual direction", f"its axis {name}")
        if bool(scaling.logBase) != log:
            self.say("shown", "logarithmic" if scaling.logBase else "linear", "linear" if scaling.logBase else
                     "logarithmic", f"its axis {name}")  # fmt: skip
        for end, held, ours in (("least", scaling.min, least), ("greatest", scaling.max, largest)):
            if held is None or (ours is not None and math.isclose(held, ours, rel_tol=1e-9, abs_tol=1e-12)):
                continue
            if ours is not None or self.cuts(name, end, held):
                self.say("shown", held, "left to the program" if ours is None else ours,
                         f"the {end} value on its axis {name}")  # fmt: skip
        self.labels(name, axis, bare)

    def labels(self, name: str, axis: Any, bare: bool) -> None:
        """Compare how the numbers along an axis are shown."""
        code = axis.numFmt.formatCode if axis.numFmt is not None else "General"
        wrong = "" if bare or plain(code) else problem(12.5, code, "General", "")
        if getattr(axis, "dispUnits", None) is not None:
            wrong = "shown in other units"
        if wrong:
            self.say("shown", wrong, "as they are", f"the numbers of its axis {name}")

    def cuts(self, name: str, end: str, limit: float) -> bool:
        """Whether a limit leaves out some of what the chart should show."""
        values = [v for series in self.chart.series for v in figures(self.match.declared, getattr(series, name))]
        if not values:
            return False
        span = max(values) - min(values)
        return limit > min(values) + 1e-6 * span if end == "least" else limit < max(values) - 1e-6 * span

    def axis_title(self, name: str, found: Area | str, declared: str) -> None:
        """Compare the title of an axis: another unit misleads, and so does the title of the other axis.

        A title that follows a cell becomes that cell's text where LibreOffice saves it.
        """
        linked = declared.startswith("=")
        text = str(self.match.declared.blocks[declared[1:]].quantities[0].value) if linked else declared
        if found == text or (linked and found == scalar(self.match, declared[1:])):
            return
        other = self.chart.y if name == "x" else self.chart.x
        misleads = isinstance(found, str) and (found == other or (not linked and unit_differs(found, text)))
        self.say("shown" if misleads else NOTICE, word(found), text, f"the title of its axis {name}")


def unit_differs(found: str, ours: str) -> bool:
    """Whether two titles name different units."""
    one, two = UNIT.search(found), UNIT.search(ours)
    return one is not None and two is not None and units.compared(one[1], two[1]) == "other"


def figures(book: Book, text: str) -> list[float]:
    """Return the finite numbers of a declared column."""
    found = COLUMN.fullmatch(text)
    block = book.blocks[found[1]] if found else None
    values = next((q.value for q in block.quantities if q.name == found[2]), ()) if block and found else ()
    listed = values if hasattr(values, "__len__") and not isinstance(values, str) else [values]
    return [float(v) for v in listed if isinstance(v, int | float) and math.isfinite(v)]


def drawn(match: Match, title: str) -> Iterator[Drawn]:
    """Yield the charts of a sheet of the file that have lines."""
    for chart in getattr(match.file.workbook[title], "_charts"):  # noqa: B009 - the stubs hide it
        start = getattr(chart.anchor, "_from", None)
        at = Address(title, start.row + 1, start.col + 1) if start is not None else Address(title, 1, 1)
        axes = (getattr(chart, "x_axis", None), getattr(chart, "y_axis", None))
        names = tuple(named(match, title, axis.title) if axis is not None else "" for axis in axes)
        lines = [line(match, title, series) for series in chart.series]
        yield Drawn(named(match, title, chart.title), lines, axes, (names[0], names[1]), at)


def line(match: Match, title: str, series: Any) -> Line:
    """Return a line of a chart of the file."""
    bars = series.errBars
    lengths = source(bars.plus) if bars is not None and bars.plus is not None else ""
    columns = (source(getattr(series, "xVal", None) or series.cat), source(getattr(series, "yVal", None) or series.val))
    x, y = (area(match, title, text) for text in columns)
    strokes = area(match, title, lengths) if lengths else None
    return Line(x, y, strokes, name_of(match, title, series.tx), seen(series))


def seen(series: Any) -> bool:
    """Whether a line, or signs at its points, are drawn."""
    look, marker = series.graphicalProperties, getattr(series, "marker", None)
    bare = look is not None and look.line is not None and bool(look.line.noFill)
    return not bare or (marker is not None and marker.symbol not in (None, "none"))


def source(data: Any) -> str:
    """Return the reference from which a chart takes its figures."""
    found = data is not None and (getattr(data, "numRef", None) or getattr(data, "strRef", None))
    return str(found.f) if found else ""


def area(match: Match, title: str, text: str) -> Area | None:
    """Return what a reference of a chart means; None for what is no range of this workbook."""
    try:
        found = reference(text, title, match.file.contents.area) if "!" in text else None
    except FormulaError:
        return None
    return found._replace(single=found.size == 1) if found else None


def name_of(match: Match, title: str, label: Any) -> Area | str:
    """Return the name of a line, or the cell that has it; LibreOffice quotes a text as if it were a reference."""
    if label is None:
        return ""
    if label.strRef is None:
        return str(label.v or "")
    text = str(label.strRef.f)
    if text.startswith('"'):
        return text.strip('"').replace('""', '"')
    return area(match, title, text) or text


def named(match: Match, title: str, found: Any) -> Area | str:
    """Return a title of a chart or an axis, or the cell that has it."""
    text = getattr(found, "tx", None)
    if text is None:
        return ""
    if text.strRef is not None:
        return area(match, title, str(text.strRef.f)) or str(text.strRef.f)
    paragraphs = text.rich.p if text.rich is not None else []
    return "".join(run.t or "" for paragraph in paragraphs for run in paragraph.r or [])


def said(line: Line) -> str:
    """Return what a line draws."""
    return " against ".join("nothing that can be read" if a is None else f"{a.sheet}!{a.a1}" for a in (line.y, line.x))


def word(name: Area | str) -> str:
    """Return a name, or the cell that has it."""
    return name if isinstance(name, str) else f"the text of {name.sheet}!{name.a1}"
