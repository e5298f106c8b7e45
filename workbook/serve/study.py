"""The page Study: choose what varies, follow the work, open the designs of the front."""

import time
from pathlib import Path
from xml.etree.ElementTree import Element

from workbook.build import write_text
from workbook.pool import cores
from workbook.reports.html import Content, e, markup, table
from workbook.serve import pages, studied
from workbook.serve.handler import Page
from workbook.serve.work import Job
from workbook.studies import folder
from workbook.studies.named import Label

ROWS = 6  # results that a form can ask for
ASKED = {"minimise": "minimise", "maximise": "maximise", "results": "keep", "at least": "at least",
         "at most": "at most", "off": "no constraint"}  # fmt: skip
"""what can be asked of a result, with its words in the form"""
SENT = ("result", "what", "value", "key", "values", "takes")  # the fields of a form that stand in several rows


async def vary(page: Page, name: str) -> str:
    """Show the form of a study of a description."""
    path = page.folder.file(name)
    return form(name, *await page.work.beside(studied.choices, path))


async def new(page: Page) -> None:
    """Write a study under a name that is free, begin it and follow it."""
    base = page.file()
    asked = {key: page.get_body_arguments(key) for key in (*page.request.body_arguments, *SENT)}
    text = studied.composed(base.name, asked)
    await page.work.beside(studied.require_study, text, base)
    path = page.folder.free(f"{base.stem}-study.toml")
    write_text(path, text)
    await begin(page, path)


async def go_on(page: Page) -> None:
    """Begin a study that is there, or go on with it."""
    await begin(page, page.file())


async def begin(page: Page, path: Path) -> None:
    """Begin a study, or go on with it, on all cores but one, and follow it."""
    results = path.with_suffix(".csv")
    done, size = folder.progress(results)
    more = ["--resume"] if size else []
    await page.work.study(path, done, "-o", results, "--jobs", str(max(1, cores() - 1)), *more)
    page.redirect(f"/study/{path.name}")


async def cancel(page: Page) -> None:
    """Interrupt a study at work."""
    name = page.file().name
    if name in page.work.jobs:
        page.work.jobs[name].interrupt()
    page.redirect(f"/study/{name}")


async def show(page: Page, name: str) -> str:
    """Show a study; the script fetches how far it is."""
    base = studied.base_of(page.folder.file(name))
    above = [pages.back(), e("p", pages.link(f"/edit/{base}", f"Edit {base}"))] if base else [pages.back()]
    panel = e("div", e("p", "…", css="quiet"), id="study", **{"data-name": name})
    return pages.page(name, [e("h1", name), *above, panel], "study")


async def progress(page: Page, name: str) -> str:
    """Return the rate of a study and what remains, the front when it is done, or what there is to begin."""
    path = page.folder.file(name)
    job, results = page.work.jobs.get(path.name), path.with_suffix(".csv")
    if job is not None and job.done is None:
        return markup(working(path.name, *folder.progress(results), job))
    if path.with_suffix(".json").exists():
        found = await page.work.beside(studied.front, path)
        return found + markup(pages.link(f"/file/{results.name}", "Download all designs"))
    done, size = folder.progress(results)
    words = f"{done:,} of {size:,} designs are worked out." if size else "No design is worked out."
    said = [e("pre", job.done.text)] if job and job.done and job.done.text else []
    return markup(e("p", words), pages.post("/begin", path.name, "Go on" if size else "Begin"), *said)


def working(name: str, done: int, size: int, job: Job) -> Element:
    """Return how far a study is that is at work, and what cancels it."""
    rate = (done - job.before) / max(time.monotonic() - job.begun, 1.0)
    bar = e("progress", value=str(done), max=str(max(size, 1)))
    words = f"{done:,} of {size:,} designs, {rate:,.1f}/s" if size else "Measuring how long a design takes …"
    return e("div", e("p", bar, f" {words}"), pages.post("/cancel", name, "Cancel"), **{"data-running": "yes"})


def form(name: str, tables: dict[str, list[studied.Field]], results: list[tuple[str, Label]]) -> str:
    """Return the page of what can vary in a description, and of the results to ask for."""
    what = e("select", *(e("option", said, value=key) for key, said in ASKED.items()), name="what",
             **{"aria-label": "What is asked of it"})  # fmt: skip
    asked = [e("p", e("label", "Result ", field("result", list="results"), " "), e("label", what, " "),
               e("label", "bound ", field("value", size="8"))) for _ in range(ROWS)]  # fmt: skip
    options = [e("option", label.words + (f" [{label.unit}]" if label.unit else ""), value=key)
               for key, label in results]  # fmt: skip
    ways = pages.choice("way", ("full", "sobol", "evolution"))
    body = [
        e("h1", f"{name}: study"), pages.back(), e("p", pages.link(f"/edit/{name}", f"Edit {name}")),
        e("p", "Tick what varies, and say over which values: 80 to 100 in 5, or 80, 90, 100, or all (laws, products). "
               "A design is feasible where its book has no FAIL and its results keep to the constraints."),
        pages.form("/study", pages.hidden("name", name), e("h2", "Best, and constraints"), *asked,
                   e("datalist", *options, id="results"),
                   e("p", pages.label("Designs:", "way"), ways, pages.label(" not in full, how many", "designs"),
                     e("input", type="number", name="designs", id="designs", value="1000", min="1")),
                   e("h2", "What varies"), *(varying(*one) for one in tables.items()),
                   e("p", pages.button("Begin"))),
    ]  # fmt: skip
    return pages.page(f"{name}: study", body)


def varying(path: str, rows: list[studied.Field]) -> Element:
    """Return the entries of a table that can vary."""
    lines: list[list[Content]] = []
    for one in rows:
        tick = e("label", e("input", type="checkbox", name="vary", value=one.key), f" {one.key.rpartition('.')[2]}")
        listed = e("datalist", *(e("option", value=word) for word in one.known), id=f"list-{one.key}")
        over = field("values", value=one.over, list=f"list-{one.key}", **{"aria-label": f"{one.key}: values"})
        givers = e("select", e("option", "–", value=""), *(e("option", phase, value=phase) for phase in one.givers),
                   name="takes", **{"aria-label": f"{one.key}: takes its room from"})  # fmt: skip
        room = givers if one.givers else pages.hidden("takes", "")
        lines.append([tick, one.now, e("span", pages.hidden("key", one.key), over, listed), room])
    last = "Takes its room from" if any(one.givers for one in rows) else ""
    return e("details", e("summary", path or "The machine"), table(("Entry", "Now", "Over", last), lines, (1,)))


def field(name: str, **attributes: str) -> Element:
    """Return a field of one line that may be empty."""
    return e("input", type="text", name=name, **attributes)
