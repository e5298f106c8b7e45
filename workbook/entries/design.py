"""Unfinished designs: what was entered is shown with its faults, the engine works with other numbers in their place."""

from collections.abc import Callable, Sequence
from typing import Any, Literal, TypeVar, get_origin

from annotated_types import Ge
from pydantic import BaseModel, ValidationError

from workbook.entries import rules
from workbook.entries.machine import Fault, Machine
from workbook.errors import LONGEST, InputError, quoted
from workbook.fields.paths import get, join, leaves, put, split
from workbook.fields.types import LARGEST, SMALLEST, DesignError, DesignFaultsError, EntryError

M = TypeVar("M", bound=Machine)
BEYOND = ("greater_than", "greater_than_equal", "less_than", "less_than_equal")
Where = Callable[[str], str]  # how an entry is named, by its key


class RefusedError(InputError):
    """The faults in the structure or type of a description, pydantic's or a design's; faults of ``numbers`` beside."""

    def __init__(self, faults: list[Any], numbers: Sequence[Fault] = (), lines: Sequence[str] = ()) -> None:
        super().__init__(lines)
        self.faults, self.numbers = faults, numbers


def part_of(key: str) -> str:
    """Return the part of a machine in which an entry is: ``axes.1`` of all entries of its second axis."""
    return ".".join(key.split(".")[:2])


def machine_or_faults(model: type[M], check: Callable[[M], None], data: dict[str, Any]) -> tuple[M | None, list[Fault]]:
    """Return the machine of a description, or the faults of its numbers; raise RefusedError for all other faults."""
    try:
        machine = model.model_validate(data)
        check(machine)
    except ValidationError as error:
        faults = [(fault, numbers_of(fault, model)) for fault in error.errors(include_url=False)]
        mendable = [each for _, numbers in faults for each in numbers or ()]
        if refused := [fault for fault, numbers in faults if numbers is None]:
            raise RefusedError(refused, mendable) from None
        return None, mendable
    except DesignError as error:
        return None, [of_rule("", error)]
    return machine, []


def numbers_of(fault: Any, model: type[BaseModel]) -> list[Fault] | None:
    """Return the faults of numbers (beyond bounds, missing, inconsistent) in pydantic's error; None for others."""
    key, rule = keys_of(model, fault["loc"])
    cause = fault.get("ctx", {}).get("error")
    if isinstance(cause, DesignFaultsError):
        return [of_rule(key, error) for error in cause.faults]
    if key.startswith("sizes") or fault["type"] == "extra_forbidden":
        return None
    (kind, constraints), value = rules.field_at(model, rule), fault["input"]
    beyond = fault["type"] in BEYOND
    if not is_mendable(fault, kind, constraints):
        return None
    is_read_as_0 = not beyond and kind is float and Ge(0) in constraints  # as an empty cell is
    fits = 0.0 if is_read_as_0 else rules.within(kind, constraints)
    message = f"expected {rules.expectation(kind, constraints)}"
    return [Fault(key, message, fits, value if beyond else None, is_missing=not beyond)]


def is_mendable(fault: Any, kind: Any, constraints: list[Any]) -> bool:
    """Whether pydantic's fault is of a number, word or table that is missing, or of a number beyond its bounds."""
    value = fault["input"]
    if fault["type"] in BEYOND:
        return isinstance(value, int | float) and value == value and not rules.beyond_all(value, constraints)
    if fault["type"] in ("missing", "too_short") and get_origin(kind) is list:
        return rules.is_table(kind)
    is_plain = kind is float or get_origin(kind) is Literal or rules.takes_law(constraints)
    return is_plain and (fault["type"] == "missing" or value is None or value == {})


