"""The server: addresses, and what each page does by the commands of motionbook."""

import asyncio
import re
import secrets
import tempfile
import webbrowser
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError

from workbook.build import write_text
from workbook.errors import WriteError
from workbook.intake import read_text
from workbook.serve import fields, pages, sheet, studied
from workbook.serve.controller import Controller, Export, Read
from workbook.serve.folder import LARGEST, Folder, plain, state
from workbook.serve.guarded import Guarded
from workbook.serve.handler import REPORT, Page, built
from workbook.serve.study import Begin, Cancel, NewStudy, Progress, Study, Vary
from workbook.serve.work import Work
from workbook.templates import TEMPLATES
from workbook.writing.place import replace

STATIC = {name: name for name in ("busy.js", "form.js", "home.js", "live.js", "study.js", "text.js")} | {
    "favicon.ico": "icon.svg"
}


class Home(Page):
    """The first page."""

    def get(self) -> None:
        """Show the folder."""
        self.finish(pages.home(self.folder, self.verdicts, self.work.waiting))


class Download(Page):
    """A workbook or a description as a file."""

    def get(self, name: str) -> None:
        """Send the file."""
        path = self.folder.file(name)
        self.set_header("Content-Type", "application/octet-stream")
        self.set_header("Content-Disposition", "attachment")
        self.finish(path.read_bytes())


class New(Page):
    """A new description."""

    async def post(self) -> None:
        """Write it, under a name that is free, and edit it."""
        path = self.folder.free(f"{self.argument('name')}.toml")
        await self.made("New machine", path, "new", self.argument("template"))


class Edit(Page):
    """A description to be edited."""

    async def get(self, name: str) -> None:
        """Show it, or one of the best designs of a study of it, which is not saved."""
        path, study = self.folder.file(name), self.get_query_argument("study", "")
        if not study:
            self.finish(pages.editor(name, read_text(path, "a description"), state(path)))
            return
        asked, number = self.folder.file(study), studied.place_of(self.get_query_argument("pick"))
        text = await self.work.beside(studied.picked, asked, asked.with_suffix(".json"), number)
        said = f"Design {number} of {study}, beside the saved {name}. It is not saved yet."
        self.finish(pages.editor(name, text, state(path), said, f"{asked.stem}-{number}.toml"))


class Live(Page):
    """What a description comes to that is being edited."""

    async def post(self) -> None:
        """Answer with the panel beside its text."""
        saved = read_text(self.folder.file(self.argument("name")), "a description")
        self.finish(await self.work.live(self.argument("name"), self.text(), saved))


class Fields(Page):
    """The form of a part of a description that is being edited."""

    async def post(self) -> None:
        """Answer with its fields."""
        part = self.argument("part")
        self.finish(await self.work.beside(fields.form, self.argument("name"), self.text(), part))


class Enter(Page):
    """A field of the form."""

    async def post(self) -> None:
        """Answer with the text in which what it says is entered."""
        asked = [self.argument(name) for name in ("path", "do", "value")]
        self.set_header("Content-Type", "text/plain; charset=utf-8")
        self.finish(await self.work.beside(fields.entered, self.argument("name"), self.text(), *asked))


class Print(Page):
    """A description as a page to print."""

    async def get(self, name: str) -> None:
        """Show it."""
        text = read_text(self.folder.file(name), "a description")
        self.finish(await self.work.beside(sheet.page, name, text))


class Picture(Page):
    """The picture of a template in the gallery."""

    async def get(self, name: str) -> None:
        """Send it; it is drawn once."""
        if name not in TEMPLATES:
            raise HTTPError(404)
        if name not in self.drawn:
            self.drawn[name] = await self.work.beside(sheet.picture, name)
        self.set_header("Content-Type", "image/svg+xml")
        self.finish(self.drawn[name])

    drawn: ClassVar[dict[str, str]] = {}


class Static(Guarded):
    """A script of a page, or the icon."""

    def get(self, name: str) -> None:
        """Send it."""
        file = Path(__file__).with_name(STATIC[name])
        self.set_header("Content-Type", "image/svg+xml" if file.suffix == ".svg" else "text/javascript; charset=utf-8")
        self.finish(file.read_text(encoding="utf-8"))


class Save(Page):
    """A description that was edited."""

    async def post(self) -> None:
        """Save it unless it changed meanwhile, or under another name that is free; then edit it, or build its book."""
        name, text = self.argument("name"), self.text()
        path = self.folder.file(name)
        if self.argument("as") != name:
            path = self.folder.free(self.argument("as"))
            name = path.name
        elif state(path) != self.argument("state"):
            raise WriteError(f"{name} changed since it was opened; open it again and repeat your change")
        replace(path, lambda draft: write_text(draft, text), overwrite=True)
        if self.argument("then") == "edit":
            self.redirect(f"/edit/{name}")
            return
        done, target = await built(self.work, self.folder, path)
        if done.code:
            self.finish(pages.editor(name, text, state(path), done.text))
        else:
            self.finish(pages.printed(name, done.text, "", path, target))


