"""A study's results as files: its parts on the way, in a folder for the study, each whole or not there; all of them."""

import csv
import hashlib
import io
import json
import re
import shutil
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import asdict
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from workbook.errors import WriteError
from workbook.studies.evaluate import Table
from workbook.studies.summary import Summary
from workbook.writing.output_files import replace, write_error

FORMATS = (".csv", ".parquet")
ENDS = ("feasible", "fails", "impossible")  # the last columns of a table
EXTRA = "Parquet wants the package pyarrow: pip install pyarrow; or name the results .csv"
LOCK, STUDY_FILE = "lock", "study.json"
OWN = re.compile(r"part-[0-9]{8}\.(json|csv|parquet)|\.motionbook-[0-9a-f]{16}\.part")
"""the files of a part, and the drafts left where a process ended; no others are removed"""
NOTED = re.compile(r"part-([0-9]{8})\.json")  # the file that is written last of a part
STEP = 64
ANOTHER = (
    "holds parts of another study, or of this one before it was changed; --force begins anew, -o names other results"
)


class Parts:
    """The folder of a study's parts, of ``step`` designs each: a study that goes on keeps the number it began with."""

    def __init__(self, results: Path, digest: str, size: int, step: int = STEP) -> None:
        self.folder, self.suffix, self.step = folder_of(results), results.suffix.lower(), step
        self._study = {"digest": digest, "size": size, "suffix": self.suffix}

    @property
    def mine(self) -> bool:
        """Whether parts of this very study lie there."""
        return noted_study(self.folder).items() >= self._study.items()

    @property
    def held(self) -> str:
        """The sentence that names the complete parts of this study and the option that goes on with them."""
        return f"holds {len(self.complete())} complete parts of this study; --resume goes on with them"

    @contextmanager
    def opened(self, resume: bool, force: bool) -> Iterator[None]:
        """Hold the folder for this study alone; raise WriteError where another study is at work in it, or was."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise write_error(self.folder, error) from error
        with locked(self.folder / LOCK):
            note = self.folder / STUDY_FILE
            if resume and self.mine:
                self.step = int(noted_study(self.folder).get("step", self.step))
            elif note.exists() and not force:
                problem = f"{self.held}, --force begins anew" if self.mine else ANOTHER
                raise WriteError(f"{self.folder}: {problem}")
            else:
                for path in self._own():
                    path.unlink()
            write_part(note, json.dumps(self._study | {"step": self.step}).encode())
            yield

    def complete(self) -> set[int]:
        """Return the numbers of the parts whose rows have the length and the digest that were noted when written."""
        complete = set()
        for number in numbers(self.folder):
            with suppress(OSError, ValueError, TypeError, KeyError):
                if json.loads(read(self._noted(number)))["rows"] == size_and_digest(self.rows(number).read_bytes()):
                    complete.add(number)
        return complete

    def _own(self) -> list[Path]:
        """Return the files of parts; what else lies in the folder is somebody's own."""
        return [path for path in self.folder.iterdir() if OWN.fullmatch(path.name)]

    def _noted(self, number: int) -> Path:
        return self.folder / f"part-{number:08}.json"

    def rows(self, number: int) -> Path:
        """Return the file of a part's rows."""
        return self.folder / f"part-{number:08}{self.suffix}"

    def summary(self, number: int) -> Summary:
        """Return the summary of a complete part."""
        return Summary.of_data(json.loads(read(self._noted(number)))["summary"])

    def keep(self, number: int, rows: bytes, summary: Summary) -> None:
        """Keep a part: its rows, and then what tells whether they are whole."""
        write_part(self.rows(number), rows)
        noted = {"rows": size_and_digest(rows), "summary": asdict(summary)}
        write_part(self._noted(number), json.dumps(noted, ensure_ascii=False).encode())

    def remove(self) -> None:
        """Remove the parts, and the folder unless something else lies in it."""
        with suppress(OSError):
            for path in [*self._own(), self.folder / STUDY_FILE, self.folder / LOCK]:
                path.unlink(missing_ok=True)
            self.folder.rmdir()


