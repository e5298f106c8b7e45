"""The first page: designs with their books and studies, what each comes to; new ones, and what is done with files."""

import re
from datetime import datetime
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import tomlkit

from workbook.book.chart import COLOURS
from workbook.book.rows import is_number
from workbook.errors import MotionbookError, WriteError
from workbook.file_cache import load_cached, store_cached
from workbook.reports.html import path as places
from workbook.reports.html import render, scale
from workbook.serve import pages, shown
from workbook.serve.editing import draft_of
from workbook.serve.handler import BRIEF, JSON, JUDGED, Page, state
from workbook.serve.parts import TURN, new_axis
from workbook.serve.work import NOT_WRITTEN
from workbook.text_files import read_text
from workbook.writing.output_files import write_text

BIN = ".bin"  # of a folder: what was deleted on the first page
# of the small picture, as in brief.html, and how many points a line has
WIDTH, HEIGHT, POINTS = 300, 100, 90
FIRST = 3  # results in a line
RATE = 60.0  # cycles/min of an empty machine


class Group(NamedTuple):
    """A design, if there is one, and the books and studies of it."""

    title: str
    design: pages.Item | None
    others: list[pages.Item]


def groups_of_files(files: list[Path]) -> list[Group]:
    """Return the files of a folder: each design with its books and studies, what has none under its own title."""
    items = [pages.item(path) for path in files]
    designs = [each for each in items if each.path.suffix.lower() == ".toml" and not each.base]
    groups = {each.path.name: Group(each.title, each, []) for each in designs}
    for each in items:
        if each not in designs:
            owner = owner_of(each, designs)
            key = owner.path.name if owner else f"/{each.title}"  # no name of a file
            groups.setdefault(key, Group(each.title, None, [])).others.append(each)
    return sorted(groups.values(), key=lambda group: group.title.casefold())


def owner_of(file: pages.Item, designs: list[pages.Item]) -> pages.Item | None:
    """Return the design that a book or a study is of: by the name of its file, else by its title."""
    if file.base:
        return next((each for each in designs if each.path.name == file.base), None)
    named = [each for each in designs if re.fullmatch(rf"{re.escape(each.path.stem)}(-\d+)?", file.path.stem)]
    titled = [each for each in designs if each.title == file.title]
    return named[-1] if named else titled[0] if len(titled) == 1 else None


async def home(page: Page) -> str:
    """Show the folder's machines with what is known of them, a new machine, an upload, a comparison."""
    files = page.folder.files()
    deleted = page.folder.path / BIN
    return pages.page(
        "motionbook",
        "home",
        at_home=True,
        do=(pages.link("#compare", "Compare"), pages.link("#verify", "Verify"), pages.link("#new", "New machine")),
        folder=page.folder.path,
        groups=groups_of_files(files),
        names=[path.name for path in files],
        waiting=page.work.waiting,
        bin=len([*deleted.iterdir()]) if deleted.is_dir() else 0,
        brief=lambda path: load_cached(BRIEF, state(path)),
        verdict_on=lambda path: (load_cached(JUDGED, state(path)) or {}).get("verdict"),
    )


async def brief(page: Page, name: str) -> str:
    """Send what a description comes to, for the first page; it is kept by the contents of the file."""
    path = page.folder.file(name)
    digest, text = state(path), read_text(path, "a description")
    known = load_cached(BRIEF, digest)
    if known is None:
        known = await page.work.in_worker(summary, name, text, slow=True)
        store_cached(BRIEF, digest, known)
    return render("serve/brief.html", known=known)


def summary(name: str, text: str) -> dict[str, Any]:
    """Return the first results of a description, its verdict in words, and the lines of a small picture."""
    try:
        design = shown.design(name, text)
    except MotionbookError as error:
        first, *more = str(error).splitlines()
        words = f"{len(more)} to complete" if more else "to complete"
        return {"results": more[0] if more else first, "state": "unfinished", "verdict": words, "lines": []}
    results = [f"{result.label} {shown.short(result.value)} {result.unit}".rstrip()
               for result in design.summary.values() if not result.place and is_number(result.value)]  # fmt: skip
    fails, checks = len(shown.failing(design)), len(design.checks())
    verdict, state = (f"{fails} of {checks} checks FAIL", "fails") if fails else (f"{checks} checks OK", "agrees")
    if design.machine.design.faults:
        verdict, state = f"{fails} to complete", "unfinished"
    return {"results": "; ".join(results[:FIRST]), "state": state, "verdict": verdict, "lines": lines_of(design)}