def fault_line(fault: Any, model: type[BaseModel], where: Where) -> str:
    """Return a line for a fault of a rule or of pydantic's: where, the value, what is expected."""
    if isinstance(fault, Fault):
        return f"{where(fault.key)}: {fault.message}"
    key, rule = keys_of(model, fault["loc"])
    cause = fault.get("ctx", {}).get("error")
    if isinstance(cause, EntryError):
        return f"{where(f'{key}.{cause.field}'.strip('.'))}: {cause}"
    if fault["type"].startswith("union_tag"):
        kind_text = quoted(fault["input"].get(rules.KIND)) if fault["type"] == "union_tag_invalid" else ""
        expected = rules.either(rules.kinds_at(model, rule.split(".")))
        return f"{where(f'{key}.{rules.KIND}')}: {f'found {kind_text}' if kind_text else 'empty'}; expected {expected}"
    if fault["type"] == "extra_forbidden":
        return unknown_line(fault["loc"], key, rule, model, where)
    kind, constraints = rules.field_at(model, rule)
    expected = rules.expectation(kind, constraints)
    if fault["type"] == "missing" or fault["input"] in ({}, None):
        return f"{where(key)}: empty; expected {expected}"
    if isinstance(fault["input"], int | float) and rules.beyond_all(fault["input"], constraints):
        expected = f"a number of at most {LARGEST:g} in size, and of at least {SMALLEST:g} if it is more than 0"
    optional = "" if rules.is_required(model, rule) else " (optional)"
    return f"{where(key)}: found {quoted(fault['input'])}; expected {expected}{optional}"


def unknown_line(loc: Sequence[Any], key: str, rule: str, model: type[BaseModel], where: Where) -> str:
    """Return the line for an entry that its table does not know, with those that it knows."""
    above, unknown = key.removesuffix(f".{loc[-1]}"), str(loc[-1])
    kind, _ = rules.field_at(model, rule.removesuffix(f".{unknown}") if "." in rule else "")
    plain = unknown.isidentifier() and len(unknown) < LONGEST
    named = where(f"{above if len(loc) > 1 else ''}.{unknown if plain else quoted(unknown)}".strip("."))
    return f"{named}: unknown entry; expected one of {rules.list_entries(kind)}"


def of_rule(where: str, error: DesignError) -> Fault:
    """Return the fault of a rule of the entries at ``where``."""
    return Fault(f"{where}.{error.field}".strip("."), str(error), error.fits, error.value)


def keys_of(model: type[BaseModel], loc: tuple[int | str, ...]) -> tuple[str, str]:
    """Return the key of a fault of pydantic's, and of its rule: by a law's family, by the kind of a table."""
    given = [*map(str, loc)]
    if len(given) < 3 or given[0] != "laws":
        own = [part for i, part in enumerate(given) if part not in rules.kinds_at(model, given[:i])]
        return ".".join(own), ".".join(given)
    _, name, family, *rest = given
    return join(["laws", name, *rest]), ".".join(["laws", family, *rest])


def rule_key(path: str, data: dict[str, Any]) -> str:
    """Return the key of the rule for an entry: of a law that has a name of its own, that of its family."""
    names = split(path)
    if len(names) > 1 and names[0] == "laws":
        names = ("laws", get(data, ("laws", names[1], "family"), names[1]), *names[2:])
    return join(names)


def differing_entries(
    model: type[BaseModel], entered: dict[str, Any], whole: dict[str, Any], replaced: Sequence[str]
) -> dict[str, Any]:
    """Return by key the entries below the places that were replaced, where they differ."""
    by_path: dict[str, Any] = {}
    for place in map(split, replaced):
        old, new = ({join(way): value for way, value in leaves(get(data, place), place)} for data in (entered, whole))
        for key in new | old:
            absent = old.get(key, {}) == {}
            was = None if absent else old[key]
            if absent and key in new and get(entered, split(key)[:-1]):
                was = rules.default_at(model, rule_key(key, entered))
            if was != new.get(key):
                by_path.setdefault(key, plain(was))
    return by_path


def plain(value: Any) -> Any:
    """Return an entry as models have it: whole numbers too are decimal ones."""
    return float(value) if isinstance(value, int) and not isinstance(value, bool) else value


def as_entered(machine: Machine) -> dict[str, Any]:
    """Return the description of a machine with what was entered, finished or not."""
    data = machine.model_dump(exclude_none=True)
    for key, old in machine.design.replaced.items():
        put(data, split(key), old)
    return dict(without_empty(data))


def without_empty(data: Any) -> Any:
    """Return a description without empty entries, and without empty rows at the end of lists."""
    if isinstance(data, dict):
        return {key: without_empty(value) for key, value in data.items() if value is not None}
    if isinstance(data, list):
        rows = [without_empty(value) for value in data]
        while rows and rows[-1] in ({}, None):
            rows.pop()
        return rows
    return data
