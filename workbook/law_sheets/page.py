"""The sheet of one law, laid out the same for every law."""

import math
from collections.abc import Sequence

import numpy as np

from engine.laws.piece import begins
from engine.motion import Phase
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, constant, given, result
from workbook.entries.machine import Sizes
from workbook.fields.paths import get, split
from workbook.fields.texts import sheet_title
from workbook.fields.units import MM, shown, si
from workbook.law_sheets.library import NamedLaw
from workbook.laws import sampling
from workbook.laws.family import BEHIND, COEFFICIENTS, LABELS, entries_of

SPELLED = {  # what the columns of a table of pieces add to a(u)
    "c0": "c0", "c1": "c1 u", "c2": "c2 u²", "c3": "c3 u³", "c4": "c4 u⁴", "c5": "c5 u⁵",
    "P": "P sin(ωu + φ)", "P2": "P₂ sin(ω₂u + φ₂)",
}  # fmt: skip


def finite(value: float) -> float | str:
    """Return a number as it is, and the sign ∞ for infinity, which no cell can hold."""
    return value if math.isfinite(value) else "∞"


def law_sheet(book: Book, named: NamedLaw, sizes: Sizes, stack: sampling.Pieces) -> Sheet:
    """Declare the sheet of one law, and return it."""
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
            a = " + ".join(words for name, words in SPELLED.items() if name in page.columns) or "0"
            sheet.heading("Pieces", f"On each piece a(u) = {a}, u = ξ − ξ_k; velocity and position are carried on.")
            rows, pieces = page.pieces, law.monotone_pieces()
            values = [entries_of(piece) for piece in pieces]
            sheet.table(
                "@pieces", "Pieces of the law", len(rows),
                constant("name", "piece", "", "", [row.name for row in rows], align="left"),
                constant("k", "number", "k", "", list(range(1, len(rows) + 1))),
                calc("xi", "begins at", "ξ_k", "", "=IF([k]=1,0,[xi-1]+[d-1])", begins(pieces)),
                *(calc(name, *LABELS[name], "", [row.formulas[name] for row in rows], [entry[name] for entry in values])
                  for name in page.columns),
                constant("equation", "equation in the books", "", "", [row.equation for row in rows], align="left"),
            )  # fmt: skip
        sheet.checks(*page.verdicts(named, sizes))
        for row, d, words in ((5, "s", "position"), (20, "v", "velocity"), (35, "a", "acceleration")):
            chart = Chart(
                f"{named.called}: {words} {d}(ξ)", "ξ = t / t_a", d, (Series(d, "[@samples.xi]", f"[@samples.{d}]"),),
                f"Dimensionless {words} of the law {named.called} over the rise, from 0 to 1", (0, 1, 0.1),
            )  # fmt: skip
            sheet.chart(chart, column=BEHIND - 6, row=row, width=6, height=14)
        sheet.row = max(sheet.row, 50)
        sheet.print_columns = BEHIND - 1
        sheet.one_page = True
        sheet.heading("Table")
        samples(sheet, rise, entered.lift, sizes.law, stack, page.of_pieces or page.columns)
        page.detail(sheet, named, stack, sizes)
    return sheet


def entries(sheet: Sheet, named: NamedLaw) -> None:
    """Declare the law's name, the rise that is shown, and the law's parameters."""
    page, entered = named.page, named.entered
    called = (
        given("@called", "Name of the law", "", "",
              named.name, f"{named.key}.called", align="center", source="by which a phase takes it"),
        constant("@built", "Named when the book was built", "", "",
                 named.called, align="center", source="the sheet and its checks keep this name"),
    )  # fmt: skip
    sheet.rows(
        *(() if named.basic else called),
        given("@h", "Rise shown", "h", "mm", entered.lift, f"{named.key}.lift", source="any; a return is negative"),
        given("@t", "Time of the rise", "t_a", "s", entered.time, f"{named.key}.time"),
        *(given(p.name, p.label, p.symbol, "",
                get(entered, split(p.key)), f"{named.key}.{p.key}", format="0.0000", source=p.source)
          for p in page.parameters),
    )  # fmt: skip


def results(sheet: Sheet, named: NamedLaw, rise: Phase) -> None:
    """Declare the law's coefficients and what they are worked out from, then the largest rates of the rise."""
    page, law = named.page, named.law
    sheet.heading("Results: the coefficients, for unit rise and time")
    for name, label, symbol in COEFFICIENTS:
        formula, words = page.coefficients[name]
        value = finite(getattr(law.coefficients, name))
        sheet.rows(result(f"@{name}", label, symbol, "", formula, value, source=words))
    if workings := page.workings(law):
        sheet.heading("Workings")
        sheet.rows(*workings)
    finding = f'=MATCH("{named.name}",law_code,0)' if named.basic else "=MATCH(@called,law_code,0)"
    sheet.heading("Results: the rise h in the time t_a")
    sheet.rows(
        calc("@h_m", "Rise in metres", "h", "m", "=@h/1000", rise.lift, source="h / 1000"),
        result("@yv", "Largest velocity", "ẏ_max", "m/s", "=@cv*ABS(@h_m)/@t", rise.y1_max, source="C_v h / t_a"),
        result("@ya", "Largest acceleration", "ÿ_max", "m/s²",
               "=MAX(@ca_max,-@ca_min)*ABS(@h_m)/@t^2", rise.y2_max, source="C_a h / t_a²"),
        result("@yrms", "RMS acceleration over the rise", "ÿ_rms", "m/s²",
               "=@ca_rms*ABS(@h_m)/@t^2", rise.y2_rms, source="C_a,rms h / t_a²"),
        calc("@no", "Number on the sheet Laws", "", "", finding, named.number, format="0"),
    )  # fmt: skip


def samples(sheet: Sheet, rise: Phase, lift: float, n: int, stack: sampling.Pieces, entries: Sequence[str]) -> None:
    """Declare the sampled table: ξ, s, v, a, j and the dimensional y, ẏ, ÿ, by the ``entries`` that pieces may have."""
    xi = np.arange(n + 1) / n
    at, h, t = rise.law.evaluate(xi), rise.lift, rise.duration
    sheet.table(
        "@samples", "The law over ξ = t / t_a, and the rise h in the time t_a", n + 1,
        constant("k", "sample", "k", "", list(range(n + 1))),
        calc("xi", "abscissa", "ξ", "", "=[k]/[@samples.k.last]", xi, source="k / N", format="0.0000"),
        *stack.columns(dict(zip("svaj", at, strict=True)), "svaj", result, entries),
        result("y", "position", "y", "mm", "=@h*[s]", shown(h * at.s, MM), scale=abs(lift), source="h s"),
        result("yv", "velocity", "ẏ", "m/s", "=@h_m/@t*[v]", h / t * at.v, source="h v / t_a"),
        result("ya", "acceleration", "ÿ", "m/s²", "=@h_m/@t^2*[a]", h / t**2 * at.a, source="h a / t_a²"),
        *stack.finding("@no", stack.number(rise.law), "xi", xi, entries),
    )  # fmt: skip
