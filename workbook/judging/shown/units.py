"""Units as people write them: the same one, another, or the same in other words."""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import NamedTuple

SYMBOLS = {
    "m": (1.0, "m"), "g": (1e-3, "kg"), "s": (1.0, "s"), "sec": (1.0, "s"), "min": (60.0, "s"), "h": (3600.0, "s"),
    "rad": (1.0, "rad"), "rev": (math.tau, "rad"), "°": (math.pi / 180, "rad"), "deg": (math.pi / 180, "rad"),
    "1": (1.0, ""), "N": (1.0, "kg m s-2"), "W": (1.0, "kg m2 s-3"), "J": (1.0, "kg m2 s-2"), "Pa": (1.0, "kg m-1 s-2"),
    "bar": (1e5, "kg m-1 s-2"), "Hz": (1.0, "s-1"), "rpm": (math.tau / 60, "rad s-1"), "%": (0.01, ""), "‰": (1e-3, ""),
    "°C": (1.0, "K"), "K": (1.0, "kelvin"), "°F": (1.0, "F"), "V": (1.0, "V"), "A": (1.0, "A"), "t": (1e3, "kg"),
    "in": (0.0254, "m"), "inch": (0.0254, "m"), "inches": (0.0254, "m"), "ft": (0.3048, "m"), "mil": (2.54e-5, "m"),
    "lb": (0.45359237, "kg"), "lbf": (4.4482216, "kg m s-2"), "oz": (0.0283495, "kg"), "hp": (745.7, "kg m2 s-3"),
    "kp": (9.80665, "kg m s-2"), "kgf": (9.80665, "kg m s-2"), "PS": (735.49875, "kg m2 s-3"), "l": (1e-3, "m3"),
}  # fmt: skip
"""Each with its size in SI, and its dimension."""
PREFIXES = {"": 1.0, "k": 1e3, "M": 1e6, "G": 1e9, "d": 0.1, "c": 1e-2, "m": 1e-3, "µ": 1e-6, "μ": 1e-6, "n": 1e-9}
PLAIN = frozenset(
    {"1", "%", "‰", "°", "°C", "°F", "rpm", "min", "h", "deg", "rev", "in", "inch", "inches", "ft", "mil"}
)
"""that take no prefix"""
ALIASES = dict.fromkeys((
    "1/min", "min⁻¹", "min-1", "min^-1", "/min", "u/min", "upm", "umdr./min", "r/min", "rev/min", "rpm", "r.p.m.",
    "giri/min", "tr/min", "tr/mn", "cpm", "c/min", "cycles/min", "cycles per minute", "revolutions per minute",
), "rpm") | {"kgm²": "kg m²", "kgm2": "kg m²", "kgcm²": "kg cm²", "kgcm2": "kg cm²"}  # fmt: skip
"""turns and cycles a minute in all spellings: which of them is meant, the label says"""
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
FACTOR = re.compile(r"([^\W\d_]+|°[CF]?|%|‰|1(?![0-9]))\^?(-?[0-9])?")
POWER = re.compile(r"([A-Za-z]+)(-?[0-9])?")


class Unit(NamedTuple):
    """A unit taken apart: its size in SI, its dimension, and the words in it that are none of these."""

    size: float
    dimension: tuple[tuple[str, int], ...]
    words: tuple[str, ...]


@lru_cache(maxsize=4_000)
def unit(text: str) -> Unit:
    """Take a unit apart; what is no symbol of one counts as a word, such as ``pieces``."""
    plain = ALIASES.get(text.strip().lower(), text.strip()).translate(RAISED)
    size, powers, words, sign = 1.0, dict[str, int](), list[str](), 1
    for part in re.split(r"([/\s·*.()]+)", plain):
        if not part.strip(" ·*.()"):
            continue
        if "/" in part:
            sign = -1
            continue
        found = FACTOR.findall(part) if FACTOR.sub("", part) == "" else []
        if not found:
            words.append(part.casefold())
        for name, power in found:
            times = sign * int(power or 1)
            known = symbol(name)
            if known is None:
                words.append(name.casefold())
                continue
            size *= known[0] ** times
            for base, exponent in POWER.findall(known[1]):
                powers[base] = powers.get(base, 0) + times * int(exponent or 1)
    return Unit(size, tuple(sorted((b, p) for b, p in powers.items() if p)), tuple(sorted(words)))


def is_unit(text: str) -> bool:
    """Whether a text reads as a unit, and as nothing else."""
    return bool(text.strip()) and not unit(text).words


def symbol(name: str) -> tuple[float, str] | None:
    """Return size and dimension of a symbol, or of two that are joined, such as Nm; None for what is none."""
    if (known := simple(name)) is not None:
        return known
    joined = ((simple(name[:cut]), simple(name[cut:])) for cut in range(1, len(name)))
    return next(((one[0] * other[0], f"{one[1]} {other[1]}") for one, other in joined if one and other), None)


def simple(name: str) -> tuple[float, str] | None:
    """Return size and dimension of one symbol, with its prefix."""
    if name in SYMBOLS:
        return SYMBOLS[name]
    first, rest = name[:1], name[1:]
    known = SYMBOLS.get(rest) if first in PREFIXES and rest not in PLAIN else None
    return (PREFIXES[first] * known[0], known[1]) if known else None


def compared(held: str, declared: str) -> str:
    """Return how a unit stands to the declared one: ``same``, ``reworded``, or ``other``."""
    if held.split() == declared.split():
        return "same"
    if not held.strip():
        return "reworded"
    one, two = unit(held), unit(declared)
    alike = one.dimension == two.dimension and math.isclose(one.size, two.size, rel_tol=1e-6)
    if alike and one.words == two.words:
        return "same"
    return "reworded" if alike and one.words and two.words else "other"
