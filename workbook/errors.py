"""Errors that a user can mend; each message is a line without control characters: what, where, what is expected."""

from collections.abc import Sequence
from typing import Any
from unicodedata import category

AGREES, DISAGREES, UNREADABLE, FAILS = 0, 1, 2, 3  # exit codes of the command
MOST = 40  # faults that are reported, of thousands
LONGEST = 60  # characters that a message repeats of a wrong value
UNFIT = ("Cc", "Cf", "Cs", "Cn", "Zl", "Zp")
"""categories of Unicode: controls, format marks, surrogates, unassigned, ends of lines and of paragraphs"""


def visible(text: str, safe: str = "") -> str:
    r"""Return a text in a line, unprintable characters but those ``safe`` as escapes such as ``\x1b``."""
    if text.isprintable():
        return text
    return "".join(
        c.encode("unicode_escape", "surrogatepass").decode() if category(c) in UNFIT and c not in safe else c
        for c in text
    )


def listed(names: list[str], most: int = 3) -> str:
    """Return the first names, and how many more there are."""
    rest = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + rest


def quoted(value: Any) -> str:
    """Return a value as an engineer wrote it, in short and in a line."""
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


class MotionbookError(Exception):
    """An error that is the file's or the engineer's to mend; its text, in a line, is all that is shown."""

    def __init__(self, line: str) -> None:
        super().__init__(visible(line))


class InputError(MotionbookError):
    """Entries that cannot be used; a line each, and of thousands the first."""

    def __init__(self, lines: Sequence[str]) -> None:
        shown = [*lines[:MOST], *([f"… and {len(lines) - MOST:,} more faults"] if len(lines) > MOST else [])]
        self.lines = [visible(line) for line in shown]
        Exception.__init__(self, "\n".join(self.lines))

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the error by its lines."""
        return InputError, (self.lines,)


class ReadError(MotionbookError):
    """A file that cannot be read as what it should be."""


class WriteError(MotionbookError):
    """A file that cannot be written, or must not be."""


class TargetError(MotionbookError):
    """A motion that a target cannot take, or a file that holds no cam table."""


class WitnessError(MotionbookError):
    """A witness that is absent, or that cannot evaluate the file."""


class DisputedError(ValueError):
    """A formula whose value is in doubt, in words that follow the formula."""
