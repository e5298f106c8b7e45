"""Spreadsheet engines of others: optional packages of their names, LibreOffice run headless; and saved values."""

from __future__ import annotations

import io
import os
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import zipfile
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from workbook.book.address import Address
from workbook.errors import WitnessError
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile
from workbook.witnesses.witness import Witness, cached_values, evaluation_copy

TIMEOUT = 300  # seconds
PLACES = (
    "/usr/bin/soffice",
    "/Applications/LibreOffice.app/Contents/MacOS/soffice",
    r"C:\Program Files\LibreOffice\program\soffice.com",
)
# LibreOffice keeps the values that it finds in a file unless it is asked to recalculate always, and follows links to
# other files and to the web unless it is asked never to; settings that a version does not know do no harm
SETTINGS = (
    ("Calc/Formula/Load", "OOXMLRecalcMode", "0"), ("Calc/Formula/Load", "ODFRecalcMode", "0"),
    ("Calc/Content/Update", "Link", "2"), ("Common/Security/Scripting", "BlockUntrustedRefererLinks", "true"),
    ("Common/Security/Scripting", "DisableActiveContent", "true"),
)  # fmt: skip
ITEM = '<item oor:path="/org.openoffice.Office.{}"><prop oor:name="{}" oor:op="fuse"><value>{}</value></prop></item>'
PROFILE = """<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry" xmlns:xs="http://www.w3.org/2001/XMLSchema"
 xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">{}</oor:items>
""".format("".join(ITEM.format(*setting) for setting in SETTINGS))


class Apart(Witness):
    """An evaluator in a process of its own, under limits of time and memory, in which a file stays open."""

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell, None where it is empty or no single value."""
        ((_, values),) = self.varied(file, [{}])
        return values

    def varied(
        self, file: BookFile, sets: Iterable[Cells], cells: Sequence[Address] | None = None
    ) -> Iterator[tuple[Cells, Cells]]:
        """Yield each set of values, all of the same cells, with what the formula ``cells`` compute at it."""
        cells = file.contents.formula_cells if cells is None else cells
        with evaluation_copy(file) as copy, tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "book.xlsx"
            path.write_bytes(without_empty_numbers(copy.path.read_bytes()))
            with Session(self.name, path, cells, TIMEOUT) as session:
                for given in sets:
                    yield given, dict(zip(cells, session.ask(given), strict=True))


class Formulon(Apart):
    """formulon, in WebAssembly, tested against Excel's own results by its makers."""

    name = "formulon"


class IronCalc(Apart):
    """IronCalc, in Rust."""

    name = "ironcalc"


EMPTY_NUMBER = re.compile(rb'(<c [^>]*?) t="n"([^>]*/>)')
SHEET = re.compile(r"xl/worksheets/[^/]+\.xml")


def without_empty_numbers(data: bytes) -> bytes:
    """Return a file whose empty cells do not say that they are numbers, as openpyxl writes: IronCalc reads zeros."""
    copy = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as parts, zipfile.ZipFile(copy, "w", zipfile.ZIP_STORED) as written:
        for info in parts.infolist():
            part = parts.read(info)
            written.writestr(
                info.filename, EMPTY_NUMBER.sub(rb"\1\2", part) if SHEET.fullmatch(info.filename) else part
            )
    return copy.getvalue()


