"""The columns of a sampled motion: which piece a sample has, and y, y', y'', y''' by one formula each."""

from collections.abc import Sequence
from math import perm

from engine.laws.base import Array
from engine.motion.pieces import MotionPiece
from workbook.book.declare import Quantity, calc
from workbook.book.polynomial import LEAST, NOT_ZERO, polynomial
from workbook.motion.cells import PieceRows
from workbook.motion.pieces import amplitude, from_power

POSITION = "c0 + c1 u + … + A sin ζ"
SINES = "+{}*SIN({})", "+{}*COS({})", "-{}*SIN({})", "-{}*COS({})"  # the same by the amplitude of each derivative
FROM_START = "from its start; never 0, so that u⁰ is 1"


def finding(rows: PieceRows, x: str, values: Array, of: str = "", suffix: str = "") -> list[Quantity]:
    """Return the workings of samples: the piece, u in it, and the argument of its sine.

    ``x`` is the column that holds the abscissa, ``values`` what it is in units of the motion; labels begin with ``of``
    and names end with ``suffix``.
    """
    at, found = rows.at, rows.found(values)
    q = f"q{suffix}"
    local = f"[{x}]-INDEX({at.named('origin' if at.opens else 'at')},[{q}])"
    return [
        calc(q, f"{of}piece", "q", "",
             f"={at.piece(x)}", found.row, format="0", source="last start at or below"),
        calc(f"u{suffix}", f"{of}within piece", "u", at.x,
             f"={f'RADIANS({local})' if at.degrees else local}{NOT_ZERO}", found.u + LEAST, source=FROM_START),
        *arguments(rows, suffix, f"[{q}]", found.angles, of),
    ]  # fmt: skip


def arguments(
    rows: PieceRows, suffix: str, q: str, angles: Sequence[Sequence[float] | Array], of: str = ""
) -> list[Quantity]:  # fmt: skip
    """Return the columns of the arguments of the sines at places u of pieces, whose row ``q`` names."""
    return [
        calc(f"x{mark}{suffix}", f"{of}argument of the {which}sine", "ζ", "rad",
             f"={of_row(rows, f'om{mark}', q)}*[u{suffix}]+{of_row(rows, f'ph{mark}', q)}", angles[k],
             source="ωu + φ")
        for k, ((*_, mark), which) in enumerate(zip(rows.sines, ("", "second "), strict=False))
    ]  # fmt: skip


def of_row(rows: PieceRows, name: str, q: str) -> str:
    """Return the formula of a figure of a piece, whose row ``q`` names; where it is empty, of that of the same row."""
    if q:
        return f"INDEX({rows.at.named(name)},{q})"
    return f"[{rows.at.pieces}.{name}.same]"


def sampled(rows: PieceRows, order: int, suffix: str = "") -> str:
    """Return the formula, without its =, of a derivative at a sample: coefficients times powers of u, and sines."""
    return at_place(rows, order, suffix, f"[q{suffix}]")


def place_columns(
    rows: PieceRows, suffix: str, of: str, formula: str, u: Array, pieces: Sequence[MotionPiece], q: str = ""
) -> list[Quantity]:  # fmt: skip
    """Return the columns of a place in each piece, that ``formula`` gives: u, and the arguments of the sines.

    ``q`` names the row of the piece; where it is empty, it is the piece of the same row.
    """
    both = list(zip(pieces, u, strict=True))
    angles = [[one.sines[k][1] * place + one.sines[k][2] for one, place in both] for k in range(len(rows.sines))]
    return [
        calc(f"u{suffix}", f"{of}: u", "u", rows.at.x, f"{formula}{NOT_ZERO}", u + LEAST, scale=rows.end,
             source=FROM_START),
        *arguments(rows, suffix, q, angles, f"{of}: "),
    ]  # fmt: skip


def at_place(rows: PieceRows, order: int, suffix: str, q: str = "") -> str:
    """Return the formula, without its =, of a derivative at a place in a piece, whose row ``q`` names."""
    name, last = from_power(order), rows.powers - 1
    several = f"INDEX({rows.at.named(name)},{q},0)" if q else of_row(rows, f"c{order}:c{last}", q)
    text = polynomial(several, f"[u{suffix}]", rows.powers, order)
    for *_, mark in rows.sines:
        text += SINES[order].format(of_row(rows, amplitude(order, mark), q), f"[x{mark}{suffix}]")
    return text


def at_begin(rows: PieceRows, order: int) -> str:
    """Return the formula, without its =, of a derivative where the piece of the same row begins."""
    factor = perm(order, order)
    text = f"{factor}*" if factor > 1 else ""
    text += of_row(rows, f"c{order}", "")
    for *_, mark in rows.sines:
        text += SINES[order].format(*(of_row(rows, name, "") for name in (amplitude(order, mark), f"ph{mark}")))
    return text.removeprefix("+")
