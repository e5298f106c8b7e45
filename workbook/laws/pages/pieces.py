"""The engineer's own law, piece by piece."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import AfterValidator, Field, model_validator

from engine import laws as engine
from engine.laws import Law, PieceLaw
from engine.laws.piece import begins
from engine.laws.points import PointedLaw, Points, piece_ends
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import ZERO
from workbook.book.declare import Quantity, RowRule, Sheet, given
from workbook.book.rows import filled
from workbook.book.sentence import amount, figure
from workbook.fields.texts import Text
from workbook.fields.types import SMALLEST, SUM_TOLERANCE, DesignError, EntryError, Model, NotNegative, Number, Positive
from workbook.laws import sampling
from workbook.laws.family import BEHIND, ENTRIES, LABELS, LawSheet, Page, coefficients_in
from workbook.laws.own import OWN_ENTRIES, extremes, missing, points_table

CELLS = cell_tables(__file__)


def not_slow(omega: float) -> float:
    """Return a frequency; raise EntryError for a value so small that nobody means it."""
    if 0 < omega < SMALLEST:
        raise EntryError("", f"{omega:g}; expected 0, or at least {SMALLEST:g}")
    return omega


class Piece(Model):
    """One piece of the engineer's own law: a(u) = c0 + c1 u + c2 u² + c3 u³ + P sin(ωu + φ)."""

    duration: NotNegative
    c0: Number = 0.0
    c1: Number = 0.0
    c2: Number = 0.0
    c3: Number = 0.0
    amplitude: Number = 0.0
    omega: Annotated[NotNegative, AfterValidator(not_slow)] = 0.0
    phase: Number = 0.0

    def design_faults(self) -> Iterator[DesignError]:
        """Yield a sine without a frequency."""
        if self.amplitude and not self.omega:
            yield DesignError("omega", TURNING.words, 1.0)

    @property
    def engine_piece(self) -> engine.Piece:
        """The engine's piece."""
        polynomial = (self.c0, self.c1, self.c2, self.c3)
        return engine.Piece(self.duration, polynomial, self.amplitude, self.omega, self.phase)


TURNING = RowRule("turning", "OR([P]+0=0,[omega]+0<>0)", "omega", "ω of a sine, expected more than 0")


SHAPED = "What `motionbook improve --freeze` shapes its pieces for: least RMS torque of its drive, or its highest rate"
SHAPER = "The input shaper by which `motionbook improve --freeze` gives out another law, for the vibration of its axis"
SHAPER_OF = "The law that its input shaper gives out"
MOST_JERK = "Its coefficient of jerk, c_j, is at most that, of a law that is shaped"
SLOPE = "The velocity that it {} with beside a phase that moves, per unit rise and time; without it, it rests there"


class OwnLaw(LawSheet):
    """The engineer's own law, piece by piece; the default is the polynomial 3-4-5."""

    name: Text = "Polynomial 3-4-5"
    pieces: list[Piece] = Field(default=[Piece(duration=1.0, c1=60.0, c2=-180.0, c3=120.0)])
    shaped: Literal["torque", "rate"] | None = Field(default=None, description=SHAPED, examples=["rate"])
    max_jerk: Positive | None = Field(default=None, description=MOST_JERK, examples=[200.0])
    shaper: Literal["ZV", "ZVD", "EI"] | None = Field(default=None, description=SHAPER, examples=["ZVD"])
    of: Text | None = Field(default=None, description=SHAPER_OF, examples=["MTP"])
    first_slope: Number | None = Field(default=None, description=SLOPE.format("begins"), examples=[0.5])
    last_slope: Number | None = Field(default=None, description=SLOPE.format("ends"), examples=[0.5])

    @model_validator(mode="after")
    def _belong_together(self) -> Self:
        if self.max_jerk and not self.shaped:
            raise EntryError("max_jerk", 'bounds laws that are shaped; expected shaped = "torque", or "rate", with it')
        if (self.shaper is None) != (self.of is None):
            raise EntryError("of", 'of an input shaper; expected shaper = "ZVD", for one, and of = "MTP", both or none')
        if self.shaper and self.shaped:
            raise EntryError("shaper", "the law is shaped for its drive; expected a shaper or shaped, not both")
        return self

    def design_faults(self) -> Iterator[DesignError]:
        """Yield pieces that do not fill the rise."""
        total = math.fsum(piece.duration for piece in self.pieces)
        if abs(total - 1) > SUM_TOLERANCE:
            yield DesignError("pieces", f"they sum to {figure(total)}; expected 1", [POLYNOMIAL_345])


