"""What the pages do: the commands of motionbook, each in a process of its own with a limit of time and memory."""

import asyncio
import gc
import os
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from workbook.errors import MotionbookError
from workbook.latest import remember
from workbook.serve.jobs import POSIX, Jobs, limit_memory, started
from workbook.serve.live import fragment

LONGEST = 600.0
"""seconds of a command"""
PATIENCE = 60.0
"""seconds of what is worked out beside the server"""
REMEMBERED = 48
"""things of each kind that the process for what is edited remembers: those of two of the largest books"""
T = TypeVar("T")


class WorkError(MotionbookError):
    """Work that took too long."""


class Done(NamedTuple):
    """How a command ended: its exit code and what it printed."""

    code: int
    text: str


class Work:
    """Commands, so many at once, others wait for their turn; and one process for what is edited."""

    def __init__(self, most: int | None = None) -> None:
        self._turns = asyncio.Semaphore(most or max(1, (os.cpu_count() or 2) - 1))
        self._running: set[asyncio.subprocess.Process] = set()
        self.waiting = 0
        self.jobs = Jobs()
        self._editing: ProcessPoolExecutor | None = None

    async def live(self, name: str, text: str, saved: str) -> str:
        """Return the panel beside a description that is being edited."""
        try:
            return await self.beside(fragment, name, text, saved)
        except WorkError as error:
            return f"<p>{error}: save and build it instead.</p>"

    async def beside(self, function: Callable[..., T], *arguments: Any) -> T:
        """Return what a function gives in the process beside the server; raise WorkError where it takes too long."""
        if self._editing is None:
            self._editing = ProcessPoolExecutor(1, get_context("spawn"), initializer=prepared)
        try:
            found = asyncio.get_running_loop().run_in_executor(self._editing, function, *arguments)
            return await asyncio.wait_for(found, PATIENCE)
        except (TimeoutError, BrokenProcessPool):
            self._end_editing()
            raise WorkError(f"Not worked out within {PATIENCE:.0f} s") from None

    def _end_editing(self) -> None:
        """End the process for what is edited; the next edit begins another."""
        if self._editing is not None:
            for process in list(self._editing._processes.values()):
                process.kill()
            self._editing.shutdown(wait=False, cancel_futures=True)
            self._editing = None

    async def run(self, *arguments: str | Path, folder: str | None = None) -> Done:
        """Run a command of motionbook, in a folder if one is named."""
        self.waiting += 1
        try:
            async with self._turns:
                return await self._run(arguments, folder)
        finally:
            self.waiting -= 1

    async def _run(self, arguments: tuple[str | Path, ...], folder: str | None) -> Done:
        process = await started(*arguments, cwd=folder)
        self._running.add(process)
        try:
            printed, _ = await asyncio.wait_for(process.communicate(), LONGEST)
        except TimeoutError:
            process.kill()
            await process.wait()
            return Done(2, f"stopped after {LONGEST:.0f} s")
        finally:
            self._running.discard(process)
        return Done(process.returncode or 0, printed.decode(errors="replace"))

    def stop(self) -> None:
        """End all commands that run."""
        for process in self._running:
            process.kill()
        self._end_editing()
        self.jobs.stop()


def prepared() -> None:
    """Prepare the process for what is edited: it remembers what an edit leaves as it is."""
    if POSIX:
        limit_memory()
    remember(REMEMBERED)
    gc.freeze()
    gc.set_threshold(500_000, 10, 10)
