"""The rate that is tried in cells, and the range of rates between it and the present one."""

import math

from engine.drive.limit_use import Ends, Shares
from engine.drive.limits import BELOW, CYCLES
from engine.drive.rate_estimates import ASTRAY, BEYOND, PEAK_TORQUE, REDUCER_TORQUE, SPEEDS, TARGET, TARGET_BETWEEN
from engine.drive.rate_estimates import largest as largest_size
from workbook.book.declare import Quantity, Sheet, calc, constant
from workbook.book.sentence import quoted
from workbook.drive.motor import continuous_at
from workbook.fields.units import PER_MINUTE, shown
from workbook.machines.machine.drive.max_rate import (
    ABOUT,
    LIMITS,
    MEETS,
    NEVER_HELD,
    NOT_REACHED,
    cubic,
    estimates_table,
    grown,
    largest,
    means,
    met,
    names_of,
)
from workbook.machines.machine.drive.view import DriveView

TRIED = (
    "Near the upper end of that estimate the points have torques T_1,N and T_N too. From a rate that holds to the "
    "other, each torque grows by a straight line over x: 1/σ of the way it is at 99.9 or 99.7 % of its limit."
)


def curve(column: str, times: str = "1") -> str:
    """Return the formula of what torque and speed use of the falling line."""
    return f"SUMPRODUCT(MAX(([@pt.{column}]^2)^0.5+@fall*([@pt.n]^2)^0.5*{times}))"


USES: dict[str, tuple[str, str]] = {
    "RMS torque": ("@rms/@continuous",
                   f"SQRT(SUMPRODUCT([@pt.share],[@pt.TN],[@pt.TN]))/{continuous_at('(@mean*@times)')}"),
    PEAK_TORQUE: ("MAX(@tmax,0-@tmin)/@motor_peak", "@TN_max/@motor_peak"),
    "motor speed": ("@speed/@motor_nmax", "@speed*@times/@motor_nmax"),
    "reducer input speed": ("IF({limit}=0,0,@speed/{limit})", "IF({limit}=0,0,@speed*@times/{limit})"),
    REDUCER_TORQUE: ("IF({limit}=0,0,@smax/{limit})", "IF({limit}=0,0,@SN_max/{limit})"),
    CYCLES: ("IF(OR({limit}=0,@cycles<=@full*(1+1E-9)),0,@smax/{limit})",
             "IF(OR({limit}=0,60*@tried<=@full*(1+1E-9)),0,@SN_max/{limit})"),
    "reducer mean torque": ("IF({limit}=0,0,@smean/{limit})", "IF({limit}=0,0,@SN_mean/{limit})"),
    BELOW: (f"IF(@fall=0,0,{curve('T')}/{{limit}})", f"IF(@fall=0,0,{curve('TN', '@times')}/{{limit}})"),
}  # fmt: skip
"""the use of each limit in cells: at the present rate, and at the one that is tried"""


