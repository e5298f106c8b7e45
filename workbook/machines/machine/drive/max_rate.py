"""The rates at which a drive holds its limits, in cells: estimated, tried near the upper end, between both, creeping.

With T_s the torque at standstill and I = T − T_s, a rate of √x times the present one takes T_s + x I.
"""

import math
from collections.abc import Iterable, Sequence

from engine.drive import rate_estimates
from engine.drive.limits import CREEP_RATE, CYCLES, PEAK_TORQUE, REDUCER_TORQUE
from workbook.book.cell_tables import cell_tables, formulas_by_row
from workbook.book.declare import Quantity, Sheet
from workbook.book.sentence import CheckSentence, Sentence, amount, around
from workbook.drive.motor import continuous_at
from workbook.fields.units import DEGREE, PER_MINUTE, PERCENT, RPM, shown
from workbook.machines.machine.drive.view import AT_NO_RATE, NONE_BINDS, DriveView, Rates

CELLS = cell_tables(__file__)

RMS_TORQUE = "RMS torque"  # the limit
NOT_REACHED, NEVER_HELD = "–", "never"
ABOUT = (
    "At rest a torque T_s stands; I = T − T_s grows with the square of the rate. At √x times it the "
    "torque is T_s + x I; of each limit, 1/x is the share that grows so and is used. T_rms is at its limit where "
    "A_s + 2 B_s x + C_s x² = (M − ΔM √x)², with √x ≤ (x_s + x/x_s)/2."
)
MEETS = (PEAK_TORQUE, REDUCER_TORQUE, CYCLES)  # of torques at points
RATE_LOOK = "0.0##;-0.0##;0"
"""the format of an end of a range: from standstill on it is 0"""
RANGE_END = 0.0499
"""what is added to the low end of a range, before it is rounded: a whole amount such as 200 lies at no edge"""


def grown(begin: str, end: str, limit: str, forward: bool) -> str:
    """Return the formula of the largest share 1/x of a limit by torques that grow from a column to another."""
    begin, end = f"[@pt.{begin}]", f"[@pt.{end}]"
    more, less, left = (end, begin, f"{limit}-{begin}") if forward else (begin, end, f"{limit}+{begin}")
    grows = f"({more}-{less}>@least_use*{limit})*({more}-{less})"
    return f"MIN(1/@least_use,SUMPRODUCT(MAX({grows}/(({left}>0)*({left})+tiny))))"


def shrunk(begin: str, end: str, limit: str, forward: bool) -> str:
    """Return the formula of the x from which torques that shrink hold a limit."""
    begin, end = f"[@pt.{begin}]", f"[@pt.{end}]"
    more, less, over = (begin, end, f"{begin}-{limit}") if forward else (end, begin, f"0-{begin}-{limit}")
    shrinks = f"({more}-{less}>@least_use*{limit})*({more}-{less})"
    return f"MIN(1/@least_use,MAX(0,SUMPRODUCT(MAX(({over})/({shrinks}+tiny)))))"


def largest(column: str) -> str:
    """Return the formula of the largest size of a column of points."""
    return f"MAX(MAX([@pt.{column}]),0-MIN([@pt.{column}]))"


def cubic(torque: str) -> str:
    """Return the formula of the cubic mean of a torque behind the reducer, weighted by |n|, which is (n²)^½."""
    return f"IF(@mean>0,(SUMPRODUCT([@pt.share],([@pt.n]^2)^0.5,({torque}^2)^1.5)/@mean)^(1/3),0)"


def names_of(view: DriveView) -> list[str]:
    """Return the names of the limits in the order of their rows."""
    return LIMITS["name"] if view.knows_falling else LIMITS["name"][:-1]


def by_square(half: str, growing: str, left: str, square: str, root: str) -> tuple[str, str]:
    """Return the formulas of the share up to which a mean torque is held, and of the x from which it is."""
    never = f"OR({half}>=0,{square}<0)"
    return (
        f"IF({left}>0,({root}+{half})/{left},IF({never},0,{growing}/({root}-{half})))",
        f"IF({left}>0,0,IF({never},1/@least_use,MIN(1/@least_use,(0-{left})/({root}-{half}))))",
    )


def held_by_points(letter: str) -> dict[str, str]:
    """Return the formulas of a limit of torques at points, by the letter of their column: see the table of limits."""
    names = ("up", "up_back", "from", "from_back")
    ways = [of(f"{letter}0", letter, "[cap]", way) for of in (grown, shrunk) for way in (True, False)]
    return {letter: largest(f"{letter}0")} | {f"{letter}_{name}": way for name, way in zip(names, ways, strict=True)}


RMS = by_square("@half", "@grow", "@left", "@square", "@root")
MEAN = by_square("@half_s", "@grow_s", "@left_s", "@square_s", "@root_s")
MEANS = dict(zip(("rms", "rms_from", "mean", "mean_from"), (*RMS, *MEAN), strict=True))
LIMITS = formulas_by_row(__file__, "limits", **MEANS, **held_by_points("T"), **held_by_points("S"))


