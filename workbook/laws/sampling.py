"""A law evaluated in cells: find the piece by one MATCH on the stacked pieces, then a short formula each.

Every sampled table of the book uses these columns. The pieces stand on the Laws sheet; a piece is found by its
key, twice the law's number plus the ξ at which it begins. A sample within ``break_tolerance`` of a break counts
as on it, so that rounding never decides which side of a jump is shown; ξ = 1 belongs to the last piece.
"""

from __future__ import annotations

from itertools import accumulate
from typing import Any

from engine.laws import Law, Piece
from engine.laws.base import Array
from engine.laws.table import located
from workbook.book.declare import Quantity, calc

FIND = "=MATCH(2*{law}+MIN([{xi}]+break_tolerance,1-break_tolerance),piece_key,1)"
LOCAL = "=[{xi}]-INDEX(piece_xi,[{q}])"
ARGUMENT = "=INDEX(piece_omega,[{q}])*[{u}]+INDEX(piece_phi,[{q}])"
POSITION = (
    "=INDEX(piece_s0,[{q}])+[{u}]*(INDEX(piece_s1,[{q}])+[{u}]*(INDEX(piece_c0,[{q}])/2+[{u}]*(INDEX(piece_c1,[{q}])/6"
    "+[{u}]*(INDEX(piece_c2,[{q}])/12+[{u}]*INDEX(piece_c3,[{q}])/20))))-INDEX(piece_ps,[{q}])*SIN([{x}])"
)
VELOCITY = (
    "=INDEX(piece_s1,[{q}])+[{u}]*(INDEX(piece_c0,[{q}])+[{u}]*(INDEX(piece_c1,[{q}])/2+[{u}]*(INDEX(piece_c2,[{q}])/3"
    "+[{u}]*INDEX(piece_c3,[{q}])/4)))-INDEX(piece_pv,[{q}])*COS([{x}])"
)
ACCELERATION = (
    "=INDEX(piece_c0,[{q}])+[{u}]*(INDEX(piece_c1,[{q}])+[{u}]*(INDEX(piece_c2,[{q}])+[{u}]*INDEX(piece_c3,[{q}])))"
    "+INDEX(piece_P,[{q}])*SIN([{x}])"
)
JERK = (
    "=INDEX(piece_c1,[{q}])+[{u}]*(2*INDEX(piece_c2,[{q}])+[{u}]*3*INDEX(piece_c3,[{q}]))"
    "+INDEX(piece_P,[{q}])*INDEX(piece_omega,[{q}])*COS([{x}])"
)


Located = tuple[Array, Array, Array]
"""row of the piece (from 1), u from its begin, and the argument ωu + φ of its sine, of each sample"""


class Pieces:
    """The stacked pieces as the sheets expect to find them: the pieces of each law, by number."""

    def __init__(self, pieces: dict[int, list[Piece]], numbers: dict[int, int]) -> None:
        self.pieces, self._numbers = pieces, numbers
        before = accumulate((len(rows) for rows in pieces.values()), initial=1)
        self.first = dict(zip(pieces, before, strict=False))

    def number(self, law: Law) -> int:
        """Return the number of one of the book's laws."""
        return self._numbers[id(law)]

    def locate(self, number: int, xi: Array) -> Located:
        """Return piece row (from 1), local abscissa u and sine argument ωu + φ of samples of one law."""
        place = located(self.pieces[number], xi)
        return (self.first[number] + place.piece).astype(float), place.u, place.angle


def finding(law: str, xi: str, at: Located, suffix: str = "") -> list[Quantity]:
    """Return the workings that find the piece of each sample: row, local abscissa, sine argument."""
    row, u, x = at
    names = {"law": law, "xi": xi, "q": f"q{suffix}", "u": f"u{suffix}", "x": f"x{suffix}"}
    return [
        calc(names["q"], "piece row", "q", "",
             FIND.format(**names), row, format="0", source="last key not above the sample's"),
        calc(names["u"], "within piece", "u", "", LOCAL.format(**names), u, source="ξ − ξ_k"),
        calc(names["x"], "sine argument", "x", "rad", ARGUMENT.format(**names), x, source="ωu + φ"),
    ]  # fmt: skip


def shape(law: Law, xi: Array, derivatives: str = "svaj", suffix: str = "", role: Any = calc) -> list[Quantity]:
    """Return the columns s, v, a, j of one law at samples found by :func:`finding`."""
    return columns(dict(zip("svaj", law.evaluate(xi), strict=True)), derivatives, suffix, role)


def columns(values: dict[str, Array], derivatives: str, suffix: str = "", role: Any = calc) -> list[Quantity]:
    """Return the columns of ``derivatives``, a part of ``svaj``, with the engine's values."""
    names = {name: name + suffix for name in "qux"}
    spelled = {
        "s": ("position", POSITION, "s_k + ∬a"),
        "v": ("velocity", VELOCITY, "v_k + ∫a"),
        "a": ("acceleration", ACCELERATION, "c0 + c1u + … + P sin x"),
        "j": ("jerk", JERK, "da/dξ"),
    }
    made = []
    for d in derivatives:
        label, formula, source = spelled[d]
        made.append(role(d + suffix, label, d, "", formula.format(**names), values[d], source=source))
    return made
