"""Cells that call the functions MOTION.* beside a machine, and whether the names that define these are today's."""

from __future__ import annotations

from collections.abc import Collection, Container, Iterator

from openpyxl import Workbook

from workbook.book.address import Address
from workbook.functions.declared import FUNCTIONS, NAMESPACE
from workbook.functions.names import definitions, meaning
from workbook.reading.contents import Contents

OURS = frozenset(function.name for function in FUNCTIONS)
SHOWN = 5  # cells or names that a note lists


def calling(contents: Contents, declared: Container[Address]) -> set[Address]:
    """Return the cells outside of what is declared that call the functions: no witness but the add-in can."""
    return {a for a, formula in contents.formulas.items() if a not in declared and formula.functions & OURS}


def notes(workbook: Workbook, calls: Collection[Address]) -> Iterator[str]:
    """Yield what an engineer should know of the functions in a workbook."""
    if calls:
        yield f"cells that call MOTION.* are not evaluated, nor what follows from them: {listed(map(str, calls))}"
    other = changed(workbook)
    if other:
        yield f"names that are not today's definitions: {listed(other)}; take them from motion-functions.xlsx"


def changed(workbook: Workbook) -> list[str]:
    """Return the names of a workbook that are ours, but mean something else than today."""
    held = {name: one.attr_text or "" for name, one in workbook.defined_names.items() if NAMESPACE in name}
    if not held:  # as in most books: the definitions need not be read
        return []
    return [d.name for d in definitions() if d.name in held and meaning(held[d.name]) != meaning(d.formula)]


def listed(words: Iterator[str] | list[str]) -> str:
    """Return words in a line, the first few where there are many."""
    found = sorted(words)
    return ", ".join(found[:SHOWN]) + (f" and {len(found) - SHOWN} more" if len(found) > SHOWN else "")
