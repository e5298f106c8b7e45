"""The server: addresses, and what is done at each by the commands of motionbook."""

import asyncio
import signal
import tempfile
from contextlib import suppress
from functools import lru_cache
from pathlib import Path

from workbook.build import read_inputs
from workbook.controllers.registry import STATED, TARGETS
from workbook.serve import editing, home, pages, shown, study, tables
from workbook.serve.handler import REPORT, Action, Folder, Page, state
from workbook.serve.server import STATIC, serving, static
from workbook.serve.work import Work
from workbook.templates import TEMPLATES
from workbook.text_files import read_text

MODULES = r"/\w+/(page/(?:vendor/)?[\w-]+\.(?:js|css))"
ALL = "all"
ORDERS = {"y": "position", "v": "velocity", "a": "acceleration", "j": "jerk"}


async def inputs(page: Page) -> str | None:
    """Write what is entered in a book as a description under a name that is free, and edit it."""
    path = page.file()
    return await page.write_by("inputs", path, page.folder.free(f"{path.stem}.toml"))


async def print_page(page: Page, name: str) -> str:
    """Show a description on a page to print."""
    text = read_text(page.folder.file(name), "a description")
    return pages.with_bar(await page.work.in_worker(shown.sheet, name, text, slow=True))


async def verify(page: Page) -> str:
    """Verify a workbook of the folder and return the report."""
    path = page.file()
    taken = pages.post("/inputs", path.name, "Edit what is entered")
    return await page.reported(path, taken, design=home.design_of(page, path))


async def upload(page: Page) -> str:
    """Verify a workbook from elsewhere, and delete it."""
    with page.upload("book", "upload.xlsx") as path:
        return await page.reported(path)


async def compare(page: Page) -> str:
    """Tell what differs between two files of the folder."""
    old, new = page.file("old"), page.file("new")
    done, text = await page.run_with_report("diff", old, new, "--html")
    design = home.design_of(page, new, old)
    return pages.with_bar(text, design=design) if text else pages.printout("Comparison", done.text, "")


async def controller(page: Page, name: str) -> str:
    """Show the form of an export, with the axes of the workbook."""
    path = page.folder.file(name)
    names = [*await page.work.in_worker(axes, path, state(path)), ALL]
    titles = {target: str(STATED[target]["title"]) for target in TARGETS}
    return pages.page(f"{name}: controller", "controller", name=name, axes=names, titles=titles)


async def export(page: Page) -> str:
    """Write an axis into the folder as a controller's file, under a name that is free; return its certificate."""
    book, axis = page.file(), page.get_body_argument("axis")
    options = ["--all"] if axis == ALL else ["--axis", axis]
    options += ["--equidistant"] if page.get_body_argument("equidistant", "") else []
    for order in ORDERS:
        if share := page.get_body_argument(order, ""):
            options += ["--tolerance", f"{order}={share}%"]
    with tempfile.TemporaryDirectory() as folder:
        to, points = (page.get_body_argument(name) for name in ("target", "points"))
        asked = ["--to", to, "--points", points, *options, "--report", REPORT]
        done = await page.run("export", book, *asked, folder=folder)
        report, links = "", []
        for file in sorted(Path(folder).iterdir()):
            if file.name == REPORT:
                report = file.read_text(encoding="utf-8")
                continue
            place = page.folder.free(file.name)
            with place.open("xb") as written:
                written.write(file.read_bytes())
            links.append(pages.link(pages.address("file", place.name), f"Download {place.name}"))
    return pages.with_bar(report, *links) if report else pages.printout(book.name, done.text, "not written")


async def read(page: Page) -> str:
    """Write what a controller's file holds as a description, under a name that is free, and edit it."""
    with page.upload("table", "table.txt") as table:
        target = page.folder.free(table.stem, ".toml")
        done = await page.run("read", table, "--from", page.get_body_argument("target"), "-o", target)
    if done.code:
        return pages.printout(table.name, done.text, "not read")
    return pages.printout(table.name, done.text, "read", target)


@lru_cache
def axes(book: Path, digest: str) -> list[str]:
    """Return the names of the axes of a workbook that a controller can be given; ``digest`` tells its versions."""
    machine, _ = read_inputs(book)
    return [axis.name for axis in TEMPLATES[machine.template].axes(machine)]


GET: dict[str, Action] = {
    "/": home.home, "/file/NAME": home.download, "/edit/NAME": editing.edit, "/state/NAME": editing.file_state,
    "/brief/NAME": home.brief, "/print/NAME": print_page, "/vary/NAME": study.vary,
    "/study/NAME": study.show, "/progress/NAME": study.progress, "/controller/NAME": controller, MODULES: static,
    STATIC: static,
}  # fmt: skip
EDITING = (editing.change, editing.figures, editing.products, editing.verdict, editing.gains)
KEEPING = (editing.save, home.build, home.new, home.keep)
WORKING = (verify, inputs, upload, compare, export, read, study.begin, study.cancel)
POST: dict[str, Action] = {
    **{f"/{action.__name__}": action for action in (*EDITING, *KEEPING, *WORKING)},
    "/open": editing.open_design,
    "/study": study.new,
}


async def serve(path: Path, port: int, browse: bool) -> None:
    """Serve a folder on this computer until it is interrupted, or terminated."""
    work, ended = Work(), asyncio.Event()
    with suppress(NotImplementedError):  # on Windows, which has no such signal
        asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, ended.set)
    shared = {"folder": Folder(path), "work": work}
    try:
        async with serving(GET, POST, shared, port, browse):
            work.worker().submit(tables.schema, "machine")  # the first design page asks for it
            await ended.wait()
    finally:
        work.stop()
