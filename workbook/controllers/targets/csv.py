"""A table of any tool: x, y, y', y'', y''' in columns of text."""

from __future__ import annotations

import numpy as np

from workbook.controllers.number import LREAL
from workbook.controllers.table import SPLINES, Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.text import joined, numbers
from workbook.controllers.tracks.csv import TAPPETS

WIDTHS = (2, 3, 4, 5)


def write(handed: Handed) -> str:
    """Return comments, a line of titles, and a line a point."""
    columns = handed.table.columns
    titles = handed.separator.join(columns)
    head = "".join(f"# {line}\r\n" for line in (*handed.header, titles))
    rows = [[LREAL.text(value) for value in row] for row in zip(*columns.values(), strict=True)]
    return head + joined(rows, handed.separator, handed.decimal)


def read(text: str) -> Table:
    """Return the table of a text of two to five columns."""
    x, y, *more = np.array(numbers(text, WIDTHS)).T
    return Table(x, y, *more)


TARGET = Target(
    "csv",
    "Columns of text: x, y, y', y'', y'''",
    ".csv",
    ("x", "y", "y'", "y''", "y'''"),
    ("quintics",),
    write,
    read,
    (
        Claim("both ends are points, x rises, derivatives are by the master", "documented", "this project"),
        Claim("a controller makes polynomials of degree 5 of y, y' and y''", "untested", "no common standard"),
    ),
    plain=SPLINES,
    signs=("separator", "decimal"),
    tappets=TAPPETS,
)  # fmt: skip
