"""Compare what the cells of a matched file hold with what is declared, without evaluating anything."""

import math
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby
from typing import Any

from openpyxl import Workbook
from pydantic import BaseModel

from workbook.book.address import Address, Place
from workbook.book.declare import Block, Book
from workbook.book.rows import is_number
from workbook.book.stamp import TABLE
from workbook.entries.rules import field_at
from workbook.errors import ReadError, listed
from workbook.functions.declarations import NAMESPACE
from workbook.functions.names import definitions, meaning
from workbook.judging.matching import Match
from workbook.judging.report import FOLLOWS, LAYOUT, Finding, Report
from workbook.reading.files import BookFile, LiteralText, is_formula

LAST_DIGITS = 1e-14  # LibreOffice keeps 15 digits of a number when it saves


def check_structure(match: Match, report: Report) -> set[Address]:
    """Enter formulas and constants that are not the declared ones; return those formulas."""
    suspects = set()
    for pair in match.pairs:
        if pair.cell.quantity.role == "input":
            continue
        if not pair.declared_formula:
            if not holds_declared(pair.held, pair.cell.content):
                held = f'"{pair.held}"' if isinstance(pair.held, LiteralText) else pair.held
                report.add(pair, "changed", held, pair.cell.content)
        elif isinstance(pair.held, str) and pair.held.startswith("{="):  # part of a formula that fills several cells
            suspects.add(pair.address)
            report.add(pair, "formula", pair.held, pair.cell.content)
        elif pair.held is None:
            report.add(pair, "missing", None, pair.cell.expected)
        elif isinstance(pair.held, LiteralText):
            held = f'"{pair.held}"'
            report.add(pair, "replaced", held, pair.cell.content, why="a text is never computed")
        elif not is_formula(pair.held):
            report.add(pair, "replaced", pair.held, pair.cell.expected)
        elif not match.same_formula(pair.cell.content, pair.cell.block, pair.held, pair.address.sheet):
            suspects.add(pair.address)
            report.add(pair, "formula", pair.held, pair.cell.content)
    return suspects


def holds_declared(held: Any, content: Any) -> bool:
    """Whether a cell holds what is declared, of the same type: TRUE is not 1; an empty text is an empty cell."""
    if content == "":
        return held is None or held == ""
    if is_number(content):
        return is_number(held) and math.isclose(held, content, rel_tol=LAST_DIGITS)
    return type(held) is type(content) and bool(held == content)


ALLOWED = frozenset(
    (
        "IF AND OR NOT MIN MAX ABS SIGN SQRT SIN COS TAN ATAN2 PI EXP LN LOG10 POWER INT ROUND "
        "SUM SUMPRODUCT AVERAGE COUNT COUNTIF INDEX MATCH CHOOSE LARGE SMALL ISNUMBER RADIANS "
        "DEGREES"
    ).split()
)
VOLATILE = frozenset(["NOW", "TODAY", "RAND", "RANDBETWEEN", "OFFSET", "INDIRECT", "CELL", "INFO", "RANDARRAY"])
MOST = 5  # names that a note lists
COMPUTED = "how the program computes"


def audit(match: Match, template: type[BaseModel]) -> Iterator[Finding]:
    """Yield what is wrong with formulas, names, inputs and settings of a matched workbook."""
    for findings in (function_findings, sheet_name_findings, column_name_findings, stray_blocks):
        yield from findings(match)
    inputs = [pair for pair in match.pairs if pair.cell.quantity.role == "input" and pair.held is not None]
    sums = {pair.address for pair in match.pairs if pair.cell.block.name == TABLE}  # of all entries: no use of them
    contents = match.file.contents
    read = contents.read([pair.address for pair in inputs], contents.formulas.keys() - sums)
    for pair in inputs:  # that no formula reads; texts that only describe are left out
        q, at = pair.cell.quantity, pair.address
        if at not in read and (field_at(template, q.key)[0] is not str or q.choices):
            yield Finding(at.sheet, at.a1, "unread", str(pair.held), "an input that a formula reads")
    yield from setting_findings(match.file.workbook)


def sheet_name_findings(match: Match) -> Iterator[Finding]:
    """Yield names of a sheet that its formulas take for the book's of the same name."""
    declared = {name.casefold() for name, _ in match.declared.names()}
    ours = {p.address.sheet for p in match.pairs}
    for sheet in (sheet for sheet in match.file.workbook.worksheets if sheet.title in ours):
        for name, defined in sheet.defined_names.items():
            if name.casefold() in declared:
                yield Finding(sheet.title, name, "name", str(defined.attr_text), "no name of the sheet's own")


def function_findings(match: Match) -> Iterator[Finding]:
    """Yield cells that should hold another formula: with a function that not every program has, or that is volatile."""
    formulas = match.file.contents.formulas
    for pair in match.pairs:
        formula = formulas.get(pair.address) if pair.declared_formula else None
        for name in sorted(formula.functions - ALLOWED) if formula else ():
            why = "a function that is not volatile" if name in VOLATILE else "a function that every program has"
            yield Finding(pair.address.sheet, pair.address.a1, "function", name, why)


def stale_functions(workbook: Workbook) -> Iterator[str]:
    """Yield a note where names that define the functions MOTION.*, copied beside a machine, are not today's."""
    held = {name: held.attr_text or "" for name, held in workbook.defined_names.items() if NAMESPACE in name}
    if not held:  # as in most books: the definitions need not be read
        return
    other = sorted(d.name for d in definitions() if d.name in held and meaning(held[d.name]) != meaning(d.stored))
    if other:
        yield f"names that are not today's definitions: {listed(other, MOST)}; take them from motion-functions.xlsx"


