"""A study as a page of HTML: the front, the best designs, what was fixed, what excludes the others."""

import platform
import re
from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any

import numpy as np

import workbook
from workbook.fields.paths import leaves, spell
from workbook.reports.differences import figure
from workbook.reports.html import document, front_picture, render
from workbook.reports.html import shown as escaped
from workbook.studies.evaluate import Label, Labels
from workbook.studies.plan import Plan
from workbook.studies.run import BookCheck
from workbook.studies.space import Dimension, Study
from workbook.studies.summary import Design, Summary

TEMPLATE = "reports/study.html"
MOST = 200  # designs that the page lists


def page(plan: Plan, summary: Summary, named: Labels, judged: BookCheck | None, when: datetime) -> str:
    """Return the page."""
    versions = f"motionbook {workbook.__version__}, Python {platform.python_version()}"
    versions = f"{when:%Y-%m-%d %H:%M:%S %z}, {versions}, NumPy {np.__version__}"
    varied = {path for dimension in plan.space.dimensions for path in dimension.paths}
    data = plan.base.model_dump(exclude_none=True, exclude={"selection", "sizes", "laws"})
    fixed = [(path, value) for path, value in leaves(data) if path not in varied and value != {}]
    more = {"judged": judged, "versions": versions, "fixed": fixed, "plan_page": True}
    return document(plan.study.title, TEMPLATE, **contents(plan, summary, named), **more)


def front(plan: Plan, summary: Summary, named: Labels, links: Sequence[str]) -> str:
    """Return the results of a study as HTML: the best designs, each a link, and the excluding bounds."""
    return render(TEMPLATE, **contents(plan, summary, named, links), judged=None, plan_page=False)


def contents(plan: Plan, summary: Summary, named: Labels, links: Sequence[str] = ()) -> dict[str, Any]:
    """Return the values that both pages show, by their names in the template."""
    shown, names = summary.best[:MOST], list(dict.fromkeys([*plan.study.goals, *plan.study.names]))
    first = [*shown[0].entries.values(), *(shown[0].results[name] for name in names)] if shown else []
    heads = [*(dimension.label for dimension in plan.space.dimensions), *(heading(name, named) for name in names)]
    css = ["" if isinstance(value, str) else ' class="number"' for value in first]
    drawn = picture(plan.study, shown, named, links) if shown and len(plan.study.goals) > 1 else ""
    columns = list(zip(heads, css, strict=False))
    given: dict[str, Any] = {"plan": plan, "summary": summary, "named": named, "links": links, "drawn": drawn}
    return given | {"columns": columns, "shown_best": shown, "names": names}


def excluding(plan: Plan, summary: Summary) -> list[tuple[str, str, int, int]]:
    """Return constraints, bounds in words, and how many designs each excludes, and alone: first those that are told."""
    counts = {name: summary.excluded.get(name, 0) for name in plan.study.bounds}
    checks = sorted(summary.excluded.items(), key=lambda counted: -counted[1])
    counts |= {name: count for name, count in checks if count and name not in counts}
    words = {name: bound if isinstance(bound, str) else bound.words for name, bound in plan.study.bounds.items()}
    return [(name, words.get(name, "OK"), count, summary.alone.get(name, 0)) for name, count in counts.items()]


def unranked_designs(summary: Summary) -> list[str]:
    """Return in a line how many feasible designs have no place among the best since they lack an objective's value."""
    if not summary.unranked:
        return []
    lacks = [f"{name} has no value in {count:,}" for name, count in summary.without.items() if count]
    return [f"{summary.unranked:,} of {summary.feasible:,} feasible designs cannot be ranked: {', '.join(lacks)}"]


def breakable(words: str) -> str:
    """Return a heading that may go on in a new line behind the parts of a name."""
    return "<wbr>".join(map(escaped, re.split(r"(?<=[._\]])", words)))


def picture(study: Study, designs: Sequence[Design], named: Labels, links: Sequence[str] = ()) -> str:
    """Return the front by the first two objectives; its points are links where these are given."""
    first, second = list(study.goals)[:2]
    values = np.array([[design.results[goal] for design in designs] for goal in (first, second)])
    labels = heading(first, named), heading(second, named)
    return front_picture(study.title, labels, names_of(designs), values, links)


def names_of(designs: Sequence[Design]) -> list[str]:
    """Return the labels of points: the place in the table, and the chosen words that differ."""
    texts = [{key: value for key, value in design.entries.items() if isinstance(value, str)} for design in designs]
    differing = [key for key in texts[0] if len({entered.get(key) for entered in texts}) > 1]
    words = [", ".join(str(text[key]) for key in differing if key in text) for text in texts]
    return [f"{place}  {text}".rstrip() for place, text in enumerate(words, 1)]


def heading(name: str, named: Mapping[str, Label]) -> str:
    """Return a result's name with what it is called and its unit."""
    label = named[name]
    return f"{name}: {label.words}" + (f" [{label.unit}]" if label.unit else "")


def varied_words(row: Dimension) -> str:
    """Return over what something varied."""
    words = f"{row.low:g} to {row.high:g}" + (f" in {row.steps} values" if row.steps else "")
    words = ", ".join(map(figure, row.values[:MOST])) if row.values else words
    return words + (f"; its room from {spell(row.takes)}" if row.takes else "")


def judged_line(judged: BookCheck) -> str:
    """Return whether the book of a design says what the study states."""
    if judged.differing:
        return f"The book of the design differs from the study: {', '.join(judged.differing)}."
    cells = f"{judged.cells:,} formula cells {'agree' if judged.agrees else 'DISAGREE'}"
    line = f"The book of the design: {cells}; its results are the study's to {judged.deviation:.1e}."
    return line + (f" Its checks that FAIL: {', '.join(judged.failing)}." if judged.failing else "")
