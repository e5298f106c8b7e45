"""The page Study: choose what varies, follow the work, open the designs of the front."""

import re
import time
import tomllib
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import tomlkit
from pydantic import ValidationError

from workbook.commands.study import announce_duration, summary_from
from workbook.description.editing import edit_text
from workbook.entries.machine import Machine
from workbook.errors import InputError, MotionbookError, ReadError
from workbook.fields.paths import Place, get, join, leaves, spell, split, spread
from workbook.laws.entries import ENTRIES, references
from workbook.pool import cores
from workbook.reading.descriptions import parse_toml, read_machine, template_named, write_machine
from workbook.reports import study as reported
from workbook.reports.differences import figure
from workbook.reports.html import shown
from workbook.serve import pages
from workbook.serve.handler import Page
from workbook.serve.typed import PLAIN, number
from workbook.serve.words import spoken
from workbook.studies import folder
from workbook.studies.evaluate import Label, listed_results, require_names
from workbook.studies.plan import EDGES, PRODUCTS, Plan, lines_of, make_plan, read_study
from workbook.studies.run import machine_of, measure_pace
from workbook.studies.space import Study
from workbook.studies.summary import Summary
from workbook.text_files import read_text
from workbook.writing.output_files import write_text

OF_MACHINE = re.compile(
    r"about_(?!limits|binds|laws|held|verdict|range|first)\w+(?<!_says)(?<!_expected)|clearances\.gap\.\S+"
)
OF_DRIVE = re.compile(r"drive(\d+)_(rms|largest|speed|use_rms|use_peak|use_speed|energy|pair_mass|pair_cost|highest)")
ROWS = 6  # results that a form can ask for
ASKED = {"minimise": "minimise", "maximise": "maximise", "results": "keep", "at least": "at least",
         "at most": "at most", "off": "no constraint"}  # fmt: skip
"""what can be asked of a result, with its words in the form"""
WAYS = {"full": "all combinations", "sobol": "spread evenly", "evolution": "bred from the best"}
# the fields of a form that stand in several rows
SENT = "result what value key values takes".split()
RANGE = re.compile(r"(\S+) to (\S+?)(?: in (\d+))?")
ALL, LAWS, CATALOGUE = "all", "laws", "catalogue"
SHARE, STEPS = 0.1, 5  # of a number, to either side, and in so many values: what is proposed
GOALS = ("minimise", "maximise", "results")
BOUNDS = {"at least": "min", "at most": "max"}
value_of = partial(number, unit="", expected="a number")


async def vary(page: Page, name: str) -> str:
    """Show the form of a study of a description."""
    path = page.folder.file(name)
    picked = page.get_query_arguments("vary")
    design = pages.link(pages.address("edit", name), f"Design {name}")
    given = await page.work.in_worker(choices, path, picked)
    return pages.page(f"{name}: study", "vary", do=[design], name=name, picked=picked, **given)


async def new(page: Page) -> None:
    """Write a study under a name that is free, and show it."""
    base = page.file()
    asked = {key: page.get_body_arguments(key) for key in (*page.request.body_arguments, *SENT)}
    text = study_text(base.name, asked)
    await page.work.in_worker(require_study, text, base)
    path = page.folder.free(f"{base.stem}-study.toml")
    write_text(path, text)
    page.redirect(pages.address("study", path.name))


def study_file(page: Page, name: str) -> Path:
    """Return the file of a study; raise ReadError where its base lies outside the folder."""
    path = page.folder.file(name)
    page.folder.file(pages.item(path).base or name)
    return path


async def begin(page: Page) -> None:
    """Begin a study, or go on with it, with a core left free, and follow it."""
    path = study_file(page, page.get_body_argument("name"))
    results = path.with_suffix(".csv")
    done, size = folder.progress(results)
    more = ["--resume"] if size else []
    await page.work.study(path, done, "-o", results, "--jobs", str(max(1, cores() - 1)), *more)
    page.redirect(pages.address("study", path.name))


