"""The demands of a product length on the tool and its shaft: the Lengths sheet, and its two tables on Cutter."""

from collections.abc import Sequence
from dataclasses import replace

from engine.flying.cut import Beyond, Cut
from workbook.book.cell_tables import cell_tables, charts_beside, formulas_by_row
from workbook.book.declare import Book, Quantity, Sheet
from workbook.entries.facts import entry_cells
from workbook.fields.units import MM, shown
from workbook.machines.flying.entries import DRUM
from workbook.machines.flying.view import CutterView, does

CELLS = cell_tables(__file__)
CHARTS = charts_beside(__file__)

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
    CELLS["lengths"].begin(sheet)
    sheet.rows(*entry_cells(machine.given.lengths, "cutter.lengths"))
    sheet.heading("Results")
    factor = replace(CHARTS["Load factor, with its limits"], title="Load factor against product length")
    tool = (CHARTS[f"{what} of the tool against product length"] for what in ("Speed", "Acceleration"))
    sheet.chart_row(*tool, factor, width=6, height=18)
    cuts, cell = [machine.of(length) for length in machine.lengths], CELLS["lengths"]
    cell.sharing(n=n + 1).place(
        sheet,
        cell("length", machine.lengths),
        *lengths_columns(machine, cuts, "[length]", "fly_beyond"),
        cell("k", list(range(n + 1))),
    )
    line(book, machine, cuts)
    sheet.print_columns = 17


def line(book: Book, machine: CutterView, cuts: Sequence[Cut]) -> None:
    """Declare the lines at the product entered, at L_0 and at L_p,lim, as drawn in the charts."""
    cell = CELLS["length_line"]
    low, high = min(c.speed_range[0] for c in cuts), max(c.speed_range[1] for c in cuts)
    peak = max(c.max_acceleration for c in cuts)
    beta = max(machine.task(c).load_factor for c in cuts)
    entered, e = machine.given.product_length, machine.given.lengths
    among = "=IF(AND({0}>fly_short,{0}<fly_long),{0},fly_length)"

    def within(length: float) -> float:
        return length if e.shortest < length < e.longest else entered

    cell.place(
        book.sheets[-1],
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
    CELLS["cases"].begin(sheet)
    cell, formulas = CELLS["cases"], formulas_by_row(__file__, "by length")
    longest = max(e.lengths.longest, e.product_length)
    cell.place(
        sheet,
        cell("case", formulas["case"]),
        cell("low", [min(tool, whole), whole, whole, max(tool, limit)], formula=formulas["low"]),
        cell("high", [whole, whole, limit, longest], formula=formulas["high"]),
        cell("here", ["is here" if k == machine.case else "-" for k in range(1, 5)]),
        cell("k", [1, 2, 3, 4]),
    )
    ways: tuple[Beyond, ...] = ("standstill", "reversal")
    cuts = [machine.of(machine.given.product_length, way) for way in ways]
    CELLS["strategies"].begin(sheet)
    CELLS["strategies"].place(
        sheet, CELLS["strategies"]("way", list(ways)), *lengths_columns(machine, cuts, "fly_length", "[way]")
    )
