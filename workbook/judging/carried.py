"""What ``inputs`` and ``regenerate`` leave behind: they carry what was entered, and nothing else."""

from __future__ import annotations

import re
import zipfile
from fnmatch import fnmatch
from pathlib import Path

from openpyxl.cell.cell import Cell
from openpyxl.worksheet.worksheet import Worksheet
from pydantic import BaseModel

from workbook.book.declare import Book, Sheet
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.judging.shown.charts import paired
from workbook.judging.shown.drawn import drawn
from workbook.judging.shown.looks import Looks
from workbook.judging.shown.rules import Rules
from workbook.judging.shown.seen import Told, seen
from workbook.judging.structure import structure
from workbook.reading.files import BookFile

MOST = 3  # cells that a line names
DRAWN = {"pictures": re.compile(rb"<(?:\w+:)?pic[ >]"), "shapes and text boxes": re.compile(rb"<(?:\w+:)?sp[ >]")}
"""what drawings hold besides charts, by the elements (ISO/IEC 29500-1, 20.5.2)"""


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
    return lines + own_things(match, ours)


def own_things(match: Match, ours: set[str]) -> list[str]:
    """Return a line for each kind of thing that someone put on a generated sheet beside its cells, and for names."""
    lines, known = [], known_rules(match)
    for sheet in match.file.workbook.worksheets:
        if sheet.title in ours:
            for what, where in on_sheet(match, sheet, known).items():
                if where:
                    lines.append(f"{what} on the sheet {sheet.title!r} are not carried over: {listed(where)}")
    declared = {name.casefold() for name, _ in match.declared.names()}
    names = [name for name in match.file.workbook.defined_names if name.casefold() not in declared]
    own = [name for name in names if not name.startswith("_xl")]
    if own:
        lines.append(f"names of your own are not carried over: {listed(own)}")
    lines += [f"{what} are not carried over: {count} in all" for what, count in drawn_in(match.file.path).items()]
    return lines


def known_rules(match: Match) -> set[int]:
    """Return the conditional formats of a file that are those of a fresh build, by their identity."""
    told = Told()
    rules = Rules(match, Looks(match, BaseModel, told), told)
    rules.judge(list(seen(match, [])))
    return rules.known


def on_sheet(match: Match, sheet: Worksheet, known: set[int]) -> dict[str, list[str]]:
    """Return what stands on a sheet that is none of the generated book's, by kind: the cells, or what it is called."""
    declared = next(one for one in match.declared.sheets if sheet.title in titles(match, one))
    words = {text.text for text in declared.texts}
    contents = match.file.contents.constants.items()
    kept = [a.a1 for a, held in contents if a.sheet == sheet.title and a not in match.addresses and held not in words]
    cells = sheet._cells.values()
    notes = [cell.coordinate for cell in cells if isinstance(cell, Cell) and cell.comment is not None]
    held = list(drawn(match, sheet.title))
    paired_charts = {id(found) for _, found in paired(match, declared, held)}
    charts = [chart.at.a1 for chart in held if id(chart) not in paired_charts]
    rules = [str(a.sqref) for a in sheet.conditional_formatting if any(id(rule) not in known for rule in a.rules)]
    return {"texts and numbers": kept, "notes": notes, "charts": charts, "conditional formats": rules}


def titles(match: Match, sheet: Sheet) -> set[str]:
    """Return where the blocks of a declared sheet are in the file."""
    return {match.file.places[block.name].sheet for block in sheet.blocks if block.name in match.file.places}


def drawn_in(path: Path) -> dict[str, int]:
    """Return how many pictures, and shapes or text boxes, the drawings of a file hold; generated ones hold charts."""
    try:
        with zipfile.ZipFile(path) as archive:
            drawings = [archive.read(name) for name in archive.namelist() if fnmatch(name, "xl/drawings/drawing*.xml")]
    except (OSError, zipfile.BadZipFile):
        return {}
    counted = {what: sum(len(sign.findall(part)) for part in drawings) for what, sign in DRAWN.items()}
    return {what: count for what, count in counted.items() if count}


def listed(cells: list[str]) -> str:
    """Return the first cells, and how many more there are."""
    rest = f" and {len(cells) - MOST} more" if len(cells) > MOST else ""
    return ", ".join(cells[:MOST]) + rest
