"""The facts of entries, in a table in Markdown beside the module of their models, under the name of each model.

``drive_entries.md`` has those of ``drive_entries.py``, a row for each entry: the name of its cell, label, symbol, unit,
note and format as in :mod:`workbook.book.cell_tables`, and four columns more. The cell, the reference, the schema, the
form, the variations of ``verify`` and random machines read them there.

===========  ===========================================================================================
``meaning``  what the reference says of it, where label and note say too little beside nothing else
``example``  an entry of a real machine, where no committed description has it
``varies``   the entry in the variations, in turn: numbers and words, ``empty`` where it is left out
``head``     the head of its column in a catalogue's CSV file
===========  ===========================================================================================

The part ``{place}`` in a unit is that of places in the cycle. A model has its base's facts too.
"""

import sys
from collections import ChainMap
from collections.abc import Container, Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel

from workbook.book.cell_tables import CellTable, CellWords, cell_tables
from workbook.book.declare import Quantity
from workbook.entries.rules import tables, unwrap


@cache
def table_of(model: type[BaseModel]) -> CellTable:
    """Return the facts of a model's entries by the names of their cells; none where no Markdown has its name."""
    if model is BaseModel:
        return CellTable()
    path = Path(str(sys.modules[model.__module__].__file__))
    known = cell_tables(str(path)) if path.with_suffix(".md").exists() else {}
    bases = [table_of(base) for base in model.__bases__ if issubclass(base, BaseModel)]
    return CellTable(ChainMap(known.get(model.__name__, {}), *bases))


def facts_of(model: type[BaseModel]) -> dict[str, CellWords]:
    """Return the facts of a model's entries by the names of its fields."""
    return {words.texts["key"]: words for words in table_of(model).values()}


def entry_cells(entries: BaseModel, place: str, leaving: Container[str] = (), **parts: Any) -> Iterator[Quantity]:
    """Yield the inputs of a table of a description, and of the tables in it, in the order of their fields.

    ``parts`` are filled into those texts of its facts that have them; entries named in ``leaving`` have no cell.
    """
    facts, cell = facts_of(type(entries)), table_of(type(entries)).entries(entries, place)
    for name, field in type(entries).model_fields.items():
        below = getattr(entries, name)
        if name in leaving:
            continue
        if name in facts and facts[name].kind == "entry":
            word = {"format": ""} if get_origin(unwrap(field.annotation, [])[0]) is Literal else {}
            own = {part: parts[part] for part in facts[name].parts}
            yield cell(facts[name].texts["name"], **own, **word)
        elif isinstance(below, BaseModel):
            yield from entry_cells(below, f"{place}.{name}", **parts)


def varying_entries(
    entries: dict[str, Any], model: type[BaseModel], leaving: Container[str] = ()
) -> Iterator[tuple[dict[str, Any], str, Sequence[Any]]]:
    """Yield the entries of a table, and of those in it, that have variations: their table, name, and values."""
    facts = facts_of(model)
    for name, field in model.model_fields.items():
        kind, _ = unwrap(field.annotation, [])
        if isinstance(entries.get(name), dict):
            yield from varying_entries(entries[name], tables(kind)[0])
        elif name in facts and name not in leaving:
            values = facts[name].varies or (get_args(kind) if get_origin(kind) is Literal else ())
            yield from [(entries, name, values)] if values else ()


def vary(entries: dict[str, Any], model: type[BaseModel], turn: int, leaving: Container[str] = ()) -> None:
    """Give a table of a description the entries of a turn: each goes through its values, beginning with another."""
    for n, (table, name, values) in enumerate(varying_entries(entries, model, leaving)):
        table[name] = values[(turn + n) % len(values)]
