"""The rates at which a drive holds all its limits, in cells: estimated, tried near the upper end, and between both.

With T_s the torque at standstill and I = T − T_s, a rate of √x times the present one takes T_s + x I.
"""

import math
from collections.abc import Iterable, Sequence

from engine.drive.limit_use import (
    ASTRAY,
    BEYOND,
    LEAST_USE,
    NO_LIMIT,
    PEAK_TORQUE,
    REDUCER_TORQUE,
    SPEEDS,
    TARGET,
    TARGET_BETWEEN,
    Ends,
    Shares,
    continuous_line,
    mean_squares,
)
from engine.drive.limit_use import (
    largest as largest_size,
)
from engine.drive.limits import BELOW, CYCLES
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.sentence import CheckSentence, Sentence, quoted
from workbook.drive.motor import continuous_at
from workbook.fields.units import PER_MINUTE, RPM, shown
from workbook.machines.machine.drive.view import AT_NO_RATE, NONE_BINDS, DriveView, Rates

NOT_REACHED, NEVER_HELD = "–", "never"
NOTE = "at most 1 % below the exact one from 0.6 to 1.5 times it; never above"
ABOUT = (
    "At rest a torque T_s stands; I = T − T_s grows with the square of the rate. At √x times it the "
    "torque is T_s + x I; of each limit, 1/x is the share that grows so and is used. T_rms is at its limit where "
    "A_s + 2 B_s x + C_s x² = (M − ΔM √x)², with √x ≤ (x_s + x/x_s)/2."
)
TRIED = (
    "Near the upper end of that estimate the points have torques T_1,N and T_N too. From a rate that holds to the "
    "other, each torque grows by a straight line over x: 1/σ of the way it is at 99.9 or 99.7 % of its limit."
)
MEETS = (PEAK_TORQUE, REDUCER_TORQUE, CYCLES)  # the limits of torques at points
RANGE_END = 0.0499
"""what is taken off an end of a range, before it is rounded: a whole amount such as 200 lies at no edge"""


def grown(begin: str, end: str, limit: str, forward: bool) -> str:
    """Return the formula of the largest share 1/x of a limit by torques that grow from a column to another."""
    begin, end = f"[@pt.{begin}]", f"[@pt.{end}]"
    more, less, left = (end, begin, f"{limit}-{begin}") if forward else (begin, end, f"{limit}+{begin}")
    return f"SUMPRODUCT(MAX(({more}>{less})*({more}-{less})/(({left}>0)*({left})+tiny)))"


def shrunk(begin: str, end: str, limit: str, forward: bool) -> str:
    """Return the formula of the x from which torques that shrink hold a limit."""
    begin, end = f"[@pt.{begin}]", f"[@pt.{end}]"
    more, less, over = (begin, end, f"{begin}-{limit}") if forward else (end, begin, f"0-{begin}-{limit}")
    return f"MIN(1/@least_use,MAX(0,SUMPRODUCT(MAX(({over})/(({more}>{less})*({more}-{less})+tiny)))))"


def largest(column: str) -> str:
    """Return the formula of the largest size of a column of points."""
    return f"MAX(MAX([@pt.{column}]),0-MIN([@pt.{column}]))"


def cubic(column: str) -> str:
    """Return the formula of the cubic mean of a torque behind the reducer, weighted by |n|, which is (n²)^½."""
    return f"IF(@mean>0,(SUMPRODUCT([@pt.share],([@pt.n]^2)^0.5,([@pt.{column}]^2)^1.5)/@mean)^(1/3),0)"


def curve(column: str, times: str = "1") -> str:
    """Return the formula of what torque and speed use of the falling line."""
    return f"SUMPRODUCT(MAX(([@pt.{column}]^2)^0.5+@fall*([@pt.n]^2)^0.5*{times}))"


def names_of(view: DriveView) -> list[str]:
    """Return the names of the limits in the order of their rows."""
    return [*LIMITS, *([BELOW] if view.knows_falling else [])]


ROOT = "@root"


def at_points(none: str, now: str, limit: str) -> tuple[str, ...]:
    """Return the formulas of a limit of torques at points: what stands, the shares, and from which x it is held."""
    ways = (of(none, now, limit, way) for of in (grown, shrunk) for way in (True, False))
    return largest(none), *ways