POLYNOMIAL_345 = {"duration": 1.0, "c1": 60.0, "c2": -180.0, "c3": 120.0}
MIXED = [
    {"duration": 0.4, "c0": 3.0, "c1": 1.5, "c2": -2.0, "c3": 0.7} | {"amplitude": 1.2, "omega": 7.0, "phase": 0.4},
    {"duration": 0.35, "c0": -1.0, "amplitude": 2.0, "omega": 3.0, "phase": 1.1},
    {"duration": 0.25, "c0": -2.0, "c2": 4.0},
]
TWO_SINES = [
    {"duration": 0.5, "amplitude": 6.5, "omega": 6.0},
    {"duration": 0.5, "amplitude": -6.0, "omega": 6.5, "phase": 0.1},
]
VARIATIONS = ({"pieces": [POLYNOMIAL_345]}, {"pieces": MIXED}, {"pieces": TWO_SINES})


WITHIN = "Against the exact law, peaks of s, v, a and j are right to 1 %, of v·a to 4 %, the RMS to 0.0001 %."
# rad, of a sine on its piece: with more, nine points do not tell its extremes to the bound
MOST_TURN = math.tau


@dataclass(frozen=True, kw_only=True)
class OwnPage(Page):
    """The page of an own law: any number of pieces, entered in rows."""

    def of(self, entered: OwnLaw) -> Page:
        """Return the page of a law with these entries: one with a slope begins with it, and keeps the rates it has."""
        slopes = slopes_of(entered)
        start, formulas = "=@first_slope" if "first_slope" in slopes else "=0", dict(self.coefficients)
        if "last_slope" in slopes:
            formulas["cj"] = (formulas["cj"][0].replace(LEFT, "0"), formulas["cj"][1])
        own = replace(self, coefficients=formulas, start=start, end_mode="=2", rests=False, single=False)
        return own if slopes else self

    def make_law(self, entered: OwnLaw) -> PointedLaw:
        """Return the engine's law, with its coefficients by points."""
        return PointedLaw([piece.engine_piece for piece in entered.pieces], (entered.first_slope, entered.last_slope))

    def law_of(self, numbers: Sequence[float]) -> Law:
        """Return the law of pieces in a row, eight numbers each: duration, c0, c1, c2, c3, P, ω, φ."""
        rows = np.array(numbers).reshape(-1, len(OWN_ENTRIES)).tolist()
        return PieceLaw([engine.Piece(d, (a, b, c, e), *sine) for d, a, b, c, e, *sine in rows])

    def numbers(self, entered: OwnLaw) -> list[float]:
        """Return the pieces in a row, eight numbers each."""
        return [float(value) for piece in entered.pieces for value in piece.model_dump().values()]

    def variation(self, k: int, room: int) -> dict[str, Any]:
        """Return the ``k``-th of other pieces, round and round; where they do not find room, a single piece."""
        variation = super().variation(k, room)
        return variation if len(variation["pieces"]) <= room else dict(VARIATIONS[0])

    def stacked(self, law: Law, sizes: Any) -> list[tuple[engine.Piece, dict[str, str]]]:
        """Return the rows of the stack: the table of the own law, spare rows and all."""
        pieces = filled(law.as_pieces(), sizes.pieces, engine.Piece(0.0))
        return [
            (piece, {name: f"=[@pieces.{name}.{k}]" if name in OWN_ENTRIES else "=0" for name in ENTRIES})
            for k, piece in enumerate(pieces, 1)
        ]

    def enter(self, sheet: Sheet, named: Any, sizes: Any) -> None:
        """Declare the name and the table of pieces."""
        cell = CELLS["enter"]
        sheet.rows(cell("@name", named.entered.name, named=named))
        sheet.rows(*(cell(f"@{name}", slope) for name, slope in slopes_of(named.entered).items()))
        pieces_entered(sheet, named.entered, named.key, sizes.pieces)

    def work(self, sheet: Sheet, named: Any, stack: sampling.Pieces, sizes: Any) -> None:
        """Declare what the coefficients are worked out from, and by how much the law misses."""
        cell = CELLS["work"]
        sheet.heading("Workings", WITHIN)
        sheet.rows(
            cell("@first", float(stack.first[named.number])),
            cell("@most_turn", MOST_TURN),
            *extremes(spread_of(named.law, sizes.pieces)),
        )
        if not named.law.fixes_ends:
            missing(sheet, named.law, sizes.pieces)

    def step_back(self, law: Law, sizes: Any) -> float:
        """Return the greatest step of v the wrong way from point to point."""
        return float(spread_of(law, sizes.pieces).wrong_way.max())

    def detail(self, sheet: Sheet, named: Any, stack: sampling.Pieces, sizes: Any) -> None:
        """Declare the points on the pieces."""
        sheet.heading("Table of points")
        points_table(sheet, spread_of(named.law, sizes.pieces), stack.first[named.number], stack)

    def verdicts(self, named: Any, sizes: Any) -> list[Quantity]:
        """Return the checks of the own law."""
        cell = CELLS["verdicts"]
        turn = max(piece.omega * piece.duration for piece in named.law.as_pieces())
        end, asked = named.law.end, named.entered.last_slope
        ends = (
            {"ends": "at rest", "last": ""} if asked is None else {"ends": "with its velocity", "last": "-@last_slope"}
        )
        reached = amount("[@samples.s.last]", end.s, "s(1) = ", "")
        left = amount("[@samples.v.last]", end.v, "v(1) = ", "")
        turns = amount("MAX([@worked.turn])", turn, "a sine turns by ", " rad over its piece")
        return [
            cell("@sum", True, named=named),
            cell("@reaches", abs(end.s - 1) < ZERO, named=named, says=reached),
            cell("@rests", abs(end.v - (asked or 0.0)) < ZERO, named=named, says=left, **ends),
            cell("@dense", turn <= MOST_TURN, named=named, says=turns),
        ]


