"""Change entries in the text of a description; its comments stay."""

import re
from collections.abc import Iterable
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import Array

from workbook.description.keys import toml
from workbook.errors import InputError
from workbook.fields.paths import Place, reach

COMMENTED = re.compile(r"""((?:[^"'#]|"[^"]*"|'[^']*')*?)( +)(#.*)""")  # entries, blanks, and a comment


def edit_text(text: str, changes: Iterable[tuple[Place, Any]]) -> str:
    """Return the text with other values at paths, None to remove an entry; raise InputError for a wrong text, path."""
    try:
        document = tomlkit.parse(text)
        for path, value in changes:
            put(document, path, value)
        before, after = text.split("\n"), tomlkit.dumps(document).split("\n")
    except (TOMLKitError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise InputError([f"the text cannot be changed there: {error}"]) from None
    if len(before) == len(after):  # each comment keeps its column, where the line leaves room for it
        for k, (old_line, new_line) in enumerate(zip(before, after, strict=True)):
            then, now = COMMENTED.fullmatch(old_line), COMMENTED.fullmatch(new_line)
            if then and now and then[3] == now[3]:
                after[k] = f"{now[1]:<{then.start(3) - 1}} {now[3]}"
    return "\n".join(after)


def put(table: Any, path: Place, value: Any) -> None:
    """Set an entry below a table of TOML, or take it away."""
    held, key = reach(table, path, grow=False)
    if value is None:
        del held[key]
    elif isinstance(held, list) and key == len(held):
        held.append(tomlkit.parse(f"x = {toml(value)}")["x"] if isinstance(held, Array) else value)
    else:
        held[key] = value
