"""What Excel accepts in an input cell, derived from the machine model that the input belongs to."""

from __future__ import annotations

import types
from typing import Any, Literal, Union, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt, MaxLen
from openpyxl.worksheet.datavalidation import DataValidation
from pydantic import BaseModel
from pydantic.fields import FieldInfo

from workbook.declare import Quantity


def field_at(model: type[BaseModel], key: str) -> tuple[Any, list[Any]]:
    """Return the bare type and the constraints of the entry at ``key``; raise KeyError where there is none."""
    kind: Any = model
    constraints: list[Any] = []
    for part in key.split("."):
        if part == "*" or part.isdigit():
            kind, constraints = unwrap(get_args(kind)[0], [])
        else:
            kind, constraints = unwrap(kind.model_fields[part].annotation, kind.model_fields[part].metadata)
    return kind, constraints


def unwrap(annotation: Any, constraints: list[Any]) -> tuple[Any, list[Any]]:
    """Strip ``Annotated`` and ``| None`` from a type, collecting the constraints on the way."""
    found = list(constraints)
    if hasattr(annotation, "__metadata__"):
        for note in annotation.__metadata__:
            found += note.metadata if isinstance(note, FieldInfo) else [note]
        return unwrap(get_args(annotation)[0], found)
    if get_origin(annotation) in (Union, types.UnionType):
        return unwrap(next(a for a in get_args(annotation) if a is not type(None)), found)
    return annotation, found


def validation(model: type[BaseModel], q: Quantity) -> DataValidation:
    """Return the rule and the two messages for the cells of input ``q``."""
    kind, constraints = field_at(model, q.key)
    if q.choices:
        rule, expected = DataValidation("list", formula1=q.choices), "one entry of the list"
    elif get_origin(kind) is Literal:
        options = get_args(kind)
        rule, expected = DataValidation("list", formula1=f'"{",".join(options)}"'), " or ".join(options)
    elif kind is str:
        length = next((c.max_length for c in constraints if isinstance(c, MaxLen)), 80)
        rule = DataValidation("textLength", operator="between", formula1="1", formula2=str(length))
        expected = f"a text of at most {length} characters"
    else:
        rule, expected = number_rule(constraints)
    rule.showErrorMessage = rule.showInputMessage = True  # off by default, and then nothing is enforced
    rule.allow_blank = q.key.find("*") >= 0
    rule.promptTitle, rule.errorTitle = clip(q.label, 32), clip(q.label, 32)
    unit = f" [{q.unit}]" if q.unit else ""
    rule.prompt = clip(f"Enter {expected}{unit}.", 255)
    rule.error = clip(f"Expected {expected}{unit}.", 255)
    return rule


def number_rule(constraints: list[Any]) -> tuple[DataValidation, str]:
    """Return the rule for a number within bounds, and the bounds in words."""
    low: Any = -1e300
    high: Any = 1e300
    low_word = high_word = ""
    for c in constraints:
        if isinstance(c, Gt):
            low, low_word = c.gt, f"greater than {c.gt:g}"
        elif isinstance(c, Ge):
            low, low_word = c.ge, f"of at least {c.ge:g}"
        elif isinstance(c, Lt):
            high, high_word = c.lt, f"less than {c.lt:g}"
        elif isinstance(c, Le):
            high, high_word = c.le, f"at most {c.le:g}"
    words = " and ".join(w for w in (low_word, high_word) if w)
    strict = next((c for c in constraints if isinstance(c, Gt)), None)
    if strict is not None and not high_word:
        return DataValidation("decimal", operator="greaterThan", formula1=repr(low)), f"a number {words}"
    rule = DataValidation("decimal", operator="between", formula1=repr(low), formula2=repr(high))
    return rule, f"a number {words}" if words else "a number"


def clip(text: str, length: int) -> str:
    """Shorten a text to what Excel's message boxes take."""
    return text if len(text) <= length else text[: length - 1] + "…"
