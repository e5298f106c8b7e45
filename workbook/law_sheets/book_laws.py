"""The laws of a book as every sheet looks them up: the Laws sheet has each by number, and the pieces of all stacked."""

from collections.abc import Mapping, Sequence
from itertools import groupby
from types import MappingProxyType
from typing import NamedTuple

from engine.laws import Piece
from engine.laws.base import BREAK_TOLERANCE
from engine.laws.piece import placed_pieces
from engine.laws.points import reach, slowest
from engine.motion.handover import end_mode
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Book, Quantity, Sheet, calc, result
from workbook.book.rows import LEAST
from workbook.entries.machine import Sizes
from workbook.law_sheets.library import NamedLaw, named_laws
from workbook.law_sheets.page import finite, law_sheet
from workbook.laws.entries import Laws
from workbook.laws.family import COEFFICIENTS, LABELS, LEAST_STAGE, POWERS, SECOND, SINE, entries_of
from workbook.laws.sampling import Pieces

CELLS = cell_tables(__file__)

Uses = Mapping[str, Sequence[str]]  # the laws of an axis' phases, by its name
RISE = 1.0  # of every law in a time of 1: its velocity and acceleration reach at least this size


class BookLaws:
    """The motion laws of a book: the engine's laws by name, and the stack of pieces in which sheets look them up."""

    def __init__(self, given: Laws, sizes: Sizes, hands_over: bool = False) -> None:
        self.given, self.sizes, self.hands_over = given, sizes, hands_over
        self.named = named_laws(given)
        self.laws = {named.name: named.law for named in self.named}
        self.rows = stack_rows(self.named, sizes)
        groups = groupby(self.rows, key=lambda row: row.number)
        self.stack = Pieces(
            {number: [row.piece for row in group] for number, group in groups},
            {id(named.law): named.number for named in self.named},
            second_sine=any("P2" in named.page.columns for named in self.named),
        )

    def sheets(self, book: Book, uses: Uses = MappingProxyType({})) -> None:
        """Declare a page for each law, and the Laws sheet, with which axes of a machine use it."""
        for named in self.named:
            if named.page.has_sheet:
                law_sheet(book, named, self.sizes, self.stack)
        laws_sheet(book, self, uses)


class Row(NamedTuple):
    """One row of the stack: its law, the number of the piece, formulas of its entries, and the value of each column."""

    law: str
    number: int
    k: int
    piece: Piece
    formulas: dict[str, str]
    values: dict[str, float]


def stack_rows(laws: Sequence[NamedLaw], sizes: Sizes) -> list[Row]:
    """Return the rows of the stack: by their keys the pieces of all laws stand in rising order."""
    rows = []
    for law in laws:
        pieces = law.page.stacked(law.law, sizes)
        places = placed_pieces([piece for piece, _ in pieces], law.law.entry_velocity)
        for k, ((piece, entered), place) in enumerate(zip(pieces, places, strict=True), 1):
            values = entries_of(place.piece) | dict(zip(("xi", "s", "v", "ds", "dv"), place[1:], strict=True))
            values |= dict(zip(("ps", "pv", "pj"), place.amplitudes[0], strict=True))
            values |= dict(zip(("ps2", "pv2", "pj2"), place.amplitudes[1], strict=True))
            values |= dict(zip(("s0", "s1"), place.constants, strict=True)) | {"key": 2.0 * law.number + place.begin}
            formulas = {name: law.own(text) for name, text in entered.items()}
            rows.append(Row(law.name, law.number, k, piece, formulas, values))
    return rows


def laws_sheet(book: Book, of: BookLaws, uses: Uses) -> None:
    """Declare the sheet from which every axis evaluates its law."""
    cell = CELLS["laws_sheet"]
    sheet = book.sheet("Laws", "Every law as a table of pieces: a sample finds its piece by key = 2 · number + ξ_k.")
    sheet.unprinted = True
    sheet.heading("Results: the laws and their coefficients")
    summary(sheet, of, uses)
    if uses:
        sheet.heading("Workings: how many phases of each axis have a law")
        uses_table(sheet, of.named, uses)
    sheet.heading(
        "Workings: the stacked pieces", "a(u) = c0 + c1 u + … + c5 u⁵ + P sin(ωu + φ) on each piece, u = ξ − ξ_k."
    )
    sheet.rows(
        cell("break_eps", BREAK_TOLERANCE),
        cell("tiny", LEAST),
        cell("stage_least", LEAST_STAGE),
    )
    stack(sheet, of.rows, of.stack)


RATES = "start v_low wrong low high s0 s1 v0 v1 a0 a1".split()
LAW_NAMES = ("name", "no", "code", *(name for name, *_ in COEFFICIENTS), *RATES)
"""columns of the table of laws that have names"""


def count_phases(law: NamedLaw, uses: Uses) -> list[int]:
    """Return how many phases of each axis have a law."""
    return [sum(name.casefold() == law.name.casefold() for name in names) for names in uses.values()]


def uses_table(sheet: Sheet, laws: Sequence[NamedLaw], uses: Uses) -> None:
    """Declare how many phases of each axis have each law, and the first axis that has it."""
    counts, numbers = [count_phases(law, uses) for law in laws], range(1, len(uses) + 1)
    cell = CELLS["uses"].sharing(axes=f"[axis1:axis{len(uses)}]")
    cell.place(
        sheet,
        cell("no", [law.number for law in laws]),
        *(cell("axis{i}", [row[i - 1] for row in counts], i=i) for i in numbers),
        cell("all", [sum(row) for row in counts]),
        cell(
            "first",
            [next((i for i in numbers if row[i - 1]), 0) for row in counts],
            numbers=",".join(map(str, numbers)),
        ),
    )


