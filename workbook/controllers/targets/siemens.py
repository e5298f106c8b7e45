"""Siemens S7-1500T: basic points of the library LCamHdl, as assignments in SCL."""

from __future__ import annotations

from workbook.controllers.structured import assigned, comments, indexed, points, rows
from workbook.controllers.table import Table
from workbook.controllers.target import Claim, Handed, Target

FIELDS = ("leadingValue", "followingValue", "velocityRatio", "accelerationRatio")
TYPES = "simatic-ax/lcamhdl, docs/types"


def write(handed: Handed) -> str:
    """Return the assignments, a line a point."""
    name = f"Cam_{handed.name}"
    lines = [assigned(f"{name}[{k}]", row) for k, row in enumerate(rows(handed.table, FIELDS), 1)]
    declared = f"{name} : ARRAY[1..{len(lines)}] OF LCamHdl_typeBasicPoint, for CreateCamBasic"
    return comments([*handed.header, declared]) + "".join(f"{line}\n" for line in lines)


def read(text: str) -> Table:
    """Return the points that are assigned."""
    return points(text, lambda one: indexed(one, FIELDS))


TARGET = Target(
    "siemens",
    "Siemens S7-1500T, LCamHdl basic points in SCL",
    ".scl",
    ("x", "y", "y'", "y''"),
    ("quintics",),
    write,
    read,
    (
        Claim("fields of LCamHdl_typeBasicPoint, LREAL, derivatives by the leading value", "documented", TYPES),
        Claim("2 to 51 points, leading values rise, polynomials of degree 5 between them", "documented", TYPES),
        Claim("start and end of the cam are the first and the last point", "documented", TYPES),
        Claim("the prefix that the tag has in a project, # or a data block", "untested", "not part of the library"),
    ),
    points=(2, 51),
)  # fmt: skip
