"""Whether the names that define the functions MOTION.*, copied beside a machine, are today's."""

from collections.abc import Iterator

from openpyxl import Workbook

from workbook.functions.declared import NAMESPACE
from workbook.functions.names import definitions, meaning

SHOWN = 5  # names that a note lists


def notes(workbook: Workbook) -> Iterator[str]:
    """Yield what an engineer should know of the functions in a workbook."""
    other = changed(workbook)
    if other:
        yield f"names that are not today's definitions: {listed(other)}; take them from motion-functions.xlsx"


def changed(workbook: Workbook) -> list[str]:
    """Return the names of a workbook that are ours, but mean something else than today."""
    held = {name: one.attr_text or "" for name, one in workbook.defined_names.items() if NAMESPACE in name}
    if not held:  # as in most books: the definitions need not be read
        return []
    return [d.name for d in definitions() if d.name in held and meaning(held[d.name]) != meaning(d.stored)]


def listed(words: list[str]) -> str:
    """Return words in a line, the first few where there are many."""
    found = sorted(words)
    return ", ".join(found[:SHOWN]) + (f" and {len(found) - SHOWN} more" if len(found) > SHOWN else "")
