"""Print on a terminal; no text acts as a control sequence or as rich's markup."""

import io
import json
import os
import sys
from collections.abc import Callable, Container, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table
from rich.text import Text

from workbook.errors import visible
from workbook.writing.output_files import write_text

OUT = Console()
ERR = Console(stderr=True)


def shown(text: str, style: str = "") -> Text:
    """Return a text as rich takes it: in a line, in no markup, no emoji, no colours of its own."""
    return Text(visible(text), style)


def say(console: Console, text: str, style: str = "") -> None:
    """Print a text as a line, however long."""
    console.print(shown(text, style), soft_wrap=True)


def say_data(text: str) -> None:
    r"""Print lines of JSON or TOML, with escapes that both know, such as ``\u009b``, for what a terminal may obey."""
    # none is obeyed beyond U+FFFF
    plain = (c == "\n" or c.isprintable() or ord(c) > 0xFFFF for c in text)
    print("".join(c if shown else f"\\u{ord(c):04x}" for c, shown in zip(text, plain, strict=True)), end="")


def say_json(data: Any, **ways: Any) -> None:
    """Print data as JSON."""
    say_data(f"{json.dumps(data, ensure_ascii=False, indent=1, **ways)}\n")


def print_or_write(text: str, output: Path | None, force: bool) -> None:
    """Print lines of data, or write them to a file that is named."""
    if output is None:
        say_data(text)
    else:
        write_text(output, text, force)
        say(OUT, f"Wrote {output.absolute()}")


def show_table(
    console: Console,
    headings: Iterable[str],
    rows: Iterable[Iterable[str]],
    right: Container[int] = (),
    title: str | Text | None = None,
    **look: Any,
) -> None:
    """Print rows of texts under headings; the columns ``right`` stand to the right."""
    grid = Table(title=title, title_justify="left", **look)
    for k, heading in enumerate(headings):
        grid.add_column(shown(heading), justify="right" if k in right else "left", overflow="fold")
    for row in rows:
        grid.add_row(*map(shown, row))
    console.print(grid)


class TolerantOutput(io.TextIOWrapper):
    """An output that never raises: what cannot be written is dropped, and ``fault`` says why."""

    fault: OSError | None = None

    def write(self, text: str) -> int:
        """Write as long as that is possible."""
        with self._kept():
            super().write(text)
        return len(text)

    def flush(self) -> None:
        """Hand on what was written, as long as that is possible."""
        with self._kept():
            super().flush()

    @contextmanager
    def _kept(self) -> Iterator[None]:
        try:
            yield
        except OSError as error:
            self.fault = self.fault or error
            os.dup2(os.open(os.devnull, os.O_WRONLY), self.fileno())  # the rest goes nowhere


@contextmanager
def tolerant_outputs() -> Iterator[Callable[[], OSError | None]]:
    """Make stdout and stderr tolerant; give a function that flushes both, and returns why stdout failed, if it did.

    They print names of files too, on terminals that lack their letters.
    """
    before = sys.stdout, sys.stderr
    out, err = (
        TolerantOutput(stream.buffer, stream.encoding, "backslashreplace", line_buffering=True) for stream in before
    )
    sys.stdout, sys.stderr = out, err

    def fault() -> OSError | None:
        out.flush()
        err.flush()
        return out.fault

    try:
        yield fault
    finally:
        fault()
        sys.stdout, sys.stderr = before
        out.detach()
        err.detach()