def spread_of(law: Any, room: int) -> Points:
    """Return the points on the pieces of a law in a table of ``room`` rows."""
    return Points(filled(law.as_pieces(), room, engine.Piece(0.0)), law.slopes)


def slopes_of(own: OwnLaw) -> dict[str, float]:
    """Return the velocities that are entered of the ends by their names."""
    return own.model_dump(include={"first_slope", "last_slope"}, exclude_none=True)


LEFT = "ABS([@worked.reached.last])"  # by how much the acceleration jumps at an end at rest


PAGE = OwnPage(
    source="entered piece by piece",
    entries=OwnLaw,
    law=PointedLaw,
    pieces=(),
    coefficients=coefficients_in(CELLS["coefficients"]),
    fastest="=@v_at",
    lowest="=@v_least",
    low="=@s_least",
    high="=@s_most",
    named="=@name",
    of_pieces=OWN_ENTRIES,
    without_cells=("shaped", "max_jerk", "shaper", "of", "first_slope", "last_slope"),
    wrong_step="=@back",
    variations=VARIATIONS,
)


def pieces_entered(sheet: Sheet, own: OwnLaw, key: str, n: int) -> None:
    """Declare the table of pieces."""

    def entry(name: str, field: str) -> Quantity:
        values = filled([getattr(piece, field) for piece in own.pieces], n, None)
        digits = "0.0000" if name == "d" else "General"
        return given(name, *LABELS[name], "", values, f"{key}.pieces.*.{field}", format=digits)

    title = "Fill one row each, in order; the durations sum to 1; leave spare rows empty"
    numbers = CELLS["pieces"]("k", list(range(1, n + 1)))
    entered = sheet.table("@pieces", title, n, numbers, *map(entry, OWN_ENTRIES, Piece.model_fields), rules=[TURNING])
    sheet.workings(entered, "@worked", "Workings: the pieces", BEHIND, *worked(own, n))


def worked(own: OwnLaw, n: int) -> list[Quantity]:
    """Return the columns of the pieces' begins, and of the acceleration at both their ends."""
    cell = CELLS["worked"]
    pieces = filled([piece.engine_piece for piece in own.pieces], n, engine.Piece(0.0))
    follows_rest = own.first_slope is None
    at, before = piece_ends(pieces, follows_rest), "0" if follows_rest else "[a0]"
    return [
        cell("xi", begins(pieces)),
        cell("turn", [piece.omega * piece.duration for piece in pieces]),
        *cell.sharing(before=before).of_rows(at, a0="begin", a1="end", reached="reached", jump="jump"),
    ]
