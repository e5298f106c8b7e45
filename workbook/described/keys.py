"""Every key of a description: what it means, its unit, default, range, an example.

All of it is taken from where it is declared: type, range and default from the models, meaning and unit from the cell
that shows the entry, the example from the committed description. A key without a cell says itself what it means.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, Literal, NamedTuple, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from workbook.book.quantity import Quantity
from workbook.entries.rules import expectation, is_table, unwrap, within
from workbook.laws.entries import ENTRIES, Laws
from workbook.laws.family import Parameter
from workbook.laws.registry import CODES, FAMILY
from workbook.reading.descriptions import read_machine
from workbook.templates import AnyTemplate

ONE = re.compile(r"\.\d+(?=\.|$)")
SHOWN = CODES[1]
"""the law whose page says what is entered on all of them"""


WORDS = {
    "template": "The kind of machine",
    "sizes.cycle": "Intervals of the table over the cycle",
    "sizes.law": "Intervals of the table of each law",
    "sizes.own_law": "Of no account: an own law has nine points on each piece",
    "sizes.export": "Intervals of the table of the sheet Export",
    "sizes.phases": "Rows for phases of an axis or a motion",
    "sizes.rotors": "Rows for rotating parts",
    "sizes.pieces": "Rows for pieces of the own law",
    "sizes.points": "Rows for points of a spline",
    "sizes.motion_pieces": "Rows for pieces of a motion; without it a few more than the motion has",
    "sizes.motors": "Rows for motors",
    "sizes.reducers": "Rows for reducers",
    "sizes.gears": "Rows for gears",
    "sizes.margins": "Intervals of the table of margins",
    "sizes.lengths": "Intervals of the table of product lengths",
    "axes.*.unit": "The unit of its lifts: of an axis that travels, or one that turns",
    "selection.motors": 'The motors to choose among; "committed": those that come with motionbook',
    "selection.reducers": 'The reducers to choose among; "committed": those that come with motionbook',
}
"""what entries mean that no cell shows; an entry of another machine says it itself, as its field's description"""


class Key(NamedTuple):
    """A key of a description; ``*`` in its path stands for the number of a row."""

    path: str
    meaning: str
    unit: str
    expected: str
    required: bool
    default: Any = None
    example: Any = None
    rows: tuple[Key, ...] = ()
    """of a list of rows: what each of them holds"""
    any: Any = None
    """some value that keeps to its rules"""

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition(".")[2]


class Section(NamedTuple):
    """A table of a description, with its keys in their order."""

    path: str
    about: str
    model: type[BaseModel]
    keys: tuple[Key, ...]


def sections(template: AnyTemplate, other: str = "") -> list[Section]:
    """Return the tables of a template's descriptions, the outermost first; of those with the key of another way."""
    machine: Any = read_machine(template.description)
    if other:
        machine = template.others[other].told(machine)
    cells: dict[str, Quantity] = {}
    for block in template.declare(machine).blocks.values():
        for q in block.quantities:
            if q.role == "input":
                cells.setdefault(ONE.sub(".*", q.key), q)
    walk = Walk(cells, machine.model_dump())
    return sorted(walk.sections(type(machine), "", machine.title), key=lambda s: rank(s.path))


LAST = ("selection", "sizes", "laws")
"""what most descriptions leave as it is"""


def rank(path: str) -> int:
    """Return where a section stands: the machine's own come first."""
    first = path.partition(".")[0]
    return LAST.index(first) + 1 if first in LAST else 0


