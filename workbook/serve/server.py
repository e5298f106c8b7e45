"""A server for this computer alone: addresses with what is done at each, and the files that its pages load."""

import secrets
import webbrowser
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError

from workbook.reports.terminal import OUT, say
from workbook.serve.handler import LARGEST, Action, Page

STATIC = r"/(pages\.js|OK\.svg|FAIL\.svg|favicon\.ico)"
SVG = "image/svg+xml"
SLOWEST = 60.0  # seconds of a body
ELSEWHERE = {"favicon.ico": "icon.svg", "page/colors.css": "../reports/colors.css"}
HERE = Path(__file__).parent
SCRIPTS = sorted(path.relative_to(HERE).as_posix() for path in HERE.glob("page/**/*.js"))
# of scripts and styles, which a browser keeps while this server runs
VERSION = secrets.token_hex(6)
TYPES = {".svg": SVG, ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8"}


async def static(page: Page, name: str) -> bytes:
    """Send a script or style of a page, or an icon."""
    file = HERE / ELSEWHERE.get(name, name)
    if not file.is_file():
        raise HTTPError(404)
    page.set_header("Content-Type", TYPES[file.suffix])
    if name.startswith("page/"):  # its address tells its version
        page.set_header("Cache-Control", "private, max-age=31536000, immutable")
    return file.read_bytes()


@asynccontextmanager
async def serving(
    get: Mapping[str, Action], post: Mapping[str, Action], shared: Mapping[str, Any], port: int, browse: bool
) -> AsyncIterator[None]:
    """Serve actions by their addresses, with NAME for any file, ``shared`` by all; tell where to begin."""
    token = secrets.token_urlsafe(24)
    sockets = bind_sockets(port, "127.0.0.1")
    port = sockets[0].getsockname()[1]
    handlers: list[Any] = [
        (path.replace("NAME", "([^/]+)"), Page, {**shared, "method": method, "action": action})
        for method, actions in (("GET", get), ("POST", post))
        for path, action in actions.items()
    ]
    application = Application(
        handlers,
        token=token,
        hosts=[f"127.0.0.1:{port}", f"localhost:{port}"],
        default_handler_class=Page,
        default_handler_args={**shared, "method": "GET", "action": None},
    )
    server = HTTPServer(application, max_buffer_size=LARGEST + 2**20, body_timeout=SLOWEST)
    server.add_sockets(sockets)
    address = f"http://127.0.0.1:{port}/?token={token}"
    say(OUT, f"Open {address} (Ctrl+C ends)")
    if browse:
        webbrowser.open(address)
    try:
        yield
    finally:
        server.stop()
