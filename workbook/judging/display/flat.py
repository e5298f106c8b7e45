"""Attributes of an element of a file and of all within it, as a flat dictionary of normal values.

Fresh builds and files of any program are read by this reader: what is left of their differences, a reader sees.
"""

import re
from collections import Counter
from collections.abc import Callable, Collection, Mapping
from functools import lru_cache
from math import isclose
from types import MappingProxyType
from typing import Any, NamedTuple
from xml.etree.ElementTree import Element

from openpyxl.styles.numbers import BUILTIN_FORMATS, BUILTIN_FORMATS_MAX_SIZE

from workbook.reading.rows import tag

Flat = dict[str, Any]  # values by the names of elements and attribute that lead to them

COLOURS = frozenset(["color", "fgColor", "bgColor", "srgbClr"])
WHITE, BLACK = "#FFFFFF", "#000000"
SAME_COLOURS = {"theme 0": WHITE, "theme 1": BLACK, "indexed 8": BLACK, "indexed 9": WHITE}
OFF = frozenset("0 none noStrike baseline general normal visible context nextTo".split())
# what each program writes as it likes, and what shows nothing
UNTOLD = re.compile(
    r"(axId|crossAx|axPos|style|lang|roundedCorners|scatterStyle|family|idx|order|hMode|wMode|xMode|yMode"
    r"|layoutTarget|showBubbleSize|showLegendKey|showLeaderLines|separator|endParaRPr|extLst|AlternateContent|spc"
    r"|xmlns|bodyPr|numCache|strCache|ptCount|noEndCap|autoTitleDeleted)"
)
EMPTY = frozenset("left right top bottom diagonal lstStyle round t r cap".split())
# of charts' texts
FACES = frozenset(["calibri", "dejavu sans", "liberation sans", "arial", "+mn-lt", "+mj-lt"])
USUAL = {  # what programs take where it is not given, by the last names of its path
    "alignment vertical": "bottom",
    "charset val": "1",
    "protection locked": "1",
    "rPr sz": "1000",
    "defRPr sz": "1000",
    "rPr solidFill srgbClr": BLACK,
    "defRPr solidFill srgbClr": BLACK,
    "spPr solidFill srgbClr": WHITE,
    "plotVisOnly val": "1",
    "prstDash val": "solid",
    "dispBlanksAs val": "gap",
    "orientation val": "minMax",
    "showObjects": "all",
    "showSheetTabs": "1",
    "showZeros": "1",
    "zoomScale": "100",
    "zoomScaleNormal": "100",
}
# of a plot: with its labels or without, as programs like it
PLACE = re.compile(r".*manualLayout . val")
SHARE = 0.2  # of a chart's width or height, to which places of plots are the same


class Shown(NamedTuple):
    """A value with its words: what is compared are cells that a chart draws or names, or what a number format shows."""

    meaning: Any
    words: str

    def __str__(self) -> str:
        """Return the words."""
        return self.words


def flatten(
    element: Element,
    path: str = "",
    leaving: Collection[str] = (),
    sources: Mapping[str, str] = MappingProxyType({}),
    source: Callable[[Element], Any] = str,
) -> Flat:
    """Return the attributes and texts of an element, but for elements of the names ``leaving``.

    ``sources`` names the elements of which ``source`` returns the value.
    """
    name, flat = tag(element), Flat()
    if name in COLOURS:
        flat[path] = colour_name(element.attrib)
    else:
        for key, value in element.attrib.items():
            flat[f"{path} {key.rpartition('}')[2]}"] = normal_value(name, key, value)
    count = Counter[str]()
    for child in element:
        name = tag(child)
        if name in sources:
            flat[f"{path} {sources[name]}".strip()] = source(child)
        if name not in leaving and not UNTOLD.fullmatch(name):
            count[name] += 1
            place = f"{path} {name} {count[name] if count[name] > 1 else ''}".strip()
            flat |= flatten(child, place, leaving, sources, source)
            if text := (child.text or "").strip():
                flat[place] = text
            elif not (len(child) or child.attrib or name in EMPTY):
                flat[f"{place} val"] = "1"  # as an element alone switches on what it is named after
    return {key: text for key, text in flat.items() if not UNTOLD.fullmatch(key.rpartition(" ")[2])}


def colour_name(held: Mapping[str, str]) -> str:
    """Return a colour as ``#`` and six digits, or as its place in a theme or palette; nothing for the program's own."""
    if digits := held.get("rgb") or held.get("val"):
        return f"#{digits[-6:].upper()}"
    kind = next((name for name in ("theme", "indexed") if name in held), "")
    tint = f" tint {held['tint']}" if held.get("tint", "0") not in ("0", "0.0") else ""
    name = f"{kind} {held[kind]}{tint}" if kind else ""
    return "" if name == "indexed 64" else SAME_COLOURS.get(name, name)