def write_part(path: Path, data: bytes) -> None:
    """Write a file whole or not at all; raise WriteError where there is no room."""
    try:
        replace(path, lambda draft: draft.write_bytes(data), overwrite=True)
    except WriteError as error:
        raise WriteError(f"{error}; --resume goes on when that is mended") from error


def progress(results: Path) -> tuple[int, int]:
    """Return how many designs of an unfinished study are worked out, and how many there are; 0 of 0 of none."""
    folder = folder_of(results)
    with suppress(ValueError, TypeError, KeyError):
        noted = noted_study(folder)
        return min(int(noted["size"]), len(numbers(folder)) * int(noted["step"])), int(noted["size"])
    return 0, 0


def numbers(folder: Path) -> list[int]:
    """Return the numbers of the parts that a folder names as written."""
    return [int(match[1]) for path in folder.glob("part-*") if (match := NOTED.fullmatch(path.name))]


def folder_of(results: Path) -> Path:
    """Return the folder beside the results."""
    return results.with_name(f"{results.name}.parts")


def noted_study(folder: Path) -> dict[str, Any]:
    """Return the notes on the study that lies in a folder."""
    with suppress(ValueError):
        noted = json.loads(read(folder / STUDY_FILE))
        return noted if isinstance(noted, dict) else {}
    return {}


def size_and_digest(rows: bytes) -> list[Any]:
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
    """Hold a file against all other processes; the system lets go of it when this process ends, however it does."""
    try:
        file = path.open("a+b")
    except OSError as error:
        raise write_error(path, error) from error
    with file:
        try:
            if sys.platform == "win32":
                import msvcrt

                msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
            else:
                import fcntl

                fcntl.flock(file.fileno(), fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            problem = "another study is at work in this folder; expected one at a time"
            raise WriteError(f"{path.parent}: {problem}") from error
        yield


def require_format(path: Path) -> None:
    """Raise WriteError for an unknown suffix, and for a suffix whose package is missing."""
    if path.suffix.lower() not in FORMATS:
        raise WriteError(f"{path}: results are written as {' or '.join(FORMATS)}; expected one of these endings")
    if path.suffix.lower() == ".parquet" and find_spec("pyarrow") is None:
        raise WriteError(f"{path}: {EXTRA}")


def part_bytes(labels: list[str], table: Table, suffix: str) -> bytes:
    """Return a table as a part of a file of this suffix, without its head.

    Its columns: number, entries, results, whether a design is feasible, and why not.
    """
    columns: dict[str, list[Any]] = {"design": list(range(table.begin + 1, table.begin + len(table) + 1))}
    for label, column in zip(labels, table.entries, strict=True):
        columns[label] = np.array(list(column.values), dtype=object)[column.places].tolist()
    for name, values in table.results.items():
        columns[name] = [None if value != value else value for value in values.tolist()]
    # the names of the constraints that a design does not keep to
    failing = np.full(len(table), "", dtype=object)
    for name, fails in table.fails.items():
        failing[fails] += f" {name}"
    ends = np.where(table.feasible, "yes", "no").tolist(), [n.lstrip() for n in failing], table.reasons.tolist()
    columns |= dict(zip(ENDS, ends, strict=True))
    if suffix == ".csv":
        return lines(zip(*columns.values(), strict=True))
    import pyarrow
    import pyarrow.parquet

    stream = io.BytesIO()
    pyarrow.parquet.write_table(pyarrow.table(columns), stream)
    return stream.getvalue()


def lines(rows: Iterable[Iterable[Any]]) -> bytes:
    """Return rows as lines of CSV."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue().encode()


def join(names: Sequence[str], parts: Sequence[Path], path: Path, suffix: str) -> None:
    """Write parts after each other into a file, a part at a time; Parquet of the kinds that all of them have."""
    if suffix == ".csv":
        with path.open("wb") as file:
            file.write(lines([names]))
            for part in parts:
                with part.open("rb") as rows:
                    shutil.copyfileobj(rows, file)
        return
    import pyarrow
    import pyarrow.parquet

    schemas = [pyarrow.parquet.read_schema(part) for part in parts]
    schema = pyarrow.unify_schemas(schemas, promote_options="permissive")
    with pyarrow.parquet.ParquetWriter(path, schema) as writer:
        for part in parts:
            writer.write_table(pyarrow.parquet.read_table(part).cast(schema))