def means(view: DriveView) -> list[Quantity]:
    """Return the rows of the means that the rates depend on, and of the line of the continuous torque."""
    cell = CELLS["means"].sharing(**view.parts)
    points, size = view.points, view.scales.torque**2
    own, mixed, growing = rate_estimates.mean_squares(points)
    (stall, _, _, half, left, square), fall, near = rate_estimates.continuous_line(points, view.driven.motor)
    most = size + stall**2
    speed = "[@pt.vs]" if view.slides else "[@pt.v]"
    behind = view.driven.reducer.mean_torque
    behind = 0.0 if math.isinf(behind) else behind
    mean, most_behind = rate_estimates.mean_torque_line(points, behind), view.scales.behind**2 + behind**2
    return [
        cell("@stand", own, scale=size),
        cell("@mixed", mixed, scale=size),
        cell("@grow", growing, scale=size),
        cell("@line", stall),
        cell("@sink", fall, scale=stall),
        cell("@near", near),
        cell("@half", half, scale=most),
        cell("@left", left, scale=most),
        cell("@square", square, scale=most**2),
        cell("@root", math.sqrt(max(0.0, square)), scale=most),
        cell("@smean0", mean.standing, cubic=cubic("[@pt.S0]")),
        cell("@grow_s", mean.growing, cubic=cubic("([@pt.S]-[@pt.S0])"), scale=most_behind),
        cell("@half_s", mean.half, scale=most_behind),
        cell("@left_s", mean.left, scale=most_behind),
        cell("@square_s", mean.square, scale=most_behind**2),
        cell("@root_s", math.sqrt(max(0.0, mean.square)), scale=most_behind),
        cell("@least_use", rate_estimates.LEAST_USE),
        *([cell("@growth", rate_estimates.growth_power(view.search.points), speed=speed)] if view.is_viscous else []),
    ]


SHARES = {"forward": "forward", "backward": "backward", "from": "from_forward", "from_back": "from_backward"}
"""the fields of an estimate, by their columns"""
LEVEL = {"limit": math.inf} | dict.fromkeys(SHARES.values(), 0.0)


