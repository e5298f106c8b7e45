"""The engineer's own law, piece by piece: it stands on the sheet Laws."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import Field

from engine import laws as engine
from engine.laws import Entry, Law, PieceLaw
from engine.laws.piece_integrals import ends, squares
from engine.laws.sampled import SampledPieceLaw, abscissae
from workbook.book.chart import Chart, Series
from workbook.book.checks import ZERO
from workbook.book.declare import Quantity, RowRule, Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import amount, figure
from workbook.entries.texts import Text
from workbook.entries.types import SMALLEST, SUM_TOLERANCE, DesignError, Model, NotNegative, Number
from workbook.laws import sampling
from workbook.laws.family import ENTRIES, Page, ShapeFormulas, Stacked


class Piece(Model):
    """One piece of the engineer's own law: a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ)."""

    duration: NotNegative
    c0: Number = 0.0
    c1: Number = 0.0
    c2: Number = 0.0
    c3: Number = 0.0
    amplitude: Number = 0.0
    omega: NotNegative = 0.0
    phase: Number = 0.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a sine without a frequency."""
        if self.amplitude and not self.omega:
            yield DesignError("omega", TURNING.words, TURNING.rule, 1.0)
        if 0 < self.omega < SMALLEST:
            yield DesignError("omega", SLOW.words, SLOW.rule, 1.0)

    @property
    def made(self) -> engine.Piece:
        """The engine's piece."""
        polynomial = (self.c0, self.c1, self.c2, self.c3)
        return engine.Piece(self.duration, polynomial, self.amplitude, self.omega, self.phase)


TURNING = RowRule("turning", "OR([P]+0=0,[omega]+0<>0)", "omega", "ω of a sine, expected more than 0")
SLOW = RowRule("slow", f"OR([omega]+0<=0,[omega]+0>={SMALLEST!r})", "omega", "ω, too small")


class OwnLaw(Model):
    """The engineer's own law, piece by piece; the default is the polynomial 3-4-5."""

    name: Text = "Polynomial 3-4-5"
    pieces: list[Piece] = Field(default=[Piece(duration=1.0, c1=60.0, c2=-180.0, c3=120.0)])

    def design_faults(self) -> Iterator[DesignError]:
        """Yield pieces that do not fill the rise."""
        total = sum(piece.duration for piece in self.pieces)
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("pieces", f"they sum to {figure(total)}; expected 1", "sum", [POLYNOMIAL_345])

    @property
    def made(self) -> list[engine.Piece]:
        """The engine's pieces."""
        return [piece.made for piece in self.pieces]

    @property
    def exact(self) -> PieceLaw:
        """The engine's law, with its exact coefficients."""
        return PieceLaw(self.made)


