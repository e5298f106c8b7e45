"""A rocker in cells: what is entered, its sizes and its reach, which ends where lever, link and slide lock."""

from math import atan2, sin
from typing import Any

import numpy as np

from engine.drive.mechanisms.slides import SAME, SlideLinkage, ends_of, lever_angle
from workbook.book.declare import Quantity, Sheet, calc, constant, given
from workbook.book.sentence import quoted
from workbook.entries.units import DEGREE, si
from workbook.machines.machine.drive.driven import Driven, as_a
from workbook.machines.machine.drive.linkages import APART
from workbook.machines.machine.drive.mechanisms import slides
from workbook.machines.machine.mechanism import Rocker

FITS = "AND(@l^2>(@r*SIN(@theta)-@e)^2,ABS(@ahead)>=check_zero,@high<@none,@low>0-@none)"
HOLDS = "lever, link and slide where the motion begins"
SIZED = "COUNT(@lever_length,@link_length,@start_angle)=3"
WITHIN = "between its dead centres"
WRONG = quoted(APART["rocker"])
BELOW, ABOVE = (
    f"INDEX([@ends.name],MATCH({most}([@ends.{side}]),[@ends.{side}],0))"
    for most, side in (("MAX", "below"), ("MIN", "above"))
)
ENDS = {
    "low": f'IF(@direction="backward",{ABOVE},{BELOW})', "high": f'IF(@direction="backward",{BELOW},{ABOVE})'
}  # fmt: skip
ratios = slides.ratios


def entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered."""
    e, key = as_a(Rocker, driven.given), f"{key}.mechanism"
    return [
        given("@lever_length", "Length of the lever", "r", "mm", e.lever_length, f"{key}.lever_length", format="0.0##"),
        given("@link_length", "Length of the link", "l", "mm", e.link_length, f"{key}.link_length", format="0.0##"),
        given("@offset", "Offset of the slide's line from the shaft", "e", "mm", e.offset, f"{key}.offset",
              format="0.0##", source="0 if empty"),
        given("@start_angle", "Lever from the line where the motion begins", "ψ_0", "°", e.start_angle,
              f"{key}.start_angle", format="0.0##"),
        given("@slide", "The slide is, of the lever's end", "", "", e.slide, f"{key}.slide", align="left",
              source="ahead, or behind; ahead if empty"),
        given("@direction", "Positions grow along the line", "", "", e.direction, f"{key}.direction", align="left",
              source="forward, or backward; forward if empty"),
    ]  # fmt: skip


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the mechanism in m, and of where it can bring its load to."""
    one, begin = as_a(SlideLinkage, driven.linkage), si(as_a(Rocker, driven.given).start_angle or 0.0, DEGREE)
    low, high, *_ = one.reach
    ahead = "SQRT(MAX(0,@l^2-(@r*SIN(@theta)-@e)^2))"
    back = '@direction="backward"'
    return [
        calc("@r", "Lever", "r", "m", "=@lever_length/1000", one.lever),
        calc("@l", "Link", "l", "m", "=@link_length/1000", one.link),
        calc("@e", "Offset", "e", "m", "=@offset/1000", one.offset),
        calc("@theta", "Lever where the motion begins", "", "rad", "=RADIANS(@start_angle)", begin),
        calc("@sense", "Positions grow along the line (1)", "", "", f"=IF({back},0-1,1)", one.direction, format="0"),
        calc("@x0", "Slide where the motion begins", "x_0", "m",
             f'=@r*COS(@theta)+IF(@slide="behind",0-1,1)*{ahead}', one.zero, source="r cos ψ ± √(l² − (r sin ψ − e)²)"),
        calc("@ahead", "Sine of the angle from the line to the slide to the lever", "", "",
             "=SIN(@theta-ATAN2(@x0,@e))", sin(begin - atan2(one.offset, one.zero)), scale=1.0,
             source="where the motion begins"),
        calc("@side", "Lever ahead of the line to the slide (1)", "σ", "", "=IF(@ahead>0,1,0-1)", one.side, format="0"),
        constant("@same", "Places that count as one, of the link", "", "", SAME, format="0E+00"),
        calc("@none", "Farther than any slide", "", "m", "=4*(@r+@l+ABS(@e))", slides.far(one)),
        calc("@low", "Lowest position that is reached", "", "m",
             f"=IF({back},@x0-MIN([@ends.above]),MAX([@ends.below])-@x0)", low, scale=one.link),
        calc("@high", "Highest position", "", "m",
             f"=IF({back},@x0-MAX([@ends.below]),MIN([@ends.above])-@x0)", high, scale=one.link),
        *slides.begun(one),
    ]  # fmt: skip


