"""The limits of entries in cells: each entry has a message, empty or a note where it is fine, each block a check.

Programs enforce validations on what is typed alone: what is pasted, or written by a script, passes them by.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from workbook.book.quantity import WANTED, Block, Quantity, calc, check
from workbook.book.sentence import first_text, quoted

MESSAGES, MESSAGE, USED = "_messages", "message", "used"
"""suffix of the block of a table's messages; its columns of the first message in a row, of rows in use"""
EXPECTED = "_expected"  # behind the name of a single cell: the message beside it
EMPTY = "no row is filled"
FULL, IS_FULL = "_full", "the table is full"
"""the suffix of the cell under a table's last row, and its text where every row has entries"""
FAULT = "*; expected*"  # what a message beside a single cell looks like, and no note does
SPARE = 1  # columns over which the texts of a table's last column may run


class Limit(NamedTuple):
    """The limits of an entry: a number within bounds, such as ``(">", 0.0)``, or without these a word."""

    required: bool
    bounds: tuple[tuple[str, float], ...]
    expected: str
    number: bool = True

    def holds(self, cell: str) -> str:
        """Return the condition that a cell obeys; texts compare above numbers."""
        if not self.number:
            return f'{cell}<>""'
        parts = [f"{cell}{sign}{bound:.12g}" for sign, bound in self.bounds]
        if self.required or all(sign.startswith(">") for sign, _ in self.bounds):
            parts.insert(0, f"ISNUMBER({cell})")
        within = f"AND({','.join(parts)})" if len(parts) > 1 else parts[0]
        return within if self.required else f'OR({cell}="",{within})'


class RowRule(NamedTuple):
    """A rule between the entries of a row; it holds in a row that has no entry at all."""

    rule: str
    condition: str  # in cells
    column: str  # the entry that is shown, if any
    words: str


Entries = Sequence[tuple[Quantity, Limit]]


def column_of(name: str) -> str:
    """Return the name of the column of messages on an entry, or on a rule."""
    return f"{name}_says"


def entered_text(cell: str) -> str:
    """Return the formula of an entry as messages show it, ``empty`` where there is none."""
    return f'IF({cell}="","empty",{cell})'


def limit_message(label: str, cell: str, limit: Limit) -> str:
    """Return the formula of the message on an entry that is beyond its limit."""
    value = entered_text(cell) if limit.required else cell
    return f"{quoted(f'{label}: ')}&{value}&{quoted(f'; expected {limit.expected}')}"


def message_beside(q: Quantity, limit: Limit) -> Quantity:
    """Return the message beside a single cell: its note, or what is expected."""
    cell = f"[{q.name}.{q.name}]"
    formula = f"=IF({limit.holds(cell)},{quoted(q.source)},{limit_message(q.label, cell, limit)})"
    label = f"{q.label}{WANTED}"
    return Quantity(f"{q.name}{EXPECTED}", label, "", "", "sentence", formula, q.source, align="left")


def cells_check(name: str, label: str, entries: Entries) -> Quantity:
    """Return the check that counts the messages beside single cells."""
    first, last = (f"[{q.name}{EXPECTED}.{q.name}{EXPECTED}]" for q in (entries[0][0], entries[-1][0]))
    messages = f"{first}:{last}"
    if len(entries) > 1:
        condition = f"COUNTIF({messages},{quoted(FAULT)})=0"
        says = f"INDEX({messages},MATCH({quoted(FAULT)},{messages},0))"
    else:  # no program looks up in a single cell alike
        q, limit = entries[0]
        condition, says = limit.holds(f"[{q.name}.{q.name}]"), first
    return check(name, label, condition, True, says=says)


def all_empty(inputs: Sequence[Quantity]) -> str:
    """Return the condition that a row of a table has no entry at all; nothing of a table without inputs."""
    empty = ",".join(f'[{q.name}]=""' for q in inputs)
    return f"AND({empty})" if empty else ""


def guard_rows(
    block: Block, entries: Entries, rules: Sequence[RowRule], label: str, filled: bool
) -> tuple[list[Quantity], Quantity]:
    """Return the messages of a table of inputs, a column for each entry and rule, and the check that counts them.

    ``filled``: a row must be.
    """
    table, inputs = f"{block.name}{MESSAGES}", [q for q in block.quantities if q.role == "input"]
    messages = [*message_columns(entries, rules)]
    first, last = messages[0].name, messages[-1].name
    among = f"[{first}:{last}]"
    of_row = f"[{first}]" if first == last else f'IF(COUNTIF({among},"?*")=0,"",INDEX({among},{first_text(among)}))'
    used = calc(
        USED,
        "row in use",
        "",
        "",
        f"=IF({all_empty(inputs)},0,1)",
        in_use(block.size, inputs),
        format="0",
        source="1 where anything is entered",
    )
    required = any(limit.required for _, limit in entries)
    of_all = message_column(MESSAGE, "what is expected", f"={of_row}")
    columns = [*([used] if required else []), *messages, of_all]
    message, row = f"[{table}.{MESSAGE}]", '"row 1, "&'
    condition, says = f'[{table}.{MESSAGE}.1]=""', f"[{table}.{MESSAGE}.1]"
    if block.size > 1:
        row_text = first_text(message)
        condition, says = f'COUNTIF({message},"?*")=0', f"INDEX({message},{row_text})"
        row = f'"row "&{row_text}&", "&'
    says = f"{row}{says}"
    if filled and required:
        says = f"IF({condition},{quoted(EMPTY)},{says})"
        condition = f"AND(SUM([{table}.{USED}])>0,{condition})"
    return columns, check(f"{block.name}_entries", label, condition, True, says=says)


def room_cell(table: str, rows: Sequence[int]) -> Quantity:
    """Return the cell under the last row of a table, which says that it is full; by whether each row is in use."""
    used = f"[{table}{MESSAGES}.{USED}]"
    formula = f'=IF(SUM({used})=COUNT({used}),{quoted(IS_FULL)},"")'
    return message_column(f"{table}{FULL}", "Room in the table", formula, IS_FULL if all(rows) else "")


def in_use(rows: int, inputs: Sequence[Quantity]) -> list[int]:
    """Return for each row of a table whether anything is entered."""
    held = [q.value if isinstance(q.value, list | tuple) else [q.value for _ in range(rows)] for q in inputs]
    return [int(any(value not in (None, "") for value in row)) for row in zip(*held, strict=True)]


def message_columns(entries: Entries, rules: Sequence[RowRule]) -> Iterator[Quantity]:
    """Yield the column of messages on each entry, and on each rule."""
    for q, limit in entries:
        cell = f"[{q.name}]"
        holds = f"OR([{USED}]=0,{limit.holds(cell)})" if limit.required else limit.holds(cell)
        yield message_column(column_of(q.name), q.label, f'=IF({holds},"",{limit_message(q.label, cell, limit)})')
    for rule in rules:
        says = f"{quoted(f'{rule.words}: ')}&{entered_text(f'[{rule.column}]')}" if rule.column else quoted(rule.words)
        yield message_column(column_of(rule.rule), rule.rule, f'=IF({rule.condition},"",{says})')


def message_column(name: str, label: str, formula: str, value: str = "") -> Quantity:
    """Return a column of messages; by default they are empty, as the engine only has sound entries."""
    return Quantity(name, label, "", "", "sentence", formula, value, align="left")
