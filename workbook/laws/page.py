"""The sheet of one law, laid out the same for every law."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable

from engine.laws import Law
from engine.laws.rise import Rise
from engine.laws.sampled import abscissae
from engine.laws.table import begins
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, given, result
from workbook.book.sentence import Said, amount
from workbook.entries.units import MM, shown, si
from workbook.laws import sampling
from workbook.laws.family import COEFFICIENTS, Page, value_at
from workbook.laws.library import NamedLaw

LONGEST_TITLE = 31  # characters of a sheet's title; Excel's limit
RESERVED = ("About", "Checks", "Laws", "History")
"""sheets that come later, and a title that Excel keeps for itself"""


def finite(value: float) -> float | str:
    """Return a number as it is, and the sign ∞ for infinity, which no cell can hold."""
    return value if math.isfinite(value) else "∞"


def law_sheet(book: Book, one: NamedLaw, intervals: int, stack: sampling.Pieces) -> None:
    """Declare the sheet of one law."""
    page, law, entered = one.page, one.law, one.entered
    sheet = book.sheet(sheet_title(one.called, [sheet.title for sheet in book.sheets]), f"{page.title} ({page.source})")
    rise = Rise(law, si(entered.lift, MM), entered.time)
    with sheet.scoped(f"{one.slug}_"):
        sheet.heading("What to enter")
        entries(sheet, one)
        sheet.heading("What comes out: the coefficients, for unit rise and time")
        coefficients(sheet, page, law)
        sheet.heading("What comes out: the rise h in the time t_a")
        risen(sheet, one, rise)
        sheet.heading(
            "Pieces",
            "On each piece a(u) = c0 + c1 u + P sin(ωu + φ), u = ξ − ξ_k; velocity and position are carried on.",
        )
        pieces_table(sheet, page, law)
        checks(sheet, one)
        draw(sheet, one.called)
        sheet.row = max(sheet.row, 50)
        sheet.print_columns = 19
        sheet.heading("Table")
        samples(sheet, rise, entered.lift, intervals, stack.locate(one.number, abscissae(intervals)))


def sheet_title(name: str, taken: Iterable[str]) -> str:
    """Return a title for the sheet of a law that Excel takes and no other sheet has."""
    plain = re.sub(r"[\[\]:*?/\\]", "-", name).strip("'")[:LONGEST_TITLE].strip("'") or "Law"
    others = {title.casefold() for title in (*taken, *RESERVED)}
    found, more = plain, 1
    while found.casefold() in others:
        more += 1
        ending = f" ({more})"
        found = plain[: LONGEST_TITLE - len(ending)] + ending
    return found


def entries(sheet: Sheet, one: NamedLaw) -> None:
    """Declare the law's name, the rise that is shown, and the law's parameters."""
    page, entered = one.page, one.entered
    sheet.rows(
        *(() if one.basic else name_of(one)),
        given("@h", "Rise shown", "h", "mm",
              entered.lift, f"{one.key}.lift", source="any; a return is negative"),
        given("@t", "Time of the rise", "t_a", "s", entered.time, f"{one.key}.time"),
        *page.constants,
        *(given(p.name, p.label, p.symbol, "",
                value_at(entered, p.key), f"{one.key}.{p.key}", format="0.0000", source=p.source)
          for p in page.parameters),
    )  # fmt: skip


def name_of(one: NamedLaw) -> tuple[Quantity, Quantity]:
    """Return the rows of a law's name, as it is and as it was when the book was built."""
    return (
        given("@called", "Name of the law", "", "",
              one.name, f"{one.key}.called", align="center", source="by which a phase takes it"),
        constant("@built", "Named when the book was built", "", "",
                 one.called, align="center", source="its sheet and its checks keep this name"),
    )  # fmt: skip


def coefficients(sheet: Sheet, page: Page, law: Law) -> None:
    """Declare the law's coefficients, and what they are worked out from."""
    for name, label, symbol in COEFFICIENTS:
        formula, words = page.coefficients[name]
        sheet.rows(
            result(f"@{name}", label, symbol, "", formula, finite(getattr(law.coefficients, name)), source=words)
        )
    if workings := page.workings(law):
        sheet.heading("Workings")
        sheet.rows(*workings)


def risen(sheet: Sheet, one: NamedLaw, rise: Rise) -> None:
    """Declare the largest velocity and accelerations of the rise."""
    sheet.rows(
        calc("@h_m", "Rise in metres", "h", "m", "=@h/1000", rise.lift, source="h / 1000"),
        result("@yv", "Largest velocity", "ẏ_max", "m/s",
               "=@cv*ABS(@h_m)/@t", rise.velocity, source="C_v h / t_a"),
        result("@ya", "Largest acceleration", "ÿ_max", "m/s²",
               "=MAX(@ca_max,-@ca_min)*ABS(@h_m)/@t^2", rise.acceleration, source="C_a h / t_a²"),
        result("@yrms", "RMS acceleration over the rise", "ÿ_rms", "m/s²",
               "=@ca_rms*ABS(@h_m)/@t^2", rise.acceleration_rms, source="C_a,rms h / t_a²"),
        calc("@no", "Number on the sheet Laws", "", "", one.finding, one.number, format="0"),
    )  # fmt: skip


