"""The rules of Excel for an input cell, derived from the machine model that the input belongs to."""

import types
from collections.abc import Callable, Iterable, Sequence
from dataclasses import astuple
from functools import cache
from math import inf
from typing import Any, Literal, Union, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt, MaxLen, MinLen
from openpyxl.worksheet.datavalidation import DataValidation
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from workbook.book.declare import Quantity
from workbook.book.limits import Limit
from workbook.fields.types import LARGEST, SMALLEST, CountsAs, EmptyCell
from workbook.laws.entries import TakesLaw
from workbook.laws.registry import RISING

KIND = "kind"  # the entry that says which kind a table is of


def field_at(model: type[BaseModel], key: str) -> tuple[Any, list[Any]]:
    """Return the type (models, of a table of several kinds) and constraints at a key; raise KeyError where none is."""
    kind: Any = model
    constraints: list[Any] = []
    for part in filter(None, key.split(".")):
        if hasattr(kind, "entry_at"):
            kind, constraints = kind.entry_at(part), []
        elif part == "*" or part.isdigit():
            kind, constraints = unwrap(get_args(kind)[0], [])
        elif part in kinds(kind):
            kind, constraints = kinds(kind)[part], []
        else:
            field = fields(kind)[part]
            kind, constraints = unwrap(field.annotation, field.metadata)
    return kind, constraints


def tables(kind: Any) -> tuple[type[BaseModel], ...]:
    """Return the models that a table may be of: several of a table of different kinds, none of an entry."""
    own = kind if isinstance(kind, tuple) else (kind,)
    return own if all(isinstance(model, type) and issubclass(model, BaseModel) for model in own) else ()


def kinds(kind: Any) -> dict[str, type[BaseModel]]:
    """Return the models of a table of different kinds by what the entry ``kind`` says; none of any other."""
    models = tables(kind)
    several = len(models) > 1 and all(KIND in model.model_fields for model in models)
    return {get_args(model.model_fields[KIND].annotation)[0]: model for model in models} if several else {}


def kinds_at(model: type[BaseModel], path: Sequence[str]) -> dict[str, type[BaseModel]]:
    """Return the models of a table of different kinds at a path of entries; none of any other."""
    try:
        return kinds(field_at(model, ".".join(path))[0])
    except (KeyError, IndexError, AttributeError):
        return {}


def fields(kind: Any) -> dict[str, FieldInfo]:
    """Return the entries of a table, of whatever kind it is."""
    return {name: field for own in reversed(tables(kind)) for name, field in own.model_fields.items()}


def unwrap(annotation: Any, constraints: list[Any]) -> tuple[Any, list[Any]]:
    """Strip ``Annotated`` and ``| None`` from a type, collecting the constraints on the way."""
    gathered = list(constraints)
    if hasattr(annotation, "__metadata__"):
        for note in annotation.__metadata__:
            gathered += note.metadata if isinstance(note, FieldInfo) else [note]
        return unwrap(get_args(annotation)[0], gathered)
    if get_origin(annotation) in (Union, types.UnionType):
        several = [a for a in get_args(annotation) if a is not type(None)]
        models = tables(tuple(several))
        return (models, gathered) if len(models) > 1 else unwrap(several[0], gathered)
    return annotation, gathered


def validation(model: type[BaseModel], q: Quantity) -> DataValidation:
    """Return the rule and the two messages for the cells of input ``q``."""
    kind, constraints = field_at(model, q.key)
    constraints = up_to(q.upper_limit, constraints)
    expected = expectation(kind, constraints)
    if q.choices:
        rule, expected = DataValidation("list", formula1=q.choices), "one entry of the list"
    elif get_origin(kind) is Literal:
        rule = DataValidation("list", formula1=f'"{",".join(get_args(kind))}"')
    elif is_free_text(model, q):
        rule = DataValidation("textLength", operator="between", formula1="1", formula2=str(longest(constraints)))
    else:
        ends = {SIGNS[type(c)]: astuple(c)[0] for c in reversed(constraints) if type(c) in SIGNS}
        low, high = ends.get(">=", ends.get(">", -1e300)), ends.get("<", ends.get("<=", 1e300))
        rule = DataValidation("decimal", operator="between", formula1=repr(low), formula2=repr(high))
        if ">" in ends and high == 1e300:
            rule = DataValidation("decimal", operator="greaterThan", formula1=repr(ends[">"]))
    # off by default, and then nothing is enforced
    rule.showErrorMessage = rule.showInputMessage = True
    may_be_empty = not must_be_entered(model, q.key)
    rule.allow_blank = may_be_empty or "*" in q.key
    rule.promptTitle = rule.errorTitle = clip(q.label, 32)
    unit = f" [{q.unit}]" if q.unit else ""
    expected = f"{expected}{unit}"
    empty = (", or leave empty", ", or nothing") if may_be_empty else ("", "")
    rule.prompt, rule.error = f"Enter {clip(expected, 225)}{empty[0]}.", f"Expected {clip(expected, 225)}{empty[1]}."
    return rule


