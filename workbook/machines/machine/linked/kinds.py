"""Each mechanism of a changing ratio in cells: what is entered, its size, angle and ratio at a position of its load.

A lever r on a shaft in the origin drives by a link l a slide at x on a line at the distance e. With d² = x² + e²,
M = d² + r² − l² and K = 2 r d sin A, A the angle at the shaft, the lever's end is at c = (x M − s e K)/(2 d²) along the
line, and dx/dψ = −s K/(2 (x − c)): so φ' and φ'' need no angle.
"""

from __future__ import annotations

import numpy as np

from engine.laws.base import Array
from engine.machine.places import Worked
from engine.mechanisms.linkage import Linkage, near_end
from engine.mechanisms.slide import SlideLinkage, Triangle
from workbook.book.declare import Quantity, calc, check, given
from workbook.machines.machine.chain import LINKED
from workbook.machines.machine.linked.driven import TOO_SHORT, LinkedDriven

INNER = "SQRT(MAX(0,(@l-@r)^2-@e^2))"
OUTER = "SQRT((@l+@r)^2-@e^2)"
FORM = "Slide from the shaft"


def entries(driven: LinkedDriven, key: str) -> list[Quantity]:
    """Return the rows of what is entered."""
    e, key = driven.given, f"{key}.mechanism"
    return [
        given("@crank", "Radius of the crank", "r", "mm", e.crank, f"{key}.crank", format="0.0##"),
        given("@rod", "Length of the connecting rod", "l", "mm", e.rod, f"{key}.rod", format="0.0##"),
        given("@offset", "Offset of the slide's line from the shaft", "e", "mm", e.offset, f"{key}.offset",
              format="0.0##", source="0 if empty"),
        given("@zero", "Positions grow from the dead centre", "", "", e.zero, f"{key}.zero", align="left",
              source="inner, or outer; inner if empty"),
        given("@branch", "The crank is, of the line from shaft to slide", "", "", e.branch, f"{key}.branch",
              align="left", source="ahead, or behind; ahead if empty"),
        given("@position", "From that dead centre to where the motion begins", "y_0", "mm", e.position,
              f"{key}.position", format="0.0##", source="0 if empty: then it rests in the dead centre"),
    ]  # fmt: skip


def sizes(driven: LinkedDriven) -> list[Quantity]:
    """Return the rows of the mechanism in m, and of where it can bring its load to."""
    one = slide_of(driven.linkage)
    low, high, *_ = one.reach
    return [
        calc("@r", "Lever", "r", "m", "=@crank/1000", one.lever),
        calc("@l", "Link", "l", "m", "=@rod/1000", one.link),
        calc("@e", "Offset", "e", "m", "=@offset/1000", one.offset),
        calc("@side", "Lever ahead (1) or behind (−1)", "s", "", '=IF(@branch="behind",0-1,1)', one.side, format="0"),
        calc("@sense", "Positions grow away from the shaft (1)", "", "", '=IF(@zero="outer",0-1,1)', one.direction,
             format="0"),
        calc("@x0", "Slide from the shaft where the motion begins", "x_0", "m",
             f"=IF(@zero=\"outer\",{OUTER}-@position/1000,{INNER}+@position/1000)", one.zero,
             source="√((l ± r)² − e²) in the dead centres"),
        calc("@low", "Lowest position that is reached", "", "m", "=0-@position/1000", low, source="a dead centre"),
        calc("@high", "Highest position", "", "m", f"={OUTER}-{INNER}-@position/1000", high, source="the other one"),
        calc("@psi0", "Angle of the lever where the motion begins", "ψ_0", "rad",
             f"=ATAN2(@x0,@e)+@side*ATAN2({ANGLE.format(d='(@x0^2+@e^2)')},{HEIGHT.format(d='SQRT(@x0^2+@e^2)')})",
             one.start, source="from the direction of the slide's line"),
        calc("@near_end", "So near to an end counts as in it", "", "m", "=check_zero*(@high-@low)", near_end(one),
             format="0E+00", source="in a dead centre the shaft may go on either way"),
    ]  # fmt: skip


def needed(driven: LinkedDriven) -> tuple[str, ...]:
    """Return the entries that the mechanism must have."""
    return LINKED[driven.given.kind][0]


def checks(driven: LinkedDriven) -> list[Quantity]:
    """Return the check that the sizes go together."""
    i = driven.number
    return [
        check("@ok_linked", f"Drive {i}: the sizes of the mechanism go together", "@l>@r+ABS(@e)", True,
              "rod longer than crank and offset", f":linked{i}", f'"{TOO_SHORT}"')
    ]  # fmt: skip


def end(driven: LinkedDriven, which: str) -> str:
    """Return the formula of the name of an end of the reach, ``low`` or ``high``."""
    one, other = ENDS[which]
    return f'IF(@zero="outer","{other}","{one}")'


ANGLE = "{d}+@r^2-@l^2"
HEIGHT = "SQRT(MAX(1E-18*@l^4+1E-30,(@l+@r-{d})*(@l-@r+{d})*({d}+@r-@l)*({d}+@r+@l)))"
"""M and K; out of reach K is next to nothing, and what hangs on it means nothing"""
ENDS = {"low": ("inner dead centre", "outer dead centre"), "high": ("outer dead centre", "inner dead centre")}


def ratios(driven: LinkedDriven, at: Worked, mark: str = "") -> list[Quantity]:
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
             source="√((l+r−d)(l−r+d)(d+r−l)(d+r+l))"),
        calc(f"c{mark}", "lever's end along the line", "c", "m", f"=({x}*({m})-@side*@e*{k})/(2*{d}^2)", found.c,
             source="(x M − s e K)/(2 d²)", scale=one.lever),
        calc(f"kx{mark}", "slope of K", "K_x", "m", f"=2*{x}*(@r^2+@l^2-{d}^2)/{k}", found.slope,
             source="2 x (r² + l² − d²)/K"),
        calc(f"g{mark}", "ratio", "φ'", "rad/m", f"=2*ABS({x}-{c})/{k}", at.first, source="2 |x − c|/K"),
        calc(f"h{mark}", "its change", "φ''", "rad/m²",
             f"=2*@sense*SIGN({x}-{c})*((1-({m}+2*{x}^2-@side*@e*{s})/(2*{d}^2)+2*{x}*{c}/{d}^2)/{k}"
             f"-({x}-{c})*{s}/{k}^2)", at.second, scale=rates, source="dφ'/dy"),
    ]  # fmt: skip


def angle(driven: LinkedDriven, y: Array) -> Quantity:
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
