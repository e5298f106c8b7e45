"""Read and write machine descriptions as TOML, validated by the templates' models; each fault is a line."""

import re
import tomllib
from collections.abc import Callable, Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from workbook.entries import rules
from workbook.entries.design import (
    RefusedError,
    Where,
    as_entered,
    differing_entries,
    fault_line,
    keys_of,
    machine_or_faults,
    part_of,
)
from workbook.entries.machine import Design, Fault, Machine
from workbook.errors import InputError, ReadError, quoted
from workbook.fields.paths import key_of, put, spell, split
from workbook.fields.types import EntryError
from workbook.laws.entries import with_laws_by_code
from workbook.selection.catalogue_files import Product, read_motors, read_reducers
from workbook.selection.entries import MOST_PRODUCTS, Products, refer_to_catalogues
from workbook.template import M, Template
from workbook.templates import TEMPLATES, AnyTemplate
from workbook.text_files import read_text

LINE = re.compile(r"at line (\d+)")
COMMA = re.compile(r"=\s*([-+]?\d+,\d+)(?![\w.])")
MOST_ROUNDS = 24  # of faults that show only where others are mended
READERS: dict[str, Callable[[Path], list[Product]]] = {"motors": read_motors, "reducers": read_reducers}
DOTTED = re.compile(r"""(?<![\w"'-])(?:[\w"'-]++[ \t]*+\.[ \t]*+){250}""")  # more than any text has


def template_named(name: object, where: str) -> AnyTemplate:
    """Return a template by name; raise InputError, listing the known ones, where there is none."""
    if not isinstance(name, str) or name not in TEMPLATES:
        fault = "empty" if name is None else f"no template is named {quoted(name)}"
        raise InputError([f"{where}: {fault}; expected one of {', '.join(TEMPLATES)}"])
    return TEMPLATES[name]


def read_machine(path: Path, **catalogues: Path) -> Machine:
    """Read a machine description, a TOML file, its choice of motor and reducer among the catalogues that are named.

    Where none is named, and the description has none of its own, motors.csv and reducers.csv beside it are taken.
    Raises ReadError and InputError, with a line for each fault.
    """
    data = parse_toml(read_text(path, "a machine description, a .toml file"), path)
    template = template_named(data.get("template"), f"{path}: template")
    data |= catalogue_entries(template, data, path, catalogues)
    return make_machine(template, data, lambda key: f"{path}: {counted_from_1(key)}", by_code=True)


def catalogue_entries(
    template: AnyTemplate, data: dict[str, Any], path: Path, catalogues: dict[str, Path]
) -> dict[str, Any]:
    """Return the entries of a description with the products of catalogues, and with room for them in their tables.

    ``catalogues`` are files by their entries, motors or reducers. Raises InputError for those of a machine that
    chooses no motor, and for too many products.
    """
    fields, choice, sizes = template.model.model_fields, data.get("selection", {}), data.get("sizes", {})
    if "selection" not in fields or not isinstance(rules.default_of(fields["selection"]), Products):
        if catalogues:
            unused = " and ".join(map("--{}".format, catalogues))
            raise InputError([f"{path}: {template.name} chooses no motor; {unused} cannot be used"])
        return {}
    if not isinstance(choice, dict) or not isinstance(sizes, dict):
        return {}  # which the model refuses
    usual = rules.default_of(fields["sizes"]).model_dump()
    for entry, read in READERS.items():
        beside = path.parent / f"{entry}.csv"
        file = catalogues.get(entry, None if entry in choice or not beside.exists() else beside)
        if file is None:
            continue
        choice = choice | {entry: (rows := read(file))}
        if len(rows) > MOST_PRODUCTS:
            raise InputError([f"{file}: {len(rows)} products; expected at most {MOST_PRODUCTS}"])
        room = sizes.get(entry, usual[entry])
        if type(room) is int and 0 < room < len(rows):  # what else is there the model refuses
            sizes = sizes | {entry: len(rows)}
    return {"selection": choice, "sizes": sizes}


def parse_toml(text: str, path: Path) -> dict[str, Any]:
    """Return the tables of a TOML text; raise ReadError for invalid TOML, and nesting that no description needs."""
    deep = f"{path}: not valid TOML for a description: {{}} are nested too deep"
    if DOTTED.search(text):
        raise ReadError(deep.format("keys"))
    try:
        return tomllib.loads(text)
    except RecursionError as error:
        raise ReadError(deep.format("values")) from error
    except ValueError as error:  # an error of TOML's, or a whole number of too many digits
        message = decimal_comma(text, error) or str(error).partition(";")[0]
        raise ReadError(f"{path}: not valid TOML: {message}") from error