async def cancel(page: Page) -> None:
    """Interrupt a study at work."""
    name = page.file().name
    if name in page.work.jobs:
        page.work.jobs[name].interrupt()
    page.redirect(pages.address("study", name))


async def show(page: Page, name: str) -> str:
    """Show a study; the page fetches how far it is."""
    base = pages.item(page.folder.file(name)).base
    do = [pages.link(pages.address("edit", base), f"Design {base}")] if base else []
    return pages.page(name, "followed", do=do, follow=pages.address("progress", name))


async def progress(page: Page, name: str) -> str:
    """Return the rate of a study and what remains, the front when it is done, or what there is to begin."""
    path = study_file(page, name)
    job, results = page.work.jobs.get(path.name), path.with_suffix(".csv")
    if job is not None and job.done is None:
        done, size = folder.progress(results)
        rate = (done - job.before) / max(time.monotonic() - job.begun, 1.0)
        words = f"{done:,} of {size:,} designs, {rate:,.1f}/s" if size else "Measuring how long a design takes …"
        bar = f'<p><progress value="{done}" max="{max(size, 1)}"></progress> {words}</p>'
        return f"<div data-again>{bar}{pages.post('/cancel', path.name, 'Cancel')}</div>"
    if path.with_suffix(".json").exists():
        front_page = await page.work.in_worker(front, path)
        return front_page + pages.link(pages.address("file", results.name), "Download all designs")
    done, size = folder.progress(results)
    words = f"{done:,} of {size:,} designs are worked out."
    if not size:
        words = await page.work.in_worker(forecast, path, slow=True)
    output = f"<pre>{shown(job.done.text)}</pre>" if job and job.done and job.done.text else ""
    return f"<p>{words}</p>{pages.post('/begin', path.name, 'Go on' if size else 'Begin')}{output}"


def forecast(path: Path) -> str:
    """Return how many designs a study has, and how long they take."""
    plan = read_study(path)
    seconds = measure_pace(plan).seconds(plan.space)
    return " ".join(announce_duration(plan, seconds, max(1, cores() - 1))) or f"{plan.space.size:,} designs, soon done."


def choices(base: Path, picked: list[str]) -> dict[str, Any]:
    """Return the entries that can vary by their tables, results by their names, and those picked that cannot vary."""
    machine = read_machine(base)
    tables = fields_of(machine)
    known = {row["at"] for rows in tables.values() for row in rows}
    others = [spoken(split(key), machine.model_dump()) for key in picked if key not in known]
    return {"tables": tables, "results": proposed_results(machine), "others": others}


def fields_of(machine: Any) -> dict[str, list[dict[str, Any]]]:
    """Return the entries that can vary by their tables."""
    data = machine.model_dump(exclude_none=True, exclude={"selection", "sizes", "laws", "template", "title"})
    words = {reference.key: [*dict.fromkeys([*machine.laws.names, *ENTRIES])] for reference in references(machine)}
    tables: dict[str, list[dict[str, Any]]] = {}
    for part in PRODUCTS:  # a product without a name of the catalogue can be given a name
        for _, row in spread(data, ("axes", "*", part)):
            if isinstance(row, dict):
                row.setdefault("name", "")
    for path, value in leaves(data):
        (*above, last), key = path, join(path)
        if last == "name" and above and above[-1] in PRODUCTS:
            words[key] = [product.name for product in getattr(machine.selection, PRODUCTS[above[-1]])]
        if isinstance(value, float) or key in words:
            row = field_to_vary(data, path, value, words.get(key, []))
            tables.setdefault(spoken((*above,), data), []).append(row)
    return tables


