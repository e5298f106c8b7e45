"""The functions as names of Excel: LAMBDA formulas of ``formulas.txt``, as Excel shows them and as a file stores them.

What differs from law to law is built from the add-in's table, ``laws.md``. A file marks what Excel 2007 did not know:
functions by ``_xlfn.``, parameters and variables by ``_xlpm.``, optional ones, shown as ``[name]``, by ``_xlop.``
(Microsoft, [MS-XLSX] 2.2.2, 'Formulas': future-function-list and _xlpm).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import cache
from math import lcm
from pathlib import Path
from typing import NamedTuple

from workbook.book.formula import words
from workbook.functions.addin.motion_functions.library import LAWS, OWN, LawForm, mirror_half
from workbook.functions.declarations import FUNCTIONS

SOURCE = Path(__file__).with_name("formulas.txt")
LATER = "DROP HSTACK ISOMITTED LAMBDA LET MAKEARRAY MAP REDUCE SCAN SEQUENCE TAKE TOCOL VSTACK".split()
FUTURE = {name: f"_xlfn.{name}" for name in LATER} | {"FILTER": "_xlfn._xlws.FILTER"}
HEADING = re.compile(r"(?P<name>[\w.]+)(?:: (?P<note>.*))?\n=(?P<formula>.*)", re.DOTALL)
PREFIX = re.compile(r"_xl(?:fn|ws|pm|op)\.")
NUMBERS = 14  # of a piece: its duration, six powers, two sines, and the velocity with which the first begins
LARGEST = 1000  # denominator of a number of a law


class Definition(NamedTuple):
    """A name of the workbook: what it is for, and its formula without ``=``, in Excel's own spelling."""

    name: str
    note: str
    formula: str

    @property
    def stored(self) -> str:
        """The formula as a file stores it."""
        parts = []
        for kind, part in words(self.formula):
            variable = kind == "name" and part not in ("TRUE", "FALSE")
            name = part.removesuffix("(") if kind == "function" else ""
            marked = f"_xlpm.{part}" if variable else part
            parts.append(part.replace(name, FUTURE.get(name, name)) if name else marked)
        return "".join(parts).replace("[_xlpm.", "[_xlop.").replace("[", "").replace("]", "")


@cache
def definitions() -> tuple[Definition, ...]:
    """Return every name: the functions in the order of their declaration, then the helpers they call."""
    helps = {function.name: function.help.en for function in FUNCTIONS}
    by_name = {}
    text = SOURCE.read_text(encoding="utf-8")
    for name, formula in tables().items():
        text = text.replace(f"«{name}»", formula)
    for block in text.split("\n\n"):
        lines = block.strip()
        if lines.startswith("//"):
            continue
        heading = HEADING.fullmatch(lines)
        if heading is None:
            raise ValueError(f"{SOURCE.name}: no name and formula: {lines[:60]!r}")
        name = heading["name"]
        by_name[name] = Definition(name, heading["note"] or helps[name], heading["formula"])
    order = [*helps, *(name for name in by_name if name not in helps)]
    return tuple(by_name[name] for name in order)


def meaning(stored: str) -> list[tuple[str, object]]:
    """Return the words of a stored formula, without what programs write in their own way."""
    parts = words(PREFIX.sub("", stored.removeprefix("=")))
    return [(kind, float(part) if kind == "number" else part.upper()) for kind, part in parts]


def array(values: Sequence[float]) -> str:
    """Return a number, or several as an array, as whole ones over what they have in common."""
    ratios = [Fraction(value).limit_denominator(LARGEST) for value in values]
    common = lcm(*(ratio.denominator for ratio in ratios))
    whole = ",".join(str(ratio * common) for ratio in ratios)
    text = f"{{{whole}}}" if len(ratios) > 1 else whole
    return text if common == 1 else f"{text} / {common}"


def with_parameters(law: LawForm, formula: str) -> str:
    """Return a formula of a law's parameters where the column ``p`` holds them."""
    let = ", ".join(f"{name}, INDEX(p, {k})" for k, name in enumerate(law.parameters, 1))
    return f"LET({let}, {formula})" if let else formula


def polynomial_formula(law: LawForm) -> str:
    """Return the pieces of a symmetric polynomial: its half over the share, and the same backwards over the rest."""
    first = [2 * Fraction(c) for c in law.half]

    def half(share: str, c: Sequence[Fraction]) -> str:
        powers = [f"{str(value).replace('/', ' / ')} / {share} ^ {i}" if value else "0" for i, value in enumerate(c, 1)]
        return f"HSTACK({', '.join([share, *powers, *'0' * (NUMBERS - 1 - len(c))])})"

    return (
        f"LET(share, INDEX(p, 1), rest, 1 - share, VSTACK({half('share', first)}, {half('rest', mirror_half(first))}))"
    )


def domain_condition(law: LawForm) -> str:
    """Return the condition under which a law can have the parameters ``p``."""
    conditions = ["_MOTION.LASTS(_MOTION.SEVEN(code, p))"] if law.staged else []
    for condition in law.possible:
        for k, name in enumerate(law.parameters, 1):
            condition = re.sub(rf"\b{name}\b", f"INDEX(p, {k})", condition)
        conditions.append(condition)
    return f"AND({', '.join(conditions)})" if len(conditions) > 1 else "".join(conditions) or "TRUE"


def by_law(text: Callable[[LawForm], str], otherwise: str, **more: str) -> str:
    """Return a formula that chooses by ``code``; laws of the same text together, those of none left out."""
    codes_of: dict[str, list[str]] = {}
    for code, formula in more.items():
        codes_of.setdefault(formula, []).append(f'code = "{code}"')
    for code, law in LAWS.items():
        codes_of.setdefault(text(law), []).append(f'code = "{code}"')
    codes_of.pop("", None)
    for formula, codes in reversed(codes_of.items()):
        among = codes[0] if len(codes) == 1 else f"OR({', '.join(codes)})"
        otherwise = f"IF({among}, {formula},\n    {otherwise})"
    return otherwise


def tables() -> dict[str, str]:
    """Return the names of ``formulas.txt``: of each law its parameters, pieces, stages, and its ends' derivatives."""
    stages = "_MOTION.STAGES(_MOTION.SEVEN(code, p), {})"

    def built(law: LawForm) -> str:
        if law.staged:
            return stages.format(str(law.form == "straight").upper())
        return polynomial_formula(law) if law.half else with_parameters(law, f"VSTACK(HSTACK({law.formula}))")

    def seven(law: LawForm) -> str:
        return with_parameters(law, f"VSTACK({law.formula})") if law.formula else "p"

    def meets(law: LawForm) -> str:
        unstaged = "1" if law.staged else "0"
        return f"IF(INDEX(p, 1) = 1 / 2, {len(law.half) // 2}, 0)" if law.half else unstaged

    return {
        "delivered": by_law(lambda law: array(law.delivered) if law.delivered else "", "0", OWN=array(OWN[0])),
        "count": by_law(lambda law: str(len(law.delivered)), "#VALUE!"),
        "fits": by_law(domain_condition, "FALSE"),
        "built": by_law(built, "#VALUE!", OWN="_MOTION.FULL(p)"),
        "seven": by_law(lambda law: seven(law) if law.staged else "", "#VALUE!"),
        "meets": by_law(meets, "0"),
    }
