"""Beckhoff TwinCAT: a position table, in Structured Text."""

from __future__ import annotations

from workbook.controllers.structured import comments, flat_pairs, points, rows
from workbook.controllers.table import SPLINES, Table, equidistant
from workbook.controllers.target import Claim, Handed, Target

INFOSYS = "Beckhoff Infosys, TF5050 TC3 NC Camming"


def write(handed: Handed) -> str:
    """Return the table as an initialised array, and the assignments of its reference."""
    table, n, name = handed.table, len(handed.table.x), f"Cam_{handed.name}"
    body = ",\n".join(f"    {row['x']}, {row['y']}" for row in rows(table, ("x", "y")))
    kind = "EQUIDISTANT" if equidistant(table.x) else "NONEQUIDISTANT"
    return (
        f"{comments(handed.header)}VAR\n  {name}_T : ARRAY[0..{n - 1}, 0..1] OF LREAL := [\n{body}];\n"
        f"  {name} : MC_CAM_REF;\nEND_VAR\n{name}.pArray := ADR({name}_T); {name}.ArraySize := SIZEOF({name}_T); "
        f"{name}.TableType := MC_TABLETYPE_{kind};\n{name}.NoOfRows := {n}; {name}.NoOfColumns := 2;\n"
    )


def read(text: str) -> Table:
    """Return the points of the array."""
    return points(text, flat_pairs, "NoOfRows")


TARGET = Target(
    "twincat-table",
    "Beckhoff TwinCAT, position table in Structured Text",
    ".st",
    ("x", "y"),
    SPLINES,
    write,
    read,
    (
        Claim("rows of master and slave, LREAL, the master in every row", "documented", f"{INFOSYS}, 1003586955"),
        Claim("TableType: EQUIDISTANT (10) at equal steps, else NONEQUIDISTANT (11)", "documented",
              f"{INFOSYS}, 1003586955"),
        Claim("a spline needs 4 rows or more, at most 65,535", "documented", "Beckhoff Infosys, Table Errors"),
        Claim("the spline is chosen at coupling; what tangential and cyclic mean in formulas", "untested",
              f"{INFOSYS}, 1003709323 names them only"),
    ),
    points=(4, 65_535),
)  # fmt: skip
