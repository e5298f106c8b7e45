"""The Laws sheet: every law by number, the stacked pieces of all laws, and the engineer's own law."""

from __future__ import annotations

from math import cos, sin
from typing import Any

import numpy as np

from engine.laws import CATALOGUE, Law
from engine.laws.base import BREAK_TOLERANCE
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, check, constant, given, result
from workbook.entries.machine import Sizes
from workbook.laws import sampling
from workbook.laws.entries import OwnLaw, Piece
from workbook.laws.page import COEFFICIENTS, finite
from workbook.laws.pages import PAGES
from workbook.laws.stack import CODES, Row, locator

ENTRIES = (
    ("c0", "constant", "c0"), ("c1", "slope", "c1"), ("c2", "quadratic", "c2"), ("c3", "cubic", "c3"),
    ("P", "amplitude", "P"), ("omega", "frequency", "ω"), ("phi", "phase", "φ"),
)  # fmt: skip
OWN_KEYS = {"d": "duration", "P": "amplitude", "omega": "omega", "phi": "phase"}


def laws_sheet(book: Book, library: dict[str, Law], own: OwnLaw, sizes: Sizes, rows: list[Row]) -> None:
    """Declare the sheet from which every axis evaluates its law."""
    sheet = book.sheet("Laws", "Every law as a table of pieces: a sample finds its piece by key = 2 · number + ξ_k.")
    sheet.heading(
        "What to enter: a law of your own",
        "Fill the rows below; an axis takes it as OWN. The durations sum to 1; leave spare rows empty.",
    )
    sheet.rows(given("own_name", "Name of the own law", "", "", own.name, "laws.OWN.name"))
    own_table(sheet, own, sizes)
    sheet.checks(
        check("own_sum", "OWN: the durations sum to 1", "ABS(SUM([own_pieces.d])-1)<check_zero", True),
        check(
            "own_reaches",
            "OWN: the law reaches s = 1",
            "ABS([own_samples.s.last]-1)<check_zero",
            bool(abs(library["OWN"].end.s - 1) < 1e-9),
        ),
        check(
            "own_rests",
            "OWN: the law ends at rest",
            "ABS([own_samples.v.last])<check_zero",
            bool(abs(library["OWN"].end.v) < 1e-9),
        ),
    )
    sheet.heading("What comes out: the laws and their coefficients")
    summary(sheet, library, own)
    sheet.heading(
        "Workings: the stacked pieces",
        "a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ) on each piece, u = ξ − ξ_k.",
    )
    sheet.rows(
        constant(
            "break_tolerance",
            "Tolerance of a break",
            "ε",
            "",
            BREAK_TOLERANCE,
            format="0E+00",
            source="in units of ξ: a sample this near counts as on it, so that rounding never decides the side of a jump",
        )
    )
    stack(sheet, rows, sizes)
    sheet.heading("Table of the own law")
    own_samples(sheet, library["OWN"], locator(rows), sizes.own_law)


def own_table(sheet: Sheet, own: OwnLaw, sizes: Sizes) -> None:
    """Declare the block that the engineer fills with a law of his own."""
    n = sizes.pieces

    def entries(name: str) -> list[Any]:
        return [getattr(p, OWN_KEYS.get(name, name)) for p in own.pieces] + [None] * (n - len(own.pieces))

    value = own_workings(own, n)
    sheet.table(
        "own_pieces", "Pieces of the own law; as delivered, the polynomial 3-4-5", n,
        constant("k", "piece", "k", "", list(range(1, n + 1))),
        given("d", "duration", "d", "", entries("d"), "laws.OWN.pieces.*.duration", format="0.0000"),
        *(given(q, label, s, "",
                entries(q), f"laws.OWN.pieces.*.{OWN_KEYS.get(q, q)}", format="General") for q, label, s in ENTRIES),
        calc("a0", "a at its begin", "", "", "=[c0]+[P]*SIN([phi])", value["a0"]),
        calc("a1", "a at its end", "", "",
             "=[c0]+[d]*([c1]+[d]*([c2]+[d]*[c3]))+[P]*SIN([omega]*[d]+[phi])", value["a1"]),
        calc("reached", "a reached", "", "", "=IF([d]>0,[a1],IF([k]=1,0,[reached-1]))", value["reached"]),
        calc("jump", "jump of a", "", "", "=IF([d]>0,ABS([a0]-IF([k]=1,0,[reached-1])),0)", value["jump"]),
        calc("poly2", "∫ of polynomial²", "", "", POLYNOMIAL_SQUARED, value["poly2"]),
        calc("cross", "∫ of 2 · polynomial · sine", "", "", CROSS, value["cross"]),
        calc("sine2", "∫ of sine²", "", "", SINE_SQUARED, value["sine2"]),
    )  # fmt: skip


