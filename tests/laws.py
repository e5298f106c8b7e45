"""Random parameters of any registered law, for machines that no engineer would build."""

from collections.abc import Callable
from typing import Any

from engine.laws.points import CHAINS, extreme
from engine.laws.sections import velocity_peak
from workbook.laws.pages.pieces import OwnLaw, spread_of
from workbook.laws.registry import CODES, FAMILY, RISING

MOVING = RISING
PAGED = tuple(code for code in CODES if FAMILY[code].page.has_sheet)


def blended(code: str, dice: Any) -> dict[str, Any]:
    """Return parameters between two variations of a law's page, or one of the two; none of a law without."""
    found = FAMILY[code].page.variations
    if not found or code == "OWN":
        return {}
    one, other = dice.sample(found, 2)
    share = dice.choice((0.0, dice.random()))
    return {name: between(one[name], other[name], share) for name in one}


def between(one: Any, other: Any, share: float) -> Any:
    """Return a number between two, or a list of such; of two words one."""
    if isinstance(one, str):
        return one if share < 0.5 else other
    if isinstance(one, list):
        return [between(a, b, share) for a, b in zip(one, other, strict=True)]
    return (1.0 - share) * one + share * other


def told(drawn: Callable[[], list[dict[str, Any]]]) -> list[dict[str, Any]]:
    """Draw the pieces of an own law until its points, at their fewest, find its extremes.

    A few of a thousand random laws have extremes that the cells miss and the engine does not (docs/limits.md).
    """
    while not all_found(pieces := drawn()):
        pass
    return pieces


def all_found(pieces: list[dict[str, Any]]) -> bool:
    """Whether the points on the pieces find all extremes that the engine finds."""
    law = OwnLaw.model_validate({"pieces": pieces}).exact
    at = spread_of(law, len(pieces), 0)
    most, least = ({what: extreme(at.tops(what), side).value for what in CHAINS} for side in (1, -1))
    exact = law.coefficients
    pairs = [
        (max(most["v"], -least["v"]), exact.cv),
        (most["v"], float(law.v(velocity_peak(law)))),
        (most["a"], exact.ca_max),
        (least["a"], exact.ca_min),
        (most["va"], exact.va_max),
        (least["va"], exact.va_min),
    ]
    return all(abs(found - true) <= 1e-8 * max(1.0, abs(true)) for found, true in pairs)
