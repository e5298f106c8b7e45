"""Every key of a description, from where it is declared: models, the cells that show it, the committed descriptions."""

import re
import tomllib
from collections.abc import Container, Iterator, Mapping, Sequence
from functools import reduce
from operator import or_
from typing import Any, NamedTuple, get_args, get_origin

import tomlkit
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from workbook.book.cell_tables import CellWords
from workbook.book.quantity import Quantity
from workbook.entries.abscissa import PLACE
from workbook.entries.facts import facts_of
from workbook.entries.rules import KIND, either, expectation, is_table, kinds, tables, unwrap
from workbook.fields.paths import get, spread
from workbook.laws.entries import ENTRIES, Laws
from workbook.laws.registry import CODES, FAMILY
from workbook.reading.descriptions import read_machine
from workbook.selection.entries import COMMITTED
from workbook.template import FOLDER
from workbook.templates import AnyTemplate

ONE, PART = re.compile(r"\.\d+(?=\.|$)"), re.compile(r"\{\w+\}")
SHOWN = CODES[1]  # the law whose page says what is entered on all of them
PRODUCTS = {  # entries that name a product of a catalogue
    "axes.*.motor.name": "motors", "selection.motor": "motors",
    "axes.*.reducer.name": "reducers", "selection.reducer": "reducers",
}  # fmt: skip
Models = tuple[type[BaseModel], ...]  # of a table of several kinds


class Key(NamedTuple):
    """A key of a description; ``*`` in its path stands for the number of a row."""

    path: str
    meaning: str
    unit: str
    expected: str
    required: bool
    default: Any = None
    example: Any = None
    rows: "tuple[Key, ...]" = ()  # of a list of rows: what each of them holds

    @property
    def name(self) -> str:
        """The last part of the path."""
        return self.path.rpartition(".")[2]


class Section(NamedTuple):
    """A table of a description, with its keys in their order; of a table of several kinds, those of a ``kind``."""

    path: str
    about: str
    models: Models
    keys: tuple[Key, ...]
    kind: str = ""


LAST = {"selection": 1, "sizes": 2, "laws": 3}  # what most descriptions leave as it is


def sections(template: AnyTemplate) -> list[Section]:
    """Return the tables of a template's descriptions, the outermost first."""
    machine: Any = read_machine(template.description)
    cells: dict[str, Quantity] = {}
    for block in template.declare(machine).blocks.values():
        for q in block.quantities:
            if q.role == "input":
                cells.setdefault(ONE.sub(".*", q.key), q)
    paths = [template.description, *sorted(FOLDER.glob("*.toml"))]
    committed = [tomllib.loads(path.read_text(encoding="utf-8")) for path in paths]
    own = [data for data in committed if data["template"] == template.name]
    listed = ModelWalk(cells, own).sections((type(machine),), "", machine.title)
    return sorted(listed, key=lambda section: LAST.get(section.path.partition(".")[0], 0))


