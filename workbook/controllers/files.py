"""Files of controllers, from anywhere: read under a limit, and refused in one line where they are no table."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from workbook.controllers.table import Table
from workbook.controllers.target import Target
from workbook.errors import ReadError, TargetError
from workbook.intake import read_text

MOST = 8_000_000  # bytes: a tag of 25,000 points
LARGEST = 1e12  # of x, y and derivatives
TOLD = re.compile(r"; ([0-9]{1,9}) points(?: at equal steps)?; between them")


def read_table(path: Path, target: Target) -> Table:
    """Return the table of a target's file; raise ReadError, in one line, where it is none."""
    text = text_of(path, target)
    try:
        return parsed(text, target)
    except TargetError as error:
        raise ReadError(f"{path}: {error}") from None


def text_of(path: Path, target: Target) -> str:
    """Return the text of a target's file, without what ends a text of old."""
    return read_text(path, f"a file for {target.name}", MOST, foreign=True).rstrip("\x1a\x00")


def parsed(text: str, target: Target) -> Table:
    """Return the table of a text; raise TargetError where it is none, or has not the points that its header tells."""
    with np.errstate(over="ignore", invalid="ignore"):  # what is not finite is refused by point
        table = target.read(text)
    require_usual(table)
    told = TOLD.search(text)
    if told and int(told[1]) != len(table.x):
        raise TargetError(f"{len(table.x)} points; its header tells {told[1]} (is the file cut off?)")
    return table


def require_usual(table: Table) -> None:
    """Raise TargetError for a number so large that none of a motion is; fits of it would overflow."""
    for name, column in table.columns.items():
        size = np.abs(column)
        if size.max() > LARGEST:
            k = int(size.argmax())
            raise TargetError(f"point {k + 1}: {name} is {column[k]:.6g}; expected at most {LARGEST:.0e} either way")


def header(points: int, between: str, equal: bool, units: tuple[str, str]) -> str:
    """Return the line of a header that tells units, points, whether at equal steps, and what is between them."""
    return (
        f"x in {units[0]}, y in {units[1]}; {points} points{' at equal steps' if equal else ''}; between them {between}"
    )
