"""Repair cells and entries in memory before a book is judged; each repair is a finding, and the file stays as it is.

Cells cut from a table are put back: formulas that follow them say where they are now, formulas that were cut are known
by their shape. Of entries, blanks around names go, names that look-ups misread are exchanged, empty rows are filled.
"""

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any, NamedTuple

from openpyxl.utils import get_column_letter, quote_sheetname
from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Block, Book
from workbook.book.formula import REFERENCE, TOKEN, corner, read, unquoted
from workbook.entries import rules
from workbook.fields.texts import LOOKED_UP, NO_NAME, PATTERN
from workbook.judging.comparison import ExpectedValues, differs
from workbook.judging.layout import table_titles
from workbook.judging.matching import Match, Pair
from workbook.judging.report import LAYOUT, NOTICE, Finding, Report
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile, find_places, is_formula
from workbook.reading.rows import tag

EMPTY = ", but below it"  # how the line on a row that was left empty ends


def repair_book(file: BookFile, layout: Book, model: type[BaseModel]) -> list[Finding]:
    """Put back what was cut from tables, and put entries in order; return findings, and notices, on what was not."""
    if said := [*put_back(file, layout), *repair_names(file, layout, model), *close_gaps(file, layout)]:
        file.mended = True
        file.__dict__.pop("contents", None)  # they are of the cells as they were
    return said


def repair_names(file: BookFile, layout: Book, model: type[BaseModel]) -> Iterator[Finding]:
    """Trim names that formulas look up, and exchange those that look-ups take for a pattern or a value."""
    cells = {at: block for block in layout.blocks.values() for at in lookup_cells(file, block, model)}
    texts = {at: as_text(file.value(at)) for at in cells}
    for text in dict.fromkeys(texts.values()):
        if (name := usable_name(text, set(texts.values()))) == text:
            continue
        trimmed = name == text.strip()
        kind = NOTICE if trimmed and name not in texts.values() else "entry"
        expected = f"{name!r}, without blanks around it" if trimmed else f"a name that look-ups find, such as {name!r}"
        for at in (at for at, one in texts.items() if one == text):
            set_value(file, at, name)
            yield Finding(at.sheet, at.a1, kind, repr(text), expected, cells[at].title or cells[at].quantities[0].label)
        file.saved |= {at: v.replace(text, name) for at, v in file.saved.items() if isinstance(v, str)}


def lookup_cells(file: BookFile, block: Block, model: type[BaseModel]) -> Iterator[Address]:
    """Yield the cells of a block in which a name is entered that formulas look up."""
    if (place := file.places.get(block.name)) is None:
        return
    for j, q in enumerate(block.quantities):
        if q.role != "input" or not place.cell(0, j).column:
            continue
        constraints: Sequence[Any] = ()
        with suppress(KeyError, AttributeError, IndexError):  # of a law, by the name of its sheet
            constraints = rules.field_at(model, q.key)[1]
        if LOOKED_UP in constraints:
            yield from (at for at in place.down(j) if as_text(file.value(at)))


def as_text(held: Any) -> str:
    """Return what is entered as a name: a number as its digits; nothing for a formula or an empty cell."""
    if is_formula(held) or isinstance(held, bool) or held is None:
        return ""
    return held if isinstance(held, str) else f"{held:.15g}"


def usable_name(text: str, others: set[str]) -> str:
    """Return a name as look-ups find it again: itself where they do, trimmed, or one that is none of the others."""
    name = "".join("_" if sign in PATTERN else sign for sign in text.strip())
    changed = name != text.strip()
    while NO_NAME.fullmatch(name) or (changed and name in others):
        name, changed = f"{name}_", True
    return name


def close_gaps(file: BookFile, layout: Book) -> Iterator[Finding]:
    """Move entries up over rows of their tables that were left empty."""
    for block in layout.blocks.values():
        place = file.places.get(block.name)
        columns = [j for j, q in enumerate(block.quantities) if q.role == "input" and "*" in q.key]
        if place is None or not columns or not all(place.cell(0, j).column for j in columns):
            continue
        rows = [[file.value(place.cell(i, j)) for j in columns] for i in range(place.rows)]
        used = [i for i, row in enumerate(rows) if any(value is not None for value in row)]
        if used == list(range(len(used))) or any(is_formula(value) for row in rows for value in row):
            continue
        for i in range(place.rows):
            for j, value in zip(columns, rows[used[i]] if i < len(used) else [None] * len(columns), strict=True):
                set_value(file, place.cell(i, j), value)
        file.saved = {at: value for at, value in file.saved.items() if at.sheet != place.sheet}
        empty = next(i for i in range(place.rows) if i not in used)
        at, said = place.cell(empty, columns[0]), f"nothing is entered in row {empty + 1} of the table {block.name}"
        yield Finding(at.sheet, at.a1, NOTICE, f"{said}{EMPTY}", "fill it, or move up what is below", block.title)


