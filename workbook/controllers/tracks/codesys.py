"""Switches of CODESYS SoftMotion: MC_CAMSWITCH_TR in Structured Text, for MC_DigitalCamSwitch."""

from __future__ import annotations

from workbook.controllers.number import LREAL, literal
from workbook.controllers.structured import comments, counted, grouped
from workbook.controllers.tappets import HandedTracks, Tappets, Track, gathered
from workbook.controllers.target import Claim

FIELDS = ("TrackNumber", "FirstOnPosition", "LastOnPosition")
HELP = "Machine Expert V1.2 help, SM3_Basic, MC_CAMSWITCH_TR"


def write(handed: HandedTracks) -> str:
    """Return a list of global variables: the times, and the reference that leads to them."""
    rows = [(str(number), *(literal(LREAL.text(x)) for x in ends)) for number, *ends in handed.times]
    told = [", ".join(f"{name} := {value}" for name, value in zip(FIELDS, row, strict=True)) for row in rows]
    body = ",\n".join(f"    ({one}, AxisDirection := 0, CamSwitchMode := 0)" for one in told)
    name, n = handed.name, len(rows)
    return (
        f"{comments([*handed.header, *handed.called])}VAR_GLOBAL\n"
        f"  {name}_S : ARRAY[1..{n}] OF MC_CAMSWITCH_TR := [\n{body}];\n"
        f"  {name} : MC_CAMSWITCH_REF := (NoOfSwitches := {n}, CamSwitchPtr := ADR({name}_S));\nEND_VAR\n"
    )


def read(text: str) -> list[Track]:
    """Return the tracks of a Structured Text."""
    rows = list(zip(*(column.tolist() for column in grouped(text, FIELDS)), strict=True))
    counted(text, "NoOfSwitches", len(rows))
    return gathered(text, rows)


TAPPETS = Tappets(
    "MC_CAMSWITCH_TR for MC_DigitalCamSwitch",
    write,
    read,
    (
        Claim("switches: TrackNumber 1 to 32, FirstOnPosition, LastOnPosition LREAL; inverted where the first is above "
              "the last; AxisDirection 0: both, CamSwitchMode 0: by position", "documented", HELP),
        Claim("switches: MC_CAMSWITCH_REF has NoOfSwitches and CamSwitchPtr", "probable", "public code that uses it"),
        Claim("switches: the output at the very end of a modulo axis that is on from 0 to its end", "untested",
              "no document says it"),
    ),
    tracks=32,
)  # fmt: skip