POLYNOMIAL_SQUARED = (
    "=[d]*([c0]^2+[d]*([c0]*[c1]+[d]*(([c1]^2+2*[c0]*[c2])/3+[d]*(([c0]*[c3]+[c1]*[c2])/2"
    "+[d]*(([c2]^2+2*[c1]*[c3])/5+[d]*([c2]*[c3]/3+[d]*[c3]^2/7))))))"
)
SINE_SQUARED = "=IF([omega]>0,[P]^2*([d]/2-(SIN(2*([omega]*[d]+[phi]))-SIN(2*[phi]))/(4*[omega])),0)"
CROSS = (
    "=IF([omega]>0,2*[P]*("
    "-(([a1]-[P]*SIN([omega]*[d]+[phi]))*COS([omega]*[d]+[phi])-[c0]*COS([phi]))/[omega]"
    "+(([c1]+[d]*(2*[c2]+3*[d]*[c3]))*SIN([omega]*[d]+[phi])-[c1]*SIN([phi]))/[omega]^2"
    "+((2*[c2]+6*[d]*[c3])*COS([omega]*[d]+[phi])-2*[c2]*COS([phi]))/[omega]^3"
    "-6*[c3]*(SIN([omega]*[d]+[phi])-SIN([phi]))/[omega]^4),0)"
)


def own_workings(own: OwnLaw, rows: int) -> dict[str, list[float]]:
    """Return the engine's side of the own law's workings: values at the ends, integrals by Gauss-Legendre."""
    nodes, weights = np.polynomial.legendre.leggauss(48)
    names = ("a0", "a1", "reached", "jump", "poly2", "cross", "sine2")
    table: dict[str, list[float]] = {name: [] for name in names}
    reached = 0.0
    for p in [*own.pieces, *[Piece(duration=0.0)] * (rows - len(own.pieces))]:
        u = p.duration * (nodes + 1) / 2
        polynomial = np.polynomial.Polynomial([p.c0, p.c1, p.c2, p.c3])
        c, sine = polynomial(u), p.amplitude * np.sin(p.omega * u + p.phase)
        w = p.duration * weights / 2
        begin = p.c0 + p.amplitude * sin(p.phase)
        end = float(polynomial(p.duration)) + p.amplitude * sin(p.omega * p.duration + p.phase)
        jump = abs(begin - reached) if p.duration > 0 else 0.0
        reached = end if p.duration > 0 else reached
        row = (begin, end, reached, jump, float(w @ c**2), float(2 * w @ (c * sine)), float(w @ sine**2))
        for name, value in zip(names, row, strict=True):
            table[name].append(value)
    return table


def summary(sheet: Sheet, library: dict[str, Law], own: OwnLaw) -> None:
    """Declare the table of laws: code, name, coefficients, values at both ends."""
    names = {entry.code: entry.name for entry in CATALOGUE}
    pages = [page.code for page in PAGES]

    def from_pages(name: str, of_own: str) -> list[str]:
        return ["=0", *(f"={code}_{name}" for code in pages), of_own]

    def coefficient(name: str) -> list[Any]:
        return [finite(getattr(library[c].coefficients, name)) for c in CODES]

    own_formulas = {
        "cv": "=MAX(MAX([own_samples.v]),-MIN([own_samples.v]))",
        "ca_max": "=MAX([own_samples.a])",
        "ca_min": "=MIN([own_samples.a])",
        "ca_rms": "=SQRT(SUM([own_pieces.poly2])+SUM([own_pieces.cross])+SUM([own_pieces.sine2]))",
        "cj": '=IF(MAX(MAX([own_pieces.jump]),ABS([own_pieces.reached.last]))>check_zero,"∞",MAX(MAX([own_samples.j]),-MIN([own_samples.j])))',
        "va_max": "=MAX([own_samples.va])",
        "va_min": "=MIN([own_samples.va])",
    }
    ends = [
        calc(f"{d}{i}", f"{label} at ξ = {i}", f"{d}({i})", "",
             ["=0", *(f"=[{code}_samples.{d}.{at}]" for code in (*pages, "own"))],
             [getattr(getattr(library[c], end), d) for c in CODES])
        for d, label in (("s", "position"), ("v", "velocity"), ("a", "acceleration"))
        for i, at, end in ((0, "first", "start"), (1, "last", "end"))
    ]  # fmt: skip
    block = sheet.table(
        "laws", "The laws by number; an axis names its law by code", len(CODES),
        calc("name", "name", "", "", ['="Dwell"', *(f'="{names[c]}"' for c in pages), "=own_name"],
             ["Dwell", *(names[c] for c in pages), own.name]),
        constant("no", "number", "", "", list(range(1, len(CODES) + 1))),
        constant("code", "code", "", "", list(CODES)),
        *(result(n, label.split(",")[0].lower(), symbol, "",
                 from_pages(n, own_formulas[n]), coefficient(n), format="0.0000")
          for n, label, symbol in COEFFICIENTS),
        *ends,
    )  # fmt: skip
    sheet.book.name_columns(block, "law")
    sheet.note(
        "C_v, C_a and max(v·a) of the own law are the greatest of its samples; C_a,rms is integrated from its pieces."
    )


