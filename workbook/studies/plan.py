"""A study ready to run: its base machine, the entries that vary, the results that are asked for by known names."""

import hashlib
import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

import workbook
from workbook.book.declare import Book
from workbook.entries.design import RefusedError, machine_or_faults
from workbook.entries.machine import Fault, Machine
from workbook.errors import InputError, quoted
from workbook.fields.paths import Place, get, join, replaced, spell, split, table
from workbook.fields.types import EntryError
from workbook.law_sheets.library import laws
from workbook.laws.entries import ENTRIES, references, with_laws_by_code
from workbook.reading.descriptions import counted_from_1, parse_toml, read_machine, write_machine
from workbook.studies.paths import Link, children, followed, make_links, nearest, path_of
from workbook.studies.space import Dimension, Space, Study, Vary, arrange
from workbook.templates import TEMPLATES, AnyTemplate
from workbook.text_files import read_text

MOST_IN_FULL = 100_000_000
MOST_TRIED = 1000  # values of a list, each by itself before the study begins
ENDS = 1e-9  # of the rise: ends of laws that differ by less are the same
PRODUCTS = {"motor": "motors", "reducer": "reducers"}


class Impossible(str):
    """The reason that no machine can have a value, whatever else varies: an entry's type or an unknown name."""


@dataclass(frozen=True)
class Plan:
    """A study, its base machine, and all that varies."""

    study: Study
    base: Machine
    space: Space
    links: tuple[Link, ...] = ()

    @property
    def template(self) -> AnyTemplate:
        """The kind of machine."""
        return TEMPLATES[self.base.template]

    @cached_property
    def digest(self) -> str:
        """The digest of the study's own words, the machine's and the version: equal studies share it."""
        words = [workbook.__version__, self.study.model_dump_json(), write_machine(self.base)]
        return hashlib.sha256(json.dumps(words).encode()).hexdigest()

    @cached_property
    def data(self) -> dict[str, Any]:
        """The base as a description."""
        return as_description(self.base)

    def changes(self, chosen: dict[Dimension, Any]) -> dict[Place, Any]:
        """Return the entries that these values change, by their paths."""
        changes: dict[Place, Any] = {}
        for dimension, value in chosen.items():
            own = dimension.paths[0]
            if dimension.takes:  # room from its neighbour
                entry, way = EDGES[own[-1]]
                path = (*dimension.takes, entry)
                now, begun = (changes.get(place, get(self.data, place)) for place in (path, own))
                changes[path] = now + way * (value - begun)
            if own[-1] == "law":  # perhaps of a new family
                known: dict[str, Any] = {name: {} for name in self.base.laws.names}
                named = with_laws_by_code({"law": value, "laws": known}, {})
                value = named["law"]
                changes |= {("laws", law): {} for law in named["laws"] if law not in known}
            changes |= dict.fromkeys(dimension.paths, value)
        return followed(self.links, self.data, changes)

    def machine(self, chosen: dict[Dimension, Any]) -> Machine | str:
        """Return the machine with these values, or why there is none such."""
        return changed_machine(self.base, self.data, self.changes(chosen))


def as_description(machine: Machine) -> dict[str, Any]:
    """Return a machine as a description, all below its first level as it is, of its sizes those that were stated."""
    return table(machine) | {"sizes": machine.sizes.model_dump(exclude_unset=True)}


def changed_machine(base: Machine, data: dict[str, Any], changes: Mapping[Place, Any]) -> Machine | str:
    """Return the machine with other entries by their paths, or why there is none such; ``data`` describes the base."""
    for path, value in changes.items():
        data = dict(replaced(data, path, value))
    try:
        machine, faults = machine_or_faults(type(base), TEMPLATES[base.template].check, data)
    except EntryError as error:
        return Impossible(f"{error.field}: {error}")
    except RefusedError as error:
        sentences = (fault.message if isinstance(fault, Fault) else str(fault["msg"]) for fault in error.faults)
        return Impossible("; ".join(line.removeprefix("Value error, ") for line in sentences))
    if machine is None:
        return "; ".join(dict.fromkeys(f"{counted_from_1(fault.key)}: {fault.message}" for fault in faults))
    return machine


