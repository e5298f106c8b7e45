"""The sheet of a law, laid out the same for every law."""

import math
from collections.abc import Sequence

import numpy as np

from engine.laws.piece import begins
from engine.motion import Phase
from workbook.book.cell_tables import cell_tables
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, given, result
from workbook.entries.machine import Sizes
from workbook.fields.paths import get, split
from workbook.fields.texts import sheet_title
from workbook.fields.units import MM, shown, si
from workbook.law_sheets.library import NamedLaw
from workbook.laws import sampling
from workbook.laws.family import ADDS, BEHIND, COEFFICIENTS, LABELS, Parameter, entries_of

CELLS = cell_tables(__file__)


def finite(value: float) -> float | str:
    """Return a number as it is, and the sign ∞ for infinity, which no cell can hold."""
    return value if math.isfinite(value) else "∞"


def law_sheet(book: Book, named: NamedLaw, sizes: Sizes, stack: sampling.Pieces) -> None:
    """Declare the sheet of a law."""
    cell = CELLS["pieces"]
    page, law, entered = named.page, named.law, named.entered
    title = sheet_title(named.called, [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"{page.title} ({page.source})")
    sheet.called = named.called
    rise = Phase(law, si(entered.lift, MM), entered.time)
    with sheet.scoped(f"{named.slug}_"):
        sheet.heading("Enter")
        entries(sheet, named)
        page.enter(sheet, named, sizes)
        results(sheet, named, rise)
        page.work(sheet, named, stack, sizes)
        if page.pieces:
            a = " + ".join(words for name, words in ADDS.items() if name in page.columns) or "0"
            sheet.heading("Pieces", f"On each piece a(u) = {a}, u = ξ − ξ_k; velocity and position are carried on.")
            rows, pieces = page.pieces, law.monotone_pieces()
            values = [entries_of(piece) for piece in pieces]

            def column(name: str) -> Quantity:
                formulas = [row.formulas[name] for row in rows]
                return calc(name, *LABELS[name], "", formulas, [entry[name] for entry in values])

            cell.place(
                sheet,
                cell("name", [row.name for row in rows]),
                cell("k", list(range(1, len(rows) + 1))),
                cell("xi", begins(pieces)),
                *map(column, page.columns),
                cell("equation", [row.equation for row in rows]),
            )
        sheet.checks(*page.verdicts(named, sizes))
        for row, d, words in ((5, "s", "position"), (20, "v", "velocity"), (35, "a", "acceleration")):
            chart = Chart(
                f"{named.called}: {words} {d}(ξ)",
                "ξ = t / t_a",
                d,
                (Series(d, "[@samples.xi]", f"[@samples.{d}]"),),
                f"Dimensionless {words} of the law {named.called} over the rise, from 0 to 1",
                (0, 1, 0.1),
            )
            sheet.chart(chart, column=BEHIND - 6, row=row, width=6, height=14)
        sheet.row = max(sheet.row, 50)
        sheet.print_columns = BEHIND - 1
        sheet.unprinted = "laws" not in book.print_also
        sheet.heading("Table")
        samples(sheet, rise, entered.lift, sizes.law, stack, page.of_pieces or page.columns)
        page.detail(sheet, named, stack, sizes)


def entries(sheet: Sheet, named: NamedLaw) -> None:
    """Declare the law's name, the rise that is shown, and the law's parameters."""
    cell = CELLS["entries"]
    page, entered = named.page, named.entered
    called = [] if named.basic else [cell("@called", named.name, named=named), cell("@built", named.called)]
    rise = [cell("@h", entered.lift, named=named), cell("@t", entered.time, named=named)]

    def parameter(p: Parameter) -> Quantity:
        value, key = get(entered, split(p.key)), f"{named.key}.{p.key}"
        return given(p.name, p.label, p.symbol, "", value, key, format="0.0000", source=p.source)

    sheet.rows(*called, *rise, *map(parameter, page.parameters))


def results(sheet: Sheet, named: NamedLaw, rise: Phase) -> None:
    """Declare the law's coefficients and what they are worked out from, then the largest rates of the rise."""
    cell = CELLS["results"]
    page, law = named.page, named.law
    sheet.heading("Results: the coefficients, for unit rise and time")
    for name, label, symbol in COEFFICIENTS:
        formula, words = page.coefficients[name]
        value = finite(getattr(law.coefficients, name))
        texts = {"name": name, "label": label, "symbol": symbol, "formula": formula}
        sheet.rows(cell("@{name}", value, source=words, **texts))
    if workings := page.workings(law):
        sheet.heading("Workings")
        sheet.rows(*workings)
    finding = f'=MATCH("{named.name}",law_code,0)' if named.basic else "=MATCH(@called,law_code,0)"
    sheet.heading("Results: the rise h in the time t_a")
    sheet.rows(
        cell("@h_m", rise.lift),
        cell("@yv", rise.y1_max),
        cell("@ya", rise.y2_max),
        cell("@yrms", rise.y2_rms),
        cell("@no", named.number, formula=finding),
    )


def samples(sheet: Sheet, rise: Phase, lift: float, n: int, stack: sampling.Pieces, entries: Sequence[str]) -> None:
    """Declare the sampled table: ξ, s, v, a, j and the dimensional y, ẏ, ÿ, by the ``entries`` that pieces may have."""
    cell = CELLS["samples"]
    xi = np.arange(n + 1) / n
    at, h, t = rise.law.evaluate(xi), rise.lift, rise.duration
    cell.place(
        sheet,
        cell("k", list(range(n + 1))),
        cell("xi", xi),
        *stack.columns(dict(zip("svaj", at, strict=True)), "svaj", result, entries),
        cell("y", shown(h * at.s, MM), scale=abs(lift)),
        cell("yv", h / t * at.v),
        cell("ya", h / t**2 * at.a),
        *stack.finding("@no", stack.number(rise.law), "xi", xi, entries),
    )
