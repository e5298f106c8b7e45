"""The colours and fonts of a book as programs show them: to tell a text that cannot be seen, and a green from a red."""

from colorsys import hls_to_rgb, rgb_to_hls
from typing import Any
from xml.etree.ElementTree import ParseError, fromstring

from openpyxl import Workbook
from openpyxl.styles.colors import COLOR_INDEX

from workbook.reading.rows import tag

BLACK, WHITE = (0.0, 0.0, 0.0), (1.0, 1.0, 1.0)
GREEN = (75 / 360, 165 / 360)  # hues
COLOURED = 0.2  # saturation and depth from which a colour is one
THEME = ("lt1", "dk1", "lt2", "dk2", "accent1", "accent2", "accent3", "accent4", "accent5", "accent6", "hlink")
OFFICE = dict(zip(THEME, ("FFFFFF", "000000", "EEECE1", "1F497D", "4F81BD", "C0504D", "9BBB59", "8064A2", "4BACC6",
                          "F79646", "0000FF"), strict=True))  # fmt: skip

Colour = tuple[float, float, float]
Look = tuple[Colour | None, Colour | None]  # ink and ground of a cell; None for what cannot be told, as a gradient


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
            return tinted(parsed(found.rgb[-6:]), found.tint)
        if kind == "theme" and found.theme is not None and 0 <= found.theme < len(THEME):
            return tinted(parsed(self._theme[THEME[found.theme]]), found.tint)
        if kind == "indexed" and found.indexed is not None and 0 <= found.indexed < len(self._indexed):
            return parsed(self._indexed[found.indexed][-6:])
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
            return BLACK, WHITE
        return self.colour(cell.font.color, BLACK), self.ground(cell.fill, WHITE)


def parsed(text: str) -> Colour | None:
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

    def luminance(colour: Colour) -> float:
        red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour)
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def looks_passed(look: Look) -> bool:
    """Whether a cell looks like a check that passes: on green, or in green ink on no colour."""
    for colour in filter(None, reversed(look)):
        hue, _, saturation = rgb_to_hls(*colour)
        if max(colour) - min(colour) >= COLOURED / 2 and saturation >= COLOURED:  # more than a grey
            return GREEN[0] <= hue <= GREEN[1]
    return False
