"""The audit beside another auditor: faults named, false alarms, time; and the seconds for workbooks of other sizes.

.venv/bin/python benchmarks/audit.py
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from collections import Counter
from contextlib import redirect_stdout, suppress
from io import StringIO
from pathlib import Path

import openpyxl
from rich.console import Console
from rich.table import Table
from spreadsheet_auditor.audit import main as other_audit

from tests.workbook.audit.seeds import draw
from workbook.audit import audit
from workbook.reading.files import open_book

FAULTS = 320
SIZES = (1_000, 10_000, 100_000)
SETTINGS = {"recalc": {"enabled": False}, "limits": {"max_formulas": 10**6, "timeout_seconds": 0}}
Named = set[tuple[str, str]]


def ours(path: Path) -> Named:
    """Return rule and cell of what motionbook names."""
    return {(f.rule, f"{f.cell.sheet}!{f.cell.a1}") for f in audit(open_book(path)).shown()}


def others(path: Path) -> Named:
    """Return rule and cell of what spreadsheet-auditor names, but for what it calls low."""
    settings, answer = path.with_name("settings.json"), path.with_name("answer.json")
    settings.write_text(json.dumps(SETTINGS))
    with redirect_stdout(StringIO()), suppress(SystemExit):  # it leaves at what it calls critical
        other_audit([str(path), "--config", str(settings), "--json", str(answer), "--out", str(path.with_name("a.md"))])
    findings = json.loads(answer.read_text())["findings"]
    return {
        (f["rule_id"], cell)
        for f in findings
        if f["severity"] not in ("Low", "Info")
        for cell in (f["members"] or [f["location"]])
    }


def compare(folder: Path) -> Table:
    """Put faults in, one at a time; a finding counts if it is at a cell of the fault, and was not there before."""
    sizes, hits, alarms, seconds = Counter[str](), Counter[tuple[str, str]](), Counter[str](), Counter[str]()
    formulas = 0
    for kind, sound, faulty, cells in draw("benchmark", FAULTS):
        sizes[kind] += 1
        places = {f"{sheet}!{cell}" for sheet, cell in cells}
        before, after = folder / "before.xlsx", folder / "after.xlsx"
        sound.save(before)
        faulty.save(after)
        formulas += len(open_book(before).contents.formula_cells)
        for name, named in (("motionbook", ours), ("spreadsheet-auditor", others)):
            begin = time.process_time()
            known, new = named(before), named(after)
            seconds[name] += time.process_time() - begin
            alarms[name] += len(known)
            hits[name, kind] += any(cell in places for _, cell in new - known)
    tools = ("motionbook", "spreadsheet-auditor")
    table = Table("fault", "put in", *(f"named by {tool}" for tool in tools), box=None)
    for kind, count in sizes.items():
        table.add_row(kind.replace("_", " "), str(count), *(str(hits[tool, kind]) for tool in tools))
    table.add_row("all", str(FAULTS), *(str(sum(hits[tool, kind] for kind in sizes)) for tool in tools))
    rate = (f"{1_000 * alarms[tool] / max(1, formulas):.2f}" for tool in tools)
    table.add_row("false alarms per 1,000 formula cells of the sound books", "", *rate)
    table.add_row("seconds of a core per book", "", *(f"{seconds[tool] / 2 / FAULTS:.3f}" for tool in tools))
    return table


def scale(folder: Path) -> Table:
    """Return the seconds for tables of so many formulas: products, running sums, a chain."""
    table = Table("formula cells", "seconds of a core to read", "to audit", box=None)
    for size in SIZES:
        book = openpyxl.Workbook(write_only=True)
        sheet = book.create_sheet("Table")
        sheet.append(["Time [s]", "Speed [m/s]", "Path [m]", "Sum [m]", "Chain", "Share"])
        for row in range(2, size // 4 + 2):
            chain = f"=E{row - 1}*0.99+C{row}" if row > 2 else "=C2"
            sheet.append([row / 10, row % 7, f"=A{row}*B{row}", f"=SUM(C$2:C{row})", chain, f"=C{row}/D{row}"])
        path = folder / f"{size}.xlsx"
        book.save(path)
        begin = time.process_time()
        file = open_book(path)
        count = len(file.contents.formula_cells)
        read = time.process_time()
        audit(file)
        table.add_row(f"{count:,}", f"{read - begin:.1f}", f"{time.process_time() - read:.1f}")
    return table


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        for table in (compare(Path(folder)), scale(Path(folder))):
            Console().print(table)
    return 0


if __name__ == "__main__":
    sys.exit(main())
