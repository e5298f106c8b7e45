"""Which laws a workbook has besides the basic ones, told by the names of its cells."""

import re
from collections.abc import Iterable

from workbook.entries.machine import Machine
from workbook.laws.entries import ENTRIES, Laws, references
from workbook.laws.registry import CODES, RISING

NAME = re.compile(r"([A-Z][A-Z0-9]{2})(\d{1,4})_called")


def numbered(names: Iterable[str]) -> dict[str, str]:
    """Return the family of each law that has a name of its own, by its key such as ``MTP8``, in their order."""
    found = [match for match in map(NAME.fullmatch, names) if match and match[1] in ENTRIES]
    return {f"{match[1]}{match[2]}": match[1] for match in sorted(found, key=lambda match: int(match[2]))}


def with_laws(machine: Machine, laws: dict[str, str]) -> Machine:
    """Return a machine whose book has cells for these laws, and for no other besides the basic ones."""
    copy = machine.model_copy(
        deep=True, update={"laws": Laws({key: {"family": family} for key, family in laws.items()})}
    )
    for one in references(copy):
        if one.name not in CODES:
            object.__setattr__(one.entries, one.field, RISING[0])
    return copy
