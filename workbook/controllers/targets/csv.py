"""Tables of any tool in columns of text: x, y, y', y'', y''', and the switches' track, from, to."""

import numpy as np

from workbook.controllers.table import SPLINES, Table
from workbook.controllers.target import Handed, HandedTracks, Tappets, Target, Track, gathered
from workbook.controllers.text import numbers, remarks, written
from workbook.errors import TargetError

DENSE = 100  # points: so many tell by their differences what y' is
FAR = 0.5


def write(handed: Handed) -> str:
    """Return comments, a line of titles, and a line a point."""
    columns = handed.table.columns
    head = remarks(*handed.header, handed.separator.join(columns))
    return head + written(columns.values(), handed.separator, handed.decimal)


def read(text: str) -> Table:
    """Return the table of a text of two to five columns."""
    x, y, *more = np.array(numbers(text, (2, 3, 4, 5))).T
    table = Table(x, y, *more)
    if table.v is not None and len(x) > DENSE:
        off = np.abs(np.diff(y) - 0.5 * (table.v[:-1] + table.v[1:]) * np.diff(x)).sum()
        if off > FAR * np.abs(np.diff(y)).sum():
            raise TargetError("the third column is not y' by x; derivatives are by the master")
    return table


def write_switches(handed: HandedTracks) -> str:
    """Return comments, a line of titles, and a line a time."""
    head = remarks(*handed.header, *handed.called, handed.separator.join(("track", "on from", "to")))
    tracks, *ends = np.array(handed.times).reshape(-1, 3).T
    lines = written(ends, handed.separator, handed.decimal).splitlines(keepends=True)
    return head + "".join(f"{number:.0f}{handed.separator}{line}" for number, line in zip(tracks, lines, strict=True))


def read_switches(text: str) -> list[Track]:
    """Return the tracks of a text of three columns."""
    return gathered(text, ((number, begin, end) for number, begin, end in numbers(text, (3,))))


TARGETS = (
    Target(
        "csv", "Columns of text: x, y, y', y'', y'''", ".csv", ("x", "y", "y'", "y''", "y'''"), ("quintics",),
        write, read, plain=SPLINES, signs=("separator", "decimal"),
        tappets=Tappets("csv switches", "track, on from, to", write_switches, read_switches),
    ),
)  # fmt: skip
