"""The Inverse sheet: at which share of its time a law has reached a share of its rise, for any law of the book.

The piece is found by one MATCH on the positions carried from piece to piece; within it the height is located by
halving, which alone reaches 1e-9, then two steps of Newton's method take it to the last digits.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from engine.halving import middles, newton_step
from engine.laws import Law
from engine.laws.base import BREAK_TOLERANCE, Array
from engine.laws.inverse import inverse
from engine.laws.points import slowest
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, result
from workbook.book.rows import filled
from workbook.book.sentence import amount
from workbook.entries.units import MM, shown
from workbook.laws.stack import Row
from workbook.machines.overlap.view import Overlapping, Station

HALVINGS = 30
NEWTON = 2
NEAR = 1e-13  # of the rise: an s this near counts as reached, so that rounding never decides a halving
SLOW = 1e-6  # dimensionless velocity below which Newton's method is left out
BEYOND = 2.0
COEFFICIENTS = (
    ("xk", "start of the piece", "ξ_k", "xi"), ("d", "its duration", "d", "d"),
    ("s0", "constant of position", "S0", "s0"), ("s1", "slope of position", "S1", "s1"),
    ("c0", "constant", "c0", "c0"), ("c1", "slope", "c1", "c1"), ("c2", "quadratic", "c2", "c2"),
    ("c3", "cubic", "c3", "c3"), ("c4", "quartic", "c4", "c4"), ("c5", "quintic", "c5", "c5"),
    ("ps", "sine of position", "P/ω²", "ps"), ("pv", "cosine of velocity", "P/ω", "pv"),
    ("omega", "frequency", "ω", "omega"), ("phi", "phase", "φ", "phi"),
)  # fmt: skip
CARRIED = "=IF([k]<=[used.count.{0}],INDEX(piece_s,[used.skip.{0}]+MIN([k],[used.count.{0}])),inverse_beyond)"
SECOND = (
    ("ps2", "second sine of position", "P₂/ω₂²", "ps2"), ("pv2", "second cosine of velocity", "P₂/ω₂", "pv2"),
    ("omega2", "its frequency", "ω₂", "omega2"), ("phi2", "its phase", "φ₂", "phi2"),
)  # fmt: skip
"""in a book with a law of two sines"""
HEIGHT = (
    "=[s0]+[{t}]*([s1]+[{t}]*([c0]/2+[{t}]*([c1]/6+[{t}]*([c2]/12+[{t}]*([c3]/20+[{t}]*([c4]/30+[{t}]*[c5]/42))))))"
    "-[ps]*SIN([omega]*[{t}]+[phi])"
)
SLOPE = (
    "=[s1]+[{t}]*([c0]+[{t}]*([c1]/2+[{t}]*([c2]/3+[{t}]*([c3]/4+[{t}]*([c4]/5+[{t}]*[c5]/6)))))"
    "-[pv]*COS([omega]*[{t}]+[phi])"
)
SWING, TURN = "-[ps2]*SIN([omega2]*[{t}]+[phi2])", "-[pv2]*COS([omega2]*[{t}]+[phi2])"
HALVE = "=[t{k}]+IF(AND([s]>0,[f{k}]<=[s]+inverse_near),1,0-1)*ABS([t{k}]-{before})/2"
STEP = "=MAX(0,MIN([d],[{t}]-IF([{v}]>inverse_slow,([{s}]-[s])/[{v}],0)))"


Column = tuple[str, str, str, str]
"""of a piece: its name here, its label and symbol, and its name in the stack"""


class Wanted(NamedTuple):
    """The rows of one table: which of the laws in use, its heights s, and the columns that say where they come from."""

    use: int
    code: str
    law: Law
    s: Array
    formula: Any
    head: tuple[Quantity, ...]


def inverse_sheet(book: Book, machine: Overlapping, rows: list[Row], second: bool) -> None:
    """Declare the sheet: the laws in use, then a table for the transfer and two for each tool.

    ``second`` says whether the stack of pieces has the columns of a second sine.
    """
    sheet = book.sheet(
        "Inverse", "Each law inverted: the share of time ξ at which it has reached a share s of its rise."
    )
    sheet.heading("Results", "The tables below give ξ for s; this says how well s(ξ) meets the s wanted.")
    names = ["inverse_transfer", *(f"{s.scope}inverse_{way}" for s in machine.stations for way in ("in", "out"))]
    largest = ",".join(f"MAX([{name}.residual]),0-MIN([{name}.residual])" for name in names)
    sheet.rows(
        result(
            "inverse_residual",
            "Largest residual",
            "|s(ξ) − s|",
            "",
            f"=MAX({largest})",
            0.0,
            format="0.0E+00",
        )
    )
    sheet.checks(
        check(
            "inverse_ok",
            "Inverse: every height is met",
            "inverse_residual<check_zero",
            True,
            "S2 reads 38 % at 44 % from a table; here to 1e-9",
            says=amount("inverse_residual", 0.0, "missed by ", ""),
        )
    )
    sheet.rows(
        constant("inverse_near", "Heights this near count as reached", "ε", "",
                 NEAR, format="0E+00", source="rounding never decides a halving; Newton's steps take it out again"),
        constant("inverse_slow", "Slower than this: halving alone", "v_0", "",
                 SLOW, format="0E+00", source="halving 30 times finds ξ to 1e-9 of the piece"),
        constant("inverse_beyond", "More than any s", "", "", BEYOND, source="fills the rows that a law does not need"),
    )  # fmt: skip
    laws_in_use(sheet, machine, rows)
    columns = (*COEFFICIENTS, *(SECOND if second else ()))
    inversion(sheet, "inverse_transfer", "Transfer: where it is in the way", in_the_way(machine), rows, columns)
    for station in machine.stations:
        into, out = heights(station)
        whose = "Tool" if machine.alone else f"Tool {station.number}"
        with sheet.scoped(station.scope):
            inversion(sheet, "@inverse_in", f"{whose}, way in", into, rows, columns)
            inversion(sheet, "@inverse_out", f"{whose}, way out, counted in reverse", out, rows, columns)


def in_the_way(machine: Overlapping) -> Wanted:
    """Return what is asked of the transfer's law: where it has left its place for a tool, and where it comes to it."""
    shares: list[float] = []
    formulas, ends = [], []
    for station in machine.stations:
        whose = "" if machine.alone else f"tool {station.number}: "
        shares += station.passage.shares
        formulas += [f"={station.scope}remaining/100", f"=1-{station.scope}remaining/100"]
        ends += [f"{whose}has left its place", f"{whose}comes to its place"]
    head = constant("what", "where", "", "", ends)
    return Wanted(1, machine.given.transfer.law, machine.transfer.law, np.array(shares), formulas, (head,))


