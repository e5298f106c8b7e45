"""The families of laws that a workbook knows: those of the engine's registry, each with its page."""

import re
from collections.abc import Iterator, Sequence
from importlib import import_module
from typing import Any, NamedTuple

from engine.laws import Entry
from engine.laws.entry import IncompleteError
from engine.laws.registry import MODULES, entry_of
from engine.motion.handover import PULSES, early_of, end_mode
from workbook.laws.family import COEFFICIENTS, Page


class Family(NamedTuple):
    """A family of laws: what the engine knows of it, and its page."""

    entry: Entry
    page: Page

    @property
    def code(self) -> str:
        """The code of three letters."""
        return self.entry.code


def family_of(module: str) -> Family:
    """Return the family of a name in the registry; raise IncompleteError where it has no page, or half of one."""
    entry, place = entry_of(module), f"workbook.laws.pages.{module}"
    try:
        page = getattr(import_module(place), "PAGE", None)
    except ModuleNotFoundError as error:
        if error.name != place:
            raise
        page = None
    if not isinstance(page, Page):
        raise IncompleteError(f"workbook/laws/pages/{module}.py has no PAGE for the law {entry.code}")
    if page.pieces:  # else they are what is entered
        require_complete(page, entry)
    return Family(entry, page)


def require_complete(page: Page, entry: Entry) -> None:
    """Raise IncompleteError, naming the law and what its page leaves out, or has otherwise than the engine."""
    examples, default = entry.examples, page.entries() if page.entries else None
    wrong = [name for name, *_ in COEFFICIENTS if name not in page.coefficients]
    if any(len(law.monotone_pieces()) != len(page.pieces) for law in examples):
        wrong.append(f"pieces as many as the engine's {len(examples[0].monotone_pieces())}")
    ways = {int(found) for found in re.findall(r"(?<=[=,])-?[0-9](?=$|[,)])", page.way)}
    early = {way: page.early if way == PULSES else 0 for way in ways}
    if any(early.get(end_mode(law)) != early_of(law) for law in examples):
        wrong.append("how it meets its neighbours, as the engine has it")
    keys = set(numbered(default, page.fields)) ^ {parameter.key for parameter in page.parameters}
    wrong += [f"the parameter {key}" for key in sorted(keys)]
    wrong += [f"variations of {key}" for key in page.fields if any(key not in v for v in page.variations)]
    if page.parameters and len(page.variations) < 2:
        wrong.append("two variations or more")
    if wrong:
        raise IncompleteError(f"the page of {entry.code} lacks {', '.join(wrong)}")


def numbered(entered: Any, fields: Sequence[str]) -> Iterator[str]:
    """Yield the key of each number in these entries."""
    for name in fields:
        value = getattr(entered, name)
        yield from (f"{name}.{i}" for i in range(len(value))) if isinstance(value, list) else (name,)


FAMILIES: tuple[Family, ...] = tuple(family_of(module) for module in MODULES)
FAMILY: dict[str, Family] = {family.code: family for family in FAMILIES}
CODES: tuple[str, ...] = ("DWL", "ACS", "TVP", "CIC", "CUB", "MTP", "OWN")
"""the basic laws, which every book has, in the order of their numbers: each named by the code of its family"""
BASIC: tuple[Family, ...] = tuple(FAMILY[code] for code in CODES)
RISING: tuple[str, ...] = tuple(code for code in CODES if FAMILY[code].entry.rises)
"""those of them that move"""
