"""Number formats, taken apart far enough to say what of a value they tell (ISO/IEC 29500-1, 18.8.31)."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from workbook.judging.shown import units

TOKEN = re.compile(
    r"""
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | _(?P<room>.) | \*(?P<filled>.)
    | \[(?P<bracket>[^\]]*)\]? | (?P<end>;) | (?P<general>General|Standard)
    | (?P<exponent>[eE][+-]) | (?P<digits>[0?\#]+) | (?P<point>\.) | (?P<comma>,+) | (?P<percent>%)
    | (?P<fraction>/) | (?P<text>@) | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgG]+) | (?P<plain>.)
    """,
    re.VERBOSE | re.DOTALL,
)
COMPARE: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge, "=": operator.eq, "<>": operator.ne,
}  # fmt: skip
CONDITION = re.compile(r"(<=|>=|<>|<|>|=)\s*([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)")
ELAPSED = re.compile(r"[hHmMsS]+")
HARMLESS = re.compile(r"[\s\u00a0\u202f]*")
MISLEADING = re.compile(r"[0-9%‰]|\b(?:OK|FAIL)\b", re.IGNORECASE)


@dataclass
class Section:
    """One part of a number format."""

    condition: tuple[str, float] | None = None
    general: bool = False
    digits: list[str] = field(default_factory=list)
    percents: int = 0
    thousands: int = 0  # commas behind the last digit: each divides by a thousand
    exponent: bool = False
    fraction: bool = False
    point: bool = False
    date: bool = False
    texts: int = 0  # how often a text itself is shown
    white: bool = False
    before: str = ""
    inside: str = ""
    after: str = ""

    @property
    def shows_number(self) -> bool:
        """Whether a number's digits are shown."""
        return self.general or bool(self.digits) or self.date or bool(self.texts)

    @property
    def literal(self) -> str:
        """All that the format adds."""
        return self.before + self.inside + self.after

    def add(self, text: str) -> None:
        """Take a literal text."""
        if self.digits or self.general or self.texts:
            self.after += text
        else:
            self.before += text

    def take(self, kind: str, text: str) -> None:
        """Take a token that is shown, or says how."""
        if kind in ("quoted", "escaped", "plain"):
            self.add(text)
        elif kind == "filled":
            self.add(text if text.strip(" -.") else "")
        elif kind == "digits":
            self.inside, self.after = self.inside + self.after, ""
            self.digits.append(text)
            self.thousands = 0
        elif kind == "comma":
            self.thousands = len(text) if self.digits else 0
        elif kind == "bracket":
            self.bracket(text)
        elif kind == "percent":
            self.percents += 1
        elif kind == "text":
            self.texts += 1
        elif kind in ("general", "exponent", "fraction", "date", "point"):
            setattr(self, kind, True)

    def bracket(self, text: str) -> None:
        """Take what stands in brackets: a condition, a colour, a currency, time that has gone by."""
        found = CONDITION.fullmatch(text)
        if found:
            self.condition = (found[1], float(found[2]))
        elif text.startswith("$"):
            self.add(text[1:].partition("-")[0])
        elif ELAPSED.fullmatch(text):
            self.date = True
        elif text.casefold() == "white" or text.casefold() == "color2":
            self.white = True


@lru_cache(maxsize=4_000)
def sections(code: str) -> tuple[Section, ...]:
    """Return the parts of a number format."""
    found = [Section()]
    for token in TOKEN.finditer(code):
        kind = str(token.lastgroup)
        if kind == "end":
            found.append(Section())
        elif kind != "room":
            found[-1].take(kind, token[kind])
    return tuple(found)


def section_for(code: str, value: Any) -> tuple[Section | None, bool]:
    """Return the part that shows a value, and whether the program adds the sign of a negative number itself.

    No part: the value is shown as it is.
    """
    parts = sections(code)
    if isinstance(value, str):
        last = parts[-1]
        return (last, False) if len(parts) == 4 or (last.texts and len(parts) < 4) else (None, False)
    numeric = list(parts[:3]) if len(parts) > 3 or not parts[-1].texts or len(parts) == 1 else list(parts[:-1])
    if any(part.condition for part in numeric):
        return conditional(numeric, value)
    if len(numeric) > 1 and value < 0:
        return numeric[1], False
    if len(numeric) > 2 and value == 0:
        return numeric[2], False
    return numeric[0], True


