"""The functions MOTION.* of ``functions.toml``: both back ends take names, arguments and help texts from here.

What both back ends promise, beside the help texts:

- An error value given as an argument passes through; one within a range gives an error.
- A law is named by its code, in capitals or not, blanks around it ignored. Anything else: #VALUE!.
- Where a number is expected, an empty cell counts as 0 and a text is #VALUE!. A number outside its domain is #NUM!.
- ``p`` holds the law's parameters in the order of its page, a row or a column, read left to right, top to bottom;
  blank cells count as 0, and where the motion turns round, ``start`` and ``end`` count as −1 and 1, ``none`` as 0.
  Left out, and where all of it is 0 or blank, the law is as delivered. Else another number of cells than
  :data:`PARAMETERS` says is #VALUE!, values that the engine refuses are #NUM!. OWN takes
  rows of eight (duration, c0, c1, c2, c3, P, ω, φ), of which those of an empty or zero duration are passed over; left
  out, it is the polynomial 3-4-5. DWL and LIN ignore p.
- ξ is right-continuous at breaks, with a tolerance of 2e-9; at ξ = 1 the left limit counts.
- An infinite coefficient is #NUM!, and so are coefficients and inverse of an own law with a sine of more than
  1,000 rad in one piece. What only evaluates the law, at ξ or in a phase, takes any sine.
- A row of a table of phases: code, duration, lift, then the law's parameters, as p takes them; OWN has its pieces side
  by side, eight cells each, as many as there is room for; no room for one is #VALUE!. Rows at the end whose first three
  cells are empty are ignored. Fewer than three columns, or no rows: #VALUE!. A duration that is not positive, or a
  dwell with a lift: #NUM!. Beyond [0, total], by more than 1e-12 of the total: #NUM!; a joint begins 2e-9 early.
- A first column of numbers: phases as a book has them, from, to, lift, code, parameters, at rest before, between (gaps
  beyond 1e-9 of the whole) and after; any x. Fewer than four columns, a row VIA: #VALUE!; an overlap: #NUM!.
- Phases hand over: beside a straight line (LIN) a curved phase takes its velocity, beside a dwell and where nothing
  stands beside it, it rests. A row VIA with velocity, acceleration and jerk (per x, x², x³) in place of duration, lift
  and first parameter prescribes them between two curved phases, or where the motion begins or ends; else they are 0
  there. Laws of two pulses meet a velocity, CUB, PO5 and PO7 of the share ½ one, two or three of these; what a law
  cannot meet is #NUM!, and so is a VIA beside another or one that a straight line contradicts, and a motion of VIA
  alone. Two straight lines beside each other keep their velocities.
- JRED and RMS: ranges of unequal size are #VALUE!; a negative inertia or duration, or durations of sum 0, are #NUM!.
- MOTION.XI: the first ξ that reaches s; s = 0 gives 0 and the law's end value 1. A law that moves backwards: #NUM!.
"""

import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Literal, NamedTuple

from engine.laws.entry import IncompleteError
from workbook.functions.addin.motion_functions.laws import LAWS, OWN_TAKES, Text
from workbook.laws.registry import FAMILIES

NAMESPACE = "MOTION"
Kind = Literal["code", "number", "cells", "table"]
CODES: tuple[str, ...] = tuple(family.code for family in FAMILIES if family.page.functions)
"""codes of the laws that the functions know: of every family but points, which are a table of their own"""
PARAMETERS = {one.code: len(one.page.parameters) for one in FAMILIES if one.code in CODES and one.code != "OWN"}
"""codes of the laws with the number of parameters each takes; OWN, beside them, takes rows of pieces"""
if wrong := [code for code, count in PARAMETERS.items() if code not in LAWS or bool(LAWS[code].takes) != bool(count)]:
    raise IncompleteError(f"addin/motion_functions/laws.py lacks {', '.join(wrong)}, or words for their parameters")
TAKES: dict[str, Text] = {code: one.takes for code, one in LAWS.items() if one.takes} | {"OWN": OWN_TAKES}
"""what each law takes that takes anything"""


class Argument(NamedTuple):
    """An argument: what it takes (a law's code, a number, a range or array or single value, a table of phases)."""

    kind: Kind
    name: Text
    help: Text
    optional: bool
    """whether it may be left out"""

    @property
    def shown(self) -> str:
        """The name as a call shows it: in brackets where it may be left out."""
        return f"[{self.name.en}]" if self.optional else self.name.en


class Function(NamedTuple):
    """A function: the last part of its name, what it returns, its arguments; the last of them may be optional."""

    key: str
    help: Text
    arguments: list[Argument]

    @property
    def name(self) -> str:
        """The name as it stands in a formula and in the file."""
        return f"{NAMESPACE}.{self.key}"


def told(texts: Sequence[str]) -> Text:
    """Return texts of three languages with the codes of the laws, and with what each law takes."""
    made = []
    for words, text in zip(zip(*TAKES.values(), strict=True), texts, strict=True):
        alike = {one: [code for code, other in zip(TAKES, words, strict=True) if other == one] for one in words}
        takes = "; ".join(f"{', '.join(codes)}: {one}" for one, codes in alike.items())
        made.append(text.format(codes=", ".join(CODES[:-1]), last=CODES[-1], takes=takes))
    return Text(*made)


TEXTS = tomllib.loads(Path(__file__).with_name("functions.toml").read_text(encoding="utf-8"))
ARGUMENTS = {
    name: Argument(one["kind"], Text(*one["name"]), told(one["help"]), one.get("optional", False))
    for name, one in TEXTS["arguments"].items()
}
FUNCTIONS = [
    Function(key, told(one["help"]), [ARGUMENTS[name] for name in one["arguments"]])
    for key, one in TEXTS["functions"].items()
]
