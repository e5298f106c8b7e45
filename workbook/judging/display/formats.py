"""What a number format makes of a value: the number with its sign, which is taste, or anything else; and colours.

A format is taken apart (ISO/IEC 29500-1, 18.8.31) and judged for every value; what is not permitted here is told.
"""

import re
from colorsys import hls_to_rgb, rgb_to_hls
from functools import lru_cache
from typing import Any, NamedTuple
from xml.etree.ElementTree import ParseError, fromstring

from openpyxl import Workbook
from openpyxl.styles.colors import COLOR_INDEX

from workbook.judging.display import permitted
from workbook.judging.display.labels import compare_units
from workbook.judging.report import NOTICE, SHOWN
from workbook.reading.rows import tag

BLACK, WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
GREEN = (75 / 360, 165 / 360)  # hues
COLOURED = 0.2  # saturation and depth from which a colour is one
THEME = ("lt1", "dk1", "lt2", "dk2", "accent1", "accent2", "accent3", "accent4", "accent5", "accent6", "hlink")
OFFICE = dict(zip(THEME, ("FFFFFF", "000000", "EEECE1", "1F497D", "4F81BD", "C0504D", "9BBB59", "8064A2", "4BACC6",
                          "F79646", "0000FF"), strict=True))  # fmt: skip

Colour = tuple[float, float, float]
Look = tuple[Colour | None, Colour | None]  # ink and ground of a cell; None for what cannot be told, as a gradient
USUAL: Look = BLACK, WHITE
TOKEN = re.compile(r"""(?xs)
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | (?P<room>_.|\*[ ]) | \*(?P<filled>.) | \[(?P<bracket>[^\]]*)\]?
    | (?P<end>;) | (?P<text>@|(?i:General|Standard)) | (?P<code>E[+-]|[0?\#.,%/])
    | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgGeE]) | (?P<plain>.)
""")
ADDED = r"((?:\0.)*)"
NUMBER = re.compile(rf"(?s){ADDED}(?P<number>@|(?:[#?0,]*[#?0])?(?:\.[#?0]*)?(?:E[+-][#?0]+)?)(?P<percent>%?){ADDED}")
FRACTION = re.compile(r"[#?0]*/(?:[#?0]|\0[0-9])+")
CONDITION = re.compile(r"(<=|>=|<>|<|>|=)\s*([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)")
COLOUR = re.compile(r"(black|white|red|green|blue|yellow|magenta|cyan)|color ?([0-9]{1,2})", re.IGNORECASE)
BRIGHT = {"white": "FFFFFF", "yellow": "FFFF00", "cyan": "00FFFF"}
LANGUAGE = re.compile(r"\$([^-]*)(?:-(?!F800|F400)(?:0?[01])?[0-9A-F]{0,6})?", re.IGNORECASE)  # of our digits

Remark = tuple[str, str]  # the kind of what is told, and what; both empty where nothing is


class Section(NamedTuple):
    """A part of a format: ``form`` has its codes, D for those of dates, and each sign that is added behind a NUL."""

    form: str = ""
    brackets: tuple[str, ...] = ()

    @property
    def condition(self) -> re.Match[str] | None:
        """The condition under which the part is used."""
        return next(filter(None, map(CONDITION.fullmatch, self.brackets)), None)


@lru_cache(maxsize=4_000)
def sections(code: str) -> tuple[Section, ...]:
    """Return the parts of a number format."""
    found = [Section()]
    for token in TOKEN.finditer(code):
        kind, said = str(token.lastgroup), token[str(token.lastgroup)]
        language = LANGUAGE.fullmatch(said) if kind == "bracket" else None
        if kind == "end":
            found.append(Section())
        elif kind == "bracket" and language is None:
            found[-1] = found[-1]._replace(brackets=(*found[-1].brackets, said))
        elif kind != "room":
            texts = language[1] if language else said
            more = {"code": said, "date": "D", "text": "@"}.get(kind, "".join(f"\0{sign}" for sign in texts))
            found[-1] = found[-1]._replace(form=found[-1].form + more)
    return tuple(found)


@lru_cache(maxsize=10_000)
def format_remark(
    code: str, declared: str, unit: str = "", symbol: str = "", text: bool = False, zeros: bool = False
) -> Remark:
    """Return what is to be told of a format for a text, or for numbers, of which some may round to 0 (``zeros``)."""
    held, ours = sections(code), sections(declared)
    last = held[3] if len(held) > 3 else held[-1] if "@" in held[-1].form else None
    kinds = set()
    if text and last is not None and last != ours[-1]:
        kinds.add("" if last.form == "@" and all(map(is_ink, last.brackets)) else SHOWN)
    numeric = () if text else held[:3] if last is None or len(held) in (1, 4) else held[:-1]
    conditional = any(one.condition for one in numeric)
    for n, one in enumerate(numeric):
        if n >= len(ours) or one != ours[n]:
            negative = bool(one.condition and one.condition[1][0] == "<" and float(one.condition[2]) <= 0)
            kinds.add(number_kind(one, negative if conditional else n, unit, symbol, zeros))
    kind = SHOWN if SHOWN in kinds else NOTICE if conditional or NOTICE in kinds else ""
    return (kind, f"the number format {code}") if kind else ("", "")


