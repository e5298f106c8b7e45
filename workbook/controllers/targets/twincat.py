"""Beckhoff TwinCAT in Structured Text: motion function points of NC2, a position table, switches of MC_CamSwitch."""

import re

from workbook.controllers.number import literal
from workbook.controllers.structured import assigned, columns, comments, indexed, pairs, points, rows, stripped
from workbook.controllers.table import SPLINES, equidistant
from workbook.controllers.target import Handed, HandedTracks, Tappets, Target, Track, gathered
from workbook.errors import TargetError

FIELDS = ("MasterPos", "SlavePos", "SlaveVelo", "SlaveAcc")
SWITCHED = ("FirstOnPosition", "LastOnPosition")
INDEXED = re.compile(
    r"_(\d{1,4})_S\[(\d{1,9})\]\s{0,9}\.\s{0,9}([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})"
)
COUNTED = re.compile(r"_(\d{1,4})\.NumberOfSwitches\s{0,9}:=\s{0,9}(\d{1,9})")


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
    "twincat switches", "MC_CamSwitch, an array for each MC_DigitalCamSwitch", write_switches, read_switches,
    times=1000,
)  # fmt: skip

TARGETS = (
    Target(
        "twincat", "Beckhoff TwinCAT NC2, motion function points in Structured Text", ".st", ("x", "y", "y'", "y''"),
        ("quintics",), write, lambda text: points(text, indexed(text, FIELDS), "NoOfRows"),
        points=(2, 65_535), tappets=TAPPETS,
    ),
    Target(
        "twincat-table", "Beckhoff TwinCAT, position table in Structured Text", ".st", ("x", "y"), SPLINES,
        write_table, lambda text: points(text, pairs(text, ":= [", "]"), "NoOfRows"), points=(4, 65_535),
    ),
)  # fmt: skip
