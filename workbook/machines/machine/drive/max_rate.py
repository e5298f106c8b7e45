"""The highest rate of a drive in cells, at which its limiting factor is reached.

With T_s the torque at standstill and I = T − T_s, a rate of √x times the present one takes T_s + x I.
"""

import math
from collections.abc import Iterable, Sequence

from engine.drive.limit_use import LEAST_USE, by_cycles, continuous_line, mean_squares
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.book.sentence import CheckSentence, Sentence, bound
from workbook.fields.units import RPM, shown
from workbook.machines.machine.drive.view import NONE_BINDS, DriveView

NO_LIMIT = "–"
NOTE = "exact at the rate that is entered; elsewhere to about 1 %"
ABOUT = (
    "At rest a torque T_s stands; I = T − T_s grows with the square of the rate. At √x times it the "
    "torque is T_s + x I; of each limit, 1/x is the share that grows so and is used. T_rms is at its limit where "
    "A_s + 2 B_s x + C_s x² = (M − ΔM √x)², with √x ≤ (x_s + x/x_s)/2."
)
SPEEDS = ("motor speed", "reducer input speed")


def grown(torque: str, limit: str, *more: str) -> str:
    """Return the formula of the largest share of a limit of torque, or of ``more``: |I| over what T_s leaves of it."""
    now, none = f"[@pt.{torque}]", f"[@pt.{torque}0]"
    ways = f"({now}-{none})/({limit}-{none})", f"({none}-{now})/({limit}+{none})"
    return f"MAX({','.join((*(f'SUMPRODUCT(MAX({way}))' for way in ways), *more))})"


MOTOR_STANDS = "MAX(MAX([@pt.T0]),0-MIN([@pt.T0]))"
LIMITS = {
    "RMS torque": (
        "@line", "SQRT(@stand)",
        "IF(OR(@speed=0,[stands]>=[limit]),0,"
        "(SQRT(@half^2+@grow*([limit]*([limit]-@sink*@near)-@stand))+@half)/([limit]*([limit]-@sink*@near)-@stand))"),
    "peak torque": ("@motor_peak", MOTOR_STANDS, grown("T", "@motor_peak")),
    "motor speed": ("@motor_nmax", "0", "(@speed/[limit])^2"),
    "reducer input speed": ("@reducer_nmax", "0", "IF([limit]=0,0,(@speed/[limit])^2)"),
    "reducer peak torque": ("@reducer_peak", "MAX(MAX([@pt.S0]),0-MIN([@pt.S0]))",
                                 f"IF([limit]=0,0,{grown('S', '[limit]', '@many')})"),
    "reducer mean torque": ("@reducer_mean", "@smean0",
                                 "IF([limit]<=[stands],0,MAX(0,@smean-[stands])/([limit]-[stands]))"),
    "torque below the curve": ("@corner", MOTOR_STANDS, "MAX(MAX([@pt.uc]),MAX([@pt.ub]))"),
}  # fmt: skip
"""of each limit in cells: the limit itself, what stands at any rate, and the share that grows with its square"""


def means(view: DriveView) -> list[Quantity]:
    """Return the rows of the means that the highest rate depends on, and of the line of the continuous torque."""
    points, size = view.points, view.scales.torque**2
    own, mixed, growing = mean_squares(points)
    stall, fall, near, half = continuous_line(points, view.driven.motor)
    return [
        calc("@stand", "Mean of T_s²", "A_s", "Nm²", "=SUMPRODUCT([@pt.share],[@pt.T0],[@pt.T0])", own, scale=size),
        calc("@mixed", "Mean of T_s I", "B_s", "Nm²", "=SUMPRODUCT([@pt.share],[@pt.T0],[@pt.T]-[@pt.T0])", mixed,
             scale=size),
        calc("@grow", "Mean of I²", "C_s", "Nm²", "=SUMPRODUCT([@pt.share],([@pt.T]-[@pt.T0])^2)", growing, scale=size),
        calc("@line", "Continuous torque at no speed", "M", "Nm",
             "=IF(@continuous>@motor_rated,@motor_stall,@motor_rated)", stall, "T_N beyond n_N"),
        calc("@sink", "Its fall to that at the mean speed", "ΔM", "Nm", "=@line-@continuous", fall, scale=stall),
        calc("@near", "Rate at which T_s alone is as large", "x_s", "",
             "=IF(@sink>0,MIN(1,(@line-SQRT(@stand))/@sink),1)", near, "over the present one, at most 1"),
        calc("@half", "What grows with x, and half the fall", "b_s", "Nm²",
             "=@mixed+IF(@near>0,@sink*(@line/@near-@sink)/2,0)", half, "B_s + ΔM (M/x_s − ΔM)/2",
             scale=size + stall**2),
        calc("@smean0", "Mean output torque of the reducer, without inertia", "", "Nm", f"={cubic('S0')}",
             points.cubic_mean(view.load.output_torque_at_rest), scale=view.scales.behind),
        *many_cycles(view),
        constant("@least_use", "A share that grows less than this is none", "", "", LEAST_USE,
                 "a rate beyond 30,000 times the present one", format="0E+00"),
    ]  # fmt: skip


