"""Columns of text: of any tool (and its switches), Kollmorgen KAS, Lenze Global Drive Cam Loader, SEW MOVI-C."""

import re

import numpy as np

from workbook.controllers.table import Table
from workbook.controllers.target import CamExport, SwitchExport, Tappets, Target, facts_of, tracks_of_rows
from workbook.controllers.texts import as_lines, numbers, remarks
from workbook.errors import TargetError

DENSE = 100  # points: so many tell by their differences what y' is
FAR = 0.5
CYCLIC = re.compile(r"CYCLIC;(YES|NO);?")
COMMENT = re.compile(r"\s//[^\n]*")


def write_any(handed: CamExport) -> str:
    """Return comments, a line of titles, and a line a point."""
    columns = handed.table.columns
    head = remarks(*handed.header, handed.separator.join(columns))
    return head + as_lines(columns.values(), handed.separator, handed.decimal)


def read_any(text: str) -> Table:
    """Return the table of a text of two to five columns."""
    x, y, *more = np.array(numbers(text, (2, 3, 4, 5))).T
    table = Table(x, y, *more)
    if table.v is not None and len(x) > DENSE:
        off = np.abs(np.diff(y) - 0.5 * (table.v[:-1] + table.v[1:]) * np.diff(x)).sum()
        if off > FAR * np.abs(np.diff(y)).sum():
            raise TargetError("the third column is not y' by x; derivatives are by the master")
    return table


def write_switches(handed: SwitchExport) -> str:
    """Return comments, a line of titles, and a line a time."""
    head = remarks(*handed.header, *handed.called, handed.separator.join(("track", "on from", "to")))
    tracks, *ends = np.array(handed.times).reshape(-1, 3).T
    lines = as_lines(ends, handed.separator, handed.decimal).splitlines(keepends=True)
    return head + "".join(f"{number:.0f}{handed.separator}{line}" for number, line in zip(tracks, lines, strict=True))


def write_kollmorgen(handed: CamExport) -> str:
    """Return the profile; the format has no comment, and units vanish, as an import divides by the largest x and y."""
    table = handed.table
    if table.y.max() <= 0.0:
        raise TargetError("no y is above 0; expected one, as an import divides by the largest")
    lines = as_lines((table.x, table.y)).replace("\r\n", ";SPLINE\r\n")
    return f"CYCLIC;{'YES' if handed.repeats else 'NO'};\r\nTABLE_BEGIN;;\r\n{lines}TABLE_END;;\r\n"


def read_kollmorgen(text: str) -> Table:
    """Return the points between TABLE_BEGIN and TABLE_END."""
    lines = [line for line in map(str.strip, text.splitlines()) if line]
    frame = [line.rstrip(";") for line in (*lines[1:2], *lines[-1:])]
    if len(lines) < 4 or not CYCLIC.fullmatch(lines[0]) or frame != ["TABLE_BEGIN", "TABLE_END"]:
        raise TargetError("expected CYCLIC;YES; then points between TABLE_BEGIN;; and TABLE_END;; (is it cut off?)")
    lines = lines[2:-1]
    for n, line in enumerate(lines, 1):
        if not line.endswith(";SPLINE"):
            raise TargetError(f"point {n}: {line[:40]!r}; expected x;y;SPLINE")
    return Table(*np.array(numbers("\n".join(line.removesuffix(";SPLINE") for line in lines), (2,))).T)


def write_lenze(handed: CamExport) -> str:
    """Return x and y of each point, the header behind the first as comments on blank lines."""
    lines = as_lines((handed.table.x, handed.table.y), " ", handed.decimal)
    return lines + "".join(f" // {line}\r\n" for line in handed.header)


def read_lenze(text: str) -> Table:
    """Return the points; a third column is a profile for the torque, and is passed over."""
    x, y, *_ = np.array(numbers(COMMENT.sub("", text), (2, 3))).T
    return Table(x, y)


def write_sew(handed: CamExport) -> str:
    """Return the count, and x and y of each point; the format has no comment."""
    table = handed.table
    return f"{len(table.x)}\r\n" + as_lines((table.x, table.y), handed.separator, handed.decimal)


TAPPETS = Tappets(
    **facts_of("csv switches"), write=write_switches, read=lambda text: tracks_of_rows(text, numbers(text, (3,)))
)
TARGETS = (
    Target(**facts_of("csv"), write=write_any, read=read_any, tappets=TAPPETS),
    Target(**facts_of("kollmorgen"), write=write_kollmorgen, read=read_kollmorgen),
    Target(**facts_of("lenze"), write=write_lenze, read=read_lenze),
    Target(**facts_of("sew"), write=write_sew, read=lambda text: Table(*np.array(numbers(text, (2,))).T)),
)
