"""Verify many workbooks: files and folders, over the cores of the machine, one outcome each. Nothing is written."""

from __future__ import annotations

import hashlib
import multiprocessing
import os
import signal
import stat
import time
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from typing import Literal, NamedTuple

from workbook.collector import collector_paused, swept_between
from workbook.errors import MotionbookError
from workbook.exits import AGREES, DISAGREES, FAILS, UNREADABLE
from workbook.intake import odd
from workbook.judging.report import Report
from workbook.judging.verify import verify
from workbook.reading.files import SUFFIXES
from workbook.visible import visible
from workbook.witnesses.beside import Beside

MOST_JOBS = 61  # Windows waits for no more processes at once
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


def exit_code(outcomes: Iterable[Outcome]) -> int:
    """Return the gravest: 2 where a file cannot be read or none was verified, 1 where cells of one disagree.

    Else 3 where the cells agree and a design is unfinished or fails its own checks, and 0 where none does.
    """
    verdicts = {outcome.verdict for outcome in outcomes}
    if "unreadable" in verdicts or not verdicts - {"no machine"}:
        return UNREADABLE
    return DISAGREES if "disagrees" in verdicts else FAILS if "fails" in verdicts else AGREES


def find(paths: Sequence[Path]) -> tuple[list[Target], list[Outcome]]:
    """Return the workbooks that ``paths`` name or hold, each once, and what of them cannot be read.

    Lock files (``~$``) and hidden files and folders are passed over; links to folders are not followed.
    """
    targets: dict[Path, Target] = {}
    failed: list[Outcome] = []
    for path in paths:
        if is_folder(path):
            found = list(within(path, failed))
            if not found:
                failed.append(
                    Outcome(path, "unreadable", reason=visible(f"{path}: there is no workbook in this folder"))
                )
        else:
            found = [Target(path, named=True)]
        for target in found:
            key = target.path.absolute()
            if target.named or key not in targets:
                targets[key] = target
    return list(targets.values()), failed


def is_folder(path: Path) -> bool:
    """Whether a path leads to a folder; not where the system cannot tell, as of a name longer than any."""
    try:
        return path.is_dir()
    except OSError:
        return False


def within(folder: Path, failed: list[Outcome]) -> Iterator[Target]:
    """Yield the workbooks in a folder and its folders, in the order of their names."""

    def fail(error: OSError) -> None:
        where = Path(error.filename or folder)
        failed.append(
            Outcome(where, "unreadable", reason=visible(f"{where}: cannot be listed: {error.strerror or error}"))
        )

    for place, folders, files in os.walk(folder, onerror=fail):
        folders[:] = sorted(name for name in folders if not hidden(Path(place, name)))
        for name in sorted(files):
            path = Path(place, name)
            if path.suffix.lower() in SUFFIXES and not name.startswith("~$") and not hidden(path):
                yield Target(path, named=False)


def hidden(path: Path) -> bool:
    """Whether a file or folder is hidden, in the way of Unix or of Windows."""
    try:
        attributes = getattr(path.stat(), "st_file_attributes", 0)  # Windows only
    except OSError:
        attributes = 0
    return path.name.startswith(".") or bool(attributes & stat.FILE_ATTRIBUTE_HIDDEN)


