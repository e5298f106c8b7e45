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
from workbook.book.declare import Quantity, Sheet, calc, constant, entries_of
from workbook.book.sentence import quoted
from workbook.fields.units import DEGREE, si
from workbook.machines.machine.drive.driven import Driven, of_kind
from workbook.machines.machine.drive.mechanisms.page import Column, LinkagePage
from workbook.machines.machine.mechanism import CrankSlider, PressCrank, Rocker

AREA = "SQRT(MAX(0,(@l+@r-{d})*(@l-@r+{d})*({d}+@r-@l)*({d}+@r+@l)))"
"""4 times the area of the triangle of shaft, lever's end and slide, by Heron's formula"""
ANGLE = "ATAN2({x},@e)+@side*ATAN2({d}^2+@r^2-@l^2,{k})"  # of the lever, by the area and the law of cosines
OFFSET = ("@offset", "Offset of the slide's line from the shaft", "e", "mm", "offset", "0 if empty")

WORD = {"format": "", "align": "left"}


def area(linkage: SlideLinkage, d: Array | float) -> Any:
    """Return four areas of the triangle where the slide is at d from the shaft (m²), by its sides."""
    r, rod = linkage.lever, linkage.link
    return np.sqrt(np.maximum(0.0, (rod + r - d) * (rod - r + d) * (d + r - rod) * (d + r + rod)))


def lengths(linkage: SlideLinkage, lever: str, link: str) -> list[Quantity]:
    """Return the rows of lever, link and offset in m, by the entries of the first two."""
    return [
        calc("@r", "Lever", "r", "m", f"=@{lever}/1000", linkage.lever),
        calc("@l", "Link", "l", "m", f"=@{link}/1000", linkage.link),
        calc("@e", "Offset", "e", "m", "=@offset/1000", linkage.offset),
    ]


def begun(linkage: SlideLinkage) -> list[Quantity]:
    """Return the rows of the lever where the motion begins, and of what is an end of the reach."""
    d = float(np.hypot(linkage.zero, linkage.offset))
    return [
        calc("@d0", "Slide to the shaft, where the motion begins", "d_0", "m", "=SQRT(@x0^2+@e^2)", d),
        calc("@k0", "Four areas of the triangle there", "K_0", "m²", f"={AREA.format(d='@d0')}", area(linkage, d),
             "Heron", scale=linkage.link**2),
        calc("@psi0", "Angle of the lever where the motion begins", "ψ_0", "rad",
             f"={ANGLE.format(x='@x0', d='@d0', k='@k0')}", linkage.start, "from the direction of the slide's line"),
        calc("@near_end", "So near to an end counts as in it", "", "m", "=check_zero*(@high-@low)", near_end(linkage),
             "in a dead centre the shaft may go on either way", format="0E+00"),
    ]  # fmt: skip


def ratios(driven: Driven, position: Array, of: Column) -> list[Quantity]:
    """Return the columns of φ', φ'' and φ at the position in the column ``y``."""
    one = of_kind(SlideLinkage, driven.linkage)
    x = one.zero + one.direction * position
    psi = one.angle(x)
    turned, ratio, change = one.shaft(position)
    d = np.hypot(x, one.offset)
    return [
        calc("X", "slide from the shaft", "x", "m", "=@x0+@sense*[y]", of(x), "x_0 ± y", scale=one.link),
        calc("d", "to the shaft", "r_B", "m", "=SQRT([X]^2+@e^2)", of(d), "√(x² + e²)", scale=one.link),
        calc("K", "four areas of the triangle", "K", "m²", f"={AREA.format(d='[d]')}", of(area(one, d)), "Heron",
             scale=one.link**2),
        calc("psi", "angle of the lever", "ψ", "rad", f"={ANGLE.format(x='[X]', d='[d]', k='[K]')}", of(psi),
             scale=1.0),
        *pin(one.lever, psi, of),
        *travel(one.lever, one.offset, psi, x, of),
        calc("g", "ratio", "φ'", "rad/m", "=1/ABS([dx])", of(ratio), "1/|dx/dψ|"),
        calc("h", "its change", "φ''", "rad/m²", "=0-@sense*[ddx]/ABS([dx])^3", of(change), "dφ'/dy",
             scale=float(np.abs(change).max())),
        calc("phi", "angle of the shaft", "φ", "rad", "=@sense*SIGN([dx])*([psi]-@psi0)", of(turned),
             "from where the motion begins", scale=1.0),
    ]  # fmt: skip


