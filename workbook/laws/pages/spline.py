"""Points joined by a cubic spline: moments by elimination, back substitution from the last point; exact extremes."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any, Literal

from pydantic import Field

from engine.laws import Law, Piece
from engine.laws.spline import EQUAL, EXAMPLE, MOST, NARROWEST, Spline, SplineTable
from workbook.book.declare import Quantity, Sheet, calc, check, constant, given, result
from workbook.book.rows import filled
from workbook.book.sentence import CheckSentence, figure, spelled
from workbook.fields.types import DesignError, Model, Number, Share
from workbook.laws.family import BEHIND, ENTRIES, REACHES, LawCheck, LawSheet, Page

ENDS = ("begin", "end")
SLOPE = "The velocity that it {} with, per unit rise and time; without it 0"


class Point(Model):
    """A point that the law passes through."""

    at: Share = Field(description="The share of the time, ξ, of the point")
    s: Number = Field(description="The share of the rise that is reached there")


ORIGINAL = [Point(at=at, s=s) for at, s in EXAMPLE]


class Points(LawSheet):
    """Points that a cubic spline passes through, and what it does at its ends."""

    points: list[Point] = Field(default=ORIGINAL, description="The points, from (0, 0) to (1, 1), in order")
    first_slope: Number | None = Field(default=None, description=SLOPE.format("begins"))
    last_slope: Number | None = Field(default=None, description=SLOPE.format("ends"))
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


def varied(*points: tuple[float, float], **ends: Any) -> dict[str, Any]:
    """Return points, and what is said of their ends, as a description has them."""
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
        pieces = filled(law.as_pieces(), sizes.points - 1, Piece(0.0, (law.end.a, 0.0, 0.0, 0.0)))
        own = {"d": "=[@intervals.d.{}]", "c0": "=[@intervals.a.{}]", "c1": "=[@intervals.j.{}]"}
        return [(piece, {name: own.get(name, "=0").format(k) for name in ENTRIES}) for k, piece in enumerate(pieces, 1)]

    def enter(self, sheet: Sheet, named: Any, sizes: Any) -> None:
        """Declare slopes and ends, and the table of points."""
        points = named.entered
        sheet.rows(
            *(given(f"@{slope}", f"Velocity at its {end}", f"v({xi})", "", getattr(points, slope),
                    f"{named.key}.{slope}", format="0.0####", source="empty: 0, or natural")
              for xi, (slope, end) in enumerate(zip(("first_slope", "last_slope"), ENDS, strict=True))),
            given("@natural", "Natural, without acceleration", "", "", points.natural, f"{named.key}.natural",
                  align="center", source="none, begin, end or both: of ends without a slope"),
        )  # fmt: skip
        at = SplineTable(named.law, sizes.points)
        table = sheet.table(
            "@points", "Fill one row each, in order; from (0, 0) to (1, 1); leave spare rows empty", at.rows,
            constant("k", "point", "k", "", list(range(1, at.rows + 1))),
            given("xi", "place", "ξ", "", filled([p.at for p in points.points], sizes.points, None),
                  f"{named.key}.points.*.at", format="0.0####", source="share of the time"),
            given("s", "position", "s", "", filled([p.s for p in points.points], sizes.points, None),
                  f"{named.key}.points.*.s", format="0.0####", source="share of the rise"),
        )  # fmt: skip
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
        end = check("@ends", f"{named.called} ends at s = 1", REACHES, True, says=says)
        return [*super().verdicts(named, sizes)[:-1], end]


ROOT = "SQRT([w])"
SPEEDS = "={0}([v],[v1],IF([a]*[a1]<0,[v]+[a]^2*[d]/(2*([a]-[a1])),[v]))"
POWER_AT = "=IF(([a]{0}[third])*([a1]{0}[third])<0,{1}[w]*[third]/(3*[j]),[v]*[a])"
POWERS = "={0}([v]*[a],[v1]*[a1],[va_plus],[va_minus])"
RISES = (
    "=IF(OR(AND([v]<0-@still,[v_high]>@still),AND([v1]>@still,[v_low]<0-@still)),"
    f"IF([a]<0,({ROOT}-[a])/[j],0-2*[v]/({ROOT}+[a])),0)"
)
FALLS = (
    "=IF(OR(AND([v]>@still,[v_low]<0-@still),AND([v1]<0-@still,[v_high]>@still)),"
    f"IF([a]>0,0-({ROOT}+[a])/[j],2*[v]/({ROOT}-[a])),0)"
)
REACH = "={0}([y],[y1],[y]+[{1}]*(4*[v]+[a]*[{1}])/6)"
FASTEST = (
    "=IF(OR([d]=0,[v_high]<@v_most-{0}*ABS(@v_most)),1,IF([v]>=@v_most-{0}*ABS(@v_most),[xi],"
    "IF(AND([a]>0,[a1]<0),[xi]+[d]*[a]/([a]-[a1]),[xi]+[d])))"
).format(f"{EQUAL:.0E}")
WRONG = (
    "=IF([d]=0,0,IF([xi]+[d]<=@v_at+check_zero,MAX(0,[v]-[v_low],[v_high]-[v1]),"
    "IF([xi]>=@v_at-check_zero,MAX(0,[v_high]-[v],[v1]-[v_low]),0)))"
)
UNIT = 1.0  # rise and time: what rounding of accelerations is measured by


def column(found: Mapping[str, Any], name: str, label: str, symbol: str, formula: str, source: str = "",
           scale: float = 0.0, role: Callable[..., Quantity] = calc) -> Quantity:  # fmt: skip
    """Return a column whose values are among those found."""
    return role(name, label, symbol, "", formula, found[name], source=source, scale=scale)


def solution(at: SplineTable) -> list[Quantity]:
    """Return the rows that the table of points refers to."""
    (first, last), free = at.slopes, at.law.natural
    moments = "(INDEX([@intervals.a],@used-1)+2*[@intervals.a.last])"
    end = f"=INDEX([@solved.m],@used-1)+INDEX([@solved.d],@used-1)*{moments}/6"
    natural = '=IF(AND(@{0}_slope="",OR(@natural="{1}",@natural="both")),1,0)'
    return [
        calc("@used", "Points", "", "", "=COUNT([@points.xi])", at.used, format="0"),
        constant("@nearest", "Least distance of two points", "", "", NARROWEST, format="0E+00"),
        calc("@v0", "Velocity entered at its begin", "v(0)", "", "=IF(ISNUMBER(@first_slope),@first_slope,0)", first),
        calc("@v1", "and at its end", "v(1)", "", "=IF(ISNUMBER(@last_slope),@last_slope,0)", last),
        calc("@free0", "Its begin is natural", "", "", natural.format("first", "begin"), int(free[0]), format="0"),
        calc("@free1", "Its end is natural", "", "", natural.format("last", "end"), int(free[1]), format="0"),
        calc("@v_end", "Velocity at its end", "v(1)", "", end, at.law.end.v, source="m + d(a_k + 2a_{k+1})/6"),
        calc("@still", "A velocity below this is none", "", "", "=check_zero*@cv", at.still, format="0E+00"),
        calc("@v_most", "Largest velocity", "", "", "=MAX([@intervals.v_high])", float(at.intervals["v_high"].max())),
        calc("@v_at", "Where the velocity is largest", "ξ_v", "", "=MIN([@intervals.fast])", at.peak),
    ]


def elimination(at: SplineTable) -> list[Quantity]:
    """Return the columns of the tridiagonal system, of its forward elimination, and of its back substitution."""
    last, before = "@used+1-[k]", "IF([k]=1,{1},INDEX([@solved.{0}],MAX([k]-1,1)))"
    solved = partial(column, at.solved)
    return [
        solved("d", "duration", "d", "=IF([k]<@used,INDEX([@points.xi],[k]+1)-[xi],0)", "to the next point"),
        calc("narrow", "not after the one before", "", "",
             "=IF(AND([k]<@used,[d]<@nearest),1,0)", filled([], at.rows, 0), format="0;;"),
        solved("m", "mean slope", "m", "=IF([d]>0,(INDEX([@points.s],[k]+1)-[s])/[d],@v1)", "Δs/d; behind it v(1)"),
        solved("before", "duration before", "", f"={before.format('d', '0')}"),
        solved("held", "has no equation", "", "=IF(OR([k]>@used,AND([k]=1,@free0=1),AND([k]=@used,@free1=1)),1,0)",
               "natural, or spare: a = 0"),
        solved("low", "factor of a_{k−1}", "", "=IF([held]=1,0,[before])", "d_{k−1}"),
        solved("high", "factor of a_{k+1}", "", "=IF([held]=1,0,[d])", "d_k"),
        solved("rhs", "right side", "", f"=IF([held]=1,0,6*([m]-{before.format('m', '@v0')}))", "6(m_k − m_{k−1})",
               UNIT),
        solved("share", "of the row before", "", "=IF([k]=1,0,[low]/[pivot-1])"),
        solved("pivot", "pivot", "", "=IF([held]=1,1,2*([before]+[d])-[share]*IF([k]=1,0,[high-1]))",
               "2(d_{k−1} + d_k), eliminated"),
        solved("right", "right side left", "", "=[rhs]-[share]*IF([k]=1,0,[right-1])", "", UNIT),
        solved("back", "a, from the last point", "",
               (f"=IF([k]>@used,0,(INDEX([@solved.right],{last})-INDEX([@solved.high],{last})"
                f"*IF([k]=1,0,[back-1]))/INDEX([@solved.pivot],{last}))"), "back substitution", UNIT),
    ]  # fmt: skip


def intervals_table(sheet: Sheet, at: SplineTable) -> None:
    """Declare the table of the intervals: rates at both ends, and extremes."""
    found = partial(column, at.intervals | {"fast": at.fastest_xi, "wrong": at.wrong_way}, scale=UNIT)
    moment, place = "INDEX([@solved.back],MAX(1,@used{0}-[k]))", "INDEX([@points.s],MIN([k]{0},@used))"
    sheet.heading("Table of the intervals, each from a point to the next")
    sheet.table(
        "@intervals", "On each a is linear, and W = a² − 2jv the same everywhere", at.rows,
        constant("k", "interval", "k", "", list(range(1, at.rows + 1))),
        found("xi", "begins at", "ξ_k", "=IF([k]<@used,INDEX([@points.xi],[k]),1)", scale=0.0),
        found("d", "duration", "d", "=INDEX([@solved.d],[k])", scale=0.0),
        found("a", "acceleration", "a", f"={moment.format('+1')}", "the moment", role=result),
        found("a1", "and at its end", "", f"={moment.format('')}"),
        found("j", "jerk", "j", "=IF([d]>0,([a1]-[a])/[d],0)", "Δa/d", role=result),
        found("v", "velocity", "v", "=IF([d]>0,INDEX([@solved.m],[k])-[d]*(2*[a]+[a1])/6,@v_end)",
               "m − d(2a_k + a_{k+1})/6", role=result),
        found("v1", "and at its end", "", "=[v]+[d]*([a]+[a1])/2"),
        found("y", "position", "", f"={place.format('')}", scale=0.0),
        found("y1", "and at its end", "", f"={place.format('+1')}", scale=0.0),
        found("w", "invariant", "W", "=[a]^2-2*[j]*[v]", "a² − 2jv"),
        found("v_low", "lowest v", "", SPEEDS.format("MIN")),
        found("v_high", "largest v", "", SPEEDS.format("MAX"), "at an end, or where a = 0"),
        found("third", "|a| where v·a is stationary", "√(W/3)", "=SQRT(MAX(0,[w])/3)"),
        found("va_plus", "v·a where a is that", "", POWER_AT.format("-", "0-"), "or at the begin"),
        found("va_minus", "and where a is less that", "", POWER_AT.format("+", ""), "or at the begin"),
        found("va_low", "lowest v·a", "", POWERS.format("MIN")),
        found("va_high", "largest v·a", "", POWERS.format("MAX"), "at an end, or where a² = W/3"),
        found("rises", "v rises through 0 at", "u", RISES, "where a = √W"),
        found("falls", "v falls through 0 at", "u", FALLS, "where a = −√W"),
        found("s_low", "lowest s", "", REACH.format("MIN", "rises"), scale=0.0),
        found("s_high", "highest s", "", REACH.format("MAX", "falls"), scale=0.0),
        found("square", "∫a² dξ", "", "=[d]*([a]^2+[a]*[a1]+[a1]^2)/3"),
        found("fast", "first place of the largest v", "", FASTEST, scale=0.0),
        found("wrong", "step of v the wrong way", "", WRONG),
    )  # fmt: skip


NARROW = "MATCH(1,[@solved.narrow],0)"
OUTER = ("[@points.xi.1]", "[@points.s.1]", "INDEX([@points.xi],@used)", "INDEX([@points.s],@used)")
ENDS_MEET = ",".join(f"{cell}={value}" for cell, value in zip(OUTER, "0011", strict=True))
LEADS = f"OR(@used<2,AND({ENDS_MEET}))"
PLACES = (f"{NARROW}+1", f"INDEX([@points.xi],{NARROW}+1)", f"INDEX([@points.xi],{NARROW})")

PAGE = SplinePage(
    titled="Cubic spline through points",
    source="the cubic spline in moments; TwinCAT, MC_MotionFunctionType, CubicSpline", entries=Points,
    law=Spline, pieces=(),
    coefficients={
        "cv": ("=MAX(@v_most,0-MIN([@intervals.v_low]))", "at a point, or where a = 0"),
        "ca_max": ("=MAX([@intervals.a])", "at a point: a is linear between two"),
        "ca_min": ("=MIN([@intervals.a])", "at a point"),
        "ca_rms": ("=SQRT(SUM([@intervals.square]))", "√∫a² of the intervals"),
        "cj": (
            '=IF(MAX(ABS([@intervals.a.first]),ABS([@intervals.a.last]))>check_zero*MAX(@ca_max,0-@ca_min),"∞",'
            "MAX(MAX([@intervals.j]),0-MIN([@intervals.j])))",
            "∞ where the acceleration jumps at an end",
        ),
        "va_max": ("=MAX([@intervals.va_high])", "at a point, or where a² = W/3"),
        "va_min": ("=MIN([@intervals.va_low])", "at a point, or where a² = W/3"),
    },
    fastest="=@v_at", lowest="=MIN([@intervals.v_low])", low="=MIN([@intervals.s_low])",
    high="=MAX([@intervals.s_high])", of_pieces=("c0", "c1"), start="=[@intervals.v.1]",
    wrong_step="=MAX([@intervals.wrong])", end_mode="=2", rests=False, single=False,
    checks=(
        LawCheck("@enough", "there are points", "@used>1", "enough", spelled(FEW, "@used")),
        LawCheck("@lead", "the points lead from 0 to 1", LEADS, "lead", spelled(LEAD, *OUTER)),
        LawCheck("@rise", "the points follow each other", "SUM([@solved.narrow])=0", "rise", spelled(RISE, *PLACES)),
    ),
    variations=VARIATIONS, functions=False,
)  # fmt: skip