POLYNOMIAL_345 = {"duration": 1.0, "c1": 60.0, "c2": -180.0, "c3": 120.0}
VARIATIONS = (
    {"pieces": [POLYNOMIAL_345]},
    {"pieces": [
        {"duration": 0.4, "c0": 3.0, "c1": 1.5, "c2": -2.0, "c3": 0.7, "amplitude": 1.2, "omega": 7.0, "phase": 0.4},
        {"duration": 0.35, "c0": -1.0, "amplitude": 2.0, "omega": 3.0, "phase": 1.1},
        {"duration": 0.25, "c0": -2.0, "c2": 4.0},
    ]},
    {"pieces": [
        {"duration": 0.5, "amplitude": 6.5, "omega": 6.0},
        {"duration": 0.5, "amplitude": -6.0, "omega": 6.5, "phase": 0.1},
    ]},
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class OwnPage(Page):
    """The page of an own law: any number of pieces, entered one by one, with the coefficients of its samples."""

    def law(self, entered: OwnLaw, intervals: int) -> Law:
        """Return the engine's law, with the coefficients of a table of ``intervals``."""
        return SampledPieceLaw(entered.made, intervals)

    def law_of(self, numbers: Sequence[float]) -> Law:
        """Return the law of pieces in a row, eight numbers each: duration, c0, c1, c2, c3, P, ω, φ."""
        rows = np.array(numbers).reshape(-1, len(ENTRIES)).tolist()
        return PieceLaw([engine.Piece(d, (a, b, c, e), *sine) for d, a, b, c, e, *sine in rows])

    def numbers(self, entered: OwnLaw) -> list[float]:
        """Return the pieces in a row, eight numbers each."""
        return [float(value) for piece in entered.pieces for value in piece.model_dump().values()]

    def variation(self, k: int, room: int) -> dict[str, Any]:
        """Return the ``k``-th of other pieces, round and round; where they do not find room, a single one."""
        found = super().variation(k, room)
        return found if len(found["pieces"]) <= room else dict(VARIATIONS[0])

    def name_formula(self, entry: Entry) -> str:
        """Return the formula of the name that is entered."""
        return "=own_name"

    def name_entered(self, entry: Entry, entered: OwnLaw) -> str:
        """Return the name that is entered."""
        return entered.name

    def reached(self, end: str) -> str:
        """Return the formula of the lowest or the highest s: of its samples."""
        return f"={end}([{self.samples}.s])"

    def stacked(self, law: Law, room: int) -> list[Stacked]:
        """Return the rows of the stack: the table of the own law, spare rows and all."""
        pieces = filled(law.as_pieces(), room, engine.Piece(0.0))
        return [
            Stacked(piece, {name: f"=[own_pieces.{name}.{k}]" for name in ENTRIES}) for k, piece in enumerate(pieces, 1)
        ]

    def require_complete(self, entry: Entry) -> None:
        """Accept it: its pieces are what is entered."""


PAGE = OwnPage(
    title="Own law",
    source="entered piece by piece",
    entries=OwnLaw,
    made=lambda entered: entered.exact,
    has_sheet=False,
    samples="own_samples",
    pieces=(),
    coefficients={
        "cv": ("=MAX(MAX([own_samples.v]),-MIN([own_samples.v]))", "of its samples"),
        "ca_max": ("=MAX([own_samples.a])", "of its samples"),
        "ca_min": ("=MIN([own_samples.a])", "of its samples"),
        "ca_rms": ("=SQRT(SUM([own_pieces.poly2])+SUM([own_pieces.cross])+SUM([own_pieces.sine2]))", "exact"),
        "cj": (
            '=IF(MAX(MAX([own_pieces.jump]),ABS([own_pieces.reached.last]))>check_zero,"∞",'
            "MAX(MAX([own_samples.j]),-MIN([own_samples.j])))",
            "of its samples; ∞ where the acceleration jumps",
        ),
        "va_max": ("=MAX([own_samples.va])", "of its samples"),
        "va_min": ("=MIN([own_samples.va])", "of its samples"),
    },
    fastest="=MIN([own_fast.at])",  # the table of a sheet that asks where the laws are fastest
    shapes=ShapeFormulas(),  # none: what needs them sums its samples instead
    variations=VARIATIONS,
)

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


def own_entries(sheet: Sheet, own: OwnLaw, law: Law, room: int) -> None:
    """Declare the block that the engineer fills with a law of his own, and its checks."""
    sheet.rows(given("own_name", "Name of the own law", "", "", own.name, "laws.OWN.name"))
    own_table(sheet, own, room)
    sheet.checks(
        check("own_sum", "OWN: the durations sum to 1", "ABS(SUM([own_pieces.d])-1)<check_zero", True,
              rule="laws.OWN:sum", says='"they sum to "&ROUND(SUM([own_pieces.d]),9)&"; expected 1"'),
        check("own_reaches", "OWN: the law reaches s = 1",
              "ABS([own_samples.s.last]-1)<check_zero", abs(law.end.s - 1) < ZERO,
              says=amount("[own_samples.s.last]", law.end.s, "s(1) = ", "")),
        check("own_rests", "OWN: the law ends at rest",
              "ABS([own_samples.v.last])<check_zero", abs(law.end.v) < ZERO,
              says=amount("[own_samples.v.last]", law.end.v, "v(1) = ", "")),
    )  # fmt: skip


def own_table(sheet: Sheet, own: OwnLaw, n: int) -> None:
    """Declare the table of pieces."""

    def entry(name: str, label: str, symbol: str, key: str) -> Quantity:
        values = filled([getattr(piece, key) for piece in own.pieces], n, None)
        digits = "0.0000" if name == "d" else "General"
        return given(name, label, symbol, "", values, f"laws.OWN.pieces.*.{key}", format=digits)

    pieces = filled(own.made, n, engine.Piece(0.0))
    at, square = ends(pieces), [squares(piece) for piece in pieces]
    sheet.table(
        "own_pieces", "Pieces of the own law; as delivered, the polynomial 3-4-5", n,
        constant("k", "piece", "k", "", list(range(1, n + 1))),
        entry("d", "duration", "d", "duration"),
        entry("c0", "constant", "c0", "c0"),
        entry("c1", "slope", "c1", "c1"),
        entry("c2", "quadratic", "c2", "c2"),
        entry("c3", "cubic", "c3", "c3"),
        entry("P", "amplitude", "P", "amplitude"),
        entry("omega", "frequency", "ω", "omega"),
        entry("phi", "phase", "φ", "phase"),
        calc("a0", "a at its begin", "", "", "=[c0]+[P]*SIN([phi])", [row.begin for row in at]),
        calc("a1", "a at its end", "", "",
             "=[c0]+[d]*([c1]+[d]*([c2]+[d]*[c3]))+[P]*SIN([omega]*[d]+[phi])", [row.end for row in at]),
        calc("reached", "a reached", "", "",
             "=IF([d]>0,[a1],IF([k]=1,0,[reached-1]))", [row.reached for row in at]),
        calc("jump", "jump of a", "", "",
             "=IF([d]>0,ABS([a0]-IF([k]=1,0,[reached-1])),0)", [row.jump for row in at]),
        calc("poly2", "∫ of polynomial²", "", "", POLYNOMIAL_SQUARED, [row.polynomial for row in square]),
        calc("cross", "∫ of 2 · polynomial · sine", "", "", CROSS, [row.cross for row in square]),
        calc("sine2", "∫ of sine²", "", "", SINE_SQUARED, [row.sine for row in square]),
        rules=[TURNING, SLOW],
    )  # fmt: skip


def own_samples(sheet: Sheet, law: SampledPieceLaw, number: int, pieces: sampling.Pieces) -> None:
    """Declare the sampled own law and its charts."""
    n = law.intervals
    xi = abscissae(n)
    sheet.chart_row(
        *(Chart(f"OWN: {name} {d}(ξ)", "ξ = t / t_a", d, (Series(d, "[own_samples.xi]", f"[own_samples.{d}]"),),
                f"Dimensionless {name} of the engineer's own law over the rise", (0, 1, 0.1))
          for d, name in (("s", "position"), ("v", "velocity"), ("a", "acceleration"))),
    )  # fmt: skip
    sheet.rows(calc("OWN_no", "Number of the own law", "", "", '=MATCH("OWN",law_code,0)', number, format="0"))
    sheet.table(
        "own_samples", "The own law over ξ", n + 1,
        constant("k", "sample", "k", "", list(range(n + 1))),
        calc("xi", "abscissa", "ξ", "", "=[k]/[own_samples.k.last]", xi, source="k / N", format="0.0000"),
        *sampling.shape(law, xi, role=result),
        calc("va", "v · a", "", "", "=[v]*[a]", law.powers),
        *sampling.finding("OWN_no", "xi", pieces.locate(number, xi)),
    )  # fmt: skip
