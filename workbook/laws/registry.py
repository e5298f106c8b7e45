"""The families of laws that a workbook knows: those of the engine's registry, each with its page."""

from importlib import import_module
from typing import NamedTuple

from engine.laws import Entry
from engine.laws.entry import IncompleteError
from engine.laws.registry import MODULES, entry_of
from workbook.laws.family import Page


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
    page.require_complete(entry)
    return Family(entry, page)


FAMILIES: tuple[Family, ...] = tuple(family_of(module) for module in MODULES)
FAMILY: dict[str, Family] = {family.code: family for family in FAMILIES}
CODES: tuple[str, ...] = ("DWL", "ACS", "TVP", "CIC", "CUB", "MTP", "OWN")
"""the basic laws, which every book has, in the order of their numbers: each named by the code of its family"""
BASIC: tuple[Family, ...] = tuple(FAMILY[code] for code in CODES)
RISING: tuple[str, ...] = tuple(code for code in CODES if FAMILY[code].entry.rises)
"""those of them that move"""
