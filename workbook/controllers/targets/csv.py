"""A table of any tool: x, y, y', y'', y''' in columns of text."""

from __future__ import annotations

import numpy as np

from workbook.controllers.number import LREAL
from workbook.controllers.table import SPLINES, Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.text import joined, numbers
from workbook.controllers.tracks.csv import TAPPETS
from workbook.errors import TargetError

WIDTHS = (2, 3, 4, 5)
DENSE = 100  # points: so many tell by their differences what y' is
FAR = 0.5


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
    table = Table(x, y, *more)
    if table.v is not None and len(x) > DENSE:
        off = np.abs(np.diff(y) - 0.5 * (table.v[:-1] + table.v[1:]) * np.diff(x)).sum()
        if off > FAR * np.abs(np.diff(y)).sum():
            raise TargetError("the third column is not y' by x; derivatives are by the master")
    return table


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