def estimates_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of the estimated rates of each limit."""
    names, search = names_of(view), view.search
    estimates = [search.estimates.get(name, search.estimates[PEAK_TORQUE]._replace(**LEVEL)) for name in names]
    estimated = [search.estimated.get(name, rate_estimates.Ends(0.0, math.inf)) for name in names]
    _, limits, stands, *shares = (column[: len(names)] for column in LIMITS.values())

    def in_units(values: Iterable[float]) -> list[float]:
        each = [0.0 if math.isinf(value) else value for value in values]
        return [
            shown(value, RPM) if name in rate_estimates.SPEEDS else value
            for name, value in zip(names, each, strict=True)
        ]

    limit = in_units(estimate.limit for estimate in estimates)
    root = "{}^(1/@growth)" if view.is_viscous else "SQRT({})"
    speed, torque = (f'IF([most]<=@least_use,"{NOT_REACHED}",@rate/{of.format("[most]")})' for of in ("SQRT({})", root))
    cycles = (
        f'IF(AND([most]<=@least_use,[stands]<[cap]),"{NOT_REACHED}",'
        f"MAX(@full/60,IF([stands]<[cap],@rate/{root.format('([most]+tiny)')},0)))"
    )
    since = f'IF(MAX([from],[from_back])*@least_use>=1,"{NEVER_HELD}",@rate*SQRT(MAX([from],[from_back])))'
    sheet.row += 1
    cell = CELLS["held"].sharing(**view.parts, rate=view.rate)
    cell.place(
        sheet,
        cell("name", names),
        cell("limit", limit, limit_of=limits),
        cell("cap", [each or rate_estimates.NO_LIMIT for each in limit]),
        cell("stands", in_units(estimate.standing for estimate in estimates), standing=stands),
        *(
            cell(name, [getattr(estimate, field) for estimate in estimates], share=cells, scale=1.0)
            for (name, field), cells in zip(SHARES.items(), shares, strict=True)
        ),
        cell("most", [max(estimate.forward, estimate.backward) for estimate in estimates]),
        cell(
            "rate",
            [as_rate(estimate.high) for estimate in estimated],
            up_to=[cycles if name == CYCLES else speed if name in rate_estimates.SPEEDS else torque for name in names],
        ),
        cell(
            "low",
            [as_rate(estimate.low, NEVER_HELD) for estimate in estimated],
            since=["0+0" if name == CYCLES else since for name in names],
        ),
    )


def as_rate(rate: float, none: str = NOT_REACHED) -> float | str:
    """Return a rate (1/s) in cycles/min, or the word for none."""
    return none if math.isinf(rate) else shown(rate, PER_MINUTE)


def range_results(view: DriveView) -> Sequence[Quantity]:
    """Return the results: the range of rates, the limit at either end, and the range in words."""
    cell = CELLS["range_results"]
    found, rates = view.rates, "[@between.high]"
    none = f'IF(@some=0,"{AT_NO_RATE}"'
    return [
        cell("@highest", found.high, none=none, none_binds=NONE_BINDS, format=RATE_LOOK),
        cell("@binds", found.high_limit, rates=rates, none_binds=NONE_BINDS),
        cell("@lowest", found.low, none=none, format=RATE_LOOK),
        cell("@binds_low", found.low_limit, none=none, none_binds=NONE_BINDS),
        cell("@mends", Sentence(range_in_words(found, "@").text), part=range_in_words(found, "@").says),
        *longer_moves(view, range_in_words(found, "@").text),
    ]


def longer_moves(view: DriveView, held: str) -> tuple[Quantity, ...]:
    """Return how long all moves of an axis last about where its drive holds the present rate; with rates in words.

    Moves that last as long as at the highest rate have its peaks. The RMS torque is that of a shorter cycle then; of
    inertia, its square falls with the third power of how long moves last.
    """
    over, high, axis = view.tables.machine.over, view.rates.high, view.driven.axis
    moved = over.shown(shown(math.fsum(phase.duration for phase in axis.phases if phase.lift), DEGREE))
    power = 4.0 / 3.0 if view.rates.high_limit == RMS_TORQUE else 1.0
    needed = max(1.0, view.rate / high) ** power * moved if isinstance(high, float) else 0.0
    decimals, half = (3, 4.9e-4) if over.measured else (0, 0.49)  # rounded up
    least = f"{round(needed + half, decimals):.15g}{over.after}"
    words = f", or with moves of about {least} in all" if 0.0 < needed <= over.length else ""
    cell = CELLS["range_results"].sharing(over=over, half=half, decimals=decimals)
    taken = f"axis{axis.number}_taken"
    turned = over.shown_formula(f"SUMPRODUCT([{taken}.span]*([{taken}.h]<>0))*180/PI()")
    return (
        cell("@moved", moved, turned=turned),
        cell("@needed", needed, rms=RMS_TORQUE, scale=over.length),
        cell("@longer", Sentence(f"{held}{words}"), cycle=over.shown_formula("360")),
    )


def range_in_words(found: Rates, scope: str, holds: str = "holds") -> CheckSentence:
    """Return the sentence on a range of rates that cells with these beginnings of names have; drives ``hold``."""
    low, high = f"{scope}lowest", f"{scope}highest"
    says = (
        f'IF(ISNUMBER({high}),"{holds} from "&ROUND({low}+{RANGE_END},1)&" to "&ROUND({high},3)'
        f'&" cycles/min",IF({high}="{NONE_BINDS}","no limit","{holds} "&{high}))'
    )
    if isinstance(found.high, str) or isinstance(found.low, str):
        return CheckSentence(says, "no limit" if found.high == NONE_BINDS else f"{holds} {found.high}")
    ends = round(found.low + RANGE_END, 1) + 0.0, round(found.high, 3)
    return CheckSentence(says, "{} from {:.15g} to {:.15g} cycles/min".format(holds, *ends))


DECIMALS = 9  # of a use: limits that are used alike are told apart by no rounding
FALLEN = "SUMPRODUCT(MAX(([@pt.TC]^2)^0.5+@fall*(([@pt.n]^2)^0.5*@slow>@knee)*(([@pt.n]^2)^0.5*@slow-@knee)))"


def creeping_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the table of the torques while the drive creeps, and of their limits."""
    cell, checks = CELLS["creep"], view.creep_checks
    asked = FALLEN if view.knows_falling else largest("TC")
    parts = {"peak": asked, "behind": largest("SC"), "mean": cubic("[@pt.SC]")}
    each = formulas_by_row(__file__, "by limit", continuous=continuous_at("(@mean*@slow)"), **parts)
    size = max(view.scales.torque, view.scales.behind)
    CELLS["rate"].begin(sheet)
    sheet.rows(CELLS["rate"]("@creep_rate", shown(CREEP_RATE, PER_MINUTE)), CELLS["rate"]("@slow", view.slow))
    cell.place(
        sheet,
        cell("name", [check.name for check in checks]),
        cell("value", [check.value for check in checks], asked=each["asked"], scale=size),
        cell("limit", [0.0 if math.isinf(check.limit) else check.limit for check in checks], limit_of=each["limit"]),
        cell("use", creep_uses(view), decimals=DECIMALS, scale=1.0),
    )
    sheet.row += 1
    most = creep_uses(view).index(max(creep_uses(view)))
    sheet.rows(CELLS["results"]("@creep_binds", view.creep_checks[most].name))


def creep_uses(view: DriveView) -> list[float]:
    """Return the use of each limit."""
    return [round(check.use, DECIMALS) for check in view.creep_checks]


def creeping_check(view: DriveView) -> Quantity:
    """Return the check that the drive holds its limits while it creeps."""
    most, forces = max(creep_uses(view)), view.tables.machine.given.creep_forces
    worst = view.creep_checks[creep_uses(view).index(most)].name
    says = around("@creep_binds", worst, "", " is ").then(
        amount("100*@creep_use", shown(most, PERCENT), "", " % of its limit, process forces ")
    )
    return CELLS["check"](
        "@ok_creep", most <= 1.0, called=view.driven.called, says=says.then(around("creep_forces", forces, "", ""))
    )
