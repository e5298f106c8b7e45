"""How a cell looks: number format, ink on ground, font, place in the cell; and whether a change of it misleads."""

import re
from collections.abc import Iterator
from colorsys import hls_to_rgb, rgb_to_hls
from functools import lru_cache
from typing import Any, NamedTuple
from xml.etree.ElementTree import ParseError, fromstring

from openpyxl import Workbook
from openpyxl.styles.colors import COLOR_INDEX
from openpyxl.styles.numbers import BUILTIN_FORMATS, BUILTIN_FORMATS_MAX_SIZE

from workbook.reading.rows import tag

THEME = ("lt1", "dk1", "lt2", "dk2", "accent1", "accent2", "accent3", "accent4", "accent5", "accent6", "hlink")
OFFICE = dict(
    zip(
        THEME,
        ["FFFFFF", "000000", "EEECE1", "1F497D", "4F81BD", "C0504D", "9BBB59", "8064A2", "4BACC6", "F79646", "0000FF"],
        strict=True,
    )
)
BLACK, WHITE, UNKNOWN = "000000", "FFFFFF", "mixed"  # the last: of gradients, patterns and colours without digits
UNSEEN = 1.3  # contrast of ink and ground below which a text is hidden (WCAG 2.1); ours have 2.5 and more
LEAST_SIZE = 4.0  # points of a font that cannot be read
MOST_INDENT = 15  # steps of three spaces after which a figure leaves its cell
SIGNS = ("wingdings", "webdings", "symbol", "marlett", "opensymbol", "zapfdingbats", "bookshelf symbol")
TOKEN = re.compile(r"""(?xs)
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | (?P<room>_.|\*[ ]) | \*(?P<filled>.) | \[(?P<bracket>[^\]]*)\]?
    | (?P<end>;) | (?P<text>@|(?i:General|Standard)) | (?P<code>E[+-]|[0?\#.,%/])
    | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgGeE]) | (?P<plain>.)
""")
NUMBER = re.compile(r"@|(?=[#?,.]*0)(?:[#?0,]*[#?0])?(?:\.[#?0]*)?(?:E[+-][#?0]+)?")  # a 0 shows in place of a zero
INK = re.compile(r"\[(?:black|red|green|blue|magenta|color ?(?:[13-57-9]|[1-4][0-9]|5[0-6]))\]", re.IGNORECASE)
LANGUAGE = re.compile(r"\$([^-\]]*)(?:-(?!F800|F400)(?:0?[01])?[0-9A-F]{0,6})?", re.IGNORECASE)  # of our digits


class CellLook(NamedTuple):
    """What a reader sees of a cell's style."""

    number_format: str = "General"
    ink: str = BLACK
    ground: str = WHITE
    face: str = "calibri"
    size: float = 11.0
    emphasis: tuple[str, ...] = ()  # bold, italic, underlined
    effects: tuple[str, ...] = ()  # struck out, in another charset, crossed out, …
    alignment: tuple[Any, ...] = ("general", 0, 0, 0, 0, False)  # side, indents, rotation, reading order, shrunk
    locked: bool = True


