"""What the page Study shows: entries that can vary, results to ask for, the front with links to its designs."""

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

import tomli_w
from pydantic import ValidationError

from workbook.build import described
from workbook.commands.study import known
from workbook.entries.design import as_entered
from workbook.entries.machine import Machine
from workbook.errors import InputError, MotionbookError, ReadError
from workbook.intake import read_text
from workbook.laws.entries import ENTRIES, references
from workbook.reading.descriptions import parsed, template_named, write_machine
from workbook.reports import study as page
from workbook.reports.html import e, markup
from workbook.serve.toml import differing, edited
from workbook.studies.judged import machine_of
from workbook.studies.model import Study
from workbook.studies.named import Label, listed, require_names
from workbook.studies.paths import held, leaves, written
from workbook.studies.plan import EDGES, PRODUCTS, Plan, lines_of, planned, read_study
from workbook.studies.summary import Summary

RANGE = re.compile(r"(\S+) to (\S+?)(?: in (\d+))?")
ALL, LAWS, CATALOGUE = "all", "laws", "catalogue"
SHARE, STEPS = 0.1, 5
"""of a number, to either side, and in so many values: what is proposed"""
GOALS = ("minimise", "maximise", "results")
BOUNDS = {"at least": "min", "at most": "max"}
OFF = "off"


class Field(NamedTuple):
    """An entry that can vary: its key, its value now, over what it is proposed to vary.

    ``known`` are the words that it may be, ``givers`` the phases that can give the room that this one takes.
    """

    key: str
    now: str
    over: str
    known: list[str]
    givers: list[str]


def choices(base: Path) -> tuple[dict[str, list[Field]], list[tuple[str, Label]]]:
    """Return the entries that can vary by their tables, and the results that may be asked for, fast ones first."""
    machine: Any = described(base)
    data = machine.model_dump(exclude_none=True, exclude={"selection", "sizes", "laws", "template", "title"})
    words = {one.key: [*dict.fromkeys([*machine.laws.names, *ENTRIES])] for one in references(machine)}
    tables: dict[str, list[Field]] = {}
    for key, value in leaves(data, PRODUCTS):
        *above, last = key.split(".")
        if last == "name" and above and above[-1] in PRODUCTS:
            words[key] = [one.name for one in getattr(machine.selection, PRODUCTS[above[-1]])]
        if isinstance(value, float) or key in words:
            known, over = [ALL, *words[key]] if key in words else [], ALL
            if not known:
                low, high = sorted((value * (1.0 - SHARE), value * (1.0 + SHARE)))
                over = f"{low:.6g} to {high:.6g} in {STEPS}" if value else ""
            rows = len(held(data, above[:-1])) if last in EDGES and above[-1].isdigit() else 0
            givers = [written([*above[:-1], str(k)]) for k in range(rows) if str(k) != above[-1]]
            row = Field(written([*above, last]), page.figure(value), over, known, givers)
            named = data[above[0]][int(above[1])].get("name", "") if above[1:] and above[1].isdigit() else ""
            tables.setdefault(f"{written(above)} {named}".strip(), []).append(row)
    return tables, [one for _, names in listed(machine) for one in names]


def base_of(path: Path) -> str:
    """Return the name of the description that a study begins with; nothing where the study does not tell it."""
    try:
        return str(parsed(read_text(path, "a study, a .toml file"), path).get("base", ""))
    except MotionbookError:
        return ""


def composed(base: str, asked: Mapping[str, list[str]]) -> str:
    """Return the text of a study of what a form asks for, lists of texts by the names of its fields."""
    study: dict[str, Any] = {"title": f"Study of {Path(base).stem}", "base": base}
    constraints: dict[str, Any] = {}
    for name, what, value in zip(asked["result"], asked["what"], asked["value"], strict=True):
        if name and what in GOALS:
            study.setdefault(what, []).append(name)
        elif name and what in BOUNDS:
            constraints.setdefault(name, {})[BOUNDS[what]] = value_of(value)
        elif name:
            constraints[name] = what
    study |= {"constraints": constraints} if constraints else {}
    kind = asked["way"][0]
    study["way"] = {"kind": kind} | ({} if kind == "full" else {"designs": int(value_of(asked["designs"][0]))})
    values = dict(zip(asked["key"], asked["values"], strict=True))
    givers = {key: {"takes": phase} for key, phase in zip(asked["key"], asked.get("takes", []), strict=False) if phase}
    study["vary"] = [{"key": key} | varied(key, values[key]) | givers.get(key, {}) for key in asked.get("vary", [])]
    return tomli_w.dumps(study)