def rates_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the means that the rates depend on, the estimated rates of each limit, and those between two rates."""
    sheet.heading("Workings: the rates", ABOUT)
    sheet.rows(*means(view))
    estimates_table(sheet, view)
    sheet.heading("Workings: the rate that is tried", TRIED)
    sheet.rows(*tried(view))
    between_table(sheet, view)
    sheet.rows(*ends(view))


def tried(view: DriveView) -> list[Quantity]:
    """Return the rows of the rate that is tried, and of the points' figures there."""
    search, size = view.search, view.scales
    then = search.points_tried
    return [
        calc("@estimate", "Estimated highest rate", "", "cycles/min",
             "=IF(COUNT([@held.rate])=0,@rate,MIN([@held.rate]))", shown(search.estimate, PER_MINUTE)),
        constant("@off", "It may be off by", "", "", BEYOND, "of it"),
        constant("@off_way", "… and by", "", "", ASTRAY, "of the way to it"),
        calc("@astray", "It may be off by", "", "cycles/min", "=@off*@estimate+@off_way*ABS(@estimate-@rate)",
             shown(search.astray, PER_MINUTE)),
        calc("@holds", "All limits hold at the present rate", "", "", "=IF(MAX([@between.now])<=1,1,0)",
             int(search.holds), "1 yes, 0 no", format="0"),
        calc("@tried", "Rate that is tried", "N_t", "cycles/min",
             "=IF(@holds=1,@estimate+@astray,MAX(@estimate-@astray,@estimate/2))", shown(search.tried, PER_MINUTE),
             "beyond the estimate; below, if not all holds"),
        calc("@times", "over the present one", "", "", "=@tried/@rate", search.factor),
        calc("@over_T", "Peak of T over the largest at a point", "", "",
             f"=IF({largest('T')}>0,MAX(@tmax,0-@tmin)/{largest('T')},1)", search.over[0]),
        calc("@over_S", "Peak of T_1 over the largest at a point", "", "",
             f"=IF({largest('S')}>0,@smax/{largest('S')},1)", search.over[1]),
        calc("@TN_max", "Largest torque of the motor there", "T_N", "Nm", f"={largest('TN')}*@over_T",
             largest_size(then.torque) * search.over[0], scale=size.torque),
        calc("@SN_max", "Largest output torque of the reducer there", "T_1,N", "Nm", f"={largest('SN')}*@over_S",
             largest_size(then.load.output_torque) * search.over[1], scale=size.behind),
        calc("@SN_mean", "Mean output torque of the reducer there", "", "Nm", f"={cubic('SN')}",
             then.cubic_mean(then.load.output_torque), scale=size.behind),
        calc("@holds_tried", "All limits hold at the rate that is tried", "", "", "=IF(MAX([@between.then])<=1,1,0)",
             int(search.tried_holds), "1 yes, 0 no", format="0"),
        calc("@cycles_use", "Use of the reducer's torque at its cycles", "", "",
             f"=IF(@reducer_peak=0,0,{CYCLES_USE.format(list(LIMITS).index(CYCLES) + 1)})",
             search.cycles_use[search.begin], "where is interpolated from"),
        calc("@x_from", "Squares of rates between which is interpolated: from", "x_N", "",
             "=IF(@holds=1,1,IF(@holds_tried=1,@times^2,0))", search.way[0] ** 2, "one that holds, or 0"),
        calc("@x_to", "… to", "x_N", "", "=IF(@holds=1,@times^2,IF(@holds_tried=1,1,@times^2))", search.way[1] ** 2),
        target(view),
        *([calc("@released", "Rate beyond which the brake has no time to hold", "N", "cycles/min",
                f'=IF({RELEASED}>0,@rate/{RELEASED},"{NOT_REACHED}")', met(search.released), align="right")]
          if view.brakes else []),
    ]  # fmt: skip


def target(view: DriveView) -> Quantity:
    """Return the row of the use of a limit at the ends of the range."""
    told = "@target", "Use of a limit at the ends of the range", "", ""
    note, value = "what is left is for peaks between points", view.search.target
    if view.varies or view.driven.by_angle or view.driven.entered.load.viscous is None:
        return constant(*told, value, note)
    return calc(*told, f"=IF(@viscous>0,{TARGET_BETWEEN},{TARGET})", value, note)


CYCLES_USE = "IF(@holds=1,@smax,IF(@holds_tried=1,@SN_max,[@held.stands.{}]))*@reducer_fs/@reducer_peak"
RELEASED = "SUMPRODUCT(MAX([@iv.held]*@brake_least/([@iv.dwell]+tiny)))"


def way(names: list[str], begin: int, sign: int) -> list[str]:
    """Return the formulas of shares from a rate on, of torques forward (0) or backward (1)."""
    uses = (("[now]", "[then]"), ("[then]", "[now]"), ("[@held.stands.{}]/[@held.limit.{}]", "[then]"))[begin]
    found = []
    for row, name in enumerate(names, 1):
        if name in MEETS:
            letter = "T" if name == PEAK_TORQUE else "S"
            columns = ((letter, f"{letter}N"), (f"{letter}N", letter), (f"{letter}0", f"{letter}N"))[begin]
            found.append(f"={grown(*columns, '[cap]', not sign)}")
        elif sign:
            found.append("=0+0")
        else:
            low, high = (use.format(row, row) for use in uses)
            limit = f"[@held.limit.{row}]=0"
            found.append(f"=IF({limit},0,MIN(1/@least_use,MAX(0,{high}-{low})/MAX(tiny,@target-{low})))")
    return found