def heights(station: Station) -> tuple[Wanted, Wanted]:
    """Return what is asked of a tool's two laws: how far it may have gone."""
    tool, given, p, n = station.tool, station.given, station.passage, station.machine.sizes.margins
    margins = np.array([p.margin, *station.margins.margin])
    gone = p.gone(tool.stroke, margins)
    k = constant("k", "row", "k", "", list(range(n + 2)), source="0: as entered; then the table of margins")
    margin = calc(
        "margin", "margin", "", "mm",
        "=IF([k]=0,@margin,INDEX([@margins.margin],MAX([k],1)))", shown(margins, MM),
    )  # fmt: skip
    formula = "MAX(0,MIN((@clearance-[margin])/@stroke,1))"
    row_in, row_out = station.law_rows
    return (
        Wanted(row_in, given.law_in, tool.law, gone, f"={formula}", (k, margin)),
        Wanted(row_out, given.law_out, tool.out, 1 - gone, f"=1-{formula}", (k, margin)),
    )


def laws_in_use(sheet: Sheet, machine: Overlapping, rows: list[Row]) -> None:
    """Declare the laws: number, where their pieces stand, and the position at the begin of each piece."""
    motions, cells, codes = ["transfer"], ["=overlap_law"], [machine.given.transfer.law]
    for station in machine.stations:
        whose = "tool" if machine.alone else f"tool {station.number}"
        motions += [f"{whose}, way in", f"{whose}, way out"]
        cells += [f"={station.scope}law_in", f"={station.scope}law_out"]
        codes += [station.given.law_in, station.given.law_out]
    names = [*machine.library]
    numbers = [names.index(code) + 1 for code in codes]
    pieces = [[r.s for r in rows if r.number == n] for n in numbers]
    skipped = [next(i for i, r in enumerate(rows) if r.number == n) for n in numbers]
    most = max(sum(r.law == code for r in rows) for code in names)
    sheet.heading("Workings: the laws in use")
    sheet.table(
        "used", "The laws of transfer and tools", len(codes),
        constant("what", "motion", "", "", motions, align="left"),
        calc("code", "law", "", "", cells, codes),
        calc("no", "law number", "", "", "=MATCH([code],law_code,0)", numbers, format="0"),
        calc("skip", "rows before its pieces", "", "", "=MATCH([no],piece_number,0)-1", skipped, format="0"),
        calc("count", "pieces", "", "", "=COUNTIF(piece_number,[no])", [len(p) for p in pieces], format="0"),
        calc("low", "lowest velocity", "", "", "=INDEX(law_v_low,[no])",
             [slowest(machine.library[c]) for c in codes]),
        calc("ca", "acceleration coefficient", "C_a", "",
             "=MAX(INDEX(law_ca_max,[no]),-INDEX(law_ca_min,[no]))",
             [machine.library[c].coefficients.ca for c in codes], source="max |a|"),
    )  # fmt: skip
    sheet.table(
        "carried", "Position s_k at which each piece of these laws begins", most,
        constant("k", "piece", "k", "", list(range(1, most + 1))),
        *(calc(f"s{i}", what, "s_k", "", CARRIED.format(i), filled(p, most, BEYOND))
          for i, (what, p) in enumerate(zip(motions, pieces, strict=True), 1)),
    )  # fmt: skip


