"""A law evaluated in cells: find the piece by one MATCH on the stacked pieces, then coefficients times powers.

Every sampled table of the book uses these columns. The pieces stand on the Laws sheet, with the coefficients of s, v, a
and j as blocks; a piece is found by its key, twice the law's number plus the ξ at which it begins. A sample within
``break_tolerance`` of a break counts as on it, so that rounding never decides which side of a jump is shown; ξ = 1
belongs to the last piece.
"""

from __future__ import annotations

from itertools import accumulate
from typing import Any

import numpy as np

from engine.laws import Law, Piece
from engine.laws.base import Array
from engine.laws.piece import POWERS
from engine.laws.table import located, powers
from workbook.book.declare import Quantity, calc, constant

FIND = "=MATCH(2*{law}+MIN([{xi}]+break_tolerance,1-break_tolerance),piece_key,1)"
ARGUMENTS = (
    ("x", "sine argument", "x", "=INDEX(piece_omega,[q])*[u]+INDEX(piece_phi,[q])", "ωu + φ"),
    ("z", "second sine's argument", "z", "=INDEX(piece_omega2,[q])*[u]+INDEX(piece_phi2,[q])", "ω₂u + φ₂"),
)
HIGHEST = POWERS + 1
"""the highest power of u in a position"""
RAISED = ("u⁰", "u", "u²", "u³", "u⁴", "u⁵", "u⁶", "u⁷")
SINES = {
    "s": "-INDEX(piece_ps{0},[q])*SIN([{1}])",
    "v": "-INDEX(piece_pv{0},[q])*COS([{1}])",
    "a": "+INDEX(piece_P{0},[q])*SIN([{1}])",
    "j": "+INDEX(piece_pj{0},[q])*COS([{1}])",
}
"""what a sine adds"""
SPELLED = {
    "s": ("position", "[curves_of.s0:s7]", "S0 + S1 u + … − P/ω² sin x"),
    "v": ("velocity", "[curves_of.v0:v6]", "V0 + V1 u + … − P/ω cos x"),
    "a": ("acceleration", "[pieces.c0:c5]", "c0 + c1 u + … + P sin x"),
    "j": ("jerk", "[curves_of.j0:j4]", "da/dξ"),
}
"""of each derivative: what it is called, its block of coefficients, and its equation"""


class Pieces:
    """The stacked pieces as the sheets expect to find them: the pieces of each law, by number.

    ``second_sine`` says whether the stack has the columns of a second sine: in a book with a law that needs them.
    """

    def __init__(self, pieces: dict[int, list[Piece]], numbers: dict[int, int], second_sine: bool) -> None:
        self.pieces, self._numbers, self.second_sine = pieces, numbers, second_sine
        before = accumulate((len(rows) for rows in pieces.values()), initial=1)
        self.first = dict(zip(pieces, before, strict=False))

    def number(self, law: Law) -> int:
        """Return the number of one of the book's laws."""
        return self._numbers[id(law)]

    def locate(self, number: int, xi: Array) -> Array:
        """Return of samples of one law, in rows: row of the piece (from 1), u from its begin, ωu + φ of each sine."""
        place = located(self.pieces[number], xi)
        row = (self.first[number] + place.piece).astype(float)
        angles = (place.angle, place.angle2) if self.second_sine else (place.angle,)
        return np.array([row, place.u, *angles])

    def finding(self, law: str, xi: str, at: Array) -> list[Quantity]:
        """Return the workings of each sample: row of its piece, powers of u in it, the argument of each sine."""
        row, *local = at
        find = FIND.format(law=law, xi=xi)
        return [
            calc("q", "piece row", "q", "", find, row, format="0", source="last key not above the sample's"),
            *self.within(f"=[{xi}]-INDEX(piece_xi,[q])", "ξ − ξ_k", *local),
        ]

    def within(self, formula: str, words: str, u: Array, *angles: Any) -> list[Quantity]:
        """Return the powers of u, by its formula, and the argument of each sine, of points whose piece is known."""
        raised = powers(u, HIGHEST)
        return [
            constant("u0", "power 0", "u⁰", "", raised[0]),
            calc("u", "within piece", "u", "", formula, u, source=words),
            *(calc(f"u{k}", f"power {k}", RAISED[k], "", f"=[u]^{k}", raised[k]) for k in range(2, HIGHEST + 1)),
            *(calc(name, label, symbol, "rad", formula, values, source=source)
              for (name, label, symbol, formula, source), values in zip(ARGUMENTS, angles, strict=False)),
        ]  # fmt: skip

    def shape(self, law: Law, xi: Array, derivatives: str = "svaj", role: Any = calc) -> list[Quantity]:
        """Return the columns s, v, a, j of one law at samples found by :meth:`finding`."""
        return self.columns(dict(zip("svaj", law.evaluate(xi), strict=True)), derivatives, role)

    def columns(self, values: dict[str, Array], derivatives: str, role: Any = calc) -> list[Quantity]:
        """Return the columns of ``derivatives``, a part of ``svaj``, with the engine's values."""
        made = []
        for d in derivatives:
            label, block, source = SPELLED[d]
            formula = f"=SUMPRODUCT(INDEX({block},[q],0),[u0:u{block[-2]}])" + self.turned(d)
            made.append(role(d, label, d, "", formula, values[d], source=source))
        return made

    def turned(self, derivative: str) -> str:
        """Return what the sines add to a derivative."""
        both = (("", "x"), ("2", "z")) if self.second_sine else (("", "x"),)
        return "".join(SINES[derivative].format(*one) for one in both)
