"""How values and rules are written of a description: as TOML, and in a line of words."""

from typing import Any

import tomli_w
from pydantic import BaseModel

from workbook.described.keys import Key


def toml(value: Any) -> str:
    """Return a value as a description has it, a row of a table in one line."""
    if isinstance(value, BaseModel):
        value = value.model_dump(exclude_none=True)
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{k} = {toml(v)}' for k, v in value.items() if v is not None)} }}" if value else "{}"
    if isinstance(value, list):
        return f"[{', '.join(map(toml, value))}]"
    return tomli_w.dumps({"x": value}).removeprefix("x = ").rstrip("\n")


def default_of(key: Key) -> str:
    """Return what an optional key is where it is left out; nothing of one that must be there."""
    if key.required:
        return ""
    if key.rows and key.default:
        return f"{len(key.default)} row{'s' if key.default[1:] else ''}"
    if isinstance(key.default, float):
        return f"{key.default:.4g}"
    return "none" if key.default in (None, "", []) else toml(key.default)


def remark(key: Key) -> str:
    """Return in a line what a key means, what it takes, and what it is where it is left out."""
    unit = f" [{key.unit}]" if key.unit else ""
    default = default_of(key)
    optional = "" if key.required else "; optional" if default == "none" else f"; optional, else {default}"
    return f"{key.meaning}{unit}: {key.expected}{optional}"
