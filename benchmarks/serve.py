"""The pages: from an edit to its figures, of few and many driven axes; first page; pages while many axes are built."""

from __future__ import annotations

import asyncio
import json
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from http.client import HTTPConnection
from pathlib import Path
from statistics import median
from urllib.parse import urlencode

import tomli_w
from rich.console import Console
from rich.table import Table

from workbook.description.editing import edit_text
from workbook.entries.design import as_entered
from workbook.reading.descriptions import read_machine
from workbook.serve.design import figures
from workbook.serve.handler import COOKIE
from workbook.serve.work import Work
from workbook.templates import TEMPLATES

EDITS, BUILT = 15, 24
GOALS = {5: 0.3, 24: 1.0}
"""seconds of the median edit, by the number of axes, each with a drive"""

ADDRESS = re.compile(r"Open http://(127\.0\.0\.1:\d+)/\?token=(\S+) ")


def description(axes: int) -> str:
    """Return the text of a machine of so many axes with a drive each: both of the committed machine's in turn."""
    data = as_entered(read_machine(TEMPLATES["machine"].description))
    driven = [axis for axis in data["axes"] if "motor" in axis]
    named = [driven[k % len(driven)] | {"name": f"AX{k + 1:02}"} for k in range(axes)]
    return tomli_w.dumps(data | {"axes": named, "clearances": [], "selection": {}})


def edits(text: str) -> dict[str, list[str]]:
    """Return by what is edited the texts after each edit: the end of a phase, a motor, the rate of all axes."""
    places = {
        "end of a phase": (("axes", "0", "phases", "0", "stop"), 81.0),
        "inertia of a motor": (("axes", "1", "motor", "inertia"), 12.0),
        "rate of the machine": (("master", "rate"), 180.0),
    }
    return {
        what: [edit_text(text, [(path, value + 0.5 * k)]) for k in range(EDITS)]
        for what, (path, value) in places.items()
    }


async def timed(others: list[str], work: Work) -> tuple[float, int]:
    """Return the median time of edits (s), and the size of the last answer (bytes)."""
    taken, answer = [], ""
    for other in others:
        begin = time.perf_counter()
        answer = json.dumps(await work.in_worker(figures, other, 0))
        taken.append(time.perf_counter() - begin)
    return median(taken), len(answer.encode())


@contextmanager
def serving(folder: Path) -> Iterator[tuple[str, str]]:
    """Run the server on a folder; yield its address and token."""
    command = [sys.executable, "-u", "-m", "workbook", "serve", str(folder), "--no-browse"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        found = ADDRESS.match(process.stdout.readline() if process.stdout else "")
        if found is None:
            raise RuntimeError("the server did not begin")
        try:
            yield found[1], found[2]
        finally:
            process.send_signal(signal.SIGINT)  # Popen waits for its end, after an error too


def asked(server: tuple[str, str], path: str, **fields: str) -> float:
    """Return how long an answer takes (s); fields are posted."""
    begin, (host, token) = time.perf_counter(), server
    headers = {"Cookie": f"{COOKIE}={token}", "Host": host, "Origin": f"http://{host}",
               "Content-Type": "application/x-www-form-urlencoded"}  # fmt: skip
    connection = HTTPConnection(host, timeout=600)
    connection.request("POST" if fields else "GET", path, urlencode(fields) if fields else None, headers)
    answer = connection.getresponse()
    answer.read()
    if answer.status >= 400:
        raise RuntimeError(f"{path}: {answer.status}")
    return time.perf_counter() - begin


def pages() -> None:
    """Print how long the first page takes, and pages and edits while a large machine is built."""
    table = Table("Page", "Median [s]", "Longest [s]", "Goal [s]", title="Pages")
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(1) as pool:
        folder, text = Path(name), description(min(GOALS))
        (folder / "small.toml").write_text(text, encoding="utf-8")
        (folder / "large.toml").write_text(description(BUILT), encoding="utf-8")
        begin = time.perf_counter()
        with serving(folder) as server:
            asked(server, "/")
            first = time.perf_counter() - begin
            table.add_row("the first, from the command on", f"{first:.2f}", "", "")
            table.add_row("the first, from the address on", *longest([asked(server, "/") for _ in range(5)]), "1")
            asked(server, "/figures", name="small.toml", text=text, axis="0")
            build = pool.submit(asked, server, "/build", name="large.toml")
            times: dict[str, list[float]] = {"the first": [], "an edit": []}
            while not build.done():
                times["the first"].append(asked(server, "/"))
                changed = text.replace("rate = 200", f"rate = {200 + len(times['the first'])}", 1)
                times["an edit"].append(asked(server, "/figures", name="small.toml", text=changed, axis="0"))
            for what, taken in times.items():
                table.add_row(f"{what}, while {BUILT} axes are built ({build.result():.0f} s)", *longest(taken), "")
    Console().print(table)


def longest(times: list[float]) -> tuple[str, str]:
    """Return the median and the longest of times as they are printed."""
    return f"{median(times):.3f}", f"{max(times):.3f}"


async def main() -> None:
    """Print a row for each size of machine and each kind of edit."""
    table = Table("Axes", "Edited", "Median [s]", "Goal [s]", "Answer [kB]", title="From an edit to its figures")
    for axes, goal in GOALS.items():
        work, text = Work(), description(axes)
        await work.in_worker(figures, text, 0)  # the process begins
        for what, others in edits(text).items():
            taken, size = await timed(others, work)
            table.add_row(f"{axes}", what, f"{taken:.3f}", f"{goal:g}", f"{size / 1000:.0f}")
        work.stop()
    Console().print(table)


if __name__ == "__main__":
    asyncio.run(main())
    pages()