def normal_value(element: str, name: str, value: str) -> str:
    """Return the value of an attribute as all programs would write it; nothing where it switches something off."""
    value = {"true": "1", "false": "0"}.get(value, value)
    if name == "typeface":
        return "" if value.casefold() in FACES else value
    if name.endswith("LayoutView") and value.isdecimal() and 30 <= int(value) <= 400:
        return ""  # of which each program has a zoom of its own
    if element == "ln" and name == "w" and value.isdecimal():
        return f"{int(value) / 12_700:.1f}"  # points
    return "" if value in OFF else value


@lru_cache(maxsize=4_000)
def usual_value(key: str) -> str:
    """Return the value of an attribute that is not given."""
    return next((value for end, value in USUAL.items() if f" {key}".endswith(f" {end}")), "")


def is_same(key: str, ours: Any, theirs: Any) -> bool:
    """Whether two values of an attribute show the same."""
    if ours == theirs:
        return True
    if key.endswith("formatCode"):
        return format_sections(ours)[:3] == format_sections(theirs)[:3]
    share = SHARE if PLACE.fullmatch(key) else 0.0
    try:
        return isclose(float(ours), float(theirs), rel_tol=1e-3, abs_tol=share)
    except (TypeError, ValueError):
        return False


def in_words(flat: Flat) -> str:
    """Return attributes in a line."""
    return ", ".join(f"{name} {value}" for name, value in sorted(flat.items()) if value)


TOKEN = re.compile(r"""(?xs)
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | (?P<room>_.|\*[ ]) | \*(?P<filled>.) | \[(?P<bracket>[^\]]*)\]?
    | (?P<end>;) | (?P<text>@|(?i:General|Standard)) | (?P<code>E[+-]|[0?\#.,%/])
    | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgGeE]) | (?P<plain>.)
""")
# a 0 shows in place of a zero
NUMBER = re.compile(r"@|(?=[#?,.]*0)(?:[#?0,]*[#?0])?(?:\.[#?0]*)?(?:E[+-][#?0]+)?")
INK = re.compile(r"(?i)\[(?:black|red|green|blue|magenta|color ?(?:[13-57-9]|[1-4][0-9]|5[0-6]))\]")
# of our digits
LANGUAGE = re.compile(r"\$([^-\]]*)(?:-(?!F800|F400)(?:0?[01])?[0-9A-F]{0,6})?", re.IGNORECASE)


def format_by_number(workbook: Any, number: int) -> str:
    """Return the number format of a number; a format that programs define by their language is named as such."""
    formats, held = workbook._number_formats, number - BUILTIN_FORMATS_MAX_SIZE
    if held >= 0:
        return str(formats[held]) if held < len(formats) else f"undefined format {number}"
    return BUILTIN_FORMATS.get(number, f"format {number} of the reader's language")


@lru_cache(maxsize=4_000)
def format_sections(code: str) -> tuple[str, ...]:
    """Return the parts of a number format (ISO/IEC 29500-1, 18.8.31), each as what it shows however it is escaped.

    Digits stand for themselves, D for codes of dates, ``@`` for General; a sign that is added follows a NUL.
    """
    parts = [""]
    for token in TOKEN.finditer(code):
        kind, text = str(token.lastgroup), token[str(token.lastgroup)]
        language = LANGUAGE.fullmatch(text) if kind == "bracket" else None
        if kind == "end":
            parts.append("")
        elif kind == "bracket" and language is None:
            parts[-1] += f"[{text.casefold()}]"
        elif kind != "room":
            added = "".join(f"\0{sign}" for sign in (language[1] if language else text))
            parts[-1] += {"code": text, "date": "D", "text": "@"}.get(kind, added)
    return tuple(parts)


ROOM = r"(?:\0 |\?)*"  # blanks


@lru_cache(maxsize=4_000)
def plain_number(code: str, unit: str = "") -> tuple[str, ...]:
    """Return the sections of a number format without decimals, separators, colours and the quantity's unit."""
    suffix = "".join(f"\0{sign}" for sign in unit)
    parts = []
    for part in format_sections(code)[:3]:
        bare = NUMBER.sub("N", re.sub(r"(?<=[#?0])\0 (?=[#?0])", "", INK.sub("", part)), count=1)
        bare = bare.replace("\0+", "").replace("\0(N\0)", "\0-N").replace("\0−", "\0-")
        bare = re.sub(r"^(?:\0≈|\0~|\0c\0a\0\.)(?:\0 )?(?=N)", "", bare)
        parts.append("N" if unit and re.fullmatch(rf"N(?:\0 )?{re.escape(suffix)}", bare) else bare)
    # as programs show it by themselves
    negative = [] if parts[1:2] == ["\0-N"] else parts[1:2]
    zero = [part for part in parts[2:] if not re.fullmatch(rf"N|{ROOM}\0[-–—]{ROOM}", part)]
    return (parts[0], *negative, *zero)


def text_section(code: str) -> str:
    """Return the part of a number format by which a text is shown."""
    parts = format_sections(code)
    if len(parts) > 3:
        return parts[3]
    return parts[-1] if "@" in parts[-1] and len(parts[-1]) > 1 else "@"
