"""What can go wrong at the edges, each said in one line: what, where, what is expected."""

from __future__ import annotations


class MotionbookError(Exception):
    """An error that is the file's or the engineer's to mend; its text is all that is shown."""


class InputError(MotionbookError):
    """Entries that cannot be used; one line each."""

    def __init__(self, lines: list[str]) -> None:
        super().__init__("\n".join(lines))
        self.lines = lines


class ReadError(MotionbookError):
    """A file that cannot be read as what it should be."""


class WriteError(MotionbookError):
    """A file that cannot be written, or must not be."""


class WitnessError(MotionbookError):
    """A witness that is absent, or that cannot evaluate the file."""