def rates_table(sheet: Sheet, view: DriveView) -> None:
    """Declare the means that the highest rate depends on, and the rate up to which each limit is held."""
    sheet.heading("Workings: the highest rate", ABOUT)
    sheet.rows(*means(view))
    each = list(LIMITS) if view.knows_falling else list(LIMITS)[:-1]
    limits, stands, uses = zip(*(LIMITS[name] for name in each), strict=True)
    level = view.shares["peak torque"]._replace(limit=0.0, use=0.0)
    found = [view.shares.get(name, level) for name in each]  # of a curve that does not fall none is used
    met = [one.highest(view.rate) if one.limit else math.inf for one in found]

    def in_units(values: Iterable[float]) -> list[float]:
        return [shown(value, RPM) if name in SPEEDS else value for name, value in zip(each, values, strict=True)]

    sheet.row += 1
    sheet.table(
        "@held", "Up to which rate each limit is held", len(each),
        constant("name", "limit", "", "", each, align="left"),
        calc("limit", "limit", "", "Nm or rpm", [f"={cell}+0" for cell in limits],
             in_units(0.0 if math.isinf(one.limit) else one.limit for one in found), "0: none"),
        calc("stands", "at no speed", "", "", [f"={cell}" for cell in stands],
             in_units(one.standing for one in found), scale=view.scales.torque),
        calc("use", "share that grows with the square of the rate", "1/x", "", [f"={cell}" for cell in uses],
             [one.use for one in found], scale=1.0),
        calc("rate", "met up to", "N", "cycles/min",
             f'=IF([limit]=0,"{NO_LIMIT}",IF([stands]>=[limit],0,'
             f'IF([use]<=@least_use,"{NO_LIMIT}",@rate/SQRT([use]))))',
             [NO_LIMIT if math.isinf(rate) else rate for rate in met], align="right", source="N/√(share)"),
    )  # fmt: skip


def many_cycles(view: DriveView) -> list[Quantity]:
    """Return the rows of the reducer's torque beyond the cycles that it holds in full for."""
    reducer, stands = view.driven.reducer, LIMITS["reducer peak torque"][1]
    over, way, many = by_cycles(view.points, reducer.limits, 1.0 / view.time)
    least = reducer.peak_torque / reducer.cycle_factor
    return [
        calc("@t_f", "Reducer's largest torque beyond its cycles", "T_f", "Nm", "=@reducer_peak/@reducer_fs", least,
             "T_2B/f_s; 0: no limit"),
        calc("@t_f_use", "Share of it that grows with the square of the rate", "", "",
             f"=IF(@t_f=0,0,{grown('S', '@t_f')})", over, scale=1.0),
        calc("@way", "Square of the cycles over those it holds in full for", "", "", "=(@cycles/@full)^2", way),
        calc("@many", "Share of the reducer's torque by its cycles", "", "",
             f"=IF(AND(@t_f>0,{stands}>=@t_f),@way,MIN(@way,@t_f_use))", many, "up to these cycles T_2B holds in full",
             scale=1.0),
    ]  # fmt: skip


def cubic(column: str) -> str:
    """Return the formula of the cubic mean of a torque behind the reducer, weighted by |n|, which is (n²)^½."""
    return f"IF(@mean>0,(SUMPRODUCT([@pt.share],([@pt.n]^2)^0.5,([@pt.{column}]^2)^1.5)/@mean)^(1/3),0)"


def highest(view: DriveView) -> Sequence[Quantity]:
    """Return the results: the highest rate, and the limiting factor."""
    most, name = view.highest
    rates = "[@held.rate]"
    return [
        result("@highest", "Highest rate within all limits", "N_max", "cycles/min",
               f'=IF(COUNT({rates})=0,"{NONE_BINDS}",MIN({rates}))', most, NOTE, align="right"),
        result("@binds", "limiting factor", "", "",
               f'=IF(COUNT({rates})=0,"{NONE_BINDS}",INDEX([@held.name],MATCH(MIN({rates}),{rates},0)))', name,
               align="right"),
        calc("@mends", "In words", "", "", f'=IF(COUNT(@highest)=0,"no limit",{mends(view).says})',
             Sentence(mends(view).said if isinstance(most, float) else "no limit"), align="left"),
    ]  # fmt: skip


def mends(view: DriveView) -> CheckSentence:
    """Return the sentence on the rate up to which the drive holds all limits."""
    most = view.highest.rate
    return bound("@highest", most if isinstance(most, float) else 0.0, "the drive holds all up to ", " cycles/min")
