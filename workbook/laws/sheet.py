"""The Laws sheet: every law by number, and the stacked pieces of all laws."""

from collections.abc import Sequence
from typing import Any

from engine.laws.base import BREAK_TOLERANCE
from engine.laws.points import reach, slowest
from engine.motion.handover import end_mode
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, result
from workbook.book.polynomial import LEAST
from workbook.entries.machine import Sizes
from workbook.laws.brief import LEAST_STAGE
from workbook.laws.library import NamedLaw
from workbook.laws.page import finite
from workbook.laws.sampling import Pieces
from workbook.laws.stack import Row

RISE = 1.0
"""what every law goes in a time of 1: so large are its velocity and acceleration at least, somewhere"""


def laws_sheet(
    book: Book, laws: Sequence[NamedLaw], sizes: Sizes, rows: list[Row], stacked: Pieces, hands_over: bool = False
) -> None:
    """Declare the sheet from which every axis evaluates its law; ``hands_over`` where phases hand over at speed."""
    sheet = book.sheet("Laws", "Every law as a table of pieces: a sample finds its piece by key = 2 · number + ξ_k.")
    sheet.heading("Results: the laws and their coefficients")
    summary(sheet, laws, sizes, hands_over)
    sheet.heading(
        "Workings: the stacked pieces",
        "a(u) = c0 + c1 u + … + c5 u⁵ + P sin(ωu + φ) on each piece, u = ξ − ξ_k.",
    )
    sheet.rows(
        constant("break_tolerance", "Tolerance of a break", "ε", "", BREAK_TOLERANCE, format="0E+00",
                 source="in units of ξ: a sample this close is taken as on it, so that rounding never decides the side "
                        "of a jump"),
        constant("u_least", "Least place in a piece", "u", "s, rad", LEAST, format="0E+00",
                 source="added to each, so that u⁰ is 1 at its begin too: Excel has no 0^0"),
        constant("stage_least", "Least stage of a law", "", "", LEAST_STAGE, format="0E+00",
                 source="as a share of the rise; a stage is none, or lasts so long"),
    )  # fmt: skip
    stack(sheet, rows, stacked.second_sine)


COEFFICIENTS = (
    ("cv", "velocity coefficient", "C_v"),
    ("ca_max", "acceleration coefficient", "C_a+"),
    ("ca_min", "deceleration coefficient", "C_a−"),
    ("ca_rms", "rms acceleration coefficient", "C_a,rms"),
    ("cj", "jerk coefficient", "C_j"),
    ("va_max", "largest v·a", "max(v·a)"),
    ("va_min", "lowest v·a", "min(v·a)"),
)
"""of a law: name, label and symbol of each"""
ENDS = (("s", "position"), ("v", "velocity"), ("a", "acceleration"))