LIMITS: dict[str, tuple[str, ...]] = {
    "RMS torque": (
        "@line", "SQRT(@stand)",
        f"IF(@speed=0,0,IF(@left>0,({ROOT}+@half)/@left,IF(OR(@half>=0,@square<0),0,@grow/({ROOT}-@half))))", "0",
        f"IF(OR(@speed=0,@left>0),0,IF(OR(@half>=0,@square<0),1/@least_use,(0-@left)/({ROOT}-@half)))", "0"),
    PEAK_TORQUE: ("@motor_peak", *at_points("T0", "T", "[cap]")),
    "motor speed": ("@motor_nmax", "0", "(@speed/[limit])^2", "0", "0", "0"),
    "reducer input speed": ("@reducer_nmax", "0", "IF([limit]=0,0,(@speed/[limit])^2)", "0", "0", "0"),
    REDUCER_TORQUE: ("@reducer_peak", *at_points("S0", "S", "[cap]")),
    CYCLES: ("@reducer_peak/@reducer_fs", *at_points("S0", "S", "[cap]")),
    "reducer mean torque": (
        "@reducer_mean", "@smean0", "IF([limit]=0,0,MAX(0,@smean-[stands])/(MAX(0,[limit]-[stands])+tiny))", "0",
        "IF([limit]=0,0,MIN(1/@least_use,MAX(0,([stands]-[limit])/(MAX(0,[stands]-@smean)+tiny))))", "0"),
}  # fmt: skip
"""of each limit in cells: the limit itself, what stands at any rate, the shares 1/x of torques forward and backward,
and the x from which they are held"""
FALLING = ("@corner", largest("T0"), "MAX([@pt.uc])", "MAX([@pt.ub])", "0", "0")
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


def means(view: DriveView) -> list[Quantity]:
    """Return the rows of the means that the rates depend on, and of the line of the continuous torque."""
    points, size = view.points, view.scales.torque**2
    own, mixed, growing = mean_squares(points)
    stall, fall, near, half, left, square = continuous_line(points, view.driven.motor)
    most = size + stall**2
    return [
        calc("@stand", "Mean of T_s²", "A_s", "Nm²", "=SUMPRODUCT([@pt.share],[@pt.T0],[@pt.T0])", own, scale=size),
        calc("@mixed", "Mean of T_s I", "B_s", "Nm²", "=SUMPRODUCT([@pt.share],[@pt.T0],[@pt.T]-[@pt.T0])", mixed,
             scale=size),
        calc("@grow", "Mean of I²", "C_s", "Nm²", "=SUMPRODUCT([@pt.share],([@pt.T]-[@pt.T0])^2)", growing, scale=size),
        calc("@line", "Continuous torque at no speed", "M", "Nm",
             "=IF(@continuous>@motor_rated,@motor_stall,@motor_rated)", stall, "T_N beyond n_N"),
        calc("@sink", "Its fall to that at the mean speed", "ΔM", "Nm", "=@line-@continuous", fall, scale=stall),
        calc("@near", "Rate at which T_s alone is as large", "x_s", "",
             "=IF(AND(@sink>0,@line>SQRT(@stand)),MIN(1,(@line-SQRT(@stand))/@sink),1)", near,
             "over the present one, at most 1"),
        calc("@half", "What grows with x, and half the fall", "b_s", "Nm²",
             "=@mixed+@sink*(@line/@near-@sink)/2", half, "B_s + ΔM (M/x_s − ΔM)/2", scale=most),
        calc("@left", "What T_s leaves", "c_s", "Nm²", "=@line*(@line-@sink*@near)-@stand", left,
             "M (M − ΔM x_s) − A_s", scale=most),
        calc("@square", "Under the root of x", "", "Nm⁴", "=@half^2+@grow*@left", square, "b_s² + C_s c_s",
             scale=most**2),
        calc("@root", "Its root", "", "Nm²", "=SQRT(MAX(0,@square))", math.sqrt(max(0.0, square)), scale=most),
        calc("@smean0", "Mean output torque of the reducer, without inertia", "", "Nm", f"={cubic('S0')}",
             points.cubic_mean(view.load.output_torque_at_rest), scale=view.scales.behind),
        constant("@least_use", "A share that grows less than this is none", "", "", LEAST_USE,
                 "a rate beyond 30,000 times the present one", format="0E+00"),
    ]  # fmt: skip


