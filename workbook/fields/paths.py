"""Paths to the entries of a description: ``axes.2.phases.1.lift`` in keys, ``axes[3].phases[2].lift`` to people."""

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

from pydantic import BaseModel, RootModel

Place = tuple[str, ...]  # names, and numbers of rows from 0
PART = re.compile(r"""("[^"]*"|'[^']*')|\[(\d+)\]|([^.\[\]"]+)""")
PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_-]*")
MISSING: Any = object()  # stands where nothing is entered, and no default


def split(key: str) -> Place:
    """Return the path of a key; names of laws may stand in quotes."""
    return tuple(quoted[1:-1] or plain for quoted, _, plain in PART.findall(key))


def join(path: Sequence[str]) -> str:
    """Return the key of a path."""
    return ".".join([key_of(name) if i == 1 and path[0] == "laws" else name for i, name in enumerate(path)])


def key_of(name: str) -> str:
    """Return a law's name as a part of a key: in quotes, where it has more than letters and digits."""
    quote = "'" if '"' in name else '"'  # as in TOML; no key tells a name with both
    return name if PLAIN.fullmatch(name) else f"{quote}{name}{quote}"


def spell(key: str | Sequence[str]) -> str:
    """Return a key or path as people read and write it, rows counted from 1: ``axes[3].phases[2].lift``."""
    text = key if isinstance(key, str) else join(key)
    return re.sub(r"""("[^"]*"|'[^']*')|\.(\d+)""", lambda part: part[1] or f"[{int(part[2]) + 1}]", text)


def table(entry: Any) -> dict[str, Any]:
    """Return the entries of a table or model by name, those below as they are; without those that are left out."""
    if isinstance(entry, RootModel):
        return dict(entry.root)
    if isinstance(entry, BaseModel):
        return {name: value for name, value in entry if value is not None}
    return dict(entry or {})


def child(entry: Any, part: str) -> Any:
    """Return the entry under a name of a table, or in a row of a list; MISSING where there is none."""
    if isinstance(entry, list):
        return entry[int(part)] if part.isdecimal() and int(part) < len(entry) else MISSING
    if isinstance(entry, RootModel):
        entry = entry.root
    if isinstance(entry, BaseModel):
        return getattr(entry, part) if part in type(entry).model_fields else MISSING
    return entry.get(part, MISSING) if isinstance(entry, Mapping) else MISSING


def get(entry: Any, path: Sequence[str], default: Any = None) -> Any:
    """Return the entry at a path of tables, lists and models, or the default."""
    for part in path:
        entry = child(entry, part)
    return default if entry is MISSING else entry


def has_key(entry: Any, key: str) -> bool:
    """Whether an entry has another at a key below it."""
    return get(entry, split(key), MISSING) is not MISSING


def reach(data: Any, path: Sequence[str], grow: bool = True) -> tuple[Any, Any]:
    """Return the table or list that holds the entry at a path, and its key there; make tables and rows on the way.

    Where rows are not to ``grow``, a missing row raises LookupError.
    """
    held: Any = data
    key: Any = ""
    for part, after in pairwise((*path, "")):
        held, key = data, int(part) if isinstance(data, list) else part
        while grow and isinstance(held, list) and len(held) <= key:
            held.append([] if after.isdecimal() else {})
        if after and not isinstance(held, list):
            held.setdefault(key, [] if after.isdecimal() else {})
        data = held[key] if after else None
    return held, key


def put(data: Any, path: Sequence[str], value: Any = MISSING) -> None:
    """Set the entry at a path, with the tables and rows on the way; without a value only make room for it."""
    held, key = reach(data, path)
    if value is not MISSING:
        held[key] = value


def replaced(entry: Any, path: Sequence[str], value: Any) -> Any:
    """Return a copy of an entry with another value at a path: tables on the way as dictionaries, all others as is."""
    if not path:
        return value
    first, *rest = path
    if isinstance(entry, list):
        at = int(first)
        return [*entry[:at], replaced(entry[at], rest, value), *entry[at + 1 :]]
    fields = table(entry)
    return fields | {first: replaced(fields.get(first), rest, value)}


def leaves(data: Any, path: Place = ()) -> Iterator[tuple[Place, Any]]:
    """Yield the entries at and below a path, with their paths; also tables that are empty."""
    if isinstance(data, dict) and data:
        for name, value in data.items():
            yield from leaves(value, (*path, name))
    elif isinstance(data, list):
        for i, value in enumerate(data):
            yield from leaves(value, (*path, str(i)))
    else:
        yield path, data


def spread(data: Any, pattern: Sequence[str], path: Place = ()) -> Iterator[tuple[Place, Any]]:
    """Yield what is at a path with ``*`` for each row, and its path; a list without rows has a place for the first."""
    if not pattern:
        yield path, data
        return
    first, *rest = pattern
    if first == "*":
        rows = data if isinstance(data, list) else []
        for k, row in enumerate(rows or ([] if rest else [None])):
            yield from spread(row, rest, (*path, str(k)))
    elif isinstance(data, dict | None):
        yield from spread((data or {}).get(first), rest, (*path, first))
