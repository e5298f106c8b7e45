"""What a product length asks of the tool and its shaft: the Lengths sheet, and both tables of it on Cutter."""

from collections.abc import Sequence

from engine.flying.cut import Beyond, Cut
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, constant, given, result
from workbook.fields.units import MM, shown
from workbook.machines.flying.entries import DRUM
from workbook.machines.flying.view import CutterView, does

IS_DRUM = f'fly_kind="{DRUM}"'


def waits(length: str, way: str) -> str:
    """Return the formula, without =, of whether the drum waits with products of a length."""
    return f'AND({IS_DRUM},{way}="standstill",{length}>fly_limit)'


def lengths_columns(machine: CutterView, cuts: Sequence[Cut], length: str, way: str) -> list[Quantity]:
    """Return the columns of speeds, accelerations and load factor of cuts; ``length`` and ``way`` refer to cells."""

    def of(name: str, unit: float = 1.0) -> list[float]:
        return [shown(getattr(cut, name), unit) for cut in cuts]

    in_words = '=IF([waits]=1,"waits",IF([low]<0-fly_near*fly_v,"reverses","keeps moving"))'
    return [
        result("does", "the tool", "", "", in_words, [does(cut) for cut in cuts]),
        result("low", "lowest speed", "v_min", "m/s", "=MIN(fly_v,fly_v+[dv])", [cut.speed_range[0] for cut in cuts]),
        result("high", "highest speed", "v_max", "m/s", "=MAX(fly_v,fly_v+[dv])", [cut.speed_range[1] for cut in cuts]),
        result("a", "peak acceleration", "a_max", "m/s²",
               "=fly_ca*ABS([h1])/1000/[tm]^2", of("max_acceleration"), "C_a h/t_m²"),
        result("a_rms", "RMS acceleration", "a_rms", "m/s²",
               f"=fly_ca_rms*ABS([h1])/1000/[tm]^2*SQRT([tm]*fly_v/({length}/1000))", of("rms_acceleration"),
               "C_a,rms h/t_m² √(t_m/t_C)"),
        result("beta", "load factor", "β", "W/s", "=2*([dw]*SQRT(fly_torque^2+(fly_j*[dw])^2)+fly_j*[dw]^2)",
               [machine.task(cut).load_factor for cut in cuts], "S5, eqs. (15), (19)"),
        calc("h", "dynamic displacement", "h", "mm", f"=fly_l0-{length}", of("displacement", MM), "L_0 − L_p"),
        calc("tr", "re-positioning time", "t_R", "s",
             f"=({length}-fly_lt)/1000/fly_v", of("repositioning_time"), "(L_p − L_T)/v_L"),
        calc("waits", "waits", "", "", f"=IF({waits(length, way)},1,0)", [float(c.waits) for c in cuts],
             "1: beyond L_p,lim", format="0"),
        calc("tm", "motion time", "t_m", "s",
             "=IF([waits]=1,fly_cv/(fly_cv-1)*fly_lr/1000/fly_v,[tr])", of("moving_time")),
        calc("h1", "displacement by the law", "h", "mm",
             "=IF([waits]=1,0-fly_v*1000*[tm]/fly_cv,[h])", of("superimposed", MM)),
        calc("dv", "change of speed", "Δv_max", "m/s", "=fly_cv*[h1]/1000/[tm]", of("speed_change"), "S5, eq. (10)"),
        calc("dw", "RMS of the shaft", "ω̇_rms", "rad/s²", "=[a_rms]*1000/fly_r", of("rms_angular_acceleration"),
             "S5, eq. (13)"),
    ]  # fmt: skip