def set_value(file: BookFile, at: Address, value: Any) -> None:
    """Enter a value into a cell of the copy that is judged."""
    cell = file.workbook[at.sheet].cell(at.row, at.column)
    cell._value, cell.data_type = value, "s" if isinstance(value, str) else "n"  # type: ignore[union-attr]


def report_wrong_results(before: Cells, match: Match, ordered: Cells, report: Report) -> None:
    """Enter a finding in place of a notice on an empty row where results are others than with the rows moved up."""
    right = ExpectedValues(match, match.declared)
    single = (p.address for p in match.pairs if p.declared_formula and not p.cell.block.is_table)
    wrong = [a for a in single if differs(right, a, before.get(a)) and not differs(right, a, ordered.get(a))]
    for one in [one for one in report.notices if is_empty_row(one)] if wrong else ():
        report.notices.remove(one)
        expected = f"{one.expected}: by it {len(wrong)} results are wrong, {wrong[0]} the first"
        report.findings.append(replace(one, kind=LAYOUT, expected=expected))


def is_empty_row(found: Finding) -> bool:
    """Whether a finding tells of a row that was left empty before others."""
    return str(found.computed).endswith(EMPTY)


# Cells that were cut from a table


class Offset(NamedTuple):
    """How far cells were moved, and to which sheet."""

    sheet: str
    down: int
    right: int

    def end(self, home: Address) -> Address:
        """Return where a cell is now."""
        return Address(self.sheet, home.row + self.down, home.column + self.right)


def put_back(file: BookFile, layout: Book) -> list[Finding]:
    """Put back cells that were cut from tables, but those with more rows than in ``layout``; return a finding a run."""
    match = Match(file, layout)
    small = {name for name, b in layout.blocks.items() if name in file.places and match.size_of(b) > b.size}
    empty = {p.address: p for p in match.pairs if p.held is None and p.cell.block.name not in small}
    gone = defaultdict[tuple[str, Offset], set[Address]](set)
    for home, way in [*moved_by_references(match, empty), *moved_by_shape(match, empty)]:
        gone[empty[home].cell.block.name, way].add(home)
    back: dict[Address, Address] = {}
    findings = []
    for (name, way), homes in gone.items():
        homes |= {a for a, p in empty.items() if p.cell.block.name == name and is_filled(match, way.end(a))}
        if any(is_filled(match, way.end(home)) for home in homes):
            back |= {way.end(home): home for home in homes}
            findings.append(cut_finding([empty[home] for home in homes], way))
    if back:
        move_cells(file, back)
    return findings


def moved_by_references(match: Match, empty: Mapping[Address, Pair]) -> Iterator[tuple[Address, Offset]]:
    """Yield empty cells of a table of which formulas say that they are elsewhere, with how far."""
    changed = (p for p in match.pairs if p.declared_formula and p.held != p.cell.content) if empty else ()
    for pair in (pair for pair in changed if match.leads_out(pair.address)):
        for (name, i, j), there in match.apart(pair):
            place = match.file.places.get(name)
            home = place.cell(i, j) if place is not None and i >= 0 else None
            if home is not None and home in empty and isinstance(there, Address):
                yield home, Offset(there.sheet, there.row - home.row, there.column - home.column)


