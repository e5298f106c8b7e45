"""What comparing any workbook with its declarations costs: a chain, a table and a grid of 1,000 to 100,000 formulas.

.venv/bin/python benchmarks/any_workbook.py
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import openpyxl
from rich.console import Console
from rich.table import Table

CASES = 20
SIZES = (1_000, 10_000, 100_000)
FLAT = 2.5  # by which time and memory of a formula may grow from 10,000 to 100,000
HEAD = "from workbook.oracle import Oracle\n\nbook = Oracle('x')\nv = book.input('B1', unit='m/s', low=1, high=9)\n"
RUN = """import resource
from workbook.cli import main
try:
    main()
finally:
    own, others = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    print("cost", own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime, own.ru_maxrss / 1024)
"""


def chain(formulas: int) -> Iterator[list[Any]]:
    """Yield rows of times that grow by a step, each from the row above, and a function of each."""
    yield [0.0, "=$B$1*A2"]
    for row in range(3, formulas // 2 + 2):
        yield [f"=A{row - 1}+0.01", f"=$B$1*A{row}"]


def table(formulas: int) -> Iterator[list[Any]]:
    """Yield rows of ten formulas of a number."""
    for row in range(2, formulas // 10 + 2):
        yield [row / 100, *(f"={k}*$B$1*$A{row}" for k in range(1, 11))]


def grid(formulas: int) -> Iterator[list[Any]]:
    """Yield rows of formulas of the row's and the column's number."""
    side = int(formulas**0.5)
    letters = [openpyxl.utils.get_column_letter(column) for column in range(2, side + 2)]
    yield ["", *(column / 10 for column in range(side))]
    for row in range(3, side + 3):
        yield [row / 100, *(f"=$B$1*$A{row}*{letter}$2" for letter in letters)]


KINDS: dict[str, tuple[Callable[[int], Iterator[list[Any]]], str]] = {
    "chain": (chain, "book.table('A2:B{last}', columns=['t', 's'], of=lambda t, v: [v * t])\n"),
    "table": (table, "book.table('A2:K{last}', columns=['t', *'abcdefghij'],"
                     " of=lambda t, v: [k * v * t for k in range(1, 11)])\n"),
    "grid": (grid, "n = {side}\nbook.table('A3:{end}{last}', columns=['t', *map(str, range(n))],"
                   " of=lambda t, v: [v * t * k / 10 for k in range(n)])\n"),
}  # fmt: skip


def write(folder: Path, kind: str, formulas: int) -> tuple[Path, Path]:
    """Write a book of so many formulas, and its declarations."""
    rows, declared = KINDS[kind]
    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("Sheet")
    sheet.append(["Velocity", 2.0, "m/s"])
    last = 1
    for row in rows(formulas):
        sheet.append(row)
        last += 1
    path, file, side = folder / f"{kind}{formulas}.xlsx", folder / f"{kind}{formulas}.py", int(formulas**0.5)
    book.save(path)
    end = openpyxl.utils.get_column_letter(side + 1)
    file.write_text(HEAD + declared.format(last=last, side=side, end=end), encoding="utf-8")
    return path, file


def measured(*command: str) -> tuple[float, float]:
    """Return the seconds of a core that a command took, evaluators with it, and its own MB; raise where it fails."""
    done = subprocess.run([sys.executable, "-c", RUN, *command], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(done.stdout[-500:] + done.stderr[-500:])
    seconds, memory = done.stdout.split("cost")[-1].split()
    return float(seconds), float(memory)


def main() -> int:
    table_ = Table("kind", "formulas", "oracle, s", "MB", "verify, s", "MB", "µs a formula and case", box=None)
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        for kind in KINDS:
            costs = {}
            for formulas in SIZES:
                path, declared = write(Path(folder), kind, formulas)
                drafted, first = measured("oracle", str(path), "-o", str(Path(folder) / "draft.py"), "--force")
                judged, peak = measured("verify", str(path), "--against", str(declared), "--cases", str(CASES))
                costs[formulas] = judged / formulas
                each = f"{1e6 * judged / formulas / CASES:.1f}"
                table_.add_row(
                    kind, f"{formulas:,}", f"{drafted:.1f}", f"{first:.0f}", f"{judged:.1f}", f"{peak:.0f}", each
                )
            missed += 100_000 in costs and costs[100_000] > FLAT * costs[10_000]
    Console().print(table_)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