def lengths_sheet(book: Book, machine: CutterView) -> None:
    """Declare the sheet: charts, then the table of product lengths."""
    sheet = book.sheet("Lengths", "Speeds, accelerations and load factor over the product length, at this line speed.")
    e, n = machine.given.lengths, machine.sizes.lengths
    sheet.heading("Enter", "Everything else is taken from the sheet Cutter.")
    sheet.rows(
        given("fly_short", "Shortest product", "", "mm", e.shortest, "cutter.lengths.shortest", format="0.0##",
              source="longer than the tool length L_T: there everything becomes infinite"),
        given("fly_long", "Longest product", "", "mm", e.longest, "cutter.lengths.longest", format="0.0##"),
    )  # fmt: skip
    sheet.heading("Results")
    charts = [
        ("Speed of the tool", "speed [m/s]", (("lowest", "low"), ("highest", "high")), "speed"),
        ("Acceleration of the tool", "acceleration [m/s²]", (("peak", "a"), ("RMS over the cycle", "a_rms")), "a"),
        ("Load factor", "β [W/s]", (("load factor", "beta"),), "beta"),
    ]
    sheet.chart_row(
        *(Chart(f"{title} against product length", "product length L_p [mm]", unit, (
            *(Series(name, "[lengths.length]", f"[lengths.{column}]") for name, column in lines),
            Series("product entered", "[length_line.x]", f"[length_line.{at}]", dashed=True),
            Series("design length L_0", "[length_line.x0]", f"[length_line.{at}]", dashed=True, color="7F7F7F"),
            Series("L_p,lim", "[length_line.x1]", f"[length_line.{at}]", dashed=True, color="C00000")),
            f"{title} over the product length; marked are the product entered, L_0 and L_p,lim")
          for title, unit, lines, at in charts),
        width=7, height=18,
    )  # fmt: skip
    cuts = [machine.of(length) for length in machine.lengths]
    sheet.table(
        "lengths", f"{n + 1} product lengths", n + 1,
        calc("length", "product length", "L_p", "mm",
             "=fly_short+[k]*(fly_long-fly_short)/[lengths.k.last]", machine.lengths),
        *lengths_columns(machine, cuts, "[length]", "fly_beyond"),
        constant("k", "row", "k", "", list(range(n + 1))),
    )  # fmt: skip
    line(book, machine, cuts)
    sheet.print_columns = 20


def line(book: Book, machine: CutterView, cuts: Sequence[Cut]) -> None:
    """Declare the lines at the product entered, at L_0 and at L_p,lim, as drawn in the charts."""
    low, high = min(c.speed_range[0] for c in cuts), max(c.speed_range[1] for c in cuts)
    peak, beta = max(c.max_acceleration for c in cuts), max(machine.task(c).load_factor for c in cuts)
    entered, e = machine.given.product_length, machine.given.lengths
    among = "=IF(AND({0}>fly_short,{0}<fly_long),{0},fly_length)"

    def within(length: float) -> float:
        return length if e.shortest < length < e.longest else entered

    book.sheets[-1].table(
        "length_line", "The product entered, L_0 and L_p,lim, as drawn in the charts", 2,
        constant("end", "end of the line", "", "", [0, 1]),
        calc("x", "product", "L_p", "mm", "=fly_length", entered),
        calc("x0", "design length", "L_0", "mm", among.format("fly_l0"), within(shown(machine.tool.design_length, MM)),
             "L_p where it is not among these lengths"),
        calc("x1", "limit", "L_p,lim", "mm",
             among.format("fly_limit"), within(machine.limit), "L_p where it is not among these lengths"),
        calc("speed", "speed", "", "m/s",
             "=IF([end]=0,MIN(0,MIN([lengths.low])),MAX([lengths.high]))", [min(0.0, low), high]),
        calc("a", "acceleration", "", "m/s²", "=[end]*MAX([lengths.a])", [0.0, peak]),
        calc("beta", "load factor", "", "W/s", "=[end]*MAX([lengths.beta])", [0.0, beta]),
    )  # fmt: skip


def cases(sheet: Sheet, machine: CutterView) -> None:
    """Declare the cases that the product length decides between, and both ways with one too long to keep moving."""
    e, limit = machine.given, machine.limit
    tool, whole = shown(machine.tool.tool_length, MM), shown(machine.tool.design_length, MM)
    sheet.heading(
        "The cases by product length", "S5, 'Variable length cut'; a saw has no design length, and always reverses."
    )
    sheet.table(
        "cases", "From one length to the next", 4,
        constant("case", "re-positioning", "", "",
                 ["faster than the line", "in step with the line", "slower than the line", "waits, or reverses"],
                 align="left"),
        calc("low", "longer than", "", "mm", ["=MIN(fly_lt,fly_l0)", "=fly_l0", "=fly_l0", "=MAX(fly_lt,fly_limit)"],
             [min(tool, whole), whole, whole, max(tool, limit)]),
        calc("high", "up to", "", "mm", ["=fly_l0", "=fly_l0", "=fly_limit", "=MAX(fly_long,fly_length)"],
             [whole, whole, limit, max(e.lengths.longest, e.product_length)]),
        result("here", "the product", "", "", '=IF([k]=fly_row,"is here","-")',
               ["is here" if k == machine.case else "-" for k in range(1, 5)], align="center"),
        constant("k", "row", "k", "", [1, 2, 3, 4]),
    )  # fmt: skip
    ways: tuple[Beyond, ...] = ("standstill", "reversal")
    cuts = [machine.of(machine.given.product_length, way) for way in ways]
    sheet.heading(
        "Standstill or reversal", "What this product asks for either way; the same unless it is longer than L_p,lim."
    )
    sheet.table(
        "strategies", "Both ways with products longer than L_p,lim", 2,
        constant("way", "way", "", "", list(ways)),
        *lengths_columns(machine, cuts, "fly_length", "[way]"),
    )  # fmt: skip
