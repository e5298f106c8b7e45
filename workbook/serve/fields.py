"""The form beside a description's text: each of its tables as rows of fields, by the facts of its keys."""

import json
import re
from pathlib import Path
from typing import Any, NamedTuple

from workbook.description.keys import PRODUCTS, Key, default_of, toml
from workbook.errors import InputError, MotionbookError
from workbook.fields.paths import Place, join, spell
from workbook.laws.entries import ENTRIES
from workbook.reading.descriptions import described, parse_toml, template_named
from workbook.reports.html import paragraphs, rendered
from workbook.selection.entries import COMMITTED
from workbook.serve.live import design
from workbook.serve.tables import Table, changed, part_of, tables_of, written

EITHER = re.compile(r", | or ")
PHRASES = ("a ", "7 ")  # begins of the words that expect anything but a choice of texts


class Field(NamedTuple):
    """A field: the key of its entry, where that is, what it says, what is wrong with it, the texts proposed."""

    key: Key
    place: Place
    value: str
    wrong: str
    known: list[str]


class Grid(NamedTuple):
    """A list of entries: its key and where it is, its columns, and the fields of each row with the row's place."""

    key: Key
    place: Place
    columns: list[Key]
    rows: list[tuple[Place, list[Field]]]


def form(name: str, text: str, part: str) -> str:
    """Return the HTML of the form of a part of a description; a message where the text is not TOML."""
    try:
        data = parse_toml(text, Path(name))
        template = template_named(data.get("template"), "template")
    except MotionbookError as error:
        return paragraphs(error)
    tables = tables_of(template.name, data)
    parts = {part_of(table.place): heading(part_of(table.place), data) for table in tables}
    chosen = next((place for place in parts if written(place) == part), ())
    messages = faults(name, text, data)
    shown = [(table, *fields(table, messages, data)) for table in tables if part_of(table.place) == chosen]
    return rendered(
        "serve/form.html",
        parts=parts,
        chosen=chosen,
        tables=shown,
        messages=messages,
        spell=spell,
        written=written,
        default_of=default_of,
    )


def heading(part: Place, data: dict[str, Any]) -> str:
    """Return the label of a part of a description in the list of parts, a row with its name."""
    rows = data.get(part[0]) if part[1:] else None
    return f"{spell(part)} {rows[int(part[1])].get('name', '') if rows else ''}".strip() or "machine"


def entered(name: str, text: str, path: str, do: str, value: str) -> str:
    """Return the text with what was entered in a field at a path, or done by a button beside it."""
    data = parse_toml(text, Path(name))
    template = template_named(data.get("template"), "template")
    try:
        place = json.loads(path)
    except ValueError:
        place = None
    if not isinstance(place, list) or not place or not all(isinstance(part, str) for part in place):
        raise InputError([f"{path!r}: expected the names of an entry"])
    return changed(text, template.name, data, tuple(place), do, value)


def faults(name: str, text: str, data: dict[str, Any]) -> dict[str, str]:
    """Return the faults of a description by the keys of entries."""
    try:
        return {fault.key: fault.message for fault in design(name, text).machine.design.faults}
    except MotionbookError:
        pass
    try:
        template = template_named(data.get("template"), "template")
        described(template, data, lambda key: key)
    except InputError as error:
        return {key: message for key, _, message in (line.partition(": ") for line in error.lines)}
    return {}


def fields(of: Table, messages: dict[str, str], data: dict[str, Any]) -> tuple[list[Field], list[Grid]]:
    """Return the fields of a table that is there, and its lists."""
    single, grids = list[Field](), list[Grid]()
    for key in of.section.keys if of.entries is not None else ():
        place, value = (*of.place, key.name), (of.entries or {}).get(key.name)
        if key.rows and isinstance(value, list | None):
            grids.append(grid(key, place, value or [], messages, data))
        else:
            single.append(field(key, place, value, messages, data))
    return single, grids


def grid(key: Key, place: Place, entries: list[Any], messages: dict[str, str], data: dict[str, Any]) -> Grid:
    """Return the rows of a list, a field for each of their entries, last those that a row may be without."""
    columns = sorted(enumerate(key.rows), key=lambda column: column[1].default is None and not column[1].required)
    rows = []
    for k, row in enumerate(entries):
        values = dict(enumerate(row)) if isinstance(row, list) else row  # a time of being on may be a pair of numbers
        names = [(column, n if isinstance(row, list) else column.name) for n, column in columns]
        way = (*place, str(k))
        rows.append((way, [field(column, (*way, str(at)), values.get(at), messages, data) for column, at in names]))
    return Grid(key, place, [column for _, column in columns], rows)


def field(key: Key, place: Place, value: Any, messages: dict[str, str], data: dict[str, Any]) -> Field:
    """Return the field of an entry; where the entry takes some texts only, they are proposed while typing."""
    shown = "" if value is None else value if isinstance(value, str) else toml(value)
    known = [] if isinstance(value, bool) else choices(key, data)
    return Field(key, place, shown, messages.get(join(place), ""), known)


def choices(key: Key, data: dict[str, Any]) -> list[str]:
    """Return the texts that an entry may be, where these are known: products, laws, words."""
    if key.path in PRODUCTS:
        return [str(getattr(product, "name", "")) for product in COMMITTED[PRODUCTS[key.path]]()]
    if key.name == "law":
        return list(dict.fromkeys([*ENTRIES, *data.get("laws", {})]))
    return [] if key.expected.startswith(PHRASES) else EITHER.split(key.expected)
