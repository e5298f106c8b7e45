"""What templates' variations share: other parameters for every law, asymmetric, with zero stages, of several pieces."""

from collections.abc import Callable, Container, Iterable, Iterator
from itertools import count
from typing import Any, TypeVar

from workbook.entries.machine import Machine
from workbook.laws.family import Page
from workbook.laws.registry import CODES, FAMILY

M = TypeVar("M", bound=Machine)
SIX = 6  # variations of a template, unless its laws need more to have their turn
MOST = 300  # turns after which a law that has not come never will


def law_for(turn: int, names: Iterable[str]) -> str:
    """Return the law whose turn it is: one after the other, round and round."""
    known = list(names)
    return known[turn % len(known)]


def variations(
    machine: Machine, varied: Callable[[dict[str, Any], int], dict[str, Any]],
    suited: Callable[[dict[str, Any]], Iterable[str]] = list,
) -> list[dict[str, Any]]:  # fmt: skip
    """Return six variations of a machine's description, and of further turns those by which a law has its first turn.

    ``varied(description, turn)`` makes the one of a turn, counted from 0, with laws by :func:`law_for`; ``suited``
    tells which laws of a description the machine can have. Raises LookupError, with those that never come.
    """
    made: list[dict[str, Any]] = []
    names = set(suited(machine.laws.model_dump()))
    missing = set(names)
    for turn in range(MOST):
        description = varied(machine.model_dump(), turn)
        if turn < SIX or missing & laws_in(description, names):
            made.append(description)
            missing -= laws_in(description, names)
        if turn + 1 >= SIX and not missing:
            return made
    raise LookupError(f"no variation of {machine.template} ever has the law {', '.join(sorted(missing))}")


def varying(
    model: type[M], varied: Callable[[dict[str, Any], int], dict[str, Any]],
    suited: Callable[[dict[str, Any]], Iterable[str]] = list,
) -> Callable[[M], list[M]]:  # fmt: skip
    """Return what gives machines of the same layout as one: its :func:`variations`, as the model has them."""
    return lambda machine: [model.model_validate(data) for data in variations(machine, varied, suited)]


def laws_in(description: Any, names: Container[str]) -> set[str]:
    """Return those of the laws ``names`` that a description's phases and tools name."""
    if isinstance(description, dict):
        return set().union(*(laws_in(value, names) for name, value in description.items() if name != "laws"))
    if isinstance(description, list):
        return set().union(*(laws_in(value, names) for value in description))
    return {description} if isinstance(description, str) and description in names else set()


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
    """Return what the ``i``-th phase passes its begin with, of some, in a book with straight lines."""
    if (i + k) % 3 != 1 or not any(entry.get("family", name) == "LIN" for name, entry in laws.items()):
        return {}
    sign = -1 if k % 2 else 1
    return {"velocity": sign * size * (1 + i % 3), "acceleration": size * (i % 4 - 1)} if i % 5 else {"velocity": size}


def own_in(laws: dict[str, Any]) -> list[str]:
    """Return the names of the own laws in a description's laws."""
    return [name for name, entry in laws.items() if entry.get("family", name) == "OWN"]


def factors(k: int) -> Iterator[float]:
    """Yield a factor near 1 for each number, no two alike."""
    return (1 + 0.013 * ((n * 7 + k * 5) % 23) + 0.0007 * n for n in count(1))


RISING = [{"duration": 0.4, "c0": 5.0}, {"duration": 0.6, "c0": -10 / 3}]
"""an own law that speeds up once, for less time than it slows down"""
