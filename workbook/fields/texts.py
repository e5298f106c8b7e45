"""Texts as entered: in a line that every program shows, names that every program finds again by MATCH, titles."""

import re
from collections.abc import Iterable, Sequence
from difflib import get_close_matches
from typing import Annotated
from unicodedata import category, normalize

from pydantic import AfterValidator, Field

from workbook.fields.types import EntryError

NO_FORMULA = r"^[^=]"
# what a program takes for an error value
ERROR = re.compile(r"#[\w/]+[!?]|#N/A|#NV|#GETTING_DATA", re.IGNORECASE)
NO_NAME = re.compile(
    r"TRUE|FALSE|[+-]?[0-9.,]+(?:E[+-]?[0-9]+)?\s?%?"
    r"|[0-9]+(?:\s?[-/.:\s]\s?[0-9]+)*[-/.:]?(?:\s[AP]M?)?"
    r"|(?:[0-9]+[-\s])?(?:JAN(?:UARY)?|FEB(?:RUARY)?|MAR(?:CH)?|APR(?:IL)?|MAY|JUNE?|JULY?|AUG(?:UST)?"
    r"|SEP(?:TEMBER)?|OCT(?:OBER)?|NOV(?:EMBER)?|DEC(?:EMBER)?)[-\s]?[0-9]+(?:[-\s][0-9]+)?",
    re.IGNORECASE,
)
"""what a program takes for a truth value, a number, a date or a time when it is chosen from a list"""
PATTERN = "*?~"


def one_line(text: str) -> str:
    """Return a text; raise EntryError where it holds a character that some program, or a file, cannot show."""
    for character in text:
        number = ord(character)  # of some it is none of a character (Unicode 15, 23.7)
        none = number & 0xFFFE == 0xFFFE or 0xFDD0 <= number <= 0xFDEF
        if none or category(character) in ("Cc", "Cs", "Zl", "Zp"):
            expected = "expected a text in one line, of characters that a cell can show"
            raise EntryError("", f"holds the character U+{number:04X}; {expected}")
    if ERROR.fullmatch(text):
        raise EntryError("", f"{text!r} reads as an error value; expected a text")
    return text


def checked_name(name: str) -> str:
    """Return a name; raise EntryError where a look-up would find another than this, or none."""
    one_line(name)
    if NO_NAME.fullmatch(name):
        raise EntryError("", f"{name!r} reads as a value, not as a name; expected a name")
    signs = [sign for sign in PATTERN if sign in name]
    if signs:
        raise EntryError("", f"holds {signs[0]}, which look-ups take for a pattern; expected a name without {PATTERN}")
    if name != name.strip():
        raise EntryError("", "begins or ends with a blank; expected a name without")
    return name


ONE_LINE, LOOKED_UP = AfterValidator(one_line), AfterValidator(checked_name)
Text = Annotated[str, Field(min_length=1, max_length=80, pattern=NO_FORMULA), ONE_LINE]


def place_of(name: str, names: Iterable[str]) -> int:
    """Return the place of the first of ``names`` that MATCH finds, whatever the case of letters; −1 where none is."""
    return next((i for i, each in enumerate(names) if each.lower() == name.lower()), -1)


def nearest_names(name: str, names: Sequence[str]) -> list[str]:
    """Return the three of the names that are most like the given name, first those of its very letters."""
    known, given = {each.casefold(): each for each in names}, name.casefold()
    swapped = [each for each in known if sorted(each) == sorted(given)]
    alike = dict.fromkeys([*swapped, *get_close_matches(given, known, n=3, cutoff=0.0)])
    return [known[each] for each in alike][:3]


def lookup_key(name: str) -> str:
    """Return a text for all names that some program could take for the same: by case, dots of an i, width, ß and ss."""
    return normalize("NFKC", normalize("NFKC", name).upper().casefold()).replace("\u0307", "")


def require_distinct(names: Iterable[str], kind: str, key: str) -> None:
    """Raise EntryError, at ``key`` with the number of the entry, for a name that a look-up takes for another before."""
    seen: dict[str, str] = {}
    for i, each in enumerate(names):
        first = seen.get(lookup_key(each))
        if first is not None:
            like = "" if first == each else f", which a look-up takes for {first!r}"
            raise EntryError(key.format(i), f"a second {kind} is named {each!r}{like}; expected a name of its own")
        seen[lookup_key(each)] = each


LONGEST = 31  # characters of a sheet's title, as UTF-16 counts them; Excel's limit
RESERVED = ("Drive cycle", *"Summary Cycle Pieces Laws Export Names Checks History".split())
"""sheets that come later, and a title that Excel keeps for itself"""


def sheet_title(name: str, taken: Iterable[str]) -> str:
    """Return a title for the sheet of a name; Law for a name of which nothing is left."""
    words = cut_text(re.sub(r"[\[\]:*?/\\]", "-", name), LONGEST) or "Law"
    others = {lookup_key(title) for title in (*taken, *RESERVED)}
    short, more = words, 1
    while lookup_key(short) in others:
        more += 1
        ending = f" ({more})"
        short = cut_text(words, LONGEST - len(ending)) + ending
    return short


def cut_text(text: str, most: int) -> str:
    """Return as much of a text as UTF-16 has in so many units, without apostrophes or blanks at its ends."""
    short = text.strip("' ").encode("utf-16-le", "surrogatepass")[: 2 * most].decode("utf-16-le", "ignore")
    return short.strip("' ")
