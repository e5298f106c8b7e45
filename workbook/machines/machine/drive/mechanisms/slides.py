"""A lever that drives a slide through a link, in cells: crank-slider and rocker, their reach and their ratio.

A lever r on a shaft in the origin drives by a link l a slide at x on a line at the distance e. ψ is the angle of the
lever: that of the line from shaft to slide, and beside it the triangle's angle by the law of cosines. The reach of a
rocker ends where lever, link and slide lock.
"""

from math import atan2, sin
from typing import Any

import numpy as np

from engine.drive.mechanisms.slides import SAME, SlideLinkage, slopes
from engine.drive.mechanisms.variable_ratio import near_end
from engine.laws.base import Array
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.sentence import quoted
from workbook.fields.units import DEGREE, si
from workbook.machines.machine.drive.driven import Driven, of_kind
from workbook.machines.machine.drive.mechanisms.page import Column, LinkagePage
from workbook.machines.machine.mechanism import CrankSlider, Rocker

CELLS = cell_tables(__file__)


def area(linkage: SlideLinkage, d: Array | float) -> Any:
    """Return four areas of the triangle where the slide is at d from the shaft (m²), by its sides."""
    r, rod = linkage.lever, linkage.link
    return np.sqrt(np.maximum(0.0, (rod + r - d) * (rod - r + d) * (d + r - rod) * (d + r + rod)))


def lengths(linkage: SlideLinkage, lever: str, link: str) -> list[Quantity]:
    """Return the rows of lever, link and offset in m, by the entries of the first two."""
    cell = CELLS["lengths"]
    return [cell("@r", linkage.lever, lever=lever), cell("@l", linkage.link, link=link), cell("@e", linkage.offset)]


def begin_of_lever(linkage: SlideLinkage) -> list[Quantity]:
    """Return the rows of the lever where the motion begins, and of what is an end of the reach."""
    cell = CELLS["begun"]
    d = float(np.hypot(linkage.zero, linkage.offset))
    return [
        cell("@d0", d),
        cell("@k0", area(linkage, d), scale=linkage.link**2),
        cell("@psi0", linkage.start),
        cell("@near_end", near_end(linkage)),
    ]


def ratios(driven: Driven, position: Array, of: Column) -> list[Quantity]:
    """Return the columns of φ', φ'' and φ at the position in the column ``y``."""
    linkage = of_kind(SlideLinkage, driven.linkage)
    cell = CELLS["ratios"].sharing(link=linkage.link, square=linkage.link**2)
    x = linkage.zero + linkage.direction * position
    psi = linkage.angle(x)
    turned, ratio, change = linkage.shaft(position)
    d = np.hypot(x, linkage.offset)
    return [
        cell("X", of(x)),
        cell("d", of(d)),
        cell("K", of(area(linkage, d))),
        cell("psi", of(psi)),
        *pin(linkage.lever, psi, of),
        *travel(linkage.lever, linkage.offset, psi, x, of),
        cell("g", of(ratio)),
        cell("h", of(change), scale=float(np.abs(change).max())),
        cell("phi", of(turned)),
    ]


def pin(lever: float, psi: Array, of: Column) -> list[Quantity]:
    """Return the columns of the lever's end at the angles in the column ``psi``."""
    cell = CELLS["pin"].sharing(lever=lever)
    return [cell("c", of(lever * np.cos(psi))), cell("above", of(lever * np.sin(psi)))]


def travel(lever: float, offset: float, psi: Array, x: Array, of: Column) -> list[Quantity]:
    """Return the columns of dx/dψ and d²x/dψ², by the slope of the link, behind those of :func:`pin` and ``X``."""
    cell = CELLS["travel"].sharing(lever=lever)
    lean = (lever * np.sin(psi) - offset) / (x - lever * np.cos(psi))
    first, second = slopes(lever, offset, psi, x)
    return [cell("tan", of(lean)), cell("dx", of(first)), cell("ddx", of(second))]


def crank_sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of a crank-slider in m, and of where it can bring its load to."""
    cell = CELLS["crank_sizes"]
    linkage = of_kind(SlideLinkage, driven.linkage)
    low, high, *_ = linkage.reach
    return [
        *lengths(linkage, "crank_radius", "rod_length"),
        cell("@side", linkage.side),
        cell("@sense", linkage.direction),
        cell("@x0", linkage.zero),
        cell("@low", low),
        cell("@high", high),
        *begin_of_lever(linkage),
    ]


def crank_varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other sizes for the i-th axis in the k-th variation, and how far its slide then moves (mm)."""
    radius = 31.0 + 7 * k + i
    made = {"crank_radius": radius, "rod_length": radius * (2.6 + 0.4 * k), "start": 0.3 * radius}
    return made, 0.0, 1.3 * radius


