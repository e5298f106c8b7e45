"""The server: addresses, and what is done at each by the commands of motionbook."""

import asyncio
import re
import secrets
import tempfile
import webbrowser
from collections.abc import Callable
from pathlib import Path
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError

from workbook.build import write_text
from workbook.errors import InputError, WriteError
from workbook.intake import read_text
from workbook.serve import controller, fields, live, pages, studied, study
from workbook.serve.folder import LARGEST, Folder, plain, state
from workbook.serve.handler import REPORT, Action, Page
from workbook.serve.work import Work, WorkError
from workbook.templates import TEMPLATES
from workbook.writing.place import replace

STATIC = {name: name for name in ("busy.js", "form.js", "home.js", "live.js", "study.js", "text.js")} | {
    "favicon.ico": "icon.svg"
}
SVG = "image/svg+xml"
drawn: dict[str, str] = {}  # the pictures of the gallery, by templates


async def home(page: Page) -> str:
    """Show the folder."""
    return pages.home(page.folder, page.verdicts, page.work.waiting)


async def download(page: Page, name: str) -> bytes:
    """Send a file of the folder."""
    page.set_header("Content-Type", "application/octet-stream")
    page.set_header("Content-Disposition", "attachment")
    return page.folder.file(name).read_bytes()


async def new(page: Page) -> str | None:
    """Write a new description, and edit it."""
    path = page.folder.free(f"{page.get_body_argument('name')}.toml")
    return await page.made("new", page.get_body_argument("template"), path)


async def edit(page: Page, name: str) -> str:
    """Show a description to be edited, or one of the best designs of a study of it, which is not saved."""
    path, asked = page.folder.file(name), page.get_query_argument("study", "")
    if not asked:
        return pages.editor(name, read_text(path, "a description"), state(path))
    number, results = page.get_query_argument("pick"), page.folder.file(asked)
    if not number.isdecimal():
        raise InputError([f"{number!r}: expected the place of a design"])
    text = await page.work.beside(studied.picked, results, int(number))
    said = f"Design {int(number)} of {asked}, beside the saved {name}. It is not saved yet."
    return pages.editor(name, text, state(path), said, f"{results.stem}-{int(number)}.toml")


async def live_panel(page: Page) -> str:
    """Return the panel beside the text of a description that is being edited."""
    saved = read_text(page.file(), "a description")
    try:
        return await page.work.beside(live.fragment, page.get_body_argument("name"), page.text(), saved)
    except WorkError as error:
        return f"<p>{error}: save and build it instead.</p>"


async def form(page: Page) -> str:
    """Return the form of a part of a description that is being edited."""
    name, part = map(page.get_body_argument, ("name", "part"))
    return await page.work.beside(fields.form, name, page.text(), part)


async def enter(page: Page) -> str:
    """Return the text of a description in which what a field says is entered."""
    name, *asked = map(page.get_body_argument, ("name", "path", "do", "value"))
    page.set_header("Content-Type", "text/plain; charset=utf-8")
    return await page.work.beside(fields.entered, name, page.text(), *asked)


async def to_print(page: Page, name: str) -> str:
    """Show a description as a page to print."""
    return await page.work.beside(live.sheet, name, read_text(page.folder.file(name), "a description"))


async def picture(page: Page, name: str) -> str:
    """Send the picture of a template in the gallery, which is drawn once."""
    if name not in TEMPLATES:
        raise HTTPError(404)
    if name not in drawn:
        drawn[name] = await page.work.beside(live.picture, name)
    page.set_header("Content-Type", SVG)
    return drawn[name]


async def static(page: Page, name: str) -> bytes:
    """Send a script of a page, or the icon."""
    file = Path(__file__).with_name(STATIC[name])
    page.set_header("Content-Type", SVG if file.suffix == ".svg" else "text/javascript; charset=utf-8")
    return file.read_bytes()


