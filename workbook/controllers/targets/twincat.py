"""Beckhoff TwinCAT in Structured Text: motion function points of NC2, a position table, switches of MC_CamSwitch."""

import re

from workbook.controllers.number import literal
from workbook.controllers.structured import assigned, columns, comments, indexed, pairs, points, rows, stripped
from workbook.controllers.table import SPLINES, equidistant
from workbook.controllers.target import Claim, Handed, HandedTracks, Tappets, Target, Track, gathered
from workbook.errors import TargetError

FIELDS = ("MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc")
SWITCHED = ("FirstOnPosition", "LastOnPosition")
INDEXED = re.compile(
    r"_(\d{1,4})_S\[(\d{1,9})\]\s{0,9}\.\s{0,9}([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})"
)
COUNTED = re.compile(r"_(\d{1,4})\.NumberOfSwitches\s{0,9}:=\s{0,9}(\d{1,9})")
INFOSYS = "Beckhoff Infosys, TF5050 TC3 NC Camming"
INFOSYS_XFC = "Beckhoff Infosys, TF5065 TC3 PLC Motion Control XFC"


def write(handed: Handed) -> str:
    """Return the variables, and the assignments of each point and of the reference."""
    n, name, lines = len(handed.table.x), f"Cam_{handed.name}", []
    for k, row in enumerate(rows(handed.table, FIELDS), 1):
        kind = "ACTIVATION" if k == 1 else "MOTION"
        head = {"PointIndex": str(k), "FunctionType": "MOTIONFUNCTYPE_POLYNOM5_MM",
                "PointType": f"MOTIONPOINTTYPE_{kind}", "RelIndexNextPoint": str(int(k < n))}  # fmt: skip
        lines.append(assigned(f"{name}_P[{k}]", head | row | {"SlaveJerk": "0.0"}))
    body = "\n".join(lines)
    last = {"pArray": f"ADR({name}_P)", "ArraySize": f"SIZEOF({name}_P)", "TableType": "MC_TABLETYPE_MOTIONFUNCTION",
            "NoOfRows": str(n), "NoOfColumns": "1"}  # fmt: skip
    reference = "".join(f"{name}.{field} := {value};\n" for field, value in last.items())
    declared = f"VAR\n  {name}_P : ARRAY[1..{n}] OF MC_MotionFunctionPoint;\n  {name} : MC_CAM_REF;\nEND_VAR\n"
    return f"{comments(handed.header)}{declared}{body}\n{reference}"


def write_table(handed: Handed) -> str:
    """Return the table as an initialised array, and the assignments of its reference."""
    table, n, name = handed.table, len(handed.table.x), f"Cam_{handed.name}"
    body = ",\n".join(f"    {row['x']}, {row['y']}" for row in rows(table, ("x", "y")))
    kind = "EQUIDISTANT" if equidistant(table.x) else "NONEQUIDISTANT"
    return (
        f"{comments(handed.header)}VAR\n  {name}_T : ARRAY[0..{n - 1}, 0..1] OF LREAL := [\n{body}];\n"
        f"  {name} : MC_CAM_REF;\nEND_VAR\n{name}.pArray := ADR({name}_T); {name}.ArraySize := SIZEOF({name}_T); "
        f"{name}.TableType := MC_TABLETYPE_{kind};\n{name}.NoOfRows := {n}; {name}.NoOfColumns := 2;\n"
    )


