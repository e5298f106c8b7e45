"""The page Study: choose what varies, follow the work, open the designs of the front."""

from pathlib import Path
from xml.etree.ElementTree import Element

from workbook.build import write_text
from workbook.cluster import cores
from workbook.reports.html import Content, e, markup, table
from workbook.serve import pages, studied
from workbook.serve.handler import Page
from workbook.serve.jobs import Job
from workbook.studies.folder import progress
from workbook.studies.named import Label

ROWS = 6
"""results that a form can ask for"""


class Vary(Page):
    """The form of a study of a description."""

    async def get(self, name: str) -> None:
        """Show it."""
        path = self.folder.file(name)
        tables = await self.work.beside(studied.fields, path)
        results = await self.work.beside(studied.results, path)
        self.finish(form(name, tables, results))


class NewStudy(Page):
    """A study, written and begun."""

    async def post(self) -> None:
        """Write it under a name that is free, begin it and follow it."""
        base = self.folder.file(self.argument("name"))
        asked = {key: self.get_body_arguments(key) for key in self.request.body_arguments}
        sent = {key: self.get_body_arguments(key) for key in ("result", "what", "value", "key", "values", "takes")}
        text = studied.composed(base.name, asked | sent)
        await self.work.beside(studied.require_study, text, base)
        path = self.folder.free(f"{base.stem}-study.toml")
        write_text(path, text)
        await begin(self, path)


class Begin(Page):
    """A study that is there."""

    async def post(self) -> None:
        """Begin it, or go on with it."""
        await begin(self, self.folder.file(self.argument("name")))


class Cancel(Page):
    """A study at work."""

    def post(self) -> None:
        """Interrupt it."""
        name = self.folder.file(self.argument("name")).name
        job = self.work.jobs.get(name)
        if job is not None:
            job.interrupt()
        self.redirect(f"/study/{name}")


class Study(Page):
    """A study: at work, or what came of it."""

    def get(self, name: str) -> None:
        """Show it; the script fetches how far it is."""
        base = studied.base_of(self.folder.file(name))
        above = [pages.back(), e("p", pages.link(f"/edit/{base}", f"Edit {base}"))] if base else [pages.back()]
        panel = e("div", e("p", "…", css="quiet"), id="study", **{"data-name": name})
        self.finish(pages.page(name, [e("h1", name), *above, panel], "study"))


class Progress(Page):
    """How far a study is."""

    async def get(self, name: str) -> None:
        """Answer with the rate and what remains, the front when it is done, or what there is to begin."""
        path = self.folder.file(name)
        job, table = self.work.jobs.get(path.name), path.with_suffix(".csv")
        if job is not None and job.code is None:
            self.finish(markup(working(path.name, *progress(table), job)))
        elif path.with_suffix(".json").exists():
            found = await self.work.beside(studied.front, path, path.with_suffix(".json"))
            self.finish(found + markup(pages.link(f"/file/{table.name}", "Download all designs")))
        else:
            self.finish(markup(*waiting(path.name, *progress(table), job.text if job else "")))


def working(name: str, done: int, size: int, job: Job) -> Element:
    """Return how far a study is that is at work, and what cancels it."""
    rate = (done - job.before) / max(job.seconds, 1.0)
    bar = e("progress", value=str(done), max=str(max(size, 1)))
    words = f"{done:,} of {size:,} designs, {rate:,.1f}/s" if size else "Measuring how long a design takes …"
    return e("div", e("p", bar, f" {words}"), pages.post("/cancel", name, "Cancel"), **{"data-running": "yes"})


def waiting(name: str, done: int, size: int, printed: str) -> list[Element]:
    """Return how far a study is that is not at work, and what begins it or goes on with it."""
    words = f"{done:,} of {size:,} designs are worked out." if size else "No design is worked out."
    said = [e("pre", printed)] if printed else []
    return [e("p", words), pages.post("/begin", name, "Go on" if size else "Begin"), *said]


async def begin(page: Page, path: Path) -> None:
    """Begin a study, or go on with it, on all cores but one, and follow it."""
    table = path.with_suffix(".csv")
    done, size = progress(table)
    more = ["--resume"] if size else []
    jobs = str(max(1, cores() - 1))
    await page.work.jobs.begin(path.name, done, "study", path, "-o", table, "--jobs", jobs, *more)
    page.redirect(f"/study/{path.name}")


def form(name: str, tables: dict[str, list[studied.Field]], results: list[tuple[str, Label]]) -> str:
    """Return the page of what can vary in a description, and of the results to ask for."""
    asked = [e("p", e("label", "Result ", field("result", list="results"), " "), e("label", select(), " "),
               e("label", "bound ", field("value", size="8"))) for _ in range(ROWS)]  # fmt: skip
    options = [e("option", f"{label.words}" + (f" [{label.unit}]" if label.unit else ""), value=key)
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


def select() -> Element:
    """Return what can be asked of a result."""
    words = {"minimise": "minimise", "maximise": "maximise", "results": "keep", "at least": "at least",
             "at most": "at most", "off": "no constraint"}  # fmt: skip
    return e("select", *(e("option", said, value=key) for key, said in words.items()), name="what",
             **{"aria-label": "What is asked of it"})  # fmt: skip
