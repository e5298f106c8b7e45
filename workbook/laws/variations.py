"""What templates' variations share: other parameters for every law, asymmetric, with zero stages, of several pieces."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from workbook.entries.machine import Machine
from workbook.laws.registry import FAMILIES, FAMILY, RISING

SIX = 6
"""variations of a template, unless its laws need more to have their turn"""
MOST = 120
"""turns after which a law that has not come never will"""


def law_for(turn: int, without: str = "") -> str:
    """Return the law that moves whose turn it is: one after the other, round and round; ``without`` a law, if any."""
    codes = [code for code in RISING if code != without]
    return codes[turn % len(codes)]


def variations(machine: Machine, varied: Callable[[dict[str, Any], int], dict[str, Any]]) -> list[dict[str, Any]]:
    """Return six variations of a machine's description, and of further turns those by which a law has its first turn.

    ``varied(description, turn)`` makes the one of a turn, counted from 0, with laws by :func:`law_for`.
    Raises LookupError, with the laws that never come.
    """
    made: list[dict[str, Any]] = []
    missing = set(RISING)
    for turn in range(MOST):
        description = varied(machine.model_dump(), turn)
        if turn < SIX or missing & laws_in(description):
            made.append(description)
            missing -= laws_in(description)
        if turn + 1 >= SIX and not missing:
            return made
    raise LookupError(f"no variation of {machine.template} ever has the law {', '.join(sorted(missing))}")


def laws_in(description: Any) -> set[str]:
    """Return the codes of the laws that a description's phases and tools name."""
    if isinstance(description, dict):
        return set().union(*(laws_in(value) for name, value in description.items() if name != "laws"))
    if isinstance(description, list):
        return set().union(*(laws_in(value) for value in description))
    return {description} if isinstance(description, str) and description in RISING else set()


def vary_laws(laws: dict[str, Any], k: int, scale: Any, room: int) -> None:
    """Give every law other parameters: asymmetric, with zero stages, of several pieces."""
    for family in FAMILIES:
        if family.page.has_sheet:
            entry = laws[family.code]
            entry["lift"] *= -next(scale) if k % 2 else next(scale)
            entry["time"] *= next(scale)
    for family in FAMILIES:
        if family.page.entries:
            laws[family.code].update(family.page.variation(k, room))


def factors(k: int) -> Any:
    """Yield a factor near 1 for each number, no two alike."""
    n = 0
    while True:
        n += 1
        yield 1 + 0.013 * ((n * 7 + k * 5) % 23) + 0.0007 * n


def own_pieces(k: int, room: int) -> list[dict[str, Any]]:
    """Return pieces of an own law; with little room, the one of a single piece."""
    return list(FAMILY["OWN"].page.variation(k, room)["pieces"])
