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

from workbook.judging.display.formats import format_sections
from workbook.reading.rows import tag

Flat = dict[str, Any]  # values by the names of elements and attribute that lead to them

COLOURS = frozenset(["color", "fgColor", "bgColor", "srgbClr"])
SAME_COLOURS = {"theme 0": "#FFFFFF", "theme 1": "#000000", "indexed 8": "#000000", "indexed 9": "#FFFFFF"}
OFF = frozenset(["0", "none", "noStrike", "baseline", "general", "normal", "visible", "context", "nextTo"])
# what each program writes as it likes, and what shows nothing
UNTOLD = re.compile(
    r"(axId|crossAx|axPos|style|lang|roundedCorners|scatterStyle|family|idx|order|hMode|wMode|xMode|yMode"
    r"|layoutTarget|showBubbleSize|showLegendKey|showLeaderLines|separator|endParaRPr|extLst|AlternateContent|spc"
    r"|xmlns|bodyPr|numCache|strCache|ptCount|noEndCap|autoTitleDeleted)"
)
EMPTY = frozenset(["left", "right", "top", "bottom", "diagonal", "lstStyle", "round", "t", "r", "cap"])
# of charts' texts
FACES = frozenset(["calibri", "dejavu sans", "liberation sans", "arial", "+mn-lt", "+mj-lt"])
USUAL = {  # what programs take where it is not given, by the last names of its path
    "alignment vertical": "bottom",
    "charset val": "1",
    "protection locked": "1",
    "rPr sz": "1000",
    "defRPr sz": "1000",
    "rPr solidFill srgbClr": "#000000",
    "defRPr solidFill srgbClr": "#000000",
    "spPr solidFill srgbClr": "#FFFFFF",
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
    return {key: value for key, value in flat.items() if not UNTOLD.fullmatch(key.rpartition(" ")[2])}


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
    try:
        return isclose(float(ours), float(theirs), rel_tol=1e-3, abs_tol=SHARE if PLACE.fullmatch(key) else 0.0)
    except (TypeError, ValueError):
        return False


def in_words(flat: Flat) -> str:
    """Return attributes in a line."""
    return ", ".join(f"{name} {value}" for name, value in sorted(flat.items()) if value)