class LookReader:
    """Reads how the cells of a workbook look, with the colours and fonts of its theme."""

    def __init__(self, workbook: Workbook) -> None:
        self._workbook: Any = workbook
        self._theme, self.fonts = dict(OFFICE), dict[str, str]()
        self._indexed = list(getattr(workbook, "_colors", None) or COLOR_INDEX)  # a file may have its own
        try:
            root = fromstring(workbook.loaded_theme or b"<none/>")
        except ParseError:
            return
        for element in root.iter():
            name = tag(element)
            if name in OFFICE and len(element):  # a colour without digits cannot be known
                given = element[0].get("lastClr") or element[0].get("val") or ""
                self._theme[name] = UNKNOWN if len(element[0]) else given.upper() or UNKNOWN
            elif name in ("majorFont", "minorFont"):
                face = next((child.get("typeface") for child in element if tag(child) == "latin"), None)
                self.fonts[name.removesuffix("Font")] = face or ""

    def cell_look(self, style: Any, font: Any = None) -> CellLook:
        """Return the look of a style of openpyxl's, a StyleArray; with the ``font`` of a part of the cell's text."""
        book = self._workbook
        font = font or book._fonts[style.fontId]
        border, alignment = book._borders[style.borderId], book._alignments[style.alignmentId]
        crossed = ("crossed out",) if border.diagonalUp or border.diagonalDown else ()
        face = self.fonts.get(font.scheme) or getattr(font, "rFont", None) or getattr(font, "name", None) or "calibri"
        emphasis = [word for word, is_so in (("bold", font.b), ("italic", font.i), ("underlined", font.u)) if is_so]
        return CellLook(
            self.number_format(style.numFmtId),
            self.colour(font.color, BLACK),
            self.ground(book._fills[style.fillId]),
            str(face).casefold(),
            float(font.sz or 11.0),
            tuple(emphasis),
            (*font_effects(font), *crossed),
            (
                alignment.horizontal or "general",
                int(alignment.indent or 0),
                int(alignment.relativeIndent or 0),
                alignment.textRotation or 0,
                alignment.readingOrder or 0,
                bool(alignment.shrinkToFit),
            ),
            bool(book._protections[style.protectionId].locked),
        )

    def number_format(self, number: int) -> str:
        """Return a number format by its number; one that programs define by their language is named as such."""
        formats = self._workbook._number_formats
        if number >= BUILTIN_FORMATS_MAX_SIZE:
            held = number - BUILTIN_FORMATS_MAX_SIZE
            return str(formats[held]) if held < len(formats) else f"undefined format {number}"
        return BUILTIN_FORMATS.get(number, f"format {number} of the reader's language")

    def colour(self, found: Any, default: str) -> str:
        """Return the six digits of a colour of openpyxl's; ``default`` where it is the program's own."""
        kind = None if found is None else found.type
        tint = 0.0 if found is None else found.tint
        if kind == "rgb" and isinstance(found.rgb, str):
            return tinted(found.rgb[-6:].upper(), tint)
        if kind == "theme" and found.theme is not None and 0 <= found.theme < len(THEME):
            return tinted(self._theme[THEME[found.theme]], tint)
        if kind == "indexed" and found.indexed is not None and 0 <= found.indexed < len(self._indexed):
            return tinted(self._indexed[found.indexed][-6:].upper(), tint)
        return default

    def ground(self, fill: Any, conditional: bool = False) -> str:
        """Return the colour of a fill; of a conditional format's, the background is the one that is seen."""
        kind = "none" if fill is None else getattr(fill, "patternType", "gradient") or "none"
        if conditional and fill is not None and kind in ("none", "solid"):
            unset = fill.bgColor is None or (fill.bgColor.type == "rgb" and fill.bgColor.rgb == "00000000")
            if not unset or kind == "solid":
                return self.colour(fill.fgColor if unset else fill.bgColor, WHITE)
        if kind == "none":
            return WHITE
        return self.colour(fill.fgColor, UNKNOWN) if kind == "solid" else UNKNOWN


def font_effects(font: Any) -> Iterator[str]:
    """Yield the names of the effects of a font of openpyxl's."""
    if font.strike:
        yield "struck out"
    if font.charset == 2:
        yield "in the signs of a symbol font"
    for name in ("outline", "shadow", "condense", "extend"):
        if getattr(font, name):
            yield name
    if font.vertAlign not in (None, "baseline"):
        yield str(font.vertAlign)


def tinted(digits: str, tint: float) -> str:
    """Return a colour made lighter, or darker by a tint below 0."""
    if not tint or not re.fullmatch("[0-9A-F]{6}", digits):
        return digits
    hue, light, saturation = rgb_to_hls(*channels(digits))
    light = light * (1 + tint) if tint < 0 else light * (1 - tint) + tint
    shaded = hls_to_rgb(hue, min(max(light, 0.0), 1.0), saturation)
    return "".join(f"{round(255 * channel):02X}" for channel in shaded)


