"""The functions as names of Excel: LAMBDA formulas of ``formulas.txt``, as Excel shows them and as a file stores them.

What differs from law to law stands in ``functions.toml``, its numbers in the add-in's table of laws. A file marks what
Excel 2007 did not know: functions by ``_xlfn.``, parameters and variables by ``_xlpm.``, optional ones, shown as
``[name]``, by ``_xlop.`` (Microsoft, [MS-XLSX] 2.2.2, 'Formulas': future-function-list and _xlpm).
"""

import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from math import lcm
from pathlib import Path
from typing import NamedTuple

from workbook.functions.addin.motion_functions.library import LAWS, OWN, LawForm
from workbook.functions.declarations import FUNCTIONS, TEXTS

SOURCE = Path(__file__).with_name("formulas.txt")
LATER = ("DROP", "HSTACK", "ISOMITTED", "LAMBDA", "LET", "MAKEARRAY", "MAP", "REDUCE", "SCAN", "SEQUENCE", "TAKE",
         "TOCOL", "VSTACK")  # fmt: skip
FUTURE = {name: f"_xlfn.{name}" for name in LATER} | {"FILTER": "_xlfn._xlws.FILTER"}
TOKEN = re.compile(
    r"""
      (?P<text>"(?:[^"]|"")*")
    | (?P<error>\#[A-Z0-9/]+[!?]?)
    | (?P<number>\d+(?:\.\d*)?(?:E[-+]?\d+)?)
    | (?P<call>[A-Za-z_][\w.]*)(?=\()
    | (?P<word>[A-Za-z_][\w.]*)
    | (?P<space>\s+)
    | (?P<sign><=|>=|<>|[-+*/^&=<>(),;{}\[\]])
    """,
    re.VERBOSE,
)
PREFIX = re.compile(r"_xl(?:fn|ws|pm|op)\.")
HEADING = re.compile(r"(?P<name>[\w.]+)(?:: (?P<note>.*))?\n=(?P<formula>.*)", re.DOTALL)
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
        for kind, part in tokens(self.formula):
            variable = kind == "word" and part not in ("TRUE", "FALSE")
            parts.append(FUTURE.get(part, part) if kind == "call" else f"_xlpm.{part}" if variable else part.strip())
        return "".join(parts).replace("[_xlpm.", "[_xlop.").replace("[", "").replace("]", "")


@cache
def definitions() -> tuple[Definition, ...]:
    """Return every name: the functions in the order of their declaration, then the helpers they call."""
    helps = {function.name: function.help.en for function in FUNCTIONS}
    found = {}
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
        found[name] = Definition(name, heading["note"] or helps[name], heading["formula"])
    order = [*helps, *(name for name in found if name not in helps)]
    return tuple(found[name] for name in order)


def tokens(formula: str) -> list[tuple[str, str]]:
    """Return the parts of a formula with their kinds; raise ValueError for what is none."""
    found, at = [], 0
    while at < len(formula):
        token = TOKEN.match(formula, at)
        if token is None or token.lastgroup is None:
            raise ValueError(f"not understood: {formula[at : at + 40]!r}")
        found.append((token.lastgroup, token[0]))
        at = token.end()
    return found


def meaning(stored: str) -> list[tuple[str, object]] | str:
    """Return a stored formula without what programs write in their own way; as it is where it cannot be read."""
    try:
        parts = tokens(PREFIX.sub("", stored.removeprefix("=")))
    except ValueError:
        return stored
    return [(kind, float(part) if kind == "number" else part.upper()) for kind, part in parts if kind != "space"]


def array(values: Sequence[float]) -> str:
    """Return a number, or several as an array, as whole ones over what they have in common."""
    found = [Fraction(value).limit_denominator(LARGEST) for value in values]
    common = lcm(*(one.denominator for one in found))
    whole = ",".join(str(one * common) for one in found)
    text = f"{{{whole}}}" if len(found) > 1 else whole
    return text if common == 1 else f"{text} / {common}"


def domain_condition(law: LawForm) -> str:
    """Return the condition under which a law can have the parameters ``p``."""
    conditions = ["_MOTION.LASTS(_MOTION.SEVEN(code, p))"] if law.stages else []
    for k, domain in law.domains.items():
        at, below = f"INDEX(p, {k + 1})", "<" if domain.open else "<="
        if domain.among:
            conditions.append(f"OR({', '.join(f'{at} = {value:g}' for value in domain.among)})")
        else:
            conditions += [f"0 {below} {at}", f"{at} {below} 1"]
    return f"AND({', '.join(conditions)})" if len(conditions) > 1 else "".join(conditions) or "TRUE"


def by_law(texts: Mapping[str, str], otherwise: str) -> str:
    """Return a formula that chooses by ``code`` among formulas of laws; laws of the same one together."""
    found: dict[str, list[str]] = {}
    for code, text in texts.items():
        found.setdefault(text, []).append(f'code = "{code}"')
    for text, codes in reversed(found.items()):
        among = codes[0] if len(codes) == 1 else f"OR({', '.join(codes)})"
        otherwise = f"IF({among}, {text},\n    {otherwise})"
    return otherwise


def tables() -> dict[str, str]:
    """Return what ``formulas.txt`` names: of each law its parameters, pieces, stages, and derivatives its ends meet."""
    delivered = {code: array(law.delivered) for code, law in LAWS.items() if law.delivered}
    built = {code: TEXTS["pieces"].get(code) or f"_MOTION.STAGES(_MOTION.SEVEN(code, p), {str(law.straight).upper()})"
             for code, law in LAWS.items()}  # fmt: skip
    meets = {code: f"IF(INDEX(p, 1) = 1 / 2, {len(law.half) // 2}, 0)" if law.half else "1" if law.stages else "0"
             for code, law in LAWS.items()}  # fmt: skip
    return {
        "delivered": by_law({"OWN": array(OWN[0]), **delivered}, "0"),
        "count": by_law({code: str(len(law.delivered)) for code, law in LAWS.items()}, "#VALUE!"),
        "fits": by_law({code: domain_condition(law) for code, law in LAWS.items()}, "FALSE"),
        "built": by_law({"OWN": "_MOTION.FULL(p)", **built}, "#VALUE!"),
        "seven": by_law(TEXTS["stages"], "#VALUE!"),
        "meets": by_law(meets, "0"),
    }
