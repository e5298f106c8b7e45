"""What a number format makes of a value: the number itself with its sign, which is taste, or anything else.

It is taken apart (ISO/IEC 29500-1, 18.8.31) and judged for every value; what is not permitted here is told.
"""

import re
from functools import lru_cache
from typing import NamedTuple

from openpyxl.styles.colors import COLOR_INDEX

from workbook.judging.report import NOTICE, SHOWN
from workbook.judging.shown import taste
from workbook.judging.shown.colours import WHITE, contrast, parsed
from workbook.judging.shown.words import compared

TOKEN = re.compile(
    r"""
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | (?P<room>_.|\*[ ]) | \*(?P<filled>.) | \[(?P<bracket>[^\]]*)\]?
    | (?P<end>;) | (?P<text>@|(?i:General|Standard)) | (?P<code>E[+-]|[0?\#.,%/])
    | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgGeE]) | (?P<plain>.)
    """,
    re.VERBOSE | re.DOTALL,
)
ADDED = r"((?:\0.)*)"
NUMBER = re.compile(
    rf"{ADDED}(?P<number>@|(?:[#?0,]*[#?0])?(?:\.[#?0]*)?(?:E[+-][#?0]+)?)(?P<percent>%?){ADDED}", re.DOTALL
)
FRACTION = re.compile(r"[#?0]*/(?:[#?0]|\0[0-9])+")
CONDITION = re.compile(r"(<=|>=|<>|<|>|=)\s*([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)")
COLOUR = re.compile(r"(black|white|red|green|blue|yellow|magenta|cyan)|color ?([0-9]{1,2})", re.IGNORECASE)
BRIGHT = {"white": "FFFFFF", "yellow": "FFFF00", "cyan": "00FFFF"}
LANGUAGE = re.compile(r"\$([^-]*)(?:-(?!F800|F400)(?:0?[01])?[0-9A-F]{0,6})?", re.IGNORECASE)  # of our digits

Judged = tuple[str, str]  # the kind of what is told, and what; both empty where nothing is


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
def judged(
    code: str, declared: str, unit: str = "", symbol: str = "", text: bool = False, zeros: bool = False
) -> Judged:
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
            kinds.add(of_number(one, negative if conditional else n, unit, symbol, zeros))
    kind = SHOWN if SHOWN in kinds else NOTICE if conditional or NOTICE in kinds else ""
    return (kind, f"the number format {code}") if kind else ("", "")


def of_number(part: Section, n: int, unit: str, symbol: str, zeros: bool) -> str:
    """Return of which kind the ``n``-th part is, which shows positive numbers, negative ones, or zero."""
    if not all(is_ink(one) or CONDITION.fullmatch(one) for one in part.brackets):
        return SHOWN
    if n == 2 and re.fullmatch(rf"(?:\0 |\?)*\0[{taste.DASHES}](?:\0 |\?)*", part.form):
        return ""
    form = re.sub(r"(?<=[#?0])\0 (?=[#?0])", "", part.form)
    if (found := NUMBER.fullmatch(form)) is None or not found["number"]:
        return NOTICE if FRACTION.fullmatch(form) else SHOWN
    before, behind = (found[i].replace("\0", "").strip() for i in (1, 4))
    signed = before[:1] in [*taste.DASHES, "("]
    sign = signed if n != 1 else not signed and found["number"] != "@"
    rest, behind = before[signed:].strip(), behind.removesuffix(")" if before[:1] == "(" else "").strip()
    named = rest in taste.NEARLY or rest.rstrip("= ") == symbol
    other = behind and not (unit and compared(behind, unit) == "same")
    if sign or not named or (found["percent"] and unit) or other:
        return SHOWN
    return "" if set("0@") & set(found["number"]) else SHOWN if zeros else NOTICE


def is_ink(bracket: str) -> bool:
    """Whether what stands in brackets is a colour that can be read on white."""
    if (found := COLOUR.fullmatch(bracket)) is None:
        return False
    number = int(found[2] or 0) + 7
    code = COLOR_INDEX[number][-6:] if found[2] and number < len(COLOR_INDEX) else BRIGHT.get(bracket.lower(), "0" * 6)
    return (ink := parsed(code)) is None or contrast(ink, WHITE) >= taste.UNSEEN
