"""CODESYS SoftMotion: a table of pairs with cubic interpolation, in Structured Text."""

from __future__ import annotations

from math import ceil, log2

import numpy as np

from engine.laws.base import Array
from workbook.controllers.number import LREAL, literal
from workbook.controllers.structured import comments, pairs, points, rows
from workbook.controllers.table import LOCAL, SPLINES, Table
from workbook.controllers.target import Claim, Handed, Target

HELP = "CODESYS help, SM3_Basic, SMC_CAMTable_LREAL_128_1 and MC_CAM_REF"
EDGES = ("fEditorMaster", "fEditorSlave", "fTableMaster", "fTableSlave")


def write(handed: Handed) -> str:
    """Return the type of the table, the table, and the cam that refers to it."""
    table, n, name = handed.table, len(handed.table.x), f"Cam_{handed.name}"
    kind = f"SMC_CAMTable_LREAL_{n}_2"
    body = ",\n".join(f"    [{row['x']}, {row['y']}]" for row in rows(table, ("x", "y")))
    ends = dict(zip(EDGES, (span(table.x), span(table.y), span(table.x), span(table.y)), strict=True))
    limits = ", ".join(f"{edge}Min := {low}, {edge}Max := {high}" for edge, (low, high) in ends.items())
    start, end = (literal(LREAL.text(float(table.x[k]))) for k in (0, -1))
    declared = ", ".join(f"{edge}{which}" for edge in EDGES for which in ("Min", "Max"))
    return (
        f"{comments(handed.header)}TYPE {kind} : STRUCT\n  Table : ARRAY[0..{n - 1}] OF ARRAY[0..1] OF LREAL;\n"
        f"  {declared} : REAL;\nEND_STRUCT END_TYPE\nVAR_GLOBAL\n  {name}_T : {kind} := (\n  Table := [\n{body}],\n"
        f"  {limits});\n  {name} : MC_CAM_REF := (byType := 2, byVarType := 6, xStart := {start}, xEnd := {end}, "
        f"nElements := {n},\n    nTappets := 0, byInterpolationQuality := 3, strCAMName := '{name}', "
        f"pce := ADR({name}_T));\nEND_VAR\n"
    )


def span(values: Array) -> tuple[str, str]:
    """Return ends that REAL holds exactly, alike for editor and table: nothing is scaled."""
    reach = 2.0 ** ceil(log2(max(1.0, float(np.abs(values).max()))))
    low = -reach if float(values.min()) < 0.0 else 0.0
    return literal(LREAL.text(low)), literal(LREAL.text(reach))


def read(text: str) -> Table:
    """Return the points of a Structured Text."""
    return points(text, lambda one: pairs(one, "Table"), "nElements")


TARGET = Target(
    "codesys-table",
    "CODESYS SoftMotion, table of pairs, cubic, in Structured Text",
    ".st",
    ("x", "y"),
    (*SPLINES, LOCAL),
    write,
    read,
    (
        Claim("members of MC_CAM_REF, byType 2 for pairs, byInterpolationQuality 3 for cubic", "documented", HELP),
        Claim("the eight limits, which must not be 0, scale the table", "documented", HELP),
        Claim("pairs as ARRAY OF ARRAY[0..1]", "probable", "Lenze SoftMotion manual DMS 5.2, p. 105"),
        Claim("the ends of the cubic interpolation, and whether it is a spline", "untested", "no document says it"),
        Claim("whether each compiler takes the nested initialiser", "untested", "no document says it"),
    ),
    points=(4, 32_767),
)
