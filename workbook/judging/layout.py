"""Rows and columns put into a table, or taken out of it: a finding each, and none for what follows from it."""

from collections import defaultdict
from collections.abc import Iterator
from itertools import groupby
from typing import Any

from openpyxl.utils import get_column_letter

from workbook.book.address import Address, Fit
from workbook.book.declare import Block
from workbook.judging.matching import Match
from workbook.judging.report import LAYOUT, Finding, Report

FOLLOWING = frozenset(("value", "error", "follows", "saved"))
UNDO = "undo that, or take the table from a copy; `regenerate` carries over what is entered"
SPARE = "no row between the table's own: delete it, and enter what it should hold in a spare row"


def layout_findings(match: Match) -> Iterator[Finding]:
    """Yield a finding for each row or column of a sheet that was put into tables, or is gone from them."""
    tables = (block for block in match.declared.blocks.values() if block.is_table)
    there = [(block, fit) for block in tables if (fit := fit_of(match, block)) is not None]
    inserted = defaultdict[tuple[str, int], list[Block]](list)
    gone, columns = defaultdict[Any, list[Block]](list), defaultdict[Any, list[tuple[Block, str]]](list)
    for block, fit in there:
        for row in fit.inserted:
            inserted[fit.place.sheet, row].append(block)
        for row, count in fit.lost:
            gone[fit.place.sheet, row, count].append(block)
        for j in fit.gone:
            columns[fit.place.sheet, fit.before(j)].append((block, block.quantities[j].label))
    for _, run in groupby(enumerate(sorted(inserted)), key=lambda pair: (pair[1][0], pair[1][1] - pair[0])):
        rows = [row for _, row in run]
        (sheet, first), (_, last) = rows[0], rows[-1]
        change = f"row {first} was inserted" if first == last else f"rows {first} to {last} were inserted"
        yield Finding(sheet, f"{first}:{last}", LAYOUT, change, SPARE, table_titles(inserted[rows[0]]))
    for (sheet, row, count), blocks in gone.items():
        change = f"{'a row is' if count == 1 else f'{count} rows are'} gone above row {row}"
        yield Finding(sheet, f"{row}:{row}", LAYOUT, change, UNDO, table_titles(blocks))
    for (sheet, number), torn in columns.items():
        letter, labels = get_column_letter(number), dict.fromkeys(repr(label) for _, label in torn)
        change = f"a column is gone before column {letter}: {', '.join(labels)}"
        yield Finding(sheet, f"{letter}:{letter}", LAYOUT, change, UNDO, table_titles([block for block, _ in torn]))


def fit_of(match: Match, block: Block) -> Fit | None:
    """Return how a table lies that is not as declared; rows that are gone from its end are among those it has lost."""
    if (place := match.file.places.get(block.name)) is None:
        return None
    fit = match.file.fits.get(block.name, Fit(place))
    behind = fit.place.cell(fit.place.rows, 0).row
    if block.size > fit.size:
        fit = fit._replace(lost=(*fit.lost, (behind, block.size - fit.size)))
    if block.size < fit.size:
        fit = fit._replace(inserted=(*fit.inserted, *range(behind - fit.size + block.size, behind)))
    return fit


def table_titles(blocks: list[Block]) -> str:
    """Return which tables they are: the heading of the first, and the names of all."""
    block, names = blocks[0], [b.name for b in blocks]
    above = [text for text in block.sheet.texts if text.style == "heading" and text.row < block.row]
    heading = max(above, key=lambda text: text.row).text if above else block.title
    return f"{heading}: the table {names[0]}" if len(names) == 1 else f"{heading}: the tables {', '.join(names)}"


def set_consequences_aside(match: Match, report: Report, suspects: set[Address]) -> None:
    """Set aside what follows from rows, columns and names inserted or gone: wrong values, #REF!."""
    fits = match.file.fits
    unfit = {*fits, *(block.name for block, _ in match.misfits)}
    less = any(fit.lost or fit.gone for fit in fits.values())
    torn = less or any(fit.inserted for fit in fits.values()) or bool(match.misfits)
    formulas = {(p.address.sheet, p.address.a1): p for p in match.pairs} if torn else {}
    causes: list[Finding] = []
    for f in report.findings:
        pair, follows = formulas.get((f.sheet, f.cell)), less and f.kind == "unread"
        if pair is not None:
            suspect = pair.address in suspects
            bereft = suspect and "#REF!" in str(pair.held)
            follows |= (f.kind in FOLLOWING and (bereft or not suspect)) or (f.kind == "formula" and bereft)
            follows |= f.kind == "changed" and pair.cell.block.name in unfit
        (report.following if follows else causes).append(f)
    report.findings[:] = causes
