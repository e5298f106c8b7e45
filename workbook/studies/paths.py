"""Entries by paths as a study has them: ``axes.MC01.phases[1].law``, rows by names or counted from 1; their links."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from pydantic import BaseModel, RootModel

from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.fields.paths import MISSING, PART, Place, child, get, spell

MOST = 12  # names that a message lists
TERM = re.compile(r"(?P<path>.+?)(?:\s*(?P<sign>[+-])\s*(?P<by>\d+(?:\.\d*)?|\.\d+))?")


def nearest(given: str, known: Iterable[str]) -> str:
    """Return in words what may be meant: the names most alike, else some of all."""
    names = list(known)
    alike = get_close_matches(given, names, n=3, cutoff=0.5)
    more = f" and {len(names) - MOST} more" if len(names) > MOST and not alike else ""
    return ", ".join(alike or names[:MOST]) + more


def path_of(machine: Machine, key: str, where: str, table: bool = False) -> Place:
    """Return the names and numbers (from 0) on the way to an entry, or to a table; raise InputError for neither."""
    entry: Any = machine
    path: list[str] = []
    for whole, number, plain in PART.findall(key):
        part, known = whole[1:-1] or number or plain, children(entry)
        step = row_of(entry, part, bool(number)) if isinstance(entry, list) else "" if number else part
        entry = child(entry, step) if step else MISSING
        if entry is MISSING:
            problem = f"has no {part!r}; expected {nearest(part, known)}" if known else f"is empty before {part!r}"
            raise InputError([f"{where}: {key!r} {problem}"])
        path.append(step)
    if table and not isinstance(entry, BaseModel):
        raise InputError([f"{where}: {key!r} is no table of entries; expected a phase"])
    if not table and (not path or isinstance(entry, BaseModel | list)):
        expected = f"expected one of {nearest('', children(entry))} in it"
        raise InputError([f"{where}: {key!r} is a table of entries; {expected}"])
    return tuple(path)


def row_of(rows: Sequence[Any], part: str, is_number: bool) -> str:
    """Return the number, from 0, of the row that has a name or a number from 1; empty where no row has the name."""
    names = [getattr(row, "name", None) for row in rows]
    # axes.2.phases.1, as messages have it
    if is_number or (part not in names and part.isdecimal()):
        return str(int(part) - 1)
    return str(names.index(part)) if part in names else ""


def children(entry: Any) -> list[str]:
    """Return the names of what is below an entry."""
    if isinstance(entry, RootModel):
        return list(entry.root)
    if isinstance(entry, BaseModel):
        return list(type(entry).model_fields)
    if isinstance(entry, list):
        # in quotes those with a sign of a path
        names = [str(row.name) for row in entry if getattr(row, "name", None)]
        quoted = [f'"{name}"' if re.search(r"[.\[\]]", name) else name for name in names]
        return quoted or [f"[{i}]" for i in range(1, len(entry) + 1)]
    return []


@dataclass(frozen=True)
class Link:
    """An entry that follows the entry at ``source``, larger by ``offset``; both are ways of names and numbers."""

    path: Place
    source: Place
    offset: float = 0.0

    def value(self, known: Any) -> Any:
        """Return the entry's value for the value of the entry it follows."""
        return known + self.offset if self.offset else known


def make_links(machine: Machine, given: Mapping[str, str], where: str) -> tuple[Link, ...]:
    """Return the links of a study of a machine, each after those that it follows; raise InputError.

    ``given`` has by the path of the entry that follows: a path, or a path + or - a number in the unit of the entry.
    """
    left = {}
    for key, text in given.items():
        named = f"{where}: links: {key}"
        term = TERM.fullmatch(text.strip())
        if term is None:
            raise InputError([f"{named} = {text!r}; expected a path, or a path + or - a number"])
        path, source = path_of(machine, key, named), path_of(machine, term["path"], named)
        offset = float((term["sign"] or "") + (term["by"] or "0"))
        for each in (path, source) if offset else ():
            require_number(machine, each, named)
        if path in left:
            raise InputError([f"{named}: {spell(path)} is linked twice"])
        left[path] = Link(path, source, offset)
    ordered: list[Link] = []
    while left:
        free = [link for link in left.values() if link.source not in left]
        if not free:
            names = ", ".join(map(spell, left))
            raise InputError([f"{where}: links: {names} follow each other; expected one of them without a link"])
        ordered += free
        left = {path: link for path, link in left.items() if link not in free}
    return tuple(ordered)


def require_number(machine: Machine, path: Place, where: str) -> None:
    """Raise InputError where an entry of the base is no number."""
    value = get(machine, path)
    if not isinstance(value, int | float) or isinstance(value, bool):
        raise InputError([f"{where}: {spell(path)} is {value!r}; expected a number, to which one is added"])


def followed(links: tuple[Link, ...], data: Mapping[str, Any], changed: Mapping[Place, Any]) -> dict[Place, Any]:
    """Return the changed entries with those that follow them, or others of the data."""
    entries = dict(changed)
    for link in links:
        entries[link.path] = link.value(entries.get(link.source, get(data, link.source)))
    return entries
