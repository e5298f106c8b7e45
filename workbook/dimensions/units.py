"""Units as engineers write them, as dimensions: ``kg cm²``, ``W/m²K⁴``, ``Nm``, ``1/min``, ``°``."""

import re
from functools import cache
from typing import Any, TypeAlias

from pint import UndefinedUnitError, UnitRegistry
from pint.util import UnitsContainer

Dimension: TypeAlias = UnitsContainer
NONE = Dimension({})  # of numbers, angles, shares and counts
POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")
FACTOR = re.compile(r"(?P<word>1|[^\W\d_]+|°[CF]?|%|‰|Ω)(?:\^|\*\*)?(?P<power>-?\d+)?")
BETWEEN = re.compile(r"(?! - )[ ·*.×-]*")
# what pint does not know, or reads as something else
WORDS = {"1": "", "%": "", "‰": "", "°": "", "cycles": "", "pieces": "", "rpm": "1/min", "C": "K", "°C": "K", "°F": "K",
    "Ω": "ohm", "µm": "m", "μm": "m", "Nm": "N m", "kNm": "N m", "mNm": "N m", "Ncm": "N m", "Nmm": "N m",
    "Nms": "N m s", "Ws": "J", "Vs": "V s", "As": "A s"}  # fmt: skip
BASE = {"[mass]": "kg", "[length]": "m", "[time]": "s", "[current]": "A", "[temperature]": "K", "[substance]": "mol",
        "[luminosity]": "cd"}  # fmt: skip
registry = cache(UnitRegistry[Any])  # what gives the units that pint knows


@cache
def dimension_of(unit: str) -> Dimension | None:
    """Return the dimension of a unit, the first ``/`` before all that divides; None where it is not known."""
    found = NONE
    for k, part in enumerate(unit.strip(" []()").split("/")):
        text, at = part.translate(POWERS).strip(), 0
        while at < len(text):
            match = FACTOR.match(text, at)
            if match is None or (one := word_dimension(match["word"])) is None:
                return None
            found *= one ** (int(match["power"] or 1) * (-1 if k else 1))
            between = BETWEEN.match(text, match.end())
            at = between.end() if between else match.end()
    return found if unit.strip(" []()") else None


def is_either(unit: str) -> bool:
    """Whether a unit is one or another, such as ``mm, °`` or ``kg or price``."""
    return ", " in unit or " or " in unit


@cache
def word_dimension(word: str) -> Dimension | None:
    """Return the dimension of one unit; None where pint knows none of that name."""
    if word in WORDS:
        return dimension_of(WORDS[word]) if WORDS[word] else NONE
    for name in (word, word.lower()) if len(word) > 2 else (word,):
        try:
            return registry().Unit(name).dimensionality
        except (UndefinedUnitError, ValueError, AttributeError):
            continue
    return None


def powers(dimension: Dimension) -> dict[str, float]:
    """Return the powers of the base quantities in a dimension."""
    found: dict[str, Any] = dict(dimension)
    return {name: float(power) for name, power in found.items()}


@cache
def dimension_text(dimension: Dimension) -> str:
    """Return a dimension as a product of SI units, such as ``kg·m^2/s^3``."""
    there = [(unit, powers(dimension).get(name, 0.0)) for name, unit in BASE.items()]
    above, below = ("·".join(unit + (f"^{sign * power:g}" if sign * power != 1 else "")
                             for unit, power in there if sign * power > 0) for sign in (1, -1))  # fmt: skip
    return f"{above or 1}/{below}" if below else above or "a number"
