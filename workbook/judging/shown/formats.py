"""What a number format shows of a value: the number itself with its sign, or something else.

A format is taken apart (ISO/IEC 29500-1, 18.8.31) and judged for every value that a cell may have, not for its present
one alone. What may be done with a number is said here; all else is told.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import NamedTuple

from openpyxl.styles.colors import COLOR_INDEX

from workbook.judging.report import NOTICE, SHOWN
from workbook.judging.shown import units
from workbook.judging.shown.colours import UNSEEN, WHITE, contrast, parsed

TOKEN = re.compile(
    r"""
    "(?P<quoted>[^"]*)"? | \\(?P<escaped>.) | _(?P<room>.) | \*(?P<filled>.) | \[(?P<bracket>[^\]]*)\]? | (?P<end>;)
    | (?P<code>(?i:General|Standard)|E[+-]|[0?\#]+|\.|,+|%|/|@) | (?P<date>AM/PM|A/P|[yYmMdDhHsSbBgGeE]+) | (?P<plain>.)
    """,
    re.VERBOSE | re.DOTALL,
)
CONDITION = re.compile(r"(<=|>=|<>|<|>|=)\s*([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)")
COLOUR = re.compile(r"black|white|red|green|blue|yellow|magenta|cyan|color ?([0-9]{1,2})", re.IGNORECASE)
COLOURS = {"white": "FFFFFF", "yellow": "FFFF00", "cyan": "00FFFF"}
"""of those by name, that cannot be read on white"""
DIGITS = re.compile(r"(?P<whole>[#?0,]*)(?P<parts>\.[#?0]*)?(?P<divided>,*)(?P<power>E[+-][#?0]+)?(?P<percent>%*)")
FRACTION = re.compile(r"[#?0]*/[#?0-9]+")
NEARLY = frozenset({"", "+", "≈", "~", "ca.", "approx."})
"""what may stand before a number, besides its symbol"""
DASHES = frozenset("-−–—")

Judged = tuple[str, str]
"""the kind of what is told of a format, and what; both empty where nothing is"""
FINE: Judged = ("", "")


class Part(NamedTuple):
    """One of the parts of a format: the codes of its digits, and the texts before, among and behind them."""

    codes: str = ""
    before: str = ""
    among: str = ""
    behind: str = ""
    date: bool = False
    odd: str = ""
    condition: str = ""
    colour: str = ""

    @property
    def literal(self) -> str:
        """All that the part adds."""
        return (self.before + self.among + self.behind).strip()

    @property
    def signed(self) -> bool:
        """Whether the part shows a number as negative."""
        return self.before.strip()[:1] in DASHES | {"("}

    def with_text(self, text: str) -> Part:
        """Return it with a literal text more."""
        if text.isdecimal() and re.search(r"/[0-9]*$", self.codes):  # a denominator
            return self._replace(codes=self.codes + text)
        return self._replace(behind=self.behind + text) if self.codes else self._replace(before=self.before + text)

    def with_code(self, code: str) -> Part:
        """Return it with a code more: what stood behind the digits stands among them now."""
        return self._replace(codes=self.codes + code, among=self.among + self.behind, behind="")

    def with_bracket(self, text: str) -> Part:
        """Return it with what stands in brackets: a condition, a colour, a currency, time that has passed, a script."""
        if CONDITION.fullmatch(text):
            return self._replace(condition=text)
        if COLOUR.fullmatch(text):
            return self._replace(colour=text.casefold())
        if text.startswith("$"):
            currency, _, place = text[1:].partition("-")
            dated = place.upper().startswith(("F800", "F400"))
            return self.with_text(currency)._replace(date=self.date or dated)
        return self._replace(date=True) if re.fullmatch("[hHmMsS]+", text) else self._replace(odd=f"[{text}]")


@lru_cache(maxsize=4_000)
def parts(code: str) -> tuple[Part, ...]:
    """Return the parts of a number format."""
    found = [Part()]
    for token in TOKEN.finditer(code):
        kind, text = str(token.lastgroup), str(token[str(token.lastgroup)])
        if kind == "end":
            found.append(Part())
        elif kind == "code":
            found[-1] = found[-1].with_code("@" if text.casefold() in ("general", "standard") else text)
        elif kind == "bracket":
            found[-1] = found[-1].with_bracket(text)
        elif kind == "date":
            found[-1] = found[-1]._replace(date=True)
        elif kind != "room":
            found[-1] = found[-1].with_text(text)
    return tuple(found)


@lru_cache(maxsize=10_000)
def judged(
    code: str, declared: str, unit: str = "", symbol: str = "", text: bool = False, zeros: bool = False
) -> Judged:
    """Return what is to be told of a format by which a cell shows its value.

    ``declared`` is the one that it has as built; ``text`` is whether it holds a text, and ``zeros`` whether there are
    numbers that round to 0.
    """
    if code == declared:
        return FINE
    held, ours = parts(code), parts(declared)
    last = held[3] if len(held) > 3 else held[-1] if "@" in held[-1].codes else None
    if text:
        return FINE if last is None or last == ours[-1] else worst(of_text(last))
    numeric = held[:3] if last is None or len(held) in (1, 4) else held[:-1]
    conditional = any(part.condition for part in numeric)
    others = [(n, part) for n, part in enumerate(numeric) if n >= len(ours) or part != ours[n]]
    return worst(one for n, part in others for one in of_number(part, n, unit, symbol, zeros, conditional))


def worst(found: Iterable[Judged]) -> Judged:
    """Return the first finding, else the first notice."""
    listed = list(found)
    return next((one for one in listed if one[0] == SHOWN), listed[0] if listed else FINE)


def of_text(part: Part) -> Iterator[Judged]:
    """Yield what is to be told of how a text is shown."""
    if part.codes != "@" or part.date or part.odd:
        yield SHOWN, f"replaced by {part.literal!r}" if part.literal else "hidden by its number format"
    elif part.literal:
        yield SHOWN, f"shown with {part.literal!r} added"
    yield from coloured(part)


def of_number(part: Part, n: int, unit: str, symbol: str, zeros: bool, conditional: bool) -> Iterator[Judged]:
    """Yield what is to be told of how numbers are shown by the ``n``-th part: positive, negative ones, and zero."""
    yield from coloured(part)
    if conditional:
        yield NOTICE, "shown by conditions"
        found = CONDITION.fullmatch(part.condition)
        n = int(found is not None and part.condition.startswith("<") and float(found[2]) <= 0)
    elif n == 2 and set(part.literal) <= DASHES and part.literal and not part.codes.strip("?"):
        return
    if part.date:
        yield SHOWN, "shown as a date or a time"
    elif not part.codes:
        yield SHOWN, f"replaced by {part.literal!r}" if part.literal else "hidden by its number format"
    elif part.among.strip() or part.odd:
        yield SHOWN, f"shown with {(part.among.strip() or part.odd)!r} among its digits"
    else:
        yield from of_digits(part.codes, unit, zeros)
        if part.signed and (n == 0 or n == 2):
            yield SHOWN, "shown as negative"
        if n == 1 and not part.signed and part.codes != "@":
            yield SHOWN, "shown without its sign"
        yield from added(part, unit, symbol)


def of_digits(codes: str, unit: str, zeros: bool) -> Iterator[Judged]:
    """Yield what is to be told of the digits."""
    found = DIGITS.fullmatch(codes)
    if codes == "@":
        return
    if FRACTION.fullmatch(codes):
        yield NOTICE, "shown in fractions"
    elif found is None:
        yield SHOWN, f"shown as {codes}"
    elif found["divided"] or (found["whole"].endswith(",") and not found["parts"]):
        yield SHOWN, "shown in thousands or millions"
    elif len(found["percent"]) > 1 or (found["percent"] and unit):
        yield SHOWN, "shown as a percentage"
    elif "0" not in codes:
        yield SHOWN if zeros else NOTICE, "hidden by its number format where it rounds to 0"


def added(part: Part, unit: str, symbol: str) -> Iterator[Judged]:
    """Yield what is to be told of the texts before and behind the digits: all but a sign, the symbol and the unit."""
    before = part.before.strip()
    rest = before[1:].strip() if part.signed else before
    if rest not in NEARLY and rest.rstrip("= ") != symbol:
        yield SHOWN, f"shown with {rest!r} added"
    behind = part.behind.strip()
    behind = behind.removesuffix(")").strip() if before[:1] == "(" else behind
    if behind and (not unit or units.compared(behind, unit) != "same"):
        yield SHOWN, f"shown with {behind!r} added"


def coloured(part: Part) -> Iterator[Judged]:
    """Yield that a colour cannot be read on white."""
    found = COLOUR.fullmatch(part.colour)
    if found is not None:
        number = int(found[1] or 0) + 7
        code = COLOR_INDEX[number][-6:] if found[1] and number < len(COLOR_INDEX) else COLOURS.get(part.colour, "0" * 6)
        ink = parsed(code)
        if ink is not None and contrast(ink, WHITE) < UNSEEN:
            yield SHOWN, f"written in {part.colour}"
