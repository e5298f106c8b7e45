"""What a description comes to while it is edited: its results, the checks that fail, the charts of its book."""

from collections.abc import Iterator
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

import numpy as np

from engine.laws.base import Array
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book
from workbook.book.summary import TITLE
from workbook.differences.design import Design, Figure, Key
from workbook.errors import MotionbookError
from workbook.reading.descriptions import checked, counted, parsed, template_named
from workbook.reports.differences import figure
from workbook.reports.html import Content, e, markup, table
from workbook.reports.plot import Line, plot, scales
from workbook.serve.edges import Edge, add_handles, edges

CHARTS = 6
"""of a design at most: those that an edit changes, else the first"""
KEPT = 4
"""designs that are remembered: the saved one, and the latest"""
NEAR = 1e-9
"""of a line's range: a smaller change is none"""


class Drawn(NamedTuple):
    """A chart of a book and its lines."""

    chart: Chart
    lines: list[Line]


class Shown(Design):
    """A design with its charts."""

    @cached_property
    def charts(self) -> list[tuple[tuple[str, str], Drawn]]:
        """The charts of its book, by the titles of the sheet and their own."""
        return list(charts_of(self.book))

    @cached_property
    def figures(self) -> dict[Key, Figure]:
        """Its results."""
        return self.results()


def fragment(name: str, text: str, saved: str) -> str:
    """Return the HTML beside a description: what it comes to, with the lines of the saved one in grey."""
    try:
        new = design(name, text)
        body = panel(new, before(name, saved), list(edges(text, new.machine)))
    except MotionbookError as error:
        body = [e("h2", "Not yet a machine"), *(e("p", line) for line in str(error).splitlines())]
    return markup(*body)


@lru_cache(KEPT)
def design(name: str, text: str) -> Shown:
    """Return the design that a text describes. Raises InputError or ReadError for one that describes none."""
    path = Path(name)
    data = parsed(text, path)
    template = template_named(data.get("template"), "template")
    machine = checked(template, data, counted)
    return Shown(path, machine, template.declare(machine))


def before(name: str, saved: str) -> Shown | None:
    """Return the saved design, None where its text describes none."""
    try:
        return design(name, saved)
    except MotionbookError:
        return None


def panel(new: Shown, old: Shown | None, found: list[Edge]) -> list[Element]:
    """Return the checks that fail, the charts, and the results in short with those of the saved design."""
    faults = [e("p", f"{counted(fault.key)}: {fault.said}") for fault in new.machine.design.faults]
    fails = failing(new)
    return [
        *([e("h2", "Unfinished"), *faults] if faults else []),
        e("h2", "Checks that fail"),
        table(("Sheet", "Check", "Where, and by how much"), fails, ()) if fails else e("p", "None: all are OK."),
        e("div", *pictures(new, old, found), css="pictures"),
        e("h2", "Results, in short"), table(("", "Now", "Saved", "Change", "Unit"), results(new, old), (1, 2, 3)),
    ]  # fmt: skip


def failing(new: Shown) -> list[list[Content]]:
    """Return a row for each check that fails: its sheet, what it is, where and by how much."""
    return [[one.place, one.label, one.says] for one in new.checks().values() if one.value == "FAIL"]


def results(new: Shown, old: Shown | None) -> list[list[Content]]:
    """Return a row for each result of the sheet Summary, with that of the saved design where it differs."""
    known = old.figures if old else {}
    rows: list[list[Content]] = []
    for key, one in new.figures.items():
        sheet, _, axis = one.place.partition(": ")
        if sheet == TITLE:
            saved = known.get(key)
            before = saved.value if saved is not None and saved.value != one.value else None
            other, by = "" if before is None else figure(before), change(before, one.value)
            rows.append([f"{axis}: {one.label}" if axis else one.label, figure(one.value), other, by, one.unit])
    return rows


def change(before: object, now: object) -> str:
    """Return by which share of it a number differs from another; nothing where that cannot be said."""
    if not isinstance(before, int | float) or not isinstance(now, int | float) or not before:
        return ""
    return f"{100.0 * (now - before) / abs(before):+.3g} %"


def pictures(new: Shown, old: Shown | None, found: list[Edge]) -> list[Element]:
    """Return the timing diagram with handles at edges, the charts that an edit changes, else the first of the book."""
    known = {title: one.lines for title, one in old.charts} if old else {}
    all_ = [(one, changed(one.lines, known.get(title))) for title, one in new.charts]
    shifts = {axis.name: axis.shift for axis in getattr(new.machine, "axes", [])} if found else {}
    all_.sort(key=lambda both: not (both[0].chart.lanes or both[1]))
    drawn = []
    for one, before in all_[:CHARTS]:
        chart = one.chart
        svg = plot(chart.title, (chart.x, chart.y), one.lines, (False, chart.log_y), before=before)
        if chart.lanes:
            add_handles(svg, scales([*one.lines, *before]), one.lines, found, shifts)
        drawn.append(svg)
    return drawn


def charts_of(book: Book) -> Iterator[tuple[tuple[str, str], Drawn]]:
    """Yield the charts of a book that have lines, each once, by the titles of its sheet and its own."""
    seen: set[tuple[Series, ...]] = set()
    for sheet in book.sheets:
        for chart, *_ in sheet.charts:
            lines = [line(book, chart, one) for one in chart.series]
            drawn = [one for one in lines if one.x.size]
            if drawn and chart.series not in seen:
                yield (sheet.title, chart.title), Drawn(chart, drawn)
            seen.add(chart.series)


def line(book: Book, chart: Chart, series: Series) -> Line:
    """Return a line of a chart: the points of which both figures are numbers, on an axis of powers above 0."""
    x, y = (numbers(book.values(column)) for column in (series.x, series.y))
    shown = np.isfinite(x) & np.isfinite(y) & ((y > 0.0) | (not chart.log_y))
    block = book.blocks.get(series.name.removeprefix("="))
    name = str(block.quantities[0].value) if block is not None and series.name.startswith("=") else series.name
    return Line(name, x[shown], y[shown], series.points)


def numbers(values: list[Any]) -> Array:
    """Return the numbers that cells have; NaN where one has none."""
    try:
        return np.array(values, dtype=float)
    except ValueError:  # a text among them
        return np.array([one if isinstance(one, int | float) else np.nan for one in values], dtype=float)


def changed(lines: list[Line], others: list[Line] | None) -> list[Line]:
    """Return the lines as they were before, none of a chart in which no line changed or which is new."""
    return others if others is not None and differ(lines, others) else []


def differ(lines: list[Line], others: list[Line]) -> bool:
    """Return whether two charts show other lines."""
    if [one.y.size for one in lines] != [one.y.size for one in others]:
        return True
    near = [max(float(np.ptp(one.y)), 1e-9) * NEAR for one in others]
    return any(
        not np.allclose(one.y, other.y, rtol=0.0, atol=by) or not np.allclose(one.x, other.x, rtol=NEAR)
        for one, other, by in zip(lines, others, near, strict=True)
    )
