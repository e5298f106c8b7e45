"""Charts: whether each declared one still draws its columns, between its limits, under its names, and can be seen."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

from workbook.book.address import Address
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet
from workbook.book.formula import Area, area_of
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, SHOWN, Report
from workbook.judging.shown import units
from workbook.judging.shown.drawn import Axis, Drawn, Line, drawn, said, word
from workbook.judging.shown.formats import judged
from workbook.judging.shown.views import Views
from workbook.judging.shown.words import reworded, sheet_of
from workbook.writing.write import size

UNIT = re.compile(r"\[([^\]]*)\]")
COLUMN = re.compile(r"\[(\w+)\.(\w+)\]")
XY = "scatterChart"
LEAST, SMALL = 0.12, 0.4  # of the width or the height of a fresh build: hardly to be seen, small
BEHIND = 0.5  # of a chart that another drawing may cover
CM = 360_000  # EMU


def charts(match: Match, views: Views, report: Report) -> None:
    """Enter declared charts that draw something else, and as notices those that are gone or are called otherwise."""
    for sheet in match.declared.sheets:
        title = sheet_of(match, sheet)
        if title is None or not sheet.charts:
            continue
        for (chart, _, column, width, height), found in paired(match, sheet, list(drawn(match, title))):
            if found is not None:
                Judge(match, sheet, chart, found, report).judge(views, size(column, width, height))
            elif match.file.inspected:
                report.say(Address(title, 1, 1), NOTICE, None, chart.title, "a chart")


def paired(match: Match, sheet: Sheet, held: list[Drawn]) -> Iterator[tuple[Any, Drawn | None]]:
    """Yield each declared chart of a sheet with the one of the file that is most like it, if any is."""
    left = list(range(len(held)))
    likeness = {(i, k): like(match, one[0], held[k]) for i, one in enumerate(sheet.charts) for k in left}
    found: dict[int, int] = {}
    for (i, k), alike in sorted(likeness.items(), key=lambda entry: -entry[1]):
        if alike > 0 and i not in found and k in left:
            found[i] = k
            left.remove(k)
    for i, one in enumerate(sheet.charts):
        yield one, held[found[i]] if i in found else None


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

    def judge(self, views: Views, size: tuple[float, float]) -> None:
        """Enter what is wrong with it; ``size`` is that of a fresh build, in cm."""
        self.kind()
        self.lines()
        self.title()
        limits, titles = (self.chart.x_range, self.chart.y_range), (self.chart.x, self.chart.y)
        for n, axis in enumerate(self.found.axes):
            if (axis is None or axis.gone) and not (n and self.chart.lanes):
                self.say(NOTICE, "not shown", "shown", f"its axis {'xy'[n]}")
            if axis is not None:
                self.axis("xy"[n], axis, limits[n], bool(n and self.chart.log_y), bool(n and self.chart.lanes))
                self.axis_title("xy"[n], axis.title, titles[n])
        self.place(views, size)

    def say(self, kind: str, found: Any, expected: Any, what: str) -> None:
        """Enter a finding or a notice at the chart's corner."""
        self.report.say(self.found.at, kind, found, expected, f"{self.what}, {what}" if what else self.what)

    def kind(self) -> None:
        """Compare the kind of chart, and tell what no XY chart of a fresh build has."""
        others = set(self.found.kinds) - {XY}
        if others:
            self.say(SHOWN, ", ".join(sorted(others)), XY, "its kind")
        if len(self.found.kinds) > 1 or self.found.other_axes:
            gone = any(axis.gone for axis in self.found.other_axes)
            self.say(SHOWN if gone else NOTICE, "other axes", "one pair of axes", "")
        if self.found.odd:
            self.say(NOTICE, ", ".join(self.found.odd), "as built", "what it shows besides")

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
                if same.smooth:
                    self.say(NOTICE, "bent between its points", "straight", f"its line {series.name!r}")
        self.elsewhere(missing, free)
        for held in free:
            if held.name and held.name in [line.name for line in ours]:
                self.say(SHOWN, said(held), "a name of its own", f"another line called {word(held.name)!r}")

    def elsewhere(self, missing: list[tuple[Line, Series]], free: list[Line]) -> None:
        """Tell the lines that point elsewhere from those that are gone."""
        for line, series in missing:
            named = next((held for held in free if held.name == line.name), free[0] if free else None)
            if named is None:
                self.say(NOTICE, None, said(line), f"its line {series.name!r}")
            else:
                free.remove(named)
                self.say(SHOWN, said(named), said(line), f"its line {series.name!r}")

    def name(self, held: Line, line: Line, ours: list[Line]) -> None:
        """Compare the name of a line: another's misleads, other words do not."""
        if held.name == line.name or (len(ours) == 1 and not held.name):
            return
        others = [other.name for other in ours if other is not line]
        self.say(SHOWN if held.name in others else NOTICE, word(held.name), word(line.name), "the name of a line")

    def title(self) -> None:
        """Compare the title."""
        found, chart = self.found.title, self.chart
        if found != chart.title:
            others = [other.title for other, *_ in self.sheet.charts if other is not chart]
            kind = reworded(found, chart.title, others) if isinstance(found, str) else NOTICE
            self.say(kind, word(found), chart.title, "its title")

    def axis(self, name: str, axis: Axis, limits: Any, log: bool, bare: bool) -> None:
        """Compare the limits and the scale of an axis, and how the numbers along it are shown."""
        least, largest, _ = limits or (None, None, None)
        if axis.backwards:
            self.say(SHOWN, "from right to left, or downwards", "in the usual direction", f"its axis {name}")
        if axis.log != log:
            scales = ("logarithmic", "linear") if axis.log else ("linear", "logarithmic")
            self.say(SHOWN, *scales, f"its axis {name}")
        for end, ours in (("min", least), ("max", largest)):
            held = axis.ends.get(end)
            if held is None or (ours is not None and math.isclose(held, ours, rel_tol=1e-9, abs_tol=1e-12)):
                continue
            if ours is not None or self.cuts(name, end, held):
                self.say(SHOWN, held, "left to the program" if ours is None else ours, f"the {end} of its axis {name}")
        kind, wrong = judged(axis.code, ";;;" if bare else "General") if not axis.scaled else (SHOWN, "in other units")
        if kind and not (bare and not axis.scaled and axis.code == "General"):
            self.say(kind, wrong, "as they are", f"the numbers of its axis {name}")

    def cuts(self, name: str, end: str, limit: float) -> bool:
        """Whether a limit leaves out some of what the chart should show."""
        values = [v for series in self.chart.series for v in figures(self.match.declared, getattr(series, name))]
        if not values:
            return False
        span = max(values) - min(values)
        return limit > min(values) + 1e-6 * span if end == "min" else limit < max(values) - 1e-6 * span

    def axis_title(self, name: str, found: Area | str, declared: str) -> None:
        """Compare the title of an axis: another unit misleads, and so does the title of the other axis.

        A title that follows a cell becomes that cell's text where LibreOffice saves it.
        """
        linked = declared.startswith("=")
        text = str(self.match.declared.blocks[declared[1:]].quantities[0].value) if linked else declared
        if found == text or (linked and found == scalar(self.match, declared[1:])):
            return
        other = self.chart.y if name == "x" else self.chart.x
        misleads = isinstance(found, str) and (found == other or unit_differs(found, text))
        self.say(SHOWN if misleads else NOTICE, word(found), text, f"the title of its axis {name}")

    def place(self, views: Views, size: tuple[float, float]) -> None:
        """Enter a chart that can hardly be seen: hidden, shrunk, behind another drawing, or by hidden rows."""
        areas = views.layouts[self.found.at.sheet].areas
        own = areas[self.found.number]
        share = min((own.right - own.left) / (size[0] * CM), (own.bottom - own.top) / (size[1] * CM))
        if share < SMALL:
            self.say(SHOWN if share < LEAST else NOTICE, f"{share:.0%} of its size", "as built", "its size")
        above = [k for k in range(self.found.number + 1, len(areas)) if own.shared(areas[k]) > BEHIND]
        if above:
            others = {k: one for one in drawn(self.match, self.found.at.sheet) for k in [one.number]}
            alike = any(k not in others or others[k].title == self.found.title for k in above)
            self.say(SHOWN if alike else NOTICE, "behind another drawing", "in sight", "")
        columns = [
            a for line in self.found.lines for a in (line.x, line.y) if a is not None and a.sheet in views.hidden
        ]
        hidden = max((views.hidden[a.sheet].rows(a.top, a.bottom) for a in columns), default=0)
        if self.found.visible_only and hidden:
            self.say(SHOWN, f"without {hidden:,} hidden rows", "with all rows", "what it draws")


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