def channels(digits: str) -> tuple[float, float, float]:
    """Return red, green and blue, from 0 to 1, of a colour in six digits."""
    red, green, blue = (int(digits[k : k + 2], 16) / 255 for k in (0, 2, 4))
    return red, green, blue


def contrast(ink: str, ground: str) -> float:
    """Return the contrast of two colours, from 1 to 21 (WCAG 2.1); 1 where either cannot be known."""
    if not all(re.fullmatch("[0-9A-Fa-f]{6}", digits) for digits in (ink, ground)):
        return 1.0
    linear = [
        [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels(digits)]
        for digits in (ink, ground)
    ]
    low, high = sorted(0.2126 * red + 0.7152 * green + 0.0722 * blue for red, green, blue in linear)
    return (high + 0.05) / (low + 0.05)


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


@lru_cache(maxsize=4_000)
def plain_number(sections: tuple[str, ...], unit: str = "") -> tuple[str, ...]:
    """Return the sections of a number format without decimals, separators, colours and the quantity's unit."""
    suffix = "".join(f"\0{sign}" for sign in unit)
    parts = []
    for part in sections[:3]:
        bare = re.sub(r"(?<=[#?0])\0 (?=[#?0])", "", INK.sub("", part))
        bare = NUMBER.sub("N", bare, count=1).replace("\0+", "").replace("\0(N\0)", "\0-N").replace("\0−", "\0-")
        bare = re.sub(r"^(?:\0≈|\0~|\0c\0a\0\.)(?:\0 )?(?=N)", "", bare)
        parts.append("N" if unit and re.fullmatch(rf"N(?:\0 )?{re.escape(suffix)}", bare) else bare)
    negative = parts[1:2] in ([], ["\0-N"])  # as programs show it by themselves
    zero = not parts[2:] or parts[2] == "N" or re.fullmatch(r"(?:\0 |\?)*\0[-–—](?:\0 |\?)*", parts[2])
    return (parts[0], *(() if negative else parts[1:2]), *(() if zero else parts[2:]))


def look_changes(fresh: CellLook, held: CellLook, text: bool, unit: str = "") -> Iterator[tuple[str, str, str, bool]]:
    """Yield attribute, what is expected, what is held, and whether it misleads, of each difference between two looks.

    ``text`` says that the cells show a text; ``unit`` is that of the quantity, which a number format may repeat.
    """
    ours, theirs = format_sections(fresh.number_format), format_sections(held.number_format)
    numeric = ours[:3] != theirs[:3]
    if (text_section(ours) != text_section(theirs)) if text else numeric:
        misleads = text or plain_number(theirs, unit) != plain_number(ours)
        yield "number format", fresh.number_format, held.number_format, misleads
    hidden = contrast(held.ink, held.ground) < UNSEEN
    for name, misleads in (
        ("ink", hidden),
        ("ground", hidden and fresh.ink == held.ink),
        ("face", held.face.startswith(SIGNS)),
        ("size", held.size < LEAST_SIZE),
        ("emphasis", False),
        ("effects", not {"struck out", "crossed out", "in the signs of a symbol font"}.isdisjoint(held.effects)),
        ("alignment", held.alignment[0] == "fill" or held.alignment[1] > MOST_INDENT),
        ("locked", False),
    ):
        if getattr(fresh, name) != getattr(held, name):
            yield name, spelled(getattr(fresh, name)), spelled(getattr(held, name)), misleads


def text_section(parts: tuple[str, ...]) -> str:
    """Return the part of a number format by which a text is shown."""
    if len(parts) > 3:
        return parts[3]
    return parts[-1] if "@" in parts[-1] and len(parts[-1]) > 1 else "@"


def spelled(value: Any) -> str:
    """Return an attribute of a look in words."""
    return ", ".join(map(str, value)) or "none" if isinstance(value, tuple) else str(value)
