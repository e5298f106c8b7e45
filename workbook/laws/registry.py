"""The families of laws that a workbook knows: the pages of the engine's catalogue, in its order."""

from collections.abc import Sequence

from engine.laws import CATALOGUE, Law, family_named
from workbook.fields.texts import nearest_names
from workbook.laws.family import Page
from workbook.laws.pages import modified, pieces, ramps, simple, spline

FILES = (modified, pieces, ramps, simple, spline)
MEMBERS = [member for file in FILES for member in vars(file).values()]
PAGES = [page for part in MEMBERS for page in (part if isinstance(part, list) else [part]) if isinstance(page, Page)]


class IncompleteError(TypeError):
    """A law has no page."""


def page_of(law: type[Law], pages: Sequence[Page]) -> Page:
    """Return the page of a law; raise IncompleteError where it has none."""
    page = next((page for page in pages if page.law.code == law.code), None)
    if page is None:
        raise IncompleteError(f"no page in FILES of workbook/laws/registry.py is of the law {law.code}")
    return page


FAMILY: dict[str, Page] = {law.code: page_of(law, PAGES) for law in CATALOGUE}
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