def between_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of each limit's use at both rates, and of the rates between which it is held."""
    names, search = names_of(view), view.search
    shares = [search.between.get(name, (Shares(0.0),) * 3) for name in names]
    ends = [search.ends.get(name, Ends(0.0, math.inf)) for name in names]
    rows = list(enumerate(names, 1))

    caps = [f"=@target*[@held.cap.{row}]/{'@over_T' if name == PEAK_TORQUE else '@over_S'}" if name in MEETS
            else "=@target+0" for row, name in rows]  # fmt: skip

    def high(row: int, name: str) -> str:
        rate = f"[@held.rate.{row}]"
        if name in SPEEDS:
            return f'=IF(@x_to<@x_from,@tried,IF(ISNUMBER({rate}),{rate}*(1-1E-6),"{NOT_REACHED}"))'
        is_curved = name == BELOW and search.has_constant_ratio
        held = f"MIN([met],@target*{rate})" if is_curved else "[met]"
        return f'=IF(@x_to<@x_from,@tried,IF(ISNUMBER({rate}),{held},"{NOT_REACHED}"))'

    at = "SQRT(MAX(0,@x_from+(@x_to-@x_from)/([share]+tiny)))"
    meets = f'=IF([share]<=@least_use,"{NOT_REACHED}",@rate*{at})'
    cycles = (f'=IF(AND([share]<=@least_use,@cycles_use<1),"{NOT_REACHED}",'
              f'MAX(@full/60,IF(@cycles_use<1,@rate,0)*{at}))')  # fmt: skip

    sheet.row += 1
    sheet.table(
        "@between", "Between both rates: from and up to which rate each limit is held", len(names),
        constant("name", "limit", "", "", names, align="left"),
        *(calc(name, label, "", "", [f"={USES[one][k].format(limit=f'[@held.limit.{row}]')}" for row, one in rows],
               [uses.get(one, 0.0) for one in names])
          for k, (name, label, uses) in enumerate((("now", "use at the present rate", search.uses),
                                                   ("then", "use at the rate that is tried", search.uses_tried)))),
        calc("cap", "use, or torque at points, at the end", "", "", caps,
             [search.caps.get(name, search.target) for name in names], format="0.0E+00"),
        *(calc(name, label, "1/σ", "", way(names, begin, sign), [share[begin][sign] for share in shares], scale=1.0)
          for name, label, begin, sign in WAYS),
        calc("share", "share of the way", "1/σ", "",
             "=IF(@holds=1,MAX([on],[on_b]),IF(@holds_tried=1,MAX([back],[back_b]),MAX([rest],[rest_b])))",
             [max(share[search.begin]) for share in shares], scale=1.0),
        calc("met", "met at", "N", "cycles/min",
             [cycles if name == CYCLES else meets for name in names],
             [met(search.met(name)) if name in search.between else NOT_REACHED for name in names], align="right"),
        calc("high", "held up to", "N", "cycles/min", [high(*each) for each in rows], [met(one.high) for one in ends],
             align="right"),
        calc("low", "held from", "N", "cycles/min",
             [f"=IF(@x_to<@x_from,IF(ISNUMBER([met]),[met],0),[@held.low.{row}])" for row, _ in rows],
             [met(one.low, NEVER_HELD) for one in ends], align="right", scale=view.rate),
    )  # fmt: skip


WAYS = (
    ("on", "grows from the present rate on", 0, 0), ("on_b", "… torques backward", 0, 1),
    ("back", "from the tried rate to the present", 1, 0), ("back_b", "… torques backward", 1, 1),
    ("rest", "from standstill to the tried rate", 2, 0), ("rest_b", "… torques backward", 2, 1),
)  # fmt: skip


def ends(view: DriveView) -> list[Quantity]:
    """Return the rows of both ends of the range, as the limits tell them."""
    search = view.search
    up_to = "MIN([@between.high])"
    if view.brakes:
        up_to = f"IF(AND(@holds=1,@holds_tried=0,ISNUMBER(@released)),MIN(@released,{up_to}),{up_to})"
    low, high = search.limits_ends
    lows, highs = zip(*(search.ends.get(name, Ends(0.0, math.inf)) for name in names_of(view)), strict=True)
    return [
        calc("@up_to", "All limits held up to", "", "cycles/min",
             f'=IF(COUNT([@between.high])=0,"{NOT_REACHED}",IF(@holds=1,MAX(@rate,{up_to}),{up_to}))', met(high),
             align="right"),
        calc("@down_to", "All limits held from", "", "cycles/min",
             f'=IF(COUNTIF([@between.low],"{NEVER_HELD}")>0,"{NEVER_HELD}",'
             "IF(@holds=1,MIN(@rate,MAX([@between.low])),MAX([@between.low])))", met(low, NEVER_HELD), align="right"),
        calc("@high_row", "Row of the limit that has the upper end", "", "",
             "=IF(COUNT([@between.high])=0,1,MATCH(MIN([@between.high]),[@between.high],0))",
             highs.index(min(highs)) + 1, format="0"),
        calc("@low_row", "Row of the limit that has the lower end", "", "",
             f'=IF(COUNTIF([@between.low],{quoted(NEVER_HELD)})>0,MATCH({quoted(NEVER_HELD)},[@between.low],0),'
             "MATCH(MAX([@between.low]),[@between.low],0))", lows.index(max(lows)) + 1, format="0"),
        calc("@some", "There is a rate at which all hold", "", "",
             "=IF(ISNUMBER(@down_to),IF(ISNUMBER(@up_to),IF(@down_to<@up_to,1,0),1),0)", int(search.range.high > 0.0),
             "1 yes, 0 no", format="0"),
    ]  # fmt: skip
