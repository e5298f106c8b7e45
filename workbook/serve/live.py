"""What a description comes to: beside its text while it is edited, on a page to print, in a line, as a picture."""

from collections.abc import Iterator
from contextlib import suppress
from functools import cached_property, lru_cache
from pathlib import Path
from typing import NamedTuple
from xml.etree.ElementTree import Element, tostring

import numpy as np

from workbook.book.chart import Chart, Series
from workbook.book.declare import Book
from workbook.book.summary import TITLE
from workbook.differences.design import Design, Figure, Key
from workbook.entries.machine import Machine
from workbook.errors import MotionbookError
from workbook.reading.descriptions import checked, counted, parsed, template_named
from workbook.reports.differences import figure
from workbook.reports.html import Content, document, e, markup, table
from workbook.reports.plot import Line, plot, scales
from workbook.serve.edges import Edge, add_handles, edges
from workbook.template import FOLDER

CHARTS = 6  # of a design at most: those that an edit changes, else the first
KEPT = 4  # designs that are remembered: the saved one, and the latest
NEAR = 1e-9  # of a line's range: a smaller change is none
KNOWN = ("number", "revision", "author", "date")  # what identifies a machine beside its title
LINES = 6  # checks that fail, in sentences on the page to print; more are counted
FIRST = 3  # results in a line
DRAWN, FEWER, MANY = 4, 2, 12
"""charts below the table of axes, and how many where it is longer than this"""


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
    except MotionbookError as error:
        return markup(e("h2", "Not yet a machine"), *(e("p", line) for line in str(error).splitlines()))
    old = None
    with suppress(MotionbookError):
        old = design(name, saved)
    faults = [e("p", f"{counted(fault.key)}: {fault.said}") for fault in new.machine.design.faults]
    fails = failing(new)
    return markup(
        *([e("h2", "Unfinished"), *faults] if faults else []),
        e("h2", "Checks that fail"),
        table(("Sheet", "Check", "Where, and by how much"), fails, ()) if fails else e("p", "None: all are OK."),
        e("div", *pictures(new, old, list(edges(text, new.machine))), css="pictures"),
        e("h2", "Results, in short"), table(("", "Now", "Saved", "Change", "Unit"), results(new, old), (1, 2, 3)),
    )  # fmt: skip


@lru_cache(KEPT)
def design(name: str, text: str) -> Shown:
    """Return the design that a text describes. Raises InputError or ReadError for one that describes none."""
    path = Path(name)
    data = parsed(text, path)
    template = template_named(data.get("template"), "template")
    machine = checked(template, data, counted)
    return Shown(path, machine, template.declare(machine))


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
            other, by = "" if before is None else figure(before), ""
            if isinstance(before, int | float) and isinstance(one.value, int | float) and before:
                by = f"{100.0 * (one.value - before) / abs(before):+.3g} %"
            rows.append([f"{axis}: {one.label}" if axis else one.label, figure(one.value), other, by, one.unit])
    return rows


def pictures(new: Shown, old: Shown | None, found: list[Edge]) -> list[Element]:
    """Return the timing diagram with handles at edges, the charts that an edit changes, else the first of the book."""
    known = {title: one.lines for title, one in old.charts} if old else {}
    all_ = [(one, others if (others := known.get(title)) and differ(one.lines, others) else [])
            for title, one in new.charts]  # fmt: skip
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
            drawn = [one for series in chart.series if (one := line(book, chart, series)).x.size]
            if drawn and chart.series not in seen:
                yield (sheet.title, chart.title), Drawn(chart, drawn)
            seen.add(chart.series)


