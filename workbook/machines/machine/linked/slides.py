"""A lever that drives a slide through a link in cells: angle and ratio at a position of the slide.

A lever r on a shaft in the origin drives by a link l a slide at x on a line at the distance e. With d² = x² + e²,
M = d² + r² − l² and K = 2 r d sin A, A the angle at the shaft, the lever's end is at c = (x M − s e K)/(2 d²) along the
line, and dx/dψ = −s K/(2 (x − c)): so φ' and φ'' need no angle.
"""

from __future__ import annotations

import numpy as np

from engine.laws.base import Array
from engine.machine.places import Worked
from engine.mechanisms.linkage import Linkage, near_end
from engine.mechanisms.rocker import farther
from engine.mechanisms.slide import SlideLinkage, Triangle
from workbook.book.declare import Quantity, Sheet, calc
from workbook.machines.machine.linked.changing import LinkedWork
from workbook.machines.machine.linked.driven import LinkedDriven

FORM = "slide from the shaft"
ANGLE = "{d}+@r^2-@l^2"
HEIGHT = "SQRT(MAX(1E-18*@l^4+1E-30,(@l+@r-{d})*(@l-@r+{d})*({d}+@r-@l)*({d}+@r+@l)))"
"""M and K; out of reach K is next to nothing, and what hangs on it means nothing"""


def far(one: SlideLinkage) -> float:
    """Return what is farther than any slide (m)."""
    return farther(one.lever, one.link, one.offset)


def begun(one: SlideLinkage) -> list[Quantity]:
    """Return the rows of the lever where the motion begins, and of what is an end of the reach."""
    return [
        calc("@psi0", "Angle of the lever where the motion begins", "ψ_0", "rad",
             f"=ATAN2(@x0,@e)+@side*ATAN2({ANGLE.format(d='(@x0^2+@e^2)')},{HEIGHT.format(d='SQRT(@x0^2+@e^2)')})",
             one.start, source="from the direction of the slide's line"),
        calc("@near_end", "So near to an end counts as in it", "", "m", "=check_zero*(@high-@low)", near_end(one),
             format="0E+00", source="in a dead centre the shaft may go on either way"),
    ]  # fmt: skip


def entered(sheet: Sheet, driven: LinkedDriven, rows: int) -> None:
    """Declare no table of entries: what is entered are single cells."""


def passing(sheet: Sheet, view: LinkedWork) -> None:
    """Declare no places where the ratio's change jumps: there are none."""


def held(driven: LinkedDriven, position: str, within: list[float]) -> list[Quantity]:
    """Return no columns of stretches: the geometry is one everywhere."""
    return []


def ratios(driven: LinkedDriven, at: Worked, within: Array, mark: str = "") -> list[Quantity]:
    """Return the columns of φ' and φ'' at the position in the column ``p``, each name with a mark at its end."""
    one = slide_of(driven.linkage)
    found = Triangle.of(one, at.y)
    rates = float(np.abs(at.second).max())

    def col(name: str) -> str:
        return f"[{name}{mark}]"

    x, d, k, c, s = (col(name) for name in ("X", "d", "K", "c", "kx"))
    m = ANGLE.format(d=f"{d}^2")
    return [
        calc(f"X{mark}", FORM, "x", "m", f"=@x0+@sense*{col('p')}", found.x, source="x_0 ± y"),
        calc(f"d{mark}", "to the shaft", "d", "m", f"=MAX(1E-9*@l,SQRT({x}^2+@e^2))", found.d, source="√(x² + e²)"),
        calc(f"K{mark}", "4 areas of the triangle", "K", "m²", f"={HEIGHT.format(d=d)}", found.k,
             source="Heron: 4 A"),
        calc(f"c{mark}", "lever's end along the line", "c", "m", f"=({x}*({m})-@side*@e*{k})/(2*{d}^2)", found.c,
             source="(x M − s e K)/(2 d²)", scale=one.lever),
        calc(f"kx{mark}", "slope of K", "K_x", "m", f"=2*{x}*(@r^2+@l^2-{d}^2)/{k}", found.slope,
             source="2 x (r² + l² − d²)/K"),
        calc(f"g{mark}", "ratio", "φ'", "rad/m", f"=2*ABS({x}-{c})/{k}", at.first, source="2 |x − c|/K"),
        calc(f"h{mark}", "its change", "φ''", "rad/m²",
             f"=2*@sense*SIGN({x}-{c})*((1-({m}+2*{x}^2-@side*@e*{s})/(2*{d}^2)+2*{x}*{c}/{d}^2)/{k}"
             f"-({x}-{c})*{s}/{k}^2)", at.second, scale=rates, source="dφ'/dy"),
    ]  # fmt: skip


def angle(driven: LinkedDriven, y: Array, within: Array) -> Quantity:
    """Return the column of the shaft's angle at positions."""
    x = "[X]"
    psi = f"ATAN2({x},@e)+@side*ATAN2({ANGLE.format(d='[d]^2')},[K])"
    return calc("phi", "angle of the shaft", "φ", "rad", f"=0-@sense*@side*SIGN({x}-[c])*({psi}-@psi0)",
                driven.linkage.shaft(y).angle, scale=1.0, source="from where the motion begins")  # fmt: skip


def slide_of(linkage: Linkage) -> SlideLinkage:
    """Return a linkage of lever and link as what it is."""
    if not isinstance(linkage, SlideLinkage):
        raise TypeError(f"{linkage.name} is no lever and link")
    return linkage