def lines_of(design: shown.ShownDesign) -> list[tuple[str, str]]:
    """Return the lines of a design's first chart as points of a small picture, each with its colour."""
    _, lines = next(iter(design.charts), (None, []))
    if not lines:
        return []
    across, up = (
        scale(np.concatenate([getattr(line, name) for line in lines]), begin, end, powers=False)
        for name, begin, end in (("x", 0.0, WIDTH), ("y", HEIGHT - 2.0, 2.0))
    )
    few = [slice(None, None, max(1, len(line.x) // POINTS)) for line in lines]
    return [(places(across.at(line.x[part]), up.at(line.y[part])), COLOURS[k % len(COLOURS)])
            for k, (line, part) in enumerate(zip(lines, few, strict=True))]  # fmt: skip


def design_of(page: Page, *paths: Path) -> str:
    """Return the name of the design that the first of some files is, or is of; empty where the folder has none."""
    groups = groups_of_files(page.folder.files())
    of = {each.path: group.design for group in groups for each in (group.design, *group.others) if each}
    return next((own.path.name for path in paths if (own := of.get(path))), "")


async def build(page: Page) -> str | dict[str, Any]:
    """Build the book of a description, or its own book anew with what an engineer added; tell what fails."""
    path = page.file()
    book, options = path.with_suffix(".xlsx"), list[str | Path]()
    page.folder.free(book.name, own=book)
    if book.exists():
        options, before = ["--keep", book, "--force"], book.read_bytes()
    done = await page.run("build", path, "-o", book, *options)
    if options and done.written != NOT_WRITTEN and pages.was_saved(before):
        place_in_bin(book).write_bytes(before)
    if page.request.headers.get("Accept") == JSON:
        return {"book": book.name, "code": done.code, "words": done.text, "written": done.written}
    return pages.printout(path.name, done.text, done.written, path, *filter(Path.exists, [book]))


def place_in_bin(path: Path) -> Path:
    """Return the place for a file in the bin of its folder, by the time."""
    path.parent.joinpath(BIN).mkdir(exist_ok=True)
    return path.parent / BIN / f"{datetime.now():%Y-%m-%d %H-%M-%S} {path.name}"


async def keep(page: Page) -> None:
    """Duplicate or rename a file of the folder, under a name that is free, or move it into the folder's bin."""
    path, do = page.file(), page.get_body_argument("do")
    draft = draft_of(path)
    if do == "duplicate":
        page.folder.free(page.get_body_argument("as"), path.suffix).write_bytes(path.read_bytes())
    elif do == "rename":
        target = page.folder.free(page.get_body_argument("as"), path.suffix, path)
        path.rename(target)
        if draft.exists():
            draft.rename(draft_of(target))
    elif do == "delete":
        for file in filter(Path.exists, (path, draft)):
            file.rename(place_in_bin(file))
    else:
        raise WriteError(f"{do!r}: expected duplicate, rename or delete")
    page.redirect("/")


async def download(page: Page, name: str) -> bytes:
    """Send a file of the folder."""
    page.set_header("Content-Type", "application/octet-stream")
    page.set_header("Content-Disposition", "attachment")
    return page.folder.file(name).read_bytes()


async def new(page: Page) -> str | None:
    """Write a new description, of a template or of an empty machine with an axis, and edit it."""
    name, template = page.get_body_argument("name"), page.get_body_argument("template")
    path = page.folder.free(name, ".toml")
    if template:
        return await page.write_by("new", template, path)
    empty = {"template": "machine", "title": name, "master": {"rate": RATE}}
    write_text(path, tomlkit.dumps(empty | {"axes": [new_axis(page.get_body_argument("axis"), TURN)]}))
    page.redirect(pages.address("edit", path.name))
    return None
