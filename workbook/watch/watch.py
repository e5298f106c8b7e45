"""``motionbook watch``: the verdict on each save of a book, on the terminal and on a page that updates itself."""

import asyncio
import json
import os
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from watchfiles import awatch

from workbook.differences.design import Change
from workbook.errors import ReadError
from workbook.judging.batch import exit_code, find_workbooks
from workbook.reading.files import SUFFIXES
from workbook.reports import differences
from workbook.reports.console import findings_data, plain
from workbook.reports.html import render
from workbook.reports.page import line
from workbook.reports.terminal import OUT, say, say_data
from workbook.serve import pages
from workbook.serve.handler import Action, Folder, Page
from workbook.serve.server import STATIC, serving, static
from workbook.serve.work import Work
from workbook.watch.saves import Saves, Verdict

MOST = 12  # findings, entries and results that are listed
LONGEST = 600.0  # seconds of a verdict


class Watch:
    """Books, or folders of them, that are watched; ends with the first verdict on a save where it is for ``once``."""

    def __init__(self, paths: Sequence[Path], once: bool, as_json: bool, until_eof: bool) -> None:
        self.paths, self.once, self.as_json = [path.resolve() for path in paths], once, as_json
        self.until_eof = until_eof
        self.code: int | None = None
        self._ended = asyncio.Event()
        # no work leaves a file behind
        self._temporary = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self._work = Work(patience=LONGEST, temporary=self._temporary.name)
        self.saves = Saves(self._work, self._tell)

    async def run(self, port: int, browse: bool) -> int:
        """Watch until the first verdict, or until it is interrupted; return the exit code of ``verify``."""
        if absent := [path for path in self.paths if not path.exists()]:
            raise ReadError(f"{absent[0]}: there is no such file or folder")
        targets, _ = find_workbooks(self.paths)
        try:
            async with asyncio.TaskGroup() as tasks:
                running = [tasks.create_task(self._notice()), tasks.create_task(self.saves.judge_each())]
                if not (self.once or self.as_json):
                    running.append(tasks.create_task(self._serve(port, browse)))
                for target in () if self.once else targets:
                    self.saves.note(target.path)
                if self.until_eof:
                    end = partial(asyncio.get_running_loop().call_soon_threadsafe, self._ended.set)
                    threading.Thread(target=read_to_end, args=(end,), daemon=True).start()
                await self._ended.wait()
                for task in running:
                    task.cancel()
        finally:
            self._work.stop()
            self._temporary.cleanup()
        return self.code or 0

    async def _notice(self) -> None:
        """Note each save of a book: whatever happens to a file of its name."""
        folders = {path if path.is_dir() else path.parent for path in self.paths}
        is_deep = any(path.is_dir() for path in self.paths)
        async for happened in awatch(*folders, step=50, debounce=400, recursive=is_deep):
            for path in {Path(name) for _, name in happened}:
                if self._is_watched(path):
                    self.saves.note(path)

    def _is_watched(self, path: Path) -> bool:
        """Whether a file is a book that is watched; lock files and hidden ones are none."""
        if path.name.startswith(("~$", ".")) or path.suffix.lower() not in SUFFIXES:
            return False
        return path in self.paths or any(folder in path.parents for folder in self.paths if folder.is_dir())

    async def _serve(self, port: int, browse: bool) -> None:
        actions: dict[str, Action] = {"/": self._page, "/now": self._fragment, STATIC: static}
        shared = {"folder": Folder(self.paths[0].parent), "work": self._work}
        async with serving(actions, {}, shared, port, browse):
            await asyncio.Event().wait()

    async def _page(self, page: Page) -> str:
        """Return the page."""
        return pages.page("motionbook watch", "followed", at_home=True, follow="/now")

    async def _fragment(self, page: Page) -> str:
        """Return the verdicts as they are now."""
        is_ok = all(verdict.is_ok for verdict in self.saves.verdicts.values())
        verdicts = sorted(self.saves.verdicts.items(), key=lambda item: item[1].when, reverse=True)
        waiting = [path.name for path in self.paths if not path.is_dir() and path not in self.saves.verdicts]
        return render(
            "watch/verdicts.html",
            verdicts=verdicts,
            waiting=waiting,
            state="" if not verdicts else "OK" if is_ok else "FAIL",
        )

    def _tell(self, path: Path, verdict: Verdict) -> None:
        """Tell a verdict on the terminal: the sentence, what the save changed, findings, checks that fail."""
        if self.as_json:
            say_data(f"{json.dumps(as_data(path, verdict), ensure_ascii=False)}\n")
        else:
            self._say(path, verdict)
        if self.once and verdict.whole:
            self.code = exit_code([verdict.outcome])
            self._ended.set()

    def _say(self, path: Path, verdict: Verdict) -> None:
        colour = "green" if verdict.is_ok else "red"
        say(OUT, f"{verdict.when:%H:%M:%S}  {path.name}: {verdict.sentence}", colour)
        changed, report = verdict.changes, verdict.outcome.report
        for change in (*changed.entries, *changed.results)[:MOST] if not verdict.whole else ():
            place, label, old, new, unit, apart, _ = differences.row(change)
            say(OUT, f"    {place}: {label}: {old} → {new} {unit} {apart}".rstrip())
        for text in [*map(line, report.causes[:MOST]), *(check.line for check in report.failing)] if report else ():
            say(OUT, f"    {text}", "red")


def read_to_end(end: Callable[[], object]) -> None:
    """Read standard input to its end, and call ``end`` then."""
    while os.read(sys.stdin.fileno(), 4096):
        pass
    end()


async def watch(paths: Sequence[Path], once: bool, as_json: bool, until_eof: bool, port: int, browse: bool) -> int:
    """Watch books until the first verdict, or until it is interrupted; return the exit code of ``verify``."""
    return await Watch(paths, once, as_json, until_eof).run(port, browse)


def as_data(path: Path, verdict: Verdict) -> dict[str, Any]:
    """Return a verdict as JSON has it."""
    outcome, changed = verdict.outcome, verdict.changes
    report = outcome.report
    return {
        "file": str(path),
        "time": verdict.when.isoformat(timespec="milliseconds"),
        "verdict": outcome.verdict,
        "whole": verdict.whole,
        "seconds": round(outcome.seconds, 3),
        "sha256": outcome.sha256,
        "sentence": verdict.sentence,
        "entries": [*map(change_data, changed.entries)],
        "results": [*map(change_data, changed.results)],
        "findings": findings_data(report, report.findings) if report else [],
        "failing": [check.line for check in report.failing] if report else [],
    }


def change_data(change: Change) -> dict[str, Any]:
    """Return a difference as JSON has it."""
    return {name: plain(value) for name, value in change._asdict().items()}
