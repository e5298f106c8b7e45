"""The laws of a book: name, family, entries, the engine's law; names of cells tell which there are beside the basic."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from engine.laws import Law
from workbook.book.chart import in_scope
from workbook.entries.machine import Machine
from workbook.laws.entries import ENTRIES, Laws, references
from workbook.laws.family import Page
from workbook.laws.registry import CODES, FAMILY, RISING

CALLED = re.compile(r"([A-Z][A-Z0-9]{2})(\d{1,4})_called")


@dataclass(frozen=True)
class NamedLaw:
    """A law of a book: its name and number there, the page of its family, what is entered of it."""

    name: str
    number: int
    page: Page
    entered: Any
    called: str  # its name when the book was built: titles and checks keep it

    @cached_property
    def law(self) -> Law:
        """The engine's law."""
        return self.page.made(self.entered)

    @property
    def words(self) -> str:
        """Its name in words."""
        return str(getattr(self.entered, "name", self.page.law.name))

    @property
    def basic(self) -> bool:
        """Whether it is one of the laws that every book has."""
        return self.name in CODES

    @property
    def slug(self) -> str:
        """What the names of its cells begin with: valid whatever the law is called."""
        return self.page.code if self.basic else f"{self.page.code}{self.number}"

    @property
    def key(self) -> str:
        """The place of its entries in what is read of a book."""
        return f"laws.{self.slug}"

    def own(self, text: str) -> str:
        """Return a name or a formula of its page as other sheets write it."""
        return in_scope(text, f"{self.slug}_")

    @property
    def listed(self) -> str:
        """The formula of its name in the list of laws."""
        return f'="{self.name}"' if self.basic else self.own("=@called")

    @property
    def finding(self) -> str:
        """The formula of its number."""
        return f'=MATCH("{self.name}",law_code,0)' if self.basic else "=MATCH(@called,law_code,0)"


def named(given: Laws) -> list[NamedLaw]:
    """Return the laws of a book in the order of their numbers."""
    return [
        NamedLaw(name, number, FAMILY[given[name].family if given[name] else name], given[name], given.called(name))
        for number, name in enumerate(given.names, 1)
    ]


def laws(given: Laws) -> dict[str, Law]:
    """Return the engine's laws by name, in the order of their numbers."""
    return {one.name: one.law for one in named(given)}


def numbered(names: Iterable[str]) -> dict[str, str]:
    """Return the family of each law that has a name of its own, by its key such as ``MTP8``, in their order."""
    found = [match for match in map(CALLED.fullmatch, names) if match and match[1] in ENTRIES]
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
