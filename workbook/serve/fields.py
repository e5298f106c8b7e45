"""The form beside a description's text: each of its tables as rows of fields, made from what its keys say."""

import json
import re
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

from workbook.description.keys import PRODUCTS, Key, default_of, toml
from workbook.errors import InputError, MotionbookError
from workbook.laws.entries import ENTRIES
from workbook.reading.descriptions import parse_toml, template_named, validated
from workbook.reports.html import Content, e, markup, table
from workbook.selection.entries import COMMITTED
from workbook.serve.live import design
from workbook.serve.tables import Place, Table, changed, part_of, tables_of, written
from workbook.studies.paths import written as counted

EITHER = re.compile(r", | or ")
PHRASES = ("a ", "7 ")  # what the words begin with that expect anything but one of some texts


def form(name: str, text: str, part: str) -> str:
    """Return the HTML of the form of a part of a description; a message where the text is not TOML."""
    try:
        data = parse_toml(text, Path(name))
        template = template_named(data.get("template"), "template")
    except MotionbookError as error:
        return markup(*(e("p", line) for line in str(error).splitlines()))
    tables = tables_of(template.name, data)
    parts = dict.fromkeys(part_of(one.place) for one in tables)
    chosen = next((one for one in parts if written(one) == part), ())
    options = []
    for one in parts:
        listed = data.get(one[0]) if one[1:] else None
        called = f"{counted(one)} {listed[int(one[1])].get('name', '') if listed else ''}".strip() if one else "machine"
        options.append(e("option", called, value=written(one), **({"selected": "selected"} if one == chosen else {})))
    said = faults(name, text, data)
    shown = [row for one in tables if part_of(one.place) == chosen for row in rows(one, said, data)]
    return markup(e("label", "Part ", e("select", *options, id="part")), e("div", *shown))


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
        return {fault.key: fault.said for fault in design(name, text).machine.design.faults}
    except MotionbookError:
        pass
    try:
        validated(template_named(data.get("template"), "template"), data, lambda key: key)
    except InputError as error:
        return {key: said for key, _, said in (line.partition(": ") for line in error.lines)}
    return {}


def rows(of: Table, said: dict[str, str], data: dict[str, Any]) -> list[Element]:
    """Return the heading of a table and its fields, a row each; of one that is left out, a button that adds it."""
    place, section = of.place, of.section
    if section.kind:
        heading: list[Element] = []
    else:
        listed = section.path.endswith(".*")
        does = ("Add",) if of.entries is None else ("Copy", "Remove") if listed else ("Remove",) if place else ()
        heading = [e("h3", counted(place) or "machine", " ", *(button(place, word) for word in does))]
    if of.entries is None:
        return heading
    message = said.get(".".join(place), "")
    lines, grids = list[list[Content]](), list[Element]()
    for key in section.keys:
        way, value = (*place, key.name), of.entries.get(key.name)
        if key.rows and isinstance(value, list | None):
            grids += grid(key, way, value or [], said, data)
        else:
            wrong = said.get(".".join(way), "")
            expected = "" if key.expected.startswith("a text") or choices(key, data) else key.expected
            limits = e("span", wrong or expected, css="disagrees" if wrong else "quiet")
            lines.append([key.meaning, field(key, way, value, wrong, data), key.unit, limits])
    shown = [table(("", "", "", "Expected"), lines, ())] if lines else []
    return [*heading, *([e("p", message, css="disagrees")] if message else []), *shown, *grids]


def grid(key: Key, place: Place, entries: list[Any], said: dict[str, str], data: dict[str, Any]) -> list[Element]:
    """Return the rows of a list, a field for each of their entries, last those that a row may be without."""
    columns = sorted(enumerate(key.rows), key=lambda column: column[1].default is None and not column[1].required)
    lines: list[list[Content]] = []
    wrong = [words for path, words in said.items() if f"{path}.".startswith(f"{'.'.join(place)}.")]
    for k, row in enumerate(entries):
        cells: list[Content] = []
        for n, one in columns:
            pair = isinstance(row, list)  # a time of being on may be a pair of numbers
            value = row[n] if pair and n < len(row) else None if pair else row.get(one.name)
            way = (*place, str(k), str(n) if pair else one.name)
            cells.append(field(one, way, value, said.get(".".join(way), ""), data))
        lines.append([*cells, e("span", *(button((*place, str(k)), word) for word in ("Copy", "Remove")))])
    heads = [e("span", f"{one.name} [{one.unit}]" if one.unit else one.name, title=one.meaning) for _, one in columns]
    add = [] if entries else [button((*place, "0"), "Add")]
    inside = [e("div", table((*heads, ""), lines, ()), css="wide")] if lines else []
    heading = e("h4", f"{key.name} ", *add, title=key.meaning)
    return [heading, *inside, *(e("p", words, css="disagrees") for words in wrong)]


def button(place: Place, word: str) -> Element:
    """Return a button that adds, copies or removes a table or a row."""
    path = written(place)
    return e("button", word, type="button", **{"data-path": path, "data-do": word, "aria-label": f"{word} {path}"})


def field(key: Key, place: Place, value: Any, wrong: str, data: dict[str, Any]) -> Element:
    """Return the field of an entry; where it is one of some texts, these are proposed as one types."""
    shown = "" if value is None else value if isinstance(value, str) else toml(value)
    known_ = [] if isinstance(value, bool) else choices(key, data)
    wide = 6 if key.expected.startswith("a number") else 12
    attributes = {"value": shown, "placeholder": default_of(key).strip('"'), "data-path": written(place),
                  "size": f"{wide}", "aria-label": key.meaning, "title": key.expected,
                  "spellcheck": "false"}  # fmt: skip
    attributes |= {"aria-invalid": "true"} if wrong else {}
    if not known_:
        return e("input", type="text", **attributes)
    name = f"list-{'-'.join(place)}"
    options = e("datalist", *(e("option", value=one) for one in known_), id=name)
    return e("span", e("input", type="text", list=name, **attributes), options)


def choices(key: Key, data: dict[str, Any]) -> list[str]:
    """Return the texts that an entry may be, where these are known: products, laws, words."""
    if key.path in PRODUCTS:
        return [str(getattr(product, "name", "")) for product in COMMITTED[PRODUCTS[key.path]]()]
    if key.name == "law":
        return list(dict.fromkeys([*ENTRIES, *data.get("laws", {})]))
    return [] if key.expected.startswith(PHRASES) else EITHER.split(key.expected)
