"""Verify workbooks, whatever they are: one, or files and folders by a pool of workers. Nothing is written."""

import hashlib
import os
import stat
import tempfile
import time
import zipfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fnmatch import fnmatch
from pathlib import Path
from typing import Any, Literal, NamedTuple

from workbook import errors
from workbook.errors import MotionbookError, WitnessError, visible
from workbook.failure import failure_line
from workbook.judging.report import Report
from workbook.judging.verify import verify
from workbook.pool import THIS_PROCESS, Pool, WorkerDied, collecting_between, collector_paused
from workbook.reading.files import SUFFIXES
from workbook.reading.guard import DAMAGE
from workbook.text_files import irregular_kind
from workbook.witnesses.witness import in_full

MOST_READ = 2**24  # bytes of a workbook's list of names

Verdict = Literal["agrees", "fails", "disagrees", "unreadable", "no machine"]


class Target(NamedTuple):
    """A workbook to verify; ``named`` where it was named itself, not met in a folder."""

    path: Path
    named: bool


@dataclass(frozen=True)
class Outcome:
    """The outcome for a workbook: a report, or the reason why there is none."""

    path: Path
    verdict: Verdict
    report: Report | None = None
    reason: str = ""
    sha256: str = ""
    seconds: float = 0.0


def no_report(path: Path, reason: str, verdict: Verdict = "unreadable") -> Outcome:
    """Return the outcome for a file of which there is no report."""
    return Outcome(path, verdict, reason=visible(f"{path}: {reason}"))


def lack_of_machine(path: Path) -> str:
    """Return why a file is, by its list of names, a workbook without a machine; nothing where that is not known."""
    try:
        with zipfile.ZipFile(path) as archive:
            parts = [name for name in archive.namelist() if fnmatch(name, "xl/workbook*.xml")]
            lists = (archive.open(part).read(MOST_READ) for part in parts)
            is_foreign = parts and not any(b"book_template" in names for names in lists)
            return "holds no machine of motionbook" if is_foreign else ""
    except (*DAMAGE, RuntimeError):
        return ""


def verify_one(target: Target, witnesses: Sequence[str]) -> Outcome:
    """Verify a workbook, whatever it is; the outcome says so where it cannot be read or changes meanwhile."""
    path, begin = target.path, time.perf_counter()
    try:
        kind = "" if target.named else irregular_kind(path) or lack_of_machine(path)
        if kind:
            return no_report(path, kind, "no machine")
        before = file_state(path)
        with collector_paused():
            report = verify(path, witnesses)
        sha256 = file_digest(path)
        if before and file_state(path) != before:
            return no_report(path, "cannot be read: it changed while it was read; try again")
    except WitnessError as error:
        return no_report(path, str(error))
    except MotionbookError as error:
        return Outcome(path, "unreadable", reason=str(error))
    except FileNotFoundError:
        return no_report(path, "there is no such file")
    except OSError as error:
        return no_report(path, f"cannot be read: {error.strerror or error}")
    except Exception as error:  # a strange file must not take the others' verdicts with it
        what, command = "verifying it failed inside motionbook", ["verify", str(path)]
        return no_report(path, failure_line(what, error, command))
    return judge(path, report, sha256, begin)


def judge(path: Path, report: Report, sha256: str, begin: float) -> Outcome:
    """Return the outcome of a report; it has no report where only an evaluator failed, as no cell is known wrong."""
    if report.findings and all(finding.kind == "witness" for finding in report.findings):
        finding = report.findings[0]
        version = next(ran.version for ran in report.witnesses if ran.name == finding.cell)
        witness = in_full(finding.cell, version)
        return no_report(path, f"{witness} gave no values to compare: {finding.computed}")
    verdict: Verdict = "disagrees" if not report.agrees else "agrees" if report.holds else "fails"
    return Outcome(path, verdict, report, sha256=sha256, seconds=time.perf_counter() - begin)


def file_digest(path: Path) -> str:
    """Return the SHA-256 of a file."""
    with path.open("rb") as data:
        return hashlib.file_digest(data, "sha256").hexdigest()


def file_state(path: Path) -> tuple[int, int] | None:
    """Return size and time of change of a file, None where there is none."""
    with suppress(OSError):  # opening it says why
        return (known := path.stat()).st_size, known.st_mtime_ns
    return None


LARGEST = 200_000_000  # bytes of a file that is sent


class SentBook(NamedTuple):
    """A workbook for a machine that may not see the file: its bytes, or None where they cannot be had."""

    target: Target
    place: str
    data: bytes | None


