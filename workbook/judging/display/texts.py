"""Texts that say what cells are (titles, labels, units): where they stand now, and whether they say the same."""

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.book.declare import FIRST, Block, Sheet, Text
from workbook.judging.display.groups import Differences
from workbook.judging.matching import MOST_BETWEEN, Match
from workbook.judging.report import LAYOUT, Report

HEADINGS = ("heading", "subheading")
ABOVE = (*HEADINGS, "header", "units", "equation")
BESIDE = ("label", "symbol", "unit", "note")
QUIET = ("equation", "note")  # reworded, these are nobody's concern
MOST_ASIDE = 6  # columns that someone may have put between a cell and the texts of its row
TELLING = re.compile(r"[0-9]+|[%‰]|\b(?:OK|FAIL)\b")  # what a translation leaves as it is
GAP = re.compile(r"\s{9}")  # blanks and lines that push a text out of its cell
# turns and cycles a minute in the languages of our users: which of them is meant, the label says
TURNS = re.compile(
    r"(?:(?:u|umdr\.?|r|rev|giri|tr|c|cycles|takte|hübe|cicli|coups)?/mi?n|1/min|min(?:⁻¹|\^?-1)|upm|r\.?p\.?m\.?|cpm"
    r"|cycles per minute|revolutions per minute)"
)


class Label(NamedTuple):
    """A declared text, the block whose cells it describes, and where the file has it."""

    text: Text
    block: Block
    at: Address

    @property
    def what(self) -> str:
        """The text's kind and what it describes, in words."""
        described = self.block.title if self.block.is_table else self.block.quantities[0].label
        return f"{self.text.style} of {described or self.block.name}"


def check_texts(match: Match, report: Report, differences: Differences) -> list[Label]:
    """Enter texts that say something else than declared; return the declared texts with their places."""
    misled = {(f.sheet, f.cell) for f in report.findings if f.kind == "name"}
    for name in match.headless:
        at = match.file.places[name].cell(0, 0)
        report.say(at, LAYOUT, "no headings", "its headings above it: move them together", f"the table {name}")
    labels: list[Label] = []
    titles = {sheet.title.casefold() for sheet in match.declared.sheets}
    for sheet, title in match.sheets:
        if title.casefold() != sheet.title.casefold():
            misleads = title.casefold() in titles
            differences.add(Address(title, 1, 1), "sheet name", sheet.title, title, "the sheet", misleads)
        placed = list(place_texts(match, sheet))
        for label in placed:
            first = match.file.places[label.block.name].cell(0, 0)
            if not first.column or (first.sheet, first.a1) not in misled:  # column 0: the first one is gone
                check_text(match, label, placed, differences)
        check_unlabelled(match, sheet, differences)
        labels += placed
    return labels


def describe_texts(sheet: Sheet) -> Iterator[tuple[Text, Block]]:
    """Yield the texts of a sheet that say what its cells are, each with the block that it describes."""
    ordered = sorted(sheet.blocks, key=lambda block: (block.row, block.column))
    rows = {block.row: block for block in reversed(ordered) if not block.is_table}
    tables = [block for block in ordered if block.is_table]
    for text in (text for text in sheet.texts if text.text):
        block = None
        if text.style in (*HEADINGS, "title"):
            block = next((b for b in ordered if b.row > text.row and b.column >= text.column), None)
        elif text.style in ABOVE:
            block = next((b for b in tables if 0 < b.row - text.row <= 4 and text.column in b.columns.values()), None)
        elif text.style in BESIDE and text.row in rows and not text.link:
            row = rows[text.row]
            block = row if text.column in range(FIRST, row.column + 3) else None
        if block is not None:
            yield text, block


def place_texts(match: Match, sheet: Sheet) -> Iterator[Label]:
    """Yield where the texts of a sheet stand: all of a line above a table, and of a column beside cells, moved alike.

    They are the nearest in which most of these texts stand, so that a right text elsewhere excuses no wrong one.
    """
    lines = defaultdict[tuple[str, int], list[tuple[Text, Block]]](list)
    for text, block in describe_texts(sheet):
        if block.name in match.file.places.keys() - match.headless:
            is_above = text.style in (*ABOVE, "title")
            offset = text.row - block.row if is_above else text.column - block.column
            lines[block.name if is_above else "", offset].append((text, block))
    for (above, offset), line in lines.items():
        furthest = MOST_BETWEEN + 4 if above else MOST_ASIDE
        nearest = [text_address(match, *entry, offset) for entry in line]
        for more in range(furthest) if offset > 0 else range(0, -furthest, -1):
            places = [text_address(match, *entry, offset + more) for entry in line]
            held = [
                at.row > 0 < at.column and same_words(match.file.value(at), text.text)
                for at, (text, _) in zip(places, line, strict=True)
            ]
            if 2 * sum(held) > len(line):
                nearest = places
                break
        for at, (text, block) in zip(nearest, line, strict=True):
            if at.column > 0 and at.row > 0:
                yield Label(text, block, at)


