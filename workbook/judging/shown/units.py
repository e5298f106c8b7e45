"""Units as people write them: the same one in another spelling, in other words, or another."""

import re
from collections import Counter
from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

PREFIXED = frozenset(["m", "g", "s", "N", "W", "J", "Pa", "Hz", "V", "A", "bar", "l", "rad", "K", "sec"])
"""symbols that may have a prefix before them"""
PREFIXES = frozenset(["", "k", "M", "G", "d", "c", "m", "µ", "μ", "n"])
OTHERS = frozenset([
    "min", "h", "rev", "°", "deg", "rpm", "%", "‰", "°C", "°F", "t", "in", "inch", "inches", "ft", "mil", "lb",
    "lbf", "oz", "hp", "kp", "kgf", "PS",
])  # fmt: skip
TURNS = dict.fromkeys((
    "1/min", "min⁻¹", "min-1", "min^-1", "/min", "u/min", "upm", "umdr./min", "r/min", "rev/min", "rpm", "r.p.m.",
    "giri/min", "tr/min", "tr/mn", "cpm", "c/min", "cycles/min", "cycles per minute", "revolutions per minute",
    "takte/min", "hübe/min", "cicli/min", "coups/min",
), "rpm")  # fmt: skip
"""turns and cycles a minute in all spellings: which of them is meant, the label says"""
SPELT = {"sec": "s", "deg": "°", "μm": "µm", "Pa": "N/m²", "MPa": "N/mm²", "Hz": "1/s", "W": "J/s", "l": "dm³"}
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
FACTOR = re.compile(r"([^\W\d_]+|°[CF]?|%|‰|1(?![0-9]))\^?(-?[0-9])?")


class Unit(NamedTuple):
    """A unit taken apart: its symbols with their powers, and the words in it that are none of these."""

    powers: dict[str, int]
    words: tuple[str, ...]


@lru_cache(maxsize=4_000)
def unit(text: str) -> Unit:
    """Take a unit apart; what is no symbol of one counts as a word, such as ``pieces``."""
    plain = text.strip()
    plain = TURNS.get(plain.lower(), SPELT.get(plain, plain)).translate(RAISED)
    powers, words, sign = Counter[str](), list[str](), 1
    for part in re.split(r"([/\s·*.()]+)", plain):
        if "/" in part:
            sign = -1
        elif part.strip(" ·*.()"):
            found = FACTOR.findall(part) if FACTOR.sub("", part) == "" else []
            words += [] if found else [part.casefold()]
            for name, power in found:
                *first, last = symbols(name) or ("",)
                words += [] if last else [name.casefold()]
                powers.update(dict.fromkeys(first, sign))
                powers[SPELT.get(last, last)] += sign * int(power or 1)
    return Unit(
        {name: power for name, power in powers.items() if power and name not in ("", "1")}, tuple(sorted(words))
    )


def symbols(text: str) -> tuple[str, ...]:
    """Return the symbol that a text is, or the two that it joins, such as Nm; nothing where it is none."""

    def known(part: str) -> bool:
        prefixed = any(part.endswith(name) and part.removesuffix(name) in PREFIXES for name in PREFIXED)
        return part == "1" or part in OTHERS or prefixed

    joined: Iterator[tuple[str, ...]] = ((text[:cut], text[cut:]) for cut in range(1, len(text)))
    return next((found for found in ((text,), *joined) if all(map(known, found))), ())


def is_unit(text: str) -> bool:
    """Whether a text reads as a unit, and as nothing else."""
    return bool(text.strip()) and not unit(text).words


def compared(held: str, declared: str) -> str:
    """Return how a unit stands to the declared one: ``same``, ``reworded``, or ``other``."""
    if held.split() == declared.split():
        return "same"
    one, two = unit(held), unit(declared)
    if not held.strip() or (one.powers == two.powers and one.words and two.words and one.words != two.words):
        return "reworded"
    return "same" if one == two else "other"
