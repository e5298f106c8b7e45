"""CODESYS SoftMotion: SMC_CAMXYVA in Structured Text."""

from __future__ import annotations

from workbook.controllers.number import LREAL, literal
from workbook.controllers.structured import comments, grouped, points, rows
from workbook.controllers.table import Table
from workbook.controllers.target import Claim, Handed, Target
from workbook.controllers.tracks.codesys import TAPPETS

FIELDS = ("dX", "dY", "dV", "dA")
HELP = "CODESYS help, SM3_Basic, MC_CAM_REF"
GENERATED = "CODESYS help, Display Generated Code"


def write(handed: Handed) -> str:
    """Return a list of global variables: the points, and the cam that refers to them."""
    initial = [", ".join(f"{name} := {value}" for name, value in row.items()) for row in rows(handed.table, FIELDS)]
    name, n = f"Cam_{handed.name}", len(initial)
    start, end = (literal(LREAL.text(float(handed.table.x[k]))) for k in (0, -1))
    body = ",\n".join(f"    ({point})" for point in initial)
    return (
        f"{comments(handed.header)}{{attribute 'linkalways'}}\nVAR_GLOBAL\n"
        f"  {name}_A : ARRAY[0..{n - 1}] OF SMC_CAMXYVA := [\n{body}];\n"
        f"  {name} : MC_CAM_REF := (byType := 3, xStart := {start}, xEnd := {end}, nElements := {n},\n"
        f"    nTappets := 0, strCAMName := '{name}', pce := ADR({name}_A), xPartofLM := TRUE);\nEND_VAR\n"
    )


def read(text: str) -> Table:
    """Return the points of a Structured Text."""
    return points(text, lambda one: grouped(one, FIELDS), "nElements")


TARGET = Target(
    "codesys",
    "CODESYS SoftMotion, SMC_CAMXYVA in Structured Text",
    ".st",
    ("x", "y", "y'", "y''"),
    ("quintics",),
    write,
    read,
    (
        Claim("members of MC_CAM_REF, byType 3 for XYVA", "documented", HELP),
        Claim("members dX, dY, dV, dA in this order, and the form of the initialiser", "documented", GENERATED),
        Claim("dV and dA are derivatives by the master, both ends are points", "documented",
              "Lenze SoftMotion manual DMS 5.2, p. 105"),
        Claim("polynomials of degree 5 between points", "documented", GENERATED),
        Claim("the members of SMC_CAMXYVA are LREAL", "probable", "no document at hand says it"),
    ),
    points=(2, 32_767),
    tappets=TAPPETS,
)  # fmt: skip
