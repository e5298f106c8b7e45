"""Pages of laws of rest, one straight line, one pulse and the same backwards, a polynomial, two sines."""

from engine.laws import Dwell
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, SimpleHarmonic, StraightLine
from workbook.laws.edged import FLAT, HALF_SINE, LINE_IN, SINE_IN, Stage, edged
from workbook.laws.family import COEFFICIENTS, POLYNOMIAL, REVERSAL, SHARED, Page, PieceRow, Reversal, parameters_of

DWELL = Page(
    source="S3, function motionlaw", entries=None, law=Dwell, has_sheet=False,
    pieces=(PieceRow("rest", "s = 0", "=1"),),
    coefficients={name: ("=0", "at rest") for name, *_ in COEFFICIENTS}, fastest="=0", end_mode="=-1",
)  # fmt: skip

STRAIGHT_LINE = Page(
    source="LCamHdl, CONST_VELO", law=StraightLine, pieces=(PieceRow("straight line", "s = ξ", "=1"),),
    coefficients={name: ("=0", "no acceleration") for name, *_ in COEFFICIENTS} | {"cv": ("=1", "v = 1")},
    fastest="=0", start="=1", lowest="=1", rests=False, end_mode="=-1", single=False,
)  # fmt: skip

HALVED = [  # by the stage of one pulse, and of the same backwards
    edged({k: Stage(form, "=@share"), 8 - k: Stage(form, "=1-@share")}, source=source, **SHARED, law=law, end_mode=mode)
    for law, form, k, mode, source in (
        (ConstantAcceleration, FLAT, 2, "=1", "S3, figure 1; with λ: LCamHdl, D_D_PARABOLA"),
        (Cycloidal, HALF_SINE, 2, "=1", "S2, movement equation; S3; with λ: LCamHdl, D_D_INCLINED_SINE"),
        (SimpleHarmonic, SINE_IN, 3, "=1", "LCamHdl, D_D_BASIC_SINE: s = (1 − cos πξ)/2"),
        (Cubic, LINE_IN, 3, POLYNOMIAL.format(3),
         "S1, S3: the cubic that starts and ends at rest; with λ: LCamHdl, POLY_3"),
    )
]  # fmt: skip

POLYNOMIAL_345 = Page(
    source="LCamHdl, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'", **SHARED, law=Polynomial345,
    pieces=(
        PieceRow("a rises", "s = 2λ S(ξ/2λ), S = 10x³ − 15x⁴ + 6x⁵", "=@share*(1-1/SQRT(3))",
                 c1="=15/@share^2", c2="=0-45/(2*@share^3)", c3="=15/(2*@share^4)"),
        PieceRow("a falls", "the same from its peak, x = (3 − √3)/6", "=@share/SQRT(3)",
                 c0="=5/(SQRT(3)*@share)", c2="=0-15*SQRT(3)/(2*@share^3)", c3="=15/(2*@share^4)"),
        PieceRow("−a rises", "s = 1 − 2μ S((1 − ξ)/2μ), μ = 1 − λ", "=(1-@share)/SQRT(3)",
                 c1="=0-15/(2*(1-@share)^2)", c3="=15/(2*(1-@share)^4)"),
        PieceRow("−a falls", "the same from its peak", "=(1-@share)*(1-1/SQRT(3))",
                 c0="=0-5/(SQRT(3)*(1-@share))", c2="=15*SQRT(3)/(2*(1-@share)^3)", c3="=15/(2*(1-@share)^4)"),
    ),
    coefficients={
        "cv": ("=15/8", "S' = 30x²(1 − x)² at x = ½"),
        "ca_max": ("=5/(SQRT(3)*@share)", "S''/2λ at x = (3 − √3)/6"),
        "ca_min": ("=0-5/(SQRT(3)*(1-@share))", "by symmetry, over 2μ"),
        "ca_rms": ("=SQRT(30/(7*@share*(1-@share)))", "√(30/7λμ)"),
        "cj": ("=15/MIN(@share,1-@share)^2", "S'''/4λ² or /4μ² at an end"),
        "va_max": ("=6075/(686*SQRT(7)*@share)", "S'S''/2λ at x = (7 − √7)/14"),
        "va_min": ("=0-6075/(686*SQRT(7)*(1-@share))", "by symmetry, over 2μ"),
    },
    fastest="=@share", end_mode=POLYNOMIAL.format(5),
)  # fmt: skip

