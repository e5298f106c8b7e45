"""A law in cells: find the piece by a MATCH on the stacked pieces, then coefficients times powers; rows of phases.

The pieces stand on the Laws sheet, the coefficients of each side by side; a piece has a key, twice the law's
number plus the ξ at which it begins. A sample within ``break_eps`` of a break counts as on it, so that rounding never
decides which side of a jump is shown; ξ = 1 belongs to the last piece.
"""

from collections.abc import Container, Sequence
from itertools import accumulate
from math import perm
from typing import Any

import numpy as np

from engine.laws import Law, Piece
from engine.laws.base import Array
from engine.laws.piece import located
from engine.motion import Phase
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, calc, result
from workbook.book.rows import LEAST, constants, filled
from workbook.laws.family import ENTRIES

CELLS = cell_tables(__file__)

# of each sine: the column of its argument, and the entry of its amplitude
SINES = {"x": "P", "z": "P2"}
SPELLED = {  # of each derivative: the block of its coefficients, and what a sine adds
    "s": ("piece_y", "-INDEX(piece_ps{0},[q])*SIN([{1}])"),
    "v": ("piece_dy", "-INDEX(piece_pv{0},[q])*COS([{1}])"),
    "a": ("piece_ddy", "+INDEX(piece_P{0},[q])*SIN([{1}])"),
    "j": ("piece_dddy", "+INDEX(piece_pj{0},[q])*COS([{1}])"),
}


def polynomial(derivative: str, highest: int, room: int) -> str:
    """Return the formula of the polynomial of a derivative: up to two terms in a row, else coefficients times powers.

    The acceleration has powers of u up to the ``highest``, below 0 where it is a sine alone, empty where the derivative
    has none; the stack has ``room`` coefficients of it.
    """
    order = "svaj".index(derivative)
    names = ["s0", "s1", *(f"c{k}" for k in range(room))][order:] if order < 3 else [f"c{k}" for k in range(1, room)]
    used = max(highest + 3 - order, 0)
    if used <= 2:
        factors = ("", "2*" if order > 2 else "")
        return "+".join(f"{factors[k]}INDEX(piece_{name},[q]){'*[u]' * k}" for k, name in enumerate(names[:used]))
    factor = {
        "s": f"/{constants([1, 1, *(perm(k, 2) for k in range(2, room + 2))])}",
        "v": f"/{constants([1, *range(1, room + 1)])}",
        "j": f",{constants(range(1, room))}",
    }
    block = f"INDEX({SPELLED[derivative][0]},[q],0){factor.get(derivative, '')}"
    return f"SUMPRODUCT({block},[u]^{constants(range(len(names)))})"


class Pieces:
    """The stacked pieces, by number of their law; with columns of a ``second_sine`` in a book whose laws need them."""

    def __init__(self, pieces: dict[int, list[Piece]], numbers: dict[int, int], second_sine: bool) -> None:
        self.pieces, self._numbers, self.second_sine = pieces, numbers, second_sine
        before = accumulate((len(rows) for rows in pieces.values()), initial=1)
        self.first = dict(zip(pieces, before, strict=False))
        self.room = max(len(piece.c) for rows in pieces.values() for piece in rows)
        """coefficients of the acceleration that any piece has"""

    def number(self, law: Law) -> int:
        """Return the number of a law of the book."""
        return self._numbers[id(law)]

    def finding(self, law: str, number: int, name: str, xi: Array, entries: Container[str] = ENTRIES) -> list[Quantity]:
        """Return the workings of samples of a law by its cell and number: piece, u in it, arguments of its sines."""
        place = located(self.pieces[number], xi)
        row, angles = (self.first[number] + place.piece).astype(float), (place.angle, place.angle2)
        return [
            CELLS["finding"]("q", row, law=law, xi=name),
            *self.within(f"=[{name}]-INDEX(piece_xi,[q])", "ξ − ξ_k", place.u, *angles, entries=entries),
        ]

    def within(
        self, formula: str, words: str, u: Array, *angles: Any, entries: Container[str] = ENTRIES
    ) -> list[Quantity]:
        """Return u by its formula, and the argument of each sine, of points whose piece is known."""
        cell, angles_of = CELLS["within"], zip(self.sines.items(), angles, strict=False)
        arguments = [cell(name, values) for (name, amplitude), values in angles_of if amplitude in entries]
        return [cell("u", u + LEAST, place=formula, words=words), *arguments]

    @property
    def sines(self) -> dict[str, str]:
        """The entry of the amplitude of each sine that a piece may have, by the column of its argument."""
        return SINES if self.second_sine else {"x": SINES["x"]}

    def columns(
        self, values: dict[str, Array], derivatives: str, role: Any = calc, entries: Container[str] = ENTRIES
    ) -> list[Quantity]:
        """Return the columns of ``derivatives``, a part of ``svaj``, with the engine's values: workings, or results."""
        cell = CELLS["results"] if role is result else CELLS["workings"]
        sines = [(amplitude[1:], x) for x, amplitude in self.sines.items() if amplitude in entries]
        highest = max((k for k in range(self.room) if f"c{k}" in entries), default=-1)

        def derivative(name: str) -> Quantity:
            adds = "".join(SPELLED[name][1].format(*sine) for sine in sines)
            text = f"{polynomial(name, highest, self.room)}{adds}".removeprefix("+")
            return cell(name, values[name], sampled=text or "INDEX(piece_c1,[q])")

        return [*map(derivative, derivatives)]


LAW_NUMBER = '=IF([law]="",1,MATCH([law],law_code,0))'
CA = "MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))"
VELOCITY = "=IF([span]>0,INDEX(law_cv,[no])*ABS([h])/[span],0)"
ACCELERATION = f"=IF([span]>0,{CA}*ABS([h])/[span]^2,0)"
JERK = '=IF(ABS([h])*[span]>0,IF(INDEX(law_cj,[no])="∞","∞",INDEX(law_cj,[no])*ABS([h])/[span]^3),0)'
LOW = "=IF([span]>0,[y0]+MIN([h]*INDEX(law_low,[no]),[h]*INDEX(law_high,[no])),{0})"
HIGH = "=IF([span]>0,[y0]+MAX([h]*INDEX(law_low,[no]),[h]*INDEX(law_high,[no])),{0})"


def kind(ends: str = "") -> str:
    """Return the formula that names a phase, spare without an end; with the table ``ends`` it may turn."""
    still, other = "[lift]=0", '"return"'
    if ends:
        still, other = f"ABS([lift])+INDEX([{ends}.mode],[k])=0", 'IF([lift]<0,"return","turn")'
    return f'=IF([stop]="","spare",IF(OR([law]="DWL",{still}),"dwell",IF([lift]>0,"rise",{other})))'


def kinds(phases: Sequence[Phase], rows: int) -> list[str]:
    """Return the kind of each phase, a turn where it moves without a lift; spare rows are spare."""
    moving = {-1.0: "return", 0.0: "turn", 1.0: "rise"}
    return filled([moving[np.sign(phase.lift)] if phase.moves else "dwell" for phase in phases], rows, "spare")