def use_columns(laws: Sequence[NamedLaw], uses: Uses) -> list[Quantity]:
    """Return how many phases have each law, and the first axis that has it."""
    cell, counts = CELLS["laws"], [count_phases(law, uses) for law in laws]
    firsts = [next((name for name, count in zip(uses, row, strict=True) if count), "") for row in counts]
    axis = (
        "[axes.name.1]" if len(uses) == 1 else "INDEX([axes.name],INDEX([law_uses.first],[no]))"
    )  # IronCalc has no INDEX of a cell
    return [cell("phases", [sum(row) for row in counts]), cell("first", firsts, axis=axis)]


def summary(sheet: Sheet, of: BookLaws, uses: Uses) -> None:
    """Declare the table of laws: name, use, coefficients, values at both ends; more where phases hand over at speed."""
    laws, cell = of.named, CELLS["laws"]
    reaches = [reach(law.law) for law in laws]

    def coefficient(name: str, label: str, symbol: str) -> Quantity:
        formulas = [law.own(f"=@{name}" if law.page.has_sheet else law.page.coefficients[name][0]) for law in laws]
        values = [finite(getattr(law.law.coefficients, name)) for law in laws]
        return result(name, label, symbol, "", formulas, values, format="0.0000")

    def stated(name: str, field: str, values: Sequence[float]) -> Quantity:
        return cell(name, values, formula=[law.own(getattr(law.page, field)) for law in laws])

    def end(d: str, xi: int) -> Quantity:
        place = ("first", "last")[xi]
        formulas = [law.own(f"=[@samples.{d}.{place}]" if law.page.has_sheet else "=0") for law in laws]
        return cell(f"{d}{xi}", [getattr(law.law.end if xi else law.law.start, d) for law in laws], formula=formulas)

    modes, early = [end_mode(law.law) for law in laws], [law.page.early for law in laws]
    ends = [stated("way", "end_mode", modes), cell("early", early)] if of.hands_over else []
    names = [law.own(law.page.named or f'="{law.words}"') for law in laws]
    codes = [f'="{law.name}"' if law.basic else law.own("=@called") for law in laws]
    cell.place(
        sheet,
        cell("name", [law.words for law in laws], formula=names),
        cell("no", [law.number for law in laws]),
        cell("code", [law.name for law in laws], formula=codes),
        *(use_columns(laws, uses) if uses else []),
        *(coefficient(name, label.partition(",")[0].lower(), symbol) for name, label, symbol in COEFFICIENTS),
        stated("start", "start", [law.law.start.v for law in laws]),
        stated("v_low", "lowest", [slowest(law.law) for law in laws]),
        stated("wrong", "wrong_step", [law.page.step_back(law.law, of.sizes) for law in laws]),
        *(end(d, xi) for d in "sva" for xi in (0, 1)),
        stated("low", "low", [low for low, _ in reaches]),
        stated("high", "high", [high for _, high in reaches]),
        *ends,
    )
    sheet.book.name("laws", **{f"law_{name}": name for name in (*LAW_NAMES, *(q.name for q in ends))})


SECOND_TERMS = {
    "s0": "+[ps2]*SIN([phi2])",
    "s1": "+[pv2]*COS([phi2])",
    "dv": "-[pv2]*(COS([omega2]*[d]+[phi2])-COS([phi2]))",
    "ds": "-[ps2]*SIN([omega2]*[d]+[phi2])",
}
"""what a second sine adds to formulas of the stack"""
# columns of the stack that are there with a second sine alone
WITH_SECOND = (*SECOND, "ps2", "pv2", "pj2")
PLACED = "xi ps pv pj pj2 ps2 pv2 v dv s ds key".split()
COLUMNS = ("d", "s0", "s1", *POWERS, *SINE, *SECOND, *PLACED)
FIRST_POWERS = {"piece_y": "s0", "piece_dy": "s1", "piece_ddy": "c0", "piece_dddy": "c1"}
"""the first column of each block of coefficients, up to the highest power that any law has"""


def stack(sheet: Sheet, rows: list[Row], stacked: Pieces) -> None:
    """Declare the stacked pieces, entries taken from the laws' pages, with a second sine where any law has it."""
    cell, second, last = CELLS["pieces"], stacked.second_sine, POWERS[stacked.room - 1]

    def column(name: str) -> Quantity:
        values = [row.values[name] for row in rows]
        if name in LABELS:
            return calc(name, *LABELS[name], "", [row.formulas[name] for row in rows], values)
        terms = {"second": SECOND_TERMS[name] if second else ""} if name in SECOND_TERMS else {}
        return cell(name, values, **terms, **({"scale": RISE} if name == "ds" else {}))

    always = [name for name in COLUMNS if name not in WITH_SECOND]
    keys = cell.of_rows(rows, law="law", number="number", k="k")
    columns = map(column, COLUMNS if second else always)
    sheet.table("pieces", "Pieces of all laws", len(rows), *keys, *columns)
    sheet.book.name(
        "pieces",
        **{f"piece_{name}": name for name in ("law", "number", "k", *always)},
        **{name: f"{first}:{last}" for name, first in FIRST_POWERS.items()},
        **{f"piece_{name}": name for name in WITH_SECOND if second},
    )