def checks(sheet: Sheet, one: NamedLaw) -> None:
    """Declare the law's own checks, and that it ends where it should."""
    name = one.called
    sheet.checks(
        *(check(each.name, f"{name}: {each.label}", each.condition, True, "", f"{one.key}:{each.rule}", each.says)
          for each in one.page.checks),
        check("@ends", f"{name} ends at s = 1, at rest",
              "AND(ABS([@samples.s.last]-1)<check_zero,ABS([@samples.v.last])<check_zero)", True,
              says=ended("@samples", one.law)),
    )  # fmt: skip


def ended(samples: str, law: Law) -> Said:
    """Return the sentence on where a law ends, by the last of its ``samples``."""
    s = amount(f"[{samples}.s.last]", law.end.s, "s(1) = ", ", ")
    v = amount(f"[{samples}.v.last]", law.end.v, "v(1) = ", "")
    return Said(f"{s.says}&{v.says}", f"{s.said}{v.said}")


def pieces_table(sheet: Sheet, page: Page, law: Law) -> None:
    """Declare the law's pieces, a textbook equation beside each."""
    rows, pieces = page.pieces, law.as_pieces()
    labels = {
        "c0": ("constant", "c0", [piece.c[0] for piece in pieces]),
        "c1": ("slope", "c1", [piece.c[1] for piece in pieces]),
        "c2": ("quadratic", "c2", [piece.c[2] for piece in pieces]),
        "c3": ("cubic", "c3", [piece.c[3] for piece in pieces]),
        "P": ("amplitude", "P", [piece.amplitude for piece in pieces]),
        "omega": ("frequency", "ω", [piece.omega for piece in pieces]),
        "phi": ("phase", "φ", [piece.phase for piece in pieces]),
    }
    sheet.table(
        "@pieces", "Pieces of the law", len(rows),
        constant("name", "piece", "", "", [row.name for row in rows], align="left"),
        constant("k", "number", "k", "", list(range(1, len(rows) + 1))),
        calc("xi", "begins at", "ξ_k", "", "=IF([k]=1,0,[xi-1]+[d-1])", begins(pieces)),
        calc("d", "duration", "d", "", [row.d for row in rows], [piece.duration for piece in pieces]),
        *(calc(name, label, symbol, "", [getattr(row, name) for row in rows], values)
          for name, (label, symbol, values) in labels.items() if name in page.columns),
        constant("equation", "equation in the books", "", "", [row.equation for row in rows], align="left"),
    )  # fmt: skip


def samples(sheet: Sheet, rise: Rise, lift: float, n: int, located: sampling.Located) -> None:
    """Declare the sampled table: ξ, s, v, a, j and the dimensional y, ẏ, ÿ."""
    xi = abscissae(n)
    y, yv, ya = rise.at(xi)
    sheet.table(
        "@samples", "The law over ξ = t / t_a, and the rise h in the time t_a", n + 1,
        constant("k", "sample", "k", "", list(range(n + 1))),
        calc("xi", "abscissa", "ξ", "", "=[k]/[@samples.k.last]", xi, source="k / N", format="0.0000"),
        *sampling.shape(rise.law, xi, role=result),
        result("y", "position", "y", "mm", "=@h*[s]", shown(y, MM), scale=abs(lift), source="h s"),
        result("yv", "velocity", "ẏ", "m/s", "=@h_m/@t*[v]", yv, source="h v / t_a"),
        result("ya", "acceleration", "ÿ", "m/s²", "=@h_m/@t^2*[a]", ya, source="h a / t_a²"),
        *sampling.finding("@no", "xi", located),
    )  # fmt: skip


def draw(sheet: Sheet, name: str) -> None:
    """Place the charts of s, v, a beside the figures."""
    for row, d, words in ((5, "s", "position"), (20, "v", "velocity"), (35, "a", "acceleration")):
        chart = Chart(
            f"{name}: {words} {d}(ξ)", "ξ = t / t_a", d, (Series(d, "[@samples.xi]", f"[@samples.{d}]"),),
            f"Dimensionless {words} of the law {name} over the rise, from 0 to 1", (0, 1, 0.1),
        )  # fmt: skip
        sheet.chart(chart, column=14, row=row, width=6, height=14)