class Session:
    """A process in which an evaluator holds a file open; it ends with the block, or when an answer takes too long."""

    def __init__(self, name: str, path: Path, cells: Sequence[Address], seconds: float) -> None:
        self.name, self.number, self.seconds = name, len(cells), seconds
        command = [sys.executable, "-P", str(Path(__file__).with_name("engine_process.py"))]
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )
        self._send((name, str(path), [tuple(cell) for cell in cells]))

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *_: object) -> None:
        self.process.kill()
        self.process.communicate()

    def _send(self, request: Any) -> None:
        assert self.process.stdin is not None  # noqa: S101 - a pipe was asked for
        with suppress(OSError):  # it ended: reading says so
            pickle.dump(request, self.process.stdin)
            self.process.stdin.flush()

    def ask(self, given: Cells) -> list[Any]:
        """Return the values of the cells with ``given`` values in others; raise WitnessError where there are none."""
        assert self.process.stdout is not None  # noqa: S101 - a pipe was asked for
        late = threading.Event()

        def stop() -> None:
            late.set()
            self.process.kill()

        clock = threading.Timer(self.seconds, stop)
        clock.start()
        try:
            self._send({tuple(cell): value for cell, value in given.items()})
            answered, answer = pickle.load(self.process.stdout)
        except (EOFError, pickle.UnpicklingError):
            if late.is_set():
                raise WitnessError(f"{self.name} gave no answer within {self.seconds:g} s") from None
            raise WitnessError(f"{self.name} ended with exit code {self.process.wait()}") from None
        finally:
            clock.cancel()
        if not answered:
            raise WitnessError(f"{self.name} cannot evaluate the file: {answer}")
        return list(answer)


def libreoffice_path() -> str | None:
    """Return the path of LibreOffice, or None where it is not on this machine."""
    return shutil.which("soffice") or next((place for place in PLACES if Path(place).exists()), None)


def convert(source: Path, kind: str, folder: Path) -> Path:
    """Convert a file with a private profile that recalculates everything; return the new file in ``folder``."""
    soffice = libreoffice_path()
    if soffice is None:
        raise WitnessError("LibreOffice is not on this machine")
    with tempfile.TemporaryDirectory() as profile:
        user = Path(profile) / "user"
        user.mkdir()
        (user / "registrymodifications.xcu").write_text(PROFILE, encoding="utf-8")
        private = f"-env:UserInstallation={Path(profile).as_uri()}"
        asked = ["--convert-to", kind, "--outdir", str(folder), str(source)]
        command = [soffice, "--headless", "--norestore", private, *asked]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise WitnessError(f"LibreOffice did not finish: {error}") from error
    path = folder / f"{source.stem}.{kind.split(':')[0]}"
    if not path.exists():
        raise WitnessError(f"LibreOffice could not open the file: {(run.stderr or run.stdout).strip()[:200]}")
    return path


@cache
def version_of(soffice: str) -> str:
    """Return the version of a LibreOffice."""
    environment = os.environ | {"HOME": tempfile.gettempdir()} if sys.platform != "win32" else None
    try:
        output = subprocess.run(
            [soffice, "--version"], capture_output=True, text=True, check=False, env=environment, timeout=TIMEOUT
        )
    except (OSError, subprocess.TimeoutExpired):  # converting says what is wrong
        return "unknown version"
    match = re.search(r"\d+(\.\d+)+", output.stdout)
    return match.group() if match else "unknown version"


class LibreOffice(Witness):
    """Recalculates a bare copy of the file, which has nothing to fetch, and reads the results back."""

    name = "libreoffice"

    def version(self) -> str | None:
        """Return LibreOffice's own version, or None where it is absent."""
        soffice = libreoffice_path()
        return None if soffice is None else version_of(soffice)

    def values(self, file: BookFile) -> Cells:
        """Return the value of every formula cell."""
        with evaluation_copy(file, bare=True) as copy, tempfile.TemporaryDirectory() as folder:
            return cached_values(convert(copy.path, "xlsx", Path(folder)).read_bytes(), file)


class Saved(Witness):
    """Reads the results that stand in the file."""

    name = "saved"
    kept = True

    def version(self) -> str | None:
        """Return words for the version; it has no program of its own."""
        return "values in the file"

    def values(self, file: BookFile) -> Cells:
        """Return the saved value of every formula cell; raise WitnessError where the file has none."""
        if all(value is None for value in file.saved.values()):
            raise WitnessError("the file holds no saved values; open it in Excel or LibreOffice and save it")
        return file.saved
