"""Mitsubishi: coordinates of cam data, whole numbers in columns of text."""

from __future__ import annotations

import numpy as np

from workbook.controllers.number import DINT, whole
from workbook.controllers.table import Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.text import joined, numbers
from workbook.controllers.units import counts, read_counts

MANUAL = "Mitsubishi RD77MS advanced synchronous control manual, p. 51"


def write(handed: Handed) -> str:
    """Return comments, and X and Y of each coordinate."""
    steps = handed.table.steps
    head = "".join(f"# {line}\r\n" for line in (*handed.header, counts(steps, handed.units)))
    columns = (np.round(values / step) for values, step in zip((handed.table.x, handed.table.y), steps, strict=True))
    rows = [[DINT.text(float(value)) for value in row] for row in zip(*columns, strict=True)]
    return f"{head}# X{handed.separator}Y\r\n" + joined(rows, handed.separator, handed.decimal)


def read(text: str) -> Table:
    """Return the coordinates, in the units that the comment names."""
    steps = read_counts(text)
    x, y = np.array(numbers(text, (2,))).T
    return Table(np.round(whole(x) * steps[0], 12), np.round(whole(y) * steps[1], 12))


TARGET = Target(
    "mitsubishi",
    "Mitsubishi, coordinates of cam data",
    ".csv",
    ("x", "y"),
    ("straight lines",),
    write,
    read,
    (
        Claim(
            "2 to 16,384 coordinates, X and Y whole numbers of 32 bits in the units of the axes", "documented", MANUAL
        ),
        Claim("straight lines between coordinates", "documented", MANUAL),
        Claim("the file that the engineering tool imports: these are the numbers alone", "untested", "not found"),
    ),
    number=DINT,
    points=(2, 16_384),
    signs=("separator",),
    tolerance=(("y", 1e-4), ("v", 0.01)),
)