def rocker_sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of a rocker in m, and of where it can bring its load to."""
    cell = CELLS["rocker_sizes"]
    linkage = of_kind(SlideLinkage, driven.linkage)
    begin = si(of_kind(Rocker, driven.given).start_angle or 0.0, DEGREE)
    low, high, *_ = linkage.reach
    return [
        *lengths(linkage, "lever_length", "link_length"),
        cell("@theta", begin),
        cell("@sense", linkage.direction),
        cell("@x0", linkage.zero),
        cell("@ahead", sin(begin - atan2(linkage.offset, linkage.zero)), scale=1.0),
        cell("@side", linkage.side),
        cell("@same", SAME),
        cell("@none", linkage.far_off),
        cell("@low", low, scale=linkage.link),
        cell("@high", high, scale=linkage.link),
        *begin_of_lever(linkage),
    ]


def rocker_table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the places at which a rocker may lock."""
    linkage = of_kind(SlideLinkage, driven.linkage)
    cell = CELLS["ends"].sharing(link=linkage.link, square=linkage.link**2)
    places = linkage.lock_places(linkage.zero)
    ways = [1, 1, -1, -1, 1, 1, -1, -1]
    rests = [f"=(@l+{way}*@r)^2-@e^2" for way in ways[:4]] + [f"=@r^2-(@e+{way}*@l)^2" for way in ways[4:]]
    at, square = np.array([place.at for place in places]), np.arange(len(places)) >= 4
    distances = np.hypot(at, linkage.offset)
    areas = np.where(square, area(linkage, distances), 0.0)
    angles = np.where(square, linkage.angle(at), 0.0)

    def of(name: str) -> list[float]:
        return [getattr(place, name) for place in places]

    cell.place(
        sheet,
        cell("name", [place.name for place in places]),
        cell("k", list(range(1, len(places) + 1))),
        cell("sign", [1, -1] * 4),
        cell("rest", of("rest"), formula=rests, scale=linkage.far_off),
        cell("at", of("at")),
        cell("d", distances),
        cell("K", areas),
        cell("psi", angles),
        cell("along", of("along")),
        cell("x", of("x")),
        cell("below", of("below")),
        cell("above", of("above")),
    )


def rocker_varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other sizes for the i-th axis in the k-th variation, and how far its slide then moves (mm)."""
    lever = 60.0 + 9 * k + i
    made = {
        "lever_length": lever,
        "link_length": lever * (2.1 + 0.3 * k),
        "offset": lever * (0.9, 1.05, 0.7, 1.2, 0.95, 1.0)[k],
        "start_angle": 70.0 + 7 * k,
    }
    return made, -0.15 * lever, 0.35 * lever


FITS, HOLDS = "@l>@r+ABS(@e)", "rod longer than crank and offset"
DEAD = "between its dead centres"
CRANK_ENDS = {
    "low": 'IF(@zero="outer","outer dead centre","inner dead centre")',
    "high": 'IF(@zero="outer","inner dead centre","outer dead centre")',
}
CRANK_SLIDER = LinkagePage(
    crank_sizes,
    ratios,
    crank_varied,
    "COUNT(@crank_radius,@rod_length)=2",
    FITS,
    HOLDS,
    quoted(CrankSlider.APART),
    DEAD,
    CRANK_ENDS,
)
BELOW, ABOVE = (
    f"INDEX([@ends.name],MATCH({most}([@ends.{side}]),[@ends.{side}],0))"
    for most, side in (("MAX", "below"), ("MIN", "above"))
)
ROCKER = LinkagePage(
    rocker_sizes,
    ratios,
    rocker_varied,
    "COUNT(@lever_length,@link_length,@start_angle)=3",
    "AND(@l^2>(@r*SIN(@theta)-@e)^2,ABS(@ahead)>=check_zero,@high<@none,@low>0-@none)",
    "lever, link and slide where the motion begins",
    quoted(Rocker.APART),
    DEAD,
    {"low": f'IF(@direction="backward",{ABOVE},{BELOW})', "high": f'IF(@direction="backward",{BELOW},{ABOVE})'},
    worked=rocker_table,
)