def number_kind(part: Section, n: int, unit: str, symbol: str, zeros: bool) -> str:
    """Return of which kind the ``n``-th part is, which shows positive numbers, negative ones, or zero."""
    if not all(is_ink(one) or CONDITION.fullmatch(one) for one in part.brackets):
        return SHOWN
    if n == 2 and re.fullmatch(rf"(?:\0 |\?)*\0[{permitted.DASHES}](?:\0 |\?)*", part.form):
        return ""
    form = re.sub(r"(?<=[#?0])\0 (?=[#?0])", "", part.form)
    if (found := NUMBER.fullmatch(form)) is None or not found["number"]:
        return NOTICE if FRACTION.fullmatch(form) else SHOWN
    before, behind = (found[i].replace("\0", "").strip() for i in (1, 4))
    signed = before[:1] in [*permitted.DASHES, "("]
    sign = signed if n != 1 else not signed and found["number"] != "@"
    rest, behind = before[signed:].strip(), behind.removesuffix(")" if before[:1] == "(" else "").strip()
    named = rest in permitted.NEARLY or rest.rstrip("= ") == symbol
    other = behind and not (unit and compare_units(behind, unit) == "same")
    if sign or not named or (found["percent"] and unit) or other:
        return SHOWN
    return "" if set("0@") & set(found["number"]) else SHOWN if zeros else NOTICE


def is_ink(bracket: str) -> bool:
    """Whether what stands in brackets is a colour that can be read on white."""
    if (found := COLOUR.fullmatch(bracket)) is None:
        return False
    number = int(found[2] or 0) + 7
    code = COLOR_INDEX[number][-6:] if found[2] and number < len(COLOR_INDEX) else BRIGHT.get(bracket.lower(), "0" * 6)
    return (ink := parse_colour(code)) is None or contrast(ink, WHITE) >= permitted.UNSEEN


# Colours and fonts as programs show them: to tell a text that cannot be seen, and a green from a red


class Palette:
    """The colours of a workbook, of its theme and its indexed ones, and the two fonts of its theme."""

    def __init__(self, workbook: Workbook) -> None:
        self._theme, self.fonts = dict(OFFICE), dict[str, str]()
        self._indexed = list(getattr(workbook, "_colors", None) or COLOR_INDEX)  # a file may have its own
        try:
            root = fromstring(workbook.loaded_theme or b"<none/>")
        except ParseError:
            return
        for element in root.iter():
            name = tag(element)
            if name in OFFICE and len(element):  # one that is not given by its digits is no colour that is known
                given = element[0].get("lastClr") or element[0].get("val") or ""
                self._theme[name] = "" if len(element[0]) else given
            elif name in ("majorFont", "minorFont"):
                face = next((one.get("typeface") for one in element if tag(one) == "latin"), None)
                self.fonts[name.removesuffix("Font")] = face or ""

    def colour(self, found: Any, otherwise: Colour | None) -> Colour | None:
        """Return a colour of openpyxl's; ``otherwise`` where there is none, or the program's own is meant."""
        kind = None if found is None else found.type
        if kind == "rgb" and isinstance(found.rgb, str):
            return tinted(parse_colour(found.rgb[-6:]), found.tint)
        if kind == "theme" and found.theme is not None and 0 <= found.theme < len(THEME):
            return tinted(parse_colour(self._theme[THEME[found.theme]]), found.tint)
        if kind == "indexed" and found.indexed is not None and 0 <= found.indexed < len(self._indexed):
            return parse_colour(self._indexed[found.indexed][-6:])
        return otherwise

    def ground(self, fill: Any, otherwise: Colour | None, conditional: bool = False) -> Colour | None:
        """Return the colour of a fill; of a conditional format's, the background is the one that is seen."""
        if fill is None:
            return otherwise
        kind = getattr(fill, "patternType", "gradient")
        if conditional and kind in (None, "solid"):
            unset = fill.bgColor is None or (fill.bgColor.type == "rgb" and fill.bgColor.rgb == "00000000")
            return self.colour(fill.fgColor if unset and kind else None if unset else fill.bgColor, otherwise)
        if kind in (None, "none"):
            return otherwise
        return self.colour(fill.fgColor, None) if kind == "solid" else None

    def look(self, cell: Any) -> Look:
        """Return ink and ground of a cell by its own style; of none black on white."""
        if cell is None or not cell.has_style:
            return USUAL
        return self.colour(cell.font.color, BLACK), self.ground(cell.fill, WHITE)


def parse_colour(text: str) -> Colour | None:
    """Return a colour written in six digits."""
    try:
        red, green, blue = (int(text[i : i + 2], 16) / 255 for i in (0, 2, 4))
    except ValueError:
        return None
    return red, green, blue


def tinted(colour: Colour | None, tint: float) -> Colour | None:
    """Return a colour made lighter, or darker by a tint below 0."""
    if colour is None or not tint:
        return colour
    hue, light, saturation = rgb_to_hls(*colour)
    light = light * (1 + tint) if tint < 0 else light * (1 - tint) + tint
    return hls_to_rgb(hue, min(max(light, 0.0), 1.0), saturation)


def contrast(one: Colour, other: Colour) -> float:
    """Return the contrast of two colours, from 1 to 21 (WCAG 2.1)."""
    linear = [[c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour] for colour in (one, other)]
    low, high = sorted(0.2126 * red + 0.7152 * green + 0.0722 * blue for red, green, blue in linear)
    return (high + 0.05) / (low + 0.05)


def is_green(look: Look) -> bool:
    """Whether a cell looks like a check that passes: on green, or in green ink on no colour."""
    for colour in filter(None, reversed(look)):
        hue, _, saturation = rgb_to_hls(*colour)
        if max(colour) - min(colour) >= COLOURED / 2 and saturation >= COLOURED:  # more than a grey
            return GREEN[0] <= hue <= GREEN[1]
    return False
