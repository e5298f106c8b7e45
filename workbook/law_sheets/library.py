"""The laws of a book: name, family, entries, the engine's law; other parameters for them, which variations share."""

from collections.abc import Callable, Container, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import count
from typing import Any, TypeVar

from engine.laws import Law
from workbook.book.chart import in_scope
from workbook.entries.machine import Machine
from workbook.fields.paths import leaves
from workbook.laws.entries import Laws
from workbook.laws.family import Page
from workbook.laws.registry import CODES, FAMILY


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
        return self.page.make_law(self.entered)

    @property
    def words(self) -> str:
        """The law's name in words."""
        return str(getattr(self.entered, "name", self.page.law.name))

    @property
    def basic(self) -> bool:
        """Return whether every book has the law."""
        return self.name in CODES

    @property
    def slug(self) -> str:
        """Return the begin of the names of its cells: valid whatever the law is called."""
        return self.page.law.code if self.basic else f"{self.page.law.code}{self.number}"

    @property
    def key(self) -> str:
        """The place of its entries in what is read of a book."""
        return f"laws.{self.slug}"

    def own(self, text: str) -> str:
        """Return a name or a formula of its page as other sheets write it."""
        return in_scope(text, f"{self.slug}_")


def named_laws(given: Laws) -> list[NamedLaw]:
    """Return the laws of a book in the order of their numbers."""
    entries = {name: given[name] for name in given.names}
    return [
        NamedLaw(name, number, FAMILY[entry.family if entry else name].of(entry), entry, given.called(name))
        for number, (name, entry) in enumerate(entries.items(), 1)
    ]


def laws(given: Laws) -> dict[str, Law]:
    """Return the engine's laws by name, in the order of their numbers."""
    return {named_law.name: named_law.law for named_law in named_laws(given)}


M = TypeVar("M", bound=Machine)
SIX = 6  # variations of a template, unless its laws need more to have their turn
MOST = 300  # turns after which a law that has not come never will


def pick_in_turn(turn: int, names: Iterable[str]) -> str:
    """Return the name (of a law, say) whose turn it is: by their order, round and round."""
    known = list(names)
    return known[turn % len(known)]


def variations(
    machine: Machine,
    varied: Callable[[dict[str, Any], int], dict[str, Any]],
    suited: Callable[[dict[str, Any]], Iterable[str]] = list,
) -> list[dict[str, Any]]:
    """Return six variations of a machine's description, and of further turns those by which a law has its first turn.

    ``varied`` makes that of a turn, from 0; ``suited`` returns the laws that can come; LookupError names the rest.
    """
    descriptions: list[dict[str, Any]] = []
    names = set(suited(machine.laws.model_dump()))
    missing = set(names)
    for turn in range(MOST):
        description = varied(machine.model_dump(), turn)
        if turn < SIX or missing & laws_in(description, names):
            descriptions.append(description)
            missing -= laws_in(description, names)
        if turn + 1 >= SIX and not missing:
            return descriptions
    raise LookupError(f"no variation of {machine.template} ever has the law {', '.join(sorted(missing))}")


def varying(
    model: type[M],
    varied: Callable[[dict[str, Any], int], dict[str, Any]],
    suited: Callable[[dict[str, Any]], Iterable[str]] = list,
) -> Callable[[M], list[M]]:
    """Return a function from a machine to its :func:`variations`, as models of the same layout."""
    return lambda machine: [model.model_validate(data) for data in variations(machine, varied, suited)]


def laws_in(description: Any, names: Container[str]) -> set[str]:
    """Return the laws among ``names`` that the phases and tools of a description use."""
    texts = (value for path, value in leaves(description) if isinstance(value, str) and "laws" not in path)
    return {text for text in texts if text in names}


def vary_laws(laws: dict[str, Any], k: int, scale: Any, room: int) -> None:
    """Give every law other parameters: asymmetric, with zero stages, of several pieces."""
    for name, entry in laws.items():
        if page_of(name, entry).has_sheet:
            entry["lift"] *= -next(scale) if k % 2 else next(scale)
            entry["time"] *= next(scale)
    for i, (name, entry) in enumerate(laws.items()):
        entry.update(page_of(name, entry).variation(k if name in CODES else k + i, room))


def single_humped(laws: dict[str, Any]) -> list[str]:
    """Return the laws that speed up once, from rest to rest, whatever their parameters."""
    return [name for name, entry in laws.items() if page_of(name, entry).single]


def page_of(name: str, entry: dict[str, Any]) -> Page:
    """Return the page of a law in a description, which leaves out that of a basic law."""
    return FAMILY[entry.get("family", name)]


def passing(k: int, i: int, laws: dict[str, Any], size: float) -> dict[str, Any]:
    """Return velocity and acceleration at the begin of every third phase, in a book with straight lines."""
    if (i + k) % 3 != 1 or not any(entry.get("family", name) == "LIN" for name, entry in laws.items()):
        return {}
    sign = -1 if k % 2 else 1
    if i % 5:
        return {"velocity": sign * size * (1 + i % 3), "acceleration": size * (i % 4 - 1)}
    return {"velocity": size}


def own_in(laws: dict[str, Any]) -> list[str]:
    """Return the names of the own laws in a description's laws."""
    return [name for name, entry in laws.items() if entry.get("family", name) == "OWN"]


def factors(k: int) -> Iterator[float]:
    """Yield a factor near 1 for each number, no two alike."""
    return (1 + 0.013 * ((n * 7 + k * 5) % 23) + 0.0007 * n for n in count(1))


RISING = [{"duration": 0.4, "c0": 5.0}, {"duration": 0.6, "c0": -10 / 3}]
"""an own law that speeds up once, for less time than it slows down"""
