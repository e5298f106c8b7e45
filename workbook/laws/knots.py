"""A cubic spline in cells: moments by elimination, back substitution from the last point; extremes in closed form."""

from collections.abc import Callable, Sequence

from engine.laws.knots import EQUAL, Knots
from engine.laws.spline import NARROWEST
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.laws.family import BEHIND

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


def worked_out() -> dict[str, tuple[str, str]]:
    """Return the formula of each coefficient."""
    return {
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
    }


def solution(at: Knots) -> list[Quantity]:
    """Return the rows that the table of points refers to."""
    first, last = at.slopes
    free = at.law.natural
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
    ]  # fmt: skip


def points_table(sheet: Sheet, at: Knots, entered: Sequence[Quantity]) -> None:
    """Declare the table of points: what is entered, and beside it the solution."""
    points = sheet.table(
        "@points", "Fill one row each, in order; from (0, 0) to (1, 1); leave spare rows empty", at.rows,
        constant("k", "point", "k", "", list(range(1, at.rows + 1))),
        *entered,
    )  # fmt: skip
    sheet.workings(points, "@solved", "Workings: the spline's moments", BEHIND, *elimination(at))


def elimination(at: Knots) -> list[Quantity]:
    """Return the columns of the tridiagonal system, of its forward elimination, and of its back substitution."""
    last = "@used+1-[k]"
    before = "IF([k]=1,{1},INDEX([@solved.{0}],MAX([k]-1,1)))"

    def column(name: str, label: str, symbol: str, formula: str, source: str = "", scale: float = 0.0) -> Quantity:
        return calc(name, label, symbol, "", formula, at.solved[name], source=source, scale=scale)

    return [
        column("d", "duration", "d", "=IF([k]<@used,INDEX([@points.xi],[k]+1)-[xi],0)", "to the next point"),
        calc("narrow", "not after the one before", "", "",
             "=IF(AND([k]<@used,[d]<@nearest),1,0)", filled([], at.rows, 0), format="0;;"),
        column("m", "mean slope", "m", "=IF([d]>0,(INDEX([@points.s],[k]+1)-[s])/[d],@v1)", "Δs/d; behind it v(1)"),
        column("before", "duration before", "", f"={before.format('d', '0')}"),
        column("held", "has no equation", "", "=IF(OR([k]>@used,AND([k]=1,@free0=1),AND([k]=@used,@free1=1)),1,0)",
               "natural, or spare: a = 0"),
        column("low", "factor of a_{k−1}", "", "=IF([held]=1,0,[before])", "d_{k−1}"),
        column("high", "factor of a_{k+1}", "", "=IF([held]=1,0,[d])", "d_k"),
        column("rhs", "right side", "", f"=IF([held]=1,0,6*([m]-{before.format('m', '@v0')}))", "6(m_k − m_{k−1})",
               UNIT),
        column("share", "of the row before", "", "=IF([k]=1,0,[low]/[pivot-1])"),
        column("pivot", "pivot", "", "=IF([held]=1,1,2*([before]+[d])-[share]*IF([k]=1,0,[high-1]))",
               "2(d_{k−1} + d_k), eliminated"),
        column("right", "right side left", "", "=[rhs]-[share]*IF([k]=1,0,[right-1])", "", UNIT),
        column("back", "a, from the last point", "",
               (f"=IF([k]>@used,0,(INDEX([@solved.right],{last})-INDEX([@solved.high],{last})"
                f"*IF([k]=1,0,[back-1]))/INDEX([@solved.pivot],{last}))"), "back substitution", UNIT),
    ]  # fmt: skip


def intervals_table(sheet: Sheet, at: Knots) -> None:
    """Declare the table of the intervals: rates at both ends, and extremes."""
    found = at.intervals | {"fast": at.fast, "wrong": at.wrong}
    moment, place = "INDEX([@solved.back],MAX(1,@used{0}-[k]))", "INDEX([@points.s],MIN([k]{0},@used))"

    def column(
        name: str, label: str, symbol: str, formula: str, source: str = "", scale: float = UNIT,
        role: Callable[..., Quantity] = calc,
    ) -> Quantity:  # fmt: skip
        return role(name, label, symbol, "", formula, found[name], source=source, scale=scale)

    sheet.heading("Table of the intervals, each from a point to the next")
    sheet.table(
        "@intervals", "On each a is linear, and W = a² − 2jv the same everywhere", at.rows,
        constant("k", "interval", "k", "", list(range(1, at.rows + 1))),
        column("xi", "begins at", "ξ_k", "=IF([k]<@used,INDEX([@points.xi],[k]),1)", "", 0.0),
        column("d", "duration", "d", "=INDEX([@solved.d],[k])", "", 0.0),
        column("a", "acceleration", "a", f"={moment.format('+1')}", "the moment", role=result),
        column("a1", "and at its end", "", f"={moment.format('')}"),
        column("j", "jerk", "j", "=IF([d]>0,([a1]-[a])/[d],0)", "Δa/d", role=result),
        column("v", "velocity", "v", "=IF([d]>0,INDEX([@solved.m],[k])-[d]*(2*[a]+[a1])/6,@v_end)",
               "m − d(2a_k + a_{k+1})/6", role=result),
        column("v1", "and at its end", "", "=[v]+[d]*([a]+[a1])/2"),
        column("y", "position", "", f"={place.format('')}", "", 0.0),
        column("y1", "and at its end", "", f"={place.format('+1')}", "", 0.0),
        column("w", "invariant", "W", "=[a]^2-2*[j]*[v]", "a² − 2jv"),
        column("v_low", "lowest v", "", SPEEDS.format("MIN")),
        column("v_high", "largest v", "", SPEEDS.format("MAX"), "at an end, or where a = 0"),
        column("third", "|a| where v·a is stationary", "√(W/3)", "=SQRT(MAX(0,[w])/3)"),
        column("va_plus", "v·a where a is that", "", POWER_AT.format("-", "0-"), "or at the begin"),
        column("va_minus", "and where a is less that", "", POWER_AT.format("+", ""), "or at the begin"),
        column("va_low", "lowest v·a", "", POWERS.format("MIN")),
        column("va_high", "largest v·a", "", POWERS.format("MAX"), "at an end, or where a² = W/3"),
        column("rises", "v rises through 0 at", "u", RISES, "where a = √W"),
        column("falls", "v falls through 0 at", "u", FALLS, "where a = −√W"),
        column("s_low", "lowest s", "", REACH.format("MIN", "rises"), "", 0.0),
        column("s_high", "highest s", "", REACH.format("MAX", "falls"), "", 0.0),
        column("square", "∫a² dξ", "", "=[d]*([a]^2+[a]*[a1]+[a1]^2)/3"),
        column("fast", "first place of the largest v", "", FASTEST, "", 0.0),
        column("wrong", "step of v the wrong way", "", WRONG),
    )  # fmt: skip
