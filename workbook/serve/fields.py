"""The form beside a description's text: each of its tables as rows of fields, made from what its keys say."""

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
PHRASES = ("a ", "7 ")  # what the words begin with that expect anything but one of some texts


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
    parts = {part_of(one.place): heading(part_of(one.place), data) for one in tables}
    chosen = next((one for one in parts if written(one) == part), ())
    said = faults(name, text, data)
    shown = [(one, *fields(one, said, data)) for one in tables if part_of(one.place) == chosen]
    return rendered("serve/form.html", parts=parts, chosen=chosen, tables=shown, said=said, spell=spell,
                    written=written, default_of=default_of)  # fmt: skip


def heading(part: Place, data: dict[str, Any]) -> str:
    """Return what a part of a description is called in the list of them, a row with its name."""
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
    """Return what is wrong with a description by the key of the entry."""
    try:
        return {fault.key: fault.message for fault in design(name, text).machine.design.faults}
    except MotionbookError:
        pass
    try:
        template = template_named(data.get("template"), "template")
        described(template, data, lambda key: key)
    except InputError as error:
        return {key: said for key, _, said in (line.partition(": ") for line in error.lines)}
    return {}


def fields(of: Table, said: dict[str, str], data: dict[str, Any]) -> tuple[list[Field], list[Grid]]:
    """Return the fields of a table that is there, and its lists."""
    single, grids = list[Field](), list[Grid]()
    for key in of.section.keys if of.entries is not None else ():
        place, value = (*of.place, key.name), (of.entries or {}).get(key.name)
        if key.rows and isinstance(value, list | None):
            grids.append(grid(key, place, value or [], said, data))
        else:
            single.append(field(key, place, value, said, data))
    return single, grids


def grid(key: Key, place: Place, entries: list[Any], said: dict[str, str], data: dict[str, Any]) -> Grid:
    """Return the rows of a list, a field for each of their entries, last those that a row may be without."""
    columns = sorted(enumerate(key.rows), key=lambda column: column[1].default is None and not column[1].required)
    rows = []
    for k, row in enumerate(entries):
        found = dict(enumerate(row)) if isinstance(row, list) else row  # a time of being on may be a pair of numbers
        names = [(one, n if isinstance(row, list) else one.name) for n, one in columns]
        way = (*place, str(k))
        rows.append((way, [field(one, (*way, str(at)), found.get(at), said, data) for one, at in names]))
    return Grid(key, place, [one for _, one in columns], rows)


def field(key: Key, place: Place, value: Any, said: dict[str, str], data: dict[str, Any]) -> Field:
    """Return the field of an entry; where it is one of some texts, these are proposed as one types."""
    shown = "" if value is None else value if isinstance(value, str) else toml(value)
    known = [] if isinstance(value, bool) else choices(key, data)
    return Field(key, place, shown, said.get(join(place), ""), known)


def choices(key: Key, data: dict[str, Any]) -> list[str]:
    """Return the texts that an entry may be, where these are known: products, laws, words."""
    if key.path in PRODUCTS:
        return [str(getattr(product, "name", "")) for product in COMMITTED[PRODUCTS[key.path]]()]
    if key.name == "law":
        return list(dict.fromkeys([*ENTRIES, *data.get("laws", {})]))
    return [] if key.expected.startswith(PHRASES) else EITHER.split(key.expected)
