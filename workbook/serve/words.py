"""Sentences on the design page speak of the machine: ``MC03, phase 2, from`` for ``axes.2.phases.1.start``."""

import re
from collections.abc import Mapping
from typing import Any

from workbook.fields.paths import Place, get

SINGULAR = (
    "axes:axis phases:phase switches:switch clearances:clearance on:time reducers:reducer parts:part stages:stage"
    " points:point start:from stop:to master:machine windows:force edges:edge orders:order motors:motor"
)
PARTS = dict(pair.split(":") for pair in SINGULAR.split())
FOUND = re.compile(r"^empty; (?:expected )?")
COUNTED = re.compile(r"\s*\(counted from 1\)")


def spoken(place: Place, data: Any, short: bool = False) -> str:
    """Return a path in the words of a machine, rows by their names or numbers; ``short`` without the first."""
    words = list[str]()
    for k, part in enumerate(place):
        if part.isdigit() and k:
            row = get(data, place[: k + 1])
            name = row.get("name") if isinstance(row, Mapping) else None
            words[-1] = str(name) if name and isinstance(name, str) else f"{words[-1]} {int(part) + 1}"
        else:
            words.append(PARTS.get(part, part.replace("_", " ")))
    return ", ".join(words[1:] if short and len(words) > 1 else words) or "the machine"


def sentence(line: str) -> str:
    """Return the fault of an entry as it stands below its field."""
    return COUNTED.sub("", FOUND.sub("missing: expected ", line))