def rates_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the means that the rates depend on, the estimated rates of each limit, and those between two rates."""
    sheet.heading("Workings: the rates", ABOUT)
    sheet.rows(*means(view))
    estimates_table(sheet, view)
    sheet.heading("Workings: the rate that is tried", TRIED)
    sheet.rows(*tried(view))
    between_table(sheet, view)
    sheet.rows(*ends(view))


ESTIMATES = (
    ("forward", "share that grows with the square of the rate", "1/x", "forward"),
    ("backward", "the same, torques backward", "1/x", "backward"),
    ("from", "held from the square of the rate's factor on", "x", "from_forward"),
    ("from_back", "the same, torques backward", "x", "from_backward"),
)


def estimates_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of the estimated rates of each limit."""
    names, search = names_of(view), view.search
    estimates = [search.estimates.get(name, search.estimates[PEAK_TORQUE]._replace(**LEVEL)) for name in names]
    estimated = [search.estimated.get(name, Ends(0.0, math.inf)) for name in names]
    limits, stands, *shares = zip(*((LIMITS | {BELOW: FALLING})[name] for name in names), strict=True)

    def in_units(values: Iterable[float]) -> list[float]:
        each = [0.0 if math.isinf(value) else value for value in values]
        return [shown(value, RPM) if name in SPEEDS else value for name, value in zip(names, each, strict=True)]

    up_to = f'=IF([most]<=@least_use,"{NOT_REACHED}",@rate/SQRT([most]))'
    cycles = (f'=IF(AND([most]<=@least_use,[stands]<[cap]),"{NOT_REACHED}",'
              'MAX(@full/60,IF([stands]<[cap],@rate/SQRT([most]+tiny),0)))')  # fmt: skip
    since = f'=IF(MAX([from],[from_back])*@least_use>=1,"{NEVER_HELD}",@rate*SQRT(MAX([from],[from_back])))'
    sheet.row += 1
    sheet.table(
        "@held", "Estimate: from and up to which rate each limit is held", len(names),
        constant("name", "limit", "", "", names, align="left"),
        calc("limit", "limit", "", "Nm or rpm", [f"={cell}+0" for cell in limits],
             in_units(one.limit for one in estimates), "0: none"),
        calc("cap", "as it counts", "", "", "=IF([limit]=0,1/tiny,[limit])",
             [limit or NO_LIMIT for limit in in_units(one.limit for one in estimates)], "1E30: none", format="0.0E+00"),
        calc("stands", "at no speed", "", "", [f"={cell}" for cell in stands],
             in_units(one.standing for one in estimates), scale=view.scales.torque),
        *(calc(name, label, symbol, "", [f"={cell}" for cell in cells],
               [getattr(one, field) for one in estimates], scale=1.0)
          for (name, label, symbol, field), cells in zip(ESTIMATES, shares, strict=True)),
        calc("most", "the larger share", "", "", "=MAX([forward],[backward])",
             [max(one.forward, one.backward) for one in estimates], scale=1.0),
        calc("rate", "met up to", "N", "cycles/min", [cycles if name == CYCLES else up_to for name in names],
             [met(one.high) for one in estimated], align="right", source="N/√(share)"),
        calc("low", "met from", "N", "cycles/min", ["=0+0" if name == CYCLES else since for name in names],
             [met(one.low, NEVER_HELD) for one in estimated], align="right", scale=view.rate),
    )  # fmt: skip


LEVEL = {"limit": math.inf, "forward": 0.0, "backward": 0.0, "from_forward": 0.0, "from_backward": 0.0}


def met(rate: float, none: str = NOT_REACHED) -> float | str:
    """Return a rate (1/s) in cycles/min, or the word for none."""
    return none if math.isinf(rate) else shown(rate, PER_MINUTE)


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
        calc("@x_from", "Squares of rates between which is interpolated: from", "x", "",
             "=IF(@holds=1,1,IF(@holds_tried=1,@times^2,0))", search.way[0] ** 2, "one that holds, or 0"),
        calc("@x_to", "… to", "x", "", "=IF(@holds=1,@times^2,IF(@holds_tried=1,1,@times^2))", search.way[1] ** 2),
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


