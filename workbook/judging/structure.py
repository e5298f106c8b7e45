"""Compare what the cells of a matched file hold with what is declared, without evaluating anything."""

import math
from collections import Counter, defaultdict
from collections.abc import Iterator
from dataclasses import replace
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
        elif pair.held is None:
            report.add(pair, "missing", None, pair.cell.expected)
        elif isinstance(pair.held, LiteralText):
            held = f'"{pair.held}"'
            report.add(pair, "replaced", held, pair.cell.content, why="a text is never computed")
        # the latter in each of several cells that a formula fills
        elif not str(pair.held).startswith(("=", "{=")):
            report.add(pair, "replaced", pair.held, pair.cell.expected)
        elif not (is_formula(pair.held) and match.holds_formula(pair)):
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
    "IF AND OR NOT MIN MAX ABS SIGN SQRT SIN COS TAN ATAN2 PI EXP LN LOG10 POWER INT ROUND SUM"
    " SUMPRODUCT AVERAGE COUNT COUNTIF INDEX MATCH CHOOSE LARGE SMALL ISNUMBER RADIANS DEGREES".split()
)
VOLATILE = frozenset("NOW TODAY RAND RANDBETWEEN OFFSET INDIRECT CELL INFO RANDARRAY".split())
MOST = 5  # names that a note lists


def audit(match: Match, template: type[BaseModel]) -> Iterator[Finding]:
    """Yield what is wrong with formulas, names, inputs and settings of a matched workbook."""
    for findings in (function_findings, sheet_name_findings, column_name_findings, stray_blocks):
        yield from findings(match)
    entered = (pair for pair in match.pairs if pair.cell.quantity.role == "input")
    inputs = {pair.address: pair for pair in entered if pair.held is not None}
    # of all entries: no use of them
    sums = {pair.address for pair in match.pairs if pair.cell.block.name == TABLE}
    contents = match.file.contents
    read = contents.read(inputs, contents.formulas.keys() - sums)
    for at, pair in inputs.items():  # that no formula reads; texts that only describe are left out
        q, expected = pair.cell.quantity, "an input that a formula reads"
        if at not in read and (field_at(template, q.key)[0] is not str or q.choices):
            yield Finding(at.sheet, at.a1, "unread", str(pair.held), expected)
    yield from setting_findings(match.file.workbook)


def sheet_name_findings(match: Match) -> Iterator[Finding]:
    """Yield names of a sheet that its formulas take for the book's of the same name."""
    declared = {name.casefold() for name, _ in match.declared.names()}
    for title in dict.fromkeys(pair.address.sheet for pair in match.pairs):
        for name, defined in match.file.workbook[title].defined_names.items():
            if name.casefold() in declared:
                held, expected = str(defined.attr_text), "no name of the sheet's own"
                yield Finding(title, name, "name", held, expected)


def function_findings(match: Match) -> Iterator[Finding]:
    """Yield cells that should hold another formula: with a function that not every program has, or that is volatile."""
    formulas = match.file.contents.formulas
    for pair in match.pairs:
        formula = formulas.get(pair.address) if pair.declared_formula else None
        for name in sorted(formula.functions - ALLOWED) if formula else ():
            kind = "is not volatile" if name in VOLATILE else "every program has"
            at, expected = pair.address, f"a function that {kind}"
            yield Finding(at.sheet, at.a1, "function", name, expected)


def stale_functions(workbook: Workbook) -> Iterator[str]:
    """Yield a note where names that define the functions MOTION.*, copied beside a machine, are not today's."""
    held = {name: defined for name, defined in workbook.defined_names.items() if NAMESPACE in name}
    # in most books there are none: the definitions need not be read
    known = {d.name: meaning(d.stored) for d in definitions() if d.name in held} if held else {}
    texts = ((name, held[name].attr_text or "", stored) for name, stored in known.items())
    if other := sorted(name for name, text, stored in texts if meaning(text) != stored):
        names = listed(other, MOST)
        yield f"names that are not today's definitions: {names}; take them from motion-functions.xlsx"


def setting_findings(workbook: Workbook) -> Iterator[Finding]:
    """Yield the settings of a file that let formulas go stale, round them, or read them by other rules."""
    held, settings = workbook.calculation, list[tuple[str, str, str]]()
    if held and held.calcMode == "manual":
        expected = "automatic: else what is shown is not what was entered"
        settings.append(("", "manual", expected))
    if held and held.iterate:
        expected = "not iterative: else a cell that depends on itself has a value"
        settings.append(("", "iterative", expected))
    if held and held.fullPrecision is False:
        settings.append(("", "with the precision as displayed", "with full precision"))
    for sheet in workbook.worksheets:
        if sheet.sheet_properties.transitionEvaluation or sheet.sheet_properties.transitionEntry:
            settings.append((sheet.title, "by the rules of Lotus 1-2-3", "by those of Excel"))
    for title, setting, expected in settings:
        place, what = (title, "calculation", "setting"), "how the program computes"
        yield Finding(*place, setting, expected, what)


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
    runs: list[list[tuple[str, int]]] = []
    for sheet, row in sorted(inserted):
        if runs and runs[-1][-1] == (sheet, row - 1):
            runs[-1].append((sheet, row))
        else:
            runs.append([(sheet, row)])
    for (sheet, first), *more in runs:
        last = more[-1][1] if more else first
        change = f"rows {first} to {last} were inserted" if more else f"row {first} was inserted"
        tables = table_titles(inserted[sheet, first])
        yield Finding(sheet, f"{first}:{last}", LAYOUT, change, SPARE, tables)


def table_titles(blocks: list[Block]) -> str:
    """Return which tables they are: the heading of the first, and the names of all."""
    block, names = blocks[0], ", ".join(b.name for b in blocks)
    above = [text for text in block.sheet.texts if text.style == "heading" and text.row < block.row]
    heading = max(above, key=lambda text: text.row).text if above else block.title
    return f"{heading}: the table{'s' if len(blocks) > 1 else ''} {names}"


def mark_consequences(match: Match, report: Report, suspects: set[Address]) -> None:
    """Mark the wrong values that follow from rows put into tables: formulas count the rows of their ranges."""
    cells = {pair.address for pair in match.pairs} - suspects if match.file.inserted else ()
    following = {(at.sheet, at.a1) for at in cells}
    for n, finding in enumerate(report.findings):
        if finding.kind in FOLLOWING and (finding.sheet, finding.cell) in following:
            report.findings[n] = replace(finding, kind=FOLLOWS)


def refuse_cut_cells(file: BookFile, layout: Book) -> None:
    """Raise ReadError where cells of a table were cut: formulas have followed them, and read them elsewhere."""
    match = Match(file, layout)
    empty = {pair.address: pair.cell.block for pair in match.pairs if pair.held is None}
    cut: dict[str, dict[Address, Address]] = {}
    for pair in match.pairs:
        if pair.declared_formula and pair.held != pair.cell.content and is_formula(pair.held):
            for home, there in match.cells_read_elsewhere(pair):
                if home in empty:
                    cut.setdefault(empty[home].name, {})[home] = there
    for name, places in cut.items():
        (first, there), last = min(places.items()), max(places)
        what = f"{first}:{last.a1} of {table_titles([layout.blocks[name]])} was cut"
        why = f"formulas read what stood in {first.a1} at {there}"
        raise ReadError(f"{file.path}: {what}: {why}; undo that, or cut and paste it back")
