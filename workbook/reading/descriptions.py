"""Read and write machine descriptions as TOML, validated by the templates' models; each fault is a line."""

import re
import tomllib
from copy import deepcopy
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from workbook.entries import rules
from workbook.entries.design import RefusedError, Where, as_entered, fault_line, keys_of, mend_machine
from workbook.entries.machine import Machine
from workbook.errors import InputError, ReadError, quoted
from workbook.fields.paths import key_of, put, spell, split
from workbook.fields.types import EntryError
from workbook.laws.named import with_laws_by_code
from workbook.selection.entries import refer_to_catalogues
from workbook.template import M, Template
from workbook.templates import TEMPLATES, AnyTemplate
from workbook.text_files import read_text

LINE = re.compile(r"at line (\d+)")
COMMA = re.compile(r"=\s*([-+]?\d+,\d+)(?![\w.])")
DOTTED = re.compile(r"""(?<![\w"'-])(?:[\w"'-]++[ \t]*+\.[ \t]*+){250}""")  # more than any text has


def template_named(name: object, where: str) -> AnyTemplate:
    """Return a template by name; raise InputError, listing the known ones, where there is none."""
    if not isinstance(name, str) or name not in TEMPLATES:
        fault = "empty" if name is None else f"no template is named {quoted(name)}"
        raise InputError([f"{where}: {fault}; expected one of {', '.join(TEMPLATES)}"])
    return TEMPLATES[name]


def read_machine(path: Path) -> Machine:
    """Read the description in a TOML file; raise ReadError or InputError, with a line for each fault."""
    data = parse_toml(read_text(path, "a machine description, a .toml file"), path)
    template = template_named(data.get("template"), f"{path}: template")
    return parse_machine(template, data, lambda key: f"{path}: {counted_from_1(key)}")


def parse_toml(text: str, path: Path) -> dict[str, Any]:
    """Return the tables of a TOML text; raise ReadError for invalid TOML, and nesting that no description needs."""
    if DOTTED.search(text):
        raise ReadError(f"{path}: not valid TOML for a description: keys are nested too deep")
    try:
        return tomllib.loads(text)
    except RecursionError as error:
        raise ReadError(f"{path}: not valid TOML for a description: values are nested too deep") from error
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


def parse_machine(template: Template[M], data: dict[str, Any], where: Where) -> M:
    """Return the machine of a description, which may name laws by their codes; raise as :func:`make_machine` does."""
    try:
        named = with_laws_by_code(data, template.laws)
    except EntryError as error:
        raise InputError([f"{where(error.field)}: {error}"]) from None
    return make_machine(template, named, where)


def make_machine(template: Template[M], data: dict[str, Any], where: Where) -> M:
    """Return the machine of entries; raise InputError for faults of structure or type: others leave it unfinished."""
    model = template.model
    try:
        return mend_machine(model, template.check, data)
    except RefusedError as error:
        raise InputError([fault_line(fault, model, where) for fault in error.faults]) from None
    except EntryError as error:
        raise InputError([f"{where(error.field)}: {error}"]) from None


def empty_machine(template: Template[M], layout: dict[str, Any]) -> M:
    """Return the machine of a book's layout with nothing entered; raise InputError for one that no book has."""
    data, model = deepcopy(layout), template.model
    try:
        model.model_validate(data)
    except ValidationError as error:
        for n, fault in enumerate(error.errors()):
            key, rule = keys_of(model, fault["loc"])
            if fault["type"] == "too_short":  # a catalogue
                put(data, split(key), [row.model_dump() for row in rules.default_at(model, rule)[:1]])
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
