"""Texts of files and paths, made fit to be shown: no terminal obeys what they hold."""

from typing import Any
from unicodedata import category

LONGEST = 60  # characters that a message repeats of what was found
UNFIT = ("Cc", "Cf", "Cs", "Cn", "Zl", "Zp")
"""control, bidirectional and other marks, halves of characters, no characters, ends of lines and of paragraphs"""


def visible(text: str, kept: str = "") -> str:
    r"""Return a text in one line, with escapes such as ``\x1b`` of what is none to read, but those ``kept``."""
    if text.isprintable():
        return text
    return "".join(c.encode("unicode_escape", "surrogatepass").decode() if category(c) in UNFIT and c not in kept else c
                   for c in text)  # fmt: skip


def found(value: Any) -> str:
    """Return what was found as an engineer wrote it, in short and in one line."""
    if isinstance(value, bool):
        return str(value).upper()
    if isinstance(value, int) and abs(value) >= 10**LONGEST:
        return f"a whole number of more than {LONGEST} digits"
    try:
        text = repr(value[: LONGEST + 1] if isinstance(value, str) else value)
    except (RecursionError, ValueError):  # the latter of a whole number within, of more digits than Python writes
        text = f"a {type(value).__name__} of too much to be shown"
    if not isinstance(value, str | list | dict):
        text = str(value)
    return visible(text if len(text) <= LONGEST else f"{text[:LONGEST]}…")
