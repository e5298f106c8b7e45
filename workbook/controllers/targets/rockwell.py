"""Rockwell Logix: a CAM array, and switches as an OUTPUT_CAM array, as Tags of L5X; reads CAM_PROFILE too."""

import re
from collections.abc import Sequence
from xml.etree.ElementTree import Element, ParseError, fromstring

import numpy as np

from engine.cams.interpolation import straight
from engine.motion.pieces import CamProfile
from workbook.controllers.number import DINT, REAL, literal
from workbook.controllers.table import MOST_POINTS, Table
from workbook.controllers.target import Handed, HandedTracks, Tappets, Target, Track, gathered
from workbook.errors import TargetError

MOST = 400_000  # tags; a CAM of 10,000 points has 70,000
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
ROW = re.compile(r"\[([^\[\]]{1,400})\]")
SLOPES = ("StartSlope", "EndSlope")
PROFILE_ROW = 14  # integers
CALCULATED = 2
POSITION = "1"
MEMBERS = {
    "CAM": {"Master": "REAL", "Slave": "REAL", "SegmentType": "DINT"},
    "OUTPUT_CAM": {"OutputBit": "DINT", "LatchType": "DINT", "UnlatchType": "DINT", "Left": "REAL", "Right": "REAL",
                   "Duration": "REAL", "EnableType": "DINT", "EnableBit": "DINT"},
}  # fmt: skip
RADIX = {"DINT": "Decimal", "REAL": "Float"}


def write(handed: Handed) -> str:
    """Return the tag of the array, and a tag for each slope, which are arguments of MCCP."""
    table, name = handed.table, f"Cam_{handed.name}"
    lines = np.append(table.straight, False) if table.straight is not None else np.zeros(len(table.x), dtype=bool)
    rows = [(real(x), real(y), str(int(not line))) for x, y, line in zip(table.x, table.y, lines, strict=True)]
    told = "\n".join(re.sub("-(?=-)", "- ", line) for line in handed.header)
    packed = ",".join(f"[{','.join(row)}]" for row in rows)
    slopes = "".join(slope(f"{name}_{which}", value)
                     for which, value in zip(SLOPES, table.slopes or (0.0, 0.0), strict=True))  # fmt: skip
    points = tag(name, "CAM", rows, f'<Data Format="L5K"><![CDATA[[{packed}]]]></Data>\n')
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<!--\n{told}\nThe slopes are arguments of MCCP.\n-->\n<Tags>\n'
        f"{points}{slopes}</Tags>\n"
    )


def real(value: float) -> str:
    """Return a REAL's text with a point."""
    return literal(value, REAL).replace("E", "e")


def tag(name: str, kind: str, rows: Sequence[Sequence[str]], packed: str = "") -> str:
    """Return the tag of an array, its elements in their decorated form."""
    elements = ""
    for k, row in enumerate(rows):
        members = "".join(f'<DataValueMember Name="{member}" DataType="{of}" Radix="{RADIX[of]}" Value="{value}"/>'
                          for (member, of), value in zip(MEMBERS[kind].items(), row, strict=True))  # fmt: skip
        elements += f'<Element Index="[{k}]"><Structure DataType="{kind}">{members}</Structure></Element>\n'
    return (
        f'<Tag Name="{name}" TagType="Base" DataType="{kind}" Dimensions="{len(rows)}" Constant="false" '
        f'ExternalAccess="Read/Write">\n{packed}<Data Format="Decorated">\n'
        f'<Array DataType="{kind}" Dimensions="{len(rows)}">\n{elements}</Array>\n</Data>\n</Tag>\n'
    )


def slope(name: str, value: float) -> str:
    """Return the tag of a slope."""
    return (
        f'<Tag Name="{name}" TagType="Base" DataType="REAL" Radix="Float" Constant="false" '
        f'ExternalAccess="Read/Write">\n<Data Format="Decorated"><DataValue DataType="REAL" Radix="Float" '
        f'Value="{real(value)}"/></Data>\n</Tag>\n'
    )


def read(text: str) -> Table:
    """Return the points of the one tag of type CAM or CAM_PROFILE; raise TargetError where its two forms differ."""
    tags, cam = only_tag(text, "CAM", "CAM_PROFILE")
    data = next((data.text or "" for data in cam.iter("Data") if data.get("Format") == "L5K"), "")
    packed = [[field.strip() for field in row.split(",")] for row in ROW.findall(data)[: MOST_POINTS + 1]]
    if cam.get("DataType") == "CAM_PROFILE":
        return profile_table(packed)
    rows = [[member.get("Value", "") for member in one.iter("DataValueMember")] for one in cam.iter("Element")]
    given = [numbers(k, row) for k, row in enumerate(rows or packed)]
    if rows and packed and given != [numbers(k, row) for k, row in enumerate(packed)]:
        raise TargetError("the two forms of the tag's data, L5K and Decorated, differ; expected the same points")
    require_dimensions(cam, len(given))
    x, y, kinds = np.array(given).reshape(-1, 3).T
    slopes = slopes_of(tags, str(cam.get("Name")))
    return Table(REAL.rounded(x), REAL.rounded(y), slopes=slopes, straight=kinds[:-1] == 0.0)


