"""What verifying costs: cells a second, against LibreOffice on the same file, and from 1 to 64 workbooks."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from rich.console import Console
from rich.table import Table

from workbook.build import build
from workbook.cluster import pool
from workbook.entries.machine import Machine
from workbook.errors import AGREES, FAILS
from workbook.judging.batch import Target, verify_many, verify_one
from workbook.judging.verify import verify
from workbook.pool import cores
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES, Template
from workbook.witnesses.engines import LibreOffice, convert

ROUNDS = 3
COUNTS = (1, 4, 16, 64)
JOBS = (1, 2)
AXES = (1, 5, 12, 24)
SMALL = {"cycle": 4, "law": 4}
GOAL = 0.7  # verifying over LibreOffice's opening, recalculating and saving


def best(*tasks: Callable[[], object]) -> list[float]:
    """Least time of each task in seconds; the tasks take turns, so that a busy machine is busy for all of them."""
    seconds = [float("inf")] * len(tasks)
    for _ in range(ROUNDS):
        for i, task in enumerate(tasks):
            begin = time.perf_counter()
            task()
            seconds[i] = min(seconds[i], time.perf_counter() - begin)
    return seconds


def command(book: Path) -> None:
    """Run the command as from a terminal: like LibreOffice, with the start of its program, and it compiled before."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    run = [sys.executable, "-m", "workbook", "verify", str(book)]
    code = subprocess.run(run, check=False, capture_output=True, env=kept).returncode
    assert code in (AGREES, FAILS), code  # noqa: S101 - a design may fail, its cells agree


def of_axes(count: int) -> Machine:
    """Return a machine of so many axes, each with a drive: those of the committed one, over and over."""
    given = read_machine(TEMPLATES["machine"].description)
    data = given.model_dump(exclude={"switches", "clearances"})
    driven = [axis for axis in data["axes"] if axis["motor"]]
    axes = [driven[k % len(driven)] | {"name": f"Axis {k + 1}", "shift": 13.0 * k} for k in range(count)]
    selection = data["selection"] | {"axis": axes[0]["name"]}
    others = {"switches": [], "clearances": [], "selection": selection}
    return type(given).model_validate(data | {"axes": axes} | others)


def against_libreoffice(name: str, machine: Machine, folder: Path) -> list[str]:
    """One row: cells, cells a second within a process; seconds of the command and of LibreOffice, and their ratio."""
    book = folder / f"{name}.xlsx"
    build(machine, book)
    cells = verify(book).compared
    target, made = Target(book, named=True), folder / "made"
    within, ours, theirs = best(
        lambda: verify_one(target, ["pycel"]), lambda: command(book), lambda: convert(book, "xlsx", made)
    )
    verdict = f"≤ {GOAL:g} " + ("met" if ours <= GOAL * theirs else "missed")
    rate = f"{cells / within:,.0f}"
    return [name, f"{cells:,}", rate, f"{ours:.2f}", f"{theirs:.2f}", f"{ours / theirs:.2f}", verdict]


def growth(template: Template, folder: Path) -> tuple[int, dict[int, list[float]]]:
    """Formula cells of a small workbook, and seconds for so many copies of it with each number of jobs."""
    machine = read_machine(template.description)
    first = folder / "0.xlsx"
    build(machine.model_copy(update={"sizes": machine.sizes.model_copy(update=SMALL)}), first)
    targets = [Target(folder / f"{i}.xlsx", named=True) for i in range(max(COUNTS))]
    for target in targets[1:]:
        shutil.copy(first, target.path)
    times = {count: [timed(targets[:count], jobs) for jobs in JOBS] for count in COUNTS}
    return verify(first).compared, times


def timed(targets: list[Target], jobs: int) -> float:
    """Seconds for one run over ``targets``, the start of its processes included."""
    begin = time.perf_counter()
    with pool(jobs, None) as workers:
        outcomes = verify_many(targets, pool=workers)
    seconds = time.perf_counter() - begin
    for outcome in outcomes:
        if outcome.verdict != "agrees":
            why = outcome.reason or (outcome.report and outcome.report.findings[:3])
            raise RuntimeError(f"{outcome.path} {outcome.verdict}, so its time would mean nothing: {why}")
    return seconds


def main() -> None:
    """Print both tables."""
    console = Console()
    with tempfile.TemporaryDirectory() as folder:
        load = f", load {os.getloadavg()[0]:.1f} before the start" if hasattr(os, "getloadavg") else ""
        console.print(f"{cores()} cores{load}, LibreOffice {LibreOffice().version()}")
        table = Table(
            *("Workbook", "Cells", "Cells/s", "verify, s", "LibreOffice, s", "Ratio", "Goal"),
            title=f"verify / LibreOffice's open, recalculate and save; best of {ROUNDS}",
        )
        for template in TEMPLATES.values():
            table.add_row(*against_libreoffice(template.name, read_machine(template.description), Path(folder)))
        for count in AXES:
            table.add_row(*against_libreoffice(f"{count} axes with drives", of_axes(count), Path(folder)))
        console.print(table)
    with tempfile.TemporaryDirectory() as folder:
        cells, times = growth(TEMPLATES["flying-cutter"], Path(folder))
        table = Table(
            *("Workbooks", *(f"{n} job{'s' * (n > 1)}, s" for n in JOBS), "Speed-up", "s a workbook"),
            title=f"Copies of a workbook of {cells:,} formula cells",
        )
        for count, seconds in times.items():
            said = [f"{s:.2f}" for s in seconds]
            table.add_row(str(count), *said, f"{seconds[0] / seconds[-1]:.2f}", f"{seconds[-1] / count:.3f}")
        console.print(table)


if __name__ == "__main__":
    main()
