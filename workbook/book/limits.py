"""The limits of entries in cells: each block of inputs has a check that says which entry is beyond them, and how far.

Programs enforce validations on what is typed alone: what is pasted, or written by a script, passes them by.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from workbook.book.quantity import Quantity, calc, check
from workbook.book.sentence import Sentence, figure, figure_of, quoted

COLUMN = "entries"
"""of a table of inputs: the number of the first entry of a row that is beyond its limits, or 0"""


EMPTY = "no row is filled"


class Limit(NamedTuple):
    """What an entry must be: a number within bounds, such as ``(">", 0.0)``, or without these a word."""

    required: bool
    bounds: tuple[tuple[str, float], ...]
    expected: str

    def holds(self, cell: str) -> str:
        """Return the condition that a cell obeys."""
        if not self.bounds:
            return f'{cell}<>""'
        within = ",".join([f"ISNUMBER({cell})", *(f"{cell}{sign}{bound!r}" for sign, bound in self.bounds)])
        return f"AND({within})" if self.required else f'OR({cell}="",AND({within}))'


class RowRule(NamedTuple):
    """A rule between the entries of a row: its name, its condition in cells, the entry that is shown, and words."""

    rule: str
    condition: str
    column: str
    words: str


class Guard(NamedTuple):
    """The check of a block of inputs: what it watches, in the order in which it tells."""

    check: str
    entries: tuple[tuple[Quantity, Limit], ...]
    rules: tuple[RowRule, ...] = ()
    table: str = ""
    rows: int = 1

    def says(self, place: int, row: int, value: Any) -> Sentence:
        """Return the sentence on an entry, by its place among those that are watched, from 0."""
        if place < len(self.entries):
            q, limit = self.entries[place]
            words, expected = q.label, f"; expected {limit.expected}"
        else:
            words, expected = self.rules[place - len(self.entries)].words, ""
        where = f"{words}, row {row + 1}" if self.table else words
        shown = figure(value) if isinstance(value, int | float) else "empty"
        return Sentence(f"{where}: {shown}{expected}")


def of_cells(name: str, label: str, entries: Sequence[tuple[Quantity, Limit]]) -> tuple[Guard, Quantity]:
    """Return the guard of single cells, and its check."""
    guard = Guard(name, tuple(entries))
    says = quoted("")
    for q, limit in reversed(entries):
        said = f"{quoted(f'{q.label}: ')}&{figure_of(q.name)}&{quoted(f'; expected {limit.expected}')}"
        says = f"IF({limit.holds(q.name)},{says},{said})"
    condition = ",".join(limit.holds(q.name) for q, limit in entries)
    return guard, check(name, label, f"AND({condition})", True, says=says)


def all_empty(inputs: Sequence[Quantity]) -> str:
    """Return the condition that a row of a table has no entry at all; nothing of a table without inputs."""
    empty = ",".join(f'[{q.name}]=""' for q in inputs)
    return f"AND({empty})" if empty else ""


def of_rows(
    table: str, rows: int, label: str, inputs: Sequence[Quantity], entries: Sequence[tuple[Quantity, Limit]],
    rules: Sequence[RowRule], filled: bool,
) -> tuple[Guard, Quantity, Quantity]:  # fmt: skip
    """Return the guard of a table of ``inputs``, the column that finds what is beyond, and the check.

    ``filled`` says that one row at least must be.
    """
    guard = Guard(f"{table}_{COLUMN}", tuple(entries), tuple(rules), table, rows)
    conditions = [*(limit.holds(f"[{q.name}]") for q, limit in entries), *(rule.condition for rule in rules)]
    first = "0"
    for number, condition in reversed(list(enumerate(conditions, 1))):
        first = f"IF({condition},{first},{number})"
    column = calc(COLUMN, "beyond its limits", "", "", f"=IF({all_empty(inputs)},0,{first})", 0, format="0;;",
                  source="number of the entry")  # fmt: skip
    told = [(q.label, q.name, f"; expected {limit.expected}") for q, limit in entries]
    told += [(rule.words, rule.column, "") for rule in rules]
    says = quoted("")
    for number, (words, name, expected) in reversed(list(enumerate(told, 1))):
        row = f"MATCH({number},[{table}.{COLUMN}],0)" if rows > 1 else "1"  # no program looks up in a single cell alike
        cell = f"INDEX([{table}.{name}],{row})" if rows > 1 else f"[{table}.{name}.1]"
        said = f"{quoted(f'{words}, row ')}&{row}&{quoted(': ')}&{figure_of(cell)}"
        said += f"&{quoted(expected)}" if expected else ""
        says = f"IF(COUNTIF([{table}.{COLUMN}],{number})>0,{said},{says})"
    condition = f"SUM([{table}.{COLUMN}])=0"
    counted = next((q.name for q, limit in entries if limit.required and limit.bounds), "")
    if filled and counted:
        condition = f"AND(COUNT([{table}.{counted}])>0,{condition})"
        says = f"IF(SUM([{table}.{COLUMN}])=0,{quoted(EMPTY)},{says})"
    return guard, column, check(guard.check, label, condition, True, says=says)
