"""The tables and entries of a description's text by their places, and what is changed in them; its comments stay."""

import json
import re
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import Array

from workbook.description.keys import Key, Section, sections, toml
from workbook.entries.rules import KIND
from workbook.errors import InputError
from workbook.fields.paths import Place, get, reach, split, spread
from workbook.templates import TEMPLATES

COMMENTED = re.compile(r"""((?:[^"'#]|"[^"]*"|'[^']*')*?)( +)(#.*)""")  # entries, blanks, and a comment


class Table(NamedTuple):
    """A table of a description: where it is, what its keys are, and its entries; None where it is left out."""

    place: Place
    section: Section
    entries: dict[str, Any] | None


def tables_of(template: str, data: dict[str, Any]) -> list[Table]:
    """Return the tables that a description of a template has, and those that it leaves out."""
    tables = []
    for section in template_sections(template):
        for place, entries in spread(data, split(section.path)):
            kind = entries.get(KIND) if isinstance(entries, dict) else None
            if not section.kind or section.kind == kind:
                tables.append(Table(place, section, entries if isinstance(entries, dict) else None))
    return tables


@lru_cache
def template_sections(template: str) -> list[Section]:
    """Return the tables of a template's descriptions."""
    return sections(TEMPLATES[template])


def part_of(place: Place) -> Place:
    """Return the part of a description in which a table is shown: what its first name says, a row of it by itself."""
    return place[:2] if place[1:] and place[1].isdigit() else place[:1]


def written(place: Place) -> str:
    """Return a place as the page sends it."""
    return json.dumps(place, ensure_ascii=False)


def changed(text: str, template: str, data: dict[str, Any], place: Place, do: str, value: str) -> str:
    """Return the text with an entry set, or a table or row added, copied or removed; raise InputError if it cannot."""
    above = get(data, place[:-1])
    if do == "Remove":
        return edited(text, [(place, None)])
    if do == "Copy":
        return edited(text, [((*place[:-1], str(len(above))), get(data, place))])
    tables = tables_of(template, data)
    if do == "Add":
        return edited(text, [(place, example(template, tables, place))])
    key = key_of(tables, place)
    new = value_of(key, value.strip())
    changes: list[tuple[Place, Any]] = [(place, new)] if new is not None or get(data, place) is not None else []
    if key.name == KIND and isinstance(new, str):  # the table becomes a table of another kind
        keys = [
            key for section in sections_at(template, place[:-1]) if section.kind in ("", new) for key in section.keys
        ]
        gone = above.keys() - {key.name for key in keys}
        changes += [((*place[:-1], name), None) for name in above if name in gone]
        changes += [((*place[:-1], name), value) for name, value in required(keys).items() if name not in above]
    return edited(text, changes)


def key_of(tables: Sequence[Table], place: Place) -> Key:
    """Return the key of an entry; raise InputError where no table has it."""
    for table in tables:
        below = place[len(table.place) :]
        if place[: len(table.place)] != table.place or not below:
            continue
        key = next((key for key in table.section.keys if key.name == below[0]), None)
        if key is not None and len(below) == 1:
            return key
        if key is not None and len(below) == 3:  # a row of a list, by the name of its entry or by its number
            rows = {**{str(n): row for n, row in enumerate(key.rows)}, **{row.name: row for row in key.rows}}
            if below[2] in rows:
                return rows[below[2]]
    raise InputError([f"{'.'.join(place)}: there is no such entry"])


def value_of(key: Key, text: str) -> Any:
    """Return a field's value in the type of its key; a text where it has another type, which the check reports."""
    if not text:
        return None
    try:
        if key.expected.startswith("a number"):
            return float(text)
        if key.expected.startswith("a whole number"):
            return int(text)
        if key.expected == "true or false" or text.startswith("["):
            return tomlkit.value(text)
    except ValueError:
        pass
    return text


def example(template: str, tables: Sequence[Table], place: Place) -> dict[str, Any]:
    """Return a table or a row that is added, with what it must have."""
    if all(table.place != place for table in tables):
        return required(key_of(tables, place[:-1]).rows)
    row: dict[str, Any] = {"family": place[1]} if place[0] == "laws" else {}
    for section in sections_at(template, place):
        if section.kind in ("", row.get(KIND)):
            row |= required(section.keys)
    return row


def sections_at(template: str, place: Place) -> list[Section]:
    """Return a template's sections for the table at a place, a section for each kind that it may have."""
    path = ".".join("*" if part.isdigit() else part for part in place)
    return [section for section in template_sections(template) if section.path == path]


def required(keys: Sequence[Key]) -> dict[str, Any]:
    """Return the entries that a table must have, as in an example."""
    return {key.name: key.example for key in keys if key.required and key.example is not None}


def edited(text: str, changes: Iterable[tuple[Place, Any]]) -> str:
    """Return the text with other values at paths, None to remove an entry; raise InputError for a wrong text, path."""
    try:
        document = tomlkit.parse(text)
        for path, value in changes:
            put(document, path, value)
        before, after = text.split("\n"), tomlkit.dumps(document).split("\n")
    except (TOMLKitError, LookupError, TypeError, ValueError) as error:
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
