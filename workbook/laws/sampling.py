"""A law evaluated in cells: find the piece by one MATCH on the stacked pieces, then a short formula each.

Every sampled table of the book uses these columns. The pieces stand on the Laws sheet; a piece is found by its
key, twice the law's number plus the ξ at which it begins. A sample within ``break_tolerance`` of a break counts
as on it, so that rounding never decides which side of a jump is shown; ξ = 1 belongs to the last piece.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from typing import Any

import numpy as np

from engine.laws import Law, Piece
from engine.laws.base import Array
from engine.laws.table import located
from workbook.book.declare import Quantity, calc

FIND = "=MATCH(2*{law}+MIN([{xi}]+break_tolerance,1-break_tolerance),piece_key,1)"
LOCAL = "=[{xi}]-INDEX(piece_xi,[{q}])"
ARGUMENT = "=INDEX(piece_omega,[{q}])*[{u}]+INDEX(piece_phi,[{q}])"
ARGUMENT2 = "=INDEX(piece_omega2,[{q}])*[{u}]+INDEX(piece_phi2,[{q}])"
POSITION = (
    "=INDEX(piece_s0,[{q}])+[{u}]*(INDEX(piece_s1,[{q}])+[{u}]*(INDEX(piece_c0,[{q}])/2+[{u}]*(INDEX(piece_c1,[{q}])/6"
    "+[{u}]*(INDEX(piece_c2,[{q}])/12+[{u}]*(INDEX(piece_c3,[{q}])/20+[{u}]*(INDEX(piece_c4,[{q}])/30"
    "+[{u}]*INDEX(piece_c5,[{q}])/42))))))-INDEX(piece_ps,[{q}])*SIN([{x}])"
)
VELOCITY = (
    "=INDEX(piece_s1,[{q}])+[{u}]*(INDEX(piece_c0,[{q}])+[{u}]*(INDEX(piece_c1,[{q}])/2+[{u}]*(INDEX(piece_c2,[{q}])/3"
    "+[{u}]*(INDEX(piece_c3,[{q}])/4+[{u}]*(INDEX(piece_c4,[{q}])/5+[{u}]*INDEX(piece_c5,[{q}])/6)))))"
    "-INDEX(piece_pv,[{q}])*COS([{x}])"
)
ACCELERATION = (
    "=INDEX(piece_c0,[{q}])+[{u}]*(INDEX(piece_c1,[{q}])+[{u}]*(INDEX(piece_c2,[{q}])+[{u}]*(INDEX(piece_c3,[{q}])"
    "+[{u}]*(INDEX(piece_c4,[{q}])+[{u}]*INDEX(piece_c5,[{q}])))))+INDEX(piece_P,[{q}])*SIN([{x}])"
)
JERK = (
    "=INDEX(piece_c1,[{q}])+[{u}]*(2*INDEX(piece_c2,[{q}])+[{u}]*(3*INDEX(piece_c3,[{q}])"
    "+[{u}]*(4*INDEX(piece_c4,[{q}])+[{u}]*5*INDEX(piece_c5,[{q}]))))"
    "+INDEX(piece_P,[{q}])*INDEX(piece_omega,[{q}])*COS([{x}])"
)
SECOND = {
    "s": "-INDEX(piece_ps2,[{q}])*SIN([{z}])",
    "v": "-INDEX(piece_pv2,[{q}])*COS([{z}])",
    "a": "+INDEX(piece_P2,[{q}])*SIN([{z}])",
    "j": "+INDEX(piece_P2,[{q}])*INDEX(piece_omega2,[{q}])*COS([{z}])",
}
"""what a second sine adds, in a book that has a law with one"""
SPELLED = {
    "s": ("position", POSITION, "s_k + ∬a"),
    "v": ("velocity", VELOCITY, "v_k + ∫a"),
    "a": ("acceleration", ACCELERATION, "c0 + c1u + … + P sin x"),
    "j": ("jerk", JERK, "da/dξ"),
}


class Pieces:
    """The stacked pieces as the sheets expect to find them: the pieces of each law, by number.

    ``second_sine`` says whether the stack has the columns of a second sine: in a book with a law that needs them.
    """

    def __init__(self, pieces: dict[int, list[Piece]], numbers: dict[int, int], second_sine: bool) -> None:
        self.pieces, self._numbers, self.second_sine = pieces, numbers, second_sine
        before = accumulate((len(rows) for rows in pieces.values()), initial=1)
        self.first = dict(zip(pieces, before, strict=False))

    @property
    def width(self) -> int:
        """The number of rows that :meth:`locate` returns."""
        return 4 if self.second_sine else 3

    def number(self, law: Law) -> int:
        """Return the number of one of the book's laws."""
        return self._numbers[id(law)]

    def locate(self, number: int, xi: Array) -> Array:
        """Return of samples of one law, in rows: row of the piece (from 1), u from its begin, ωu + φ of each sine."""
        place = located(self.pieces[number], xi)
        row = (self.first[number] + place.piece).astype(float)
        angles = (place.angle, place.angle2) if self.second_sine else (place.angle,)
        return np.array([row, place.u, *angles])

    def finding(self, law: str, xi: str, at: Array, suffix: str = "") -> list[Quantity]:
        """Return the workings that find the piece of each sample: row, local abscissa, argument of each sine."""
        names = {"law": law, "xi": xi} | columns_of(suffix)
        found = [
            ("q", "piece row", "q", "", FIND, "last key not above the sample's"),
            ("u", "within piece", "u", "", LOCAL, "ξ − ξ_k"),
            ("x", "sine argument", "x", "rad", ARGUMENT, "ωu + φ"),
            ("z", "second sine's argument", "z", "rad", ARGUMENT2, "ω₂u + φ₂"),
        ]
        return [
            calc(names[name], label, symbol, unit, formula.format(**names), values,
                 format="0" if name == "q" else "", source=source)
            for (name, label, symbol, unit, formula, source), values in zip(found, at, strict=False)
        ]  # fmt: skip

    def arguments(self, angles: Sequence[Any]) -> list[Quantity]:
        """Return the columns of the sines' arguments at points whose piece and local abscissa are known."""
        found = [("x", "sine argument", ARGUMENT, "ωu + φ"), ("z", "second sine's argument", ARGUMENT2, "ω₂u + φ₂")]
        names = columns_of("")
        return [
            calc(name, label, name, "rad", formula.format(**names), values, source=source)
            for (name, label, formula, source), values in zip(found[: self.width - 2], angles, strict=False)
        ]

    def shape(
        self, law: Law, xi: Array, derivatives: str = "svaj", suffix: str = "", role: Any = calc
    ) -> list[Quantity]:
        """Return the columns s, v, a, j of one law at samples found by :meth:`finding`."""
        return self.columns(dict(zip("svaj", law.evaluate(xi), strict=True)), derivatives, suffix, role)

    def columns(
        self, values: dict[str, Array], derivatives: str, suffix: str = "", role: Any = calc
    ) -> list[Quantity]:  # fmt: skip
        """Return the columns of ``derivatives``, a part of ``svaj``, with the engine's values."""
        names, made = columns_of(suffix), []
        for d in derivatives:
            label, formula, source = SPELLED[d]
            formula += SECOND[d] if self.second_sine else ""
            made.append(role(d + suffix, label, d, "", formula.format(**names), values[d], source=source))
        return made


def columns_of(suffix: str) -> dict[str, str]:
    """Return the names of the columns that find a sample's piece."""
    return {name: name + suffix for name in "quxz"}
