"""The server: addresses, and what each page does by the commands of motionbook."""

from __future__ import annotations

import asyncio
import secrets
import tempfile
import webbrowser
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application

from workbook.build import write_text
from workbook.errors import WriteError
from workbook.intake import read_text
from workbook.serve import pages
from workbook.serve.controller import Controller, Export, Read
from workbook.serve.folder import LARGEST, Folder, plain, state
from workbook.serve.guarded import Guarded
from workbook.serve.handler import REPORT, Page, built
from workbook.serve.work import Work
from workbook.writing.place import replace

SCRIPT = Path(__file__).with_name("live.js")


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
        done = await self.work.run("new", self.argument("template"), "-o", path)
        if done.code:
            self.finish(pages.printed("New machine", done.text, "not written"))
        else:
            self.redirect(f"/edit/{path.name}")


class Edit(Page):
    """A description to be edited."""

    def get(self, name: str) -> None:
        """Show it."""
        path = self.folder.file(name)
        text = read_text(path, "a description")
        self.finish(pages.editor(name, text, state(path)))


class Live(Page):
    """What a description comes to that is being edited."""

    async def post(self) -> None:
        """Answer with the panel beside its text."""
        saved = read_text(self.folder.file(self.argument("name")), "a description")
        text = self.get_body_argument("text", strip=False).replace("\r\n", "\n")
        self.finish(await self.work.live(self.argument("name"), text, saved))


class Script(Guarded):
    """The script of the page Edit."""

    def get(self) -> None:
        """Send it."""
        self.set_header("Content-Type", "text/javascript; charset=utf-8")
        self.finish(SCRIPT.read_text(encoding="utf-8"))


class Save(Page):
    """A description that was edited."""

    async def post(self) -> None:
        """Save it unless it changed meanwhile, and build its workbook; show what is amiss beside the text."""
        name, text = self.argument("name"), self.get_body_argument("text", strip=False).replace("\r\n", "\n")
        path = self.folder.file(name)
        if state(path) != self.argument("state"):
            raise WriteError(f"{name} changed since it was opened; open it again and repeat your change")
        replace(path, lambda draft: write_text(draft, text), overwrite=True)
        done, target = await built(self.work, self.folder, path)
        if done.code:
            self.finish(pages.editor(name, text, state(path), done.text))
        else:
            self.finish(pages.printed(name, done.text, "", pages.link(f"/file/{target.name}", "Download")))


class Build(Page):
    """A workbook made of a description."""

    async def post(self) -> None:
        """Build it under a name that is free."""
        path = self.folder.file(self.argument("name"))
        done, target = await built(self.work, self.folder, path)
        links = [] if done.code else [pages.link(f"/file/{target.name}", "Download")]
        self.finish(pages.printed(path.name, done.text, "", *links))


class Verify(Page):
    """A workbook of the folder, verified."""

    async def post(self) -> None:
        """Answer with the report."""
        path = self.folder.file(self.argument("name"))
        await self.reported(path, path.name)


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
        (r"/live", Live),
        (r"/build", Build), (r"/verify", Verify), (r"/upload", Upload), (r"/compare", Compare),
        (r"/controller/([^/]+)", Controller), (r"/export", Export), (r"/read", Read),
    ]  # fmt: skip
    handlers: list[Any] = [(path, page, shared) for path, page in routes]
    handlers.append((r"/live.js", Script))
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