async def save(page: Page) -> str | None:
    """Save a description unless it changed meanwhile, or under another, free name; then edit it, or build its book."""
    name, text, path = page.get_body_argument("name"), page.text(), page.file()
    if page.get_body_argument("as") != name:
        path = page.folder.free(page.get_body_argument("as"))
    elif state(path) != page.get_body_argument("state"):
        raise WriteError(f"{name} changed since it was opened; open it again and repeat your change")
    replace(path, lambda draft: write_text(draft, text), overwrite=True)
    if page.get_body_argument("then") == "edit":
        page.redirect(f"/edit/{path.name}")
        return None
    book = page.folder.free(f"{path.stem}.xlsx")
    done = await page.work.run("build", path, "-o", book)
    if done.code:
        return pages.editor(path.name, text, state(path), done.text)
    return pages.printed(path.name, done.text, "", path, book)


async def build(page: Page) -> str | None:
    """Build the workbook of a description."""
    path = page.file()
    return await page.made("build", path, page.folder.free(f"{path.stem}.xlsx"))


async def verify(page: Page) -> str:
    """Verify a workbook of the folder and return the report."""
    path = page.file()
    more = [pages.post("/inputs", path.name, "Edit what is entered"),
            pages.post("/regenerate", path.name, "Build anew")]  # fmt: skip
    return await page.reported(path, *more)


async def inputs(page: Page) -> str | None:
    """Write what was entered in a workbook as a description, and edit it."""
    path = page.file()
    return await page.made("inputs", path, page.folder.free(f"{path.stem}.toml"))


async def regenerate(page: Page) -> str | None:
    """Build a workbook anew by today's formulas."""
    path = page.file()
    return await page.made("regenerate", path, page.folder.free(f"{path.stem}.xlsx"))


async def short(page: Page, name: str) -> str:
    """Return in a line for the first page what a description comes to."""
    return await page.work.beside(live.in_short, name, read_text(page.folder.file(name), "a description"))


async def upload(page: Page) -> str:
    """Verify a workbook from elsewhere, which is not kept."""
    file = page.upload("book")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / plain(file.filename, "upload.xlsx")
        path.write_bytes(file.body)
        return await page.reported(path)


async def compare(page: Page) -> str:
    """Tell what differs between two files of the folder."""
    old, new = page.file("old"), page.file("new")
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / REPORT
        done = await page.work.run("diff", old, new, "--html", report)
        text = report.read_text(encoding="utf-8") if report.exists() else ""
    return pages.framed(text) if text else pages.printed("Comparison", done.text, "")


async def missing(page: Page) -> str:
    """Say that there is nothing at an address."""
    raise HTTPError(404)


GET: dict[str, Action] = {
    r"/": home, r"/file/([^/]+)": download, r"/edit/([^/]+)": edit, r"/short/([^/]+)": short,
    r"/print/([^/]+)": to_print, r"/picture/([^/]+)\.svg": picture, r"/vary/([^/]+)": study.vary,
    r"/study/([^/]+)": study.show, r"/progress/([^/]+)": study.progress, r"/controller/([^/]+)": controller.show,
    f"/({'|'.join(map(re.escape, STATIC))})": static,
}  # fmt: skip
POST: dict[str, Action] = {
    "/new": new, "/save": save, "/inputs": inputs, "/regenerate": regenerate, "/live": live_panel, "/fields": form,
    "/set": enter, "/build": build, "/verify": verify, "/upload": upload, "/compare": compare, "/study": study.new,
    "/begin": study.go_on, "/cancel": study.cancel, "/export": controller.export, "/read": controller.read,
}  # fmt: skip


def application(folder: Folder, token: str, hosts: list[str], work: Work) -> Application:
    """Return the application that serves a folder to who has the token."""
    shared = {"folder": folder, "work": work, "verdicts": dict[str, str]()}
    handlers: list[Any] = [(path, Page, shared | {"method": method, "action": action})
                           for method, actions in (("GET", GET), ("POST", POST))
                           for path, action in actions.items()]  # fmt: skip
    nothing = shared | {"method": "GET", "action": missing}
    return Application(handlers, token=token, hosts=hosts, default_handler_class=Page, default_handler_args=nothing)


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
