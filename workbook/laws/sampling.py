"""A law in cells: find the piece by one MATCH on the stacked pieces, then coefficients times powers; rows of phases.

The pieces stand on the Laws sheet, the coefficients of each side by side; a piece is found by its key, twice the law's
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
from workbook.book.declare import Quantity, calc
from workbook.book.rows import LEAST, NOT_ZERO, constants, filled
from workbook.laws.family import ENTRIES

FIND = "=MATCH(2*{law}+MIN([{xi}]+break_eps,1-break_eps),piece_key,1)"
ARGUMENTS = (  # of each sine: the entry of its amplitude, and the column of its argument
    ("P", "x", "sine argument", "x", "=INDEX(piece_omega,[q])*[u]+INDEX(piece_phi,[q])", "ωu + φ"),
    ("P2", "z", "second sine's argument", "z", "=INDEX(piece_omega2,[q])*[u]+INDEX(piece_phi2,[q])", "ω₂u + φ₂"),
)
SPELLED = {  # of each derivative: what it is called, the block of its coefficients, its equation, what a sine adds
    "s": ("position", "piece_y", "S0 + S1 u + … − P/ω² sin x", "-INDEX(piece_ps{0},[q])*SIN([{1}])"),
    "v": ("velocity", "piece_dy", "S1 + c0 u + … − P/ω cos x", "-INDEX(piece_pv{0},[q])*COS([{1}])"),
    "a": ("acceleration", "piece_ddy", "c0 + c1 u + … + P sin x", "+INDEX(piece_P{0},[q])*SIN([{1}])"),
    "j": ("jerk", "piece_dddy", "c1 + 2 c2 u + … + P ω cos x", "+INDEX(piece_pj{0},[q])*COS([{1}])"),
}


def polynomial(derivative: str, highest: int, room: int) -> str:
    """Return the formula of the polynomial of a derivative: up to two terms one by one, else coefficients times powers.

    The acceleration has powers of u up to the ``highest``, below 0 where it is a sine alone, empty where the derivative
    has none; the stack has ``room`` coefficients of it.
    """
    order = "svaj".index(derivative)
    names = ["s0", "s1", *(f"c{k}" for k in range(room))][order:] if order < 3 else [f"c{k}" for k in range(1, room)]
    used = max(highest + 3 - order, 0)
    if used <= 2:
        factors = ("", "2*" if order > 2 else "")
        return "+".join(f"{factors[k]}INDEX(piece_{name},[q]){'*[u]' * k}" for k, name in enumerate(names[:used]))
    factor = {"s": f"/{constants([1, 1, *(perm(k, 2) for k in range(2, room + 2))])}",
              "v": f"/{constants([1, *range(1, room + 1)])}", "j": f",{constants(range(1, room))}"}  # fmt: skip
    block = f"INDEX({SPELLED[derivative][1]},[q],0){factor.get(derivative, '')}"
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
        """Return the number of one of the book's laws."""
        return self._numbers[id(law)]

    def finding(self, law: str, number: int, name: str, xi: Array, entries: Container[str] = ENTRIES) -> list[Quantity]:
        """Return the workings of samples of a law by its cell and number: piece, u in it, arguments of its sines."""
        place, find = located(self.pieces[number], xi), FIND.format(law=law, xi=name)
        row = (self.first[number] + place.piece).astype(float)
        return [
            calc("q", "piece row", "q", "", find, row, format="0", source="last key not above the sample's"),
            *self.within(f"=[{name}]-INDEX(piece_xi,[q])", "ξ − ξ_k", place.u,
                         *(place.angle, place.angle2)[: 1 + self.second_sine], entries=entries),
        ]  # fmt: skip

    def within(
        self, formula: str, words: str, u: Array, *angles: Any, entries: Container[str] = ENTRIES
    ) -> list[Quantity]:
        """Return u by its formula, and the argument of each sine, of points whose piece is known."""
        return [
            calc("u", "within piece", "u", "", f"{formula}{NOT_ZERO}", u + LEAST,
                 source=f"{words}; never 0, so that u⁰ is 1"),
            *(calc(name, label, symbol, "rad", formula, values, source=source)
              for (amplitude, name, label, symbol, formula, source), values in zip(ARGUMENTS, angles, strict=False)
              if amplitude in entries),
        ]  # fmt: skip

    def columns(
        self, values: dict[str, Array], derivatives: str, role: Any = calc, entries: Container[str] = ENTRIES
    ) -> list[Quantity]:
        """Return the columns of ``derivatives``, a part of ``svaj``, with the engine's values."""
        both = ARGUMENTS if self.second_sine else ARGUMENTS[:1]
        sines = [(entry[1:], x) for entry, x, *_ in both if entry in entries]
        made = []
        for d in derivatives:
            label, _, source, sine = SPELLED[d]
            highest = max((k for k in range(self.room) if f"c{k}" in entries), default=-1)
            formula = polynomial(d, highest, self.room) + "".join(sine.format(*each) for each in sines)
            made.append(role(d, label, d, "", f"={formula.removeprefix('+') or 'INDEX(piece_c1,[q])'}", values[d],
                             source=source))  # fmt: skip
        return made


LAW_NUMBER = '=IF([law]="",1,MATCH([law],law_code,0))'
CA = "MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))"
VELOCITY = "=IF([span]>0,INDEX(law_cv,[no])*ABS([h])/[span],0)"
ACCELERATION = f"=IF([span]>0,{CA}*ABS([h])/[span]^2,0)"
JERK = '=IF(ABS([h])*[span]>0,IF(INDEX(law_cj,[no])="∞","∞",INDEX(law_cj,[no])*ABS([h])/[span]^3),0)'
LOW = "=IF([span]>0,[y0]+MIN([h]*INDEX(law_low,[no]),[h]*INDEX(law_high,[no])),{0})"
HIGH = "=IF([span]>0,[y0]+MAX([h]*INDEX(law_low,[no]),[h]*INDEX(law_high,[no])),{0})"
RMS = "IF([span]>0,INDEX(law_ca_rms,[no])*ABS([h])/[span]^2,0)"


def kind(ends: str = "") -> str:
    """Return the formula that names a phase, spare without an end; with the table ``ends`` it may turn."""
    still, other = "[lift]=0", '"return"'
    if ends:
        still, other = f"ABS([lift])+INDEX([{ends}.mode],[k])=0", 'IF([lift]<0,"return","turn")'
    return f'=IF([stop]="","spare",IF(OR([law]="DWL",{still}),"dwell",IF([lift]>0,"rise",{other})))'


def kinds(phases: Sequence[Phase], rows: int) -> list[str]:
    """Return the kind of each phase, one that moves without a lift a turn; spare rows are spare."""
    moving = {-1.0: "return", 0.0: "turn", 1.0: "rise"}
    return filled([moving[np.sign(phase.lift)] if phase.moves else "dwell" for phase in phases], rows, "spare")
