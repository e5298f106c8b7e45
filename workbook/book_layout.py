"""The layout of a book as its cell book_layout says it: what of a description decides which cells there are.

It is the description of the machine without all that is entered in cells, as JSON. Of an entry that is marked by
:class:`~workbook.fields.types.MakesCells` a stand-in is there, of a law with a name of its own its family.
"""

import json
import re
from typing import Any
from zlib import crc32

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from workbook.book.declare import Book
from workbook.entries import rules
from workbook.entries.machine import Machine
from workbook.errors import quoted
from workbook.fields.paths import put, split
from workbook.fields.types import MakesCells
from workbook.law_sheets.library import named_laws

NAME = "book_layout"
CHECKSUM = "checksum"
INPUTS = "inputs"  # how many keys of entries have cells
ROW = re.compile(r"\.\d+(?=\.|$)")


def layout_text(machine: Machine, book: Book) -> str:
    """Return the layout of a declared book as JSON, with a checksum."""
    layout = layout_of(machine, book)
    return as_json(layout | {CHECKSUM: checksum(layout)})


def layout_of(machine: Machine, book: Book) -> dict[str, Any]:
    """Return the description of a machine without the entries that have a cell in its book."""
    keys = input_keys(book)
    layout: dict[str, Any] = {"template": machine.template, INPUTS: len(keys)}
    layout |= without_cells(machine, "", {ROW.sub(".*", key) for key in keys})
    own = (law for law in named_laws(machine.laws) if not law.basic)
    layout["sizes"] = machine.sizes.model_dump(exclude_none=True)
    layout["laws"] = {
        law.slug: law.entered.model_dump(include={"family", *law.page.without_cells}, exclude_none=True) for law in own
    }
    for key, value in machine.layout_entries().items():
        put(layout, split(key), value)
    return layout


def input_keys(book: Book) -> list[str]:
    """Return the keys of all entries that have cells in a book; of a table that of each column."""
    return [q.key for block in book.blocks.values() for q in block.quantities if q.role == "input"]


def without_cells(model: BaseModel, path: str, keys: set[str]) -> dict[str, Any]:
    """Return the entries of a model, at a ``path``, whose keys are none of ``keys``; of marked ones the stand-in."""
    fields, hidden = type(model).model_fields, () if path else ("laws", "sizes")
    held = {name: value for name, value in model if value not in (None, []) and name not in hidden}
    named = {name: entry_without_cells(value, fields[name], f"{path}{name}", keys) for name, value in held.items()}
    return {name: entry for name, entry in named.items() if entry is not None}


def entry_without_cells(value: Any, field: FieldInfo, key: str, keys: set[str]) -> Any:
    """Return the part of an entry that its layout has; None where it has none."""
    default = rules.default_of(field)
    marks = [c for c in rules.unwrap(field.annotation, field.metadata)[1] if isinstance(c, MakesCells)]
    if isinstance(value, BaseModel):
        return without_cells(value, f"{key}.", keys) or ({} if default is None else None)
    if marks and marks[0].stand_in is not None:
        return marks[0].stand_in
    # a description without such a list would have the rows of the default
    if isinstance(value, list):
        return [without_cells(row, f"{key}.*.", keys) for row in value] if marks else [] if default else None
    return None if key in keys or value == default else value


def read_layout(text: Any, template: str) -> dict[str, Any]:
    """Return the layout in the content of a cell; raise ValueError, in words, where it is damaged, or no template's."""
    try:
        layout = json.loads(text)
        sound = layout.pop(CHECKSUM) == checksum(layout) and all(law["family"] for law in layout["laws"].values())
    except (ValueError, TypeError, LookupError, AttributeError, RecursionError):
        sound = False
    if not sound:
        held = "empty" if text is None else "not as motionbook wrote it"
        raise ValueError(f"{held}; expected what the tables of this book are")
    if (name := layout.get("template")) != template:
        raise ValueError(f"the tables of a book of the template {quoted(name)}; expected those of {template}")
    return dict(layout)


def checksum(layout: dict[str, Any]) -> int:
    """Return a number that shows whether a layout was changed."""
    return crc32(as_json(layout).encode())


def as_json(data: Any) -> str:
    """Return data as JSON in one line."""
    return json.dumps(data, separators=(",", ":"), ensure_ascii=False)
