"""The page Controller: an axis of a workbook as a controller's file with its certificate, and such a file read back."""

import tempfile
from pathlib import Path
from xml.etree.ElementTree import Element

from workbook.build import inputs
from workbook.controllers.registry import TARGETS
from workbook.reports.html import Content, e
from workbook.serve import pages
from workbook.serve.folder import Folder, plain, state
from workbook.serve.handler import REPORT, Page
from workbook.templates import TEMPLATES

ALL = "all"
ORDERS = {"y": "position", "v": "velocity", "a": "acceleration", "j": "jerk"}
known: dict[str, list[str]] = {}
"""the names of the axes of books that were read, by the SHA-256 of the file"""


class Controller(Page):
    """The form of an export."""

    async def get(self, name: str) -> None:
        """Show it, with the axes of the workbook."""
        path = self.folder.file(name)
        digest = state(path)
        if digest not in known:
            known[digest] = await self.work.beside(axes, path)
        self.finish(page(name, known[digest]))


class Export(Page):
    """An axis as a controller's file."""

    async def post(self) -> None:
        """Write it into the folder, under a name that is free, and answer with its certificate."""
        book, axis = self.folder.file(self.argument("name")), self.argument("axis")
        options = ["--all"] if axis == ALL else ["--axis", axis]
        options += ["--equidistant"] if self.get_body_argument("equidistant", "") else []
        for order in ORDERS:
            if share := self.get_body_argument(order, ""):
                options += ["--tolerance", f"{order}={share}%"]
        with tempfile.TemporaryDirectory() as made:
            done = await self.work.run(
                "export", book, "--to", self.argument("target"), "--points", self.argument("points"), *options,
                "--report", REPORT, folder=made,
            )  # fmt: skip
            report = Path(made) / REPORT
            text = report.read_text(encoding="utf-8") if report.exists() else ""
            links = [pages.link(f"/file/{name}", f"Download {name}") for name in taken(self.folder, Path(made))]
        self.finish(pages.framed(text, *links) if text else pages.printed(book.name, done.text, "not written"))


class Read(Page):
    """A controller's file from elsewhere."""

    async def post(self) -> None:
        """Write what it was made of as a description, under a name that is free, and edit it."""
        file = self.upload("table")
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / plain(file.filename, "table.txt")
            table.write_bytes(file.body)
            target = self.folder.free(f"{table.stem}.toml")
            done = await self.work.run("read", table, "--from", self.argument("target"), "-o", target)
        if done.code:
            self.finish(pages.printed(table.name, done.text, "not read"))
        else:
            self.finish(pages.editor(target.name, target.read_text(encoding="utf-8"), state(target), done.text))


def axes(book: Path) -> list[str]:
    """Return the names of the axes of a workbook that a controller can be given."""
    machine, _ = inputs(book)
    return [one.name for one in TEMPLATES[machine.template].axes(machine)]


def taken(folder: Folder, made: Path) -> list[str]:
    """Move what a command wrote, but its report, into the folder under free names; return these."""
    names = []
    for file in sorted(one for one in made.iterdir() if one.name != REPORT):
        place = folder.free(file.name)
        with place.open("xb") as written:
            written.write(file.read_bytes())
        names.append(place.name)
    return names


def page(name: str, axes: list[str]) -> str:
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
    body = [e("h1", f"{name}: controller"), pages.back(), e("p", said), export, e("h2", "Read a controller's file"),
            read()]  # fmt: skip
    return pages.page(f"{name}: controller", body)


def read() -> Element:
    """Return the form that takes a controller's file as a description."""
    file = e("input", type="file", name="table", id="table", required="required")
    return pages.form("/read", pages.label("File", "table"), file, pages.label("of", "from"),
                      pages.choice("target", TARGETS, "from"), pages.button("Read as a machine"),
                      enctype="multipart/form-data")  # fmt: skip
