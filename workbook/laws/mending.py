"""By how much an own law misses its rise and rest, and its entries scaled so that it does not."""

from collections.abc import Sequence

from engine import laws as engine
from engine.laws import Law
from engine.laws.mended import ALIKE, Groups, groups, misses
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled

EITHER = (
    "=IF(OR(MAX([@mend.slow])>0,@v_up>@least),IF(ABS(@under)>@least_under,{0}/@under,0),"
    "IF(@s_up>@alike*MAX([@mend.size]),1/@s_up,0))"
)
"""a factor: of two groups, or, where nothing slows down, of all"""
WORTH = '=IF(MIN(@up,@down)>@alike*MAX(@up,@down),"yes","no: it should speed up, then slow down")'


def missing(sheet: Sheet, law: Law, n: int) -> None:
    """Declare by how much the law misses its rise and rest, and the entries scaled so that it does not."""
    pieces = filled(law.as_pieces(), n, engine.Piece(0.0))
    found, off = groups(pieces), misses(pieces)
    up, down = found.factors
    factors = [down if slow else up for slow in found.slows]
    sheet.row += 1
    sheet.heading("By how much it misses", "And its entries scaled so that it reaches 1 at rest.")
    sheet.rows(
        result("@miss_s", "It misses its rise by", "s(1) − 1", "", "=[@samples.s.last]-1", off.s, format="0.0000####"),
        result("@miss_v", "and rest by", "v(1)", "", "=[@samples.v.last]", off.v, format="0.0000####"),
        result("@mends", "Do two factors mend it?", "", "",
               WORTH, "yes" if found.mends else "no: it should speed up, then slow down", align="left"),
        result("@up", "Factor of the pieces that gain velocity", "α", "", EITHER.format("@v_down"), up),
        result("@down", "Factor of those that lose it", "β", "", EITHER.format("(0-@v_up)"), down),
        *sums(found),
    )  # fmt: skip
    row = "@first+[k]-1"

    def scaled(name: str, label: str, symbol: str, values: Sequence[float]) -> Quantity:
        formula = f"=[factor]*INDEX([@pieces.{name}],[k])"
        return result(
            name,
            label,
            symbol,
            "",
            formula,
            [f * value for f, value in zip(factors, values, strict=True)],
            format="General",
        )

    sheet.table(
        "@mend", "The entries scaled: durations, frequencies and phases stay", n,
        constant("k", "piece", "k", "", list(range(1, n + 1))),
        *(scaled(f"c{i}", f"scaled c{i}", f"c{i}", [piece.c[i] for piece in pieces]) for i in range(4)),
        scaled("P", "scaled amplitude", "P", [piece.amplitude for piece in pieces]),
        calc("factor", "factor", "", "", "=IF([slow]=1,@down,@up)", factors),
        calc("gain_v", "adds to v(1)", "", "", f"=INDEX(piece_dv,{row})", [v for _, v in found.gained]),
        calc("gain_s", "adds to s(1)", "", "",
             f"=INDEX(piece_ds,{row})-INDEX(piece_v,{row})*INDEX(piece_d,{row})"
             f"+[gain_v]*(SUM([@pieces.d])-INDEX(piece_xi,{row})-INDEX(piece_d,{row}))",
             [s for s, _ in found.gained], source="∬a over it, and ∫a over the time that follows"),
        calc("d", "duration", "d", "", "=INDEX([@pieces.d],[k])", [piece.duration for piece in pieces]),
        calc("size", "size", "", "",
             "=[d]*(ABS(INDEX([@pieces.c0],[k]))+[d]*(ABS(INDEX([@pieces.c1],[k]))+[d]*(ABS(INDEX([@pieces.c2],[k]))"
             "+[d]*ABS(INDEX([@pieces.c3],[k]))))+ABS(INDEX([@pieces.P],[k])))", found.sizes),
        calc("slow", "loses velocity", "", "",
             "=IF([gain_v]<0-@least,1,0)", [float(slow) for slow in found.slows], format="0"),
        blank='INDEX([@pieces.d],[k])=""',
    )  # fmt: skip


def sums(found: Groups) -> list[Quantity]:
    """Return the rows of what the pieces of each group add, and what counts as none."""
    return [
        calc("@least", "A velocity below this is none", "", "",
             "=1E-12*MAX([@mend.size])", found.least, format="0E+00"),
        constant("@alike", "Share of the largest below which travels and factors are none", "", "", ALIKE,
                 format="0E+00"),
        calc("@s_up", "Travel of those that gain", "S⁺", "",
             "=SUMPRODUCT(1-[@mend.slow],[@mend.gain_s])", found.s1),
        calc("@v_up", "Velocity that they gain", "V⁺", "", "=SUMPRODUCT(1-[@mend.slow],[@mend.gain_v])", found.v1),
        calc("@s_down", "Travel of those that lose", "S⁻", "", "=SUMPRODUCT([@mend.slow],[@mend.gain_s])", found.s2),
        calc("@v_down", "Velocity that they lose", "V⁻", "", "=SUMPRODUCT([@mend.slow],[@mend.gain_v])", found.v2),
        calc("@under", "Determinant", "", "", "=@s_up*@v_down-@s_down*@v_up", found.under, source="S⁺V⁻ − S⁻V⁺"),
        calc("@least_under", "A determinant below this is none", "", "", "=@alike*MAX([@mend.size])^2",
             found.least_under, format="0E+00"),
    ]  # fmt: skip
