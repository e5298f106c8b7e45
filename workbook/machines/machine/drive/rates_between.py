"""The rate that is tried in cells, and the range of rates between it and the present one."""

import math

from engine.drive import rate_estimates
from engine.drive.limit_use import RateSearch
from engine.drive.limits import BELOW, CYCLES, PEAK_TORQUE, REDUCER_TORQUE
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Quantity, Sheet
from workbook.book.sentence import quoted
from workbook.drive.motor import continuous_at
from workbook.fields.units import PER_MINUTE, shown
from workbook.machines.machine.drive import max_rate
from workbook.machines.machine.drive.view import DriveView, count_steps

CELLS = cell_tables(__file__)

TRIED = (
    "Near the upper end of that estimate the points have torques T_1,N and T_N too. From a rate that holds to the "
    "other, each torque grows by a straight line over x: 1/σ of the way it is at 99.9 or 99.7 % of its limit."
)


def curve(column: str, times: str = "1") -> str:
    """Return the formula of what torque and speed use of the falling line."""
    return f"SUMPRODUCT(MAX(([@pt.{column}]^2)^0.5+@fall*([@pt.n]^2)^0.5*{times}))"


def rates_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the means that the rates depend on, the estimated rates of each limit, and those between two rates."""
    sheet.heading("Workings: the rates", max_rate.ABOUT)
    sheet.rows(*max_rate.means(view))
    max_rate.estimates_table(sheet, view)
    sheet.heading("Workings: the rate that is tried", TRIED)
    sheet.rows(*tried_rate(view))
    between_table(sheet, view)
    sheet.rows(*ends(view))


def tried_rate(view: DriveView) -> list[Quantity]:
    """Return the rows of the rate that is tried, and of the points' figures there."""
    search, then = view.search, view.search.points_tried
    cell = CELLS["tried"].sharing(**view.parts, not_reached=max_rate.NOT_REACHED)
    torque, output, over = then.torque, then.load.output_torque, search.over
    return [
        cell("@estimate", shown(search.estimate, PER_MINUTE)),
        cell("@off", rate_estimates.BEYOND),
        cell("@off_way", rate_estimates.ASTRAY),
        cell("@astray", shown(search.astray, PER_MINUTE)),
        cell("@holds", int(search.holds)),
        cell("@tried", shown(search.tried, PER_MINUTE)),
        cell("@times", search.factor),
        cell("@over_T", over[0], largest=max_rate.largest("T")),
        cell("@over_S", over[1], largest=max_rate.largest("S")),
        cell("@TN_max", rate_estimates.largest(torque) * over[0], largest=max_rate.largest("TN")),
        cell("@SN_max", rate_estimates.largest(output) * over[1], largest=max_rate.largest("SN")),
        cell("@SN_mean", then.cubic_mean(output), cubic=max_rate.cubic("[@pt.SN]")),
        cell("@holds_tried", int(search.tried_holds)),
        cell("@cycles_use", search.cycles_use[search.begin]),
        cell("@from", search.way[0]),
        cell("@to", search.way[1]),
        target(view),
        *([cell("@target_curve", rate_estimates.TARGET_CURVE)] if view.knows_falling else []),
        *([cell("@released", max_rate.as_rate(search.released))] if view.brakes else []),
    ]


def target(view: DriveView) -> Quantity:
    """Return the row of the use of a limit at the ends of the range."""
    value = view.search.target
    if view.varies or view.driven.by_angle or not view.is_viscous:
        return CELLS["target"]("@target", value)
    return CELLS["target of a viscous load"](
        "@target", value, between=rate_estimates.TARGET_BETWEEN, at_an_end=rate_estimates.TARGET
    )


def way(names: list[str], begin: int, sign: int) -> list[str]:
    """Return the formulas of shares from a rate on, of torques forward (0) or backward (1)."""
    holds = ("@holds*", "@holds_tried*", "")[begin]
    uses = (("[now]", "[then]"), ("[then]", "[now]"), ("[@held.stands.{}]/[@held.limit.{}]", "[then]"))[begin]
    found = []
    for row, name in enumerate(names, 1):
        if name in max_rate.MEETS:
            letter = "T" if name == PEAK_TORQUE else "S"
            columns = ((letter, f"{letter}N"), (f"{letter}N", letter), (f"{letter}0", f"{letter}N"))[begin]
            share = max_rate.grown(*columns, "[cap]", not sign)
        elif sign:
            share = "0"
        else:
            low, high = (use.format(row, row) for use in uses)
            limit = f"[@held.limit.{row}]=0"
            grows = f"({high}-{low}>@least_use*{low})*({high}-{low})"
            share = f"IF({limit},0,MIN(1/@least_use,{grows}/MAX(tiny,[cap]-{low})))"
        found.append(f"={holds}{share}")
    return found


