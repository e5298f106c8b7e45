"""The results of a description by its book: its charts, a page to print, and what single changes would gain."""

from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from workbook.book.chart import Chart, Series
from workbook.book.declare import Book
from workbook.book.rows import is_number
from workbook.book.summary import TITLE
from workbook.description.editing import edit_text
from workbook.differences.design import Design, Figure, Key
from workbook.entries.machine import Machine
from workbook.pool import THIS_PROCESS
from workbook.reading.descriptions import counted_from_1, make_machine, parse_toml, template_named
from workbook.reports.differences import figure
from workbook.reports.html import Line, document, plot
from workbook.studies.design import first_design
from workbook.studies.improve import single_gains

REMEMBERED = 4  # designs that are remembered: the saved one, and the latest
KNOWN = ("number", "revision", "author", "date")  # what identifies a machine beside its title
LINES = 6  # checks that fail, in sentences on the page to print; more are counted
# charts below the table of axes, and how many where it is longer than this
DRAWN, FEWER, MANY = 4, 2, 12


class ShownDesign(Design):
    """A design with its charts and results."""

    @cached_property
    def charts(self) -> list[tuple[Chart, list[Line]]]:
        """The charts of its book that have lines, each once: first the timing diagram."""
        every = dict[tuple[Series, ...], Chart]()
        for chart in (chart for sheet in self.book.sheets for chart, *_ in sheet.charts):
            every[tuple(line for line in chart.series if not line.is_note)] = chart  # whole on its own sheet
        drawn = [(chart, [curve for series in lines if (curve := line(self.book, chart, series)).x.size])
                 for lines, chart in every.items()]  # fmt: skip
        return sorted(((chart, lines) for chart, lines in drawn if lines), key=lambda drawn: not drawn[0].lanes)

    @cached_property
    def summary(self) -> dict[Key, Figure]:
        """The results of the sheet Summary, each with its axis, if any, as its place."""
        parted = ((key, result, result.place.partition(": ")) for key, result in self.results().items())
        return {key: figure._replace(place=axis) for key, figure, (sheet, _, axis) in parted if sheet == TITLE}


@lru_cache(REMEMBERED)
def design(name: str, text: str) -> ShownDesign:
    """Return the design that a text describes. Raises InputError or ReadError for a text that describes none."""
    path = Path(name)
    data = parse_toml(text, path)
    template = template_named(data.get("template"), "template")
    machine = make_machine(template, data, counted_from_1, by_code=True)
    return ShownDesign(path, machine, template.declare(machine))


def gains(name: str, text: str) -> list[dict[str, str]]:
    """Return what each single change of a machine would gain, the best first, and the text with it.

    Raises MotionbookError for a text that describes no finished machine whose drives limit its rate.
    """
    first = first_design(design(name, text).machine)
    rows = sorted(single_gains(first, THIS_PROCESS, lambda *_: None), key=lambda gain: gain.after)
    return [{"sentence": gain.sentence(first), "text": edit_text(text, gain.changes.items())} for gain in rows]


def failing(new: ShownDesign) -> list[list[str]]:
    """Return a row for each check that fails: its sheet, what it is, why; of an unfinished design for each fault."""
    if faults := new.machine.design.faults:
        return [["to complete", counted_from_1(fault.key), fault.message] for fault in faults]
    return [[check.place, check.label, check.says] for check in new.checks().values() if check.value == "FAIL"]


def pictures(shown: ShownDesign, most: int) -> list[str]:
    """Return pictures of the first charts of a design."""
    drawn = shown.charts[:most]
    return [plot(chart.title, (chart.x, chart.y), lines, (False, chart.log_y)) for chart, lines in drawn]


def line(book: Book, chart: Chart, series: Series) -> Line:
    """Return a line of a chart: points with numbers, on an axis of powers above 0, and gaps between bars."""
    x, y = (
        np.array([value if is_number(value) else np.nan for value in book.values(text)])
        for text in (series.x, series.y)
    )
    shown = np.isfinite(x) & (np.isfinite(y) | series.thick) & ((y > 0.0) | (not chart.log_y))
    name = str(book.values(series.name)[0]) if series.name.startswith(("=", "[")) else series.name
    return Line(name, x[shown], y[shown], series.points)


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
    drawn = pictures(shown, 1 + (FEWER if len(shown.axes) > MANY else DRAWN))
    return document(
        machine.title,
        "serve/sheet.html",
        lines=[": ".join(map(str, row)) for row in failing(shown)],
        most=LINES,
        known=[name, machine.template, *(f"{word} {value}" for word in KNOWN if (value := getattr(machine, word)))],
        whole=whole,
        names=names,
        axes=[[axis, *(row.get(what, "") for what in names)] for axis, row in of.items()],
        drawn=drawn,
    )


def short(value: Any) -> str:
    """Return a number with four digits that count, and all before its point; another value as it is."""
    return (f"{value:,.0f}" if abs(value) >= 1000.0 else f"{value:.4g}") if is_number(value) else figure(value)