class Walk:
    """Goes through the models of a template; ``cells`` are its inputs by key, ``data`` is a description."""

    def __init__(self, cells: Mapping[str, Quantity], data: Mapping[str, Any]) -> None:
        self._cells, self._data = cells, data

    def sections(self, model: type[BaseModel], path: str, about: str) -> Iterator[Section]:
        """Yield the section of a model, then those of the tables in it."""
        fields = model.model_fields
        below = [(name, table_of(field)) for name, field in fields.items()]
        plain = tuple(self._key(join(path, name), fields[name]) for name, table in below if not isinstance(table, type))
        yield Section(path, about, model, plain)
        for name, table in below:
            if isinstance(table, type) and issubclass(table, Laws):
                yield from self._laws(join(path, name))
            elif isinstance(table, type):
                kind, constraints = unwrap(fields[name].annotation, fields[name].metadata)
                many = f": {expectation(kind, constraints)}" if get_origin(kind) is list else ""
                yield from self.sections(table, join(path, name) + (".*" if many else ""), said(table) + many)

    def _laws(self, path: str) -> Iterator[Section]:
        for code, model in ENTRIES.items():
            for section in self.sections(model, join(path, code), FAMILY[code].page.title):
                own = tuple(key for key in section.keys if key.name != "family")  # which its name says already
                yield section._replace(keys=own)

    def _key(self, path: str, field: FieldInfo) -> Key:
        kind, constraints = unwrap(field.annotation, field.metadata)
        row = get_args(kind)[0] if get_origin(kind) is list else None
        table = row if isinstance(row, type) and issubclass(row, BaseModel) else None
        rows = [self._key(join(f"{path}.*", name), one) for name, one in table.model_fields.items()] if table else []
        cell = self._cells.get(path) or self._of_law(path)
        meaning = (
            field.description or WORDS.get(path) or (cell.label if cell else said(table) if table else listed(path))
        )
        default = None if field.is_required() else field.get_default(call_default_factory=True)
        return Key(
            path, sentence(meaning), cell.unit if cell else "", expectation(kind, constraints),
            field.is_required() or path == "template", default, example(self._data, path.split(".")), tuple(rows),
            stand_in(kind, constraints),
        )  # fmt: skip

    def _of_law(self, path: str) -> Quantity | None:
        """Return a cell for an entry of a family of laws that the committed description has no law of."""
        parts = path.split(".")
        if parts[0] != "laws" or len(parts) != len(("laws", "code", "entry")):
            return None
        parameter = next((p for p in parameters(parts[1]) if p.key == parts[2]), None)
        if parameter is None:
            return self._cells.get(f"laws.{SHOWN}.{parts[2]}")
        source = f" ({parameter.source})" if parameter.source else ""
        return Quantity(parameter.name, f"{parameter.label}{source}")


def stand_in(kind: Any, constraints: list[Any]) -> Any:
    """Return a value that keeps to its rules."""
    if kind is float or kind is int or get_origin(kind) is Literal:
        return kind(within(kind, constraints)) if kind is int else within(kind, constraints)
    return [] if get_origin(kind) is list else "a text"


def listed(path: str) -> str:
    """Return what the numbers of a list of a law's are."""
    labels = [p.label for p in parameters(path.split(".")[1]) if p.key.startswith(f"{path.rpartition('.')[2]}.")]
    return "; ".join(labels)


def parameters(code: str) -> tuple[Parameter, ...]:
    """Return the numbers that a family of laws has."""
    return tuple(FAMILY[code].page.parameters) if code in FAMILY else ()


def table_of(field: FieldInfo) -> type[BaseModel] | None:
    """Return the model of a table, or of a list of tables with more tables in them; None of an entry."""
    kind, _ = unwrap(field.annotation, [])
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        return kind
    if get_origin(kind) is list and not is_table(kind):
        row = get_args(kind)[0]
        return row if isinstance(row, type) and issubclass(row, BaseModel) else None
    return None


def join(path: str, name: str) -> str:
    """Return a key below another."""
    return f"{path}.{name}" if path else name


def said(model: type[BaseModel] | None) -> str:
    """Return the first line of what a model says of itself."""
    return ((model.__doc__ if model else "") or "").strip().partition("\n")[0].rstrip(".")


def sentence(text: str) -> str:
    """Return a text that begins with a capital."""
    return text[:1].upper() + text[1:]


def example(data: Any, path: list[str]) -> Any:
    """Return what a description has at a key: in the first row that has it."""
    if not path or data is None:
        return data
    first, *rest = path
    if first == "*":
        return next((found for row in data if (found := example(row, rest)) is not None), None)
    return example(data.get(first), rest) if isinstance(data, Mapping) else None