def is_free_text(model: type[BaseModel], q: Quantity) -> bool:
    """Whether a cell is for a text that the engineer makes up: no figure, no word of a list."""
    return q.role == "input" and not q.choices and field_at(model, q.key)[0] is str


@cache
def limits(model: type[BaseModel]) -> Callable[[str, float], Limit | None]:
    """Return a function from the key of an entry, and its largest value, to its limits in cells.

    It has limits where it is a number, or a required word.
    """

    @cache
    def limit(key: str, most: float) -> Limit | None:
        kind, constraints = field_at(model, key)
        constraints = up_to(most, constraints)
        if get_origin(kind) is list:
            return Limit(any(isinstance(c, MinLen) and c.min_length for c in constraints), (), "", number=False)
        required = must_be_entered(model, key)
        if kind is float:
            bounds = tuple((SIGNS[type(c)], float(astuple(c)[0])) for c in plain_bounds(constraints))
            return Limit(required, bounds, expectation(kind, constraints))
        listed = get_origin(kind) is Literal or takes_law(constraints)
        return Limit(True, (), "one entry of the list", number=False) if listed and required else None

    return limit


def up_to(most: float, constraints: list[Any]) -> list[Any]:
    """Return constraints of a number that is at most so large."""
    return constraints if most == inf else [*(c for c in constraints if not isinstance(c, Le)), Le(most)]


def is_required(model: type[BaseModel], key: str) -> bool:
    """Whether an entry must be there: it has no default."""
    field = field_of_entry(model, key)
    return field is None or bool(field.is_required())


def field_of_entry(model: type[BaseModel], key: str) -> FieldInfo | None:
    """Return the field of an entry; None of a row of a list."""
    above, _, last = key.rpartition(".")
    return None if last == "*" or last.isdigit() else fields(field_at(model, above)[0]).get(last)


def must_be_entered(model: type[BaseModel], key: str) -> bool:
    """Whether a cell must hold the entry: a description without it has a default that an empty cell is not."""
    if is_required(model, key):
        return True
    _, constraints = field_at(model, key)
    read = takes_law(constraints) or any(isinstance(c, EmptyCell) for c in constraints)
    return default_at(model, key) not in (None, 0, "", [], {}) and not read


def default_at(model: type[BaseModel], key: str) -> Any:
    """Return the default of an entry; None where it has none."""
    field = field_of_entry(model, key)
    return None if field is None else default_of(field)


def default_of(field: FieldInfo) -> Any:
    """Return the default of a field; None where it has none."""
    return None if field.is_required() else field.get_default(call_default_factory=True)


def takes_law(constraints: list[Any]) -> bool:
    """Whether an entry names a law."""
    return any(isinstance(c, TakesLaw) for c in constraints)


def is_table(kind: Any) -> bool:
    """Whether a list is a table of rows, each of several entries and none of them a table again."""
    rows = tables(get_args(kind)[0])
    entries = [unwrap(entry.annotation, [])[0] for row in rows for entry in row.model_fields.values()]
    return bool(rows) and not any(get_origin(entry) is list or tables(entry) for entry in entries)


def within(kind: Any, constraints: list[Any]) -> Any:
    """Return an entry that keeps to its constraints: a number near 1, the first word, a row of such entries."""
    if get_origin(kind) is list:
        required = {name: field for name, field in fields(get_args(kind)[0]).items() if field.is_required()}
        return [{name: within(*unwrap(field.annotation, field.metadata)) for name, field in required.items()}]
    if get_origin(kind) is Literal:
        return get_args(kind)[0]
    if takes_law(constraints):
        return RISING[0]
    if kind is str:
        return "A"
    if counted := [c.value for c in constraints if isinstance(c, CountsAs)]:
        return counted[0]
    low = max((astuple(c)[0] for c in constraints if isinstance(c, Gt | Ge)), default=-LARGEST)
    high = min((astuple(c)[0] for c in constraints if isinstance(c, Lt | Le)), default=LARGEST)
    return 1.0 if low < 1.0 < high else (low + high) / 2


