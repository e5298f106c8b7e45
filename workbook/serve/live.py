"""The results of a description: beside its text while it is edited, with handles at edges; in print, in a line."""

import re
from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from workbook.book.chart import Chart, Series
from workbook.book.declare import Book
from workbook.book.rows import is_number
from workbook.book.summary import TITLE
from workbook.differences.design import Change, Design, Figure, Key
from workbook.entries.machine import Machine
from workbook.errors import MotionbookError
from workbook.reading.descriptions import counted_from_1, described, parse_toml, template_named
from workbook.reports.differences import figure
from workbook.reports.html import ACROSS, Handle, Line, document, paragraphs, plot, rendered
from workbook.template import FOLDER

BEFORE_NEXT = r".*?(?=^[ \t]*\[|\Z)"  # a table of TOML, up to the next
AXIS = re.compile(rf"(?ms)^\[\[axes\]\]{BEFORE_NEXT}")
PHASES = re.compile(rf"(?ms)^\s*(?:\[\[axes\.phases\]\]{BEFORE_NEXT}|phases\s*=\s*\[(?:[^][]|\[[^][]*\])*\])")
ENTRY = re.compile(r"\b(?:start|stop)\s*=\s*(-?\d[\d.]*)")
SHIFT = re.compile(r"(?m)^\s*shift\s*=\s*(-?\d[\d.]*)")
NAME = re.compile(r"(?m)^\s*name\s*=.*$")
STEPS = 360  # steps of a cycle: a degree where the cycle is in degrees
CHARTS = 6  # of a design at most: those that an edit changes, else the first
REMEMBERED = 4  # designs that are remembered: the saved one, and the latest
NEAR = 1e-9  # of a line's range: a smaller change is none
KNOWN = ("number", "revision", "author", "date")  # what identifies a machine beside its title
LINES = 6  # checks that fail, in sentences on the page to print; more are counted
FIRST = 3  # results in a line
DRAWN, FEWER, MANY = 4, 2, 12  # charts below the table of axes, and how many where it is longer than this


class Edge(NamedTuple):
    """A handle in the timing diagram: where phases of an axis begin or end, or its whole lane."""

    axis: str
    value: float  # as entered
    places: list[tuple[int, int]]  # of its numbers in the text, or where they would stand
    lane: bool = False
    before: str = ""  # what is to be written before its number

    @property
    def key(self) -> str:
        """The key by which the page finds the handle, also in the next picture."""
        return f"{self.axis} {'lane' if self.lane else format(self.value, 'g')}"


def edges(text: str, machine: Any) -> Iterator[Edge]:
    """Yield the lane and the edges of each axis whose entries stand in the text as the machine has them."""
    heads = [match.span() for match in AXIS.finditer(text)]
    axes = getattr(machine, "axes", [])
    if len(heads) != len(axes):
        return
    for axis, head, (end, _) in zip(axes, heads, [*heads[1:], (len(text), 0)], strict=False):
        yield from lane(text, axis, head)
        typed = typed_edges(text, head[0], end)
        entered = [value for phase in axis.phases for value in (phase.start, phase.stop)]
        if [value for value, _ in typed] == entered:
            for value in dict.fromkeys(entered):
                yield Edge(axis.name, value, [place for entry, place in typed if entry == value])


def lane(text: str, axis: Any, head: tuple[int, int]) -> Iterator[Edge]:
    """Yield the lane of an axis whose table is at a place of a text, if its shift stands or has room there."""
    shift, name = SHIFT.search(text, *head), NAME.search(text, *head)
    if shift and float(shift[1]) == axis.shift:
        yield Edge(axis.name, axis.shift, [shift.span(1)], lane=True)
    elif not shift and not axis.shift and name:
        yield Edge(axis.name, 0.0, [(name.end(), name.end())], lane=True, before="\nshift = ")


def typed_edges(text: str, begin: int, end: int) -> list[tuple[float, tuple[int, int]]]:
    """Return the numbers of the phases between two places of a text that stand in no comment, and where they stand."""
    lists = (match.span() for match in PHASES.finditer(text, begin, end))
    numbers = (match for place in lists for match in ENTRY.finditer(text, *place))
    return [
        (float(number[1]), number.span(1))
        for number in numbers
        if "#" not in text[text.rfind("\n", 0, number.start()) + 1 : number.start()]
    ]


