"""Contents that ``inputs`` and ``regenerate`` leave, and the engineer's additions that ``regenerate`` takes along."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import Any

from openpyxl.cell.cell import Cell
from openpyxl.workbook.defined_name import DefinedName
from openpyxl.worksheet.worksheet import Worksheet

from workbook.book.address import Address
from workbook.book.declare import Book, Sheet
from workbook.book.formula import FormulaError
from workbook.errors import WriteError, listed
from workbook.judging.display.cells import rule_words
from workbook.judging.display.charts import pair_charts, read_charts
from workbook.judging.matching import Match
from workbook.judging.moved_cells import LostError, Moves
from workbook.judging.report import Report
from workbook.judging.structure import check_structure
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
    none = "is not carried over: it is none of the generated ones"
    lines = [f"the sheet {title!r} {none}" for title in foreign]
    report = Report(file.path, template)
    check_structure(match, report)
    edited, added = defaultdict[str, list[str]](list), defaultdict[str, list[str]](list)
    for finding in (finding for finding in report.findings if finding.kind != "missing"):
        edited[finding.sheet].append(finding.cell)
    taken = taken_places(own)
    for at in file.contents.formula_cells:
        if at.sheet in ours | titles and at not in match.numbers and (at.sheet, at.a1) not in taken:
            added[at.sheet].append(at.a1)
    lines += [f"{at} is not carried over: {reason}" for at, reason in own.lost.items()]
    for what, by_sheet in (("edits", edited), ("formulas added", added)):
        for title, cells in by_sheet.items():
            lines.append(f"{what} on the sheet {title!r} are not carried over: {listed(cells)}")
    return lines + left_behind(match, own)


def left_behind(match: Match, own: Additions = NO_ADDITIONS) -> list[str]:
    """Return a line for each kind of addition to a generated sheet that is not in ``own``, and for names."""
    taken, carried = taken_places(own), {name.name for name in own.names}
    lines = [
        f"{what} on the sheet {title!r} are not carried over: {listed(left)}"
        for declared, title in match.sheets
        for what, cells in sheet_additions(match, declared, title).items()
        if (left := [a1 for a1 in cells if (title, a1) not in taken])
    ]
    if left := [name.name for name in own_names(match) if name.name not in carried]:
        lines.append(f"names of your own are not carried over: {listed(left)}")
    inspected, left_there = match.file.inspected, "of the sheet {!r} are not carried over"
    for sheet in (sheet for sheet in own.sheets if sheet.tables):
        lines.append(f"tables {left_there.format(sheet.title)}: {listed([*sheet.tables])}")
    drawn = (sheet.title for sheet in own.sheets if inspected.drawings.get(sheet.title))
    lines += [f"charts and pictures {left_there.format(title)}" for title in drawn]
    counted = ((what, count) for what, count in inspected.drawn.items() if count)
    lines += [f"{what} are not carried over: {count} in all" for what, count in counted]
    return lines


def taken_places(own: Additions) -> set[tuple[str, str]]:
    """Return the sheets and cells of what is taken along, and of what is known to stay behind."""
    cells = [cell for cell, *_ in own.cells] + [cell for cell, _ in own.notes]
    taken = {(cell.parent.title, cell.coordinate) for cell in cells}
    return taken | {(at.sheet, at.a1) for at in own.lost}


def sheet_additions(match: Match, declared: Sheet, title: str) -> dict[str, list[str]]:
    """Return the cells of what was added to a sheet, by its kind in words."""
    sheet, book = match.file.workbook[title], match.declared
    known = {rule_words(mark.rule) for b in declared.blocks for mark in conditional_formats(b)}
    marked = ((area, {*map(rule_words, area.rules)}) for area in sheet.conditional_formatting)
    charts, wide = list(read_charts(match, title)), widths(declared, PossibleTexts(book))
    sizes = ((chart, chart_size(declared, wide, *place)) for chart, *place in declared.charts)
    drawn = [draw(chart, book, *size) for chart, size in sizes]
    ours = {id(chart) for *_, chart in pair_charts(match, declared, drawn, charts)}
    constants = (at for at in match.file.contents.constants if at.sheet == title)
    cells = (cell for cell in sheet._cells.values() if isinstance(cell, Cell))
    return {
        "texts and numbers": [at.a1 for at in constants if is_own(match, at)],
        "notes": [cell.coordinate for cell in cells if cell.comment],
        "charts": [chart.at.a1 for chart in charts if id(chart) not in ours],
        "conditional formats": [str(area.sqref) for area, words in marked if words - known],
    }


def find_additions(match: Match, fresh: Book) -> Additions:
    """Return the additions of a matched file that a fresh book takes along, with their places, and what it lacks."""
    ours = {pair.address.sheet for pair in match.pairs}
    titles = {sheet.title.casefold() for sheet in fresh.sheets}
    sheets = match.file.workbook.worksheets
    beside = (sheet for sheet in sheets if sheet.title not in ours)
    own = [sheet for sheet in beside if sheet.title.casefold() not in titles]
    moves = Moves(match, fresh, {sheet.title for sheet in own})
    names = tuple(carried_names(match, moves))
    moves.own_names |= {name.name.casefold() for name in names}
    taken, lost = taken_cells(fresh), dict[Address, str]()
    cells, notes = list[tuple[Cell, Address, Any]](), list[tuple[Cell, Address]]()
    for at, cell in cells_on(sheets, ours | moves.own_sheets):
        try:
            if is_own(match, at):
                to = free_place(moves, at, taken)
                cells.append((cell, to, carried_content(moves, cell, at, to.sheet)))
            if cell.comment is not None:
                notes.append((cell, moves.cell(at)))
        except LostError as error:
            lost[at] = str(error)
    return Additions(tuple(own), tuple(cells), tuple(notes), names, tuple(moves.remarks()), lost)


def cells_on(sheets: Sequence[Worksheet], titles: set[str]) -> Iterator[tuple[Address, Cell]]:
    """Yield the cells of sheets with these titles."""
    for sheet in (sheet for sheet in sheets if sheet.title in titles):
        cells = (cell for cell in sheet._cells.values() if isinstance(cell, Cell))
        yield from ((Address(sheet.title, cell.row, cell.column), cell) for cell in cells)


def is_own(match: Match, at: Address) -> bool:
    """Whether a cell holds something that no book of the engine's has there."""
    if at in match.numbers or at in match.labels:
        return False
    contents = match.file.contents
    return any(at in held for held in (contents.formulas, contents.failed, contents.constants))


