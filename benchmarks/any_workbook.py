"""What comparing any workbook with its declarations costs: seconds at 100 cases by two evaluators, and memory.

.venv/bin/python benchmarks/any_workbook.py
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import openpyxl
from rich.console import Console
from rich.table import Table

CASES = 100
COLUMNS = 10
SIZES = (200, 2_000, 50_000)
GOAL = {200: 20.0}
"""seconds of the command"""
DECLARED = """
from workbook.oracle import Oracle

book = Oracle("A column of velocities")
v = book.input("B1", unit="m/s", low=1, high=9)


def columns(t, v):
    return [k * v * t for k in range(1, {columns} + 1)]


book.table("A2:K{rows}", columns=["t", *"abcdefghij"], of=columns)
"""
RUN = "import resource; from workbook.cli import main\ntry: main()\nfinally: print('MB', {peak})"
PEAK = "resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024"


def write(folder: Path, formulas: int) -> tuple[Path, Path]:
    """Write a book of so many formulas in ten columns, and its declarations."""
    rows, book = formulas // COLUMNS + 1, openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("Sheet")
    sheet.append(["Velocity", 2.0, "m/s"])
    for row in range(2, rows + 1):
        sheet.append([row / 100, *(f"={k}*$B$1*$A{row}" for k in range(1, COLUMNS + 1))])
    path, declared = folder / f"{formulas}.xlsx", folder / f"{formulas}.py"
    book.save(path)
    declared.write_text(DECLARED.format(columns=COLUMNS, rows=rows), encoding="utf-8")
    return path, declared


def main() -> int:
    table = Table("formula cells", "seconds", "MB at most", "goal", box=None)
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        for formulas in SIZES:
            path, declared = write(Path(folder), formulas)
            command = ["verify", str(path), "--against", str(declared), "--cases", str(CASES)]
            begin = time.perf_counter()
            done = subprocess.run(
                [sys.executable, "-c", RUN.format(peak=PEAK), *command], capture_output=True, text=True, check=False
            )
            seconds = time.perf_counter() - begin
            goal = GOAL.get(formulas)
            missed += done.returncode != 0 or (goal is not None and seconds > goal)
            peak = done.stdout.split("MB")[-1].strip() if done.returncode == 0 else done.stdout + done.stderr
            table.add_row(f"{formulas:,}", f"{seconds:.1f}", peak, "" if goal is None else f"{goal:.0f} s")
    Console().print(table)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
