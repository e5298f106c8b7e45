"""What verifying costs in CPU, and what LibreOffice takes to open, recalculate and save the same file in the same run.

    .venv/bin/python -m benchmarks.verify [AXES ...]

Cold is the command as from a terminal, with the start of its program. Warm is the verdict on the values after a save in
which one entry is another, in a process that stays, as `motionbook watch` has it: the median of those saves. Raw is
reading the file and pycel's evaluation of its cells. AXES (24) are the larger machines besides the templates.
"""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from openpyxl import load_workbook
from rich.console import Console
from rich.table import Table

from benchmarks.scale import of_axes
from workbook.build import build
from workbook.entries.machine import Machine
from workbook.errors import AGREES, FAILS
from workbook.judging.warm import WarmBook
from workbook.pool import collector_paused, cores
from workbook.reading.descriptions import read_machine
from workbook.reading.files import open_book
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import LibreOffice, convert
from workbook.witnesses.pycel.model import Pycel

ROUNDS, SAVES = 3, 5
GOAL = 0.6  # cold over LibreOffice


def cpu(task: Callable[[], object]) -> float:
    """CPU seconds of a task, here and in the processes that it began and that ended."""

    def used() -> float:
        ended = resource.getrusage(resource.RUSAGE_CHILDREN)
        return time.process_time() + ended.ru_utime + ended.ru_stime

    begin = used()
    task()
    return used() - begin


def command(book: Path) -> None:
    """Run the command as from a terminal: like LibreOffice, with the start of its program, and it compiled before."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    run = [sys.executable, "-m", "workbook", "verify", str(book)]
    code = subprocess.run(run, check=False, capture_output=True, env=kept).returncode
    assert code in (AGREES, FAILS), code  # noqa: S101 - a design may fail, its cells agree


def of_warm_saves(book: Path, machine: Machine) -> list[float]:
    """CPU seconds of the verdict on the values of each save in which a number that is entered is another."""
    blocks = TEMPLATES[machine.template].declare(machine).blocks.values()
    single = (block.quantities[0] for block in blocks if not block.is_table)
    name = next(q.name for q in single if q.role == "input" and isinstance(q.value, float) and q.value > 0.0)
    workbook = load_workbook(book)
    ((sheet, place),) = workbook.defined_names[name].destinations
    cell = workbook[sheet][place.replace("$", "").partition(":")[0]]
    warm, value, seconds = WarmBook(), cell.value, []
    for k in range(SAVES + 1):
        cell.value = value * (1.0 - 0.001 * k)
        workbook.save(book)
        with collector_paused():
            seconds.append(cpu(lambda: warm.judge_values(book)))
    return seconds[1:]


def row_of(name: str, machine: Machine, folder: Path) -> list[str]:
    """A row of the table."""
    book, edited = folder / f"{name}.xlsx", folder / f"{name}-edited.xlsx"
    for path in (book, edited):
        build(machine, path)
    times = [[cpu(lambda: command(book)), cpu(lambda: convert(book, "xlsx", folder / "made"))] for _ in range(ROUNDS)]
    cold, theirs = map(statistics.median, zip(*times, strict=True))
    model = Pycel().model(open_book(book))
    cells, raw = len(model.evaluate()), cpu(lambda: Pycel().model(open_book(book)).evaluate())
    warm = statistics.median(of_warm_saves(edited, machine))
    figures = [f"{cells:,}", *(f"{seconds:.2f}" for seconds in (theirs, cold, raw, warm))]
    return [
        name,
        *figures,
        f"{cold / theirs:.2f}",
        f"{warm / theirs:.2f}",
        "met" if cold <= GOAL * theirs else "missed",
    ]


def main() -> None:
    """Print the table."""
    heads = ("Workbook", "Cells", "LibreOffice, s", "Cold, s", "Raw, s", "Warm, s", "Cold ratio", "Warm ratio")
    table = Table(*heads, f"≤ {GOAL:g}", title=f"CPU; cold and LibreOffice the medians of {ROUNDS}, warm of {SAVES}")
    console = Console(width=140)
    console.print(f"{cores()} cores, load {os.getloadavg()[0]:.1f}, LibreOffice {LibreOffice().version()}")
    with tempfile.TemporaryDirectory() as folder:
        for name, template in TEMPLATES.items():
            table.add_row(*row_of(name, read_machine(template.description), Path(folder)))
        for count in map(int, sys.argv[1:] or ["24"]):
            table.add_row(*row_of(f"{count} axes", of_axes(count), Path(folder)))
    console.print(table)
    console.print(f"most memory of this process: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main()
