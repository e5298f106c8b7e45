"""The Laws sheet: every law by number, the stacked pieces of all laws, and the engineer's own law."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

from engine.laws.base import BREAK_TOLERANCE
from engine.laws.sampled import SampledPieceLaw, reach
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.entries.machine import Sizes
from workbook.laws.entries import Laws
from workbook.laws.library import NamedLaw
from workbook.laws.page import finite
from workbook.laws.pages.pieces import own_entries, own_samples
from workbook.laws.sampling import Pieces
from workbook.laws.stack import Row


def laws_sheet(
    book: Book, laws: Sequence[NamedLaw], given: Laws, sizes: Sizes, rows: list[Row], stacked: Pieces
) -> None:
    """Declare the sheet from which every axis evaluates its law."""
    own = next(one for one in laws if one.name == "OWN")
    sheet = book.sheet("Laws", "Every law as a table of pieces: a sample finds its piece by key = 2 · number + ξ_k.")
    sheet.heading(
        "What to enter: a law of your own",
        "Fill the rows below; an axis takes it as OWN. The durations sum to 1; leave spare rows empty.",
    )
    own_entries(sheet, given["OWN"], own.law, sizes.pieces)
    sheet.heading("What comes out: the laws and their coefficients")
    summary(sheet, laws)
    sheet.note(
        "C_v, C_a and max(v·a) of the own law are the greatest of its samples; C_a,rms is integrated from its pieces."
    )
    sheet.heading(
        "Workings: the stacked pieces",
        "a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ) on each piece, u = ξ − ξ_k.",
    )
    sheet.rows(
        constant("break_tolerance", "Tolerance of a break", "ε", "", BREAK_TOLERANCE, format="0E+00",
                 source="in units of ξ: a sample this near counts as on it, so that rounding never decides the side "
                        "of a jump"),
    )  # fmt: skip
    stack(sheet, rows)
    sheet.heading("Table of the own law")
    own_samples(sheet, cast(SampledPieceLaw, own.law), own.number, stacked)


def summary(sheet: Sheet, laws: Sequence[NamedLaw]) -> None:
    """Declare the table of laws: name, coefficients, values at both ends."""

    def coefficient(name: str, label: str, symbol: str) -> Quantity:
        formulas = [one.own(one.page.coefficient(name)) for one in laws]
        values = [finite(getattr(one.law.coefficients, name)) for one in laws]
        return result(name, label, symbol, "", formulas, values, format="0.0000")

    def end(d: str, label: str, at: str) -> Quantity:
        xi = 0 if at == "first" else 1
        formulas = [one.own(one.page.end(d, at)) for one in laws]
        values = [getattr(one.law.start if at == "first" else one.law.end, d) for one in laws]
        return calc(f"{d}{xi}", f"{label} at ξ = {xi}", f"{d}({xi})", "", formulas, values)

    sheet.table(
        "laws", "The laws by number; a phase takes its law by this name", len(laws),
        calc("name", "law in words", "", "",
             [one.page.name_formula(one.family.entry) for one in laws],
             [one.page.name_entered(one.family.entry, one.entered) for one in laws]),
        constant("no", "number", "", "", [one.number for one in laws]),
        calc("code", "name", "", "", [one.listed for one in laws], [one.name for one in laws]),
        coefficient("cv", "velocity coefficient", "C_v"),
        coefficient("ca_max", "acceleration coefficient", "C_a+"),
        coefficient("ca_min", "deceleration coefficient", "C_a−"),
        coefficient("ca_rms", "rms acceleration coefficient", "C_a,rms"),
        coefficient("cj", "jerk coefficient", "C_j"),
        coefficient("va_max", "largest v·a", "max(v·a)"),
        coefficient("va_min", "lowest v·a", "min(v·a)"),
        end("s", "position", "first"),
        end("s", "position", "last"),
        end("v", "velocity", "first"),
        end("v", "velocity", "last"),
        end("a", "acceleration", "first"),
        end("a", "acceleration", "last"),
        *(calc(name, f"{word} position", f"s_{end.lower()}", "",
               [one.own(one.page.reached(end)) for one in laws], [reach(one.law)[i] for one in laws])
          for i, (name, word, end) in enumerate((("low", "lowest", "MIN"), ("high", "highest", "MAX")))),
    )  # fmt: skip
    sheet.book.name(
        "laws", law_name="name", law_no="no", law_code="code",
        law_cv="cv", law_ca_max="ca_max", law_ca_min="ca_min", law_ca_rms="ca_rms", law_cj="cj",
        law_va_max="va_max", law_va_min="va_min",
        law_low="low", law_high="high", law_s0="s0", law_s1="s1", law_v0="v0", law_v1="v1", law_a0="a0", law_a1="a1",
    )  # fmt: skip


def stack(sheet: Sheet, rows: list[Row]) -> None:
    """Declare the stacked pieces: entries taken from the laws' pages, position and velocity carried on."""

    def column(name: str) -> list[Any]:
        return [getattr(row, name) for row in rows]

    def entry(name: str, label: str, symbol: str) -> Quantity:
        return calc(name, label, symbol, "", [row.formulas[name] for row in rows], column(name))

    sheet.table(
        "pieces", "Pieces of all laws", len(rows),
        calc("law", "law", "", "", "=INDEX(law_code,[number])", column("law")),
        constant("number", "number", "", "", column("number")),
        constant("k", "piece", "k", "", column("k")),
        entry("d", "duration", "d"),
        entry("c0", "constant", "c0"),
        entry("c1", "slope", "c1"),
        entry("c2", "quadratic", "c2"),
        entry("c3", "cubic", "c3"),
        entry("P", "amplitude", "P"),
        entry("omega", "frequency", "ω"),
        entry("phi", "phase", "φ"),
        calc("xi", "begins at", "ξ_k", "", "=IF([k]=1,0,[xi-1]+[d-1])", column("xi")),
        calc("ps", "sine of position", "P/ω²", "", "=IF([omega]>0,[P]/[omega]^2,0)", column("ps")),
        calc("pv", "cosine of velocity", "P/ω", "", "=IF([omega]>0,[P]/[omega],0)", column("pv")),
        calc("v", "velocity carried", "v_k", "",
             "=IF([k]=1,0,[v-1]+[dv-1])", column("v"), source="v + ∫a of the piece before"),
        calc("dv", "gain of velocity", "Δv", "",
             "=[d]*([c0]+[d]*([c1]/2+[d]*([c2]/3+[d]*[c3]/4)))-[pv]*(COS([omega]*[d]+[phi])-COS([phi]))",
             column("dv"), source="∫a over the piece"),
        calc("s", "position carried", "s_k", "",
             "=IF([k]=1,0,[s-1]+[ds-1])", column("s"), source="s + ∫v of the piece before"),
        calc("ds", "gain of position", "Δs", "",
             "=[d]*([v]+[pv]*COS([phi])+[d]*([c0]/2+[d]*([c1]/6+[d]*([c2]/12+[d]*[c3]/20))))"
             "-[ps]*(SIN([omega]*[d]+[phi])-SIN([phi]))",
             column("ds"), source="∫v over the piece"),
        calc("s0", "constant of position", "S0", "",
             "=[s]+[ps]*SIN([phi])", column("s0"), source="s_k + P/ω² sin φ"),
        calc("s1", "slope of position", "S1", "",
             "=[v]+[pv]*COS([phi])", column("s1"), source="v_k + P/ω cos φ"),
        calc("key", "key", "", "",
             "=2*[number]+MIN(1,MAX(0,[xi]))", column("key"), source="2 · number + ξ_k, within its law"),
    )  # fmt: skip
    sheet.book.keyed.add("pieces.key")
    sheet.book.name(
        "pieces", piece_law="law", piece_number="number", piece_k="k", piece_d="d",
        piece_c0="c0", piece_c1="c1", piece_c2="c2", piece_c3="c3",
        piece_P="P", piece_omega="omega", piece_phi="phi", piece_xi="xi",
        piece_ps="ps", piece_pv="pv", piece_v="v", piece_dv="dv", piece_s="s", piece_ds="ds",
        piece_s0="s0", piece_s1="s1", piece_key="key",
    )  # fmt: skip
