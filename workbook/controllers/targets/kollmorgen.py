"""Kollmorgen KAS: a cam profile as CSV."""

import re

import numpy as np

from workbook.controllers.table import SPLINES, Table
from workbook.controllers.target import Handed, Target
from workbook.controllers.text import numbers, written
from workbook.errors import TargetError

CYCLIC = re.compile(r"CYCLIC;(YES|NO);?")


def write(handed: Handed) -> str:
    """Return the profile; the format has no comment, and units vanish, as an import divides by the largest x and y."""
    table = handed.table
    if table.y.max() <= 0.0:
        raise TargetError("no y is above 0; expected one, as an import divides by the largest")
    lines = written((table.x, table.y)).replace("\r\n", ";SPLINE\r\n")
    return f"CYCLIC;{'YES' if handed.repeats else 'NO'};\r\nTABLE_BEGIN;;\r\n{lines}TABLE_END;;\r\n"


def read(text: str) -> Table:
    """Return the points between TABLE_BEGIN and TABLE_END."""
    lines = [line for line in map(str.strip, text.splitlines()) if line]
    frame = [line.rstrip(";") for line in (*lines[1:2], *lines[-1:])]
    if len(lines) < 4 or not CYCLIC.fullmatch(lines[0]) or frame != ["TABLE_BEGIN", "TABLE_END"]:
        raise TargetError("expected CYCLIC;YES; then points between TABLE_BEGIN;; and TABLE_END;; (is it cut off?)")
    lines = lines[2:-1]
    for n, line in enumerate(lines, 1):
        if not line.endswith(";SPLINE"):
            raise TargetError(f"point {n}: {line[:40]!r}; expected x;y;SPLINE")
    x, y = np.array(numbers("\n".join(line.removesuffix(";SPLINE") for line in lines), (2,))).T
    return Table(x, y)


TARGETS = (
    Target(
        "kollmorgen", "Kollmorgen KAS, cam profile as CSV", ".csv", ("x", "y"), SPLINES, write, read,
        points=(5, 10_000),
    ),
)  # fmt: skip
