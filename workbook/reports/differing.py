"""Two formulas that are not the same: where they differ, and a little around it."""

from __future__ import annotations

import re
from typing import Any

LONG = 50  # characters: a shorter formula is shown whole
AROUND = 12  # characters before and after the difference
WORD = re.compile(r"[\w.$!']")


def differing(found: Any, expected: Any) -> tuple[Any, Any]:
    """Return two long formulas without what both begin and end with, ``…`` in its place; others as they are."""
    both = found, expected
    if not all(isinstance(text, str) and text.startswith("=") for text in both) or max(map(len, both)) <= LONG:
        return both
    same = alike(found, expected)
    end = min(alike(found[::-1], expected[::-1]), min(map(len, both)) - same)
    begin = max(0, same - AROUND)
    while begin and WORD.match(found[begin - 1]) and WORD.match(found[begin]):  # not within a name
        begin -= 1
    return (part(found, begin, len(found) - end + AROUND), part(expected, begin, len(expected) - end + AROUND))


def alike(one: str, other: str) -> int:
    """Return with how many of the same characters two texts begin."""
    return next((k for k, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))


def part(text: str, begin: int, end: int) -> str:
    """Return a part of a text, with marks where more is before or after it."""
    return f"{'…' if begin else ''}{text[begin:end]}{'…' if end < len(text) else ''}"