def handles(lines: list[Line], edges: Iterable[Edge], shifts: dict[str, float]) -> Iterator[Handle]:
    """Yield a handle of the timing diagram for each edge, on the line of its axis; a lane's is the name at its line."""
    drawn = {line.name: line for line in lines}
    for edge in (edge for edge in edges if edge.axis in drawn):
        x = drawn[edge.axis].x
        begin, cycle = float(x[0]), float(np.ptp(x))
        attributes = {
            "class": "lane" if edge.lane else "edge",
            "tabindex": "0",
            "role": "slider",
            "aria-label": f"{edge.axis}, {'shift' if edge.lane else 'edge of a phase'}",
            "aria-valuenow": f"{edge.value:g}",
            "data-edge": edge.key,
            "data-value": f"{edge.value!r}",
            "data-step": f"{10.0 ** round(np.log10(cycle / STEPS)):g}",
            "data-across": f"{cycle / ACROSS!r}",
            "data-places": " ".join(f"{low}-{high}" for low, high in edge.places),
            "data-before": edge.before,
        }
        later = edge.value + shifts[edge.axis] - begin
        at = begin + (later if 0.0 <= later <= cycle else later % cycle)
        yield Handle(edge.axis, attributes, None if edge.lane else at, f"{edge.axis}: {edge.value:g}")


class ShownDesign(Design):
    """A design with its charts and results."""

    @cached_property
    def charts(self) -> list[tuple[tuple[str, str], tuple[Chart, list[Line]]]]:
        """The charts of its book that have lines, each once, by the titles of its sheet and its own."""
        charts, seen = [], set[tuple[Series, ...]]()
        for sheet in self.book.sheets:
            for chart, *_ in sheet.charts:
                drawn = [curve for series in chart.series if (curve := line(self.book, chart, series)).x.size]
                if drawn and chart.series not in seen:
                    charts.append(((sheet.title, chart.title), (chart, drawn)))
                seen.add(chart.series)
        return charts

    @cached_property
    def summary(self) -> dict[Key, Figure]:
        """The results of the sheet Summary, each with its axis, if any, as its place."""
        parted = ((key, result, result.place.partition(": ")) for key, result in self.results().items())
        return {key: figure._replace(place=axis) for key, figure, (sheet, _, axis) in parted if sheet == TITLE}


def fragment(name: str, text: str, saved: str) -> str:
    """Return the HTML beside a description: its results, with the lines of the saved description in grey."""
    try:
        new = design(name, text)
    except MotionbookError as error:
        return f"<h2>Not yet a machine</h2>{paragraphs(error)}"
    old = None
    with suppress(MotionbookError):
        old = design(name, saved)
    drawn = pictures(new, old, list(edges(text, new.machine)))
    return rendered(
        "serve/fragment.html",
        new=new,
        counted=counted_from_1,
        fails=failing(new),
        results=results(new, old),
        drawn=drawn,
    )


@lru_cache(REMEMBERED)
def design(name: str, text: str) -> ShownDesign:
    """Return the design that a text describes. Raises InputError or ReadError for a text that describes none."""
    path = Path(name)
    data = parse_toml(text, path)
    template = template_named(data.get("template"), "template")
    machine = described(template, data, counted_from_1)
    return ShownDesign(path, machine, template.declare(machine))


def failing(new: ShownDesign) -> list[list[str]]:
    """Return a row for each check that fails: its sheet, what it is, where and by how much."""
    return [[check.place, check.label, check.says] for check in new.checks().values() if check.value == "FAIL"]


def results(new: ShownDesign, old: ShownDesign | None) -> list[list[str]]:
    """Return a row for each result of the sheet Summary, with that of the saved design where it differs."""
    known = old.summary if old else {}
    rows = []
    for key, result in new.summary.items():
        saved = known.get(key, result).value
        share = (
            Change(result.place, result.label, result.unit, saved, result.value).per_cent
            if saved != result.value
            else None
        )
        before, by = "" if saved in (None, result.value) else figure(saved), "" if share is None else f"{share:+.3g} %"
        rows.append([": ".join(filter(None, result[:2])), figure(result.value), before, by, result.unit])
    return rows


