"""The results that a study may ask for, by the names of the book, with their labels and units."""

import re
from collections.abc import Iterator
from fnmatch import filter as matching
from typing import NamedTuple

from workbook.book.declare import Book
from workbook.entries.machine import Machine
from workbook.errors import InputError
from workbook.studies.evaluate import of_book, of_no_book
from workbook.studies.model import Bound
from workbook.studies.paths import nearest
from workbook.studies.plan import Plan, book_names
from workbook.templates import TEMPLATES

UNITS = {"mass": "kg"}
ROW = re.compile(r"(.+)\.(\d+)")


class Label(NamedTuple):
    """What a result is called, and its unit."""

    words: str
    unit: str


Named = dict[str, Label]


def require_names(plan: Plan, where: str) -> Named:
    """Return the labels of results and constraints; raise InputError for a name that there is not."""
    book, usual, study = plan.template.declare(plan.base), of_no_book(plan.base), plan.study
    known = dict.fromkeys([*usual.named, *book_names(book)])
    checks = [q.name for _, q in book.checks]
    lines = []
    for pattern in study.off:
        if not matching([*checks, *known], pattern):
            lines.append(f"{where}: constraints: no check is named {pattern!r}; expected {nearest(pattern, checks)}")
    for name in study.names:
        if name not in known:
            lines.append(f"{where}: no result is named {name!r}; expected {nearest(name, known)}")
            continue
        value = usual.named[name]() if name in usual.named else of_book(book, name)
        value = value.ravel()[0].item() if hasattr(value, "ravel") else value
        text = isinstance(value, str)
        if name in study.goals and text:
            lines.append(f"{where}: {name} is a text, {value!r}; expected a number to minimise or maximise")
        bound = study.bounds.get(name)
        if bound is not None and text == isinstance(bound, Bound):
            expected = f'{name} = "OK"' if text else f"{name} = {{ max = ... }}"
            lines.append(f"{where}: constraints: {name} is {'a text' if text else 'a number'}; expected {expected}")
    if lines:
        raise InputError(lines)
    return {name: label(book, name) for name in dict.fromkeys([*study.names, *plan.bounds, *checks])}


def listed(machine: Machine) -> Iterator[tuple[str, list[tuple[str, Label]]]]:
    """Yield headings and the names below them, those of a table's rows as one: ``axis1.v.1…3``."""
    template = TEMPLATES[machine.template]
    book, usual = template.declare(machine), of_no_book(machine)
    inputs = {name for name, block in book.blocks.items() for q in block.quantities if q.role == "input"}
    named = dict.fromkeys(name for name in book_names(book) if name.partition(".")[0] not in inputs)
    fast = [name for name in usual.named if name not in usual.slow]
    slow = [name for name in usual.named if name in usual.slow]
    others = [name for name in named if name not in usual.named]
    for heading, names in (("Fast", fast), ("Each design by itself", slow), ("From a book of each design", others)):
        yield heading, [(name, label(book, name.partition("…")[0])) for name in gathered(names)]


def gathered(names: list[str]) -> Iterator[str]:
    """Yield names, those of a table's rows as one."""
    rows: dict[str, list[str]] = {}
    for name in names:
        found = ROW.fullmatch(name)
        rows.setdefault(found[1] if found else name, []).append(found[2] if found else "")
    for name, numbers in rows.items():
        last = f"…{numbers[-1]}" if len(numbers) > 1 else ""
        yield f"{name}.{numbers[0]}{last}" if numbers[0] else name


def label(book: Book, name: str) -> Label:
    """Return what a result is called."""
    block, _, rest = name.partition(".")
    found = book.blocks.get(block)
    if found is None:
        return Label(name.partition("_")[2].replace("_", " "), UNITS.get(name.rpartition("_")[2], ""))
    column = rest.partition(".")[0]
    quantity = next(q for q in found.quantities if not column or q.name == column)
    return Label(quantity.label, quantity.unit)