def packed_book(target: Target) -> SentBook:
    """Return a workbook as it is handed out; a file that cannot be read goes by its path, and the worker says so."""
    path, data = target.path.absolute(), None
    with suppress(OSError):
        data = path.read_bytes() if path.is_file() and path.stat().st_size <= LARGEST else None
    return SentBook(target, str(path), data)


def verify_sent(book: SentBook, witnesses: Sequence[str]) -> Outcome:
    """Verify a workbook on another machine; its outcome names it as it was named here."""
    name = book.target.path
    with tempfile.TemporaryDirectory() as folder:
        place = Path(book.place) if book.data is None else Path(folder, name.name)
        if book.data is not None:
            place.write_bytes(book.data)
        outcome = verify_one(Target(place, book.target.named), witnesses)
    report = replace(outcome.report, path=name) if outcome.report else None
    reason = outcome.reason.replace(str(place), str(name))
    return replace(outcome, path=name, report=report, reason=reason)


def exit_code(outcomes: Iterable[Outcome]) -> int:
    """Return the gravest: 2 where any cannot be read or none was verified, 1 for cells, 3 for a design, 0 for none."""
    verdicts = {outcome.verdict for outcome in outcomes}
    if "unreadable" in verdicts or not verdicts - {"no machine"}:
        return errors.UNREADABLE
    if "disagrees" in verdicts:
        return errors.DISAGREES
    return errors.FAILS if "fails" in verdicts else errors.AGREES


def find_workbooks(paths: Sequence[Path]) -> tuple[list[Target], list[Outcome]]:
    """Return the workbooks that paths name or hold, each once and no hidden or lock files, and what cannot be read."""
    targets: dict[Path, Target] = {}
    failed: list[Outcome] = []
    for path in paths:
        if os.path.isdir(path):  # not where the system cannot tell, as of a name longer than any
            if not (workbooks := list(workbooks_in(path, failed))):
                failed.append(no_report(path, "there is no workbook in this folder"))
        else:
            workbooks = [Target(path, named=True)]
        for target in workbooks:
            if target.named or target.path.absolute() not in targets:
                targets[target.path.absolute()] = target
    return list(targets.values()), failed


def workbooks_in(folder: Path, failed: list[Outcome]) -> Iterator[Target]:
    """Yield the workbooks in a folder and its folders, in the order of their names."""
    errors = list[OSError]()
    for place, folders, files in os.walk(folder, onerror=errors.append):
        folders[:] = sorted(name for name in folders if not hidden(Path(place, name)))
        for name in sorted(files):
            path = Path(place, name)
            if path.suffix.lower() in SUFFIXES and not name.startswith("~$") and not hidden(path):
                yield Target(path, named=False)
    for error in errors:
        reason = f"cannot be listed: {error.strerror or error}"
        failed.append(no_report(Path(error.filename or folder), reason))


def hidden(path: Path) -> bool:
    """Whether a file or folder is hidden, in the way of Unix or of Windows."""
    with suppress(OSError):
        # Windows only
        if getattr(path.stat(), "st_file_attributes", 0) & stat.FILE_ATTRIBUTE_HIDDEN:
            return True
    return path.name.startswith(".")


def verify_many(
    targets: Sequence[Target],
    witnesses: Sequence[str] = ("pycel",),
    pool: Pool = THIS_PROCESS,
    done: Callable[[Outcome], object] = lambda outcome: None,
) -> list[Outcome]:
    """Verify workbooks by a pool; call ``done`` as each is finished."""
    outcomes: dict[Target, Outcome] = {}
    for target, outcome in verify_by_pool(targets, witnesses, pool):
        outcomes[target] = outcome
        done(outcome)
    return [outcomes[target] for target in targets]


def verify_by_pool(
    targets: Sequence[Target], witnesses: Sequence[str], pool: Pool, is_last: bool = False
) -> Iterator[tuple[Target, Outcome]]:
    """Verify by a pool, where a worker dies once more by a fresh pool unless this ``is_last``; yield each outcome."""
    here = collecting_between(targets) if pool is THIS_PROCESS else targets
    books: Iterable[Any] = map(packed_book, targets) if pool.distant else here
    died = []
    for book, outcome in pool.each(verify_sent if pool.distant else verify_one, books, witnesses):
        target = book.target if isinstance(book, SentBook) else book
        if not isinstance(outcome, WorkerDied):
            yield target, outcome
        elif is_last:
            yield target, no_report(target.path, "verifying it ended the process (out of memory?)")
        else:
            died.append(target)
    for target in died:
        with pool.alone() as fresh:
            yield from verify_by_pool([target], witnesses, fresh, is_last=True)
