"""Switches of Rockwell Logix: an OUTPUT_CAM array as a Tag of L5X, for MAOC."""

from __future__ import annotations

from xml.etree.ElementTree import Element

import numpy as np

from workbook.controllers.number import REAL, literal
from workbook.controllers.tappets import HandedTracks, Tappets, Track, gathered
from workbook.controllers.target import Claim
from workbook.controllers.xml import parsed
from workbook.errors import TargetError

MANUAL = "Rockwell MOTION-RM002H-EN-P"
POSITION = "1"
MEMBERS = {"OutputBit": "DINT", "LatchType": "DINT", "UnlatchType": "DINT", "Left": "REAL", "Right": "REAL",
           "Duration": "REAL", "EnableType": "DINT", "EnableBit": "DINT"}  # fmt: skip
RADIX = {"DINT": "Decimal", "REAL": "Float"}


def write(handed: HandedTracks) -> str:
    """Return the tag of the array; a time past the end of the cycle is two elements, as left must be below right."""
    rows = [(number - 1, low, high) for number, begin, end in handed.times for low, high in parted(begin, end, handed)]
    told = "\n".join(line.replace("--", "- -") for line in (*handed.header, *handed.called))
    elements = "".join(element(k, *row) for k, row in enumerate(rows))
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<!--\n{told}\n-->\n<Tags>\n'
        f'<Tag Name="{handed.name}" TagType="Base" DataType="OUTPUT_CAM" Dimensions="{len(rows)}" Constant="false" '
        f'ExternalAccess="Read/Write">\n<Data Format="Decorated">\n'
        f'<Array DataType="OUTPUT_CAM" Dimensions="{len(rows)}">\n{elements}</Array>\n</Data>\n</Tag>\n</Tags>\n'
    )


def parted(begin: float, end: float, handed: HandedTracks) -> list[tuple[float, float]]:
    """Return a time as ranges from left to right."""
    return [(begin, end)] if begin < end else [(begin, handed.cycle), (0.0, end)]


def element(k: int, bit: int, low: float, high: float) -> str:
    """Return one element of the array: on from left to right, by position."""
    ends = (literal(REAL.text(x)).replace("E", "e") for x in (low, high))
    values = (str(bit), POSITION, POSITION, *ends, "0.0", "0", "0")
    members = "".join(f'<DataValueMember Name="{name}" DataType="{kind}" Radix="{RADIX[kind]}" Value="{value}"/>'
                      for (name, kind), value in zip(MEMBERS.items(), values, strict=True))  # fmt: skip
    return f'<Element Index="[{k}]"><Structure DataType="OUTPUT_CAM">{members}</Structure></Element>\n'


def read(text: str) -> list[Track]:
    """Return the tracks of the one tag of type OUTPUT_CAM."""
    cams = [tag for tag in parsed(text).iter("Tag") if tag.get("DataType") == "OUTPUT_CAM"]
    if len(cams) != 1:
        raise TargetError(f"{len(cams)} tags of type OUTPUT_CAM; expected one in a file")
    rows = [ranged(k, one) for k, one in enumerate(cams[0].iter("Element"))]
    told = cams[0].get("Dimensions", "")
    if told.isdecimal() and int(told[:9]) != len(rows):
        raise TargetError(f"Dimensions is {told[:9]}, {len(rows)} elements follow; expected as many")
    return gathered(text, rows)


def ranged(k: int, one: Element) -> tuple[int, float, float]:
    """Return the track of an element, and from where to where it is on."""
    held = {member.get("Name", ""): member.get("Value", "") for member in one.iter("DataValueMember")}
    if (held.get("LatchType"), held.get("UnlatchType")) != (POSITION, POSITION):
        raise TargetError(f"element {k}: it does not switch by position; expected LatchType and UnlatchType {POSITION}")
    try:
        bit, low, high = int(held["OutputBit"]), float(held["Left"]), float(held["Right"])
    except (KeyError, ValueError):
        raise TargetError(f"element {k}: expected numbers for OutputBit, Left and Right") from None
    if not low < high:
        raise TargetError(f"element {k}: Left is {low:.9g}, Right {high:.9g}; expected Left below Right")
    ends = REAL.rounded(np.array([low, high])).tolist()
    return bit + 1, ends[0], ends[1]


TAPPETS = Tappets(
    "OUTPUT_CAM array for MAOC, as a Tag of L5X",
    write,
    read,
    (
        Claim("switches: OutputBit 0 to 31, LatchType and UnlatchType 1 by position, Left below Right", "documented",
              f"{MANUAL}, p. 293, 632"),
        Claim("switches: Duration, EnableType and EnableBit follow, and are not used", "probable", f"{MANUAL}, p. 293"),
        Claim("switches: of one that is on past the end of the cycle, two elements meet there without a pulse",
              "untested", "no document says it"),
    ),
    number=REAL,
    tracks=32,
)  # fmt: skip
