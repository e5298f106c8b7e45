"""What a margin costs one tool: its angles and its acceleration for margins from 0 to the whole clearance."""

from __future__ import annotations

from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet, calc, constant, result
from workbook.entries.units import DEGREE, MM, shown
from workbook.machines.overlap.view import Station


def margins(sheet: Sheet, station: Station) -> None:
    """Declare charts and table, in the tool's scope."""
    sheet.heading(
        "What a margin costs", "The longest angles less the allowance, for margins from 0 to the whole clearance."
    )
    draw(sheet)
    sweep, n = station.margins, station.machine.sizes.margins
    row_in, row_out = station.law_rows
    ways = f"MAX([used.ca.{row_in}]/[in]^2,[used.ca.{row_out}]/[out]^2)"
    peak = f"=IF(MIN([in],[out])>0,{ways}*@stroke/1000*(360/overlap_tc)^2,0)"
    sheet.table(
        "@margins", "Ratio against margin", n + 1,
        calc("margin", "margin", "m", "mm", "=[k]/[@margins.k.last]*@clearance", shown(sweep.margin, MM)),
        result("in", "way in", "B_m", "°", way("in", "@split"), shown(sweep.angle_in, DEGREE)),
        result("out", "way out", "B_m", "°", way("out", "(1-@split)"), shown(sweep.angle_out, DEGREE)),
        result("a", "peak acceleration", "a_max", "m/s²", peak, sweep.acceleration, source="C_a h/t_m²"),
        result("ratio", "times lower", "", "", "=IF([a]>0,@a0/[a],0)", sweep.ratio),
        constant("k", "row", "k", "", list(range(n + 1))),
    )  # fmt: skip
    sheet.table(
        "@margin_line", "The margin entered, as drawn in the charts", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("x", "margin", "m", "mm", "=@margin", station.given.passage.margin),
        calc("ratio", "times lower", "", "", "=[end]*MAX([@margins.ratio])", [0.0, float(sweep.ratio.max())]),
        calc("a", "peak acceleration", "a_max", "m/s²",
             "=[end]*MAX([@margins.a])", [0.0, float(sweep.acceleration.max())]),
    )  # fmt: skip


def draw(sheet: Sheet) -> None:
    """Place both charts side by side."""
    sheet.chart_row(
        Chart("Acceleration ratio against margin", "margin m [mm]", "times lower", (
            Series("times lower", "[@margins.margin]", "[@margins.ratio]"),
            Series("margin entered", "[@margin_line.x]", "[@margin_line.ratio]", dashed=True)),
            "How many times the peak acceleration falls, over the margin that stays free between the parts"),
        Chart("Peak acceleration against margin", "margin m [mm]", "a_max [m/s²]", (
            Series("peak acceleration", "[@margins.margin]", "[@margins.a]"),
            Series("margin entered", "[@margin_line.x]", "[@margin_line.a]", dashed=True)),
            "Peak acceleration of the tool over the margin that stays free between the parts"),
        width=7,
    )  # fmt: skip


def way(which: str, share: str) -> str:
    """Return the angle of one way at the margin of the row."""
    xi = f"INDEX([@inverse_{which}.xi],[k]+2)"
    rest = f"(1-{xi})" if which == "in" else xi
    most = f"@room*{share}"
    return f"=IF({rest}>0,MIN(@free_{which}/{rest},{most}),{most})-@allowance"
