"""Differences of two designs: on the terminal, as JSON, as a page with both timing diagrams."""

import re
from typing import Any

import numpy as np
from rich.console import Console

from workbook.differences.design import Change, Design, Differences
from workbook.reports.html import Line, document, plot
from workbook.reports.terminal import say, show_table
from workbook.templates import TEMPLATES

KINDS = (("entries", "Entries"), ("results", "Results"), ("checks", "Checks"))
LINES = (("edited", "Formulas and texts edited"), ("own", "Cells, sheets and charts of your own"))
HEADINGS = ("where", "what", "old", "new", "unit", "difference", "")
MOST = 25  # differences of a kind that are listed unless all are asked for
CELL = re.compile(r"(?P<column>[^:(]*![A-Z]{1,3})(?P<row>\d+)")
DIGITS = re.compile(r"\d+(?:\.\d+)?(?:E[+-]?\d+)?", re.IGNORECASE)
SAMPLES = 721  # of a diagram


def data(differences: Differences) -> dict[str, Any]:
    """Return all differences as JSON has them."""
    kinds = {
        name: [
            change._asdict() | {"difference": change.difference, "per_cent": change.per_cent}
            for change in getattr(differences, name)
        ]
        for name, _ in KINDS
    }
    return {"same": differences.same, **kinds, "edited": differences.edited, "own": differences.own}


def row(change: Change) -> list[str]:
    """Return the cells of a table for a difference."""
    # of numbers of which the old is 0
    apart = "" if change.difference is None else f"{change.difference:+.6g}"
    apart = apart if change.per_cent is None else f"{change.per_cent:+.2f} %"
    note = change.says or ("worse" if change.worse else "")
    both = figure(change.old), figure(change.new)
    return [change.place, change.label, *both, change.unit, apart, note]


def figure(value: Any) -> str:
    """Return a value as people write it; a dash for an empty value and for what is no number."""
    if value in (None, "") or value != value:
        return "–"
    return f"{value:.7g}" if isinstance(value, float) else str(value)


def show(console: Console, differences: Differences, everything: bool = False) -> None:
    """Print the differences as tables and lines: of each kind the first, formulas by patterns, the rest as a number."""
    for name, title in KINDS:
        changes = getattr(differences, name)
        chosen = changes if everything else [x for x in changes if name != "results" or x.is_shown][:MOST]
        if chosen:
            show_table(console, HEADINGS, map(row, chosen), title=title, box=None, pad_edge=False)
        show_rest(console, len(changes) - len(chosen), name)
    for name, title in LINES:
        lines = sign_lines(getattr(differences, name))
        groups = [f"{sign} {text}" for sign, text in lines] if everything else group_lines(lines)
        for text in groups if everything else groups[:MOST]:
            say(console, f"{title}: {text}")
        show_rest(console, 0 if everything else len(groups) - MOST, title.lower())


def show_rest(console: Console, count: int, what: str) -> None:
    """Print how many differences of a kind are not listed, if any."""
    if count > 0:
        say(console, f"… and {count:,} more {what}; --all lists them")


def group_lines(lines: list[tuple[str, str]]) -> list[str]:
    """Return lines on cells, those of a column whose texts differ in numbers alone as one with its first and last."""
    groups: dict[tuple[str, ...], list[tuple[str, str]]] = {}
    for sign, line in lines:
        cell = CELL.match(line)
        column = cell["column"] if cell else line
        groups.setdefault((sign, column, DIGITS.sub("#", line)), []).append((cell["row"] if cell else "", line))
    texts = []
    for (sign, column, _), cells in groups.items():
        (first, line), count = cells[0], len(cells)
        span = f"{column}{first} … {cells[-1][0]}, {count} cells{line[len(column) + len(first) :]}"
        texts.append(f"{sign} {span if count > 1 else line}")
    return texts


def sign_lines(lines: dict[str, list[str]]) -> list[tuple[str, str]]:
    """Return the lines that are gone with a minus, and those that came with a plus."""
    return [*(("−", line) for line in lines["old"]), *(("+", line) for line in lines["new"])]


def page(old: Design, new: Design, differences: Differences) -> str:
    """Return the page of all differences, with the motions of both sides over one another."""
    title = f"{old.path.name} and {new.path.name}"
    given = {"old": old, "new": new, "differences": differences}
    return document(title, "reports/differences.html", **given)


def diagrams(old: Design, new: Design) -> list[str]:
    """Return a picture of each axis whose motion differs: its position over the cycle, old and new."""
    before = {axis.name: axis for axis in TEMPLATES[old.machine.template].axes(old.machine)}
    plots = []
    for axis in TEMPLATES[new.machine.template].axes(new.machine):
        lines = []
        for name, drawn_axis in (("old", before.get(axis.name)), ("new", axis)):
            if drawn_axis is not None:
                x = np.linspace(drawn_axis.profile.edges[0], drawn_axis.profile.edges[-1], SAMPLES)
                lines.append(Line(name, x, drawn_axis.profile.at(x).y))
        if len(lines) < 2 or not np.allclose(lines[0].y, lines[1].y, rtol=0.0, atol=1e-9 * np.ptp(lines[1].y)):
            plots.append(plot(f"{axis.name}: position over the cycle", (axis.x_unit, axis.y_unit), lines))
    return plots