def write_switches(handed: HandedTracks) -> str:
    """Return the variables, and the assignments of each time and of each track's reference."""
    declared, lines = "", ""
    for one in (track for track in handed.tracks if track.on):
        name, n = f"{handed.name}_{one.number}", len(one.on)
        declared += f"  {name}_S : ARRAY[1..{n}] OF MC_CamSwitch;\n  {name} : CAMSWITCH_REF;\n"
        for k, ends in enumerate(one.on, 1):
            fields = dict(zip(SWITCHED, (literal(x) for x in ends), strict=True))
            kind = {"AxisDirection": "CAMSWITCHDIRECTION_BOTH", "CamSwitchMode": "CAMSWITCHMODE_POSITION"}
            lines += f"{assigned(f'{name}_S[{k}]', fields | kind)}\n"
        lines += (f"{name}.NumberOfSwitches := {n}; {name}.pSwitches := ADR({name}_S); "
                  f"{name}.SizeOfSwitches := SIZEOF({name}_S);\n")  # fmt: skip
    return f"{comments([*handed.header, *handed.called])}VAR\n{declared}END_VAR\n{lines}"


def read_switches(text: str) -> list[Track]:
    """Return the tracks that are assigned."""
    plain = stripped(text)
    arrays: dict[int, list[tuple[int, str, str]]] = {}
    for number, index, field, value in INDEXED.findall(plain):
        arrays.setdefault(int(number), []).append((int(index), field, value))
    told = {int(number): int(count) for number, count in COUNTED.findall(plain)}
    times = []
    for number, found in arrays.items():
        begins, ends = columns(found, SWITCHED)
        if told.get(number, len(begins)) != len(begins):
            raise TargetError(f"track {number}: {told[number]} switches are told, {len(begins)} follow")
        times += [(number, *both) for both in zip(begins.tolist(), ends.tolist(), strict=True)]
    return gathered(text, times)


TAPPETS = Tappets(
    "MC_CamSwitch, an array for each MC_DigitalCamSwitch", write_switches, read_switches, (
        Claim("switches: FirstOnPosition, LastOnPosition; inverted where the last is below the first", "documented",
              f"{INFOSYS_XFC}, 9826984203"),
        Claim("switches: CAMSWITCH_REF, at most 1,000 of a track; a track an instance", "documented",
              f"{INFOSYS_XFC}, 9826994699, 9826014859"),
        Claim("switches: positions of a modulo axis are taken as angles of its turn", "untested",
              "no document at hand says it"),
    ),
    times=1000,
)  # fmt: skip

TARGETS = (
    Target(
        "twincat", "Beckhoff TwinCAT NC2, motion function points in Structured Text", ".st", ("x", "y", "y'", "y''"),
        ("quintics",), write, lambda text: points(text, indexed(text, FIELDS), "NoOfRows"), (
            Claim("fields of MC_MotionFunctionPoint and MC_CAM_REF", "documented",
                  f"{INFOSYS}, 1003721995, 1003586955"),
            Claim("POLYNOM5_MM (15): degree 5 from motion to motion, of the segment that starts here", "documented",
                  f"{INFOSYS}, 1003744011"),
            Claim("y' and y'' are derivatives by the master", "probable", "comments Y', Y'' in the declaration"),
            Claim("PointType of the first point (ACTIVATION), RelIndexNextPoint of the last (0)", "untested",
                  "as one public generator writes them"),
        ),
        points=(2, 65_535), tappets=TAPPETS,
    ),
    Target(
        "twincat-table", "Beckhoff TwinCAT, position table in Structured Text", ".st", ("x", "y"), SPLINES,
        write_table, lambda text: points(text, pairs(text, ":= [", "]"), "NoOfRows"), (
            Claim("rows of master and slave, LREAL, the master in every row", "documented", f"{INFOSYS}, 1003586955"),
            Claim("TableType: EQUIDISTANT (10) at equal steps, else NONEQUIDISTANT (11)", "documented",
                  f"{INFOSYS}, 1003586955"),
            Claim("a spline needs 4 rows or more, at most 65,535", "documented", "Beckhoff Infosys, Table Errors"),
            Claim("the spline is chosen at coupling; what tangential and cyclic mean in formulas", "untested",
                  f"{INFOSYS}, 1003709323 names them only"),
        ),
        points=(4, 65_535),
    ),
)  # fmt: skip