def pin(lever: float, psi: Array, of: Column) -> list[Quantity]:
    """Return the columns of the lever's end at the angles in the column ``psi``."""
    return [
        calc("c", "lever's end along the line", "x_A", "m", "=@r*COS([psi])", of(lever * np.cos(psi)), "r cos ψ",
             scale=lever),
        calc("above", "and above it", "y_A", "m", "=@r*SIN([psi])", of(lever * np.sin(psi)), "r sin ψ", scale=lever),
    ]  # fmt: skip


def travel(lever: float, offset: float, psi: Array, x: Array, of: Column) -> list[Quantity]:
    """Return the columns of dx/dψ and d²x/dψ², by the slope of the link, behind those of :func:`pin` and ``X``."""
    lean = (lever * np.sin(psi) - offset) / (x - lever * np.cos(psi))
    first, second = slopes(lever, offset, psi, x)
    return [
        calc("tan", "slope of the link", "tan β", "", "=([above]-@e)/([X]-[c])", of(lean), "(y_A − e)/(x − x_A)",
             scale=1.0),
        calc("dx", "travel by angle", "dx/dψ", "m", "=0-[above]-[tan]*[c]", of(first), "−(y_A + x_A tan β)",
             scale=lever),
        calc("ddx", "its change", "d²x/dψ²", "m", "=[tan]*[above]-[c]-([c]+[tan]*[c]*[tan])*[c]/([X]-[c])", of(second),
             "y_A tan β − x_A − x_A² (1 + tan² β)/(x − x_A)", scale=lever),
    ]  # fmt: skip


def crank(e: CrankSlider | PressCrank, key: str, moved: str) -> list[Quantity]:
    """Return the rows of crank, rod and offset as they are entered; ``moved`` is what has a share of the rod's mass."""
    cell, shared = entries_of(e, f"{key}.mechanism"), f"its mass: a share to the {moved}, the rest to the parts"
    return [
        cell("@crank_radius", "Radius of the crank", "r", "mm", "crank_radius"),
        cell("@rod_length", "Length of the connecting rod", "l", "mm", "rod_length", shared),
        cell(*OFFSET),
    ]


def crank_entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered of a crank-slider."""
    e = of_kind(CrankSlider, driven.given)
    cell = entries_of(e, f"{key}.mechanism")
    return [
        *crank(e, key, "load"),
        cell("@zero", "Positions grow from the dead centre", "", "", "zero", "inner, or outer; inner if empty", **WORD),
        cell("@branch", "The crank is, of the line from shaft to slide", "", "", "branch",
             "ahead, or behind; ahead if empty", **WORD),
        cell("@start", "Distance from there where the motion begins", "y_0", "mm", "start",
             "0 if empty: then it rests in the dead centre"),
    ]  # fmt: skip


INNER, OUTER = "SQRT(MAX(0,(@l-@r)^2-@e^2))", "SQRT((@l+@r)^2-@e^2)"


def crank_sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of a crank-slider in m, and of where it can bring its load to."""
    one = of_kind(SlideLinkage, driven.linkage)
    low, high, *_ = one.reach
    return [
        *lengths(one, "crank_radius", "rod_length"),
        calc("@side", "Lever ahead (1) or behind (−1)", "σ", "", '=IF(@branch="behind",0-1,1)', one.side, format="0"),
        calc("@sense", "Positions grow away from the shaft (1)", "", "", '=IF(@zero="outer",0-1,1)', one.direction,
             format="0"),
        calc("@x0", "Slide from the shaft where the motion begins", "x_0", "m",
             f"=IF(@zero=\"outer\",{OUTER}-@start/1000,{INNER}+@start/1000)", one.zero,
             "√((l ± r)² − e²) in the dead centres"),
        calc("@low", "Lowest position that is reached", "", "m", "=0-@start/1000", low, "a dead centre"),
        calc("@high", "Highest position", "", "m", f"={OUTER}-{INNER}-@start/1000", high, "the other one"),
        *begun(one),
    ]  # fmt: skip


