"""The saves of books that are watched: each read once it is whole, and judged in a process that stays."""

import asyncio
import hashlib
import io
import tempfile
import time
import zipfile
from collections import OrderedDict
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from typing import Any

from workbook.differences.design import Change, Design, changed_results, changes
from workbook.errors import MotionbookError
from workbook.failure import failure_line
from workbook.judging.batch import Outcome, SentBook, Target, file_state, judge, no_report, verify_sent
from workbook.judging.warm import WarmBook
from workbook.pool import collector_paused
from workbook.reports.page import VERDICTS, own_verdict
from workbook.serve.work import Work, WorkError

TRIES, PAUSE = 20, 0.25  # readings of a file until it is whole, and the seconds between them
MOST_HELD = 2  # books of which formulas and values are in memory: some 200 MB each
DAILY = ("pycel",)


@dataclass(frozen=True)
class Changes:
    """The entries and results that differ from the save before."""

    entries: list[Change] = field(default_factory=list)
    results: list[Change] = field(default_factory=list)


@dataclass(frozen=True)
class Verdict:
    """The verdict on a save; not ``whole`` where values alone are judged yet, at the entries of the save."""

    when: datetime
    outcome: Outcome
    changes: Changes
    whole: bool

    @property
    def is_ok(self) -> bool:
        """Whether every cell agrees and the machine passes its own checks."""
        return self.outcome.verdict == "agrees"

    @property
    def sentence(self) -> str:
        """The verdict in a sentence."""
        report = self.outcome.report
        if report is None:
            return self.outcome.reason
        words = VERDICTS[self.outcome.verdict].page
        cells = f"{report.compared:,} of {report.declared:,} formula cells compute what the engine computes"
        cells = cells if report.agrees else report.findings_words
        rest = "" if self.whole else "; what is shown, and other entries, are being compared"
        return f"{words}: {cells}; the machine's own checks: {own_verdict(report)}{rest}"


class WatchedBook:
    """A watched book in the process that judges it: its formulas, and its design as of the latest save."""

    def __init__(self) -> None:
        self.book = WarmBook()
        self.design: Design | None = None


_books: OrderedDict[Path, WatchedBook] = OrderedDict()


def judge_values(path: Path, data: bytes) -> tuple[Outcome, Changes] | None:
    """Return the outcome of the values of a save, and its changes; None where only ``verify`` can judge it."""
    watched, begin = _books.setdefault(path, WatchedBook()), time.perf_counter()
    _books.move_to_end(path)
    while len(_books) > MOST_HELD:
        _books.popitem(last=False)
    with tempfile.TemporaryDirectory() as folder, suppress(MotionbookError):  # verify says what is wrong
        copy = Path(folder, path.name)
        copy.write_bytes(data)
        with collector_paused():
            judged = watched.book.judge_values(copy)
        before, watched.design = watched.design, Design(path, judged.machine, judged.declared)
        report = replace(judged.report, path=path)
        return judge(path, report, hashlib.sha256(data).hexdigest(), begin), changes_between(before, watched.design)
    watched.design = None
    return None


def changes_between(before: Design | None, design: Design) -> Changes:
    """Return the differences between two saves of a book."""
    if before is None or before.machine.template != design.machine.template:
        return Changes()
    results = [change for change in changed_results(before, design) if change.is_shown]
    return Changes(changes(before.entries(), design.entries()), results)


async def read_whole(path: Path) -> bytes | None:
    """Return the bytes of a save once it is whole, or as it is at last; None of a file that is not there.

    A program that writes a file, or holds it closed to others, is waited for; a zip's directory is written last.
    """
    data = None
    for _ in range(TRIES):
        data, before = None, file_state(path)
        with suppress(OSError):
            data = path.read_bytes()
            if before == file_state(path) and zipfile.is_zipfile(io.BytesIO(data)):
                return data
        await asyncio.sleep(PAUSE)
    return data


class Saves:
    """Books that are watched, with the latest verdict on each."""

    def __init__(self, work: Work, tell: Callable[[Path, Verdict], Any]) -> None:
        self.verdicts: dict[Path, Verdict] = {}
        self._work, self._tell = work, tell
        self._digests: dict[Path, str] = {}  # of the saves that have these verdicts
        self._waiting: dict[Path, None] = {}
        self._noted = asyncio.Event()

    def note(self, path: Path) -> None:
        """Note that a book may have been saved."""
        self._waiting[path] = None
        self._noted.set()

    async def judge_each(self) -> None:
        """Judge saves as they are noted, for ever."""
        while True:
            await self._noted.wait()
            while self._waiting:
                path = next(iter(self._waiting))
                del self._waiting[path]
                await self._judge(path)
            self._noted.clear()

    async def _judge(self, path: Path) -> None:
        """Judge a save, unless it is that which was judged: values first; the rest unless the next save came."""
        data = await read_whole(path)
        if data is None:
            return
        digest = hashlib.sha256(data).hexdigest()
        last = self.verdicts.get(path) if self._digests.get(path) == digest else None
        if last and last.whole:
            return
        try:
            if last is None and (judged := await self._work.in_worker(judge_values, path, data)):
                last = Verdict(datetime.now().astimezone(), *judged, whole=False)
                self._say(path, digest, last)
            if path in self._waiting:
                return
            outcome = await self._work.in_worker(
                verify_sent, SentBook(Target(path, named=True), str(path), data), DAILY
            )
        except WorkError as error:
            outcome = no_report(path, str(error))
        except Exception as error:  # a strange file must not end the watch over others, and is told
            outcome = no_report(
                path, failure_line("verifying it failed inside motionbook", error, ["watch", str(path)])
            )
        changed = last.changes if last else Changes()
        self._say(path, digest, Verdict(datetime.now().astimezone(), outcome, changed, whole=True))

    def _say(self, path: Path, digest: str, verdict: Verdict) -> None:
        self.verdicts[path], self._digests[path] = verdict, digest
        self._tell(path, verdict)