def decimal_comma(text: str, error: ValueError) -> str:
    """Return the fault in the line of an error of TOML's where a number has a comma; nothing where none has."""
    place = LINE.search(str(error))
    lines = text.splitlines()[int(place[1]) - 1 :] if place else []
    number = COMMA.search(lines[0].partition("#")[0]) if lines else None
    if place is None or number is None:
        return ""
    return f"line {place[1]}: {number[1]} has a decimal comma; expected a point, {number[1].replace(',', '.')}"


def counted_from_1(key: str) -> str:
    """Return a key whose lists are counted from 1, as people count: ``timing.axes[1].name``."""
    spelled = spell(key)
    return spelled if spelled == key else f"{spelled} (counted from 1)"


def write_machine(machine: Machine) -> str:
    """Return the TOML of a machine description; catalogues that come with the templates are referred to."""
    import tomlkit  # for this alone: most commands write no description

    return tomlkit.dumps(refer_to_catalogues(as_entered(machine)))


def make_machine(template: Template[M], data: dict[str, Any], where: Where, by_code: bool = False) -> M:
    """Return the machine of entries, with numbers that do in place of faulty ones: an unfinished design.

    ``by_code``: entries may name laws of the catalogue by their codes, as those of a description do. Raises InputError
    for faults of structure or type, a line each, which ``where`` begins by the key.
    """
    model, replaced, faults = template.model, list[str](), list[Fault]()
    try:
        data = model.expand_short_forms(with_laws_by_code(data, template.laws) if by_code else data)
        tried = deepcopy(data)
        for _ in range(MOST_ROUNDS):
            machine, refused = machine_or_faults(model, template.check, tried)
            if machine is not None:
                changed = differing_entries(model, data, machine.model_dump(), replaced)
                machine._design = Design(changed, tuple(faults))
                return machine
            faulty = {part_of(fault.key) for fault in faults}  # what lacks an entry of a part is no fault of its own
            faults += [fault for fault in refused if part_of(fault.key) not in faulty]
            replaced += put_what_fits(tried, refused, tuple(f"{place}." for place in replaced))
        raise RefusedError(refused)
    except (EntryError, RefusedError) as error:
        alone = [Fault(error.field, str(error))] if isinstance(error, EntryError) else error.faults
        lines = [fault_line(fault, model, where) for fault in alone]
        raise RefusedError(alone, getattr(error, "numbers", ()), lines) from None


def put_what_fits(data: dict[str, Any], faults: list[Fault], not_entered: tuple[str, ...]) -> Iterator[str]:
    """Put what would do in place of faulty entries; yield the keys of those that begin with none of ``not_entered``.

    Raises RefusedError for a fault of the whole description.
    """
    for fault in faults:
        if not fault.key:
            raise RefusedError(faults)
        put(data, split(fault.key), deepcopy(fault.fits))
        if not f"{fault.key}.".startswith(not_entered):
            yield fault.key


def empty_machine(template: Template[M], layout: dict[str, Any]) -> M:
    """Return the machine of a book's layout with nothing entered; raise InputError for one that no book has."""
    data, model = deepcopy(layout), template.model
    try:
        model.model_validate(data)
    except ValidationError as error:
        for n, fault in enumerate(error.errors()):
            key, rule = keys_of(model, fault["loc"])
            if fault["type"] == "too_short":  # a catalogue
                rows = rules.default_at(model, rule)[:1]
                put(data, split(key), [row.model_dump() for row in rows])
            elif fault["type"] == "missing":
                kind, constraints = rules.field_at(model, rule)
                if kind is str and not rules.takes_law(constraints):
                    put(data, split(key), f"A{n}")
    return make_machine(template, data, lambda key: key)


def require_possible(template: Template[M], machine: M, where: Where) -> None:
    """Raise InputError, whose line says where the fault is, for a machine that the engine refuses."""
    try:
        template.check(machine)
    except EntryError as error:
        raise InputError([f"{where(error.field)}: {error}"]) from None


def cell_key(key: str, named: dict[str, str]) -> str:
    """Return a key below a law's name with the name that its cells have."""
    for name, below in named.items():
        begin = f"laws.{key_of(name)}"
        if key == begin or key.startswith(f"{begin}."):
            return f"laws.{below}{key.removeprefix(begin)}"
    return key
