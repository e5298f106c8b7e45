"""What the pages do: the commands of motionbook, each in a process of its own with a limit of time and memory."""

from __future__ import annotations

import asyncio
import os
import sys
from pathlib import Path
from typing import NamedTuple

LONGEST = 600.0
"""seconds of a command"""
MEMORY = 6 * 2**30
"""bytes of address space of a command, where the system can limit it"""


class Done(NamedTuple):
    """How a command ended: its exit code and what it printed."""

    code: int
    text: str


class Work:
    """Commands, so many at once; others wait for their turn."""

    def __init__(self, most: int | None = None) -> None:
        self._turns = asyncio.Semaphore(most or max(1, (os.cpu_count() or 2) - 1))
        self._running: set[asyncio.subprocess.Process] = set()
        self.waiting = 0

    async def run(self, *arguments: str | Path) -> Done:
        """Run a command of motionbook."""
        self.waiting += 1
        try:
            async with self._turns:
                return await self._run([str(one) for one in arguments])
        finally:
            self.waiting -= 1

    async def _run(self, arguments: list[str]) -> Done:
        process = await asyncio.create_subprocess_exec(
            sys.executable, "-m", "workbook", *arguments, stdin=asyncio.subprocess.DEVNULL,
            stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.STDOUT, env=os.environ | {"COLUMNS": "120"},
            preexec_fn=limit_memory if os.name == "posix" else None,
        )  # fmt: skip
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


def limit_memory() -> None:
    """Limit the memory of this process."""
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
