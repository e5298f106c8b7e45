"""The columns of a sampled motion: which piece a sample has, and y, y', y'', y''' by one formula each."""

from __future__ import annotations

from math import perm

from engine.laws.base import Array
from workbook.book.declare import Quantity, calc
from workbook.motion.cells import Cells, PieceRows

POSITION = "c0 + c1 u + … + A sin x"
TURNED = ("+{A}*SIN({x})", "+{A}*{om}*COS({x})", "-{A}*{om}^2*SIN({x})", "-{A}*{om}^3*COS({x})")
"""a sine A sin(ωu + φ) and its derivatives by u"""


def finding(rows: PieceRows, x: str, values: Array, of: str = "", suffix: str = "") -> list[Quantity]:
    """Return the workings of samples: the piece, u in it, and the argument of its sine.

    ``x`` is the column that holds the abscissa, ``values`` what it is in units of the motion; labels begin with ``of``
    and names end with ``suffix``.
    """
    at, found = rows.at, rows.found(values)
    q, local = f"q{suffix}", f"[{x}]-{at.of_piece('origin' if at.opens else 'begin', f'q{suffix}')}"
    return [
        calc(q, f"{of}piece", "q", "",
             f"={at.piece(x)}", found.row, format="0", source="last start at or below"),
        calc(f"u{suffix}", f"{of}within piece", "u", at.x,
             f"=RADIANS({local})" if at.degrees else f"={local}", found.u, source="from its start"),
        calc(f"x{suffix}", f"{of}sine argument", "x", "rad",
             f"={at.of_piece('om', q)}*[u{suffix}]+{at.of_piece('ph', q)}", found.angle, source="ωu + φ"),
    ]  # fmt: skip


def derivative(rows: PieceRows, order: int, suffix: str = "", place: str = "") -> str:
    """Return the formula, without its =, of a derivative of the motion: 0 is y; at another ``place`` of its piece."""
    at, q, u = rows.at, f"q{suffix}", place or f"[u{suffix}]"
    text = ""
    for i in range(rows.powers - 1, order - 1, -1):
        share = perm(i, order)
        term = at.of_piece(f"c{i}", q)
        scaled = term if share == 1 else f"{share}*{term}"
        text = f"{scaled}+{u}*({text})" if text else scaled
    if place:
        return text + "".join(_turned(at, order, mark, q, u) for *_, mark in rows.sines)
    return text + "".join(_sine(at, order, mark, q, u, suffix) for *_, mark in rows.sines)


def in_piece(rows: PieceRows, order: int, u: str) -> str:
    """Return the formula, without its =, of a derivative of a piece in its own row; ``u`` is empty at its begin."""
    text, highest = "", rows.powers - 1 if u else order
    for i in range(highest, order - 1, -1):
        share = perm(i, order)
        scaled = f"[c{i}]" if share == 1 else f"{share}*[c{i}]"
        text = f"{scaled}+{u}*({text})" if text else scaled
    for *_, mark in rows.sines:
        x = f"[om{mark}]*{u}+[ph{mark}]" if u else f"[ph{mark}]"
        text += TURNED[order].format(A=f"[A{mark}]", om=f"[om{mark}]", x=x)
    return f"({text})"


def _turned(at: Cells, order: int, mark: str, q: str, u: str) -> str:
    a, om, ph = (at.of_piece(f"{name}{mark}", q) for name in ("A", "om", "ph"))
    return TURNED[order].format(A=a, om=om, x=f"{om}*{u}+{ph}")


def _sine(at: Cells, order: int, mark: str, q: str, u: str, suffix: str) -> str:
    a, om, ph = (at.of_piece(f"{name}{mark}", q) for name in ("A", "om", "ph"))
    x = f"{om}*{u}+{ph}" if mark else f"[x{suffix}]"
    return TURNED[order].format(A=a, om=om, x=x)
