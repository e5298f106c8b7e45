"""Entries put in order before a book is judged: blanks around names, names that look-ups misread, rows left empty.

The file stays as it is: what is judged is a copy, and each change of it is told with what to do.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Block, Book
from workbook.entries import rules
from workbook.entries.texts import LOOKED_UP, NO_NAME, PATTERN
from workbook.judging.comparing import Right, differs
from workbook.judging.matching import Match
from workbook.judging.moved import put_back
from workbook.judging.report import LAYOUT, NOTICE, Finding, Report
from workbook.reading.contents import Cells
from workbook.reading.files import BookFile, is_formula

EMPTY = ", but below it"
"""how the line on a row that was left empty ends"""


def in_order(file: BookFile, layout: Book, model: type[BaseModel]) -> list[Finding]:
    """Put back what was cut from tables, and put entries in order; return findings, and notices, on what was not.

    ``model`` is that of the machine's entries.
    """
    said = [*put_back(file, layout), *named(file, layout, model), *moved_up(file, layout)]
    file.mended = file.mended or bool(said)
    file.__dict__.pop("contents", None)
    return said


def named(file: BookFile, layout: Book, model: type[BaseModel]) -> Iterator[Finding]:
    """Trim names that formulas look up, and exchange those that look-ups take for a pattern or a value."""
    cells = {at: block for block in layout.blocks.values() for at in looked_up(file, block, model)}
    texts = {at: as_text(file.value(at)) for at in cells}
    for text in dict.fromkeys(texts.values()):
        name = usable(text, set(texts.values()))
        if name == text:
            continue
        trimmed = name == text.strip()
        kind = NOTICE if trimmed and name not in texts.values() else "entry"
        expected = f"{name!r}, without blanks around it" if trimmed else f"a name that look-ups find, such as {name!r}"
        for at in (at for at, one in texts.items() if one == text):
            set_value(file, at, name)
            yield Finding(at.sheet, at.a1, kind, repr(text), expected, cells[at].title or cells[at].quantities[0].label)
        file.saved |= {at: v.replace(text, name) for at, v in file.saved.items() if isinstance(v, str)}


def looked_up(file: BookFile, block: Block, model: type[BaseModel]) -> Iterator[Address]:
    """Yield the cells of a block in which a name is entered that formulas look up."""
    place = file.places.get(block.name)
    if place is None:
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


def usable(text: str, others: set[str]) -> str:
    """Return a name as look-ups find it again: itself where they do, trimmed, or one that is none of the others."""
    name = "".join("_" if sign in PATTERN else sign for sign in text.strip())
    changed = name != text.strip()
    while NO_NAME.fullmatch(name) or (changed and name in others):
        name, changed = f"{name}_", True
    return name


def moved_up(file: BookFile, layout: Book) -> Iterator[Finding]:
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


def unlike(before: Cells, match: Match, ordered: Cells, report: Report) -> None:
    """Enter a finding in place of a notice on an empty row where results are others than with the rows moved up.

    ``before`` are the values of the cells of the file as it is, ``ordered`` those with its entries in order.
    """
    right = Right(match, match.declared)
    single = (p.address for p in match.pairs if p.declared_formula and not p.cell.block.is_table)
    wrong = [a for a in single if differs(right, a, before.get(a)) and not differs(right, a, ordered.get(a))]
    for one in [one for one in report.notices if is_empty_row(one)] if wrong else ():
        report.notices.remove(one)
        expected = f"{one.expected}: by it {len(wrong)} results are wrong, {wrong[0]} the first"
        report.findings.append(replace(one, kind=LAYOUT, expected=expected))


def is_empty_row(found: Finding) -> bool:
    """Whether a finding tells of a row that was left empty before others."""
    return str(found.computed).endswith(EMPTY)
