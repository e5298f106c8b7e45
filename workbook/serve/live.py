"""What a description comes to while it is edited: its results, the checks that fail, the charts of its book."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple
from xml.etree.ElementTree import Element, tostring

import numpy as np

from engine.laws.base import Array
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book
from workbook.book.summary import TITLE
from workbook.differences.design import Design
from workbook.errors import MotionbookError
from workbook.reading.descriptions import checked, counted, parsed, template_named
from workbook.reports.differences import figure
from workbook.reports.page import Content, e, table
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


def fragment(name: str, text: str, saved: str) -> str:
    """Return the HTML beside a description: what it comes to, with the lines of the saved one in grey."""
    try:
        new = design(name, text)
        body = panel(new, before(name, saved), list(edges(text, new.machine)))
    except MotionbookError as error:
        body = [e("h2", "Not yet a machine"), *(e("p", line) for line in str(error).splitlines())]
    return "".join(tostring(one, encoding="unicode", method="html") for one in body)


@lru_cache(KEPT)
def design(name: str, text: str) -> Design:
    """Return the design that a text describes. Raises InputError or ReadError for one that describes none."""
    path = Path(name)
    data = parsed(text, path)
    template = template_named(data.get("template"), "template")
    machine = checked(template, data, counted)
    return Design(path, machine, template.declare(machine))


def before(name: str, saved: str) -> Design | None:
    """Return the saved design, None where its text describes none."""
    try:
        return design(name, saved)
    except MotionbookError:
        return None


def panel(new: Design, old: Design | None, found: list[Edge]) -> list[Element]:
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


def failing(new: Design) -> list[list[Content]]:
    """Return a row for each check that fails: its sheet, what it is, where and by how much."""
    return [[one.place, one.label, one.says] for one in new.checks().values() if one.value == "FAIL"]


def results(new: Design, old: Design | None) -> list[list[Content]]:
    """Return a row for each result of the sheet Summary, with that of the saved design where it differs."""
    known = old.results() if old else {}
    rows: list[list[Content]] = []
    for key, one in new.results().items():
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


def pictures(new: Design, old: Design | None, found: list[Edge]) -> list[Element]:
    """Return the timing diagram with handles at edges, the charts that an edit changes, else the first of the book."""
    known = {(title, one.chart.title): one.lines for title, one in charts(old.book)} if old else {}
    all_ = [(one, known.get((title, one.chart.title), one.lines)) for title, one in charts(new.book)]
    shifts = {axis.name: axis.shift for axis in getattr(new.machine, "axes", [])} if found else {}
    all_.sort(key=lambda both: not (both[0].chart.lanes or differ(both[0].lines, both[1])))
    drawn = []
    for one, lines in all_[:CHARTS]:
        chart = one.chart
        svg = plot(chart.title, (chart.x, chart.y), one.lines, (False, chart.log_y), before=lines)
        if chart.lanes:
            add_handles(svg, scales([*one.lines, *lines]), one.lines, found, shifts)
        drawn.append(svg)
    return drawn


def charts(book: Book) -> Iterator[tuple[str, Drawn]]:
    """Yield the charts of a book that have lines, each once and with the title of its sheet."""
    seen: set[tuple[Series, ...]] = set()
    for sheet in book.sheets:
        for chart, *_ in sheet.charts:
            lines = [line(book, chart, one) for one in chart.series]
            drawn = [one for one in lines if one.x.size]
            if drawn and chart.series not in seen:
                yield sheet.title, Drawn(chart, drawn)
            seen.add(chart.series)


def line(book: Book, chart: Chart, series: Series) -> Line:
    """Return a line of a chart: the points of which both figures are numbers, on an axis of powers above 0."""
    x, y = (np.array([number(one) for one in book.values(column)]) for column in (series.x, series.y))
    shown: Array = np.isfinite(x) & np.isfinite(y) & ((y > 0.0) | (not chart.log_y))
    block = book.blocks.get(series.name.removeprefix("="))
    name = str(block.quantities[0].value) if block is not None and series.name.startswith("=") else series.name
    return Line(name, x[shown], y[shown], series.points)


def number(value: object) -> float:
    """Return the number that a cell has; NaN where it has none."""
    return float(value) if isinstance(value, int | float) else float("nan")


def differ(lines: list[Line], others: list[Line]) -> bool:
    """Return whether two charts show other lines."""
    if [one.y.size for one in lines] != [one.y.size for one in others]:
        return True
    near = [max(float(np.ptp(one.y)), 1e-9) * NEAR for one in others]
    return any(
        not np.allclose(one.y, other.y, rtol=0.0, atol=by) or not np.allclose(one.x, other.x, rtol=NEAR)
        for one, other, by in zip(lines, others, near, strict=True)
    )
