"""Entries of a description by their paths: ``axes.MC01.phases[1].law``, rows by their names or counted from 1."""

import re
from collections.abc import Container, Iterable, Iterator, Sequence
from difflib import get_close_matches
from typing import Any

from pydantic import BaseModel, RootModel

from workbook.entries.machine import Machine
from workbook.errors import InputError

PART = re.compile(r'"([^"]*)"|\[(\d+)\]|([^.\[\]"]+)')
MISSING = object()  # what is at no entry
MOST = 12  # names that a message lists


def nearest(given: str, known: Iterable[str]) -> str:
    """Return in words what may be meant: the names most alike, else some of all."""
    names = list(known)
    alike = get_close_matches(given, names, n=3, cutoff=0.5)
    more = f" and {len(names) - MOST} more" if len(names) > MOST and not alike else ""
    return ", ".join(alike or names[:MOST]) + more


def written(path: Sequence[str]) -> str:
    """Return the way to an entry as a study writes it."""
    return re.sub(r"\.(\d+)", lambda found: f"[{int(found[1]) + 1}]", ".".join(path))


def path_of(machine: Machine, key: str, where: str, table: bool = False) -> tuple[str, ...]:
    """Return the names and numbers (from 0) on the way to an entry, or to a table; raise InputError for neither."""
    entry: Any = machine
    path: list[str] = []
    for whole, number, plain in PART.findall(key):
        part, known = whole or number or plain, children(entry)
        if isinstance(entry, list):
            names = [getattr(one, "name", None) for one in entry]
            counted = part not in names and part.isdecimal()  # axes.2.phases.1, as messages have it
            at = int(part) - 1 if number or counted else names.index(part) if part in names else -1
            entry, part = (entry[at], str(at)) if 0 <= at < len(entry) else (MISSING, part)
        elif isinstance(entry, RootModel):
            entry = entry.root.get(part, MISSING)
        elif isinstance(entry, BaseModel) and not number and part in type(entry).model_fields:
            entry = getattr(entry, part)
        else:
            entry = MISSING
        if entry is MISSING:
            said = f"has no {part!r}; expected {nearest(part, known)}" if known else f"is empty before {part!r}"
            raise InputError([f"{where}: {key!r} {said}"])
        path.append(part)
    if table and not isinstance(entry, BaseModel):
        raise InputError([f"{where}: {key!r} is no table of entries; expected a phase"])
    if not table and (not path or isinstance(entry, BaseModel | list)):
        expected = f"expected one of {nearest('', children(entry))} in it"
        raise InputError([f"{where}: {key!r} is a table of entries; {expected}"])
    return tuple(path)


def children(entry: Any) -> list[str]:
    """Return the names of what is below an entry."""
    if isinstance(entry, RootModel):
        return list(entry.root)
    if isinstance(entry, BaseModel):
        return list(type(entry).model_fields)
    if isinstance(entry, list):
        names = [str(one.name) for one in entry if getattr(one, "name", None)]  # in quotes those with a sign of a path
        quoted = [f'"{name}"' if re.search(r"[.\[\]]", name) else name for name in names]
        return quoted or [f"[{i}]" for i in range(1, len(entry) + 1)]
    return []


def with_entry(entry: Any, path: Sequence[str], value: Any) -> Any:
    """Return an entry with another value at a path: tables on the way as dictionaries, all others as they are."""
    if not path:
        return value
    first, *rest = path
    if isinstance(entry, list):
        at = int(first)
        return [*entry[:at], with_entry(entry[at], rest, value), *entry[at + 1 :]]
    fields = as_dict(entry)
    return fields | {first: with_entry(fields.get(first), rest, value)}


def as_dict(entry: Any) -> dict[str, Any]:
    """Return the entries of a table by name, what is below them as it is."""
    if isinstance(entry, RootModel):
        return dict(entry.root)
    if isinstance(entry, BaseModel):
        return {name: getattr(entry, name) for name in type(entry).model_fields if getattr(entry, name) is not None}
    return dict(entry or {})


def entry_at(entry: Any, path: Sequence[str]) -> Any:
    """Return what is at a path."""
    for part in path:
        entry = entry[int(part)] if isinstance(entry, list) else as_dict(entry).get(part)
    return entry


def leaves(data: Any, named: Container[str] = (), key: str = "") -> Iterator[tuple[str, Any]]:
    """Yield what is below an entry, by keys; a table ``named`` so that has no name has an empty one."""
    if isinstance(data, dict):
        for name, value in (({"name": ""} if key.rpartition(".")[2] in named else {}) | data).items():
            yield from leaves(value, named, f"{key}.{name}".strip("."))
    elif isinstance(data, list):
        for k, value in enumerate(data):
            yield from leaves(value, named, f"{key}.{k}")
    else:
        yield key, data
