"""The functions as names of Excel: LAMBDA formulas, as they are read and as a file stores them.

``formulas.txt`` holds them in the spelling that Excel shows; what differs by law comes from ``lambdas.py``. A file
marks what Excel 2007 did not know: functions by ``_xlfn.``, the parameters of LAMBDA and the variables of LET by
``_xlpm.``, an optional parameter, ``[name]`` as Excel shows it, by ``_xlop.`` where it is declared
(Microsoft, [MS-XLSX] 2.2.2, 'Formulas': future-function-list and _xlpm).
"""

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from workbook.functions.declared import FUNCTIONS
from workbook.functions.lambdas import tables

SOURCE = Path(__file__).with_name("formulas.txt")
FUTURE = {
    **{name: f"_xlfn.{name}" for name in (
        "DROP", "HSTACK", "ISOMITTED", "LAMBDA", "LET", "MAKEARRAY", "MAP", "REDUCE", "SCAN", "SEQUENCE", "TAKE",
        "TOCOL", "VSTACK",
    )},
    "FILTER": "_xlfn._xlws.FILTER",
}  # fmt: skip
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


@dataclass(frozen=True)
class Definition:
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
    """Return a stored formula without what a program may write in its own way: prefixes, blanks, case, digits.

    A formula that cannot be read stands for itself.
    """
    try:
        parts = tokens(PREFIX.sub("", stored.removeprefix("=")))
    except ValueError:
        return stored
    return [(kind, float(part) if kind == "number" else part.upper()) for kind, part in parts if kind != "space"]
