"""The engine's figures for the stacked pieces of all laws: what the Laws sheet must hold."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby

from engine.laws import Law, Piece
from engine.laws.table import Carried, carried, key
from workbook.book.chart import in_scope
from workbook.entries.machine import Sizes
from workbook.laws.registry import FAMILIES
from workbook.laws.sampling import Pieces

CODES = tuple(family.code for family in FAMILIES)
"""the laws of a book in the order of their numbers, from 1"""


@dataclass(frozen=True)
class Row:
    """One row of the stack: law, its number, number of the piece, formulas of its entries, and each column's value."""

    law: str
    number: int
    k: int
    piece: Piece
    formulas: dict[str, str]
    xi: float
    d: float
    c0: float
    c1: float
    c2: float
    c3: float
    P: float
    omega: float
    phi: float
    s: float
    v: float
    ds: float
    dv: float
    ps: float
    pv: float
    s0: float
    s1: float
    key: float


def stacked(library: dict[str, Law], sizes: Sizes) -> list[Row]:
    """Return the rows of the stack: the pieces of each law in the order of their numbers."""
    rows = []
    for number, family in enumerate(FAMILIES, 1):
        law = library[family.code]
        found = family.page.stacked(law, sizes.pieces)
        places = carried(law, [one.piece for one in found])
        for k, (one, place) in enumerate(zip(found, places, strict=True), 1):
            formulas = {name: in_scope(text, f"{family.code}_") for name, text in one.formulas.items()}
            rows.append(row(family.code, number, k, formulas, place))
    return rows


def row(law: str, number: int, k: int, formulas: dict[str, str], place: Carried) -> Row:
    """Return the row of a piece at its place."""
    piece = place.piece
    c0, c1, c2, c3 = piece.c
    return Row(
        law, number, k, piece, formulas, place.begin, piece.duration, c0, c1, c2, c3,
        piece.amplitude, piece.omega, piece.phase, place.s, place.v, place.ds, place.dv,
        place.position_sine, place.velocity_cosine, place.position_constant, place.position_slope,
        key(number, place.begin),
    )  # fmt: skip


def locator(rows: list[Row]) -> Pieces:
    """Return the stack as the sampled tables search it."""
    found = groupby(rows, key=lambda row: row.number)
    return Pieces({number: [row.piece for row in group] for number, group in found})