def moved_by_shape(match: Match, empty: Mapping[Address, Pair]) -> Iterator[tuple[Address, Offset]]:
    """Yield the formulas missing in a table of which most are found elsewhere by their shape, one way from there."""
    missing = {home: pair for home, pair in empty.items() if pair.declared_formula}
    shapes = defaultdict[str, list[Address]](list)
    for address, formula in match.file.contents.formulas.items() if missing else ():
        if address not in match.numbers:
            shapes[formula.shape].append(address)
    counted: dict[str, dict[Offset, list[Address]]] = defaultdict(lambda: defaultdict(list))
    for home, pair in missing.items() if shapes else ():
        declared = read(pair.cell.content, pair.cell.block.sheet.title, match.declared_area)
        for there in shapes.get(declared.shape, ()):
            way = Offset(there.sheet, there.row - home.row, there.column - home.column)
            counted[pair.cell.block.name][way].append(home)
    for name, ways in counted.items():
        way, homes = max(ways.items(), key=lambda one: len(one[1]))
        if 2 * len(homes) > sum(p.cell.block.name == name for p in missing.values()):
            yield from ((home, way) for home in homes)


def is_filled(match: Match, address: Address) -> bool:
    """Whether a cell holds anything, and is none of the declared ones."""
    there = address.sheet in match.file.workbook.sheetnames and address not in match.numbers
    return there and address.row > 0 and address.column > 0 and match.file.value(address) is not None


def cut_finding(pairs: list[Pair], way: Offset) -> Finding:
    """Return the finding on cells of a table that were moved one way."""
    rows, columns = [p.address.row for p in pairs], [p.address.column for p in pairs]
    sheet, what = pairs[0].address.sheet, table_titles([pairs[0].cell.block])
    first, last = Address(sheet, min(rows), min(columns)), Address(sheet, max(rows), max(columns))
    found = f"cut, and pasted to {way.end(first)}:{way.end(last).a1}"
    expected = "all cells of the table in their places: cut and paste them back"
    return Finding(sheet, f"{first.a1}:{last.a1}", LAYOUT, found, expected, what)


def move_cells(file: BookFile, back: Mapping[Address, Address]) -> None:
    """Move cells of a file, and let all formulas and names follow."""
    pages = {page.title: page._cells for page in file.workbook.worksheets}
    for now, home in back.items():
        if (cell := pages[now.sheet].pop((now.row, now.column), None)) is None:
            continue
        cell.parent, cell.row, cell.column = file.workbook[home.sheet], home.row, home.column
        pages[home.sheet][home.row, home.column] = cell
        if now in file.saved:
            file.saved[home] = file.saved.pop(now)
    for title, cells in pages.items():
        for cell in cells.values():
            if cell.data_type == "f" and isinstance(cell.value, str):
                cell.value = f"={redirect_formula(cell.value[1:], title, back)}"
    for title, drawings in file.inspected.drawings.items() if file.inspected else ():
        charts = (one.chart for one in drawings if one.chart is not None)
        for source in (one for chart in charts for one in chart.iter() if tag(one) == "f" and one.text):
            source.text = redirect_formula(source.text or "", title, back)
    moved = set()
    for name, one in file.workbook.defined_names.items():
        if (text := redirect_formula(one.attr_text or "", "", back)) != one.attr_text:
            one.attr_text = text
            moved.add(name)
    file.places |= {name: place for name, place in find_places(file.workbook).items() if name in moved}
    file.mended = True
    file.__dict__.pop("contents", None)


def redirect_formula(text: str, sheet: str, back: Mapping[Address, Address]) -> str:
    """Return a formula of a sheet with its references to cells of ``back`` led to where these go."""
    return TOKEN.sub(lambda one: redirect(one[0], sheet, back) if one.lastgroup == "reference" else one[0], text)


def redirect(word: str, sheet: str, back: Mapping[Address, Address]) -> str:
    """Return a reference led to where its cells go; as it is where not both of its corners are among them."""
    if (parts := REFERENCE.fullmatch(word)) is None:
        return word
    before, first, _, second = parts.groups()
    title = unquoted(before[:-1]) if before else sheet
    corners = [Address(title, *corner(end)) for end in (first, second) if end]
    if len(ends := [back[one] for one in corners if one in back]) < len(corners):
        return word
    there = ends[0].sheet
    prefix = "" if there == sheet and not before else before if there == title else f"{quote_sheetname(there)}!"
    pairs = [(*re.fullmatch(r"(\$?)[A-Za-z]+(\$?)[0-9]+", old).groups(), new)  # type: ignore[union-attr]
             for old, new in zip((first, second), ends, strict=False)]  # fmt: skip
    return prefix + ":".join(f"{one}{get_column_letter(at.column)}{two}{at.row}" for one, two, at in pairs)
