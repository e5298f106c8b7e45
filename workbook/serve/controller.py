"""The page Controller: an axis of a workbook as a controller's file with its certificate, and such a file read back."""

import tempfile
from pathlib import Path

from workbook.build import inputs
from workbook.controllers.registry import TARGETS
from workbook.reports.html import Content, e
from workbook.serve import pages
from workbook.serve.folder import plain, state
from workbook.serve.handler import REPORT, Page
from workbook.templates import TEMPLATES

ALL = "all"
ORDERS = {"y": "position", "v": "velocity", "a": "acceleration", "j": "jerk"}
known: dict[str, list[str]] = {}  # the names of the axes of books that were read, by the SHA-256 of the file


async def show(page: Page, name: str) -> str:
    """Show the form of an export, with the axes of the workbook."""
    path = page.folder.file(name)
    digest = state(path)
    if digest not in known:
        known[digest] = await page.work.beside(axes, path)
    return form(name, known[digest])


async def export(page: Page) -> str:
    """Write an axis into the folder as a controller's file, under a name that is free; return its certificate."""
    book, axis = page.file(), page.get_body_argument("axis")
    options = ["--all"] if axis == ALL else ["--axis", axis]
    options += ["--equidistant"] if page.get_body_argument("equidistant", "") else []
    for order in ORDERS:
        if share := page.get_body_argument(order, ""):
            options += ["--tolerance", f"{order}={share}%"]
    with tempfile.TemporaryDirectory() as made:
        done = await page.work.run(
            "export", book, "--to", page.get_body_argument("target"), "--points", page.get_body_argument("points"),
            *options, "--report", REPORT, folder=made,
        )  # fmt: skip
        report, links = "", []
        for file in sorted(Path(made).iterdir()):
            if file.name == REPORT:
                report = file.read_text(encoding="utf-8")
                continue
            place = page.folder.free(file.name)
            with place.open("xb") as written:
                written.write(file.read_bytes())
            links.append(pages.link(f"/file/{place.name}", f"Download {place.name}"))
    return pages.framed(report, *links) if report else pages.printed(book.name, done.text, "not written")


async def read(page: Page) -> str:
    """Write what a controller's file was made of as a description, under a name that is free, and edit it."""
    file = page.upload("table")
    with tempfile.TemporaryDirectory() as folder:
        table = Path(folder) / plain(file.filename, "table.txt")
        table.write_bytes(file.body)
        target = page.folder.free(f"{table.stem}.toml")
        done = await page.work.run("read", table, "--from", page.get_body_argument("target"), "-o", target)
    if done.code:
        return pages.printed(table.name, done.text, "not read")
    return pages.editor(target.name, target.read_text(encoding="utf-8"), state(target), done.text)


def axes(book: Path) -> list[str]:
    """Return the names of the axes of a workbook that a controller can be given."""
    machine, _ = inputs(book)
    return [one.name for one in TEMPLATES[machine.template].axes(machine)]


def form(name: str, axes: list[str]) -> str:
    """Return the page of a workbook with such axes."""
    limits: list[Content] = []
    for order, word in ORDERS.items():
        field = e("input", type="number", min="0", step="any", name=order, id=order)
        limits.append(e("p", pages.label(f"Largest error of the {word}", order), field, " % of its peak"))
    even = e("input", type="checkbox", name="equidistant", id="equidistant")
    export = pages.form(
        "/export", pages.hidden("name", name),
        e("p", pages.label("Axis", "axis"), pages.choice("axis", [*axes, ALL])),
        e("p", pages.label("Controller", "target"), pages.choice("target", TARGETS)),
        e("p", pages.label("Points", "points"), pages.text("points", "auto"), " a number, or auto for the fewest"),
        e("p", even, pages.label(" At equal steps", "equidistant")), *limits,
        pages.button("Export"), css="entry",
    )  # fmt: skip
    said = ("The workbook is verified first. The file is read back, and the motion that the controller makes of it "
            "is compared with the engine over the whole cycle; beyond a limit nothing is written.")  # fmt: skip
    file = e("input", type="file", name="table", id="table", required="required")
    read = pages.form("/read", pages.label("File", "table"), file, pages.label("of", "from"),
                      pages.choice("target", TARGETS, "from"), pages.button("Read as a machine"),
                      enctype="multipart/form-data")  # fmt: skip
    title = f"{name}: controller"
    return pages.page(title, [e("h1", title), pages.back(), e("p", said), export, e("h2", "Read a controller's file"),
                              read])  # fmt: skip
