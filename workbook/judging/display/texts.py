"""Texts that say what cells are (titles, labels, units): where they stand now, and whether they say the same."""

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator
from typing import Literal, NamedTuple

from workbook.book.address import Address
from workbook.book.declare import Block, Sheet, Text
from workbook.judging.display.differences import Differences, Subject, is_unit
from workbook.judging.matching import Match
from workbook.judging.report import Report
from workbook.reading.table_fit import MOST_BETWEEN

HEADINGS = ("heading", "subheading", "title")
ABOVE = (*HEADINGS, "header", "units", "equation", "figure name", "figure unit")
LABELS = ("label", "aside")
BESIDE, BEHIND = (*LABELS, "symbol", "unit", "note"), ("unit", "note")
QUIET = ("equation", "note")  # remarks: reworded, they mislead nobody
MOST_HEADS = 4  # rows of a table's headings, above it
MOST_ASIDE = 6  # columns that someone may have put between a cell and the texts of its row


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

    @property
    def kind(self) -> Literal["", "unit", "entry"]:
        """The kind of text as it is judged: a unit, the label of an entry, or another."""
        is_entry = self.text.style in LABELS and self.block.quantities[0].role == "input"
        return "unit" if self.text.style == "unit" else "entry" if is_entry else ""


def compare_texts(report: Report, differences: Differences) -> list[Label]:
    """Enter texts that say something else than declared; return the declared texts with their places."""
    misled = {(f.sheet, f.cell) for f in report.findings if f.kind == "name"}
    labels, match = list[Label](), differences.match
    for sheet, _ in match.sheets:
        placed = list(place_texts(match, sheet))
        words = defaultdict[str, set[str]](set)
        for text in sheet.texts:
            words[text.style].add(text.text)
        for label in placed:
            first = match.file.places[label.block.name].cell(0, 0)
            if (first.sheet, first.a1) not in misled:
                subject = Subject(label.what, label.kind, words[label.text.style])
                held = {"text": str(match.file.value(label.at) or "")}
                differences.compare(label.at, subject, {"text": label.text.text}, held)
        compare_unlabelled(sheet, differences)
        labels += placed
    return labels


def describe_texts(sheet: Sheet) -> Iterator[tuple[Text, Block]]:
    """Yield the texts of a sheet that say what its cells are, each with the block that it describes."""
    ordered = sorted(sheet.blocks, key=lambda block: (block.row, block.column))
    rows = [block.row for block in ordered]
    for text in (text for text in sheet.texts if text.text):
        end = len(rows) if text.style in HEADINGS else bisect_right(rows, text.row + MOST_HEADS)
        near = ordered[bisect_left(rows, text.row) : end]
        if about := [block for block in near if is_about(text, block)]:
            yield text, about[-1 if text.style in BEHIND else 0]


def is_about(text: Text, block: Block) -> bool:
    """Whether a text may describe a block: of several the first, or the last before a unit or note."""
    if text.style in HEADINGS:
        return block.row > text.row and block.column >= text.column
    if text.style == "figure unit":
        return block.is_large and (block.row, block.column) == (text.row - 1, text.column)
    has_heads = block.is_table or block.is_large
    if text.style in ABOVE:
        is_near = 0 < block.row - text.row <= MOST_HEADS
        return has_heads and is_near and text.column in block.columns.values()
    if text.style not in BESIDE or text.link or has_heads or block.row != text.row:
        return False
    return block.column < text.column if text.style in BEHIND else block.column > text.column


def place_texts(match: Match, sheet: Sheet) -> Iterator[Label]:
    """Yield where the texts of a sheet stand: all of a line above a table, and of a column beside cells, moved alike.

    They are the nearest in which most of these texts stand, so that a right text elsewhere excuses no wrong text.
    """
    lines = defaultdict[tuple[str, int, int], list[tuple[Text, Block]]](list)
    for text, block in describe_texts(sheet):
        if block.name in match.file.places:
            is_above = text.style in ABOVE
            offset = text.row - block.row if is_above else text.column - block.column
            key = (block.name, 0, offset) if is_above else ("", text.column, offset)
            lines[key].append((text, block))
    for (above, _, offset), line in lines.items():
        furthest, away = MOST_BETWEEN + MOST_HEADS if above else MOST_ASIDE, 1 if offset > 0 else -1
        for tried in (*range(offset, offset + away * furthest, away), offset):
            places = [Label(*entry, text_address(match, *entry, tried)) for entry in line]
            if 2 * sum(has_words(match, label.at, label.text) for label in places) > len(line):
                break
        yield from (label for label in places if label.at.column > 0 < label.at.row)


def text_address(match: Match, text: Text, block: Block, offset: int) -> Address:
    """Return the cell so many rows above, or columns beside, the cells that a text describes."""
    place = match.file.places[block.name]
    if text.style not in ABOVE:
        return place.cell(0, offset)
    declared = place.cell(0, text.column - block.column)._replace(row=place.row + offset)
    columns = range(place.column, 0, -1) if text.style in HEADINGS else ()
    line = (declared._replace(column=column) for column in columns)
    return next((at for at in line if has_words(match, at, text)), declared)


def has_words(match: Match, at: Address, text: Text) -> bool:
    """Whether a cell holds a text, however its lines and spaces are broken."""
    held = match.file.value(at) if at.row > 0 < at.column else None
    return isinstance(held, str) and held.split() == text.text.split()


def compare_unlabelled(sheet: Sheet, differences: Differences) -> None:
    """Enter a unit beside a cell whose quantity has none."""
    named, match = {(text.row, text.column) for text in sheet.texts}, differences.match
    for block, place in match.placed(sheet):
        quantity, at = block.quantities[0], place.cell(0, 1)
        has_unit = block.is_table or (block.row, block.column + 1) in named or at in match.numbers
        if has_unit or quantity.role in ("check", "sentence"):
            continue
        if isinstance(text := match.file.value(at), str) and is_unit(text):
            differences.add(at, Subject(f"unit of {quantity.label}", "unit"), "text", "", text)
