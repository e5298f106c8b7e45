"""The families of laws that a workbook knows: the pages of the engine's catalogue, in its order."""

from collections.abc import Sequence
from importlib import import_module
from pkgutil import iter_modules

from engine.laws import CATALOGUE, family_named
from workbook.fields.texts import nearest_names
from workbook.laws import pages
from workbook.laws.family import Page

FILES = [import_module(f"{pages.__name__}.{file.name}") for file in iter_modules(pages.__path__)]
MEMBERS = [member for file in FILES for member in vars(file).values()]
LISTED = [page for member in MEMBERS for page in (member if isinstance(member, list) else [member])]
PAGES = {page.law.code: page for page in LISTED if isinstance(page, Page)}
if _lacking := [law.code for law in CATALOGUE if law.code not in PAGES]:
    raise TypeError(f"no file of workbook/laws/pages has the page of {', '.join(_lacking)}")
FAMILY: dict[str, Page] = {law.code: PAGES[law.code] for law in CATALOGUE}
"""the pages of all families by code, in the order of the catalogue"""
CODES: tuple[str, ...] = ("DWL", "ACS", "TVP", "CIC", "CUB", "MTP", "OWN")
"""the basic laws, which every book has, in the order of their numbers: each named by the code of its family"""
RISING: tuple[str, ...] = CODES[1:]  # those of them that move
# of all families
NAMES = tuple(name for law in CATALOGUE for name in (law.code, law.name, *law.aliases))


def code_named(name: str) -> str | None:
    """Return the code of the family that people call so; None where the catalogue has none."""
    family = family_named(name)
    return family.code if family else None


def nearest_laws(name: str, own: Sequence[str]) -> list[str]:
    """Return the three names, of a book's own laws and of the catalogue's, that are most like the given name."""
    return nearest_names(name, [*own, *NAMES])
