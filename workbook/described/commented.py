"""A description with every key and what it means, in the values of the committed example."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from workbook.described.keys import Key, Section, sections
from workbook.described.words import remark, toml
from workbook.entries.design import as_entered
from workbook.laws.entries import key_of
from workbook.reading.descriptions import read_machine
from workbook.selection.entries import referred
from workbook.templates import AnyTemplate

WIDTH = 110
COUNTED = "sizes."
"""entries that are worked out where they are left out, whatever an example came to"""


def commented(template: AnyTemplate, schema: str) -> str:
    """Return a new description of a template; ``schema`` is the file that editors complete its keys from."""
    data = referred(as_entered(read_machine(template.description)))
    blocks = ["\n".join([f"#:schema {schema}", *remarks(HEAD)])]
    known = sections(template)
    for section in known:
        if ".*." not in section.path:
            below = [inner for inner in known if inner.path.startswith(f"{section.path}.") and ".*." in inner.path]
            blocks += written(section, below, data)
    return "\n\n".join(blocks) + "\n"


HEAD = "Every key is here, with the values of an example: change what differs, and leave out what is optional."


def written(section: Section, below: Sequence[Section], data: Mapping[str, Any]) -> Iterator[str]:
    """Yield the tables of a section: one, or each of a list, with those of its row below it."""
    if section.path.startswith("laws."):
        yield from of_family(section, data)
        return
    title = section.path.removesuffix(".*")
    values = found(data, title.split(".") if title else [])
    if isinstance(values, list):
        for i, row in enumerate(values):
            about = [] if i else remarks(section.about)
            yield "\n".join([*about, f"[[{title}]]", *entries(section, row, not i)])
            for inner in below:
                part = found(row, [inner.path.removeprefix(f"{section.path}.")])
                named = inner._replace(path=inner.path.replace(".*", ""))
                yield one_table(named, part, not i)
    else:
        yield one_table(section, values, True)


def of_family(section: Section, data: Mapping[str, Any]) -> Iterator[str]:
    """Yield the laws of a family: the basic one of its code, then those of other names, or one in comments."""
    code = section.path.rpartition(".")[2]
    laws = data["laws"]
    names = [name for name, entry in laws.items() if name == code or entry.get("family") == code]
    for i, name in enumerate(names):
        own = [] if name == code else [f"family = {toml(code)}"]
        about = [] if i else remarks(section.about)
        yield "\n".join([*about, f"[laws.{key_of(name)}]", *own, *entries(section, laws[name], not i)])
    if not names:
        lines = [f"[{section.path}]", f"family = {toml(code)}", *entries(section, stand_ins(section), True)]
        yield "\n".join([*remarks(section.about), *(f"# {line}" for line in lines)])


def stand_ins(section: Section) -> dict[str, Any]:
    """Return a table that shows how its keys are written."""
    return {key.name: shown(key) for key in section.keys}


def one_table(section: Section, values: Mapping[str, Any] | None, explained: bool) -> str:
    """Return a table, in comments where the example has none."""
    about = remarks(section.about) if section.path and explained else []
    head = [f"[{section.path}]"] if section.path else []
    if values is not None:
        return "\n".join([*about, *head, *entries(section, values, explained)])
    lines = [*head, *entries(section, stand_ins(section), True)]
    return "\n".join([*about, *(f"# {line}" for line in lines)])


def entries(section: Section, values: Mapping[str, Any], explained: bool) -> Iterator[str]:
    """Yield the lines of a table: what each key means, then the key."""
    for key in section.keys:
        if explained:
            yield from remarks(remark(key))
        value = None if key.path.startswith(COUNTED) and key.default is None else values.get(key.name)
        if key.rows and explained:
            yield from (f"#   {line}" for row in key.rows for line in wrapped(f"{row.name}: {remark(row)}", 4))
        if isinstance(value, list) and key.rows and value:
            yield f"{key.name} = ["
            yield from (f"  {toml(row)}," for row in value)
            yield "]"
        elif value is None:
            yield f"# {key.name} = {toml(shown(key))}"
        else:
            yield f"{key.name} = {toml(value)}"


def shown(key: Key) -> Any:
    """Return a value that shows how a key is written which the example does not have."""
    return next((value for value in (key.example, key.default) if value not in (None, "")), key.any)


def found(data: Any, path: list[str]) -> Any:
    """Return what a description has at a path; None where there is nothing."""
    for part in path:
        data = data.get(part) if isinstance(data, Mapping) else None
    return data


def remarks(text: str) -> list[str]:
    """Return a text as comments."""
    return [f"# {line}" for line in wrapped(text)]


def wrapped(text: str, indent: int = 2) -> list[str]:
    """Return a text in lines."""
    return textwrap.wrap(text, WIDTH - indent, break_long_words=False, break_on_hyphens=False)
