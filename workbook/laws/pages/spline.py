"""Points joined by a cubic spline: entered point by point, solved in the rows of one table."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Literal

from pydantic import Field

from engine.laws import Law, Piece
from engine.laws.knots import Knots
from engine.laws.spline import EXAMPLE, MOST, NARROWEST, Spline
from workbook.book.declare import Quantity, Sheet, check, given
from workbook.book.rows import filled
from workbook.book.sentence import Said, figure
from workbook.entries.types import DesignError, Model, Number, Share
from workbook.laws.family import ENTRIES, LawCheck, LawSheet, Page
from workbook.laws.knots import intervals_table, points_table, solution, worked_out

ENDS = ("begin", "end")


class Point(Model):
    """A point that the law passes through."""

    at: Share = Field(description="The share of the time, ξ, of the point")
    s: Number = Field(description="The share of the rise that is reached there")


ORIGINAL = [Point(at=at, s=s) for at, s in EXAMPLE]


class Points(LawSheet):
    """Points that a cubic spline passes through, and what it does at its ends."""

    points: list[Point] = Field(default=ORIGINAL, description="The points, from (0, 0) to (1, 1), in order")
    first_slope: Number | None = Field(
        default=None, description="The velocity that it begins with, per unit rise and time; without it 0"
    )
    last_slope: Number | None = Field(
        default=None, description="The velocity that it ends with, per unit rise and time; without it 0"
    )
    natural: Literal["none", "begin", "end", "both"] = Field(
        default="none", description="The ends that are natural, without acceleration, where no slope is entered"
    )

    def design_faults(self) -> Iterator[DesignError]:
        """Yield points that do not lead from (0, 0) to (1, 1), or do not follow each other."""
        fits = [point.model_dump() for point in ORIGINAL]
        if len(self.points) < 2:
            yield DesignError("points", FEW.format(len(self.points)), "enough", fits)
            return
        first, last = self.points[0], self.points[-1]
        if (first.at, first.s, last.at, last.s) != (0.0, 0.0, 1.0, 1.0):
            ends = (figure(value) for value in (first.at, first.s, last.at, last.s))
            yield DesignError("points", LEAD.format(*ends), "lead", fits)
        for k, (one, other) in enumerate(pairwise(self.points), 2):
            if not other.at - one.at >= NARROWEST:
                yield DesignError("points", RISE.format(k, figure(other.at), figure(one.at)), "rise", fits)
                return


FEW = "{} points are given; expected 2 or more"
LEAD = "they lead from ({}, {}) to ({}, {}); expected from (0, 0) to (1, 1)"
RISE = "point {} is at {}, the one before at {}"

ROOM = MOST  # points that a table may have
WAVE = ((0.0, 0.0), (0.1, 0.4), (0.3, -0.2), (0.32, -0.2), (0.8, 1.3), (0.97, 0.9), (1.0, 1.0))


def entered(*points: tuple[float, float]) -> list[dict[str, float]]:
    """Return points as a description has them."""
    return [{"at": at, "s": s} for at, s in points]


VARIATIONS = (
    {"points": entered(*WAVE), "first_slope": None, "last_slope": None, "natural": "none"},
    {"points": entered((0, 0), (0.4, 0.1), (0.55, 0.8), (1, 1)), "first_slope": 0.25, "last_slope": None,
     "natural": "both"},
    {"points": entered((0, 0), (1, 1)), "first_slope": None, "last_slope": 0.5, "natural": "begin"},
    {"points": entered((0, 0), (0.2, 0.05), (0.6, 0.7), (0.61, 0.72), (1, 1)), "first_slope": 0.0,
     "last_slope": -0.3, "natural": "both"},
)  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class SplinePage(Page):
    """The page of a spline: any number of points, entered one by one."""

    def made(self, entered: Points) -> Spline:
        """Return the engine's law: its ends are settled here, whatever is beside it."""
        given = (entered.first_slope, entered.last_slope)
        natural = [slope is None and entered.natural in (end, "both") for end, slope in zip(ENDS, given, strict=True)]
        slopes = [None if free else slope or 0.0 for free, slope in zip(natural, given, strict=True)]
        points = tuple((point.at, point.s) for point in entered.points)
        return Spline(points, (slopes[0], slopes[1]), (natural[0], natural[1]))

    def stacked(self, law: Law, sizes: Any) -> list[tuple[Piece, dict[str, str]]]:
        """Return the rows of the stack: an interval each, spare ones and all."""
        pieces = law.as_pieces()
        rows = range(1, sizes.points)
        shown = {"d": "=[@intervals.d.{}]", "c0": "=[@intervals.a.{}]", "c1": "=[@intervals.j.{}]"}
        return [
            (
                pieces[k - 1] if k <= len(pieces) else Piece(0.0, (law.end.a, 0.0, 0.0, 0.0)),
                {name: shown.get(name, "=0").format(k) for name in ENTRIES},
            )
            for k in rows
        ]

    def enter(self, sheet: Sheet, one: Any, sizes: Any) -> None:
        """Declare slopes and ends, and the table of points."""
        points, slope = one.entered, "empty: 0, or natural"
        sheet.rows(
            given("@first_slope", "Velocity at its begin", "v(0)", "", points.first_slope, f"{one.key}.first_slope",
                  format="0.0####", source=slope),
            given("@last_slope", "Velocity at its end", "v(1)", "", points.last_slope, f"{one.key}.last_slope",
                  format="0.0####", source=slope),
            given("@natural", "Natural, without acceleration", "", "", points.natural, f"{one.key}.natural",
                  align="center", source="none, begin, end or both: of ends without a slope"),
        )  # fmt: skip
        at = Knots(one.law, sizes.points)
        rows = (
            given("xi", "place", "ξ", "", filled([p.at for p in points.points], sizes.points, None),
                  f"{one.key}.points.*.at", format="0.0####", source="share of the time"),
            given("s", "position", "s", "", filled([p.s for p in points.points], sizes.points, None),
                  f"{one.key}.points.*.s", format="0.0####", source="share of the rise"),
        )  # fmt: skip
        points_table(sheet, at, rows)

    def work(self, sheet: Sheet, one: Any, stack: Any, sizes: Any) -> None:
        """Declare what the table of points is worked out from."""
        sheet.heading("Workings")
        sheet.rows(*solution(Knots(one.law, sizes.points)))

    def detail(self, sheet: Sheet, one: Any, stack: Any, sizes: Any) -> None:
        """Declare the table of the intervals."""
        intervals_table(sheet, Knots(one.law, sizes.points))

    def stepping(self, law: Law, sizes: Any) -> float:
        """Return the greatest step of v the wrong way, interval by interval."""
        return float(Knots(law, sizes.points).wrong.max()) if isinstance(law, Spline) else 0.0

    def verdicts(self, one: Any, sizes: Any) -> list[Quantity]:
        """Return the checks of the points, and that of the law's end."""
        says = Said('"s(1) = "&ROUND([@samples.s.last],9)', "s(1) = 1")
        end = check("@ends", f"{one.called} ends at s = 1", "ABS([@samples.s.last]-1)<check_zero", True, says=says)
        return [*super().verdicts(one, sizes)[:-1], end]