def proposed_results(machine: Any) -> list[tuple[str, Label]]:
    """Return the results that are proposed, a drive's with its axis; other results are asked for by their names."""
    results = [result for _, names in listed_results(machine) for result in names]
    chosen = []
    for key, about in results:
        if match := OF_DRIVE.fullmatch(key):
            chosen.append((key, about._replace(words=f"{machine.axes[int(match[1]) - 1].name}: {about.words}")))
        elif OF_MACHINE.fullmatch(key):
            chosen.append((key, about))
    return chosen or results


def field_to_vary(data: Mapping[str, Any], path: Place, value: Any, words: list[str]) -> dict[str, Any]:
    """Return an entry as the form has it: over all its words, or a range about its value; phases beside an edge."""
    *above, last = path
    known, over = [ALL, *words] if words else [], ALL
    if not known:
        low, high = sorted((value * (1.0 - SHARE), value * (1.0 + SHARE)))
        over = f"{low:.6g} to {high:.6g} in {STEPS}" if value else ""
    rows = len(get(data, above[:-1])) if last in EDGES and above[-1].isdigit() else 0
    givers = [spell([*above[:-1], str(k)]) for k in range(rows) if str(k) != above[-1]]
    return {"key": spell(path), "at": join(path), "now": figure(value), "over": over, "known": known, "givers": givers}


def study_text(base: str, asked: Mapping[str, list[str]]) -> str:
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
    study["vary"] = [
        {"key": key} | range_of_entry(key, values[key]) | givers.get(key, {}) for key in asked.get("vary", [])
    ]
    return tomlkit.dumps(study)


def range_of_entry(key: str, text: str) -> dict[str, Any]:
    """Return the values or range of an entry: ``80 to 100 in 5``, values with commas between, or all."""
    text = text.strip()
    if text == ALL:
        return {"all": CATALOGUE if key.endswith(".name") else LAWS}
    if span := RANGE.fullmatch(text):
        ends = {"from": value_of(span[1]), "to": value_of(span[2])}
        return ends | ({"steps": int(span[3])} if span[3] else {})
    parts = [part.strip() for part in text.split(",") if part.strip()]
    return {"values": [value_of(part) if PLAIN.fullmatch(part) else part for part in parts]}


def require_study(text: str, base: Path) -> None:
    """Raise InputError for a study that asks for what there is not."""
    try:
        study = Study.model_validate(tomllib.loads(text))
    except ValidationError as error:
        raise InputError(lines_of(error, "study")) from None
    require_names(make_plan(study, base, "study"), "study")


def front(path: Path) -> str:
    """Return the HTML of a study's results; each of the best designs is a link to its description."""
    plan, summary = read_results(path)
    named = require_names(plan, str(path))
    links = [
        f"{pages.address('edit', str(plan.study.base))}?{urlencode({'study': path.name, 'pick': n})}"
        for n in range(1, len(summary.best) + 1)
    ]
    return reported.front(plan, summary, named, links)


def read_results(path: Path) -> tuple[Plan, Summary]:
    """Return a study's plan and summary; raise ReadError where these do not go together."""
    plan, results = read_study(path), path.with_suffix(".json")
    summary = summary_from(plan, results, own=True)
    if summary is None:
        raise ReadError(f"{results.name}: results of this study before it or its machine was changed; delete them")
    return plan, summary


def design_of_study(path: Path, number: int) -> str:
    """Return the description of a design among the best of a study: the text of its base with other entries."""
    plan, summary = read_results(path)
    if not 1 <= number <= len(summary.best):
        raise InputError([f"design {number}: expected 1 to {len(summary.best)}"])
    best = summary.best[number - 1]
    machine: Machine = machine_of(plan, best)
    base = path.parent / str(plan.study.base)
    text = read_text(base, "a machine description, a .toml file")
    try:
        entries = {dimension: best.entries[dimension.label] for dimension in plan.space.dimensions}
        changed = edit_text(text, plan.changes(entries).items())
        template = template_named(plan.base.template, "template")
        if template.model.model_validate(parse_toml(changed, base)) == machine:
            return changed
    except (MotionbookError, ValidationError):
        pass
    return write_machine(machine)
