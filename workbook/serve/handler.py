"""What all pages that work on the folder have in common."""

import tempfile
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

from tornado.httputil import HTTPFile

from workbook.errors import MotionbookError, WriteError
from workbook.serve import pages
from workbook.serve.folder import Folder
from workbook.serve.guarded import Guarded
from workbook.serve.work import Done, Work

REPORT = "report.html"


class Page(Guarded):
    """A page that works on the folder."""

    def initialize(self, folder: Folder, work: Work, verdicts: dict[str, str]) -> None:
        """Take what all pages share."""
        self.folder, self.work, self.verdicts = folder, work, verdicts

    def argument(self, name: str) -> str:
        """Return a field of the form."""
        return str(self.get_body_argument(name))

    def text(self) -> str:
        """Return the text that is edited, as it is: a form sends it with the line ends of Windows."""
        return str(self.get_body_argument("text", strip=False)).replace("\r\n", "\n")

    def write_error(self, status_code: int, **kwargs: Any) -> None:
        """Answer with the message of an error of motionbook's, else with the reason."""
        error = (kwargs.get("exc_info") or (None, None))[1]
        if isinstance(error, MotionbookError):
            self.set_status(400)
            self.finish(pages.printed("This cannot be done", str(error), ""))
        else:
            super().write_error(status_code, **kwargs)

    def log_exception(self, typ: Any, value: Any, tb: Any) -> None:
        """Keep the errors of motionbook from the log: they are told on the page."""
        if not isinstance(value, MotionbookError):
            super().log_exception(typ, value, tb)

    def upload(self, name: str) -> HTTPFile:
        """Return the file that came with the form."""
        files = self.request.files.get(name, [])
        if len(files) != 1:
            raise WriteError("no file came; choose one first")
        return files[0]

    async def made(self, title: str, path: Path, *command: str | Path) -> None:
        """Run a command that writes a file; edit it where it is a description, else offer it."""
        done = await self.work.run(*command, "-o", path)
        if done.code:
            self.finish(pages.printed(title, done.text, "not written"))
        elif path.suffix == ".toml":
            self.redirect(f"/edit/{path.name}")
        else:
            self.finish(pages.printed(title, done.text, "", path))

    async def reported(self, path: Path, name: str, *links: Element) -> None:
        """Verify a workbook and answer with its report, links above it."""
        with tempfile.TemporaryDirectory() as folder:
            report = Path(folder) / REPORT
            done = await self.work.run("verify", path, "--report", report)
            text = report.read_text(encoding="utf-8") if report.exists() else ""
        self.verdicts[name] = pages.VERDICTS.get(done.code, "cannot be read")
        self.finish(pages.framed(text, *links) if text else pages.printed(name, done.text, self.verdicts[name]))


async def built(work: Work, folder: Folder, path: Path) -> tuple[Done, Path]:
    """Build the workbook of a description under a name that is free; return how that ended, and the workbook."""
    target = folder.free(f"{path.stem}.xlsx")
    return await work.run("build", path, "-o", target), target
