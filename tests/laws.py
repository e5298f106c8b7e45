"""Random parameters of any registered law, for machines that no engineer would build."""

from typing import Any

from workbook.laws.registry import CODES, FAMILY, RISING

MOVING = RISING
PAGED = tuple(code for code in CODES if FAMILY[code].has_sheet)


def blended(code: str, dice: Any) -> dict[str, Any]:
    """Return parameters between two variations of a law's page, or one of the two; none of a law without."""
    found = FAMILY[code].variations
    if not found or code in ("OWN", "SPL"):  # whose pieces and points make no others between two of them
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
