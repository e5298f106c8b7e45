"""Siemens S7-1500T: interpolation points of TO_Cam, as assignments in SCL."""

from __future__ import annotations

from workbook.controllers.structured import assigned, comments, indexed, points, rows
from workbook.controllers.table import SPLINES, Table
from workbook.controllers.target import Claim, Handed, Target

FIELDS = ("x", "y")
HELP = "Siemens TIA help, S7-1500/S7-1500T synchronous operation, tags of the cam"


def write(handed: Handed) -> str:
    """Return the assignments of the points, and of how to go between them."""
    name = f"Cam_{handed.name}"
    lines = [f"{assigned(f'{name}.Point[{k}]', row)} {name}.ValidPoint[{k}] := TRUE;"
             for k, row in enumerate(rows(handed.table, FIELDS), 1)]  # fmt: skip
    lines.append(f"{name}.InterpolationSettings.InterpolationMode := 1;")
    lines.append(f"{name}.InterpolationSettings.BoundaryConditions := {int(handed.repeats)};")
    declared = f"{name} : TO_Cam; MC_InterpolateCam comes before its use; points beyond these stay invalid"
    return comments([*handed.header, declared]) + "".join(f"{line}\n" for line in lines)


def read(text: str) -> Table:
    """Return the points that are assigned."""
    return points(text, lambda one: indexed(one, FIELDS))


TARGET = Target(
    "siemens-points",
    "Siemens S7-1500T, points of TO_Cam in SCL",
    ".scl",
    ("x", "y"),
    SPLINES,
    write,
    read,
    (
        Claim("fields of Point, ValidPoint, InterpolationSettings; 1 to 1000 points, LREAL", "documented", HELP),
        Claim("InterpolationMode 1 is a cubic spline through the points", "documented", HELP),
        Claim("ends of the spline: BoundaryConditions 1 (equal first derivatives), 0 (none)", "untested",
              "the help does not give the formula"),
    ),
    points=(2, 1000),
)  # fmt: skip