EDGES = {"stop": ("start", 1.0), "start": ("stop", 1.0), "duration": ("duration", -1.0)}
"""of an entry of a phase: the neighbour's that moves along, and which way"""


def read_study(path: Path) -> Plan:
    """Read a study; raise ReadError or InputError with a line for each fault."""
    data = parse_toml(read_text(path, "a study, a .toml file"), path)
    if "template" in data:
        raise InputError([f"{path}: this describes a machine; a study names it as base and says what varies"])
    try:
        study = Study.model_validate(data)
    except ValidationError as error:
        raise InputError(lines_of(error, str(path))) from None
    if study.base is None:
        raise InputError([f"{path}: base: empty; expected the name of a machine description"])
    return make_plan(study, path.parent / study.base, str(path))


INNER = ("str", "Bound", "constrained-str")
"""parts of a fault's place that name a kind where an entry may have several"""
KINDS = ("string_type", "list_type")


def lines_of(error: ValidationError, where: str) -> list[str]:
    """Return a line for each of pydantic's faults; of an entry of several kinds, for the kind that was meant."""
    faults: list[tuple[list[str], Any]] = []
    for fault in error.errors(include_url=False):
        # rows counted from 1
        place = [str(part + 1) if isinstance(part, int) else part for part in fault["loc"]]
        named = [part for part in place if part not in INNER and not part.startswith(("function-", "list["))]
        faults.append((named, fault))
    lines: dict[str, str] = {}
    for place, fault in faults:
        others = [other for other, _ in faults if other[: len(place)] == place]
        if len(others) < 2 or fault["type"] not in KINDS:
            lines.setdefault(".".join(place), line_of(fault, place, where))
    return list(lines.values()) or [line_of(faults[0][1], faults[0][0], where)]


def line_of(fault: Any, place: list[str], where: str) -> str:
    """Return the line of a fault of pydantic's."""
    cause = fault.get("ctx", {}).get("error")
    if isinstance(cause, EntryError):
        return f"{where}: {'.'.join([*place, *filter(None, [cause.field])])}: {cause}"
    if fault["type"] == "extra_forbidden":
        fields = {1: Study.model_fields, 3: Vary.model_fields}.get(len(place), {})
        keys = [field.alias or name for name, field in fields.items()]
        expected = f"; expected one of {nearest(place[-1], keys)}" if keys else ""
        return f"{where}: {'.'.join(place)}: unknown entry{expected}"
    what = "empty" if fault["type"] == "missing" else f"found {quoted(fault['input'])}"
    return f"{where}: {'.'.join(place)}: {what}; {fault['msg'][:1].lower()}{fault['msg'][1:]}"


def make_plan(study: Study, base: Path, where: str) -> Plan:
    """Return the plan of a study of the machine that a file describes; raise InputError, ReadError."""
    machine = read_machine(base)
    for fault in machine.design.faults:
        raise InputError([f"{base}: {fault.key}: {fault.message}; a study expects a finished design"])
    links = make_links(machine, study.links, where)
    draft = Plan(study, machine, Space((), study.way), links)
    dimensions = [make_dimension(draft, vary, f"{where}: vary {i}") for i, vary in enumerate(study.vary, 1)]
    space = arrange(dimensions, study.way)
    varied = [path for dimension in space.dimensions for path in dimension.paths]
    for twice in (path for path in varied if varied.count(path) > 1):
        raise InputError([f"{where}: {spell(twice)} varies twice"])
    varied += [
        (*dimension.takes, EDGES[dimension.paths[0][-1]][0]) for dimension in space.dimensions if dimension.takes
    ]
    for linked in (link.path for link in links if link.path in varied):
        raise InputError([f"{where}: links: {spell(linked)} varies already; expected one or the other"])
    if study.way.kind == "full" and space.size > MOST_IN_FULL:
        problem = f"{where}: {space.size:,} designs in full; expected at most {MOST_IN_FULL:,}"
        raise InputError([f'{problem}: take fewer steps, or way.kind = "sobol" with way.designs'])
    return Plan(study, machine, space, links)


