"""The sheet of one law, laid out the same for every law."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from engine.laws import Law
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.entries.units import MM
from workbook.laws import sampling


@dataclass(frozen=True)
class PieceRow:
    """One piece as written in the books: a(u) = c0 + c1 u + P sin(ωu + φ), a formula for each entry."""

    name: str
    equation: str
    d: str
    c0: str = "=0"
    c1: str = "=0"
    P: str = "=0"
    omega: str = "=0"
    phi: str = "=0"


@dataclass(frozen=True)
class LawPage:
    """What one law puts on its sheet; ``values`` gives the engine's figures for the pieces' entries."""

    code: str
    title: str
    source: str
    pieces: tuple[PieceRow, ...]
    values: Callable[[Law], Sequence[tuple[float, ...]]]  # d, c0, c1, P, ω, φ of each piece
    parameters: Callable[[Law], list[Quantity]]
    coefficients: dict[str, tuple[str, str]]  # name of a coefficient: formula, equation in words
    workings: Callable[[Law], list[Quantity]] = lambda law: []
    checks: Callable[[Law], list[Quantity]] = lambda law: []


COEFFICIENTS = (
    ("cv", "Velocity coefficient", "C_v"),
    ("ca_max", "Acceleration coefficient", "C_a+"),
    ("ca_min", "Deceleration coefficient", "C_a−"),
    ("ca_rms", "RMS acceleration coefficient", "C_a,rms"),
    ("cj", "Jerk coefficient", "C_j"),
    ("va_max", "Largest v·a, when driving", "max(v·a)"),
    ("va_min", "Lowest v·a, when braking", "min(v·a)"),
)


def finite(value: float) -> float | str:
    """Return a number as it is, and the sign ∞ for infinity, which no cell can hold."""
    return value if math.isfinite(value) else "∞"


def piece_values(page: LawPage, law: Law) -> dict[str, list[float]]:
    """Return the engine's figures of a law's pieces by column, with ξ_k, s_k, v_k from its closed forms."""
    rows = page.values(law)
    table = {name: [float(row[i]) for row in rows] for i, name in enumerate(("d", "c0", "c1", "P", "omega", "phi"))}
    table["xi"] = [sum(table["d"][:k]) for k in range(len(rows))]
    return table


def law_sheet(
    book: Book, page: LawPage, law: Law, entered: Any, number: int, intervals: int, stack: sampling.Pieces
) -> None:
    """Declare the sheet of one law."""
    sheet = book.sheet(page.code, f"{page.title} ({page.source})")
    lift, time = entered.lift * MM, entered.time
    sheet.heading("What to enter")
    entries(sheet, page, law, entered)
    sheet.heading("What comes out: the coefficients, for unit rise and time")
    coefficients(sheet, page, law)
    sheet.heading("What comes out: the rise h in the time t_a")
    risen(sheet, page.code, law, number, lift, time)
    sheet.heading(
        "Pieces",
        "On each piece a(u) = c0 + c1 u + P sin(ωu + φ), u = ξ − ξ_k; velocity and position are carried on.",
    )
    pieces_table(sheet, page, law)
    checks(sheet, page, law)
    draw(sheet, page.code)
    sheet.row = max(sheet.row, 50)
    sheet.print_columns = 19
    sheet.heading("Table")
    samples(sheet, page.code, law, number, lift, time, intervals, stack)


def entries(sheet: Sheet, page: LawPage, law: Law, entered: Any) -> None:
    """Declare the rise that is shown, and the law's parameters."""
    code = page.code
    sheet.rows(
        given(f"{code}_h", "Rise shown", "h", "mm",
              entered.lift, f"laws.{code}.lift", source="any; a return is negative"),
        given(f"{code}_t", "Time of the rise", "t_a", "s", entered.time, f"laws.{code}.time"),
        *page.parameters(law),
    )  # fmt: skip


def coefficients(sheet: Sheet, page: LawPage, law: Law) -> None:
    """Declare the law's coefficients, and what they are worked out from."""
    for name, label, symbol in COEFFICIENTS:
        formula, words = page.coefficients[name]
        value = finite(getattr(law.coefficients, name))
        sheet.rows(result(f"{page.code}_{name}", label, symbol, "", formula, value, source=words))
    if workings := page.workings(law):
        sheet.heading("Workings")
        sheet.rows(*workings)


