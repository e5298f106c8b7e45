"""Units as engineers write them, as dimensions: ``kg cm²``, ``W/m²K⁴``, ``Nm``, ``1/min``, ``°``."""

import re
from functools import cache
from tokenize import TokenError
from typing import Any, TypeAlias

from pint import UnitRegistry
from pint.errors import PintError
from pint.util import UnitsContainer

Dimension: TypeAlias = UnitsContainer
NONE = Dimension({})  # of numbers, angles, shares and counts
POWERS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")
FACTOR = re.compile(r"(?P<word>1(?!\d)|[^\W\d_]+|°[CF]?|%|‰|Ω)(?:\^|\*\*)?(?P<power>-?\d+)?")
BETWEEN = re.compile(r"(?! - )[ ·*.×-]*")
MOST_POWER = 12
# what pint does not know, or reads as something else
WORDS = {"1": "1", "%": "0.01", "‰": "0.001", "°": "degree", "cycles": "1", "pieces": "1", "rpm": "1/min", "C": "K",
    "°C": "K", "°F": "K", "Ω": "ohm", "µm": "1e-6 m", "μm": "1e-6 m", "Nm": "N*m", "kNm": "kN*m", "mNm": "mN*m",
    "Ncm": "N*cm", "Nmm": "N*mm", "Nms": "N*m*s", "Ws": "J", "Vs": "V*s", "As": "A*s", "g": "gram",
    "h": "hour"}  # fmt: skip
BASE = {"[mass]": "kg", "[length]": "m", "[time]": "s", "[current]": "A", "[temperature]": "K", "[substance]": "mol",
        "[luminosity]": "cd"}  # fmt: skip
registry = cache(UnitRegistry[Any])  # what gives the units that pint knows


def dimension_of(unit: str) -> Dimension | None:
    """Return the dimension of a unit, the first ``/`` before all that divides; None where it is not known."""
    quantity = parse_unit(unit)
    return None if quantity is None else quantity.dimensionality


def size_of(unit: str) -> tuple[Dimension, float] | None:
    """Return the dimension of a unit and its size in SI; None where it is not known."""
    size = parse_unit(unit)
    return None if size is None else (size.dimensionality, float(f"{size.magnitude:.12g}"))


@cache
def parse_unit(unit: str) -> Any:
    """Return a unit as pint's quantity in base units, the first ``/`` before all that divides; None if not known."""
    quantity = registry().Quantity(1.0)
    for k, part in enumerate(unit.strip(" []()").split("/")):
        text, at = part.translate(POWERS).strip(), 0
        while at < len(text):
            match = FACTOR.match(text, at)
            if match is None or (factor := parse_word(match["word"])) is None:
                return None
            power = int(match["power"] or 1)
            if abs(power) > MOST_POWER:
                return None
            quantity *= factor ** (-power if k else power)
            between = BETWEEN.match(text, match.end())
            at = between.end() if between else match.end()
    return quantity if unit.strip(" []()") else None


def is_either(unit: str) -> bool:
    """Whether a unit is this or another, such as ``mm, °`` or ``kg or price``."""
    return ", " in unit or " or " in unit


@cache
def parse_word(word: str) -> Any:
    """Return a unit as pint's quantity in base units; None where pint knows none of that name."""
    names = (word, word.lower()) if len(word) > 2 else (word,)
    for name in () if word.startswith("dB") else names:  # pint has a deci-biot
        try:
            return registry().Quantity(WORDS.get(name, f"1 {name}")).to_base_units()
        except (PintError, ValueError, AttributeError, TokenError):
            continue
    return None


def powers(dimension: Dimension) -> dict[str, float]:
    """Return the powers of the base quantities in a dimension."""
    exponents: dict[str, Any] = dict(dimension)
    return {name: float(power) for name, power in exponents.items()}


@cache
def dimension_text(dimension: Dimension) -> str:
    """Return a dimension as a product of SI units, such as ``kg·m^2/s^3``."""
    there = [(unit, powers(dimension).get(name, 0.0)) for name, unit in BASE.items()]
    above, below = (
        "·".join(
            unit + (f"^{sign * power:g}" if sign * power != 1 else "") for unit, power in there if sign * power > 0
        )
        for sign in (1, -1)
    )
    return f"{above or 1}/{below}" if below else above or "a number"
