"""The base of every address: who may ask, and the files of the folder that is served, and nothing outside it."""

import asyncio
import base64
import hashlib
import hmac
import json
import math
import os
import re
import tempfile
from collections.abc import Awaitable, Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeAlias

from tornado.httputil import HTTPInputError, parse_body_arguments
from tornado.web import HTTPError, RequestHandler, stream_request_body

from workbook.errors import MotionbookError, ReadError, WriteError
from workbook.file_cache import store_cached
from workbook.reports.html import STYLE
from workbook.serve import pages
from workbook.serve.work import Done, Work, WorkError

RESERVED = {*"CON PRN AUX NUL".split(), *(f"{port}{k}" for port in ("COM", "LPT") for k in range(1, 10))}
KINDS = (".toml", ".xlsx", ".xlsm")  # descriptions and workbooks: what the first page lists
MADE = (*KINDS, *".csv .json .html .scl .st .txt .xml".split())  # what is written and downloaded
NAME = re.compile(r"[^/\\:*?\"<>|\x00-\x1f]{1,120}")
LARGEST = 60_000_000  # bytes of an upload: what verify takes of a file at most
COOKIE, JSON = "motionbook", "application/json"
REPORT = "report.html"
# of the cache: what a description comes to, the verdict on a book
BRIEF, JUDGED = "brief", "judged"
STYLED = base64.b64encode(hashlib.sha256(STYLE.encode()).digest()).decode()
POLICY = (
    f"default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'self' 'sha256-{STYLED}'; img-src 'self'; "
    "form-action 'self'; frame-ancestors 'none'; base-uri 'none'"
)


class Folder:
    """A folder of machines."""

    def __init__(self, path: Path) -> None:
        if not path.is_dir():
            raise ReadError(f"{path}: there is no such folder")
        self.path = path.resolve()

    def files(self) -> list[Path]:
        """Return its descriptions and workbooks, by name."""
        files = (path for path in self.path.iterdir() if path.suffix.lower() in KINDS)
        return sorted(path for path in files if path.is_file() and not path.name.startswith((".", "~$")))

    def file(self, name: str) -> Path:
        """Return a file of the folder; raise ReadError for a name that is none."""
        path = self._within(name)
        if path.suffix.lower() not in MADE or not path.is_file():
            raise ReadError(f"{name}: there is no such file of a machine in this folder")
        return path

    def free(self, name: str, suffix: str = "", own: Path | None = None) -> Path:
        """Return the path for a new file: the name, or that with a number; raise WriteError for no name of a file.

        ``suffix`` is added where it ends otherwise; a file that is renamed may keep its ``own`` name.
        """
        ending = Path(name).suffix.lower()
        if suffix and ending != suffix.lower():
            if ending in MADE:
                raise WriteError(f"{name}: expected a name that ends in {suffix}")
            name = f"{name}{suffix}"
        if (path := self._within(name)) == own:
            return path
        if path.stem.split(".")[0].upper() in RESERVED:
            raise WriteError(f"{name}: Windows has no such file; expected another name")
        if path.suffix.lower() not in MADE:
            raise WriteError(f"{name}: expected a name that ends in {', '.join(MADE)}")
        numbered = (path.with_stem(f"{path.stem}-{number}") for number in range(2, 1000))
        return path if not path.exists() else next(free for free in numbered if not free.exists())

    def _within(self, name: str) -> Path:
        path = self.path / name
        if not NAME.fullmatch(name) or name.startswith(".") or path.resolve().parent != self.path:
            raise ReadError(f"{name!r}: expected the plain name of a file in this folder")
        return path


