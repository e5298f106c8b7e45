"""Find entries by paths as a study has them: ``axes.MC01.phases[1].law``, rows by their names or counted from 1."""

import re
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Any

from pydantic import BaseModel, RootModel

from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.fields.paths import MISSING, PART, Place, child

MOST = 12  # names that a message lists


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