def table(sheet: Sheet, driven: Driven, rows: int) -> None:
    """Declare the places at which the mechanism may lock."""
    one = as_a(SlideLinkage, driven.linkage)
    places = ends_of(one.lever, one.link, one.offset, one.side, one.zero)
    signs = [1, -1, 1, -1, 1, -1, 1, -1]
    ways = [1, 1, -1, -1, 1, 1, -1, -1]
    rests = [f"=(@l+{way}*@r)^2-@e^2" for way in ways[:4]] + [f"=@r^2-(@e+{way}*@l)^2" for way in ways[4:]]
    locks = "OR([k]<=4,ABS([at]-[along])<=@same*@l)"
    at, square = np.array([place.at for place in places]), np.arange(len(places)) >= 4
    distances = np.hypot(at, one.offset)
    areas = np.where(square, slides.area(one, distances), 0.0)
    angles = np.where(square, lever_angle(one.lever, one.link, one.offset, one.side, at), 0.0)

    def of(name: str) -> list[float]:
        return [getattr(place, name) for place in places]

    sheet.table(
        "@ends", "Where the mechanism may lock", len(places),
        constant("k", "place", "", "", list(range(1, len(places) + 1))),
        constant("name", "what is there", "", "", [place.name for place in places], align="left"),
        constant("sign", "sign", "", "", signs),
        calc("rest", "under the root", "", "m²", rests, of("rest"), scale=slides.far(one)),
        calc("at", "slide at", "x", "m", "=IF([rest]<0,@x0,[sign]*SQRT(MAX(0,[rest])))", of("at"), scale=one.link),
        calc("d", "to the shaft", "r_B", "m", "=SQRT([at]^2+@e^2)", distances, scale=one.link),
        calc("K", "four areas of the triangle", "K", "m²", f"=IF([k]<=4,0,{slides.AREA.format(d='[d]')})",
             areas, scale=one.link**2, source="0 in line"),
        calc("psi", "angle of the lever", "ψ", "rad",
             f"=IF([k]<=4,0,{slides.ANGLE.format(x='[at]', d='[d]', k='[K]')})", angles, scale=1.0,
             source="where the link is square"),
        calc("along", "lever's end along the line", "x_A", "m", "=IF([k]<=4,[at],@r*COS([psi]))",
             of("along"), scale=one.link),
        calc("x", "locks at", "x", "m", f"=IF(AND([rest]>=0,{locks}),[at],@x0)", of("x"), scale=one.link),
        calc("below", "below the begin", "", "m", "=IF([x]<@x0,[x],0-@none)", of("below"), scale=one.link),
        calc("above", "above it", "", "m", "=IF([x]>@x0,[x],@none)", of("above"), scale=one.link),
    )  # fmt: skip


def varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other sizes for the i-th axis in the k-th variation, and how far its slide then moves (mm)."""
    lever = 60.0 + 9 * k + i
    made = {
        "lever_length": lever, "link_length": lever * (2.1 + 0.3 * k),
        "offset": lever * (0.9, 1.05, 0.7, 1.2, 0.95, 1.0)[k], "start_angle": 70.0 + 7 * k,
        "slide": ("behind", "ahead", None)[(i + k) % 3], "direction": ("forward", "backward", None)[k % 3],
    }  # fmt: skip
    return made, -0.15 * lever, 0.35 * lever
