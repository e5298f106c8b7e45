"""The demands of a product length on the tool and its shaft: the Lengths sheet, and its two tables on Cutter."""

from collections.abc import Sequence

from engine.flying.cut import Beyond, Cut
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet
from workbook.entries.facts import entry_cells
from workbook.fields.units import MM, shown
from workbook.machines.flying.entries import DRUM
from workbook.machines.flying.view import CutterView, does

CELLS = cell_tables(__file__)

IS_DRUM = f'fly_kind="{DRUM}"'


def waits(length: str, way: str) -> str:
    """Return the formula, without =, of whether the drum waits with products of a length."""
    return f'AND({IS_DRUM},{way}="standstill",{length}>fly_limit)'


def lengths_columns(machine: CutterView, cuts: Sequence[Cut], length: str, way: str) -> list[Quantity]:
    """Return the columns of speeds, accelerations and load factor of cuts; ``length`` and ``way`` refer to cells."""
    cell = CELLS["lengths_columns"]

    def of(name: str, unit: float = 1.0) -> list[float]:
        return [shown(getattr(cut, name), unit) for cut in cuts]

    in_words = '=IF([waits]=1,"waits",IF([low]<0-fly_near*fly_v,"reverses","keeps moving"))'
    return [
        cell("does", [does(cut) for cut in cuts], formula=in_words),
        cell("low", [cut.speed_range[0] for cut in cuts]),
        cell("high", [cut.speed_range[1] for cut in cuts]),
        cell("a", of("max_acceleration")),
        cell("a_rms", of("rms_acceleration"), length=length),
        cell("beta", [machine.task(cut).load_factor for cut in cuts]),
        cell("h", of("displacement", MM), length=length),
        cell("tr", of("repositioning_time"), length=length),
        cell("waits", [float(c.waits) for c in cuts], waits=waits(length, way)),
        cell("tm", of("moving_time")),
        cell("h1", of("superimposed", MM)),
        cell("dv", of("speed_change")),
        cell("dw", of("rms_angular_acceleration")),
    ]


def lengths_sheet(book: Book, machine: CutterView) -> None:
    """Declare the sheet: charts, then the table of product lengths."""
    sheet = book.sheet("Lengths", "Speeds, accelerations and load factor over the product length, at this line speed.")
    n = machine.sizes.lengths
    sheet.heading("Enter", "Everything else is taken from the sheet Cutter.")
    sheet.rows(*entry_cells(machine.given.lengths, "cutter.lengths"))
    sheet.heading("Results")
    charts = [
        ("Speed of the tool", "speed [m/s]", (("lowest", "low"), ("highest", "high")), "speed"),
        ("Acceleration of the tool", "acceleration [m/s²]", (("peak", "a"), ("RMS over the cycle", "a_rms")), "a"),
        ("Load factor", "β [W/s]", (("load factor", "beta"),), "beta"),
    ]
    sheet.chart_row(
        *(
            Chart(
                f"{title} against product length",
                "product length L_p [mm]",
                unit,
                (
                    *(Series(name, "[lengths.length]", f"[lengths.{column}]") for name, column in lines),
                    Series("product entered", "[length_line.x]", f"[length_line.{at}]", dashed=True),
                    Series("design length L_0", "[length_line.x0]", f"[length_line.{at}]", dashed=True, color="7F7F7F"),
                    Series("L_p,lim", "[length_line.x1]", f"[length_line.{at}]", dashed=True, color="C00000"),
                ),
                f"{title} over the product length; marked are the product entered, L_0 and L_p,lim",
            )
            for title, unit, lines, at in charts
        ),
        width=6,
        height=18,
    )
    cuts = [machine.of(length) for length in machine.lengths]
    sheet.table(
        "lengths",
        f"{n + 1} product lengths",
        n + 1,
        CELLS["lengths"]("length", machine.lengths),
        *lengths_columns(machine, cuts, "[length]", "fly_beyond"),
        CELLS["lengths"]("k", list(range(n + 1))),
    )
    line(book, machine, cuts)
    sheet.print_columns = 17


def line(book: Book, machine: CutterView, cuts: Sequence[Cut]) -> None:
    """Declare the lines at the product entered, at L_0 and at L_p,lim, as drawn in the charts."""
    cell = CELLS["length_line"]
    low, high = min(c.speed_range[0] for c in cuts), max(c.speed_range[1] for c in cuts)
    peak, beta = max(c.max_acceleration for c in cuts), max(machine.task(c).load_factor for c in cuts)
    entered, e = machine.given.product_length, machine.given.lengths
    among = "=IF(AND({0}>fly_short,{0}<fly_long),{0},fly_length)"

    def within(length: float) -> float:
        return length if e.shortest < length < e.longest else entered

    book.sheets[-1].table(
        "length_line",
        "The product entered, L_0 and L_p,lim, as drawn in the charts",
        2,
        cell("end", [0, 1]),
        cell("x", entered),
        cell("x0", within(shown(machine.tool.design_length, MM)), formula=among.format("fly_l0")),
        cell("x1", within(machine.limit), formula=among.format("fly_limit")),
        cell("speed", [min(0.0, low), high]),
        cell("a", [0.0, peak]),
        cell("beta", [0.0, beta]),
    )


def cases(sheet: Sheet, machine: CutterView) -> None:
    """Declare the cases that the product length decides between, and both ways of a product too long to keep moving."""
    e, limit = machine.given, machine.limit
    tool, whole = shown(machine.tool.tool_length, MM), shown(machine.tool.design_length, MM)
    sheet.heading(
        "The cases by product length", "S5, 'Variable length cut'; a saw has no design length, and always reverses."
    )
    sheet.table(
        "cases",
        "From one length to the next",
        4,
        CELLS["cases"](
            "case", ["faster than the line", "in step with the line", "slower than the line", "waits, or reverses"]
        ),
        CELLS["cases"](
            "low",
            [min(tool, whole), whole, whole, max(tool, limit)],
            formula=["=MIN(fly_lt,fly_l0)", "=fly_l0", "=fly_l0", "=MAX(fly_lt,fly_limit)"],
        ),
        CELLS["cases"](
            "high",
            [whole, whole, limit, max(e.lengths.longest, e.product_length)],
            formula=["=fly_l0", "=fly_l0", "=fly_limit", "=MAX(fly_long,fly_length)"],
        ),
        CELLS["cases"]("here", ["is here" if k == machine.case else "-" for k in range(1, 5)]),
        CELLS["cases"]("k", [1, 2, 3, 4]),
    )
    ways: tuple[Beyond, ...] = ("standstill", "reversal")
    cuts = [machine.of(machine.given.product_length, way) for way in ways]
    sheet.heading(
        "Standstill or reversal", "What this product asks for either way; the same unless it is longer than L_p,lim."
    )
    sheet.table(
        "strategies",
        "Both ways with products longer than L_p,lim",
        2,
        CELLS["strategies"]("way", list(ways)),
        *lengths_columns(machine, cuts, "fly_length", "[way]"),
    )