POLYNOMIAL_4567 = Page(
    source="LCamHdl, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'", **SHARED, law=Polynomial4567,
    pieces=(
        PieceRow("a rises", "s = 2λ S(ξ/2λ), S = 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷", "=@share*(1-1/SQRT(5))",
                 c2="=105/(2*@share^3)", c3="=0-105/@share^4", c4="=525/(8*@share^5)", c5="=0-105/(8*@share^6)"),
        PieceRow("a falls", "the same from its peak, x = (5 − √5)/10", "=@share/SQRT(5)", c0="=42/(5*SQRT(5)*@share)",
                 c2="=0-21*SQRT(5)/(2*@share^3)", c4="=105*SQRT(5)/(8*@share^5)", c5="=0-105/(8*@share^6)"),
        PieceRow("−a rises", "s = 1 − 2μ S((1 − ξ)/2μ), μ = 1 − λ", "=(1-@share)/SQRT(5)",
                 c1="=0-105/(8*(1-@share)^2)", c3="=105/(4*(1-@share)^4)", c5="=0-105/(8*(1-@share)^6)"),
        PieceRow("−a falls", "the same from its peak", "=(1-@share)*(1-1/SQRT(5))", c0="=0-42/(5*SQRT(5)*(1-@share))",
                 c2="=21*SQRT(5)/(2*(1-@share)^3)", c4="=0-105*SQRT(5)/(8*(1-@share)^5)", c5="=0-105/(8*(1-@share)^6)"),
    ),
    coefficients={
        "cv": ("=35/16", "S' = 140x³(1 − x)³ at x = ½"),
        "ca_max": ("=42/(5*SQRT(5)*@share)", "S''/2λ at x = (5 − √5)/10"),
        "ca_min": ("=0-42/(5*SQRT(5)*(1-@share))", "by symmetry, over 2μ"),
        "ca_rms": ("=SQRT(70/(11*@share*(1-@share)))", "√(70/11λμ)"),
        "cj": ("=105/(8*MIN(@share,1-@share)^2)", "S'''/4λ² or /4μ² in the middle"),
        "va_max": ("=58800/2048*(10/11)^5/(SQRT(11)*@share)", "S'S''/2λ at x = (11 − √11)/22"),
        "va_min": ("=0-58800/2048*(10/11)^5/(SQRT(11)*(1-@share))", "by symmetry, over 2μ"),
    },
    fastest="=@share", end_mode=POLYNOMIAL.format(7),
)  # fmt: skip


ENDS = 'IF(@reversal="end",{0},{1})'
PEAK = "ATAN2(1,SQRT(15))/PI()"  # where the acceleration at the end at rest is largest: cos πξ = ¼
POWER = "675*SQRT(15)*PI()^3/8192"

DOUBLE_HARMONIC = Page(
    source="LCamHdl, D_R_DOUBLE_HARMONIC; saltire.com, cam functions", law=DoubleHarmonic,
    entries=parameters_of(DoubleHarmonic, reversal=Reversal),
    parameters=(REVERSAL,), variations=({"reversal": "start"}, {"reversal": "end"}),
    pieces=(
        PieceRow(
            "two sines", "sin⁴(πξ/2), or mirrored", f"={ENDS.format(PEAK, f'1-{PEAK}')}",
            P="=PI()^2/2", omega="=PI()", phi=f"={ENDS.format('PI()/2', '0-3*PI()/2')}",
            P2="=0-PI()^2/2", omega2="=2*PI()", phi2=f"={ENDS.format('PI()/2', '0-5*PI()/2')}",
        ),
        PieceRow(
            "the same", "from where cos πξ = ¼, or mirrored", f"={ENDS.format(f'1-{PEAK}', PEAK)}",
            P="=PI()^2/2", omega="=PI()", phi="=[phi-1]+[omega-1]*[d-1]",
            P2="=0-PI()^2/2", omega2="=2*PI()", phi2="=[phi2-1]+[omega2-1]*[d-1]",
        ),
    ),
    coefficients={
        "cv": ("=3*SQRT(3)*PI()/8", "2π sin³x cos x at x = π/3, x = πξ/2"),
        "ca_max": (f"={ENDS.format('9*PI()^2/16', 'PI()^2')}", "where cos πξ = ¼; at the reversal π²"),
        "ca_min": (f"=0-{ENDS.format('PI()^2', '9*PI()^2/16')}", "the same, of the other end"),
        "ca_rms": ("=PI()^2/2", "of two sines of π²/2 each"),
        "cj": ('="∞"', "the acceleration jumps at the reversal, unless its mirror follows"),
        "va_max": (f"={ENDS.format('PI()^3/4', POWER)}", "at ξ = ½, or where cos πξ = 7/8"),
        "va_min": (f"=0-{ENDS.format(POWER, 'PI()^3/4')}", "the same, of the other end"),
    },
    fastest=f"={ENDS.format('2/3', '1/3')}",
)  # fmt: skip
