"""Verify one workbook, whatever it is, and say what became of it. Nothing is written."""

import hashlib
import time
import zipfile
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from typing import Literal, NamedTuple

from workbook.collector import collector_paused
from workbook.errors import MotionbookError
from workbook.intake import odd
from workbook.judging.report import Report
from workbook.judging.verify import verify
from workbook.visible import visible
from workbook.witnesses.beside import Beside

MOST_READ = 2**24  # bytes of a workbook's list of names

Verdict = Literal["agrees", "fails", "disagrees", "unreadable", "no machine"]


class Target(NamedTuple):
    """A workbook to verify; ``named`` where it was named itself, not found in a folder."""

    path: Path
    named: bool


@dataclass(frozen=True)
class Outcome:
    """What became of one workbook: a report, or the reason why there is none."""

    path: Path
    verdict: Verdict
    report: Report | None = None
    reason: str = ""
    sha256: str = ""
    seconds: float = 0.0


def foreign(path: Path) -> bool:
    """Whether a file is a whole workbook without a machine of motionbook, by its list of names alone.

    False also where that cannot be told: then opening the file says what is wrong with it.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            parts = [name for name in archive.namelist() if fnmatch(name, "xl/workbook*.xml")]
            lists = (archive.open(part).read(MOST_READ) for part in parts)
            return bool(parts) and not any(b"book_template" in names for names in lists)
    except (OSError, zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, ValueError, EOFError):
        return False


def verify_one(target: Target, witnesses: Sequence[str], beside: Beside | None = None) -> Outcome:
    """Verify one workbook, whatever it is; the outcome says so where it cannot be read or changes meanwhile."""
    path, begin = target.path, time.perf_counter()

    def without(verdict: Verdict, reason: object) -> Outcome:
        return Outcome(path, verdict, reason=visible(f"{path}: {reason}"))

    try:
        if not target.named and (kind := odd(path)):
            return without("no machine", kind)
        if not target.named and foreign(path):
            return without("no machine", "holds no machine of motionbook")
        before = state(path)
        with collector_paused():
            report = verify(path, witnesses, beside)
        sha256 = digest(path)
        if before and state(path) != before:
            return without("unreadable", "cannot be read: it changed while it was read; try again")
    except MotionbookError as error:
        return Outcome(path, "unreadable", reason=str(error))
    except FileNotFoundError:
        return without("unreadable", "there is no such file")
    except OSError as error:
        return without("unreadable", f"cannot be read: {error.strerror or error}")
    except Exception as error:  # one strange file must not take the others' verdicts with it
        said = f"verifying it failed inside motionbook ({type(error).__name__}: {error}); please report this"
        return without("unreadable", said)
    if report.findings and all(one.kind == "witness" for one in report.findings):  # no cell is known to be wrong
        found = report.findings[0]
        return without("unreadable", f"{found.cell} gave no values to compare: {found.computed}")
    verdict: Verdict = "disagrees" if not report.agrees else "agrees" if report.holds else "fails"
    return Outcome(path, verdict, report, sha256=sha256, seconds=time.perf_counter() - begin)


def state(path: Path) -> tuple[int, int] | None:
    """Return size and time of change of a file, None where there is none."""
    try:
        known = path.stat()
    except OSError:  # opening it says why
        return None
    return known.st_size, known.st_mtime_ns


def digest(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as data:
        return hashlib.file_digest(data, "sha256").hexdigest()
