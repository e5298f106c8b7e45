"""What verifying from 1 to 64 workbooks costs, by one process and by two."""

from __future__ import annotations

import shutil
import tempfile
import time
from pathlib import Path

from rich.console import Console
from rich.table import Table

from workbook.build import build
from workbook.cluster import pool
from workbook.entries.machine import Machine
from workbook.judging.batch import Target, verify_many
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES, Template

COUNTS = (1, 4, 16, 64)
JOBS = (1, 2)
SMALL = {"cycle": 4, "law": 4}
PHASES = 8  # rows of each axis: figures of one year and the next are of the same machine


def of_axes(count: int) -> Machine:
    """Return a machine of so many axes, each with a drive: those of the committed one, over and over."""
    given = read_machine(TEMPLATES["machine"].description)
    data = given.model_dump(exclude={"switches", "clearances"})
    driven = [axis for axis in data["axes"] if axis["motor"]]
    axes = [driven[k % len(driven)] | {"name": f"Axis {k + 1}", "shift": 13.0 * k} for k in range(count)]
    selection = data["selection"] | {"axis": axes[0]["name"]}
    sizes = given.sizes.model_dump(exclude_unset=True) | {"phases": PHASES}
    others = {"switches": [], "clearances": [], "selection": selection, "sizes": sizes}
    return type(given).model_validate(data | {"axes": axes} | others)


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
    """Print the table."""
    console = Console()
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