def varied(key: str, text: str) -> dict[str, Any]:
    """Return what an entry varies over: ``80 to 100 in 5``, values with commas between, or all."""
    text = text.strip()
    if text == ALL:
        return {"all": CATALOGUE if key.endswith(".name") else LAWS}
    if span := RANGE.fullmatch(text):
        ends = {"from": value_of(span[1]), "to": value_of(span[2])}
        return ends | ({"steps": int(span[3])} if span[3] else {})
    return {"values": [value_of(one.strip(), or_text=True) for one in text.split(",") if one.strip()]}


def value_of(text: str, or_text: bool = False) -> Any:
    """Return the number that a text is; of another one, it as it is where that may be, else raise InputError."""
    try:
        return float(text)
    except ValueError:
        if or_text:
            return text
        raise InputError([f"{text!r}: expected a number"]) from None


def require_study(text: str, base: Path) -> None:
    """Raise InputError for a study that asks for what there is not."""
    try:
        study = Study.model_validate(tomllib.loads(text))
    except ValidationError as error:
        raise InputError(lines_of(error, "study")) from None
    require_names(planned(study, base, "study"), "study")


def front(path: Path) -> str:
    """Return the HTML of what came of a study; each of the best designs is a link to its description."""
    plan, found = found_in(path)
    named = require_names(plan, str(path))
    links = [f"/edit/{plan.study.base}?study={path.name}&pick={n}" for n in range(1, len(found.best) + 1)]
    return markup(*page.counts(found), *linked(page.best(plan, found, named), links),
                  *page.constraints(plan, found, named))  # fmt: skip


def found_in(path: Path) -> tuple[Plan, Summary]:
    """Return a study and what is known of it; raise ReadError where these do not go together."""
    plan, results = read_study(path), path.with_suffix(".json")
    found = known(plan, results, own=True)
    if found is None:
        raise ReadError(f"{results.name}: results of this study before it or its machine was changed; delete them")
    return plan, found


def linked(said: list[Element], links: list[str]) -> list[Element]:
    """Return picture and table of the best designs, the points and the places in the table as links."""
    for one in said:
        points = [child for child in one if child.tag == "circle"]
        if points:
            one.set("role", "group")  # a picture by itself may have no links in it
        for point, link in zip(points, links, strict=False):
            at = list(one).index(point)
            one.remove(point)
            anchor = Element("a", {"href": link, "aria-label": f"Open design {links.index(link) + 1}"})
            anchor.append(point)
            one.insert(at, anchor)
        for row, link in zip(one.findall(".//tbody/tr"), links, strict=False):
            cell = row[0]
            cell.append(e("a", cell.text or "", href=link))
            cell.text = None
    return said


def picked(path: Path, number: int) -> str:
    """Return the description of one of the best designs of a study: the text of its base with other entries."""
    plan, found = found_in(path)
    if not 1 <= number <= len(found.best):
        raise InputError([f"design {number}: expected 1 to {len(found.best)}"])
    machine: Machine = machine_of(plan, found.best[number - 1])
    base = path.parent / str(plan.study.base)
    text = read_text(base, "a machine description, a .toml file")
    try:
        changed = edited(text, differing(as_entered(plan.base), as_entered(machine)))
        template = template_named(plan.base.template, "template")
        if template.model_for(data := parsed(changed, base)).model_validate(data) == machine:
            return changed
    except (MotionbookError, ValidationError):
        pass
    return write_machine(machine)
