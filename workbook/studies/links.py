"""Linked entries of a study: each follows another, or lies a number beyond it, whatever its value."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.fields.paths import Place, get, spell
from workbook.studies.paths import path_of

TERM = re.compile(r"(?P<path>.+?)(?:\s*(?P<sign>[+-])\s*(?P<by>\d+(?:\.\d*)?|\.\d+))?")


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
