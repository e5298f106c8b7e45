"""The laws of a book: each a name, a family, what is entered, and the engine's law of it."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

from engine.laws import Law
from workbook.book.chart import in_scope
from workbook.laws.entries import Laws
from workbook.laws.family import Page
from workbook.laws.registry import CODES, FAMILY, Family


@dataclass(frozen=True)
class NamedLaw:
    """A law of a book: its name and number there, its family, what is entered of it."""

    name: str
    number: int
    family: Family
    entered: Any
    called: str
    """its name when the book was built: titles and checks keep it"""

    @cached_property
    def law(self) -> Law:
        """The engine's law."""
        return self.page.made(self.entered)

    @property
    def page(self) -> Page:
        """The page of its family."""
        return self.family.page

    @property
    def basic(self) -> bool:
        """Whether it is one of the laws that every book has."""
        return self.name in CODES

    @property
    def slug(self) -> str:
        """What the names of its cells begin with: valid whatever the law is called."""
        return self.family.code if self.basic else f"{self.family.code}{self.number}"

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
        NamedLaw(name, number, family_of(given, name), given[name], given.called(name))
        for number, name in enumerate(given.names, 1)
    ]


def family_of(given: Laws, name: str) -> Family:
    """Return the family of a law by its name."""
    return FAMILY[name if name == "DWL" else given[name].family]


def laws(given: Laws) -> dict[str, Law]:
    """Return the engine's laws by name, in the order of their numbers."""
    return {one.name: one.law for one in named(given)}
