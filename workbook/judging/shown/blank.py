"""The rules by which rows that are not used show nothing: known wherever rows, columns and sheets have moved to."""

from __future__ import annotations

import re
from collections.abc import Iterator

from workbook.book.address import Address
from workbook.book.declare import Block
from workbook.book.formula import REFERENCE, TOKEN
from workbook.judging.matching import Match
from workbook.judging.report import NOTICE, Report
from workbook.judging.shown.conditional import Placed, Rules, code_of
from workbook.judging.shown.formats import sections

CELL = re.compile(r"(\$?[A-Za-z]{1,3})(\$?)([0-9]+)")


class Blanks:
    """The declared rules of a book as its file has them; each may hide its table's cells, and no others.

    In a book that is ``torn``, the rules went with the cells that were cut, or lost the row for which they are written:
    their conditions are compared when that is mended.
    """

    def __init__(self, match: Match, rules: dict[str, Rules], torn: bool = False) -> None:
        self._match, self._torn = match, torn
        self._declared: dict[str, list[Placed]] = {}
        self._ruled: dict[str, set[str]] = {}
        self.known: set[int] = set()
        """the rules that are declared ones, by their identity"""
        for block in match.declared.blocks.values():
            place = match.file.places.get(block.name)
            self._ruled[block.name] = {q.name for q in block.blanked}
            if block.blanked and place is not None and place.sheet in rules:
                found = list(self._found(block, rules))
                self._declared[block.name] = found
                self.known |= {id(one.rule) for one in found}

    def _found(self, block: Block, rules: dict[str, Rules]) -> Iterator[Placed]:
        """Yield the rules of the file that hide cells of a table where the declared condition holds."""
        place = self._match.file.places[block.name]
        left, right = place.cell(0, 0).column, place.cell(0, place.columns - 1).column
        for one, code in rules[place.sheet].formats:
            if not hides(code) or one.rule.type != "expression" or not one.rule.formula:
                continue
            within = (one.covers(place.row, column) for column in range(left, right + 1))
            if any(within) and self._match.same_formula(
                block.unused(block.row), block, moved(str(one.rule.formula[0]), place.row - one.top), place.sheet
            ):
                yield one

    def allow(self, block: Block, quantity: str, at: Address, code: str) -> bool:
        """Whether a number format that a rule gives to a cell of a table is that of the table's declared rule."""
        ruled = quantity in self._ruled[block.name]
        if self._torn:
            return ruled and hides(code)
        return ruled and any(one.covers(at.row, at.column) and code_of(one.rule) == code
                             for one in self._declared.get(block.name, ()))  # fmt: skip

    def gone(self, report: Report) -> None:
        """Enter as a notice each table whose declared rule is gone, or is another one now."""
        for name, found in self._declared.items():
            if not found and not self._torn:
                block = self._match.declared.blocks[name]
                at = self._match.file.places[name].cell(0, 0)
                report.say(
                    at, NOTICE, "no such rule", "a rule that leaves unused rows blank", f"the table {block.title}"
                )


def hides(code: str) -> bool:
    """Whether a number format shows nothing of anything."""
    parts = sections(code)
    return len(parts) == 4 and not any(part.shows_number or part.literal.strip() for part in parts)


def moved(formula: str, down: int) -> str:
    """Return the formula of a rule as it is so many rows further down."""

    def shifted(cell: re.Match[str]) -> str:
        column, fixed, row = cell.groups()
        return cell[0] if fixed else f"{column}{int(row) + down}"

    def replaced(token: re.Match[str]) -> str:
        word = token[0]
        if token.lastgroup != "reference" or not REFERENCE.fullmatch(word):
            return word
        sheet, mark, cells = word.rpartition("!")
        return f"{sheet}{mark}{CELL.sub(shifted, cells)}"

    return "=" + TOKEN.sub(replaced, formula.removeprefix("="))