def between_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of each limit's use at both rates, and of the rates between which it is held."""
    cell = CELLS["between"]
    names, search = max_rate.names_of(view), view.search
    shares = [search.between.get(name, (rate_estimates.Shares(0.0),) * 3) for name in names]
    ends = [search.ends.get(name, rate_estimates.Ends(0.0, math.inf)) for name in names]
    rows = list(range(1, len(names) + 1))
    least = "(1-1E-6)" if search.points.load.train.has_constant_ratio else "@target"
    parts = {"continuous": continuous_at("(@mean*@times)"), "least": least, "not_reached": max_rate.NOT_REACHED}
    curves = {"curve": curve("T"), "curve_then": curve("TN", "@times")}
    by_limit = {
        head: column[: len(rows)] for head, column in formulas_by_row(__file__, "by limit", **parts, **curves).items()
    }
    cell = cell.sharing(row=rows, not_reached=max_rate.NOT_REACHED, **by_limit)
    meets = [max_rate.as_rate(search.met(name)) if name in search.between else max_rate.NOT_REACHED for name in names]
    lows = [max_rate.as_rate(end.low, max_rate.NEVER_HELD) for end in ends]
    sheet.row += 1
    cell.place(
        sheet,
        cell("name", names),
        cell("now", [search.uses.get(name, 0.0) for name in names]),
        cell("then", [search.uses_tried.get(name, 0.0) for name in names]),
        cell("cap", [search.caps.get(name, rate_estimates.TARGET_CURVE) for name in names]),
        *(
            cell(column, [share[begin][sign] for share in shares], formula=way(names, begin, sign))
            for column, (begin, sign) in WAYS.items()
        ),
        cell("share", [max(share[search.begin]) for share in shares]),
        cell("part", [part(search, name) for name in names]),
        *(orders(view) if view.is_viscous or view.knows_falling else []),
        cell("met", meets, formula=[met_at(view, name) for name in names]),
        cell("high", [max_rate.as_rate(end.high) for end in ends]),
        cell("low", lows, scale=view.rate),
    )


ORDER = "IF({beyond},2,MAX(1,MIN([power],IF([base]*[@held.limit.{row}]<[@held.stands.{row}]*(1-eps),{growth},2))))"
BEYOND_BOTH = "@holds*([share]<1)=1"


def orders(view: DriveView) -> list[Quantity]:
    """Return the columns of the power of the rate over which the use of each limit is a line."""
    cell, names, search = CELLS["orders"], max_rate.names_of(view), view.search
    rows = [names.index(REDUCER_TORQUE if name == CYCLES else name) + 1 for name in names]
    growth, others = ("@growth", f"OR(@viscous=0,{BEYOND_BOTH})") if view.is_viscous else ("2", "1=1")
    order = [
        ORDER.format(row=row, growth=growth, beyond=BEYOND_BOTH if name == BELOW else others)
        for row, name in zip(rows, names, strict=True)
    ]
    uses = [search.uses_at_rates(name) for name in names]
    return [
        cell("base", [rate_estimates.use_below(*each) for each in uses], row=rows),
        cell("power", [search.power(name) for name in names], row=rows),
        cell("order", [search.order(name) for name in names], order=order),
    ]


def met_at(view: DriveView, name: str) -> str:
    """Return the formula of the rate at which a limit is reached by the line between both rates."""
    over, under = ("^[order]", "^(1/[order])") if view.is_viscous or view.knows_falling else ("^2", "^(1/2)")
    at = f"@rate*MAX(0,@from{over}+(@to{over}-@from{over})*[part]){under}"
    if name != CYCLES:
        return f'=IF(ISNUMBER([part]),{at},"{max_rate.NOT_REACHED}")'
    return f'=IF(OR(ISNUMBER([part]),@cycles_use>=1),MAX(@full/60,IF(@cycles_use<1,{at},0)),"{max_rate.NOT_REACHED}")'


WAYS = {
    f"{column}{end}": (begin, sign)
    for begin, column in enumerate(("on", "back", "rest"))
    for sign, end in enumerate(("", "_b"))
}
"""of the columns of shares: where they begin, and whether torques are forward (0) or backward (1)"""


def part(search: RateSearch, name: str) -> float | str:
    """Return the part of the way to the tried rate after which a limit is reached, or the word for none."""
    found = search.part(name) if name in search.between else math.inf
    return max_rate.NOT_REACHED if math.isinf(found) else found


def ends(view: DriveView) -> list[Quantity]:
    """Return the rows of both ends of the range, as the limits tell them."""
    cell = CELLS["ends"].sharing(not_reached=max_rate.NOT_REACHED, never_held=max_rate.NEVER_HELD)
    search, none = view.search, rate_estimates.Ends(0.0, math.inf)
    up_to = "MIN([@between.high])"
    if view.brakes:
        up_to = f"IF(AND(@holds=1,@holds_tried=0,ISNUMBER(@released)),MIN(@released,{up_to}),{up_to})"
    low, high = search.limits_ends
    lows, highs = zip(*(search.ends.get(name, none) for name in max_rate.names_of(view)), strict=True)
    steps = count_steps(shown(high, PER_MINUTE)) if 0.0 < search.range.high < math.inf else 1.0
    return [
        cell("@up_to", max_rate.as_rate(high), up_to=up_to),
        cell("@down_to", max_rate.as_rate(low, max_rate.NEVER_HELD)),
        cell("@high_row", highs.index(min(highs)) + 1),
        cell("@low_row", lows.index(max(lows)) + 1, quoted=quoted(max_rate.NEVER_HELD)),
        cell("@some", int(search.range.high > 0.0)),
        cell("@unit_rate", 1.0),
        cell("@steps", steps),
    ]
