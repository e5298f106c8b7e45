"""Switches of Beckhoff TwinCAT: MC_CamSwitch in Structured Text, an array for each MC_DigitalCamSwitch."""

from __future__ import annotations

import re

from workbook.controllers.number import LREAL, literal
from workbook.controllers.structured import assigned, columns, comments, stripped
from workbook.controllers.tappets import HandedTracks, Tappets, Track, gathered
from workbook.controllers.target import Claim
from workbook.errors import TargetError

FIELDS = ("FirstOnPosition", "LastOnPosition")
INDEXED = re.compile(
    r"_(\d{1,4})_S\[(\d{1,9})\]\s{0,9}\.\s{0,9}([A-Za-z_]\w{0,60})\s{0,9}:=\s{0,9}([^,;()\[\]\s]{1,40})"
)
COUNTED = re.compile(r"_(\d{1,4})\.NumberOfSwitches\s{0,9}:=\s{0,9}(\d{1,9})")
INFOSYS = "Beckhoff Infosys, TF5065 TC3 PLC Motion Control XFC"


def write(handed: HandedTracks) -> str:
    """Return the variables, and the assignments of each time and of each track's reference."""
    declared, lines = [], []
    for one in (track for track in handed.tracks if track.on):
        name, n = f"{handed.name}_{one.number}", len(one.on)
        declared += [f"  {name}_S : ARRAY[1..{n}] OF MC_CamSwitch;", f"  {name} : CAMSWITCH_REF;"]
        for k, ends in enumerate(one.on, 1):
            fields = dict(zip(FIELDS, (literal(LREAL.text(x)) for x in ends), strict=True))
            kind = {"AxisDirection": "CAMSWITCHDIRECTION_BOTH", "CamSwitchMode": "CAMSWITCHMODE_POSITION"}
            lines.append(assigned(f"{name}_S[{k}]", fields | kind))
        lines.append(f"{name}.NumberOfSwitches := {n}; {name}.pSwitches := ADR({name}_S); "
                     f"{name}.SizeOfSwitches := SIZEOF({name}_S);")  # fmt: skip
    variables = "".join(f"{line}\n" for line in declared)
    head = comments([*handed.header, *handed.called])
    return f"{head}VAR\n{variables}END_VAR\n" + "".join(f"{line}\n" for line in lines)


def read(text: str) -> list[Track]:
    """Return the tracks that are assigned."""
    plain = stripped(text)
    arrays: dict[int, list[tuple[int, str, str]]] = {}
    for number, index, field, value in INDEXED.findall(plain):
        arrays.setdefault(int(number), []).append((int(index), field, value))
    told = {int(number): int(count) for number, count in COUNTED.findall(plain)}
    times = []
    for number, found in arrays.items():
        begins, ends = columns(found, FIELDS)
        if told.get(number, len(begins)) != len(begins):
            raise TargetError(f"track {number}: {told[number]} switches are told, {len(begins)} follow")
        times += [(number, *both) for both in zip(begins.tolist(), ends.tolist(), strict=True)]
    return gathered(text, times)


TAPPETS = Tappets(
    "MC_CamSwitch, an array for each MC_DigitalCamSwitch",
    write,
    read,
    (
        Claim("switches: FirstOnPosition, LastOnPosition; inverted where the last is below the first", "documented",
              f"{INFOSYS}, 9826984203"),
        Claim("switches: CAMSWITCH_REF, at most 1,000 of a track; a track an instance", "documented",
              f"{INFOSYS}, 9826994699, 9826014859"),
        Claim("switches: positions of a modulo axis are taken as angles of its turn", "untested",
              "no document at hand says it"),
    ),
    times=1000,
)  # fmt: skip
