"""What an engineer enters for the place where two curved phases meet: y' and y'' there, 0 where nothing is entered."""

from collections.abc import Iterable
from typing import Any

from engine.motion.joining import Rates
from workbook.book.declare import Quantity, given


def passed(phases: Iterable[Any]) -> dict[int, Rates]:
    """Return what is entered, by the number of the phase that begins there, from 0."""
    return {k: Rates(one.velocity or 0.0, one.acceleration or 0.0) for k, one in enumerate(phases) if one.passes}


def entries(
    velocities: list[Any], accelerations: list[Any], key: str, units: tuple[str, str],
    symbols: tuple[str, str] = ("y'", "y''"),
) -> list[Quantity]:  # fmt: skip
    """Return the columns in which it is entered; ``key`` is that of the rows in the description."""
    return [
        given("velocity", "velocity at its start", symbols[0], units[0], velocities, f"{key}.velocity",
              format="0.0####", source="between two curved phases; empty: 0"),
        given("acceleration", "and with", symbols[1], units[1], accelerations, f"{key}.acceleration",
              format="0.0####", source="between two curved phases; empty: 0"),
    ]  # fmt: skip
