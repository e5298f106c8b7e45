"""What is shown on a terminal: texts that neither it nor rich's markup obeys."""

import io
import json
import sys
from collections.abc import Callable, Container, Iterable, Iterator
from contextlib import contextmanager
from typing import Any, TextIO

from rich.console import Console
from rich.table import Table
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
    plain = (c == "\n" or c.isprintable() or ord(c) > 0xFFFF for c in text)  # none is obeyed beyond U+FFFF
    print("".join(c if shown else f"\\u{ord(c):04x}" for c, shown in zip(text, plain, strict=True)), end="")


def say_json(data: Any, **ways: Any) -> None:
    """Print data as JSON."""
    say_data(f"{json.dumps(data, ensure_ascii=False, indent=1, **ways)}\n")


def show_table(
    console: Console, headings: Iterable[str], rows: Iterable[Iterable[str]], right: Container[int] = (),
    title: str | Text | None = None, **look: Any,
) -> None:  # fmt: skip
    """Print rows of texts under headings; the columns ``right`` stand to the right."""
    grid = Table(title=title, title_justify="left", **look)
    for k, heading in enumerate(headings):
        grid.add_column(shown(heading), justify="right" if k in right else "left")
    for row in rows:
        grid.add_row(*map(shown, row))
    console.print(grid)


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


@contextmanager
def lasting() -> Iterator[Callable[[], OSError | None]]:
    """Let both outputs of this process last; give what flushes them, and tells why the first took no more."""
    before = sys.stdout, sys.stderr
    out, sys.stderr = map(lasted, before)
    sys.stdout = out

    def fault() -> OSError | None:
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        raw = getattr(getattr(out, "buffer", None), "raw", None)
        return raw.fault if isinstance(raw, Lasting) else None

    try:
        yield fault
    finally:
        fault()
        sys.stdout, sys.stderr = before


def lasted(stream: TextIO) -> TextIO:
    """Return a text over an output that lasts: names of files too, on terminals that lack their letters."""
    buffer = getattr(stream, "buffer", None)
    raw = getattr(buffer, "raw", buffer)
    stream.flush()
    if isinstance(raw, io.RawIOBase):
        lasts = io.BufferedWriter(Lasting(raw))
        return io.TextIOWrapper(lasts, stream.encoding, "backslashreplace", line_buffering=True)
    if isinstance(stream, io.TextIOWrapper):
        stream.reconfigure(errors="backslashreplace")
    return stream