def pictures(new: ShownDesign, old: ShownDesign | None, edges: list[Edge]) -> list[str]:
    """Return the timing diagram with handles at edges, the charts that an edit changes, else the first of the book."""
    known = dict(old.charts) if old else {}
    all_ = [
        (chart, lines, others if (others := known.get(title, (chart, []))[1]) and differ(lines, others) else [])
        for title, (chart, lines) in new.charts
    ]
    shifts = {axis.name: axis.shift for axis in getattr(new.machine, "axes", [])} if edges else {}
    all_.sort(key=lambda drawn_chart: not (drawn_chart[0].lanes or drawn_chart[2]))
    drawn = []
    for chart, lines, before in all_[:CHARTS]:
        held = [*handles(lines, edges, shifts)] if chart.lanes else []
        drawn.append(plot(chart.title, (chart.x, chart.y), lines, (False, chart.log_y), before, held))
    return drawn


def line(book: Book, chart: Chart, series: Series) -> Line:
    """Return a line of a chart: the points of which both figures are numbers, on an axis of powers above 0."""
    columns = [book.values(series.x), book.values(series.y)]
    x, y = (
        np.array([value if isinstance(value, int | float | np.number) else np.nan for value in column], dtype=float)
        for column in columns
    )
    shown = np.isfinite(x) & np.isfinite(y) & ((y > 0.0) | (not chart.log_y))
    block = book.blocks.get(series.name.removeprefix("="))
    name = str(block.quantities[0].value) if block is not None and series.name.startswith("=") else series.name
    return Line(name, x[shown], y[shown], series.points)


def differ(lines: list[Line], others: list[Line]) -> bool:
    """Return whether two charts show other lines."""
    return [line.y.size for line in lines] != [other.y.size for other in others] or not all(
        np.allclose(line.y, other.y, rtol=0.0, atol=max(float(np.ptp(other.y)), 1e-9) * NEAR)
        and np.allclose(line.x, other.x, rtol=NEAR)
        for line, other in zip(lines, others, strict=True)
    )


def sheet(name: str, text: str) -> str:
    """Return the page of a description: results of the whole machine, those of each axis in a row, pictures."""
    shown = design(name, text)
    machine: Machine = shown.machine
    whole: list[list[str]] = []
    of: dict[str, dict[str, str]] = {}
    for result in shown.summary.values():
        if result.place:
            of.setdefault(result.place, {})[f"{result.label} [{result.unit}]" if result.unit else result.label] = short(
                result.value
            )
        else:
            whole.append([result.label, short(result.value), result.unit])
    names = list(dict.fromkeys(what for row in of.values() for what in row))
    drawn = pictures(shown, None, [])[: 1 + (FEWER if len(shown.axes) > MANY else DRAWN)]
    return document(
        machine.title,
        rendered(
            "serve/sheet.html",
            title=machine.title,
            lines=[": ".join(map(str, row)) for row in failing(shown)],
            most=LINES,
            known=[name, machine.template, *(f"{word} {value}" for word in KNOWN if (value := getattr(machine, word)))],
            whole=whole,
            names=names,
            axes=[[axis, *(row.get(what, "") for what in names)] for axis, row in of.items()],
            drawn=drawn,
        ),
    )


def short(value: Any) -> str:
    """Return a number with four digits that count, and all before its point; another value as it is."""
    return (f"{value:,.0f}" if abs(value) >= 1000.0 else f"{value:.4g}") if is_number(value) else figure(value)


def in_short(name: str, text: str) -> str:
    """Return in a line the first results of a description, and how many checks fail."""
    try:
        shown = design(name, text)
    except MotionbookError as error:
        return str(error).partition("\n")[0]
    whole = [
        f"{result.label} {short(result.value)} {result.unit}".rstrip()
        for result in shown.summary.values()
        if not result.place
    ]
    fails = len(failing(shown))
    return "; ".join([*whole[:FIRST], f"{fails} checks FAIL" if fails else "all checks OK"])


@lru_cache
def picture(template: str) -> str:
    """Return the first chart of a template's committed description as a picture of its own."""
    shown = design(template, (FOLDER / f"{template}.toml").read_text(encoding="utf-8"))
    return pictures(shown, None, [])[0]
