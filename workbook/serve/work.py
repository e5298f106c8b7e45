"""The work of the pages: commands of motionbook, each in a process of its own with a limit of time and memory."""

import asyncio
import gc
import os
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import suppress
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from workbook.errors import AGREES, FAILS, MotionbookError

POSIX = os.name == "posix"
MEMORY = 6 * 2**30  # bytes of address space of a command, where the system can limit it
LONGEST = 600.0  # seconds of a command
PATIENCE = 60.0  # seconds of what is worked out beside the server
GRACE = 2.0  # seconds of a command that is interrupted, until it is killed
NOT_WRITTEN = "not written"
T = TypeVar("T")


class WorkError(MotionbookError):
    """Work that took too long, or that other work is in the way of."""


class Done(NamedTuple):
    """The end of a command: its exit code and its output."""

    code: int
    text: str

    @property
    def written(self) -> str:
        """Return a note on the file that the command was to write, empty where it is fine."""
        return {AGREES: "", FAILS: "written; the design fails its checks"}.get(self.code, NOT_WRITTEN)


class Job:
    """A study at work, which can be interrupted and goes on: when it began, after how many designs, how it ended."""

    def __init__(self, process: asyncio.subprocess.Process, before: int) -> None:
        self.begun, self.before = time.monotonic(), before
        self.done: Done | None = None
        self._process, self._reading = process, asyncio.create_task(self._ended())

    async def _ended(self) -> None:
        printed, _ = await self._process.communicate()
        self.done = Done(self._process.returncode or 0, printed.decode(errors="replace"))

    def interrupt(self) -> None:
        """Interrupt it, and kill it if that does not end it: what is complete stays."""
        self._ending = asyncio.create_task(end(self._process))

    def stop(self) -> None:
        """End it with the server."""
        kill(self._process)
        self._reading.cancel()


class Work:
    """Commands, so many at once, others wait for their turn; a single study; processes for edits and verdicts."""

    def __init__(self, most: int | None = None, patience: float = PATIENCE, temporary: str | None = None) -> None:
        self._patience, self._temporary = patience, temporary
        self._turns = asyncio.Semaphore(most or max(1, (os.cpu_count() or 2) - 1))
        self._running: set[asyncio.subprocess.Process] = set()
        self.waiting = 0
        self.jobs: dict[str, Job] = {}  # the latest work at each study, by the name of its file
        self._workers: dict[bool, ProcessPoolExecutor] = {}  # what is edited, and by True what takes longer

    async def in_worker(self, function: Callable[..., T], *arguments: Any, slow: bool = False) -> T:
        """Return the result of a function in a process beside the server; raise WorkError where it takes too long.

        What is ``slow``, such as a book's verdict, has a process of its own, so that no edit waits for it.
        """
        worker = self.worker(slow)
        try:
            future = asyncio.get_running_loop().run_in_executor(worker, function, *arguments)
            return await asyncio.wait_for(future, self._patience)
        except (TimeoutError, BrokenProcessPool):
            if self._workers.get(slow) is worker:  # else another request has ended it
                self._end_worker(slow)
            raise WorkError(f"Not worked out within {self._patience:.0f} s") from None

    def worker(self, slow: bool = False) -> ProcessPoolExecutor:
        """Return the process for edits, or that for what takes longer."""
        if slow not in self._workers:
            self._workers[slow] = ProcessPoolExecutor(1, get_context("spawn"), prepare_worker, (self._temporary,))
        return self._workers[slow]

    def _end_worker(self, slow: bool) -> None:
        """End a process for edits, or for what takes longer; the next begins another."""
        if worker := self._workers.pop(slow, None):
            for process in list(worker._processes.values()):
                process.kill()
                process.join()
            worker.shutdown(cancel_futures=True)  # its thread ends with it: left alone, it can fail at exit

    async def run(self, *arguments: str | Path, folder: str | None = None) -> Done:
        """Run a command of motionbook, in a folder where it is given."""
        self.waiting += 1
        try:
            async with self._turns:
                return await self._run(arguments, folder)
        finally:
            self.waiting -= 1

    async def _run(self, arguments: tuple[str | Path, ...], folder: str | None) -> Done:
        process = await start_command(*arguments, cwd=folder)
        self._running.add(process)
        try:
            printed, _ = await asyncio.wait_for(process.communicate(), LONGEST)
        except TimeoutError:
            return Done(2, f"stopped after {LONGEST:.0f} s")
        finally:
            await end(process)
            self._running.discard(process)
        return Done(process.returncode or 0, printed.decode(errors="replace"))

    async def study(self, path: Path, before: int, *options: str | Path) -> None:
        """Begin a study, ``before`` of whose designs are done; raise WorkError where another study is at work."""
        busy = next((name for name, job in self.jobs.items() if job.done is None), None)
        if busy is not None:  # each leaves a single core free
            raise WorkError(f"{busy} is at work; cancel it, or wait for its end")
        self.jobs[path.name] = Job(await start_command("study", path, *options), before)

    def stop(self) -> None:
        """End all commands that run."""
        for process in self._running:
            kill(process)
        for job in self.jobs.values():
            job.stop()
        for slow in (False, True):
            self._end_worker(slow)


async def start_command(*arguments: str | Path, cwd: str | None = None) -> asyncio.subprocess.Process:
    """Start a command of motionbook with a limit of memory, its errors among what it prints."""
    return await asyncio.create_subprocess_exec(
        sys.executable,
        "-m",
        "workbook",
        *map(str, arguments),
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.STDOUT,
        env=os.environ | {"COLUMNS": "120"},
        preexec_fn=prepare_command if POSIX else None,
        start_new_session=True,
        cwd=cwd,
    )


def kill(process: asyncio.subprocess.Process) -> None:
    """Kill a command that is at work, with the processes that it began."""
    if process.returncode is None:
        os.killpg(process.pid, signal.SIGKILL) if POSIX else process.kill()


async def end(process: asyncio.subprocess.Process) -> None:
    """End a command: interrupted as Ctrl+C does, and killed where that does not end it soon."""
    if process.returncode is None:
        process.send_signal(signal.SIGINT) if POSIX else process.terminate()
    with suppress(TimeoutError):
        await asyncio.wait_for(process.wait(), GRACE)
    kill(process)


def prepare_command() -> None:
    """Limit the memory of this process, and let it be interrupted where the server cannot be."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    limit_memory()


def limit_memory() -> None:
    """Limit the memory of this process."""
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def prepare_worker(temporary: str | None) -> None:
    """Prepare the process for what is edited, and the folder of its temporary files; Ctrl+C is the server's."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    tempfile.tempdir = temporary
    if POSIX:
        limit_memory()
    gc.freeze()
    gc.set_threshold(500_000, 10, 10)
