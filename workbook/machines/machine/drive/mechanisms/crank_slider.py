"""A crank-slider in cells: what is entered, its sizes and its reach."""

from typing import Any

from engine.drive.mechanisms.slides import SlideLinkage
from workbook.book.declare import Quantity, calc, given
from workbook.book.sentence import quoted
from workbook.machines.machine.drive.driven import Driven, as_a
from workbook.machines.machine.drive.linkages import APART
from workbook.machines.machine.drive.mechanisms import slides
from workbook.machines.machine.mechanism import CrankSlider

INNER = "SQRT(MAX(0,(@l-@r)^2-@e^2))"
OUTER = "SQRT((@l+@r)^2-@e^2)"
ENDS = {
    "low": 'IF(@zero="outer","outer dead centre","inner dead centre")',
    "high": 'IF(@zero="outer","inner dead centre","outer dead centre")',
}
FITS = "@l>@r+ABS(@e)"
HOLDS = "rod longer than crank and offset"
SIZED = "COUNT(@crank_radius,@rod_length)=2"
WITHIN = "between its dead centres"
WRONG = quoted(APART["crank-slider"])
ratios = slides.ratios


def entries(driven: Driven, key: str) -> list[Quantity]:
    """Return the rows of what is entered."""
    e, key = as_a(CrankSlider, driven.given), f"{key}.mechanism"
    return [
        *slides.crank(e, key, "load"),
        given("@zero", "Positions grow from the dead centre", "", "", e.zero, f"{key}.zero", align="left",
              source="inner, or outer; inner if empty"),
        given("@branch", "The crank is, of the line from shaft to slide", "", "", e.branch, f"{key}.branch",
              align="left", source="ahead, or behind; ahead if empty"),
        given("@start", "Distance from there where the motion begins", "y_0", "mm", e.start,
              f"{key}.start", format="0.0##", source="0 if empty: then it rests in the dead centre"),
    ]  # fmt: skip


def sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the mechanism in m, and of where it can bring its load to."""
    one = as_a(SlideLinkage, driven.linkage)
    low, high, *_ = one.reach
    return [
        calc("@r", "Lever", "r", "m", "=@crank_radius/1000", one.lever),
        calc("@l", "Link", "l", "m", "=@rod_length/1000", one.link),
        calc("@e", "Offset", "e", "m", "=@offset/1000", one.offset),
        calc("@side", "Lever ahead (1) or behind (−1)", "σ", "", '=IF(@branch="behind",0-1,1)', one.side, format="0"),
        calc("@sense", "Positions grow away from the shaft (1)", "", "", '=IF(@zero="outer",0-1,1)', one.direction,
             format="0"),
        calc("@x0", "Slide from the shaft where the motion begins", "x_0", "m",
             f"=IF(@zero=\"outer\",{OUTER}-@start/1000,{INNER}+@start/1000)", one.zero,
             source="√((l ± r)² − e²) in the dead centres"),
        calc("@low", "Lowest position that is reached", "", "m", "=0-@start/1000", low, source="a dead centre"),
        calc("@high", "Highest position", "", "m", f"={OUTER}-{INNER}-@start/1000", high, source="the other one"),
        *slides.begun(one),
    ]  # fmt: skip


def varied(i: int, k: int, room: int) -> tuple[dict[str, Any], float, float]:
    """Return other sizes for the i-th axis in the k-th variation, and how far its slide then moves (mm)."""
    crank = 31.0 + 7 * k + i
    made = {
        "crank_radius": crank, "rod_length": crank * (2.6 + 0.4 * k), "start": 0.3 * crank,
        "offset": (0.0, 9.0, -14.0, None, 5.5, 0.0)[(i + k) % 6], "zero": ("inner", "outer", None)[k % 3],
        "branch": ("behind", "ahead", None)[(i + k) % 3],
    }  # fmt: skip
    return made, 0.0, 1.3 * crank
