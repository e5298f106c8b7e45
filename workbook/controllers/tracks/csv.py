"""Switches as columns of text: track, from, to."""

from __future__ import annotations

from workbook.controllers.number import LREAL
from workbook.controllers.tappets import HandedTracks, Tappets, Track, gathered
from workbook.controllers.target import Claim
from workbook.controllers.text import joined, numbers


def write(handed: HandedTracks) -> str:
    """Return comments, a line of titles, and a line a time."""
    titles = handed.separator.join(("track", "on from", "to"))
    head = "".join(f"# {line}\r\n" for line in (*handed.header, *handed.called, titles))
    rows = [[str(number), LREAL.text(begin), LREAL.text(end)] for number, begin, end in handed.times]
    return head + joined(rows, handed.separator, handed.decimal)


def read(text: str) -> list[Track]:
    """Return the tracks of a text of three columns."""
    return gathered(text, ((number, begin, end) for number, begin, end in numbers(text, (3,))))


TAPPETS = Tappets(
    "track, on from, to",
    write,
    read,
    (Claim("on from one angle to another; past the end of the cycle where to is less", "documented", "this project"),),
)
