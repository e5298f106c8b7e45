"""Number formats by what their sections show, however they are escaped, and whether they show another number."""

import re
from functools import lru_cache
from typing import Any

from openpyxl.styles.numbers import BUILTIN_FORMATS, BUILTIN_FORMATS_MAX_SIZE

TOKEN = re.compile(r"""(?xs)
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | (?P<room>_.|\*[ ]) | \*(?P<filled>.) | \[(?P<bracket>[^\]]*)\]?
    | (?P<end>;) | (?P<text>@|(?i:General|Standard)) | (?P<code>E[+-]|[0?\#.,%/])
    | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgGeE]) | (?P<plain>.)
""")
# a 0 shows in place of a zero
NUMBER = re.compile(r"@|(?=[#?,.]*0)(?:[#?0,]*[#?0])?(?:\.[#?0]*)?(?:E[+-][#?0]+)?")
INK = re.compile(r"\[(?:black|red|green|blue|magenta|color ?(?:[13-57-9]|[1-4][0-9]|5[0-6]))\]", re.IGNORECASE)
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


@lru_cache(maxsize=4_000)
def plain_number(code: str, unit: str = "") -> tuple[str, ...]:
    """Return the sections of a number format without decimals, separators, colours and the quantity's unit."""
    suffix = "".join(f"\0{sign}" for sign in unit)
    parts = []
    for part in format_sections(code)[:3]:
        bare = re.sub(r"(?<=[#?0])\0 (?=[#?0])", "", INK.sub("", part))
        bare = NUMBER.sub("N", bare, count=1).replace("\0+", "").replace("\0(N\0)", "\0-N").replace("\0−", "\0-")
        bare = re.sub(r"^(?:\0≈|\0~|\0c\0a\0\.)(?:\0 )?(?=N)", "", bare)
        parts.append("N" if unit and re.fullmatch(rf"N(?:\0 )?{re.escape(suffix)}", bare) else bare)
    negative = parts[1:2] in ([], ["\0-N"])  # as programs show it by themselves
    zero = not parts[2:] or parts[2] == "N" or re.fullmatch(r"(?:\0 |\?)*\0[-–—](?:\0 |\?)*", parts[2])
    return (parts[0], *(() if negative else parts[1:2]), *(() if zero else parts[2:]))


def text_section(code: str) -> str:
    """Return the part of a number format by which a text is shown."""
    parts = format_sections(code)
    if len(parts) > 3:
        return parts[3]
    return parts[-1] if "@" in parts[-1] and len(parts[-1]) > 1 else "@"
