"""What each law promises, with its default parameters, and the parameters at which it is measured."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields

from engine.laws import Law
from engine.laws.base import Coefficients
from engine.laws.ends import BoundaryValues
from engine.laws.modified import (
    HarmonicCombination,
    ModifiedSine,
    ModifiedTrapezoidal,
    SineConstantCosine,
    SineStraightSine,
    TrapezoidByShare,
)
from engine.laws.piece import Piece
from engine.laws.pieces import PieceLaw
from engine.laws.polynomials import Cubic, Polynomial345, Polynomial4567
from engine.laws.ramps import SCurve, SineRamps, TrapezoidalVelocity
from engine.laws.simple import ConstantAcceleration, Cycloidal, DoubleHarmonic, Dwell, SimpleHarmonic, StraightLine
from engine.laws.spline import EXAMPLE, Spline


@dataclass(frozen=True)
class Claims:
    """What a law promises, with its default parameters; one test measures every claim of every law.

    ``orders`` are the highest derivatives of s that are continuous, at the ends against rest and between them. The
    coefficients are formulas in Python's notation, over the functions of ``math``, the names in ``where`` and the
    coefficients before. ``others`` are the law with other parameters, stages of no duration among them; ``beyond``
    those between prescribed ends, and with parameters that its page does not enter. A parameter that none of them
    changes raises TypeError: figures that do not follow it would pass for right.
    """

    law: type[Law]
    orders: tuple[float, float]
    coefficients: str
    where: Mapping[str, str] = field(default_factory=dict)
    start: tuple[float, float] = (0.0, 0.0)  # s, v
    end: tuple[float, float] = (1.0, 0.0)
    others: tuple[Law, ...] = ()
    beyond: tuple[Law, ...] = ()

    def __post_init__(self):
        if lacks := [f.name for f in fields(Coefficients) if f.name not in self.formulas]:
            raise TypeError(f"{self.law.__name__}: lacks the claim of {', '.join(lacks)}")
        example, more = self.law(), (*self.others, *self.beyond)
        parameters = [f.name for f in fields(self.law)]
        if lacks := [p for p in parameters if all(getattr(one, p) == getattr(example, p) for one in more)]:
            raise TypeError(f"{self.law.__name__}: lacks among its other examples one with another {', '.join(lacks)}")

    @property
    def code(self):
        return self.law.code

    @property
    def examples(self):
        """The law with its default parameters, then with others."""
        return (self.law(), *self.others)

    @property
    def formulas(self):
        """Formulas by their names, of a text like "cv = 3/2; ca_max = 6"."""
        return {name: formula for name, _, formula in (one.partition(" = ") for one in self.coefficients.split("; "))}


MIXED = (
    Piece(0.3, amplitude=6.0, omega=5.0),
    Piece(0.0, (9.0, 0.0, 0.0, 0.0)),
    Piece(0.2, (6.0, -30.0, 2.0, 0.0), amplitude=1.0, omega=9.0, phase=0.4),
    Piece(0.5, (-4.0, 8.0, 0.0, 0.0)),
)
"""a polynomial and a sine in one piece, a piece of no duration; it ends neither at 1 nor at rest"""
WAVE = ((0.0, 0.0), (0.1, 0.4), (0.3, -0.2), (0.32, -0.2), (0.8, 1.3), (0.97, 0.9), (1.0, 1.0))

TRAPEZOID = {
    "where": {"y": "2/(1 + pi + sqrt((1 + pi)**2 + 8))"},
    "coefficients": "cv = 2; ca_max = 8*pi/(2 + pi); ca_min = -ca_max; ca_rms = ca_max*sqrt(3)/2; cj = 4*pi*ca_max; "
    "va_max = ca_max**2/(4*pi)*(1 + pi + y)*sqrt(1 - y**2); va_min = -va_max",
}
CLAIMS = (
    Claims(
        ConstantAcceleration,
        orders=(1, 1),
        coefficients="cv = 2; ca_max = 4; ca_min = -4; ca_rms = 4; cj = inf; va_max = 8; va_min = -8",
        others=(ConstantAcceleration(0.3),),
        beyond=(ConstantAcceleration(0.6, ends=BoundaryValues(1.0, 0.4, -0.2)),),
    ),
    Claims(
        Cycloidal,
        orders=(2, math.inf),
        coefficients="cv = 2; ca_max = 2*pi; ca_min = -2*pi; ca_rms = pi*sqrt(2); cj = 4*pi**2; "
        "va_max = 3*sqrt(3)*pi/2; va_min = -3*sqrt(3)*pi/2",
        others=(Cycloidal(0.3),),
        beyond=(Cycloidal(0.6, ends=BoundaryValues(1.0, 0.8, -0.3)),),
    ),
    Claims(
        SimpleHarmonic,
        orders=(1, math.inf),
        coefficients="cv = pi/2; ca_max = pi**2/2; ca_min = -ca_max; ca_rms = pi**2/(2*sqrt(2)); cj = inf; "
        "va_max = pi**3/8; va_min = -va_max",
        others=(SimpleHarmonic(0.3),),
        beyond=(SimpleHarmonic(0.6, ends=BoundaryValues(1.0, 0.3, 1.2)),),
    ),
    Claims(
        TrapezoidalVelocity,
        orders=(1, 1),
        coefficients="cv = 3/2; ca_max = 9/2; ca_min = -9/2; ca_rms = 9/2*sqrt(2/3); cj = inf; "
        "va_max = 27/4; va_min = -va_max",
        others=(TrapezoidalVelocity(0.1, 0.7), TrapezoidalVelocity(0.45, 0.45), TrapezoidalVelocity(0.02, 0.98)),
        beyond=(TrapezoidalVelocity(0.2, 0.7, ends=BoundaryValues(0.5, 1.0, 0.3)),),
    ),
    Claims(
        SineRamps,
        orders=(2, 2),
        coefficients="cv = 4/3; ca_max = 8*pi/3; ca_min = -ca_max; ca_rms = 4*pi/3; cj = 32*pi**2/3; "
        "va_max = 4*sqrt(3)*pi/3; va_min = -va_max",
        others=(SineRamps(0.2, 0.7), SineRamps(0.4, 0.4)),
        beyond=(SineRamps(0.2, 0.7, ends=BoundaryValues(1.0, 1.5, -0.3)),),
    ),
    Claims(
        SCurve,
        orders=(2, 2),
        coefficients="cv = 3/2; ca_max = 6; ca_min = -6; ca_rms = 4; cj = 72; va_max = 15/2; va_min = -15/2",
        others=(
            SCurve((0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2)),
            SCurve((0.25, 0.0, 0.25, 0.0, 0.25, 0.0, 0.25)),
            SCurve((0.0, 0.2, 0.2, 0.1, 0.3, 0.2, 0.0)),
        ),
        beyond=(SCurve((0.05, 0.2, 0.1, 0.15, 0.2, 0.1, 0.2), ends=BoundaryValues(-1.0, 0.5, 1.5)),),
    ),
    Claims(
        ModifiedTrapezoidal,
        orders=(2, 3),
        **TRAPEZOID,
        others=tuple(
            ModifiedTrapezoidal(durations)
            for durations in (
                (0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1),
                (0.3, 0.0, 0.25, 0.1, 0.15, 0.0, 0.2),
                (0.0, 0.2, 0.2, 0.0, 0.25, 0.35, 0.0),
                (0.0, 0.0, 0.4, 0.1, 0.0, 0.5, 0.0),
            )
        ),
        beyond=(ModifiedTrapezoidal((0.05, 0.15, 0.05, 0.3, 0.1, 0.25, 0.1), ends=BoundaryValues(2.0, 1.0, -0.5)),),
    ),
    Claims(
        TrapezoidByShare,
        orders=(2, 3),
        **TRAPEZOID,
        others=(TrapezoidByShare(0.3), TrapezoidByShare(0.5, "end"), TrapezoidByShare(0.3, "start", 0.7)),
        beyond=(TrapezoidByShare(0.4, ends=BoundaryValues(1.0, 0.6, 1.1)),),
    ),
    Claims(
        ModifiedSine,
        orders=(2, 3),
        where={"n": "2*pi**2/(4 + pi)", "y": "(sqrt(73) - 1)/12"},
        coefficients="cv = 4*pi/(4 + pi); ca_max = 2*n; ca_min = -ca_max; ca_rms = sqrt(2)*n; cj = 8*pi*n; "
        "va_max = n**2/pi*(1 + 3*y)*sqrt(1 - y**2); va_min = -va_max",
        others=(ModifiedSine(0.3), ModifiedSine(0.3, 0.25, 0.4), ModifiedSine(0.6, 0.0, 1.0)),
        beyond=(ModifiedSine(0.4, ends=BoundaryValues(1.0, 2.0, -0.5)),),
    ),
    Claims(
        SineConstantCosine,
        orders=(2, 3),
        where={"k": "(1/pi + 1/2)/3", "g": "1/(3*pi)", "y": "2*g/(k + sqrt(k**2 + 8*g**2))"},
        coefficients="ca_max = 4*pi**2/(pi**2 - 2*pi*(pi - 2)/3); cv = ca_max*(2/(3*pi) + 1/6); ca_min = -ca_max; "
        "ca_rms = ca_max*sqrt(2/3); cj = 3*pi*ca_max; va_max = ca_max**2*(k + g*y)*sqrt(1 - y**2); "
        "va_min = -va_max",
        others=(SineConstantCosine(0.1, 0.6, 0.3), SineConstantCosine(0.2, 0.0, 0.6, 0.2, 0.4)),
        beyond=(SineConstantCosine(0.1, 0.2, 0.3, 0.4, 0.6, ends=BoundaryValues(1.0, -0.4, 0.9)),),
    ),
    Claims(
        HarmonicCombination,
        orders=(1, 2),
        where={"d": "6 + pi/2", "y": "(sqrt(73) - 1)/12"},
        coefficients="cv = 4*pi/d; ca_max = 4*pi**2/d; ca_min = -ca_max; ca_rms = 2*pi**2*sqrt(2)/d; cj = inf; "
        "va_max = ca_max**2/(4*pi)*(1 + 3*y)*sqrt(1 - y**2); va_min = cv*ca_min/2",
        others=(HarmonicCombination(0.3), HarmonicCombination(0.6, "start")),
        beyond=(
            HarmonicCombination(0.4, "end", ends=BoundaryValues(1.0, 0.7)),
            HarmonicCombination(0.4, "start", ends=BoundaryValues(1.0, 0.1, 0.7)),
        ),
    ),
    Claims(
        SineStraightSine,
        orders=(1, 2),
        coefficients="cv = 2*pi/(2 + pi); ca_max = 2*pi*cv; ca_min = -ca_max; ca_rms = pi*cv; cj = inf; "
        "va_max = ca_max*cv/2; va_min = -va_max",
        others=(SineStraightSine(0.3, 0.4), SineStraightSine(1.0)),
        beyond=(SineStraightSine(0.3, 0.4, ends=BoundaryValues(1.0, 0.5, 0.2)),),
    ),
    Claims(
        Cubic,
        orders=(1, math.inf),
        coefficients="cv = 3/2; ca_max = 6; ca_min = -6; ca_rms = sqrt(12); cj = inf; "
        "va_max = 2*sqrt(3); va_min = -va_max",
        others=(Cubic(0.3),),
    ),
    Claims(
        Polynomial345,
        orders=(2, math.inf),
        coefficients="cv = 15/8; ca_max = 10/sqrt(3); ca_min = -ca_max; ca_rms = sqrt(120/7); cj = 60; "
        "va_max = 6075/(343*sqrt(7)); va_min = -va_max",
        others=(Polynomial345(0.3),),
    ),
    Claims(
        Polynomial4567,
        orders=(3, math.inf),
        coefficients="cv = 35/16; ca_max = 84/(5*sqrt(5)); ca_min = -ca_max; ca_rms = sqrt(280/11); cj = 105/2; "
        "va_max = 58800/1024*(10/11)**5/sqrt(11); va_min = -va_max",
        others=(Polynomial4567(0.3),),
    ),
    Claims(
        Dwell,
        orders=(math.inf, math.inf),
        end=(0.0, 0.0),
        coefficients="cv = 0; ca_max = 0; ca_min = 0; ca_rms = 0; cj = 0; va_max = 0; va_min = 0",
    ),
    Claims(
        StraightLine,
        orders=(0, math.inf),
        start=(0.0, 1.0),
        end=(1.0, 1.0),
        coefficients="cv = 1; ca_max = 0; ca_min = 0; ca_rms = 0; cj = 0; va_max = 0; va_min = 0",
    ),
    Claims(
        DoubleHarmonic,
        orders=(1, math.inf),
        coefficients="cv = 3*sqrt(3)*pi/8; ca_max = 9*pi**2/16; ca_min = -pi**2; ca_rms = pi**2/2; cj = inf; "
        "va_max = pi**3/4; va_min = -675*sqrt(15)*pi**3/8192",
        others=(DoubleHarmonic("start"),),
    ),
    Claims(
        PieceLaw,
        orders=(2, math.inf),
        coefficients="cv = 15/8; ca_max = 10/sqrt(3); ca_min = -ca_max; ca_rms = sqrt(120/7); cj = 60; "
        "va_max = 225/8*(6/7)**3/sqrt(7); va_min = -va_max",
        others=(PieceLaw(MIXED),),
        beyond=(PieceLaw([Piece(1.0, (1.8, -2.4, 0.0, 0.0))], (0.5, 1.1)),),
    ),
    Claims(
        Spline,
        orders=(1, 2),
        where={"a": "192/35", "b": "24/7"},
        coefficients="cv = (a + 2*b)/8; ca_max = a; ca_min = -a; ca_rms = sqrt((a**2 + a*b + 2*b**2)/6); cj = inf; "
        "va_max = (a + b)/8*b; va_min = -va_max",
        others=(Spline(WAVE),),
        beyond=(Spline(EXAMPLE, (0.5, None), (False, True)), Spline(WAVE, ends=BoundaryValues(2.0, 1.0, -3.0))),
    ),
)