def spelled(text: str, *cells: str) -> str:
    """Return a sentence as a formula, with the figures of cells in it."""
    first, *others = text.split("{}")
    parts = [f'"{first}"'] if first else []
    for cell, words in zip(cells, others, strict=True):
        parts += [cell, *([f'"{words}"'] if words else [])]
    return "&".join(parts)


NARROW = "MATCH(1,[@solved.narrow],0)"
OUTER = ("[@points.xi.1]", "[@points.s.1]", "INDEX([@points.xi],@used)", "INDEX([@points.s],@used)")
LEADS = "AND(" + ",".join(f"{cell}={value}" for cell, value in zip(OUTER, "0011", strict=True)) + ")"
PLACES = (f"{NARROW}+1", f"INDEX([@points.xi],{NARROW}+1)", f"INDEX([@points.xi],{NARROW})")

PAGE = SplinePage(
    titled="Cubic spline through points",
    source="the cubic spline in moments; TwinCAT, MC_MotionFunctionType, CubicSpline",
    entries=Points,
    law=Spline,
    pieces=(),
    coefficients=worked_out(),
    fastest="=@v_at",
    lowest="=MIN([@intervals.v_low])",
    low="=MIN([@intervals.s_low])",
    high="=MAX([@intervals.s_high])",
    of_pieces=("c0", "c1"),
    start="=[@intervals.v.1]",
    wrong="=MAX([@intervals.wrong])",
    way="=2",
    rests=False,
    single=False,
    checks=(
        LawCheck("@enough", "there are points", "@used>1", "enough", spelled(FEW, "@used")),
        LawCheck("@lead", "the points lead from 0 to 1", LEADS, "lead", spelled(LEAD, *OUTER)),
        LawCheck("@rise", "the points follow each other", "SUM([@solved.narrow])=0", "rise", spelled(RISE, *PLACES)),
    ),
    variations=VARIATIONS,
    functions=False,
)
