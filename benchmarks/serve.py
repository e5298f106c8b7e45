"""From an edit in the browser to its figures: time of the server and size of the answer, for 5 and 24 driven axes."""

from __future__ import annotations

import asyncio
import time
from statistics import median

import tomli_w
from rich.console import Console
from rich.table import Table

from workbook.entries.design import as_entered
from workbook.reading.descriptions import read_machine
from workbook.serve.toml import edited
from workbook.serve.work import Work
from workbook.templates import TEMPLATES

EDITS = 15
GOALS = {5: 0.1, 24: 0.4}
"""seconds of the median edit, by the number of axes, each with a drive"""


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
        what: [edited(text, [(path, value + 0.5 * k)]) for k in range(EDITS)] for what, (path, value) in places.items()
    }


async def timed(text: str, others: list[str], work: Work) -> tuple[float, int]:
    """Return the median time of edits (s), and the size of the last answer (bytes)."""
    taken, answer = [], ""
    for other in others:
        begin = time.perf_counter()
        answer = await work.live("machine.toml", other, text)
        taken.append(time.perf_counter() - begin)
    return median(taken), len(answer.encode())


async def main() -> None:
    """Print a row for each size of machine and each kind of edit."""
    table = Table("Axes", "Edited", "Median [s]", "Goal [s]", "Answer [kB]", title="From an edit to its figures")
    for axes, goal in GOALS.items():
        work, text = Work(), description(axes)
        await work.live("machine.toml", text, text)  # the process begins
        for what, others in edits(text).items():
            taken, size = await timed(text, others, work)
            table.add_row(f"{axes}", what, f"{taken:.3f}", f"{goal:g}", f"{size / 1000:.0f}")
        work.stop()
    Console().print(table)


if __name__ == "__main__":
    asyncio.run(main())
