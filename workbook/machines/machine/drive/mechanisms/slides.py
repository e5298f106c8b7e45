"""A lever that drives a slide through a link in cells: its angle at a position of the slide, and its ratio.

A lever r on a shaft in the origin drives by a link l a slide at x on a line at the distance e. ψ is the angle of the
lever: that of the line from shaft to slide, and beside it the triangle's angle by the law of cosines.
"""

from typing import Any

import numpy as np

from engine.drive.mechanisms.slides import SlideLinkage, farther, lever_angle, slopes
from engine.drive.mechanisms.variable_ratio import near_end
from engine.laws.base import Array
from workbook.book.declare import Quantity, calc, given
from workbook.machines.machine.drive.driven import Driven, as_a
from workbook.machines.machine.drive.mechanisms.column import Column
from workbook.machines.machine.mechanism import CrankSlider, PressCrank

AREA = "SQRT(MAX(0,(@l+@r-{d})*(@l-@r+{d})*({d}+@r-@l)*({d}+@r+@l)))"
"""4 times the area of the triangle of shaft, lever's end and slide, by Heron's formula"""
ANGLE = "ATAN2({x},@e)+@side*ATAN2({d}^2+@r^2-@l^2,{k})"
"""of the lever, by the area and the law of cosines"""


def far(one: SlideLinkage) -> float:
    """Return what is farther than any slide (m)."""
    return farther(one.lever, one.link, one.offset)


def begun(one: SlideLinkage) -> list[Quantity]:
    """Return the rows of the lever where the motion begins, and of what is an end of the reach."""
    d = float(np.hypot(one.zero, one.offset))
    return [
        calc("@d0", "Slide to the shaft, where the motion begins", "d_0", "m", "=SQRT(@x0^2+@e^2)", d),
        calc("@k0", "Four areas of the triangle there", "K_0", "m²", f"={AREA.format(d='@d0')}", area(one, d),
             scale=one.link**2, source="Heron"),
        calc("@psi0", "Angle of the lever where the motion begins", "ψ_0", "rad",
             f"={ANGLE.format(x='@x0', d='@d0', k='@k0')}", one.start, source="from the direction of the slide's line"),
        calc("@near_end", "So near to an end counts as in it", "", "m", "=check_zero*(@high-@low)", near_end(one),
             format="0E+00", source="in a dead centre the shaft may go on either way"),
    ]  # fmt: skip


def area(one: SlideLinkage, d: Array | float) -> Any:
    """Return four areas of the triangle where the slide is at d from the shaft (m²), by its sides."""
    r, rod = one.lever, one.link
    return np.sqrt(np.maximum(0.0, (rod + r - d) * (rod - r + d) * (d + r - rod) * (d + r + rod)))


def crank(e: CrankSlider | PressCrank, key: str, moved: str) -> list[Quantity]:
    """Return the rows of crank, rod and offset as they are entered; ``moved`` is what has a share of the rod's mass."""
    return [
        given("@crank_radius", "Radius of the crank", "r", "mm", e.crank_radius, f"{key}.crank_radius", format="0.0##"),
        given("@rod_length", "Length of the connecting rod", "l", "mm", e.rod_length, f"{key}.rod_length",
              format="0.0##", source=f"its mass: a share to the {moved}, the rest to the parts"),
        given("@offset", "Offset of the slide's line from the shaft", "e", "mm", e.offset, f"{key}.offset",
              format="0.0##", source="0 if empty"),
    ]  # fmt: skip


def ratios(driven: Driven, position: Array, of: Column) -> list[Quantity]:
    """Return the columns of φ', φ'' and φ at the position in the column ``y``."""
    one = as_a(SlideLinkage, driven.linkage)
    x = one.zero + one.direction * position
    psi = lever_angle(one.lever, one.link, one.offset, one.side, x)
    turned, ratio, change = one.shaft(position)
    d = np.hypot(x, one.offset)
    return [
        calc("X", "slide from the shaft", "x", "m", "=@x0+@sense*[y]", of(x), scale=one.link, source="x_0 ± y"),
        calc("d", "to the shaft", "r_B", "m", "=SQRT([X]^2+@e^2)", of(d), scale=one.link, source="√(x² + e²)"),
        calc("K", "four areas of the triangle", "K", "m²", f"={AREA.format(d='[d]')}", of(area(one, d)),
             scale=one.link**2, source="Heron"),
        calc("psi", "angle of the lever", "ψ", "rad", f"={ANGLE.format(x='[X]', d='[d]', k='[K]')}", of(psi),
             scale=1.0),
        *pin(one.lever, psi, of),
        *travel(one.lever, one.offset, psi, x, of),
        calc("g", "ratio", "φ'", "rad/m", "=1/ABS([dx])", of(ratio), source="1/|dx/dψ|"),
        calc("h", "its change", "φ''", "rad/m²", "=0-@sense*[ddx]/ABS([dx])^3", of(change),
             scale=float(np.abs(change).max()), source="dφ'/dy"),
        calc("phi", "angle of the shaft", "φ", "rad", "=@sense*SIGN([dx])*([psi]-@psi0)", of(turned), scale=1.0,
             source="from where the motion begins"),
    ]  # fmt: skip


def pin(lever: float, psi: Array, of: Column) -> list[Quantity]:
    """Return the columns of the lever's end at the angles in the column ``psi``."""
    return [
        calc("c", "lever's end along the line", "x_A", "m", "=@r*COS([psi])", of(lever * np.cos(psi)), scale=lever,
             source="r cos ψ"),
        calc("above", "and above it", "y_A", "m", "=@r*SIN([psi])", of(lever * np.sin(psi)), scale=lever,
             source="r sin ψ"),
    ]  # fmt: skip


def travel(lever: float, offset: float, psi: Array, x: Array, of: Column) -> list[Quantity]:
    """Return the columns of dx/dψ and d²x/dψ², by the slope of the link, behind those of :func:`pin` and ``X``."""
    lean = (lever * np.sin(psi) - offset) / (x - lever * np.cos(psi))
    first, second = slopes(lever, offset, psi, x)
    return [
        calc("tan", "slope of the link", "tan β", "", "=([above]-@e)/([X]-[c])", of(lean), scale=1.0,
             source="(y_A − e)/(x − x_A)"),
        calc("dx", "travel by angle", "dx/dψ", "m", "=0-[above]-[tan]*[c]", of(first), scale=lever,
             source="−(y_A + x_A tan β)"),
        calc("ddx", "its change", "d²x/dψ²", "m", "=[tan]*[above]-[c]-([c]+[tan]*[c]*[tan])*[c]/([X]-[c])",
             of(second), scale=lever, source="y_A tan β − x_A − x_A² (1 + tan² β)/(x − x_A)"),
    ]  # fmt: skip
