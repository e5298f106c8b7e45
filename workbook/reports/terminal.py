"""What is shown on a terminal: texts that neither it nor rich's markup obeys."""

from __future__ import annotations

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
