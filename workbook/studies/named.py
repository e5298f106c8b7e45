"""The results that a study may ask for, by the names of the book, with their labels and units."""

from __future__ import annotations

from typing import NamedTuple

from workbook.book.declare import Book
from workbook.errors import InputError
from workbook.studies.evaluate import of_book
from workbook.studies.model import Bound
from workbook.studies.paths import nearest
from workbook.studies.plan import Plan, book_names

UNITS = {"mass": "kg"}


class Label(NamedTuple):
    """What a result is called, and its unit."""

    words: str
    unit: str


Named = dict[str, Label]


def require_names(plan: Plan, where: str) -> Named:
    """Return the labels of the results that are asked for; raise InputError for one that there is not."""
    book = plan.template.declare(plan.base)
    scaling = plan.template.scaling
    swift = scaling.results(plan.base, {}) if scaling else {}
    known = dict.fromkeys([*swift, *book_names(book)])
    lines = []
    for name in plan.study.names:
        if name not in known:
            lines.append(f"{where}: no result is named {name!r}; expected {nearest(name, known)}")
            continue
        value = swift[name]() if name in swift else of_book(book, name)
        text = isinstance(plain(value), str)
        if name in plan.study.goals and text:
            lines.append(f"{where}: {name} is a text, {plain(value)!r}; expected a number to minimise or maximise")
        bound = plan.study.constraints.get(name)
        if bound is not None and text == isinstance(bound, Bound):
            expected = f'{name} = "OK"' if text else f"{name} = {{ max = ... }}"
            lines.append(f"{where}: constraints: {name} is {'a text' if text else 'a number'}; expected {expected}")
    if lines:
        raise InputError(lines)
    return {name: label(book, name) for name in plan.study.names}


def plain(value: object) -> object:
    """Return one value of a result."""
    return value.ravel()[0].item() if hasattr(value, "ravel") else value


def label(book: Book, name: str) -> Label:
    """Return what a result is called."""
    block, _, rest = name.partition(".")
    found = book.blocks.get(block)
    if found is None:
        return Label(name.partition("_")[2].replace("_", " "), UNITS.get(name.rpartition("_")[2], ""))
    column = rest.partition(".")[0]
    quantity = next(q for q in found.quantities if not column or q.name == column)
    return Label(quantity.label, quantity.unit)