def make_dimension(plan: Plan, vary: Vary, where: str) -> Dimension:
    """Return the dimension of an entry of a study; raise InputError, also for values that no machine can have."""
    paths = tuple(path_of(plan.base, key, f"{where}, key") for key in vary.keys)
    takes = Place() if vary.takes is None else phase_with_room(plan, vary, paths, f"{where}, takes")
    values, name = vary.values or names_to_try(plan, vary, paths[0], where), vary.keys[0]
    bounds = vary.low or 0.0, vary.high or 0.0, vary.steps or 0
    dimension = Dimension(name, paths, tuple(values), *bounds, takes, scaled_part(plan, paths))
    for value in dimension.values[:MOST_TRIED] or (dimension.low, dimension.high):
        machine = plan.machine({dimension: value})
        if isinstance(machine, Impossible) or (isinstance(machine, str) and dimension.part):
            raise InputError([f"{where}: {dimension.label} = {quoted(value)}: {machine}"])
    return dimension


def scaled_part(plan: Plan, paths: Sequence[Place]) -> str:
    """Return the motor, reducer or rate with which results scale; nothing where a link moves other entries too."""
    is_linked = any(link.source in paths for link in plan.links)
    if plan.template.scaling and not is_linked:
        return plan.template.scaling.part(join(paths[0]))
    return ""


def phase_with_room(plan: Plan, vary: Vary, paths: Sequence[Place], where: str) -> Place:
    """Return the place of the phase that gives the room which an edge takes; raise InputError if it has none."""
    entry = paths[0][-1]
    if len(paths) > 1 or entry not in EDGES:
        raise InputError([f"{where}: {vary.keys} takes no room; expected one key, of {', '.join(EDGES)}"])
    takes = path_of(plan.base, vary.takes or "", where, table=True)
    if takes == paths[0][:-1] or EDGES[entry][0] not in children(get(plan.data, takes)):
        raise InputError([f"{where}: {vary.takes!r} cannot give room; expected another phase"])
    return takes


def names_to_try(plan: Plan, vary: Vary, path: Place, where: str) -> list[Any]:
    """Return the names of all laws or of all products that an entry may have; none where a study gives figures."""
    if vary.all == "laws":
        given = next((reference for reference in references(plan.base) if split(reference.key) == path), None)
        if given is None:
            raise InputError([f"{where}: {vary.keys[0]!r} names no law; expected the law of a phase"])
        return list(laws_with_same_ends(plan, path, given.name))
    if vary.all == "catalogue":
        products = next((PRODUCTS[part] for part in reversed(path) if part in PRODUCTS), "")
        rows = getattr(getattr(plan.base, "selection", None), products, None) or []
        if not rows:
            problem = f"{vary.keys[0]!r} is none of a catalogue; expected the name of a motor or reducer"
            raise InputError([f"{where}: {problem}"])
        return [row.name for row in rows]
    return []


def laws_with_same_ends(plan: Plan, path: Place, given: str) -> list[str]:
    """Return the laws with the ends of the entered law, of the book and all families, as far as they fit."""

    def ends(machine: Machine, name: str) -> tuple[float, float, float, float]:
        law = laws(machine.laws)[name]
        return law.start.s, law.start.v, law.end.s, law.end.v

    now, fitting = ends(plan.base, given), []
    for name in dict.fromkeys([*plan.base.laws.names, *ENTRIES]):
        machine = plan.machine({Dimension("", (path,)): name})
        if not isinstance(machine, str) and np.allclose(ends(machine, name), now, rtol=0.0, atol=ENDS):
            fitting.append(name)
    return fitting


def book_names(book: Book) -> Iterator[str]:
    """Yield the names of all that a book computes: cells, and ``table.column.row``."""
    for block in book.blocks.values():
        for q in block.quantities:
            if block.is_table:
                yield from (f"{block.name}.{q.name}.{i}" for i in range(1, block.size + 1))
            else:
                yield block.name
