"""Points joined by a cubic spline: moments by elimination, back substitution from the last point; exact extremes."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Literal

from pydantic import Field

from engine.laws import Law, Piece
from engine.laws.spline import EQUAL, EXAMPLE, MOST, NARROWEST, Spline, SplineTable
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity, Sheet
from workbook.book.rows import filled
from workbook.book.sentence import CheckSentence, figure, sentence_formula
from workbook.fields.types import DesignError, Model, Number, Share
from workbook.laws.family import BEHIND, ENTRIES, LawCheck, LawSheet, Page, coefficients_in

CELLS = cell_tables(__file__)

ENDS = ("begin", "end")
ASKED_OF_ENDS = ("first_slope", "last_slope", "natural")
SLOPE = "The velocity that it {} with, per unit rise and time; without it 0"


class Point(Model):
    """A point that the law passes through."""

    at: Share = Field(description="The share of the time, ξ, of the point")
    s: Number = Field(description="The share of the rise that is reached there")


ORIGINAL = [Point(at=at, s=s) for at, s in EXAMPLE]


class Points(LawSheet):
    """Points that a cubic spline passes through, and what it does at its ends."""

    points: list[Point] = Field(default=ORIGINAL, description="The points, from (0, 0) to (1, 1), in order")
    first_slope: Number | None = Field(default=None, description=SLOPE.format("begins"), examples=[0.5])
    last_slope: Number | None = Field(default=None, description=SLOPE.format("ends"), examples=[0.5])
    natural: Literal["none", "begin", "end", "both"] = Field(
        default="none", description="The ends that are natural, without acceleration, where no slope is entered"
    )

    def design_faults(self) -> Iterator[DesignError]:
        """Yield points that do not lead from (0, 0) to (1, 1), or do not follow each other."""
        fits = [point.model_dump() for point in ORIGINAL]
        if len(self.points) < 2:
            yield DesignError("points", FEW.format(len(self.points)), fits)
            return
        first, last = self.points[0], self.points[-1]
        if (first.at, first.s, last.at, last.s) != (0.0, 0.0, 1.0, 1.0):
            ends = (figure(value) for value in (first.at, first.s, last.at, last.s))
            yield DesignError("points", LEAD.format(*ends), fits)
        for k, (point, after) in enumerate(pairwise(self.points), 2):
            if not after.at - point.at >= NARROWEST:
                yield DesignError("points", RISE.format(k, figure(after.at), figure(point.at)), fits)
                return


FEW = "{} points are given; expected 2 or more"
LEAD = "they lead from ({}, {}) to ({}, {}); expected from (0, 0) to (1, 1)"
RISE = "point {} is at {}, the one before at {}"
ROOM = MOST  # points that a table may have


def varied(*points: tuple[float, float], **ends: Any) -> dict[str, Any]:
    """Return points, and the entries of their ends, as a description has them."""
    given = {"first_slope": None, "last_slope": None, "natural": "none"}
    return {"points": [{"at": at, "s": s} for at, s in points]} | given | ends


VARIATIONS = (
    varied((0.0, 0.0), (0.1, 0.4), (0.3, -0.2), (0.32, -0.2), (0.8, 1.3), (0.97, 0.9), (1.0, 1.0)),
    varied((0, 0), (0.4, 0.1), (0.55, 0.8), (1, 1), first_slope=0.25, natural="both"),
    varied((0, 0), (1, 1), last_slope=0.5, natural="begin"),
    varied((0, 0), (0.2, 0.05), (0.6, 0.7), (0.61, 0.72), (1, 1), first_slope=0.0, last_slope=-0.3, natural="both"),
)


@dataclass(frozen=True, kw_only=True)
class SplinePage(Page):
    """The page of a spline: any number of points, entered in rows."""

    def make_law(self, entered: Points) -> Spline:
        """Return the engine's law: its ends are settled here, whatever is beside it."""
        given = (entered.first_slope, entered.last_slope)
        natural = [slope is None and entered.natural in (end, "both") for end, slope in zip(ENDS, given, strict=True)]
        slopes = [None if free else slope or 0.0 for free, slope in zip(natural, given, strict=True)]
        points = tuple((point.at, point.s) for point in entered.points)
        return Spline(points, (slopes[0], slopes[1]), (natural[0], natural[1]))

    def stacked(self, law: Law, sizes: Any) -> list[tuple[Piece, dict[str, str]]]:
        """Return the rows of the stack: an interval each, spare ones and all."""
        pieces = filled(law.as_pieces(), sizes.points - 1, Piece(0.0, (law.end.a, 0.0, 0.0, 0.0)))
        own = {"d": "=[@intervals.d.{}]", "c0": "=[@intervals.a.{}]", "c1": "=[@intervals.j.{}]"}
        return [(piece, {name: own.get(name, "=0").format(k) for name in ENTRIES}) for k, piece in enumerate(pieces, 1)]

    def enter(self, sheet: Sheet, named: Any, sizes: Any) -> None:
        """Declare slopes and ends, and the table of points."""
        points, cell = named.entered, CELLS["enter"]
        sheet.rows(*(cell(f"@{name}", getattr(points, name), named=named) for name in ASKED_OF_ENDS))
        at = SplineTable(named.law, sizes.points)
        table = sheet.table(
            "@points",
            "Fill one row each, in order; from (0, 0) to (1, 1); leave spare rows empty",
            at.rows,
            CELLS["points"]("k", list(range(1, at.rows + 1))),
            CELLS["points"]("xi", filled([point.at for point in points.points], at.rows, None), named=named),
            CELLS["points"]("s", filled([point.s for point in points.points], at.rows, None), named=named),
        )
        sheet.workings(table, "@solved", "Workings: the spline's moments", BEHIND, *elimination(at))

    def work(self, sheet: Sheet, named: Any, stack: Any, sizes: Any) -> None:
        """Declare what the table of points is worked out from."""
        sheet.heading("Workings")
        sheet.rows(*solution(SplineTable(named.law, sizes.points)))

    def detail(self, sheet: Sheet, named: Any, stack: Any, sizes: Any) -> None:
        """Declare the table of the intervals."""
        intervals_table(sheet, SplineTable(named.law, sizes.points))

    def step_back(self, law: Law, sizes: Any) -> float:
        """Return the greatest step of v the wrong way, interval by interval."""
        return float(SplineTable(law, sizes.points).wrong_way.max()) if isinstance(law, Spline) else 0.0

    def verdicts(self, named: Any, sizes: Any) -> list[Quantity]:
        """Return the checks of the points, and that of the law's end."""
        says = CheckSentence('"s(1) = "&ROUND([@samples.s.last],9)', "s(1) = 1")
        end = CELLS["verdicts"]("@ends", True, named=named, says=says)
        return [*super().verdicts(named, sizes)[:-1], end]