def text_address(match: Match, text: Text, block: Block, offset: int) -> Address:
    """Return the cell so many rows above, or columns beside, the cells that a text describes."""
    place = match.file.places[block.name]
    if text.style not in (*ABOVE, "title"):
        return place.cell(0, offset)
    column = place.cell(0, text.column - block.column).column
    line = [Address(place.sheet, place.row + offset, number) for number in range(place.column, 0, -1)]
    moved = next((at for at in line if at.row > 0 and same_words(match.file.value(at), text.text)), None)
    is_left = text.style in (*HEADINGS, "title")
    return moved if moved and is_left else Address(place.sheet, place.row + offset, column)


def check_text(match: Match, label: Label, labels: Iterable[Label], differences: Differences) -> None:
    """Enter what is wrong with a text: another's text, figure or unit in its place misleads."""
    expected, held = label.text.text, match.file.value(label.at)
    text = "" if held is None else str(held)
    if same_words(held, expected):
        if GAP.search(text):
            differences.add(label.at, "text", expected, text, label.what, misleads=False)
        return
    others = {other.text.text for other in labels if other.text.style == label.text.style} - {expected}
    if label.text.style in ("unit", "units"):
        (symbol, unit), (own_symbol, own_unit) = split_unit(text), split_unit(expected)
        parts = [split_unit(other) for other in others]
        misleads = is_other_unit(unit, own_unit) or (symbol != own_symbol and symbol in {name for name, _ in parts})
        if not misleads and symbol == own_symbol and is_same_unit(unit, own_unit):
            return
    else:
        more = set(TELLING.findall(text)) - set(TELLING.findall(expected))
        misleads = bool(more) or any(same_words(held, other) for other in others)
    if misleads or label.text.style not in QUIET:
        differences.add(label.at, "text", expected, text or "nothing", label.what, misleads)


def check_unlabelled(match: Match, sheet: Sheet, differences: Differences) -> None:
    """Enter a unit beside a cell whose quantity has none."""
    named = {(text.row, text.column) for text in sheet.texts}
    for block, place in match.placed(sheet):
        quantity = block.quantities[0]
        if block.is_table or quantity.role in ("check", "sentence") or (block.row, block.column + 1) in named:
            continue
        at = place.cell(0, 1)
        text = match.file.value(at)
        if isinstance(text, str) and at not in match.numbers and text.strip() and is_unit(text):
            differences.add(at, "text", "no unit", text, f"unit of {quantity.label}", misleads=True)


def same_words(held: object, expected: str) -> bool:
    """Whether a cell holds a text, however its lines and spaces are broken."""
    return isinstance(held, str) and held.split() == expected.split()


def split_unit(text: str) -> tuple[str, str]:
    """Return symbol and unit of ``s [mm]``; a text without brackets is a unit."""
    symbol, bracket, unit = text.partition("[")
    return (" ".join(symbol.split()), unit.strip().removesuffix("]").strip()) if bracket else ("", text.strip())


def is_same_unit(held: str, declared: str) -> bool:
    """Whether a unit is the declared one, however it is spelled."""
    if held.split() == declared.split():
        return True
    sizes = unit_size(held), unit_size(declared)
    return None not in sizes and sizes[0] == sizes[1]


def is_other_unit(held: str, declared: str) -> bool:
    """Whether a text is a unit, and another one than the declared: of other dimension or other size."""
    return bool(held.strip()) and is_unit(held) and not is_same_unit(held, declared)


def is_unit(text: str) -> bool:
    """Whether a text reads as a unit, or as a figure with one."""
    return unit_size(text) is not None or bool(TELLING.search(text))


@cache
def unit_size(text: str) -> tuple[Any, float] | None:
    """Return dimension and size of a unit in SI; None for words that are no unit."""
    from workbook.dimensions.units import size_of  # here, since pint takes a third of a second to load

    return size_of("rpm" if TURNS.fullmatch(text.strip().lower()) else text)
