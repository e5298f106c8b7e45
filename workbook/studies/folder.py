"""The parts of a study on the way: a folder beside the results, one study in it, each part whole or not there."""

from __future__ import annotations

import hashlib
import json
import os
import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from workbook.errors import WriteError
from workbook.studies.summary import Summary
from workbook.writing.place import unwritten

LOCK, TOLD = "lock", "study.json"
OWN = re.compile(r"\.?part-[0-9]{8}\.(json|csv|parquet)")
"""the files of a part, and what was written of one when the process ended; no others are read or removed"""
STEP = 64


class Parts:
    """The folder of a study's parts, of ``step`` designs each: of one that goes on, of as many as it began with."""

    def __init__(self, results: Path, digest: str, size: int, step: int = STEP) -> None:
        self.results, self.digest, self.size, self.step = results, digest, size, step
        self.folder = results.with_name(f"{results.name}.parts")
        self.suffix = results.suffix.lower()

    @property
    def _told(self) -> str:
        return json.dumps(self._whose | {"step": self.step})

    @property
    def _whose(self) -> dict[str, Any]:
        return {"digest": self.digest, "size": self.size, "suffix": self.suffix}

    @property
    def mine(self) -> bool:
        """Whether parts of this very study lie there."""
        return self._begun.items() >= self._whose.items()

    @property
    def _begun(self) -> dict[str, Any]:
        """What is noted of the study that lies there."""
        with suppress(ValueError):
            noted = json.loads(read(self.folder / TOLD))
            return noted if isinstance(noted, dict) else {}
        return {}

    @property
    def held(self) -> str:
        """What lies there of this study, and how it goes on."""
        return f"holds {len(self.complete())} complete parts of this study; --resume goes on with them"

    @property
    def _refused(self) -> str:
        if self.mine:
            return f"{self.held}, --force begins anew"
        said = "holds parts of another study, or of this one before it was changed"
        return f"{said}; --force begins anew, -o names other results"

    @contextmanager
    def opened(self, resume: bool, force: bool) -> Iterator[None]:
        """Hold the folder for this study alone; raise WriteError where another one is at work in it, or was."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise unwritten(self.folder, error) from error
        with locked(self.folder / LOCK):
            self._begin(resume, force)
            yield

    def _begin(self, resume: bool, force: bool) -> None:
        """See what lies in the folder: nothing, parts of this study, or of another."""
        told = self.folder / TOLD
        if resume and self.mine:
            self.step = int(self._begun.get("step", self.step))
        else:
            if told.exists() and not force:
                raise WriteError(f"{self.folder}: {self._refused}")
            for one in self._own():
                one.unlink()
        self.place(told, self._told.encode())

    def complete(self) -> set[int]:
        """Return the numbers of the parts that are whole: their rows are those that were written."""
        numbers = {int(one.stem.removeprefix("part-")) for one in self._own() if one.suffix == ".json"}
        return {number for number in numbers if self._whole(number)}

    def _own(self) -> list[Path]:
        """Return the files of parts; what else lies in the folder is somebody's own."""
        return [one for one in self.folder.glob("*part-*") if OWN.fullmatch(one.name)]

    def _whole(self, number: int) -> bool:
        """Whether the rows of a part have the length and the digest that were noted when they were written."""
        try:
            noted = json.loads(read(self._noted(number)))["rows"]
            return bool(noted == told_of(self.rows(number).read_bytes()))
        except (OSError, ValueError, TypeError, KeyError):
            return False

    def _noted(self, number: int) -> Path:
        return self.folder / f"part-{number:08}.json"

    def rows(self, number: int) -> Path:
        """Return the file of a part's rows."""
        return self.folder / f"part-{number:08}{self.suffix}"

    def summary(self, number: int) -> Summary:
        """Return what is known of a complete part."""
        return Summary.of_json(json.dumps(json.loads(read(self._noted(number)))["summary"]))

    def keep(self, number: int, rows: bytes, summary: Summary) -> None:
        """Keep a part: its rows, and then what tells whether they are whole."""
        self.place(self.rows(number), rows)
        noted = {"rows": told_of(rows), "summary": json.loads(summary.json())}
        self.place(self._noted(number), json.dumps(noted, ensure_ascii=False).encode())

    def place(self, path: Path, data: bytes) -> None:
        """Write a file beside and rename it; raise WriteError where there is no room."""
        draft = path.with_name(f".{path.name}")
        try:
            with draft.open("wb") as file:
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
            draft.replace(path)
        except OSError as error:
            draft.unlink(missing_ok=True)
            said = f"{unwritten(path, error)}; --resume goes on when that is mended"
            raise WriteError(said) from error

    def remove(self) -> None:
        """Remove the parts, and the folder unless something else lies in it."""
        with suppress(OSError):
            for one in [*self._own(), self.folder / TOLD, self.folder / LOCK]:
                one.unlink(missing_ok=True)
            self.folder.rmdir()


def progress(results: Path) -> tuple[int, int]:
    """Return how many designs of an unfinished study are worked out, and how many there are; 0 of 0 of none."""
    folder = results.with_name(f"{results.name}.parts")
    with suppress(ValueError, TypeError, KeyError):
        begun = json.loads(read(folder / TOLD))
        size, parts = int(begun["size"]), len([one for one in folder.glob("part-*.json") if OWN.fullmatch(one.name)])
        return min(size, parts * int(begun["step"])), size
    return 0, 0


def told_of(rows: bytes) -> list[Any]:
    """Return the length and the digest of a part's rows."""
    return [len(rows), hashlib.sha256(rows).hexdigest()]


def read(path: Path) -> str:
    """Return a text, empty where there is none."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""


@contextmanager
def locked(path: Path) -> Iterator[None]:
    """Hold a file against all other processes; the system lets go of it when this one ends, however it does."""
    try:
        file = path.open("a+b")
    except OSError as error:
        raise unwritten(path, error) from error
    with file:
        try:
            hold(file.fileno())
        except OSError as error:
            said = "another study is at work in this folder; expected one at a time"
            raise WriteError(f"{path.parent}: {said}") from error
        yield


if sys.platform == "win32":
    import msvcrt

    def hold(descriptor: int) -> None:
        """Hold an open file, or raise OSError at once."""
        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)

else:
    import fcntl

    def hold(descriptor: int) -> None:
        """Hold an open file, or raise OSError at once."""
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