def state(path: Path) -> str:
    """Return a digest that tells this version of a file from later versions."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


@stream_request_body  # who may not ask is refused before a body is read
class Page(RequestHandler):
    """A page for who has the token; Host is compared against DNS rebinding, Origin against posts from other pages."""

    def initialize(self, method: str, action: "Action | None", folder: Folder, work: Work) -> None:
        """Take the action of this address with its HTTP method, and what all pages share."""
        self.method, self.action, self.folder, self.work = method, action, folder, work
        self._command: asyncio.Future[Done] | None = None
        self._body = bytearray()

    def set_default_headers(self) -> None:
        """Let a browser load nothing from elsewhere, run no script but the server's own and keep no copy."""
        self.set_header("Content-Security-Policy", POLICY)
        self.set_header("X-Content-Type-Options", "nosniff")
        self.set_header("Referrer-Policy", "same-origin")  # without it, a form's post has no Origin
        self.set_header("Cache-Control", "no-store")

    def prepare(self) -> Awaitable[None] | None:
        """Refuse who has neither token nor cookie; exchange the token for a cookie."""
        hosts = self.settings["hosts"]
        if self.request.host not in hosts:
            raise HTTPError(403, reason="this server answers to its own address only")
        origin = self.request.headers.get("Origin")
        if self.request.method == "POST" and origin not in {f"http://{host}" for host in hosts}:
            raise HTTPError(403, reason="only this server's own pages may post to it")
        token = self.settings["token"]
        if hmac.compare_digest(self.get_cookie(COOKIE, "").encode(), token.encode()):
            return None
        given = self.get_query_argument("token", "")
        if self.request.method != "GET" or not hmac.compare_digest(given.encode(), token.encode()):
            raise HTTPError(403, reason="open the address that motionbook serve printed")
        self.set_cookie(COOKIE, token, httponly=True, samesite="Strict")
        self.redirect("/")
        return None

    def data_received(self, chunk: bytes) -> None:
        """Take a part of the body as it comes."""
        self._body += chunk

    async def get(self, *names: str) -> None:
        """Run the action of this address, and answer with its result."""
        if self.request.method != self.method:
            raise HTTPError(405)
        if self.action is None:  # there is nothing at this address
            raise HTTPError(404)
        kind, request = self.request.headers.get("Content-Type", ""), self.request
        try:
            parse_body_arguments(kind, bytes(self._body), request.body_arguments, request.files)
        except HTTPInputError:
            raise HTTPError(400) from None
        answer = await self.action(self, *names)
        if isinstance(answer, dict | list):
            self.set_header("Content-Type", JSON)
            answer = json.dumps(finite(answer), ensure_ascii=False, default=str)
        if answer is not None:
            self.finish(answer)

    post = get

    def write_error(self, status_code: int, **kwargs: Any) -> None:
        """Answer with the message of an error of motionbook's as a page, else with the reason in a line of text."""
        error = (kwargs.get("exc_info") or (None, None))[1]
        if isinstance(error, MotionbookError):
            self.set_status(400)
            if self.request.headers.get("Accept") == JSON:
                self.finish({"error": str(error).replace(f"{self.folder.path}{os.sep}", "")})
                return
            self.finish(pages.printout("This cannot be done", str(error), ""))
        else:
            self.set_header("Content-Type", "text/plain; charset=utf-8")
            self.finish(f"{status_code}: {self._reason}\n")

    def log_exception(self, typ: Any, value: Any, tb: Any) -> None:
        """Keep the errors of motionbook from the log: the page shows them."""
        if not isinstance(value, MotionbookError):
            super().log_exception(typ, value, tb)

    def file(self, name: str = "name") -> Path:
        """Return the file that a field of the form names."""
        return self.folder.file(self.get_body_argument(name))

    def text(self) -> str:
        """Return the text that is edited, as it is: a form sends it with the line ends of Windows."""
        return self.get_body_argument("text", strip=False).replace("\r\n", "\n")

    def number(self, field: str, otherwise: str = "") -> int:
        """Return the whole number that a field of the form holds; raise WriteError for another text."""
        given = self.get_body_argument(field, otherwise)
        if not re.fullmatch(r"-?\d{1,6}", given):
            raise WriteError(f"{field}: found {given!r}; expected a whole number")
        return int(given)

    def changes(self) -> list[dict[str, Any]]:
        """Return the list of changes that the form holds as JSON."""
        try:
            given = json.loads(self.get_body_argument("changes"))
        except ValueError:
            given = None
        if not isinstance(given, list) or not all(isinstance(each, dict) and "path" in each for each in given):
            raise WriteError("changes: expected a list of changes in JSON")
        return given

    @contextmanager
    def upload(self, field: str, otherwise: str) -> Iterator[Path]:
        """Keep the file that came with the form for a while; ``otherwise`` is its name where it has none."""
        files = self.request.files.get(field, [])
        if len(files) != 1:
            raise WriteError("no file came; choose one first")
        name = Path(files[0].filename).name
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / (name if NAME.fullmatch(name) else otherwise)
            path.write_bytes(files[0].body)
            yield path

    async def run(self, *command: str | Path, folder: str | None = None) -> Done:
        """Run a command of motionbook; it ends with the browser's wait for this page. Files are told by their names."""
        self._command = asyncio.ensure_future(self.work.run(*command, folder=folder))
        try:
            done = await self._command
        except asyncio.CancelledError:
            raise WorkError("cancelled") from None
        return done._replace(text=without_folders(done.text, command))

    def on_connection_close(self) -> None:
        """End the command that nobody waits for any more."""
        super().on_connection_close()
        if self._command is not None:
            self._command.cancel()

    async def write_by(self, command: str, source: Path | str, target: Path) -> str | None:
        """Write a description by a command, and edit it."""
        done = await self.run(command, source, "-o", target)
        if done.code:
            return pages.printout(Path(source).name, done.text, done.written)
        self.redirect(pages.address("edit", target.name))
        return None

    async def run_with_report(self, *command: str | Path) -> tuple[Done, str]:
        """Return how a command ended whose last option writes a report, and that; empty where there is none."""
        with tempfile.TemporaryDirectory() as folder:
            report = Path(folder) / REPORT
            done = await self.run(*command, report)
            text = report.read_text(encoding="utf-8") if report.exists() else ""
            return done, without_folders(text, command)

    async def reported(self, path: Path, *links: str, design: str = "") -> str:
        """Verify a workbook of a design and return its report, links above it; the verdict is kept by its contents."""
        digest = state(path)
        done, text = await self.run_with_report("verify", path, "--report")
        verdict = pages.VERDICTS.get(done.code, "cannot be read")
        if not text:
            return pages.printout(path.name, done.text, verdict)
        store_cached(JUDGED, digest, {"verdict": verdict})
        return pages.with_bar(text, *links, design=design)


def without_folders(text: str, paths: Iterable[str | Path]) -> str:
    """Return a text without the folders of files in it."""
    for folder in {path.parent for path in paths if isinstance(path, Path)}:
        text = text.replace(f"{folder}{os.sep}", "")
    return text


def finite(data: Any) -> Any:
    """Return data whose numbers JSON has; others as texts."""
    if isinstance(data, dict):
        return {key: finite(value) for key, value in data.items()}
    if isinstance(data, list):
        return [finite(value) for value in data]
    return str(data) if isinstance(data, float) and not math.isfinite(data) else data


Action: TypeAlias = Callable[..., Awaitable[Any]]
"""what is done at an address: HTML, bytes of a file, data that is sent as JSON; None where the page went elsewhere"""
