"""CODESYS SoftMotion in Structured Text: points of SMC_CAMXYVA, a table of pairs, switches of MC_CAMSWITCH_TR."""

from math import ceil, log2

import numpy as np

from engine.laws.base import Array
from workbook.controllers.number import literal
from workbook.controllers.structured import comments, counted, grouped, pairs, points, rows
from workbook.controllers.table import LOCAL, SPLINES
from workbook.controllers.target import Handed, HandedTracks, Tappets, Target, Track, gathered

FIELDS = ("dX", "dY", "dV", "dA")
EDGES = ("fEditorMaster", "fEditorSlave", "fTableMaster", "fTableSlave")
SWITCHED = ("TrackNumber", "FirstOnPosition", "LastOnPosition")


def write(handed: Handed) -> str:
    """Return a list of global variables: the points, and the cam that refers to them."""
    initial = [", ".join(f"{name} := {value}" for name, value in row.items()) for row in rows(handed.table, FIELDS)]
    name, n = f"Cam_{handed.name}", len(initial)
    start, end = (literal(handed.table.x[k]) for k in (0, -1))
    body = ",\n".join(f"    ({point})" for point in initial)
    return (
        f"{comments(handed.header)}{{attribute 'linkalways'}}\nVAR_GLOBAL\n"
        f"  {name}_A : ARRAY[0..{n - 1}] OF SMC_CAMXYVA := [\n{body}];\n"
        f"  {name} : MC_CAM_REF := (byType := 3, xStart := {start}, xEnd := {end}, nElements := {n},\n"
        f"    nTappets := 0, strCAMName := '{name}', pce := ADR({name}_A), xPartofLM := TRUE);\nEND_VAR\n"
    )


def write_table(handed: Handed) -> str:
    """Return the type of the table, the table, and the cam that refers to it."""
    table, n, name = handed.table, len(handed.table.x), f"Cam_{handed.name}"
    kind = f"SMC_CAMTable_LREAL_{n}_2"
    body = ",\n".join(f"    [{row['x']}, {row['y']}]" for row in rows(table, ("x", "y")))
    ends = dict(zip(EDGES, (span(table.x), span(table.y)) * 2, strict=True))
    limits = ", ".join(f"{edge}Min := {low}, {edge}Max := {high}" for edge, (low, high) in ends.items())
    start, end = (literal(table.x[k]) for k in (0, -1))
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
    return literal(-reach if values.min() < 0.0 else 0.0), literal(reach)


def write_switches(handed: HandedTracks) -> str:
    """Return a list of global variables: the times, and the reference that leads to them."""
    texts = [(str(number), *(literal(x) for x in ends)) for number, *ends in handed.times]
    told = [", ".join(f"{name} := {value}" for name, value in zip(SWITCHED, row, strict=True)) for row in texts]
    body = ",\n".join(f"    ({one}, AxisDirection := 0, CamSwitchMode := 0)" for one in told)
    name, n = handed.name, len(told)
    return (
        f"{comments([*handed.header, *handed.called])}VAR_GLOBAL\n"
        f"  {name}_S : ARRAY[1..{n}] OF MC_CAMSWITCH_TR := [\n{body}];\n"
        f"  {name} : MC_CAMSWITCH_REF := (NoOfSwitches := {n}, CamSwitchPtr := ADR({name}_S));\nEND_VAR\n"
    )


def read_switches(text: str) -> list[Track]:
    """Return the tracks of a Structured Text."""
    times = list(zip(*(column.tolist() for column in grouped(text, SWITCHED)), strict=True))
    counted(text, "NoOfSwitches", len(times))
    return gathered(text, times)


TAPPETS = Tappets(
    "codesys switches", "MC_CAMSWITCH_TR for MC_DigitalCamSwitch", write_switches, read_switches, tracks=32
)

TARGETS = (
    Target(
        "codesys", "CODESYS SoftMotion, SMC_CAMXYVA in Structured Text", ".st", ("x", "y", "y'", "y''"),
        ("quintics",), write, lambda text: points(text, grouped(text, FIELDS), "nElements"),
        points=(2, 32_767), tappets=TAPPETS,
    ),
    Target(
        "codesys-table", "CODESYS SoftMotion, table of pairs, cubic, in Structured Text", ".st", ("x", "y"),
        (*SPLINES, LOCAL), write_table, lambda text: points(text, pairs(text, "Table := [", "]]"), "nElements"),
        points=(4, 32_767),
    ),
)  # fmt: skip