def solution(at: SplineTable) -> list[Quantity]:
    """Return the rows that the table of points refers to."""
    cell, (first, last), free = CELLS["solution"], at.slopes, at.law.natural
    return [
        cell("@used", at.used),
        cell("@nearest", NARROWEST),
        cell("@v0", first),
        cell("@v1", last),
        cell("@free0", int(free[0])),
        cell("@free1", int(free[1])),
        cell("@v_end", at.law.end.v),
        cell("@still", at.still),
        cell("@v_most", float(at.intervals["v_high"].max())),
        cell("@v_at", at.peak),
    ]


def elimination(at: SplineTable) -> list[Quantity]:
    """Return the columns of the tridiagonal system, of its forward elimination, and of its back substitution."""
    table, values = CELLS["elimination"], at.solved | {"narrow": filled([], at.rows, 0)}
    return [table(name, values[name]) for name in table]


def intervals_table(sheet: Sheet, at: SplineTable) -> None:
    """Declare the table of the intervals: rates at both ends, and extremes."""
    table = CELLS["intervals"].sharing(equal=f"{EQUAL:.0E}")
    values = at.intervals | {"k": list(range(1, at.rows + 1)), "fast": at.fastest_xi, "wrong": at.wrong_way}
    sheet.heading("Table of the intervals, each from a point to the next")
    title = "On each a is linear, and W = a² − 2jv the same everywhere"
    sheet.table("@intervals", title, at.rows, *(table(name, values[name]) for name in table))


NARROW = "MATCH(1,[@solved.narrow],0)"
OUTER = ("[@points.xi.1]", "[@points.s.1]", "INDEX([@points.xi],@used)", "INDEX([@points.s],@used)")
ENDS_MEET = ",".join(f"{cell}={value}" for cell, value in zip(OUTER, "0011", strict=True))
LEADS = f"OR(@used<2,AND({ENDS_MEET}))"
PLACES = (f"{NARROW}+1", f"INDEX([@points.xi],{NARROW}+1)", f"INDEX([@points.xi],{NARROW})")

PAGE = SplinePage(
    titled="Cubic spline through points",
    source="the cubic spline in moments; TwinCAT, MC_MotionFunctionType, CubicSpline",
    entries=Points,
    law=Spline,
    pieces=(),
    coefficients=coefficients_in(CELLS["coefficients"]),
    fastest="=@v_at",
    lowest="=MIN([@intervals.v_low])",
    low="=MIN([@intervals.s_low])",
    high="=MAX([@intervals.s_high])",
    of_pieces=("c0", "c1"),
    start="=[@intervals.v.1]",
    wrong_step="=MAX([@intervals.wrong])",
    end_mode="=2",
    rests=False,
    single=False,
    checks=(
        LawCheck("@enough", "there are points", "@used>1", sentence_formula(FEW, "@used")),
        LawCheck("@lead", "the points lead from 0 to 1", LEADS, sentence_formula(LEAD, *OUTER)),
        LawCheck("@rise", "the points follow each other", "SUM([@solved.narrow])=0", sentence_formula(RISE, *PLACES)),
    ),
    variations=VARIATIONS,
    functions=False,
)
