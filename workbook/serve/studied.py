"""What the page Study shows: entries that can vary, results to ask for, the front with links to its designs."""

import re
import tomllib
from collections.abc import Iterator, Mapping
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
from workbook.scaling import Results
from workbook.serve.toml import differing, edited
from workbook.studies.judged import machine_of
from workbook.studies.model import Study
from workbook.studies.named import Label, listed, require_names
from workbook.studies.paths import held, written
from workbook.studies.plan import EDGES, PRODUCTS, Plan, lines_of, planned, read_study
from workbook.studies.summary import Summary
from workbook.templates import TEMPLATES

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


def fields(base: Path) -> dict[str, list[Field]]:
    """Return the entries that can vary by their tables."""
    machine: Any = described(base)
    data = machine.model_dump(exclude_none=True, exclude={"selection", "sizes", "laws", "template", "title"})
    words = {one.key: [*dict.fromkeys([*machine.laws.names, *ENTRIES])] for one in references(machine)}
    tables: dict[str, list[Field]] = {}
    for key, value in leaves(data, ""):
        *above, last = key.split(".")
        if last == "name" and above and above[-1] in PRODUCTS:
            words[key] = [one.name for one in getattr(machine.selection, PRODUCTS[above[-1]])]
        if isinstance(value, float) or key in words:
            known = [ALL, *words[key]] if key in words else []
            row = Field(written([*above, last]), page.figure(value), ALL if known else around(value), known,
                        givers(data, above) if last in EDGES else [])  # fmt: skip
            named = data[above[0]][int(above[1])].get("name", "") if above[1:] and above[1].isdigit() else ""
            tables.setdefault(f"{written(above)} {named}".strip(), []).append(row)
    return tables


def base_of(path: Path) -> str:
    """Return the name of the description that a study begins with; nothing where the study does not tell it."""
    try:
        return str(parsed(read_text(path, "a study, a .toml file"), path).get("base", ""))
    except MotionbookError:
        return ""


def givers(data: Any, phase: list[str]) -> list[str]:
    """Return the other phases beside one of a list."""
    *above, number = phase
    if not number.isdigit():
        return []
    return [written([*above, str(k)]) for k in range(len(held(data, tuple(above)))) if k != int(number)]


def around(value: float) -> str:
    """Return a range about a number, as a form has it; nothing about 0."""
    low, high = sorted((value * (1.0 - SHARE), value * (1.0 + SHARE)))
    return f"{low:.6g} to {high:.6g} in {STEPS}" if value else ""


def leaves(data: Any, key: str) -> Iterator[tuple[str, Any]]:
    """Yield what is below an entry, by keys; a motor and a reducer without a name have an empty one."""
    if isinstance(data, dict):
        named = {"name": ""} if key.rpartition(".")[2] in PRODUCTS else {}
        for name, value in {**named, **data}.items():
            yield from leaves(value, f"{key}.{name}".strip("."))
    elif isinstance(data, list):
        for k, value in enumerate(data):
            yield from leaves(value, f"{key}.{k}")
    else:
        yield key, data


def results(base: Path) -> list[tuple[str, Label]]:
    """Return the results that a study may ask for, those that are fast first, rows of a table each by itself."""
    machine = described(base)
    template = TEMPLATES[machine.template]
    usual = template.scaling.results(machine, {}) if template.scaling else Results({}, (), ())
    return [one for _, names in listed(template.declare(machine), usual) for one in names]


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
    return {"values": [value_of(one) if numeric(one) else one.strip() for one in text.split(",") if one.strip()]}


def numeric(text: str) -> bool:
    """Whether a text is a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


def value_of(text: str) -> float:
    """Return the number that a text is; raise InputError for another one."""
    if not numeric(text):
        raise InputError([f"{text!r}: expected a number"])
    return float(text)


def require_study(text: str, base: Path) -> None:
    """Raise InputError for a study that asks for what there is not."""
    try:
        study = Study.model_validate(tomllib.loads(text))
    except ValidationError as error:
        raise InputError(lines_of(error, "study")) from None
    require_names(planned(study, base, "study"), "study")


def front(path: Path, results: Path) -> str:
    """Return the HTML of what came of a study; each of the best designs is a link to its description."""
    plan, found = found_in(path, results)
    named = require_names(plan, str(path))
    counts = f"{found.designs:,} designs, {found.feasible:,} feasible, {found.impossible:,} impossible."
    links = [f"/edit/{plan.study.base}?study={path.name}&pick={n}" for n in range(1, len(found.best) + 1)]
    body = [e("p", counts), *(e("p", line) for line in page.unranked(found)),
            *linked(page.best(plan, found, named), links), *page.constraints(plan, found, named)]  # fmt: skip
    return markup(*body)


def found_in(path: Path, results: Path) -> tuple[Plan, Summary]:
    """Return a study and what is known of it; raise ReadError where these do not go together."""
    plan = read_study(path)
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


def place_of(text: str) -> int:
    """Return the place of a design among the best."""
    if not text.isdecimal():
        raise InputError([f"{text!r}: expected the place of a design"])
    return int(text)


def picked(path: Path, results: Path, number: int) -> str:
    """Return the description of one of the best designs of a study: the text of its base with other entries."""
    plan, found = found_in(path, results)
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
