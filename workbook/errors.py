"""What can go wrong at the edges, each said in one line: what, where, what is expected; the exit codes."""

from collections.abc import Sequence
from typing import Any

from workbook.visible import visible

AGREES, DISAGREES, UNREADABLE, FAILS = 0, 1, 2, 3  # exit codes of the command
MOST = 40  # faults that are told, of thousands


class MotionbookError(Exception):
    """An error that is the file's or the engineer's to mend; its text, in one line, is all that is shown."""

    def __init__(self, line: str) -> None:
        super().__init__(visible(line))


class InputError(MotionbookError):
    """Entries that cannot be used; one line each, and of thousands the first."""

    def __init__(self, lines: Sequence[str]) -> None:
        told = [*lines[:MOST], *([f"… and {len(lines) - MOST:,} more faults"] if len(lines) > MOST else [])]
        self.lines = [visible(line) for line in told]
        Exception.__init__(self, "\n".join(self.lines))

    def __reduce__(self) -> tuple[Any, ...]:
        """To another process it goes by its lines."""
        return InputError, (self.lines,)


class ReadError(MotionbookError):
    """A file that cannot be read as what it should be."""


class WriteError(MotionbookError):
    """A file that cannot be written, or must not be."""


class TargetError(MotionbookError):
    """What a controller cannot be given, or a table that none could be."""


class WitnessError(MotionbookError):
    """A witness that is absent, or that cannot evaluate the file."""


class TooLargeError(WitnessError):
    """A file that is larger than a witness takes."""


class DisputedError(ValueError):
    """A formula whose value is in doubt, in words that follow the formula."""
