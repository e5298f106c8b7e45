"""The engine's figures for the stacked pieces of all laws: what the Laws sheet must hold."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from engine.laws import Piece
from engine.laws.piece import POWERS
from engine.laws.table import Carried, carried, key
from workbook.entries.machine import Sizes
from workbook.laws.library import NamedLaw
from workbook.laws.sampling import Pieces


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
    c4: float
    c5: float
    P: float
    omega: float
    phi: float
    P2: float
    omega2: float
    phi2: float
    s: float
    v: float
    ds: float
    dv: float
    ps: float
    pv: float
    ps2: float
    pv2: float
    pj: float
    pj2: float
    s0: float
    s1: float
    key: float


def stacked(laws: Sequence[NamedLaw], sizes: Sizes) -> list[Row]:
    """Return the rows of the stack: the pieces of each law in the order of their numbers."""
    rows = []
    for one in laws:
        found = one.page.stacked(one.law, sizes)
        places = carried(one.law, [each.piece for each in found])
        for k, (each, place) in enumerate(zip(found, places, strict=True), 1):
            formulas = {name: one.own(text) for name, text in each.formulas.items()}
            rows.append(row(one.name, one.number, k, formulas, place))
    return rows


def row(law: str, number: int, k: int, formulas: dict[str, str], place: Carried) -> Row:
    """Return the row of a piece at its place."""
    piece = place.piece
    c0, c1, c2, c3, c4, c5 = piece.row[:POWERS]
    (ps, ps2), (pv, pv2) = place.position_sines, place.velocity_cosines
    return Row(
        law, number, k, piece, formulas, place.begin, piece.duration, c0, c1, c2, c3, c4, c5,
        piece.amplitude, piece.omega, piece.phase, piece.amplitude2, piece.omega2, piece.phase2,
        place.s, place.v, place.ds, place.dv, ps, pv, ps2, pv2, *place.jerk_cosines,
        place.position_constant, place.position_slope, key(number, place.begin),
    )  # fmt: skip


def locator(laws: Sequence[NamedLaw], rows: list[Row]) -> Pieces:
    """Return the stack as the sampled tables search it."""
    found = groupby(rows, key=lambda row: row.number)
    numbers = {id(one.law): one.number for one in laws}
    second_sine = any(one.page.second_sine for one in laws)
    return Pieces({number: [row.piece for row in group] for number, group in found}, numbers, second_sine)
