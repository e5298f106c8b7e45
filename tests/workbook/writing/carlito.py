"""How wide a text is in Carlito, whose letters are as wide as Calibri's: from the font's own tables (OpenType 1.9)."""

import struct
from functools import cache
from pathlib import Path

FOLDER = Path("/usr/share/fonts/truetype/crosextra")
PIXELS = 96 / 72  # of a point, at Excel's resolution
MARGIN = 5  # pixels of padding beside a column's digits


@cache
def face(bold=False, italic=False):
    """Return the advance of each code point in units of the em, and that of one without a glyph."""
    style = {(False, False): "Regular", (True, False): "Bold", (False, True): "Italic", (True, True): "BoldItalic"}
    data = (FOLDER / f"Carlito-{style[bold, italic]}.ttf").read_bytes()
    tables = {}
    for i in range(struct.unpack(">H", data[4:6])[0]):
        tag, _, offset, length = struct.unpack(">4sIII", data[12 + 16 * i : 28 + 16 * i])
        tables[tag.decode()] = data[offset : offset + length]
    em = struct.unpack(">H", tables["head"][18:20])[0]
    count = struct.unpack(">H", tables["hhea"][34:36])[0]
    advances = [struct.unpack(">H", tables["hmtx"][4 * i : 4 * i + 2])[0] / em for i in range(count)]
    return {code: advances[min(glyph, count - 1)] for code, glyph in glyphs(tables["cmap"]).items()}, advances[0]


def glyphs(cmap):
    """Return the glyph of each code point of the basic plane, from a table of format 4."""
    for i in range(struct.unpack(">H", cmap[2:4])[0]):
        offset = struct.unpack(">I", cmap[8 + 8 * i : 12 + 8 * i])[0]
        if struct.unpack(">H", cmap[offset : offset + 2])[0] == 4:
            return format4(cmap[offset:])
    raise ValueError("no table of format 4")


def format4(table):
    """Return the glyphs of a table of segments."""
    n = struct.unpack(">H", table[6:8])[0] // 2
    words = struct.unpack(f">{len(table) // 2}H", table[: len(table) // 2 * 2])
    ends, starts, deltas, offsets = (words[7 + k * n + (k > 0) : 7 + (k + 1) * n + (k > 0)] for k in range(4))
    first, found = 7 + 3 * n + 1, {}
    for i, (start, end, delta, offset) in enumerate(zip(starts, ends, deltas, offsets, strict=True)):
        for code in range(start, end + 1):
            glyph = words[first + i + offset // 2 + code - start] if offset else code
            if code != 0xFFFF and (glyph or not offset):
                found[code] = (glyph + delta) & 0xFFFF
    return found


@cache
def pixels(text, size=11.0, bold=False, italic=False):
    """Return how wide a text is, in pixels."""
    advances, missing = face(bold, italic)
    return sum(advances.get(ord(letter), missing) for letter in text) * size * PIXELS


def room(width):
    """Return how wide a text may be in a column of so many digits of Calibri 11 (ISO/IEC 29500-1, 18.3.1.13)."""
    return width * pixels("0") + MARGIN
