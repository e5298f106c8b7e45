"""Put entries in order in memory before a book is judged; each repair is a finding, and the file stays as it is.

Blanks around names go, names that look-ups misread are exchanged. A book from whose tables cells were cut is refused:
only who cut them knows what belongs where.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from typing import Any

from pydantic import BaseModel

from workbook.book.address import Address
from workbook.book.declare import Block, Book
from workbook.entries import rules
from workbook.errors import ReadError
from workbook.fields.texts import LOOKED_UP, NO_NAME, PATTERN
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, Finding
from workbook.judging.structure import table_titles
from workbook.reading.files import BookFile, is_formula


def repair_book(file: BookFile, layout: Book, model: type[BaseModel]) -> list[Finding]:
    """Put entries in order; return findings, and notices, on what was not. Raises ReadError for cells that were cut."""
    refuse_cut_cells(file, layout)
    if notices := [*repair_names(file, layout, model)]:
        file.mended = True
        file.__dict__.pop("contents", None)  # they are of the cells as they were
    return notices


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
        for at in (at for at, held in texts.items() if held == text):
            cell: Any = file.workbook[at.sheet].cell(at.row, at.column)  # of the copy that is judged
            cell._value, cell.data_type = name, "s"
            what = cells[at].title or cells[at].quantities[0].label
            yield Finding(at.sheet, at.a1, kind, repr(text), expected, what)
        file.saved |= {at: v.replace(text, name) for at, v in file.saved.items() if isinstance(v, str)}


def lookup_cells(file: BookFile, block: Block, model: type[BaseModel]) -> Iterator[Address]:
    """Yield the cells of a block in which a name is entered that formulas look up."""
    for j, q in enumerate(block.quantities if block.name not in file.torn else ()):
        if q.role != "input":
            continue
        constraints: Sequence[Any] = ()
        with suppress(KeyError, AttributeError, IndexError):  # of a law, by the name of its sheet
            constraints = rules.field_at(model, q.key)[1]
        if LOOKED_UP in constraints:
            yield from (at for at in file.places[block.name].down(j) if as_text(file.value(at)))


def as_text(held: Any) -> str:
    """Return the text that is entered as a name: a number as its digits; nothing for a formula or an empty cell."""
    if is_formula(held) or isinstance(held, bool) or held is None:
        return ""
    return held if isinstance(held, str) else f"{held:.15g}"


def usable_name(text: str, others: set[str]) -> str:
    """Return a name as look-ups find it again: itself where they do, trimmed, or a name that is none of the others."""
    name = "".join("_" if sign in PATTERN else sign for sign in text.strip())
    changed = name != text.strip()
    while NO_NAME.fullmatch(name) or (changed and name in others):
        name, changed = f"{name}_", True
    return name


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
