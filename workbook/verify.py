"""Compare every formula cell of a workbook with the engine, at the values that the engineer entered."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from workbook.address import Address
from workbook.declare import Block, Book, Cell, as_rows
from workbook.entries import Entries
from workbook.files import BookFile, open_book
from workbook.witnesses.pycel_witness import PycelModel, version

TOLERANCE = 1e-9  # relative to the greatest value of the cell's column

Kind = Literal["missing", "replaced", "changed", "error", "value"]
RANK: dict[Kind, int] = {"missing": 0, "replaced": 1, "changed": 2, "error": 3, "value": 4}


@dataclass(frozen=True)
class Finding:
    """One cell that is not what it should be."""

    sheet: str
    cell: str
    kind: Kind
    computed: Any
    expected: Any
    what: str = ""
    deviation: float = math.inf  # relative to the greatest value of the column


@dataclass
class Report:
    """What ``verify`` found in one workbook."""

    path: Path
    template: str
    witness: str = ""
    compared: int = 0
    findings: list[Finding] = field(default_factory=list)
    deviations: dict[str, float] = field(default_factory=dict)  # the largest of each sheet
    cells: dict[str, int] = field(default_factory=dict)  # compared on each sheet
    unmatched: list[str] = field(default_factory=list)  # formula cells that belong to nothing declared
    notes: list[str] = field(default_factory=list)

    @property
    def agrees(self) -> bool:
        """Whether every formula cell computes what the engine computes."""
        return not self.findings


def verify(path: Path) -> Report:
    """Verify one workbook; raise ReadError or InputError where it cannot be read."""
    file = open_book(path)
    entries = Entries(file)
    machine = entries.machine()
    declared = entries.template.declare(machine)
    report = Report(path, entries.template.name)
    if entries.computed:
        report.notes.append(f"inputs that hold a formula of their own: {', '.join(entries.computed)}")
    compare(file, declared, report)
    report.findings.sort(key=lambda f: (RANK[f.kind], -f.deviation))
    return report


def compare(file: BookFile, declared: Book, report: Report) -> None:
    """Compare the cells of ``file`` with the declaration, block by block."""
    model = PycelModel(file.workbook)
    values = model.evaluate()
    report.witness = f"pycel {version()}"
    known: set[Address] = set()
    for block in declared.blocks.values():
        place = file.places.get(block.name)
        if place is None:
            report.findings.append(
                Finding(block.sheet.title, block.name, "missing", None, "a block of this name", block.title)
            )
            continue
        if (place.rows, place.columns) != (block.size, len(block.quantities)):
            found = f"{place.rows} rows by {place.columns} columns"
            expected = f"{block.size} rows by {len(block.quantities)} columns"
            report.findings.append(
                Finding(place.sheet, str(place.cell(0, 0).a1), "missing", found, expected, block.name)
            )
        peaks = column_peaks(block)
        for cell in block.cells():
            i, j = cell.i, cell.column - block.column
            if i >= place.rows or j >= place.columns:
                continue
            address = place.cell(i, j)
            known.add(address)
            compare_cell(cell, address, file.value(address), values, peaks[cell.quantity.name], report)
    report.unmatched = sorted(str(a) for a in values if a not in known)


def compare_cell(
    cell: Cell, address: Address, held: Any, values: dict[Address, Any], peak: float, report: Report
) -> None:
    """Compare one cell: inputs are the engineer's, constants stay as declared, formulas compute the engine's value."""
    q = cell.quantity
    if q.role == "input":
        return
    what = q.label if cell.block.size == 1 else f"{q.label}, {cell.block.title}, row {cell.i + 1}"
    is_formula = isinstance(cell.content, str) and cell.content.startswith("=")
    if not is_formula:
        if held != cell.content:
            report.findings.append(Finding(address.sheet, address.a1, "changed", held, cell.content, what))
        return
    report.compared += 1
    report.cells[address.sheet] = report.cells.get(address.sheet, 0) + 1
    if not (isinstance(held, str) and held.startswith("=")):
        kind: Kind = "missing" if held is None else "replaced"
        report.findings.append(Finding(address.sheet, address.a1, kind, held, cell.expected, what))
        return
    computed = values.get(address)
    deviation = difference(computed, cell.expected, peak)
    if math.isfinite(deviation):
        report.deviations[address.sheet] = max(report.deviations.get(address.sheet, 0.0), deviation)
    if not deviation <= TOLERANCE:
        kind = "error" if isinstance(computed, str) and computed.startswith("#") else "value"
        report.findings.append(Finding(address.sheet, address.a1, kind, computed, cell.expected, what, deviation))


def column_peaks(block: Block) -> dict[str, float]:
    """Return what the deviations of each column are measured against: its greatest value, or its declared scale."""
    peaks = {}
    for q in block.quantities:
        values = as_rows(q.value, block.size, q.name)
        numbers = [abs(v) for v in values if isinstance(v, int | float) and math.isfinite(v)]
        peaks[q.name] = max([*numbers, q.scale or 0.0], default=0.0)
    return peaks


def difference(computed: Any, expected: Any, peak: float) -> float:
    """Return the deviation relative to ``peak``: 0 for equal texts, infinite for values of different kinds."""
    if isinstance(computed, bool) or not isinstance(computed, int | float) or isinstance(expected, str):
        return 0.0 if computed == expected else math.inf
    gap = abs(computed - expected)
    return gap / peak if peak else (0.0 if gap == 0 else math.inf)