def summary(sheet: Sheet, laws: Sequence[NamedLaw], sizes: Sizes, hands_over: bool) -> None:
    """Declare the table of laws: name, coefficients, values at both ends."""
    ends, reaches = meeting(laws) if hands_over else [], [reach(one.law) for one in laws]

    def coefficient(name: str, label: str, symbol: str) -> Quantity:
        formulas = [one.own(one.page.coefficient(name)) for one in laws]
        values = [finite(getattr(one.law.coefficients, name)) for one in laws]
        return result(name, label, symbol, "", formulas, values, format="0.0000")

    def end(d: str, label: str, at: str) -> Quantity:
        xi = 0 if at == "first" else 1
        formulas = [one.own(one.page.end(d, at)) for one in laws]
        values = [getattr(one.law.start if at == "first" else one.law.end, d) for one in laws]
        return calc(f"{d}{xi}", f"{label} at ξ = {xi}", f"{d}({xi})", "", formulas, values, scale=RISE)

    sheet.table(
        "laws", "The laws by number; a phase takes its law by this name", len(laws),
        calc("name", "law in words", "", "",
             [one.own(one.page.name_formula(one.family.entry)) for one in laws],
             [one.page.name_entered(one.family.entry, one.entered) for one in laws]),
        constant("no", "number", "", "", [one.number for one in laws]),
        calc("code", "name", "", "", [one.listed for one in laws], [one.name for one in laws]),
        *(coefficient(*one) for one in COEFFICIENTS),
        calc("start", "velocity it begins with", "", "",
             [one.own(one.page.start) for one in laws], [one.law.start.v for one in laws]),
        calc("v_low", "lowest velocity", "", "",
             [one.own(one.page.lowest) for one in laws],
             [slowest(one.law) for one in laws], scale=1.0),
        calc("wrong", "step of v the wrong way", "", "",
             [one.own(one.page.wrong) for one in laws], [one.page.stepping(one.law, sizes) for one in laws]),
        *(end(d, label, at) for d, label in ENDS for at in ("first", "last")),
        *(calc(name, f"{word} position", f"s_{end.lower()}", "",
               [one.own(one.page.reached(end)) for one in laws],
               [one[i] for one in reaches], scale=1.0)
          for i, (name, word, end) in enumerate((("low", "lowest", "MIN"), ("high", "highest", "MAX")))),
        *ends,
    )  # fmt: skip
    sheet.book.name(
        "laws", law_name="name", law_no="no", law_code="code",
        law_cv="cv", law_ca_max="ca_max", law_ca_min="ca_min", law_ca_rms="ca_rms", law_cj="cj",
        law_va_max="va_max", law_va_min="va_min", law_start="start", law_v_low="v_low", law_wrong="wrong",
        law_low="low", law_high="high", law_s0="s0", law_s1="s1", law_v0="v0", law_v1="v1", law_a0="a0", law_a1="a1",
        **({"law_way": "way", "law_early": "early"} if ends else {}),
    )  # fmt: skip


def meeting(laws: Sequence[NamedLaw]) -> list[Quantity]:
    """Return the columns of how laws meet neighbours that hand velocity over to them."""
    return [
        calc("way", "meets its neighbours' velocity", "", "",
             [one.own(one.page.way) for one in laws], [end_mode(one.law) for one in laws], format="0",
             source="−1 has one, 0 cannot, 1 by two pulses, 2 keeps its own, 3, 5, 7 by a polynomial"),
        constant("early", "pieces of its first pulse", "", "", [one.page.early for one in laws]),
    ]  # fmt: skip


SECOND = {"piece_P2": "P2", "piece_omega2": "omega2", "piece_phi2": "phi2", "piece_ps2": "ps2", "piece_pv2": "pv2",
          "piece_pj2": "pj2"}  # fmt: skip
"""names of the columns of a second sine"""
GAINED = "=SUMPRODUCT([c0:c5]/{1,2,3,4,5,6},[d]^{1,2,3,4,5,6})-[pv]*(COS([omega]*[d]+[phi])-COS([phi]))"
TURNED2 = "-[pv2]*(COS([omega2]*[d]+[phi2])-COS([phi2]))"
TRAVELLED = "=[s0]-[s]+SUMPRODUCT([s1:c5]/{1,2,6,12,20,30,42},[d]^{1,2,3,4,5,6,7})-[ps]*SIN([omega]*[d]+[phi])"
SWUNG2 = "-[ps2]*SIN([omega2]*[d]+[phi2])"


POWERS = ("constant", "slope", "quadratic", "cubic", "quartic", "quintic")
"""what the coefficients of a piece's acceleration are called"""


def amplitudes(rows: list[Row], second: bool) -> list[Quantity]:
    """Return the amplitudes of the sines in position, velocity and jerk."""
    first = [
        ("ps", "sine of position", "P/ω²", "=IF([omega]>0,[P]/[omega]^2,0)"),
        ("pv", "cosine of velocity", "P/ω", "=IF([omega]>0,[P]/[omega],0)"),
        ("pj", "cosine of jerk", "P ω", "=[P]*[omega]"),
    ]
    other = [
        ("pj2", "second cosine of jerk", "P₂ ω₂", "=[P2]*[omega2]"),
        ("ps2", "second sine of position", "P₂/ω₂²", "=IF([omega2]>0,[P2]/[omega2]^2,0)"),
        ("pv2", "second cosine of velocity", "P₂/ω₂", "=IF([omega2]>0,[P2]/[omega2],0)"),
    ]
    return [
        calc(name, label, symbol, "", formula, [getattr(row, name) for row in rows])
        for name, label, symbol, formula in (*first, *(other if second else []))
    ]