def inversion(
    sheet: Sheet, name: str, title: str, wanted: Wanted, rows: list[Row], columns: Sequence[Column]
) -> None:  # fmt: skip
    """Declare one table: for each s its ξ and the residual, then piece, halvings, Newton's steps."""
    at = solved(wanted, rows, columns)
    last = f"u{NEWTON}"
    sheet.table(
        name, title, len(wanted.s),
        *wanted.head,
        calc("s", "height wanted", "s", "", wanted.formula, wanted.s),
        result("xi", "share of time", "ξ", "",
               f"=IF([s]<=0,0,IF([s]>=1,1,[xk]+[{last}]))", inverse(wanted.law, wanted.s), source="s(ξ) = s",
               format="0.00000000"),
        calc("residual", "residual", "s(ξ) − s", "", f"=[f{last}]-[s]", np.zeros(len(wanted.s)), format="0.0E+00"),
        calc("p", "piece", "", "",
             f"=MATCH([s]+break_tolerance,[carried.s{wanted.use}],1)", at["p"], format="0",
             source="last s_k not above s"),
        calc("q", "piece row", "q", "", f"=[used.skip.{wanted.use}]+[p]", at["q"], format="0"),
        *(calc(n, label, symbol, "",
               f"=INDEX(piece_{column},[q])", at[n]) for n, label, symbol, column in columns),
        *halvings(at),
        *newton(at),
    )  # fmt: skip
    sheet.row += 1


def halvings(at: dict[str, Array]) -> list[Quantity]:
    """Return the columns of the halvings: the middle t, and the position f there."""
    made = []
    for k in range(1, HALVINGS + 1):
        before = f"[t{k - 2}]" if k > 2 else "0"
        formula = "=[d]/2" if k == 1 else HALVE.format(k=k - 1, before=before)
        made += [
            calc(f"t{k}", f"halving {k}", "t", "", formula, at[f"t{k}"], source="± half the last step"),
            calc(f"f{k}", "position there", "s(t)", "", height(f"t{k}", at), at[f"f{k}"]),
        ]
    return made


def newton(at: dict[str, Array]) -> list[Quantity]:
    """Return the columns of Newton's steps, from the last middle: velocity, local abscissa, position."""
    made, t, s = [], f"t{HALVINGS}", f"f{HALVINGS}"
    for k in range(1, NEWTON + 1):
        made += [
            calc(f"v{k}", f"velocity, step {k}", "v", "", slope(t, at), at[f"v{k}"]),
            calc(f"u{k}", f"Newton's step {k}", "u", "",
                 STEP.format(t=t, v=f"v{k}", s=s), at[f"u{k}"], source="t − (s(t) − s)/v"),
            calc(f"fu{k}", "position there", "s(u)", "", height(f"u{k}", at), at[f"fu{k}"]),
        ]  # fmt: skip
        t, s = f"u{k}", f"fu{k}"
    return made


def height(t: str, at: dict[str, Array]) -> str:
    """Return the formula of the position at a local abscissa."""
    return (HEIGHT + (SWING if "ps2" in at else "")).format(t=t)


def slope(t: str, at: dict[str, Array]) -> str:
    """Return the formula of the velocity at a local abscissa."""
    return (SLOPE + (TURN if "ps2" in at else "")).format(t=t)


def solved(wanted: Wanted, rows: list[Row], columns: Sequence[Column]) -> dict[str, Array]:
    """Return the engine's side: the middles of the halvings follow from the engine's own inverse of s + ε."""
    law, own = wanted.law, [(i, r) for i, r in enumerate(rows, 1) if r.law == wanted.code]
    p = np.searchsorted([r.s for _, r in own], wanted.s + BREAK_TOLERANCE, side="right")
    found = [own[i - 1][1] for i in p]
    at: dict[str, Array] = {"p": p.astype(float), "q": np.array([float(own[i - 1][0]) for i in p])}
    for name, _, _, column in columns:
        at[name] = np.array([float(getattr(r, column)) for r in found])
    sought = np.where(wanted.s > 0, np.minimum(wanted.s + NEAR, 1.0), 0.0)  # at a law's end no height is sought
    root = inverse(law, sought) - at["xk"]
    for k, t in enumerate(middles(at["d"], root, HALVINGS), 1):
        at[f"t{k}"] = t
        at[f"f{k}"] = law.s(local(at, f"t{k}"))
    t = f"t{HALVINGS}"
    for k in range(1, NEWTON + 1):
        here = law.evaluate(local(at, t))
        at[f"v{k}"], at[f"u{k}"] = here.v, newton_step(at[t], here.s, here.v, wanted.s, at["d"], SLOW)
        t = f"u{k}"
        at[f"fu{k}"] = law.s(local(at, t))
    return at


def local(at: dict[str, Array], name: str) -> Array:
    """Return ξ of a local abscissa."""
    return np.minimum(at["xk"] + at[name], 1.0)
