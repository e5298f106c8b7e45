"""A study as one page of HTML: the front, the best designs, what was fixed, what excludes the others."""

import platform
import re
from collections.abc import Mapping
from datetime import datetime
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np

import workbook
from workbook.reports.html import Content, document, e, table
from workbook.reports.plot import Point, front_picture
from workbook.studies.judged import Judged
from workbook.studies.model import Study
from workbook.studies.named import Label, Named
from workbook.studies.paths import leaves, written
from workbook.studies.plan import Plan
from workbook.studies.space import Dimension
from workbook.studies.summary import Design, Summary

MOST = 200  # designs that the page lists


def page(plan: Plan, found: Summary, named: Named, judged: Judged | None, when: datetime) -> str:
    """Return the page."""
    study = plan.study
    versions = (f"{when:%Y-%m-%d %H:%M:%S %z}, motionbook {workbook.__version__}, Python {platform.python_version()}, "
                f"NumPy {np.__version__}; {study.way.kind}, seed {study.way.seed}")  # fmt: skip
    body = [e("h1", study.title), e("p", versions, css="quiet"), *counts(found)]
    if judged:
        body.append(e("p", judged_line(judged), css="agrees" if judged.holds else "disagrees"))
    body += best(plan, found, named)
    body += [e("h2", "What varied"), table(("entry", "values"), [varied(one) for one in plan.space.dimensions], ())]
    body += constraints(plan, found, named)
    if found.reasons:
        rows = [[reason, f"{count:,}"] for reason, count in found.reasons.items()]
        body += [e("h2", "Why designs are impossible"), table(("reason", "designs"), rows, (1,))]
    paths = {".".join(path) for one in plan.space.dimensions for path in one.paths}
    data = plan.base.model_dump(exclude_none=True, exclude={"selection", "sizes", "laws"})
    fixed = [[written(key.split(".")), figure(value)] for key, value in leaves(data) if key not in paths]
    body += [e("h2", "What was fixed"), table(("entry", "value"), fixed, ())]
    return document(study.title, body)


def counts(found: Summary) -> list[Element]:
    """Return in lines how many designs there are, and how many of them cannot be ranked."""
    said = f"{found.designs:,} designs, {found.feasible:,} feasible, {found.impossible:,} impossible."
    return [e("p", line) for line in (said, *unranked(found))]


def constraints(plan: Plan, found: Summary, named: Named) -> list[Element]:
    """Return the table of what excludes designs, and in words what does not."""
    rows = [[heading(name, named), bounds, f"{count:,}", f"{alone:,}"]
            for name, bounds, count, alone in excluding(plan, found)]  # fmt: skip
    said = [e("h2", "Constraints"), table(("result", "bounds", "excludes", "of these alone"), rows, (2, 3))]
    idle = [name for name, count in found.excluded.items() if not count and name not in plan.bounds]
    if idle:
        said.append(e("p", f"Checks of the book that exclude none: {', '.join(idle)}."))
    if plan.study.off:
        said.append(e("p", f"Switched off: {', '.join(plan.study.off)}."))
    return said


def excluding(plan: Plan, found: Summary) -> list[tuple[str, str, int, int]]:
    """Return constraints, bounds in words, and how many designs each excludes, and alone: first those that are told."""
    counts = {name: found.excluded.get(name, 0) for name in plan.bounds}
    checks = sorted(found.excluded.items(), key=lambda one: -one[1])
    counts |= {name: count for name, count in checks if count and name not in counts}
    said = {name: bound if isinstance(bound, str) else bound.words for name, bound in plan.bounds.items()}
    return [(name, said.get(name, "OK"), count, found.alone.get(name, 0)) for name, count in counts.items()]


def unranked(found: Summary) -> list[str]:
    """Return in a line how many feasible designs have no place among the best since they lack an objective's value."""
    if not found.unranked:
        return []
    lacks = [f"{name} has no value in {count:,}" for name, count in found.without.items() if count]
    return [f"{found.unranked:,} of {found.feasible:,} feasible designs cannot be ranked: {', '.join(lacks)}"]


