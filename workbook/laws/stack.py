"""The engine's figures for the stacked pieces of all laws: what the Laws sheet must hold."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

from engine.laws import Law
from workbook.entries.machine import Sizes
from workbook.laws.entries import Piece
from workbook.laws.page import piece_values
from workbook.laws.pages import PAGES
from workbook.laws.sampling import Pieces

CODES = ("DWL", *(page.code for page in PAGES), "OWN")


@dataclass(frozen=True)
class Row:
    """One row of the stack: law, number of the piece, entries of the piece, carried position and velocity."""

    law: str
    number: int
    k: int
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

    @property
    def ps(self) -> float:
        """P/ω², the amplitude of the position's sine."""
        return self.P / self.omega**2 if self.omega > 0 else 0.0

    @property
    def pv(self) -> float:
        """P/ω, the amplitude of the velocity's cosine."""
        return self.P / self.omega if self.omega > 0 else 0.0

    @property
    def s0(self) -> float:
        """Constant of the position, s_k + P/ω² sin φ."""
        return self.s + self.ps * sin(self.phi)

    @property
    def s1(self) -> float:
        """Slope of the position, v_k + P/ω cos φ."""
        return self.v + self.pv * cos(self.phi)


def stacked(library: dict[str, Law], own: list[Piece], sizes: Sizes) -> list[Row]:
    """Return the rows of the stack: Dwell, the laws with a page, then the own law with its spare rows."""
    rows = [row("DWL", 1, 1, library["DWL"], 0.0, (1.0, *(0.0,) * 7))]
    for page in PAGES:
        values = piece_values(page, library[page.code])
        number = CODES.index(page.code) + 1
        for k, xi in enumerate(values["xi"]):
            entries = (
                values["d"][k],
                values["c0"][k],
                values["c1"][k],
                0.0,
                0.0,
                values["P"][k],
                values["omega"][k],
                values["phi"][k],
            )
            rows.append(row(page.code, number, k + 1, library[page.code], xi, entries))
    reached = 0.0
    for k in range(sizes.pieces):
        p = own[k] if k < len(own) else Piece(duration=0.0)
        entries = (p.duration, p.c0, p.c1, p.c2, p.c3, p.amplitude, p.omega, p.phase)
        rows.append(row("OWN", len(CODES), k + 1, library["OWN"], reached, entries))
        reached += p.duration
    return rows


def row(code: str, number: int, k: int, law: Law, xi: float, entries: tuple[float, ...]) -> Row:
    """Return one row; what is carried and gained are differences of the law's own closed forms."""
    begin, end = law.evaluate(min(xi, 1.0)), law.evaluate(min(xi + entries[0], 1.0))
    d, c0, c1, c2, c3, amplitude, omega, phi = entries
    gains = (end.s - begin.s, end.v - begin.v)
    return Row(code, number, k, xi, d, c0, c1, c2, c3, amplitude, omega, phi, begin.s, begin.v, *gains)


def locator(rows: list[Row]) -> Pieces:
    """Return the stack as the sampled tables search it."""

    def column(name: str) -> dict[int, list[float]]:
        return {n: [getattr(r, name) for r in rows if r.number == n] for n in range(1, len(CODES) + 1)}

    return Pieces(column("xi"), column("omega"), column("phi"))
