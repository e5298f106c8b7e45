"""The text of a description, changed entry by entry; its comments stay."""

import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import Array, InlineTable

from workbook.described.keys import toml
from workbook.errors import InputError

NOTHING = object()  # stands where a description has no entry
COMMENTED = re.compile(r"""((?:[^"'#]|"[^"]*"|'[^']*')*?)( +)(#.*)""")
"""a line of entries, the blanks before its comment, and the comment"""


def edited(text: str, changes: Iterable[tuple[tuple[str, ...], Any]]) -> str:
    """Return the text with other values at paths, names and row numbers from 0; None takes an entry away.

    Raises InputError for a text that is not TOML, and for a path that does not lead to an entry.
    """
    try:
        document = tomlkit.parse(text)
        for path, value in changes:
            put(document, path, value)
        return aligned(text, tomlkit.dumps(document))
    except (TOMLKitError, LookupError, TypeError, ValueError) as error:
        raise InputError([f"the text cannot be changed there: {error}"]) from None


def aligned(old: str, new: str) -> str:
    """Return a changed text with each comment in the column that it had, where the line leaves room for it."""
    before, after = old.split("\n"), new.split("\n")
    if len(before) != len(after):
        return new
    lines = []
    for one, other in zip(before, after, strict=True):
        then, now = COMMENTED.fullmatch(one), COMMENTED.fullmatch(other)
        lines.append(f"{now[1]:<{then.start(3) - 1}} {now[3]}" if then and now and then[3] == now[3] else other)
    return "\n".join(lines)


def put(table: Any, path: Sequence[str], value: Any) -> None:
    """Set an entry below a table, or take it away."""
    *above, last = path
    for part in above:
        if isinstance(table, list):
            table = table[int(part)]
            continue
        if part not in table:
            table[part] = tomlkit.inline_table() if isinstance(table, InlineTable) else tomlkit.table()
        table = table[part]
    key = int(last) if isinstance(table, list) else last
    if value is None:
        del table[key]
    elif isinstance(table, list) and key == len(table):
        table.append(tomlkit.parse(f"x = {toml(value)}")["x"] if isinstance(table, Array) else value)
    else:
        table[key] = value


def differing(old: Any, new: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield the paths of the entries by which a description differs from another, with the new values."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in {**old, **new}:
            yield from differing(old.get(key, NOTHING), new.get(key, NOTHING), (*path, key))
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for k, (one, other) in enumerate(zip(old, new, strict=True)):
            yield from differing(one, other, (*path, str(k)))
    elif old is not new and old != new:
        yield path, None if new is NOTHING else new