def crank_varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other sizes for the i-th axis in the k-th variation, and how far its slide then moves (mm)."""
    radius = 31.0 + 7 * k + i
    made = {
        "crank_radius": radius, "rod_length": radius * (2.6 + 0.4 * k), "start": 0.3 * radius,
        "offset": (0.0, 9.0, -14.0, None, 5.5, 0.0)[(i + k) % 6], "zero": ("inner", "outer", None)[k % 3],
        "branch": ("behind", "ahead", None)[(i + k) % 3],
    }  # fmt: skip
    return made, 0.0, 1.3 * radius


def rocker_entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered of a rocker."""
    cell = entries_of(driven.given, f"{key}.mechanism")
    return [
        cell("@lever_length", "Length of the lever", "r", "mm", "lever_length"),
        cell("@link_length", "Length of the link", "l", "mm", "link_length"), cell(*OFFSET),
        cell("@start_angle", "Lever from the line where the motion begins", "ψ_0", "°", "start_angle"),
        cell("@slide", "The slide is, of the lever's end", "", "", "slide", "ahead, or behind; ahead if empty", **WORD),
        cell("@direction", "Positions grow along the line", "", "", "direction",
             "forward, or backward; forward if empty", **WORD),
    ]  # fmt: skip


def rocker_sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of a rocker in m, and of where it can bring its load to."""
    one, begin = of_kind(SlideLinkage, driven.linkage), si(of_kind(Rocker, driven.given).start_angle or 0.0, DEGREE)
    low, high, *_ = one.reach
    ahead = "SQRT(MAX(0,@l^2-(@r*SIN(@theta)-@e)^2))"
    back = '@direction="backward"'
    return [
        *lengths(one, "lever_length", "link_length"),
        calc("@theta", "Lever where the motion begins", "", "rad", "=RADIANS(@start_angle)", begin),
        calc("@sense", "Positions grow along the line (1)", "", "", f"=IF({back},0-1,1)", one.direction, format="0"),
        calc("@x0", "Slide where the motion begins", "x_0", "m", f'=@r*COS(@theta)+IF(@slide="behind",0-1,1)*{ahead}',
             one.zero, "r cos ψ ± √(l² − (r sin ψ − e)²)"),
        calc("@ahead", "Sine of the angle from the line to the slide to the lever", "", "",
             "=SIN(@theta-ATAN2(@x0,@e))", sin(begin - atan2(one.offset, one.zero)), "where the motion begins",
             scale=1.0),
        calc("@side", "Lever ahead of the line to the slide (1)", "σ", "", "=IF(@ahead>0,1,0-1)", one.side, format="0"),
        constant("@same", "Places that count as one, of the link", "", "", SAME, format="0E+00"),
        calc("@none", "Farther than any slide", "", "m", "=4*(@r+@l+ABS(@e))", one.far_off),
        calc("@low", "Lowest position that is reached", "", "m",
             f"=IF({back},@x0-MIN([@ends.above]),MAX([@ends.below])-@x0)", low, scale=one.link),
        calc("@high", "Highest position", "", "m",
             f"=IF({back},@x0-MAX([@ends.below]),MIN([@ends.above])-@x0)", high, scale=one.link),
        *begun(one),
    ]  # fmt: skip


def rocker_table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the places at which a rocker may lock."""
    one = of_kind(SlideLinkage, driven.linkage)
    places = one.lock_places(one.zero)
    ways = [1, 1, -1, -1, 1, 1, -1, -1]
    rests = [f"=(@l+{way}*@r)^2-@e^2" for way in ways[:4]] + [f"=@r^2-(@e+{way}*@l)^2" for way in ways[4:]]
    locks = "OR([k]<=4,ABS([at]-[along])<=@same*@l)"
    at, square = np.array([place.at for place in places]), np.arange(len(places)) >= 4
    distances = np.hypot(at, one.offset)
    areas = np.where(square, area(one, distances), 0.0)
    angles = np.where(square, one.angle(at), 0.0)

    def of(name: str) -> list[float]:
        return [getattr(place, name) for place in places]

    sheet.table(
        "@ends", "Where the mechanism may lock", len(places),
        constant("k", "place", "", "", list(range(1, len(places) + 1))),
        constant("name", "what is there", "", "", [place.name for place in places], align="left"),
        constant("sign", "sign", "", "", [1, -1] * 4),
        calc("rest", "under the root", "", "m²", rests, of("rest"), scale=one.far_off),
        calc("at", "slide at", "x", "m", "=IF([rest]<0,@x0,[sign]*SQRT(MAX(0,[rest])))", of("at"), scale=one.link),
        calc("d", "to the shaft", "r_B", "m", "=SQRT([at]^2+@e^2)", distances, scale=one.link),
        calc("K", "four areas of the triangle", "K", "m²", f"=IF([k]<=4,0,{AREA.format(d='[d]')})", areas, "0 in line",
             scale=one.link**2),
        calc("psi", "angle of the lever", "ψ", "rad", f"=IF([k]<=4,0,{ANGLE.format(x='[at]', d='[d]', k='[K]')})",
             angles, "where the link is square", scale=1.0),
        calc("along", "lever's end along the line", "x_A", "m", "=IF([k]<=4,[at],@r*COS([psi]))", of("along"),
             scale=one.link),
        calc("x", "locks at", "x", "m", f"=IF(AND([rest]>=0,{locks}),[at],@x0)", of("x"), scale=one.link),
        calc("below", "below the begin", "", "m", "=IF([x]<@x0,[x],0-@none)", of("below"), scale=one.link),
        calc("above", "above it", "", "m", "=IF([x]>@x0,[x],@none)", of("above"), scale=one.link),
    )  # fmt: skip