def line(book: Book, chart: Chart, series: Series) -> Line:
    """Return a line of a chart: the points of which both figures are numbers, on an axis of powers above 0."""
    columns = [book.values(series.x), book.values(series.y)]
    x, y = (np.array([one if isinstance(one, int | float | np.number) else np.nan for one in column], dtype=float)
            for column in columns)  # fmt: skip
    shown = np.isfinite(x) & np.isfinite(y) & ((y > 0.0) | (not chart.log_y))
    block = book.blocks.get(series.name.removeprefix("="))
    name = str(block.quantities[0].value) if block is not None and series.name.startswith("=") else series.name
    return Line(name, x[shown], y[shown], series.points)


def differ(lines: list[Line], others: list[Line]) -> bool:
    """Return whether two charts show other lines."""
    return [one.y.size for one in lines] != [one.y.size for one in others] or any(
        not np.allclose(one.y, other.y, rtol=0.0, atol=max(float(np.ptp(other.y)), 1e-9) * NEAR)
        or not np.allclose(one.x, other.x, rtol=NEAR)
        for one, other in zip(lines, others, strict=True)
    )


def sheet(name: str, text: str) -> str:
    """Return the page of a description."""
    shown = design(name, text)
    machine: Machine = shown.machine
    known = [f"{word} {value}" for word in KNOWN if (value := getattr(machine, word))]
    lines = [": ".join(map(str, row)) for row in failing(shown)]
    more = [f"and {len(lines) - LINES} more"] if len(lines) > LINES else []
    word = e("span", "FAIL" if lines else "OK", css=f"verdict {'fails' if lines else 'agrees'}")
    whole, axes = figures(shown)
    first, *others = pictures(shown, None, [])
    below = others[: FEWER if len(shown.axes) > MANY else DRAWN]
    body = [
        e("h1", machine.title, " ", word),
        e("p", ", ".join([name, machine.template, *known]), css="quiet"),
        e("p", "Print this page by Ctrl+P; it is one page of A4.", css="quiet screen"),
        e("div", *(e("p", line) for line in (*lines[:LINES], *more))),
        e("div", whole, first, css="columns"), *axes, e("div", *below, css="pictures"),
    ]  # fmt: skip
    return document(machine.title, [e("div", *body, css="sheet")])


def figures(shown: Shown) -> tuple[Element, list[Element]]:
    """Return the results of the whole machine, and the table of those that each axis has, a row an axis."""
    whole: list[list[Content]] = []
    of: dict[str, dict[str, Content]] = {}
    for label, value, _, _, unit in results(shown, None):
        axis, parted, what = str(label).partition(": ")
        if parted:
            of.setdefault(axis, {})[f"{what} [{unit}]" if unit else what] = short(str(value))
        else:
            whole.append([label, short(str(value)), unit])
    names = list(dict.fromkeys(what for row in of.values() for what in row))
    rows = [[axis, *(row.get(what, "") for what in names)] for axis, row in of.items()]
    axes = [table(("Axis", *names), rows, range(1, len(names) + 1))] if rows else []
    return table(("Result", "", ""), whole, (1,)), axes


def short(value: str) -> str:
    """Return a number with four digits that count, and all before its point; another text as it is."""
    try:
        number = float(value)
    except ValueError:
        return value
    return f"{number:,.0f}" if abs(number) >= 1000.0 else f"{number:.4g}"


def in_short(name: str, text: str) -> str:
    """Return in a line the first results of a description, and how many checks fail."""
    try:
        shown = design(name, text)
    except MotionbookError as error:
        return str(error).partition("\n")[0]
    whole = [f"{label} {short(str(value))} {unit}".rstrip() for label, value, _, _, unit in results(shown, None)
             if ": " not in str(label)]  # fmt: skip
    fails = len(failing(shown))
    return "; ".join([*whole[:FIRST], f"{fails} checks FAIL" if fails else "all checks OK"])


def picture(template: str) -> str:
    """Return the first chart of a template's committed description as a picture of its own."""
    text = (FOLDER / f"{template}.toml").read_text(encoding="utf-8")
    return tostring(pictures(design(template, text), None, [])[0], encoding="unicode")
