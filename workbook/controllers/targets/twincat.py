"""Beckhoff TwinCAT NC2: motion function points, as assignments in Structured Text."""

from __future__ import annotations

from workbook.controllers.structured import assigned, comments, indexed, points, rows
from workbook.controllers.table import Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.tracks.twincat import TAPPETS

FIELDS = ("MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc")
INFOSYS = "Beckhoff Infosys, TF5050 TC3 NC Camming"


def write(handed: Handed) -> str:
    """Return the variables, and the assignments of each point and of the reference."""
    n, name, lines = len(handed.table.x), f"Cam_{handed.name}", []
    for k, row in enumerate(rows(handed.table, FIELDS), 1):
        kind = "ACTIVATION" if k == 1 else "MOTION"
        head = {
            "PointIndex": str(k),
            "FunctionType": "MOTIONFUNCTYPE_POLYNOM5_MM",
            "PointType": f"MOTIONPOINTTYPE_{kind}",
            "RelIndexNextPoint": str(int(k < n)),
        }
        lines.append(assigned(f"{name}_P[{k}]", head | row | {"SlaveJerk": "0.0"}))
    body = "\n".join(lines)
    last = {"pArray": f"ADR({name}_P)", "ArraySize": f"SIZEOF({name}_P)", "TableType": "MC_TABLETYPE_MOTIONFUNCTION",
            "NoOfRows": str(n), "NoOfColumns": "1"}  # fmt: skip
    reference = "".join(f"{name}.{field} := {value};\n" for field, value in last.items())
    declared = f"VAR\n  {name}_P : ARRAY[1..{n}] OF MC_MotionFunctionPoint;\n  {name} : MC_CAM_REF;\nEND_VAR\n"
    return f"{comments(handed.header)}{declared}{body}\n{reference}"


def read(text: str) -> Table:
    """Return the points that are assigned."""
    return points(text, lambda one: indexed(one, FIELDS), "NoOfRows")


TARGET = Target(
    "twincat",
    "Beckhoff TwinCAT NC2, motion function points in Structured Text",
    ".st",
    ("x", "y", "y'", "y''"),
    ("quintics",),
    write,
    read,
    (
        Claim("fields of MC_MotionFunctionPoint and MC_CAM_REF", "documented", f"{INFOSYS}, 1003721995, 1003586955"),
        Claim("POLYNOM5_MM (15): degree 5 from motion to motion, of the segment that starts here", "documented",
              f"{INFOSYS}, 1003744011"),
        Claim("y' and y'' are derivatives by the master", "probable", "comments Y', Y'' in the declaration"),
        Claim("PointType of the first point (ACTIVATION), RelIndexNextPoint of the last (0)", "untested",
              "as one public generator writes them"),
    ),
    points=(2, 65_535),
    tappets=TAPPETS,
)  # fmt: skip
