"""The entries of a description by their places, as the page has them."""

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from workbook.description.keys import PRODUCTS, Key, Section, default_of, sections
from workbook.entries.abscissa import PLACE
from workbook.entries.rules import KIND
from workbook.errors import InputError
from workbook.fields.paths import Place, get
from workbook.laws.entries import ENTRIES
from workbook.laws.registry import FAMILY
from workbook.selection.entries import COMMITTED
from workbook.templates import TEMPLATES

EITHER = re.compile(r", | or ")
PHRASES = ("a ", "7 ")  # begins of the words that expect anything but a choice of texts
SHAPE = 25  # points of the picture of a law
OF_AXIS = ("lift", "position", "low", "high")  # entries in the unit of their axis
BEFORE = re.compile(r"^(Motor|Reducer), as entered: |^(Arm|Brake): ")
NOTE = re.compile(r" \((.*)\)$")
MORE = re.compile(r"(?!Of a |Stage |Drum: |Saw: |Duration )(.{5,}?)[:;.] (.*)")


@lru_cache
def template_sections(template: str) -> list[Section]:
    """Return the tables of a template's descriptions."""
    return sections(TEMPLATES[template])


@lru_cache
def schema(template: str) -> list[dict[str, Any]]:
    """Return the tables of a template's descriptions with their entries, as the page has them."""
    tables = []
    for path, about, _, keys, kind in template_sections(template):
        tables.append({"path": path, "about": about, "kind": kind, "keys": [*map(shown_key, keys)]})
    return tables


def shown_key(key: Key) -> dict[str, Any]:
    """Return an entry as the page has it: its label and note, its unit, the texts that are proposed."""
    words = BEFORE.sub("", key.meaning)
    note = NOTE.search(words)
    label = NOTE.sub("", words)
    more = MORE.fullmatch(label)  # what follows the first clause is no name of a field
    notes = [more[2] if more else "", note[1] if note else ""]
    label = more[1] if more else label
    rows = sorted(key.rows, key=lambda row: row.default is None and not row.required)
    return {
        "name": key.name,
        "label": label[:1].upper() + label[1:],
        "note": "; ".join(filter(None, notes)),
        "unit": key.unit,
        "expected": key.expected,
        "required": key.required,
        "default": default_of(key).strip('"'),
        "options": choices(key),
        "rows": [*map(shown_key, rows)],
    }


@lru_cache
def catalogue() -> dict[str, Any]:
    """Return the laws that come with motionbook with their shapes, motors and reducers with their figures."""
    shares = np.linspace(0.0, 1.0, SHAPE)
    known = {code: FAMILY[code].make_law(entry()) for code, entry in ENTRIES.items()}
    laws = []
    for code, page in FAMILY.items():
        shape, figures = 0.0 * shares, {}
        if law := known.get(code):
            shape, own = law.s(shares), law.coefficients
            figures = {"v": own.cv, "a": own.ca, "j": own.cj if math.isfinite(own.cj) else None}
        laws.append({"code": code, "title": page.title, "shape": shape.round(4).tolist()} | figures)
    products = {kind: [row.model_dump() for row in COMMITTED[f"{kind}s"]()] for kind in ("motor", "reducer")}
    return {"laws": laws, "products": products}


def choices(key: Key) -> list[str]:
    """Return the texts that an entry may be, where these are known: products, laws, words."""
    if key.path in PRODUCTS:
        return [str(getattr(product, "name", "")) for product in COMMITTED[PRODUCTS[key.path]]()]
    if key.name == "law":
        return list(FAMILY)
    return [] if key.expected.startswith(PHRASES) or key.rows else EITHER.split(key.expected)


def key_at(template: str, data: Any, place: Place) -> Key:
    """Return the key of the entry at a place; raise InputError where no table has it."""
    for depth in (1, 3):  # an entry of a table; of a row of its list
        above, (name, *below) = place[:-depth], place[-depth:]
        kinds = ("", get(data, (*above, KIND)))
        keys = [key for section in sections_at(template, above) if section.kind in kinds for key in section.keys]
        for key in (key for key in keys if key.name == name and len(below) == depth - 1):
            rows = {row.name: row for row in key.rows} | {str(n): row for n, row in enumerate(key.rows)} | {"": key}
            if (row := "".join(below[1:])) in rows:
                return rows[row]
    raise InputError([f"{'.'.join(place)}: there is no such entry"])


def unit_at(key: Key, data: Any, place: Place) -> str:
    """Return the unit of an entry: where it is the axis' or the cycle's, of those in this description."""
    axis = str(get(data, (*place[:2], "unit"), "mm")) if place[0] == "axes" else ""
    if axis and key.name in OF_AXIS:
        return axis
    if PLACE in key.unit:
        over = get(data, ("master", "unit"), "s") if get(data, ("master", "cycle")) is not None else "°"
        return str(over)
    units = key.unit.split(" or ")
    return units[-1 if axis == "°" else 0] if units[1:] else key.unit


def required_entries(keys: Sequence[Key]) -> dict[str, Any]:
    """Return the entries that a table must have, as in an example."""
    return {key.name: key.example for key in keys if key.required and key.example is not None}


def sections_at(template: str, place: Place) -> list[Section]:
    """Return the sections for the table at a place: of each kind that it may have, of each family of a law."""
    path = ".".join("*" if part.isdigit() else part for part in place)
    is_law = place[:1] == ("laws",)
    every = template_sections(template)
    return [section for section in every if section.path == path or (is_law and section.path.startswith("laws."))]
