"""Contents that ``inputs`` and ``regenerate`` leave, and the engineer's additions that ``regenerate`` takes along."""

from collections import defaultdict
from typing import Any

from openpyxl.cell.cell import Cell
from openpyxl.workbook.defined_name import DefinedName

from workbook.book.address import Address
from workbook.book.declare import Book, Sheet
from workbook.errors import listed
from workbook.judging.display.cells import rule_words
from workbook.judging.display.charts import pair_charts, read_charts
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.judging.structure import check_structure
from workbook.reading.contents import Contents
from workbook.reading.files import BookFile
from workbook.writing.charts import draw
from workbook.writing.layout import PossibleTexts, widths
from workbook.writing.style import conditional_formats
from workbook.writing.write import NO_ADDITIONS, Additions, chart_size


def not_carried(match: Match, template: str, own: Additions = NO_ADDITIONS) -> list[str]:
    """Return in lines what a file has that is neither an entry nor ``own``, what is carried over besides."""
    file = match.file
    ours = {pair.address.sheet for pair in match.pairs}
    titles = {sheet.title for sheet in own.sheets}
    foreign = [title for title in file.workbook.sheetnames if title not in ours | titles]
    lines = [f"the sheet {title!r} is not carried over: it is none of the generated ones" for title in foreign]
    report = Report(file.path, template)
    check_structure(match, report)
    edited, added = defaultdict[str, list[str]](list), defaultdict[str, list[str]](list)
    for finding in (finding for finding in report.findings if finding.kind != "missing"):
        edited[finding.sheet].append(finding.cell)
    taken = {(cell.parent.title, cell.coordinate) for cell, _ in own.cells}
    for at in file.contents.formula_cells:
        if at.sheet in ours | titles and at not in match.numbers and (at.sheet, at.a1) not in taken:
            added[at.sheet].append(at.a1)
    lines += [f"edits on the sheet {s!r} are not carried over: {listed(cells)}" for s, cells in edited.items()]
    lines += [f"formulas added on the sheet {s!r} are not carried over: {listed(cells)}" for s, cells in added.items()]
    return lines + left_behind(match, own)


def left_behind(match: Match, own: Additions = NO_ADDITIONS) -> list[str]:
    """Return a line for each kind of addition to a generated sheet that is not in ``own``, and for names."""
    taken = {(cell.parent.title, cell.coordinate) for cell in (*(cell for cell, _ in own.cells), *own.notes)}
    lines = [
        f"{what} on the sheet {title!r} are not carried over: {listed(left)}"
        for declared, title in match.sheets
        for what, cells in sheet_additions(match, declared, title).items()
        if (left := [a1 for a1 in cells if (title, a1) not in taken])
    ]
    if left := [name.name for name in own_names(match) if name not in own.names]:
        lines.append(f"names of your own are not carried over: {listed(left)}")
    if inspected := match.file.inspected:
        drawn = (sheet.title for sheet in own.sheets if inspected.drawings.get(sheet.title))
        lines += [f"charts and pictures of the sheet {title!r} are not carried over" for title in drawn]
        lines += [f"{what} are not carried over: {count} in all" for what, count in inspected.drawn.items() if count]
    return lines


def sheet_additions(match: Match, declared: Sheet, title: str) -> dict[str, list[str]]:
    """Return the cells of what was added to a sheet, by its kind in words."""
    sheet, words = match.file.workbook[title], {text.text for text in declared.texts}
    constants = match.file.contents.constants.items()
    known = {rule_words(mark.rule) for block in declared.blocks for mark in conditional_formats(block)}
    charts, wide = list(read_charts(match, title)), widths(declared, PossibleTexts(match.declared))
    drawn = [draw(chart, match.declared, *chart_size(declared, wide, *place)) for chart, *place in declared.charts]
    ours = {id(chart) for *_, chart in pair_charts(match, declared, drawn, charts)}
    return {
        "texts and numbers": [
            at.a1 for at, text in constants if at.sheet == title and at not in match.numbers and text not in words
        ],
        "notes": [cell.coordinate for cell in sheet._cells.values() if isinstance(cell, Cell) and cell.comment],
        "charts": [chart.at.a1 for chart in charts if id(chart) not in ours],
        "conditional formats": [
            str(area.sqref) for area in sheet.conditional_formatting if set(map(rule_words, area.rules)) - known
        ],
    }


def find_additions(match: Match, fresh: Book) -> Additions:
    """Return the additions of a matched file that a fresh book of the same inputs takes along."""
    file = match.file
    ours = {pair.address.sheet for pair in match.pairs}
    own = [sheet for sheet in file.workbook.worksheets if sheet.title not in ours | {s.title for s in fresh.sheets}]
    known, taken = steady_sheets(file, fresh) | {sheet.title for sheet in own}, taken_cells(match, fresh)
    cells = [
        cell
        for sheet in file.workbook.worksheets
        if sheet.title in known
        for cell in sheet._cells.values()
        if isinstance(cell, Cell)
    ]
    free = [cell for cell in cells if (cell.parent.title, cell.row, cell.column) not in taken]
    held = [(cell, content) for cell in free if (content := carried_content(file.contents, cell, known)) is not None]
    notes = [cell for cell in cells if cell.comment is not None]
    names = tuple(defined for defined in own_names(match) if leads_to_sheets(defined, known))
    return Additions(tuple(own), tuple(held), tuple(notes), names)


def leads_to_sheets(defined: DefinedName, known: set[str]) -> bool:
    """Whether a name leads to cells, all of them on known sheets."""
    titles = {title for title, _ in defined.destinations}
    return bool(titles) and titles <= known


def steady_sheets(file: BookFile, fresh: Book) -> set[str]:
    """Return the sheets of a fresh book on which all blocks lie as they do in a file."""
    lies = {name: place[:4] for name, place in file.places.items()}
    return {
        sheet.title
        for sheet in fresh.sheets
        if all(lies.get(b.name) == (sheet.title, b.row, b.column, b.size) for b in sheet.blocks)
    }


def taken_cells(match: Match, fresh: Book) -> set[tuple[str, int, int]]:
    """Return the cells that hold something declared, in a file or in a fresh book."""
    texts = {(sheet.title, text.row, text.column) for sheet in fresh.sheets for text in sheet.texts if text.text}
    cells = {(cell.block.sheet.title, cell.row, cell.column) for cell in fresh.cells()}
    return texts | cells | {(a.sheet, a.row, a.column) for a in match.numbers}


def carried_content(contents: Contents, cell: Cell, known: set[str]) -> Any:
    """Return the content of a cell; None for nothing, and for a formula that refers to other sheets than the known."""
    address = Address(cell.parent.title, cell.row, cell.column)
    if cell.data_type != "f":
        return contents.constants.get(address)
    if (formula := contents.formulas.get(address)) is None or address in contents.arrays:
        return None
    sheets = {area.sheet for area in formula.arguments if not isinstance(area, str)}
    return cell.value if sheets <= known else None


def own_names(match: Match) -> list[DefinedName]:
    """Return the names that are someone's own."""
    declared, held = {name.casefold() for name, _ in match.declared.names()}, match.file.workbook.defined_names.items()
    return [own for name, own in held if name.casefold() not in declared and not name.startswith("_xl")]