class Build(Page):
    """A workbook made of a description."""

    async def post(self) -> None:
        """Build it under a name that is free."""
        path = self.folder.file(self.argument("name"))
        done, target = await built(self.work, self.folder, path)
        self.finish(pages.printed(path.name, done.text, "", path, *([] if done.code else [target])))


class Verify(Page):
    """A workbook of the folder, verified."""

    async def post(self) -> None:
        """Answer with the report."""
        path = self.folder.file(self.argument("name"))
        more = [pages.post("/inputs", path.name, "Edit what is entered"),
                pages.post("/regenerate", path.name, "Build anew")]  # fmt: skip
        await self.reported(path, path.name, *more)


class Inputs(Page):
    """What was entered in a workbook of the folder."""

    async def post(self) -> None:
        """Write it as a description, under a name that is free, and edit it."""
        path = self.folder.file(self.argument("name"))
        await self.made(path.name, self.folder.free(f"{path.stem}.toml"), "inputs", path)


class Regenerate(Page):
    """A workbook of the folder, built anew by today's formulas."""

    async def post(self) -> None:
        """Build it under a name that is free."""
        path = self.folder.file(self.argument("name"))
        await self.made(path.name, self.folder.free(f"{path.stem}.xlsx"), "regenerate", path)


class Short(Page):
    """What a description comes to, in a line for the first page."""

    async def get(self, name: str) -> None:
        """Answer with the line."""
        text = read_text(self.folder.file(name), "a description")
        self.finish(await self.work.beside(sheet.in_short, name, text))


class Upload(Page):
    """A workbook from elsewhere, verified and not kept."""

    async def post(self) -> None:
        """Answer with the report."""
        file = self.upload("book")
        name = plain(file.filename, "upload.xlsx")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.write_bytes(file.body)
            await self.reported(path, name)


class Compare(Page):
    """Two files of the folder, compared."""

    async def post(self) -> None:
        """Answer with what differs."""
        old, new = (self.folder.file(self.argument(name)) for name in ("old", "new"))
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / REPORT
            done = await self.work.run("diff", old, new, "--html", page)
            text = page.read_text(encoding="utf-8") if page.exists() else ""
        self.finish(pages.framed(text) if text else pages.printed("Comparison", done.text, ""))


class Missing(Guarded):
    """An address at which there is nothing."""

    def get(self) -> None:
        """Say so."""
        self.send_error(404)


def application(folder: Folder, token: str, hosts: list[str], work: Work) -> Application:
    """Return the application that serves a folder to who has the token."""
    shared = {"folder": folder, "work": work, "verdicts": dict[str, str]()}
    routes = [
        (r"/", Home), (r"/file/([^/]+)", Download), (r"/edit/([^/]+)", Edit), (r"/new", New), (r"/save", Save),
        (r"/inputs", Inputs), (r"/regenerate", Regenerate), (r"/short/([^/]+)", Short),
        (r"/print/([^/]+)", Print), (r"/picture/([^/]+)\.svg", Picture),
        (r"/live", Live), (r"/fields", Fields), (r"/set", Enter),
        (r"/build", Build), (r"/verify", Verify), (r"/upload", Upload), (r"/compare", Compare),
        (r"/vary/([^/]+)", Vary), (r"/study", NewStudy), (r"/study/([^/]+)", Study), (r"/begin", Begin),
        (r"/cancel", Cancel), (r"/progress/([^/]+)", Progress),
        (r"/controller/([^/]+)", Controller), (r"/export", Export), (r"/read", Read),
    ]  # fmt: skip
    handlers: list[Any] = [(path, page, shared) for path, page in routes]
    handlers.append((f"/({'|'.join(map(re.escape, STATIC))})", Static))
    return Application(handlers, token=token, hosts=hosts, default_handler_class=Missing)


async def serve(path: Path, port: int, browse: bool, tell: Callable[[str], None]) -> None:
    """Serve a folder on this computer until it is interrupted."""
    folder, token, work = Folder(path), secrets.token_urlsafe(24), Work()
    sockets = bind_sockets(port, "127.0.0.1")
    port = sockets[0].getsockname()[1]
    hosts = [f"127.0.0.1:{port}", f"localhost:{port}"]
    server = HTTPServer(application(folder, token, hosts, work), max_buffer_size=LARGEST + 2**20)
    server.add_sockets(sockets)
    address = f"http://127.0.0.1:{port}/?token={token}"
    tell(address)
    if browse:
        webbrowser.open(address)
    try:
        await asyncio.Event().wait()
    finally:
        server.stop()
        work.stop()