def free_place(moves: Moves, at: Address, taken: set[Address]) -> Address:
    """Return where an own cell goes, and note it as taken; raise LostError where the fresh book has something there."""
    if (to := moves.cell(at)) in taken:
        raise LostError(f"the new book has something else in {to}")
    taken.add(to)
    return to


def carried_names(match: Match, moves: Moves) -> Iterator[DefinedName]:
    """Yield the engineer's own names that lead on, each with what it leads to in the fresh book."""
    known = {name.casefold() for name, _ in moves.fresh.names()}
    for own in own_names(match):
        text = str(own.attr_text)
        try:
            if own.name.casefold() not in known and "#REF!" not in text:
                led = moves.formula(f"={text}", Address("", 1, 1), "").removeprefix("=")
                yield DefinedName(own.name, attr_text=led, comment=own.comment, hidden=own.hidden)
        except (LostError, FormulaError):
            continue


def taken_cells(fresh: Book) -> set[Address]:
    """Return the cells in which a fresh book has something."""
    texts = ((sheet.title, text) for sheet in fresh.sheets for text in sheet.texts if text.text)
    cells = {Address(cell.block.sheet.title, cell.row, cell.column) for cell in fresh.cells()}
    return cells | {Address(title, text.row, text.column) for title, text in texts}


def carried_content(moves: Moves, cell: Cell, at: Address, sheet: str) -> Any:
    """Return the content of an own cell on a sheet of the fresh book; raise LostError where a formula cannot follow."""
    contents = moves.match.file.contents
    if cell.data_type != "f":
        return contents.constants[at]
    if at in contents.arrays or not isinstance(cell.value, str):
        raise LostError("it is a formula over several cells")
    return moves.formula(cell.value, at, sheet)


def own_names(match: Match) -> list[DefinedName]:
    """Return the names that are someone's own."""
    declared = {name.casefold() for name, _ in match.declared.names()}
    held = match.file.workbook.defined_names.values()
    named = (own for own in held if own.name.casefold() not in declared)
    return [own for own in named if not own.name.startswith("_xl")]


def with_sheet(own: Additions, sheet: Worksheet) -> Additions:
    """Return additions with a sheet in place of an older one that begins alike; raise WriteError where none does."""
    title = sheet.title
    if any(each.title == title and each["A1"].value != sheet["A1"].value for each in own.sheets):
        raise WriteError(f"the sheet {title!r} is your own; expected another title of it")
    cells = ((c, Address.parse(c.coordinate, title)) for row in sheet.iter_rows() for c in row)
    return own._replace(
        sheets=(*(each for each in own.sheets if each.title != title), sheet),
        cells=(
            *(each for each in own.cells if each[1].sheet != title),
            *((cell, at, cell.value) for cell, at in cells if cell.value is not None),
        ),
        notes=tuple(each for each in own.notes if each[1].sheet != title),
    )
