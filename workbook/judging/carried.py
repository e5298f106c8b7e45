"""What ``inputs`` and ``regenerate`` leave behind: they carry what was entered, and nothing else."""

from __future__ import annotations

from workbook.book.declare import Book
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.judging.structure import structure
from workbook.reading.files import BookFile

MOST = 3  # cells that a line names


def not_carried(file: BookFile, declared: Book, template: str) -> list[str]:
    """Return a line for each foreign sheet, and for each sheet with formulas that are not the generated ones."""
    match = Match(file, declared)
    ours = {pair.address.sheet for pair in match.pairs}
    foreign = [title for title in file.workbook.sheetnames if title not in ours]
    lines = [f"the sheet {title!r} is not carried over: it is none of the generated ones" for title in foreign]
    report = Report(file.path, template)
    structure(match, report)
    edited: dict[str, list[str]] = {}
    for found in report.findings:
        if found.kind != "missing":
            edited.setdefault(found.sheet, []).append(found.cell)
    added: dict[str, list[str]] = {}
    for address in file.contents.formula_cells:
        if address.sheet in ours and address not in match.addresses:
            added.setdefault(address.sheet, []).append(address.a1)
    lines += [f"edits on the sheet {s!r} are not carried over: {listed(cells)}" for s, cells in edited.items()]
    lines += [f"formulas added on the sheet {s!r} are not carried over: {listed(cells)}" for s, cells in added.items()]
    return lines


def listed(cells: list[str]) -> str:
    """Return the first cells, and how many more there are."""
    rest = f" and {len(cells) - MOST} more" if len(cells) > MOST else ""
    return ", ".join(cells[:MOST]) + rest
