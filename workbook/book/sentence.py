"""The sentence of a failing check: where, and by how much; its figures are rounded for people."""

import re
from itertools import zip_longest
from typing import Any, NamedTuple, Self

DIGITS = 9  # decimals that are shown of an entry, at most
PLACES = 4  # decimals that are shown of an amount, at most
LARGEST = 1e9  # of the entries that are shown
BEYOND = "beyond 1E9"
_FIGURE = re.compile(r"-?[0-9]+(?:[.,][0-9]+)?(?:[eE][+-]?[0-9]+)?")
_ROUNDED = 1.1 * 10.0**-PLACES  # each program rounds the last decimal in its way


class Sentence(str):
    """A text with rounded figures, as cells put it together: programs write these with a point or with a comma."""

    __slots__ = ()

    def says(self, other: Any) -> bool:
        """Whether another text has the same words, and its figures are the same but for their last digit."""
        if not isinstance(other, str) or _FIGURE.split(self) != _FIGURE.split(other):
            return False
        ours, theirs = ([float(n.replace(",", ".")) for n in _FIGURE.findall(text)] for text in (self, other))
        return all(abs(our - two) <= _ROUNDED + 1e-9 * abs(our) for our, two in zip(ours, theirs, strict=True))


def figure(value: float, most: float = LARGEST) -> str:
    """Return a number as sentences show it; cells show what is entered however large."""
    return f"{round(value, DIGITS) + 0.0:.15g}" if abs(value) < most else BEYOND


def quoted(text: str) -> str:
    """Return a text as formulas write it."""
    return '"' + text.replace('"', '""') + '"'


def sentence_formula(text: str, *cells: str) -> str:
    """Return the formula of a sentence, without its =, that has the figures of cells at each {}."""
    words = [quoted(part) if part else "" for part in text.split("{}")]
    return "&".join(part for pair in zip_longest(words, cells, fillvalue="") for part in pair if part)


def first_text(texts: str) -> str:
    """Return the formula of the number of the first row that has a text in a column."""
    return f'MATCH("?*",{texts},0)'


class CheckSentence(NamedTuple):
    """The sentence of a check where it fails: the formula of it, and what that gives by the engine."""

    says: str
    text: str

    def then(self, other: Self) -> "CheckSentence":
        """Return this sentence with another behind it."""
        return CheckSentence("&".join(filter(None, [self.says, other.says])), self.text + other.text)


NOTHING = CheckSentence("", "")


def amount(cell: str, value: float, before: str, after: str) -> CheckSentence:
    """Return a sentence on the amount that a formula without = gives, rounded for people, between words."""
    return around(as_shown_formula(cell), as_shown(value), before, after)


def around(shows: str, shown: str, before: str, after: str) -> CheckSentence:
    """Return a sentence of what a formula shows between words."""
    texts = [before and quoted(before), shows, after and quoted(after)]
    return CheckSentence("&".join(filter(None, texts)), f"{before}{shown}{after}")


def exceeding(cell: str, limit: str, unit: str, value: float, most: float) -> CheckSentence:
    """Return a sentence on a value above its limit, by formulas and engine: what it is, and by how much too large."""
    number = amount(cell, value, "", f" {unit}, ")
    return number.then(amount(f"{cell}-{limit}", value - most, "", f" {unit} too much"))


def as_shown_formula(cell: str) -> str:
    """Return the formula that rounds an amount for people."""
    return f"ROUND({cell},{PLACES})"


def as_shown(value: float) -> str:
    """Return an amount as sentences show it."""
    return f"{round(value, PLACES) + 0.0:.15g}"