def rocker_varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other sizes for the i-th axis in the k-th variation, and how far its slide then moves (mm)."""
    lever = 60.0 + 9 * k + i
    made = {
        "lever_length": lever, "link_length": lever * (2.1 + 0.3 * k),
        "offset": lever * (0.9, 1.05, 0.7, 1.2, 0.95, 1.0)[k], "start_angle": 70.0 + 7 * k,
        "slide": ("behind", "ahead", None)[(i + k) % 3], "direction": ("forward", "backward", None)[k % 3],
    }  # fmt: skip
    return made, -0.15 * lever, 0.35 * lever


FITS, HOLDS = "@l>@r+ABS(@e)", "rod longer than crank and offset"
DEAD = "between its dead centres"
CRANK_ENDS = {"low": 'IF(@zero="outer","outer dead centre","inner dead centre")',
              "high": 'IF(@zero="outer","inner dead centre","outer dead centre")'}  # fmt: skip
CRANK_SLIDER = LinkagePage(
    crank_entries, crank_sizes, ratios, crank_varied, "COUNT(@crank_radius,@rod_length)=2", FITS, HOLDS,
    quoted(CrankSlider.APART), DEAD, CRANK_ENDS,
)  # fmt: skip
BELOW, ABOVE = (
    f"INDEX([@ends.name],MATCH({most}([@ends.{side}]),[@ends.{side}],0))"
    for most, side in (("MAX", "below"), ("MIN", "above"))
)
ROCKER = LinkagePage(
    rocker_entries, rocker_sizes, ratios, rocker_varied, "COUNT(@lever_length,@link_length,@start_angle)=3",
    "AND(@l^2>(@r*SIN(@theta)-@e)^2,ABS(@ahead)>=check_zero,@high<@none,@low>0-@none)",
    "lever, link and slide where the motion begins", quoted(Rocker.APART), DEAD,
    {"low": f'IF(@direction="backward",{ABOVE},{BELOW})', "high": f'IF(@direction="backward",{BELOW},{ABOVE})'},
    worked=rocker_table,
)  # fmt: skip