def foreign(path: Path) -> bool:
    """Whether a file is a whole workbook without a machine of motionbook, by its list of names alone.

    False also where that cannot be told: then opening the file says what is wrong with it.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            parts = [name for name in archive.namelist() if fnmatch(name, "xl/workbook*.xml")]
            return bool(parts) and not any(holds_our_name(archive, part) for part in parts)
    except (OSError, zipfile.BadZipFile, zlib.error, NotImplementedError, RuntimeError, ValueError, EOFError):
        return False


def holds_our_name(archive: zipfile.ZipFile, part: str) -> bool:
    """Whether a part of a workbook speaks of the name by which motionbook knows its own."""
    with archive.open(part) as data:
        return b"book_template" in data.read(MOST_READ)


def verify_one(target: Target, witnesses: Sequence[str], beside: Beside | None = None) -> Outcome:
    """Verify one workbook, whatever it is; the outcome says so where it cannot be read or changes meanwhile."""
    path, begin = target.path, time.perf_counter()
    try:
        if not target.named and (kind := odd(path)):
            return Outcome(path, "no machine", reason=visible(f"{path}: {kind}"))
        if not target.named and foreign(path):
            return Outcome(path, "no machine", reason=visible(f"{path}: holds no machine of motionbook"))
        before = state(path)
        with collector_paused():
            report = verify(path, witnesses, beside)
        sha256 = digest(path)
        if before and state(path) != before:
            raise OSError("it changed while it was read; try again")
    except MotionbookError as error:
        return Outcome(path, "unreadable", reason=str(error))
    except FileNotFoundError:
        return Outcome(path, "unreadable", reason=visible(f"{path}: there is no such file"))
    except OSError as error:
        return Outcome(path, "unreadable", reason=visible(f"{path}: cannot be read: {error.strerror or error}"))
    except Exception as error:  # one strange file must not take the others' verdicts with it
        reason = f"{path}: verifying it failed inside motionbook ({type(error).__name__}: {error}); please report this"
        return Outcome(path, "unreadable", reason=visible(reason))
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


def verify_many(
    targets: Sequence[Target],
    witnesses: Sequence[str] = ("pycel",),
    jobs: int | None = None,
    done: Callable[[Outcome], object] = lambda outcome: None,
    beside: Beside | None = None,
) -> list[Outcome]:
    """Verify workbooks over ``jobs`` processes (all cores where None); call ``done`` as each is finished.

    The outcomes come in the order of ``targets``. A single workbook, or a single job, needs no process of its own;
    ``beside`` may be one that evaluates the single workbook meanwhile.
    """
    jobs = min(jobs or cores(), len(targets), MOST_JOBS)
    outcomes: dict[Target, Outcome] = {}

    def keep(target: Target, outcome: Outcome) -> None:
        outcomes[target] = outcome
        done(outcome)

    if jobs <= 1:
        for target in swept_between(targets):
            keep(target, verify_one(target, witnesses, beside))
    else:
        in_processes(targets, witnesses, jobs, keep)
        for target in targets:  # left over by a process that died: each alone, to find which one killed it
            if target not in outcomes:
                in_processes([target], witnesses, 1, keep)
            if target not in outcomes:
                reason = f"{target.path}: verifying it ended the process (out of memory?)"
                keep(target, Outcome(target.path, "unreadable", reason=visible(reason)))
    return [outcomes[target] for target in targets]


def cores() -> int:
    """Return how many cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def in_processes(
    targets: Sequence[Target], witnesses: Sequence[str], jobs: int, keep: Callable[[Target, Outcome], object]
) -> None:
    """Verify over processes, until all is done or a process dies; interrupted, leave none of them running."""
    others = set(multiprocessing.active_children())
    context = multiprocessing.get_context("spawn")  # the same on every system, and safe beside threads
    pool = ProcessPoolExecutor(jobs, mp_context=context, initializer=ignore_interrupts)
    waiting = iter(targets)
    running: dict[Future[Outcome], Target] = {}
    try:
        while True:
            while len(running) <= jobs and (target := next(waiting, None)):  # one more than jobs: no one idles
                running[pool.submit(verify_one, target, witnesses)] = target
            if not running:
                break
            for future in wait(running, return_when=FIRST_COMPLETED).done:
                keep(running.pop(future), future.result())
    except BrokenProcessPool:
        pass
    except BaseException:
        for child in set(multiprocessing.active_children()) - others:
            child.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def ignore_interrupts() -> None:
    """Leave Ctrl-C, which reaches every process of a terminal, to the first of them."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