def best(plan: Plan, found: Summary, named: Named) -> list[Element]:
    """Return picture and table of the best designs."""
    if not found.best:
        return [e("p", "No design is feasible." if not found.feasible else "No objective was told.")]
    shown = found.best[:MOST]
    said = [e("h2", "The best" if len(plan.study.goals) == 1 else "The front: no other design beats these")]
    if len(plan.study.goals) > 1:
        said.append(picture(plan.study, shown, named))
    entries = [one.label for one in plan.space.dimensions]
    names = list(dict.fromkeys([*plan.study.goals, *plan.study.names]))
    heads: list[Content] = ["", "design", *map(parted, entries), *(parted(heading(name, named)) for name in names)]
    rows = [[str(place), f"{one.number + 1}", *(figure(one.entries[name]) for name in entries),
             *(figure(one.results[name]) for name in names)] for place, one in enumerate(shown, 1)]  # fmt: skip
    values = [*shown[0].entries.values(), *(shown[0].results[name] for name in names)]
    numbers = tuple(k for k, value in enumerate(values, 2) if not isinstance(value, str))
    made = table(heads, rows, (1, *numbers))
    made.set("class", "wide")
    return [*said, e("div", made, css="wide")]


def parted(words: str) -> Element:
    """Return a heading that may go on in a new line behind the parts of a name."""
    pieces = re.split(r"(?<=[._\]])", words)
    return e("span", pieces[0], *(part for piece in pieces[1:] for part in (e("wbr"), piece)))


def picture(study: Study, designs: list[Design], named: Named) -> Element:
    """Return the front by the first two objectives."""
    first, second = list(study.goals)[:2]
    points = [Point(name, str(place), one.results[first], one.results[second])
              for place, (name, one) in enumerate(zip(names_of(designs), designs, strict=True), 1)]  # fmt: skip
    return front_picture(study.title, (heading(first, named), heading(second, named)), points)


def names_of(designs: list[Design]) -> list[str]:
    """Return what stands beside points: the place in the table, and of what was chosen in words what differs."""
    texts = [{key: value for key, value in one.entries.items() if isinstance(value, str)} for one in designs]
    differing = [key for key in texts[0] if len({one.get(key) for one in texts}) > 1]
    words = [", ".join(str(one[key]) for key in differing if key in one) for one in texts]
    return [f"{place}  {said}".rstrip() for place, said in enumerate(words, 1)]


def heading(name: str, named: Mapping[str, Label]) -> str:
    """Return a result's name with what it is called and its unit."""
    label = named[name]
    return f"{name}: {label.words}" + (f" [{label.unit}]" if label.unit else "")


def varied(one: Dimension) -> list[Element | str]:
    """Return what is said of something that varied."""
    if one.values:
        said = ", ".join(map(figure, one.values[:MOST]))
    else:
        said = f"{one.low:g} to {one.high:g}" + (f" in {one.steps} values" if one.steps else "")
    room = f"; its room from {written(one.takes)}" if one.takes else ""
    return [", ".join([one.label, *map(written, one.paths[1:])]), said + room]


def judged_line(judged: Judged) -> str:
    """Return whether the book of a design says what the study said."""
    if judged.differing:
        return f"The book of the design differs from the study: {', '.join(judged.differing)}."
    cells = f"{judged.cells:,} formula cells {'agree' if judged.agrees else 'DISAGREE'}"
    said = f"The book of the design: {cells}; its results are the study's to {judged.deviation:.1e}."
    return said + (f" Its checks that FAIL: {', '.join(judged.failing)}." if judged.failing else "")


def figure(value: Any) -> str:
    """Return a value as it is shown."""
    if isinstance(value, float):
        return "–" if value != value else f"{value:.6g}"
    return str(value)
