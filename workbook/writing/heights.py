"""How high a row of wrapped texts must be: its lines, by how wide letters are in Calibri."""

from __future__ import annotations

NARROW, SLIM, BROAD = "ilj.,:;'|()[] ", "tfr", "mwMW%ω"
EMS = {**dict.fromkeys(NARROW, 0.3), **dict.fromkeys(SLIM, 0.37), **dict.fromkeys(BROAD, 0.84)}
CAPITAL, LETTER, DIGIT = 0.62, 0.545, 0.507
"""of the em, rather more than less: a text must not be cut"""
FULL = 11.0
"""points in which a column's width is counted"""


BOLD = 1.06
"""how much wider than others bold letters are"""


def width(text: str, points: float, bold: bool = False) -> float:
    """Return how wide a text is at most, in digits of a column's width."""
    ems = sum(EMS.get(letter, CAPITAL if letter.isupper() else LETTER) for letter in text)
    return ems * points / FULL / DIGIT * (BOLD if bold else 1.0)


def lines(text: str, points: float, room: float) -> int:
    """Return how many lines a text takes that is wrapped at its blanks, in a column ``room`` wide."""
    count, taken = 1, 0.0
    for word in text.split():
        needed = width(f" {word}" if taken else word, points)
        if taken and taken + needed > room:
            count, taken, needed = count + 1, 0.0, width(word, points)
        taken += needed
        while taken > room:
            count, taken = count + 1, taken - room
    return count
