"""What is shown on a terminal: texts that neither it nor rich's markup obeys."""

from __future__ import annotations

import io
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple, TextIO

from rich.console import Console
from rich.text import Text

from workbook.visible import visible

OUT = Console()
ERR = Console(stderr=True)


def shown(text: str, style: str = "") -> Text:
    """Return a text as rich takes it: in one line, in no markup, no emoji, no colours of its own."""
    return Text(visible(text), style)


def say(console: Console, text: str, style: str = "") -> None:
    """Print a text as one line, however long."""
    console.print(shown(text, style), soft_wrap=True)


def say_data(text: str) -> None:
    r"""Print lines of JSON or TOML, with escapes that both know, such as ``\u009b``, for what a terminal may obey."""
    print(text if text.isprintable() else "".join(map(quoted, text)), end="")


def quoted(character: str) -> str:
    r"""Return a character as it stands in a string of JSON and of TOML; none is obeyed beyond U+FFFF."""
    plain = character == "\n" or character.isprintable() or ord(character) > 0xFFFF
    return character if plain else f"\\u{ord(character):04x}"


class Lasting(io.RawIOBase):
    """An output that takes whatever is written, also when what it leads to takes no more; ``fault`` says why not."""

    def __init__(self, raw: Any) -> None:
        self.raw = raw
        self.fault: OSError | None = None

    def write(self, data: Any) -> int:
        """Write as long as that is possible; return how many bytes were taken."""
        if self.fault is None:
            try:
                return int(self.raw.write(data) or 0)
            except OSError as error:
                self.fault = error
        return len(data)

    def writable(self) -> bool:
        """Return True."""
        return True

    def fileno(self) -> int:
        """Return the number that the system knows it by."""
        return int(self.raw.fileno())

    def isatty(self) -> bool:
        """Whether it is a terminal."""
        return bool(self.raw.isatty())

    def flush(self) -> None:
        """Write what the stream before this holds back."""


class Faults(NamedTuple):
    """Why the two outputs of a command took no more; None where they took all."""

    out: OSError | None = None
    err: OSError | None = None


@contextmanager
def lasting() -> Iterator[Callable[[], Faults]]:
    """Let both outputs of this process last; give what flushes them, and tells why they took no more."""
    before = sys.stdout, sys.stderr
    raws = [lasting_over(stream) for stream in before]
    sys.stdout, sys.stderr = (wrapped(raw, stream) for raw, stream in zip(raws, before, strict=True))

    def faults() -> Faults:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        return Faults(*(raw.fault if raw else None for raw in raws))

    try:
        yield faults
    finally:
        faults()
        sys.stdout, sys.stderr = before


def lasting_over(stream: TextIO) -> Lasting | None:
    """Return an output over what a stream leads to; None of one that is no file."""
    buffer = getattr(stream, "buffer", None)
    raw = getattr(buffer, "raw", buffer)
    stream.flush()
    return Lasting(raw) if isinstance(raw, io.RawIOBase) else None


def wrapped(raw: Lasting | None, stream: TextIO) -> TextIO:
    """Return a text over an output: names of files too, on terminals that lack their letters."""
    if raw is None:
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
        return stream
    return io.TextIOWrapper(io.BufferedWriter(raw), stream.encoding, "backslashreplace", line_buffering=True)
