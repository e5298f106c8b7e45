"""Pages of laws of rest, a straight line, a pulse and the same backwards, a polynomial, two sines."""

from engine.laws import Dwell
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, SimpleHarmonic, StraightLine
from workbook.book.cell_tables import cell_tables
from workbook.laws.edged import FLAT, HALF_SINE, LINE_IN, SINE_IN, Stage, edged
from workbook.laws.family import (
    COEFFICIENTS,
    POLYNOMIAL,
    REVERSAL,
    SHARED,
    Page,
    PieceRow,
    Reversal,
    coefficients_in,
    parameters_of,
    pieces_in,
)

CELLS = cell_tables(__file__)

DWELL = Page(
    source="S3, function motionlaw",
    entries=None,
    law=Dwell,
    has_sheet=False,
    pieces=(PieceRow("rest", "s = 0", "=1"),),
    coefficients={name: ("=0", "at rest") for name, *_ in COEFFICIENTS},
    fastest="=0",
    end_mode="=-1",
)

STRAIGHT_LINE = Page(
    source="LCamHdl, CONST_VELO",
    law=StraightLine,
    pieces=(PieceRow("straight line", "s = ξ", "=1"),),
    coefficients={name: ("=0", "no acceleration") for name, *_ in COEFFICIENTS} | {"cv": ("=1", "v = 1")},
    fastest="=0",
    start="=1",
    lowest="=1",
    rests=False,
    end_mode="=-1",
    single=False,
)

CUBIC = "S1, S3: the cubic that starts and ends at rest; with λ: LCamHdl, POLY_3"
HALVED = [  # by the stage of a pulse, and of the same backwards
    edged({k: Stage(form, "=@share"), 8 - k: Stage(form, "=1-@share")}, source=source, **SHARED, law=law, end_mode=mode)
    for law, form, k, mode, source in (
        (ConstantAcceleration, FLAT, 2, "=1", "S3, figure 1; with λ: LCamHdl, D_D_PARABOLA"),
        (Cycloidal, HALF_SINE, 2, "=1", "S2, movement equation; S3; with λ: LCamHdl, D_D_INCLINED_SINE"),
        (SimpleHarmonic, SINE_IN, 3, "=1", "LCamHdl, D_D_BASIC_SINE: s = (1 − cos πξ)/2"),
        (Cubic, LINE_IN, 3, POLYNOMIAL.format(3), CUBIC),
    )
]

POLYNOMIAL_345 = Page(
    source="LCamHdl, POLY_5; mechdesigner.support, 'Polynomial 3-4-5'",
    law=Polynomial345,
    fastest="=@share",
    end_mode=POLYNOMIAL.format(5),
    **SHARED,
    pieces=pieces_in(CELLS["polynomial 3-4-5: pieces"]),
    coefficients=coefficients_in(CELLS["polynomial 3-4-5: coefficients"]),
)

POLYNOMIAL_4567 = Page(
    source="LCamHdl, POLY_7; mechdesigner.support, 'Polynomial 4-5-6-7'",
    law=Polynomial4567,
    fastest="=@share",
    end_mode=POLYNOMIAL.format(7),
    **SHARED,
    pieces=pieces_in(CELLS["polynomial 4-5-6-7: pieces"]),
    coefficients=coefficients_in(CELLS["polynomial 4-5-6-7: coefficients"]),
)

DOUBLE_HARMONIC = Page(
    source="LCamHdl, D_R_DOUBLE_HARMONIC; saltire.com, cam functions",
    law=DoubleHarmonic,
    entries=parameters_of(DoubleHarmonic, reversal=Reversal),
    parameters=(REVERSAL,),
    variations=({"reversal": "start"}, {"reversal": "end"}),
    fastest='=IF(@reversal="end",2/3,1/3)',
    pieces=pieces_in(CELLS["double harmonic: pieces"]),
    coefficients=coefficients_in(CELLS["double harmonic: coefficients"]),
)
