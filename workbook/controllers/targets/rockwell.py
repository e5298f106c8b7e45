"""Rockwell Logix: a CAM array, and switches as an OUTPUT_CAM array, as Tags of L5X; reads CAM_PROFILE too."""

import re
from collections.abc import Iterable
from xml.etree.ElementTree import Element, ParseError, fromstring

import numpy as np

from engine.cams.interpolation import straight
from engine.motion.profile import CamProfile
from workbook.controllers.table import MOST_POINTS, Table
from workbook.controllers.target import SwitchExport, Tappets, Target, Track, facts_of, tracks_of_rows
from workbook.controllers.texts import DINT, REAL, literal
from workbook.errors import TargetError

MOST = 400_000  # tags; a CAM of 10,000 points has 70,000
NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
ROW = re.compile(r"\[([^\[\]]{1,400})\]")
SLOPES = ("StartSlope", "EndSlope")
PROFILE_ROW = 14  # integers
CALCULATED = 2
POSITION = "1"


def elements(table: Table) -> list[tuple[str, str, int]]:
    """Return master, slave and whether a cubic begins there, of each point."""
    lines = np.append(table.straight, False) if table.straight is not None else np.zeros(len(table.x), dtype=bool)
    return [(real(x), real(y), int(not line)) for x, y, line in zip(table.x, table.y, lines, strict=True)]


def split_at_cycle_end(handed: SwitchExport) -> list[tuple[int, float, float]]:
    """Return the times; a time past the end of the cycle as two, as left must be below right."""
    return [
        (track, low, high)
        for track, begin, end in handed.times
        for low, high in ([(begin, end)] if begin < end else [(begin, handed.cycle), (0.0, end)])
    ]


def remark(text: str) -> str:
    """Return a text as a comment of XML has it, without two hyphens in a row."""
    return re.sub("-(?=-)", "- ", text)


def real(value: float) -> str:
    """Return a REAL's text with a point."""
    return literal(value, REAL).replace("E", "e")


def read(text: str) -> Table:
    """Return the points of the only tag of type CAM or CAM_PROFILE; raise TargetError where its two forms differ."""
    tags, cam = only_tag(text, "CAM", "CAM_PROFILE")
    data = next((data.text or "" for data in cam.iter("Data") if data.get("Format") == "L5K"), "")
    packed = [[field.strip() for field in row.split(",")] for row in ROW.findall(data)[: MOST_POINTS + 1]]
    if cam.get("DataType") == "CAM_PROFILE":
        return profile_table(packed)
    rows = [[member.get("Value", "") for member in element.iter("DataValueMember")] for element in cam.iter("Element")]
    given = [numbers(k, row) for k, row in enumerate(rows or packed)]
    if rows and packed and given != [numbers(k, row) for k, row in enumerate(packed)]:
        raise TargetError("the two forms of the tag's data, L5K and Decorated, differ; expected the same points")
    require_dimensions(cam, len(given))
    x, y, kinds = np.array(given).reshape(-1, 3).T
    slopes = end_slopes(tags, cam.get("Name", ""))
    return Table(REAL.rounded(x), REAL.rounded(y), slopes=slopes, straight=kinds[:-1] == 0.0)


def end_slopes(tags: Iterable[Element], cam: str) -> tuple[float, float] | None:
    """Return the slopes at both ends of a cam, which have tags of their own; None where there are no such tags."""
    values = {tag.get("Name"): next((member.get("Value", "") for member in tag.iter("DataValue")), "") for tag in tags}
    names = [f"{cam}_{which}" for which in SLOPES]
    if not all(name in values for name in names):
        return None
    for name in names:
        if not NUMBER.fullmatch(values[name]):
            raise TargetError(f"{name} is {values[name][:40]!r}; expected a number")
    first, last = REAL.rounded(np.array([float(values[name]) for name in names])).tolist()
    return first, last


def only_tag(text: str, *kinds: str) -> tuple[list[Element], Element]:
    """Return the tags of an XML text, and that of these types; raise TargetError for none, several, and entities."""
    if "<!DOCTYPE" in text:
        raise TargetError("it declares a document type or entities, which no engineering tool writes")
    if text.count("<") > MOST:
        raise TargetError(f"it has more than {MOST:,} tags; expected a file of one cam")
    try:
        tags = list(fromstring(text).iter("Tag"))
    except (ParseError, ValueError) as error:
        raise TargetError(f"it is not well-formed XML ({error})") from None
    matching = [tag for tag in tags if tag.get("DataType") in kinds]
    if len(matching) != 1:
        names = ", ".join(str(tag.get("Name"))[:40] for tag in matching[:5]) or "none"
        raise TargetError(f"{len(matching)} tags of type {' or '.join(kinds)} ({names}); expected one in a file")
    return tags, matching[0]


def require_dimensions(cam: Element, count: int) -> None:
    """Raise TargetError where a tag tells of another number of elements."""
    size = cam.get("Dimensions", "")
    if size.isascii() and size.isdecimal() and int(size[:9]) != count:
        raise TargetError(f"Dimensions is {size[:9]}, {count} elements follow; expected as many")


def numbers(k: int, row: list[str]) -> list[float]:
    """Return master, slave and segment type of an element."""
    if len(row) != 3 or not all(map(NUMBER.fullmatch, row)):
        raise TargetError(f"element {k}: {', '.join(row)[:60]!r}; expected master, slave and segment type")
    master, slave, kind = map(float, row)
    if kind not in (0.0, 1.0):
        raise TargetError(f"element {k}: segment type {kind:g}; expected 0 (linear) or 1 (cubic)")
    return [master, slave, kind]


def profile_table(rows: list[list[str]]) -> Table:
    """Return the polynomials Slave + C0 + C1 d + C2 d² + C3 d³ of a CAM_PROFILE: of 64 bits each, high integer, low."""
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


def read_switches(text: str) -> list[Track]:
    """Return the tracks of the only tag of type OUTPUT_CAM."""
    _, cam = only_tag(text, "OUTPUT_CAM")
    rows = []
    for k, element in enumerate(cam.iter("Element")):
        held = {member.get("Name", ""): member.get("Value", "") for member in element.iter("DataValueMember")}
        if (held.get("LatchType"), held.get("UnlatchType")) != (POSITION, POSITION):
            expected = f"expected LatchType and UnlatchType {POSITION}"
            raise TargetError(f"element {k}: it does not switch by position; {expected}")
        try:
            bit, low, high = int(held["OutputBit"]), float(held["Left"]), float(held["Right"])
        except (KeyError, ValueError):
            raise TargetError(f"element {k}: expected numbers for OutputBit, Left and Right") from None
        if not low < high:
            raise TargetError(f"element {k}: Left is {low:.9g}, Right {high:.9g}; expected Left below Right")
        rows.append((bit + 1, *REAL.rounded(np.array([low, high])).tolist()))
    require_dimensions(cam, len(rows))
    return tracks_of_rows(text, rows)


TAPPETS = Tappets(**facts_of("rockwell switches"), read=read_switches, number=REAL)
TARGETS = (Target(**facts_of("rockwell"), read=read, number=REAL, exact=straight, tappets=TAPPETS),)
