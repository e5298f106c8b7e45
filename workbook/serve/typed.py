"""Entries as people type them: ``112,5``, ``112.5 °``, ``25000 g``, ``20+5`` into the unit of an entry, or refused."""

import math
import re
from typing import Any

import tomlkit

from workbook.description.keys import Key
from workbook.errors import InputError, visible

FIGURE = r"(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d{1,3})?"
PLAIN = re.compile(rf"[-+]?{FIGURE}")
SUM = re.compile(rf"[-+]?\s*{FIGURE}(?:\s*[-+*/]\s*{FIGURE})*")
WITH_UNIT = re.compile(r"([^a-zA-Z°µ%/²³]*?(?:\d[eE][-+]?\d+)?)\s*((?:[a-zA-Z°µ%]|1/).*)")
OF_PINT = (
    "cycles/min=rpm|cycle/min=rpm|rev/min=rpm|1/min=rpm|min-1=rpm|Nm=N m|kNm=kN m|Ncm=N cm|mNm=mN m|kgcm²=kg cm²|"
    "kgm²=kg m²|gcm²=g cm²|%=percent|1/h=1/hour|kWh=kW hour"
)
SPELLED = dict(pair.split("=") for pair in OF_PINT.split("|"))
LONGEST = 60  # characters of a number


def number(text: str, unit: str, expected: str) -> float:
    """Return the number that a text says, in the unit of its entry; raise InputError where it says none."""
    words = text.strip().replace("−", "-").replace("\u00a0", " ")
    if "," in words and "." in words:
        raise InputError([f"“{visible(text)}” has a comma and a point; expected one of them, as the decimal sign"])
    words = words.replace(",", ".")
    if len(words) <= LONGEST:
        if PLAIN.fullmatch(words):
            return finite(float(words), text)
        if SUM.fullmatch(words):
            return finite(worked_out(words, text), text)
        if match := WITH_UNIT.fullmatch(words):
            return finite(in_unit_of_entry(match[1].strip(), match[2].strip(), unit, text), text)
    raise InputError([f"{expected} is expected; “{visible(text[:LONGEST])}” is none"])


def finite(value: float, text: str) -> float:
    """Return a number to the digits that typing and conversion give it; raise InputError for an infinite one."""
    if not math.isfinite(value):
        raise InputError([f"“{visible(text)}” is too large a number"])
    return float(f"{value:.12g}")


def worked_out(words: str, text: str) -> float:
    """Return the number of a sum of products."""
    from workbook.dimensions.units import registry  # takes its time to load: only who types a sum or a unit needs it

    try:
        return float(registry().parse_expression(words))
    except Exception:  # pint has an error of its own for each fault
        raise InputError([f"“{visible(text)}” cannot be worked out; expected a number, or a sum as 20+5"]) from None


def in_unit_of_entry(figure: str, given: str, unit: str, text: str) -> float:
    """Return a number with a unit in the unit of its entry."""
    value = number(figure, "", "a number")
    if pint_spelling(given) == pint_spelling(unit):
        return value
    wanted = f"in {unit}" if unit else "without a unit"
    from workbook.dimensions.units import registry

    try:
        return float(
            registry().Quantity(value, pint_spelling(given)).to(pint_spelling(unit) or "dimensionless").magnitude
        )
    except Exception:  # pint has an error of its own for each of: unknown, ambiguous, of another kind
        raise InputError([f"“{visible(text)}”: {visible(given)} is no unit here; expected a number {wanted}"]) from None


def pint_spelling(unit: str) -> str:
    """Return a unit as pint spells it."""
    unit = SPELLED.get(unit, unit)
    return unit.replace("²", "**2").replace("³", "**3").replace("°C", "degC").replace("°", "degree").replace(" ", " * ")


def value_of(key: Key, unit: str, text: str) -> Any:
    """Return the text of a field in the type of its entry, None of an empty one; raise InputError for none."""
    words = text.strip()
    if not words:
        return None
    if key.expected.startswith("a number") or key.expected.startswith("a whole number"):
        value = number(words, unit, key.expected)
        if key.expected.startswith("a number"):
            return value
        if value != round(value):
            raise InputError([f"{key.expected} is expected; “{visible(words)}” is none"])
        return int(value)
    if key.expected == "true or false":
        if words.lower() not in ("true", "false"):
            raise InputError([f"true or false is expected; “{visible(words)}” is neither"])
        return words.lower() == "true"
    if words.startswith("["):
        try:
            return tomlkit.value(words).unwrap()
        except ValueError:
            raise InputError([f"{key.expected} is expected; “{visible(words[:LONGEST])}” is no list"]) from None
    return words