def setting_findings(workbook: Workbook) -> Iterator[Finding]:
    """Yield the settings of a file that let formulas go stale, round them, or read them by other rules."""
    held = workbook.calculation
    settings: list[tuple[str, str]] = []
    if held and held.calcMode == "manual":
        settings.append(("manual", "automatic: else what is shown is not what was entered"))
    if held and held.iterate:
        settings.append(("iterative", "not iterative: else a cell that depends on itself has a value"))
    if held and held.fullPrecision is False:
        settings.append(("with the precision as displayed", "with full precision"))
    for setting in settings:
        yield Finding("", "calculation", "setting", *setting, COMPUTED)
    for sheet in workbook.worksheets:
        if sheet.sheet_properties.transitionEvaluation or sheet.sheet_properties.transitionEntry:
            rules = "by the rules of Lotus 1-2-3", "by those of Excel"
            yield Finding(sheet.title, "calculation", "setting", *rules, COMPUTED)


def structure_finding(place: Place, name: str, fault: str, expected: str) -> Finding:
    """Return the finding of a name that leads elsewhere: its place, the fault, and the expectation."""
    return Finding(place.sheet, place.cell(0, 0).a1, "name", f"{name}: {fault}", expected)


def column_name_findings(match: Match) -> Iterator[Finding]:
    """Yield names of a table's column, or of several side by side, that are not those; and public names."""
    places = match.file.places
    for name, (table, column) in match.declared.column_names.items():
        block, place = match.declared.blocks[table], places.get(table)
        if place is None:
            continue
        first, last = (place.part(part - block.column) for part in block.ends(column))
        right, held = (first.corners[0], last.corners[1]), places.get(name)
        if held is None or held.corners != right:
            expected = range_of(first._replace(columns=last.column - first.column + 1))
            yield structure_finding(held or first, name, range_of(held), expected)
    for name, cell in match.declared.public.items():
        if (place := places.get(cell)) is not None and places.get(name) != place:
            yield structure_finding(place, name, range_of(places.get(name)), range_of(place))


def stray_blocks(match: Match) -> Iterator[Finding]:
    """Yield the first of the blocks that lie on another sheet than the rest of theirs, and how many there are."""
    for sheet in match.declared.sheets:
        placed = match.placed(sheet)
        counted = Counter(place.sheet for _, place in placed).most_common(1)
        away = defaultdict[str, list[tuple[Block, Place]]](list)
        for block, place in placed:
            away[place.sheet].append((block, place))
        away.pop(counted[0][0] if counted else "", None)
        for title, ((first, place), *more) in away.items():
            others = f"the sheet {title}" + (f", and so do {len(more)} more" if more else "")
            expected = f"the sheet {counted[0][0]}, with the others: move it back"
            yield structure_finding(place, first.name, others, expected)


def range_of(place: Place | None) -> str:
    """Return a place in words."""
    if place is None:
        return "no cells"
    first, last = place.corners
    return f"{first}:{last.a1}"


FOLLOWING = frozenset(("value", "error", "saved"))
SPARE = "no row between the table's own: delete it, and enter what it should hold in a spare row"


def layout_findings(match: Match) -> Iterator[Finding]:
    """Yield a finding for rows of a sheet that were put into tables."""
    inserted = defaultdict[tuple[str, int], list[Block]](list)
    for name, rows in match.file.inserted.items():
        for row in rows:
            inserted[match.file.places[name].sheet, row].append(match.declared.blocks[name])
    for _, run in groupby(enumerate(sorted(inserted)), key=lambda pair: (pair[1][0], pair[1][1] - pair[0])):
        places = [place for _, place in run]
        (sheet, first), (_, last) = places[0], places[-1]
        change = f"row {first} was inserted" if first == last else f"rows {first} to {last} were inserted"
        yield Finding(sheet, f"{first}:{last}", LAYOUT, change, SPARE, table_titles(inserted[places[0]]))


def table_titles(blocks: list[Block]) -> str:
    """Return which tables they are: the heading of the first, and the names of all."""
    block, names = blocks[0], [b.name for b in blocks]
    above = [text for text in block.sheet.texts if text.style == "heading" and text.row < block.row]
    heading = max(above, key=lambda text: text.row).text if above else block.title
    return f"{heading}: the table {names[0]}" if len(names) == 1 else f"{heading}: the tables {', '.join(names)}"


def mark_consequences(match: Match, report: Report, suspects: set[Address]) -> None:
    """Mark the wrong values that follow from rows put into tables: formulas count the rows of their ranges."""
    formulas = {(p.address.sheet, p.address.a1): p.address for p in match.pairs} if match.file.inserted else {}
    for n, finding in enumerate(report.findings):
        at = formulas.get((finding.sheet, finding.cell))
        if at is not None and finding.kind in FOLLOWING and at not in suspects:
            report.findings[n] = replace(finding, kind=FOLLOWS)


def refuse_cut_cells(file: BookFile, layout: Book) -> None:
    """Raise ReadError where cells of a table were cut: formulas have followed them, and read them elsewhere."""
    match = Match(file, layout)
    empty = {pair.address: pair.cell.block for pair in match.pairs if pair.held is None}
    cut: dict[str, dict[Address, Address]] = {}
    for pair in (p for p in match.pairs if p.declared_formula and is_formula(p.held) and p.held != p.cell.content):
        for home, there in match.cells_read_elsewhere(pair):
            if home in empty:
                cut.setdefault(empty[home].name, {})[home] = there
    for name, places in cut.items():
        (first, there), last = min(places.items()), max(places)
        raise ReadError(
            f"{file.path}: {first}:{last.a1} of {table_titles([layout.blocks[name]])} was cut: formulas read what "
            f"stood in {first.a1} at {there}; undo that, or cut and paste it back"
        )
