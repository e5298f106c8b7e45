"""Lenze Global Drive Cam Loader: x and y as text."""

import re

import numpy as np

from workbook.controllers.table import LOCAL, SPLINES, Table
from workbook.controllers.target import Handed, Target
from workbook.controllers.text import numbers, written

COMMENT = re.compile(r"\s//[^\n]*")


def write(handed: Handed) -> str:
    """Return x and y of each point, the header behind the first as comments on blank lines."""
    lines = written((handed.table.x, handed.table.y), " ", handed.decimal)
    return lines + "".join(f" // {line}\r\n" for line in handed.header)


def read(text: str) -> Table:
    """Return the points; a third column is a profile for the torque, and is passed over."""
    x, y, *_ = np.array(numbers(COMMENT.sub("", text), (2, 3))).T
    return Table(x, y)


TARGETS = (
    Target(
        "lenze", "Lenze Global Drive Cam Loader, text", ".txt", ("x", "y"), (*SPLINES, LOCAL), write, read,
        points=(4, 10_000), signs=("decimal",),
    ),
)  # fmt: skip