SIGNS: dict[Any, str] = {Gt: ">", Ge: ">=", Lt: "<", Le: "<="}


def plain_bounds(constraints: list[Any]) -> list[Any]:
    """Return the bounds of a number that a person would know; of two lower ones the greater counts."""
    bounds = [c for c in constraints if type(c) in SIGNS and abs(astuple(c)[0]) not in (LARGEST, SMALLEST)]
    least = max((astuple(c)[0] for c in bounds if isinstance(c, Gt | Ge)), default=0.0)
    return [c for c in bounds if isinstance(c, Lt | Le) or astuple(c)[0] == least]


def beyond_all(value: float, constraints: list[Any]) -> bool:
    """Whether a number is beyond what any entry may be, or so small that nobody means it."""
    too_small = Ge(SMALLEST) in constraints and 0 < value < SMALLEST
    return abs(value) > LARGEST or too_small


def expectation(kind: Any, constraints: list[Any]) -> str:
    """Return in words what an entry of a type and its constraints must be."""
    if get_origin(kind) is Literal:
        return either(get_args(kind))
    if kind is bool:
        return "true or false"
    if kind is str:
        return f"a text of 1 to {longest(constraints)} characters that does not begin with ="
    if get_origin(kind) is list:
        return list_expectation(constraints)
    if kinds(kind):
        return f"the entries of a {either(kinds(kind))}"
    if tables(kind):
        return f"the entries {list_entries(kind)}"
    return f"{'a whole number' if kind is int else 'a number'} {bounds_expectation(constraints)}".strip()


def list_expectation(constraints: list[Any]) -> str:
    """Return in words how many entries a list must have."""
    least = next((c.min_length for c in constraints if isinstance(c, MinLen)), 0)
    most = next((c.max_length for c in constraints if isinstance(c, MaxLen)), None)
    if most is not None:
        return f"{least} entries" if least == most else f"a list of {least} to {most} entries"
    return f"a list of at least {least} entries" if least else "a list"


def bounds_expectation(constraints: list[Any]) -> str:
    """Return in words the bounds of a number."""
    bounds = [BOUNDS[type(c)].format(astuple(c)[0]) for c in plain_bounds(constraints)]
    low, high = ([c for c in plain_bounds(constraints) if isinstance(c, kinds)] for kinds in (Gt | Ge, Lt | Le))
    if low and high:
        bounds = [BETWEEN[type(low[0]), type(high[0])].format(astuple(low[0])[0], astuple(high[0])[0])]
    return " and ".join(bounds)


def either(choices: Iterable[Any]) -> str:
    """Return choices in words."""
    *others, last = map(str, choices)
    return f"{', '.join(others)} or {last}" if others else last


def list_entries(kind: Any) -> str:
    """Return the entries of a table in words, those that may be left out last; of either of two tables, each."""
    if len(tables(kind)) > 1 and not kinds(kind):
        return ", or ".join(map(list_entries, tables(kind)))
    required = [name for name, field in fields(kind).items() if field.is_required()]
    optional = [name for name in fields(kind) if name not in required]
    if not required:
        return f"{', '.join(optional)} (all optional)"
    return "; optional: ".join(filter(None, (", ".join(required), ", ".join(optional))))


BOUNDS: dict[Any, str] = {Gt: "greater than {:g}", Ge: "of at least {:g}", Lt: "less than {:g}", Le: "at most {:g}"}
BETWEEN: dict[Any, str] = {
    (Ge, Le): "from {:g} to {:g}", (Ge, Lt): "from {:g} to below {:g}",
    (Gt, Le): "above {:g}, up to {:g}", (Gt, Lt): "above {:g}, below {:g}",
}  # fmt: skip


def longest(constraints: list[Any]) -> int:
    """Return how many characters a text may have."""
    return next((c.max_length for c in constraints if isinstance(c, MaxLen)), 80)


def clip(text: str, length: int) -> str:
    """Shorten a text to what Excel's message boxes take."""
    return text if len(text) <= length else text[: length - 1] + "…"