def only_tag(text: str, *kinds: str) -> tuple[list[Element], Element]:
    """Return the tags of a text, and the one of these types; raise TargetError where it is not one."""
    tags = list(parsed(text).iter("Tag"))
    found = [tag for tag in tags if tag.get("DataType") in kinds]
    if len(found) != 1:
        said = ", ".join(str(tag.get("Name"))[:40] for tag in found[:5]) or "none"
        raise TargetError(f"{len(found)} tags of type {' or '.join(kinds)} ({said}); expected one in a file")
    return tags, found[0]


def require_dimensions(cam: Element, count: int) -> None:
    """Raise TargetError where a tag tells of another number of elements."""
    told = cam.get("Dimensions", "")
    if told.isascii() and told.isdecimal() and int(told[:9]) != count:
        raise TargetError(f"Dimensions is {told[:9]}, {count} elements follow; expected as many")


def numbers(k: int, row: list[str]) -> list[float]:
    """Return master, slave and segment type of an element."""
    if len(row) != 3 or not all(map(NUMBER.fullmatch, row)):
        raise TargetError(f"element {k}: {', '.join(row)[:60]!r}; expected master, slave and segment type")
    master, slave, kind = map(float, row)
    if kind not in (0.0, 1.0):
        raise TargetError(f"element {k}: segment type {kind:g}; expected 0 (linear) or 1 (cubic)")
    return [master, slave, kind]


def slopes_of(tags: list[Element], name: str) -> tuple[float, float] | None:
    """Return the slopes that stand in tags of their own; None where they are not in the file."""
    held = {tag.get("Name"): next((one.get("Value", "") for one in tag.iter("DataValue")), "") for tag in tags}
    names = [f"{name}_{which}" for which in SLOPES]
    if not all(one in held for one in names):
        return None
    for one in names:
        if not NUMBER.fullmatch(held[one]):
            raise TargetError(f"{one} is {held[one][:40]!r}; expected a number")
    first, last = REAL.rounded(np.array([float(held[one]) for one in names])).tolist()
    return first, last


def profile_table(rows: list[list[str]]) -> Table:
    """Return the polynomials of a CAM_PROFILE: y = Slave + C0 + C1 d + C2 d² + C3 d³, d from an element's master.

    Each is a number of 64 bits in two integers, high then low.
    """
    words = []
    for k, row in enumerate(rows):
        if len(row) != PROFILE_ROW or not all(re.fullmatch(r"-?[0-9]{1,10}", field) for field in row):
            raise TargetError(f"element {k}: expected {PROFILE_ROW} integers of a CAM_PROFILE")
        if int(row[0]) < CALCULATED:
            break
        words.append([int(row[i]) for i in (1, 2, 3, 4, *range(6, PROFILE_ROW))])
    if len(words) < 2:
        raise TargetError(f"{len(words)} calculated elements of a CAM_PROFILE; expected two or more")
    if np.abs(words).max() > DINT.largest + 1:
        raise TargetError(f"{np.abs(words).max()}: expected integers of 32 bits")
    x, y, *c = np.array(words).astype(">i4").view(">f8").astype(np.float64).T
    if np.any(np.diff(x) <= 0.0):
        raise TargetError("the masters of the CAM_PROFILE do not rise from element to element")
    powers = np.column_stack([y + c[0], *c[1:]])[:-1]
    return Table(x, y, profile=CamProfile(x, x[:-1], powers, np.zeros((len(powers), 0, 3))))


def write_switches(handed: HandedTracks) -> str:
    """Return the tag of the array; a time past the end of the cycle is two elements, as left must be below right."""
    rows = []
    for number, begin, end in handed.times:
        for low, high in [(begin, end)] if begin < end else [(begin, handed.cycle), (0.0, end)]:
            rows.append((str(number - 1), POSITION, POSITION, real(low), real(high), "0.0", "0", "0"))
    told = "\n".join(line.replace("--", "- -") for line in (*handed.header, *handed.called))
    head = f'<?xml version="1.0" encoding="UTF-8"?>\n<!--\n{told}\n-->\n<Tags>\n'
    return f"{head}{tag(handed.name, 'OUTPUT_CAM', rows)}</Tags>\n"


def read_switches(text: str) -> list[Track]:
    """Return the tracks of the one tag of type OUTPUT_CAM."""
    _, cam = only_tag(text, "OUTPUT_CAM")
    rows = [ranged(k, one) for k, one in enumerate(cam.iter("Element"))]
    require_dimensions(cam, len(rows))
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


def parsed(text: str) -> Element:
    """Return the root of a text in XML; raise TargetError where it is none, too much, or declares a document type."""
    if "<!DOCTYPE" in text:  # and with it entities
        raise TargetError("it declares a document type or entities, which no engineering tool writes")
    if text.count("<") > MOST:
        raise TargetError(f"it has more than {MOST:,} tags; expected a file of one cam")
    try:
        return fromstring(text)
    except (ParseError, ValueError) as error:
        raise TargetError(f"it is not well-formed XML ({error})") from None


TAPPETS = Tappets(
    "rockwell switches", "OUTPUT_CAM array for MAOC, as a Tag of L5X", write_switches, read_switches,
    number=REAL, tracks=32,
)  # fmt: skip

TARGETS = (
    Target(
        "rockwell", "Rockwell Logix, CAM array as a Tag of L5X", ".xml", ("x", "y", "straight"),
        ("clamped cubic spline",), write, read, number=REAL, points=(2, 10_000), exact=straight, tappets=TAPPETS,
    ),
)  # fmt: skip
