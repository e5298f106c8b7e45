"""What a reader sees of a file: runs of cells that are judged alike, and what is told of all of a kind at once."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from workbook.book.address import Address
from workbook.judging.matching import Match, Pair
from workbook.judging.report import NOTICE, Report
from workbook.judging.shown.formats import Judged
from workbook.judging.shown.words import Found


class Seen(NamedTuple):
    """Cells of one column, one below the other: the column of a block, or a text that says what a cell is."""

    at: Address
    last: int
    pairs: list[Pair]
    what: str
    counts: bool
    """whether it is a verdict, a figure, its unit or its label: what is read otherwise there is a finding"""
    folded: bool
    """whether a fresh build has them in a hidden column"""

    @property
    def verdict(self) -> bool:
        """Whether the cells say OK or FAIL."""
        return bool(self.pairs) and is_verdict(self.pairs[0])

    @property
    def text(self) -> bool:
        """Whether the cells show texts."""
        return not self.pairs or any(isinstance(value_of(pair), str) for pair in self.pairs)


def seen(match: Match, found: list[Found]) -> Iterator[Seen]:
    """Yield all cells of a file that are declared, with the texts that say what they are."""
    for pairs in match.by_column():
        cell = pairs[0].cell
        folded = 0 < cell.block.sheet.folded <= cell.column
        what = f"{cell.quantity.label} ({cell.block.name})" if cell.block.is_table else cell.quantity.label
        yield Seen(pairs[0].address, pairs[-1].address.row, pairs, what, True, folded)
    for at, word in found:
        folded = 0 < word.block.sheet.folded <= word.text.column
        yield Seen(at, at.row, [], word.what, word.counts, folded)


def is_verdict(pair: Pair) -> bool:
    """Whether a cell says OK or FAIL."""
    cell = pair.cell
    return cell.quantity.role == "check" or (cell.block.name, cell.quantity.name) == ("checks", "verdict")


def is_overall(match: Match, pair: Pair) -> bool:
    """Whether a verdict is that of the whole book."""
    name = pair.cell.block.name
    return name == "overall" or name in {f"status{n}" for n in range(1, len(match.declared.sheets) + 1)}


def value_of(pair: Pair) -> Any:
    """Return what a cell should show."""
    return pair.cell.expected if pair.declared_formula else pair.held


class Told:
    """What is told of the cells of a file: of many that are shown alike, at the first of them."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, str, str, str, str], tuple[Address, str, int]] = {}

    def add(
        self, at: Address, judged: Judged, expected: str, what: str, counts: bool = True, cells: int = 1,
        group: str | None = None,
    ) -> None:  # fmt: skip
        """Enter what is told of some cells, the first of them ``at``; once for all of a ``group``, or of ``what``."""
        kind, said = judged
        if kind:
            key = at.sheet, kind if counts else NOTICE, said, expected, what if group is None else group
            first, name, count = self._told.get(key, (at, what, 0))
            self._told[key] = first, name, count + cells

    def enter(self, report: Report) -> None:
        """Enter all into a report."""
        for (_, kind, said, expected, _), (at, what, count) in self._told.items():
            more = f", and {count - 1:,} more cells" if count > 1 else ""
            report.say(at, kind, said, expected, what + more)
