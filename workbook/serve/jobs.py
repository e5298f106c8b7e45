"""Long work: a study in a process of its own, which can be interrupted and goes on."""

import asyncio
import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

from workbook.errors import MotionbookError

POSIX = os.name == "posix"
MEMORY = 6 * 2**30
"""bytes of address space of a command, where the system can limit it"""


class BusyError(MotionbookError):
    """A study is at work already."""


class Job:
    """A command at work: when it began, what was done before, what it printed, its exit code, None while it runs."""

    def __init__(self, process: asyncio.subprocess.Process, before: int) -> None:
        self.begun, self.before, self.text = time.monotonic(), before, ""
        self.code: int | None = None
        self._process, self._reading = process, asyncio.create_task(self._ended())

    async def _ended(self) -> None:
        printed, _ = await self._process.communicate()
        self.text, self.code = printed.decode(errors="replace"), self._process.returncode

    @property
    def seconds(self) -> float:
        """How long it has been at work (s)."""
        return time.monotonic() - self.begun

    def interrupt(self) -> None:
        """Interrupt it as Ctrl+C does: what is complete stays."""
        if self.code is None and self._process.returncode is None:
            self._process.send_signal(signal.SIGINT) if POSIX else self._process.terminate()

    def kill(self) -> None:
        """End it and the processes that it began."""
        if self._process.returncode is None:
            os.killpg(self._process.pid, signal.SIGKILL) if POSIX else self._process.kill()
        self._reading.cancel()


class Jobs:
    """Studies by the name of their file, one at a time: each takes all cores but one."""

    def __init__(self) -> None:
        self._known: dict[str, Job] = {}

    def get(self, name: str) -> Job | None:
        """Return the latest work at a study."""
        return self._known.get(name)

    async def begin(self, name: str, before: int, *arguments: str | Path) -> None:
        """Begin a command, ``before`` of whose designs are done; raise BusyError where another one is at work."""
        busy = next((other for other, job in self._known.items() if job.code is None), None)
        if busy is not None:
            raise BusyError(f"{busy} is at work; cancel it, or wait for its end")
        self._known[name] = Job(await started(*arguments, start_new_session=True), before)

    def stop(self) -> None:
        """End all of them."""
        for job in self._known.values():
            job.kill()


async def started(*arguments: str | Path, **more: Any) -> asyncio.subprocess.Process:
    """Start a command of motionbook with a limit of memory, its errors among what it prints."""
    return await asyncio.create_subprocess_exec(
        sys.executable, "-m", "workbook", *map(str, arguments), stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.STDOUT, env=os.environ | {"COLUMNS": "120"},
        preexec_fn=limit_memory if POSIX else None, **more,
    )  # fmt: skip


def limit_memory() -> None:
    """Limit the memory of this process."""
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