class ModelWalk:
    """Goes through the models of a template; ``cells`` are its inputs by key, ``data`` are descriptions."""

    def __init__(self, cells: Mapping[str, Quantity], data: Sequence[Mapping[str, Any]]) -> None:
        self._cells, self._data = cells, data

    def sections(self, models: Models, path: str, about: str) -> Iterator[Section]:
        """Yield the section of a model, then those of the tables in it; of several, what is common first."""
        known = [model.model_fields for model in models]
        by_kind, common = kinds(models), set.intersection(*map(set, known))
        fields = {name: field for name, field in reduce(or_, known).items() if name in common or not by_kind}
        below = [(name, tables_of(field)) for name, field in fields.items()]
        facts = reduce(or_, map(facts_of, models))
        keys = [self._key(join(path, name), fields[name], facts.get(name)) for name, nested in below if not nested]
        expected = {KIND: either(by_kind)} if by_kind else {}
        plain = tuple(
            key._replace(required=key.required and key.name in common, expected=expected.get(key.name, key.expected))
            for key in keys
        )
        yield Section(path, about, models, plain)
        yield from (self._of_kind(kind, model, common, path) for kind, model in by_kind.items())
        for name, nested in below:
            yield from self._nested(nested, join(path, name), fields[name])

    def _nested(self, models: Models, path: str, field: FieldInfo) -> Iterator[Section]:
        """Yield the sections of a field that is a table, or a list of tables; nothing of any other field."""
        if not models:
            return
        if issubclass(models[0], Laws):
            yield from self._laws(path)
            return
        annotated, constraints = unwrap(field.annotation, field.metadata)
        many = f": {expectation(annotated, constraints)}" if get_origin(annotated) is list else ""
        about = doc_line(models[0].__base__ if models[1:] else models[0])
        yield from self.sections(models, path + (".*" if many else ""), about + many)

    def _of_kind(self, kind: str, model: type[BaseModel], common: Container[str], path: str) -> Section:
        """Return the section of what a table of a kind has beside what is common to all kinds."""
        facts = facts_of(model)
        own = [entry for entry in model.model_fields.items() if entry[0] not in common]
        keys = tuple(self._key(join(path, name), field, facts.get(name), kind) for name, field in own)
        return Section(path, doc_line(model), (model,), keys, kind)

    def _example(self, path: str, kind: str = "") -> Any:
        """Return the value of a key in the first description that has it, in a table of a kind."""
        for data in self._data:
            for place, value in spread(data, path.split(".")):
                kinds = {get(data, (*place[:k], KIND), kind) for k in range(len(place))} if kind else {kind}
                if value is not None and kinds == {kind}:
                    return value
        return getattr(COMMITTED[PRODUCTS[path]]()[0], "name", None) if path in PRODUCTS else None

    def _laws(self, path: str) -> Iterator[Section]:
        for code, model in ENTRIES.items():
            for section in self.sections((model,), join(path, code), FAMILY[code].title):
                # which its name says already
                own = tuple(key for key in section.keys if key.name != "family")
                yield section._replace(keys=own)

    def _key(self, path: str, field: FieldInfo, facts: CellWords | None, of: str = "", listed_in: Any = None) -> Key:
        kind, constraints = unwrap(field.annotation, field.metadata)
        table = next(iter(tables(get_args(kind)[0])), None) if get_origin(kind) is list else None
        meaning, unit = in_words(facts) if facts else self._meaning(path, field, table)
        default = None if field.is_required() else field.get_default(call_default_factory=True)
        row = table or BaseModel
        rows = [
            self._key(join(f"{path}.*", name), inner, facts_of(row).get(name), of, first_value(default, name))
            for name, inner in row.model_fields.items()
        ]
        examples = (listed_in, self._example(path, of), example_in(facts, kind), *(field.examples or []))
        shown = next((example for example in examples if example is not None), None)
        if shown is None and default in (None, "", []):
            raise LookupError(f"{path}{of and f' of a {of}'} has no example: its field has none, nor a committed file")
        return Key(
            path,
            meaning[:1].upper() + meaning[1:],
            unit,
            expectation(kind, constraints),
            field.is_required() or path == "template",
            default,
            shown,
            tuple(rows),
        )

    def _meaning(self, path: str, field: FieldInfo, table: type[BaseModel] | None) -> tuple[str, str]:
        """Return the meaning and the unit of a key: as its field says, else as its cell shows."""
        cell = self._cells.get(path) or self._of_law(path)
        meaning = field.description or (cell.label if cell else "")
        return meaning or (doc_line(table) if table else list_meaning(path)), cell.unit if cell else ""

    def _of_law(self, path: str) -> Quantity | None:
        """Return a cell for an entry of a family of laws that the committed description has no law of."""
        laws, code, name, *below = [*path.split("."), "", ""]
        if laws != "laws" or not name or below != ["", ""]:
            return None
        for p in FAMILY[code].parameters:
            if p.key == name:
                return Quantity(p.name, f"{p.label} ({p.source})" if p.source else p.label)
        return self._cells.get(f"laws.{SHOWN}.{name}")


def in_words(facts: CellWords) -> tuple[str, str]:
    """Return the meaning of an entry, else its label with the note beside its cell, and its unit.

    ``*`` stands for any number.
    """
    label, source, unit = (facts.texts.get(name, "") for name in ("label", "source", "unit"))
    meaning = facts.meaning or (f"{label} ({source})" if source else label)
    return PART.sub("*", meaning), PART.sub("", unit.replace("{place}", PLACE))


def example_in(facts: CellWords | None, kind: Any) -> Any:
    """Return the example in the facts of an entry, a whole number where the entry is; None where there is none."""
    example = facts.example if facts else None
    return int(example) if kind is int and example is not None else example


def first_value(rows: Any, name: str) -> Any:
    """Return an entry of the first of some rows that has it."""
    return next((value for row in rows or [] if (value := getattr(row, name, None)) not in (None, "")), None)


def list_meaning(path: str) -> str:
    """Return the labels of the numbers in a list of a law."""
    code, name = path.split(".")[1], path.rpartition(".")[2]
    return "; ".join(p.label for p in FAMILY[code].parameters if p.key.startswith(f"{name}.")) if code in FAMILY else ""


def tables_of(field: FieldInfo) -> Models:
    """Return the models of a table, or of a list of tables with more tables in them; none of an entry."""
    kind, _ = unwrap(field.annotation, [])
    return tables(get_args(kind)[0] if get_origin(kind) is list and not is_table(kind) else kind)


def join(path: str, name: str) -> str:
    """Return a key below another."""
    return f"{path}.{name}" if path else name


def doc_line(model: type[BaseModel] | None) -> str:
    """Return the first line of what a model says of itself."""
    return ((model.__doc__ if model else "") or "").strip().partition("\n")[0].rstrip(".")


def toml(value: Any) -> str:
    """Return a value as a description has it, a row of a table in a line."""
    if isinstance(value, BaseModel):
        value = value.model_dump(exclude_none=True)
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{k} = {toml(v)}' for k, v in value.items() if v is not None)} }}" if value else "{}"
    if isinstance(value, list):
        return f"[{', '.join(map(toml, value))}]"
    return str(tomlkit.item(value).as_string())


def default_of(key: Key) -> str:
    """Return the default of an optional key as a text; nothing for a required key."""
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
