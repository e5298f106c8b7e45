"""What a study of a million designs takes: a feeding axis, law × angle × motor × reducer, and 1,000 books over workers.

.venv/bin/python benchmarks/study.py [designs] [books]
"""

from __future__ import annotations

import resource
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from workbook.build import build
from workbook.cluster import pool
from workbook.judging.batch import Target, verify_many
from workbook.pool import cores
from workbook.reading.descriptions import read_machine, write_machine
from workbook.studies.folder import Parts
from workbook.studies.plan import Plan, make_plan
from workbook.studies.run import run
from workbook.studies.space import Study
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.writing.output_files import write_text

MACHINE = TEMPLATES["machine"].description  # its first axis is S1's feeding group
DESIGNS, BOOKS = 1_000_000, 1_000
NAMES = ["drive1_rms", "drive1_res_rms", "drive1_res_peak", "drive1_res_speed"]


def study(designs: int, folder: Path) -> Plan:
    """Return so many designs at least: five laws, the end of the feed in so many steps, all motors and reducers."""
    pairs = 5 * 19 * 16
    varied = [
        {"key": "axes.MC01.phases[1].law", "values": ["MTP", "CIC", "CUB", "TVP", "ACS"]},
        {"key": "axes.MC01.phases[1].stop", "from": 60.0, "to": 120.0, "steps": max(2, -(-designs // pairs))},
        {"key": "axes.MC01.motor.name", "all": "catalogue"},
        {"key": "axes.MC01.reducer.name", "all": "catalogue"},
    ]
    told = {"title": "Feeding axis", "vary": varied, "results": NAMES, "minimise": ["drive1_rms"]}
    machine = read_machine(MACHINE)
    feeding = {"axes": machine.axes[:1], "clearances": []}
    feeding["selection"] = machine.selection.model_copy(update={"axis": None})
    write_text(folder / "feed.toml", write_machine(machine.model_copy(update=feeding)))
    return make_plan(Study.model_validate(told), folder / "feed.toml", "benchmark")


def one_pass(rows: int) -> float:
    """Return the seconds of one pass of NumPy over so many rows: RMS torques from figures that are there."""
    inertia, ratio, eta = (np.linspace(one, 2.0 * one, rows) for one in (1e-3, 4.0, 0.45))
    begin = time.perf_counter()
    square = (inertia * ratio) ** 2 * 5.0 + 2.0 * inertia * (3.0 / eta + 2.0 * eta) + (7.0 / eta**2) / ratio**2
    np.sqrt(square, out=square)
    return time.perf_counter() - begin


def peak() -> float:
    """Return the most memory that this process has had (MB)."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0


def studied(designs: int, jobs: int) -> tuple[int, float, float]:
    """Return how many designs were worked out, the seconds, and the memory of the process that hands them out."""
    with tempfile.TemporaryDirectory() as folder:
        plan = study(designs, Path(folder))
        begin = time.perf_counter()
        parts = Parts(Path(folder, "r.csv"), plan.digest, plan.space.size)
        with parts.opened(False, False), pool(jobs, None) as workers:
            found = run(plan, parts, workers, lambda count, before: None)
        return found.designs, time.perf_counter() - begin, peak()


def books(count: int, jobs: int, book: Path, folder: Path) -> float:
    """Return the seconds that so many books take over so many processes."""
    targets = [Target(folder / f"{i}.xlsx", named=True) for i in range(count)]
    for one in targets:
        if not one.path.exists():
            one.path.hardlink_to(book)
    begin = time.perf_counter()
    with pool(jobs, None) as workers:
        outcomes = verify_many(targets, pool=workers)
    assert all(one.verdict == "agrees" for one in outcomes)  # noqa: S101
    return time.perf_counter() - begin


def small(folder: Path) -> Path:
    """Build a book of about a thousand formula cells."""
    machine = read_machine(FOLDER / "motion-composer.toml")
    sizes = machine.sizes.model_copy(update={"cycle": 4, "law": 4})
    build(machine.model_copy(update={"sizes": sizes}), folder / "book.xlsx")
    return folder / "book.xlsx"


def main(designs: int, count: int) -> None:
    """Print the figures."""
    table = Table("Designs", "s", "passes of NumPy", "MB", title=f"Studies on {cores()} cores")
    for wanted in (designs // 10, designs):
        done, seconds, memory = studied(wanted, cores())
        table.add_row(f"{done:,}", f"{seconds:.1f}", f"{seconds / one_pass(done):,.0f}", f"{memory:.0f}")
    Console().print(table)
    if count:
        with tempfile.TemporaryDirectory() as folder:
            book = small(Path(folder))
            alone, together = (books(count, jobs, book, Path(folder)) for jobs in (1, 2))
        Console().print(f"{count:,} books: {alone:.1f} s by one process, {together / alone:.2f} of it by two workers")


if __name__ == "__main__":
    given = [int(text) for text in sys.argv[1:]]
    main(*given, *[DESIGNS, BOOKS][len(given) :])