def stack(sheet: Sheet, rows: list[Row], sizes: Sizes) -> None:
    """Declare the stacked pieces: entries taken from the laws' pages, position and velocity carried on."""
    where = [(f"{r.law}_pieces" if r.law != "OWN" else "own_pieces", r.k) for r in rows]

    def linked(name: str) -> list[str]:
        found = []
        for r, (table, k) in zip(rows, where, strict=True):
            if r.law == "DWL" or (r.law != "OWN" and name in ("c2", "c3")):
                found.append("=1" if name == "d" else "=0")
            else:
                found.append(f"=[{table}.{name}.{k}]")
        return found

    block = sheet.table(
        "pieces", "Pieces of all laws", len(rows),
        constant("law", "law", "", "", [r.law for r in rows]),
        constant("number", "number", "", "", [r.number for r in rows]),
        constant("k", "piece", "k", "", [r.k for r in rows]),
        calc("d", "duration", "d", "", linked("d"), [r.d for r in rows]),
        *(calc(n, label, s, "", linked(n), [getattr(r, n) for r in rows]) for n, label, s in ENTRIES),
        calc("xi", "begins at", "ξ_k", "", "=IF([k]=1,0,[xi-1]+[d-1])", [r.xi for r in rows]),
        calc("ps", "sine of position", "P/ω²", "", "=IF([omega]>0,[P]/[omega]^2,0)", [r.ps for r in rows]),
        calc("pv", "cosine of velocity", "P/ω", "", "=IF([omega]>0,[P]/[omega],0)", [r.pv for r in rows]),
        calc("v", "velocity carried", "v_k", "",
             "=IF([k]=1,0,[v-1]+[dv-1])", [r.v for r in rows], source="v + ∫a of the piece before"),
        calc("dv", "gain of velocity", "Δv", "", GAIN_V, [r.dv for r in rows], source="∫a over the piece"),
        calc("s", "position carried", "s_k", "",
             "=IF([k]=1,0,[s-1]+[ds-1])", [r.s for r in rows], source="s + ∫v of the piece before"),
        calc("ds", "gain of position", "Δs", "", GAIN_S, [r.ds for r in rows], source="∫v over the piece"),
        calc("s0", "constant of position", "S0", "",
             "=[s]+[ps]*SIN([phi])", [r.s + r.ps * sin(r.phi) for r in rows], source="s_k + P/ω² sin φ"),
        calc("s1", "slope of position", "S1", "",
             "=[v]+[pv]*COS([phi])", [r.v + r.pv * cos(r.phi) for r in rows], source="v_k + P/ω cos φ"),
        calc("key", "key", "", "", "=2*[number]+[xi]", [2 * r.number + r.xi for r in rows], source="2 · number + ξ_k"),
    )  # fmt: skip
    sheet.book.name_columns(block, "piece")


GAIN_V = "=[d]*([c0]+[d]*([c1]/2+[d]*([c2]/3+[d]*[c3]/4)))-[pv]*(COS([omega]*[d]+[phi])-COS([phi]))"
GAIN_S = (
    "=[d]*([v]+[pv]*COS([phi])+[d]*([c0]/2+[d]*([c1]/6+[d]*([c2]/12+[d]*[c3]/20))))"
    "-[ps]*(SIN([omega]*[d]+[phi])-SIN([phi]))"
)


def own_samples(sheet: Sheet, law: Law, pieces: sampling.Pieces, n: int) -> None:
    """Declare the sampled own law and its charts."""
    xi = np.arange(n + 1) / n
    at = law.evaluate(xi)
    sheet.chart_row(
        *(Chart(f"OWN: {name} {d}(ξ)", "ξ = t / t_a", d, (Series(d, "[own_samples.xi]", f"[own_samples.{d}]"),),
                f"Dimensionless {name} of the engineer's own law over the rise", (0, 1, 0.1))
          for d, name in (("s", "position"), ("v", "velocity"), ("a", "acceleration"))),
    )  # fmt: skip
    sheet.rows(calc("OWN_no", "Number of the own law", "", "", '=MATCH("OWN",law_code,0)', len(CODES), format="0"))
    sheet.table(
        "own_samples", "The own law over ξ", n + 1,
        constant("k", "sample", "k", "", list(range(n + 1))),
        calc("xi", "abscissa", "ξ", "", "=[k]/[own_samples.k.last]", xi, source="k / N", format="0.0000"),
        *sampling.shape(law, xi, role=result),
        calc("va", "v · a", "", "", "=[v]*[a]", at.v * at.a),
        *sampling.finding("OWN_no", "xi", pieces.locate(len(CODES), xi)),
    )  # fmt: skip