def between_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of each limit's use at both rates, and of the rates between which it is held."""
    names, search = names_of(view), view.search
    shares = [search.between.get(name, (Shares(0.0),) * 3) for name in names]
    ends = [search.ends.get(name, Ends(0.0, math.inf)) for name in names]
    rows = list(enumerate(names, 1))

    def way(begin: int, sign: int) -> list[str]:
        """Return the formulas of shares from a rate on, of torques forward (0) or backward (1)."""
        uses = (("[now]", "[then]"), ("[then]", "[now]"), ("[@held.stands.{}]/[@held.limit.{}]", "[then]"))[begin]
        found = []
        for row, name in rows:
            if name in MEETS:
                letter = "T" if name == PEAK_TORQUE else "S"
                columns = ((letter, f"{letter}N"), (f"{letter}N", letter), (f"{letter}0", f"{letter}N"))[begin]
                found.append(f"={grown(*columns, '[cap]', not sign)}")
            elif sign:
                found.append("=0+0")
            else:
                low, high = (use.format(row, row) for use in uses)
                limit = f"[@held.limit.{row}]=0"
                found.append(f"=IF({limit},0,({high}-{low})/MAX(tiny,@target-{low}))")
        return found

    caps = [f"=@target*[@held.cap.{row}]/{'@over_T' if name == PEAK_TORQUE else '@over_S'}" if name in MEETS
            else "=@target+0" for row, name in rows]  # fmt: skip

    def high(row: int, name: str) -> str:
        rate = f"[@held.rate.{row}]"
        if name in SPEEDS:
            return f'=IF(@x_to<@x_from,@tried,IF(ISNUMBER({rate}),{rate}*(1-1E-6),"{NOT_REACHED}"))'
        return f'=IF(@x_to<@x_from,@tried,IF(ISNUMBER({rate}),[met],"{NOT_REACHED}"))'

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
        *(calc(name, label, "1/σ", "", way(begin, sign), [share[begin][sign] for share in shares], scale=1.0)
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


def range_results(view: DriveView) -> Sequence[Quantity]:
    """Return the results: the range of rates, the limit at either end, and the range in words."""
    found, rates = view.rates, "[@between.high]"
    none = f'IF(@some=0,"{AT_NO_RATE}"'
    return [
        result("@highest", "Highest rate within all limits", "N_max", "cycles/min",
               f'={none},IF(ISNUMBER(@up_to),@up_to,"{NONE_BINDS}"))', found.high, NOTE, align="right"),
        result("@binds", "limiting factor", "", "",
               f'=IF(@some=0,INDEX([@between.name],@low_row),'
               f'IF(COUNT({rates})=0,"{NONE_BINDS}",INDEX([@between.name],@high_row)))',
               found.high_limit, align="right"),
        result("@lowest", "Lowest rate within all limits", "N_min", "cycles/min", f"={none},@down_to)", found.low,
               "0: standstill", align="right"),
        result("@binds_low", "limiting factor", "", "",
               f'={none},IF(@down_to>0,INDEX([@between.name],@low_row),"{NONE_BINDS}"))', found.low_limit,
               align="right"),
        calc("@mends", "In words", "", "", f"={range_in_words(found, '@').says}",
             Sentence(range_in_words(found, "@").said), align="left"),
    ]  # fmt: skip


def range_in_words(found: Rates, scope: str) -> CheckSentence:
    """Return the sentence on a range of rates that cells with these beginnings of names have."""
    low, high = f"{scope}lowest", f"{scope}highest"
    says = (f'IF(ISNUMBER({high}),"holds from "&ROUND({low}+{RANGE_END},1)&" to "&ROUND({high}-{RANGE_END},1)'
            f'&" cycles/min",IF({high}="{NONE_BINDS}","no limit","holds "&{high}))')  # fmt: skip
    if isinstance(found.high, str) or isinstance(found.low, str):
        return CheckSentence(says, "no limit" if found.high == NONE_BINDS else f"holds {found.high}")
    ends = (round(end, 1) + 0.0 for end in (found.low + RANGE_END, found.high - RANGE_END))
    return CheckSentence(says, "holds from {:.15g} to {:.15g} cycles/min".format(*ends))
