"""Titles of sheets that are named by an entry: such as Excel takes, and no other sheet of the book has."""

import re
from collections.abc import Iterable

from workbook.entries.texts import alike

LONGEST = 31  # characters of a sheet's title, as UTF-16 counts them; Excel's limit
RESERVED = ("Summary", "Cycle", "Drive cycle", "Pieces", "Laws", "Export", "Checks", "History")
"""sheets that come later, and a title that Excel keeps for itself"""


def sheet_title(name: str, taken: Iterable[str], plain: str = "Law") -> str:
    """Return a title for the sheet of a name; ``plain`` for a name of which nothing is left."""
    words = cut(re.sub(r"[\[\]:*?/\\]", "-", name), LONGEST) or plain
    others = {alike(title) for title in (*taken, *RESERVED)}
    found, more = words, 1
    while alike(found) in others:
        more += 1
        ending = f" ({more})"
        found = cut(words, LONGEST - len(ending)) + ending
    return found


def cut(text: str, most: int) -> str:
    """Return as much of a text as UTF-16 has in so many units, without apostrophes or blanks at its ends."""
    kept = text.strip("' ").encode("utf-16-le", "surrogatepass")[: 2 * most].decode("utf-16-le", "ignore")
    return kept.strip("' ")