def risen(sheet: Sheet, code: str, law: Law, number: int, lift: float, time: float) -> None:
    """Declare the largest velocity and accelerations of the rise."""
    m, k = lift / time, law.coefficients
    sheet.rows(
        calc(f"{code}_h_m", "Rise in metres", "h", "m", f"={code}_h/1000", lift, source="h / 1000"),
        result(f"{code}_yv", "Largest velocity", "ẏ_max", "m/s",
               f"={code}_cv*ABS({code}_h_m)/{code}_t", k.cv * abs(m), source="C_v h / t_a"),
        result(
            f"{code}_ya", "Largest acceleration", "ÿ_max", "m/s²",
            f"=MAX({code}_ca_max,-{code}_ca_min)*ABS({code}_h_m)/{code}_t^2", k.ca * abs(m) / time, source="C_a h / t_a²",
        ),
        result(
            f"{code}_yrms", "RMS acceleration over the rise", "ÿ_rms", "m/s²",
            f"={code}_ca_rms*ABS({code}_h_m)/{code}_t^2", k.ca_rms * abs(m) / time, source="C_a,rms h / t_a²",
        ),
        calc(f"{code}_no", "Number on the sheet Laws", "", "", f'=MATCH("{code}",law_code,0)', number, format="0"),
    )  # fmt: skip


def checks(sheet: Sheet, page: LawPage, law: Law) -> None:
    """Declare the law's own checks, and that it ends where it should."""
    code = page.code
    ends = f"AND(ABS([{code}_samples.s.last]-1)<check_zero,ABS([{code}_samples.v.last])<check_zero)"
    sheet.checks(*page.checks(law), check(f"{code}_ends", f"{code} ends at s = 1, at rest", ends, True))


def pieces_table(sheet: Sheet, page: LawPage, law: Law) -> None:
    """Declare the law's pieces, a textbook equation beside each."""
    values = piece_values(page, law)
    rows = page.pieces
    text = {field: [getattr(r, field) for r in rows] for field in PieceRow.__dataclass_fields__}
    labels = {
        "c0": ("constant", "c0"),
        "c1": ("slope", "c1"),
        "P": ("amplitude", "P"),
        "omega": ("frequency", "ω"),
        "phi": ("phase", "φ"),
    }
    sheet.table(
        f"{page.code}_pieces", "Pieces of the law", len(rows),
        constant("name", "piece", "", "", text["name"], align="left"),
        constant("k", "number", "k", "", list(range(1, len(rows) + 1))),
        calc("xi", "begins at", "ξ_k", "", "=IF([k]=1,0,[xi-1]+[d-1])", values["xi"]),
        calc("d", "duration", "d", "", text["d"], values["d"]),
        *(calc(n, *labels[n], "", text[n], values[n]) for n in labels),
        constant("equation", "equation in the books", "", "", text["equation"], align="left"),
    )  # fmt: skip


def samples(
    sheet: Sheet, code: str, law: Law, number: int, lift: float, time: float, n: int, stack: sampling.Pieces
) -> None:
    """Declare the sampled table: ξ, s, v, a, j and the dimensional y, ẏ, ÿ."""
    xi = np.arange(n + 1) / n
    value = law.evaluate(xi)
    sheet.table(
        f"{code}_samples", "The law over ξ = t / t_a, and the rise h in the time t_a", n + 1,
        constant("k", "sample", "k", "", list(range(n + 1))),
        calc("xi", "abscissa", "ξ", "", f"=[k]/[{code}_samples.k.last]", xi, source="k / N", format="0.0000"),
        *sampling.shape(law, xi, role=result),
        result("y", "position", "y", "mm", f"={code}_h*[s]", lift / MM * value.s, scale=abs(lift / MM), source="h s"),
        result("yv", "velocity", "ẏ", "m/s", f"={code}_h_m/{code}_t*[v]", lift / time * value.v, source="h v / t_a"),
        result("ya", "acceleration", "ÿ", "m/s²",
               f"={code}_h_m/{code}_t^2*[a]", lift / time**2 * value.a, source="h a / t_a²"),
        *sampling.finding(f"{code}_no", "xi", stack.locate(number, xi)),
    )  # fmt: skip


def draw(sheet: Sheet, code: str) -> None:
    """Place the charts of s, v, a beside the figures."""
    for i, (d, name) in enumerate((("s", "position"), ("v", "velocity"), ("a", "acceleration"))):
        chart = Chart(
            f"{code}: {name} {d}(ξ)", "ξ = t / t_a", d, (Series(d, f"[{code}_samples.xi]", f"[{code}_samples.{d}]"),),
            f"Dimensionless {name} of the law {code} over the rise, from 0 to 1", (0, 1, 0.1),
        )  # fmt: skip
        sheet.chart(chart, column=14, row=5 + 15 * i, width=6, height=14)