def carried(rows: list[Row], second: bool) -> list[Quantity]:
    """Return velocity and position with which each piece begins, and what it adds to them."""
    gained, travelled = (one + more if second else one for one, more in ((GAINED, TURNED2), (TRAVELLED, SWUNG2)))

    def column(name: str) -> list[float]:
        return [getattr(row, name) for row in rows]

    return [
        calc("v", "velocity carried", "v_k", "",
             "=IF([k]=1,INDEX(law_start,[number]),[v-1]+[dv-1])", column("v"), source="v + ∫a of the piece before"),
        calc("dv", "gain of velocity", "Δv", "", gained, column("dv"), source="∫a over the piece"),
        calc("s", "position carried", "s_k", "",
             "=IF([k]=1,0,[s-1]+[ds-1])", column("s"), source="s + ∫v of the piece before"),
        calc("ds", "gain of position", "Δs", "", travelled, column("ds"), scale=RISE, source="∫v over the piece"),
    ]  # fmt: skip


def stack(sheet: Sheet, rows: list[Row], second: bool) -> None:
    """Declare the stacked pieces, entries taken from the laws' pages; ``second`` adds the columns of a second sine."""

    def column(name: str) -> list[Any]:
        return [getattr(row, name) for row in rows]

    def entry(name: str, label: str, symbol: str) -> Quantity:
        return calc(name, label, symbol, "", [row.formulas[name] for row in rows], column(name))

    def only(*quantities: Quantity) -> tuple[Quantity, ...]:
        return quantities if second else ()

    def both(formula: str, added: str) -> str:
        return formula + added if second else formula

    sheet.table(
        "pieces", "Pieces of all laws", len(rows),
        calc("law", "law", "", "", "=INDEX(law_code,[number])", column("law")),
        constant("number", "number", "", "", column("number")),
        constant("k", "piece", "k", "", column("k")),
        entry("d", "duration", "d"),
        calc("s0", "constant of position", "S0", "",
             both("=[s]+[ps]*SIN([phi])", "+[ps2]*SIN([phi2])"), column("s0"), source="s_k + P/ω² sin φ"),
        calc("s1", "slope of position", "S1", "",
             both("=[v]+[pv]*COS([phi])", "+[pv2]*COS([phi2])"), column("s1"), source="v_k + P/ω cos φ"),
        *(entry(f"c{power}", label, f"c{power}") for power, label in enumerate(POWERS)),
        entry("P", "amplitude", "P"),
        entry("omega", "frequency", "ω"),
        entry("phi", "phase", "φ"),
        *only(
            entry("P2", "second amplitude", "P₂"),
            entry("omega2", "its frequency", "ω₂"),
            entry("phi2", "its phase", "φ₂"),
        ),
        calc("xi", "begins at", "ξ_k", "", "=IF([k]=1,0,[xi-1]+[d-1])", column("xi")),
        *amplitudes(rows, second),
        *carried(rows, second),
        calc("key", "key", "", "",
             "=2*[number]+MIN(1,MAX(0,[xi]))", column("key"), source="2 · number + ξ_k, within its law"),
    )  # fmt: skip
    sheet.book.keyed.add("pieces.key")
    sheet.book.name(
        "pieces", piece_law="law", piece_number="number", piece_k="k", piece_d="d",
        piece_c0="c0", piece_c1="c1", piece_c2="c2", piece_c3="c3", piece_c4="c4", piece_c5="c5",
        piece_P="P", piece_omega="omega", piece_phi="phi", piece_xi="xi",
        piece_ps="ps", piece_pv="pv", piece_pj="pj", piece_v="v", piece_dv="dv", piece_s="s", piece_ds="ds",
        piece_key="key", piece_y="s0:c5", piece_dy="s1:c5", piece_ddy="c0:c5", piece_dddy="c1:c5",
        **(SECOND if second else {}),
    )  # fmt: skip