def conditional(parts: list[Section], value: float) -> tuple[Section | None, bool]:
    """Return the part whose condition a number meets, or the one for all others.

    One for negative numbers alone shows their size: the sign is its own affair.
    """
    for n, part in enumerate(parts):
        if part.condition is None:
            order, limit = (n == 1 and parts[0].condition) or ("", 0.0)
            return part, not (order in (">", ">=") and limit <= 0)
        order, limit = part.condition
        if COMPARE[order](value, limit):
            return part, not ((order == "<" and limit <= 0) or (order == "<=" and limit < 0))
    return None, True


@lru_cache(maxsize=4_000)
def plain(code: str) -> bool:
    """Whether a format shows every number with its sign and its digits, and nothing else; and texts as they are."""
    parts = sections(code)
    first = parts[0]
    bare = first.general or (bool(first.digits) and "0" in "".join(first.digits))
    odd = first.percents or first.thousands or first.literal or first.white or first.condition
    return len(parts) == 1 and (first.date or (bare and not odd))


def problem(value: Any, code: str, declared: str, unit: str) -> str:
    """Return what is wrong with how a value is shown, by the format that a cell has; nothing where all is well.

    ``declared`` is the format by which motionbook shows it: what that hides or replaces may be hidden or replaced so.
    """
    if isinstance(value, bool) or value is None or value == "":
        return ""
    part, signed = section_for(code, value)
    if part is None:
        return ""
    said = of_text(part) if isinstance(value, str) else of_number(part, signed, value, unit)
    if not said:
        return ""
    ours, signed = section_for(declared, value)
    if ours is None:
        return said
    own = of_text(ours) if isinstance(value, str) else of_number(ours, signed, value, unit)
    return "" if own == said else said


def of_text(part: Section) -> str:
    """Return what is wrong with how a text is shown."""
    if part.white:
        return "written in white"
    if not part.texts:
        return f"replaced by {part.literal!r}" if part.literal.strip() else "hidden by its number format"
    return f"shown with {part.literal!r} added" if part.literal.strip() or part.texts > 1 else ""


def of_number(part: Section, signed: bool, value: float, unit: str) -> str:
    """Return what is wrong with how a number is shown."""
    if part.white:
        return "written in white"
    if not part.shows_number:
        return f"replaced by {part.literal!r}" if part.literal.strip() else "hidden by its number format"
    if part.date or part.texts:
        return ""
    if part.percents > 1 or (part.percents and unit):
        return "shown as a percentage"
    if part.thousands:
        return "shown in thousands" if part.thousands == 1 else "shown in millions"
    if part.inside.strip():
        return f"shown with {part.inside!r} among its digits"
    return sign_of(part, signed, value) or added(part, unit) or empty(part, value)


def sign_of(part: Section, signed: bool, value: float) -> str:
    """Return what is wrong with the sign that is shown."""
    written = part.before.strip()[:1] in ("-", "−", "–", "(")
    if value < 0 and not signed and not written and not part.general:
        return "shown without its sign"
    return "shown as negative" if value > 0 and written and "(" not in part.before else ""


def added(part: Section, unit: str) -> str:
    """Return what is wrong with the texts before and after the digits: digits, or another unit."""
    for text in (part.before.strip().lstrip("+-−–("), part.after.strip().rstrip(")")):
        if HARMLESS.fullmatch(text) or text.split() == unit.split():
            continue
        if MISLEADING.search(text) or (letters(text.strip()) and units.compared(text.strip(), unit) != "same"):
            return f"shown with {text!r} added"
    return ""


def letters(text: str) -> bool:
    """Whether a text beside a number reads as a unit, or as a factor such as k."""
    return text in units.PREFIXES or (not units.unit(text).words and bool(text.strip(" .,:;()[]")))


def empty(part: Section, value: float) -> str:
    """Return what is wrong where a number that rounds to 0 leaves no digit at all."""
    places = "".join(part.digits)
    if part.general or "0" in places or part.fraction:
        return ""
    decimals = len(part.digits[-1]) if part.point and len(part.digits) > 1 else 0
    return "hidden by its number format" if round(value, decimals) == 0 else ""
