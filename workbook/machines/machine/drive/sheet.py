"""The sheet of a drive: entries, results, checks, and the table of points from which all results come."""

import math

from engine.drive.bounds import stated_bounds
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, entries_of, result
from workbook.book.sentence import CheckSentence
from workbook.drive.motor import (
    below_curve,
    continuous,
    inertia_check,
    limit_checks,
    limits_table,
    rms_point,
    within_reducer,
)
from workbook.fields.texts import sheet_title
from workbook.fields.units import KG_CM2, KW, PER_RPM, RPM, shown
from workbook.machines.machine.drive import brake, by_angle, in_use, max_rate, rates_between, reducer_load, stages
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.entered import loads, parts_table, windows_check, windows_table
from workbook.machines.machine.drive.mechanisms import LINKAGES, page
from workbook.machines.machine.drive.points import (
    charts,
    cuts_table,
    intervals_table,
    points_table,
    samples_table,
    tops_table,
)
from workbook.machines.machine.drive.reach import linkage_checks, reach_table
from workbook.machines.machine.drive.turns import turns_check, turns_table
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.drive.workings import peaks_table, top, workings
from workbook.machines.machine.file_layout import kind_name
from workbook.machines.machine.mechanism import SCREWS
from workbook.selection.catalogue import FULL_CYCLES

USED = (
    "The figures that this sheet computes with: the catalogue's where a name is entered, else those entered below; "
    "limits over their reserves."
)
MACHINES, OWN = "the machine's rate", "a rate of its own"
END = "INDEX([motors.end],MAX(1,@motor_row))"
LEVEL = (
    "its peak torque falls beyond a speed, and this book knows none that does: give it to the description, and build"
)


def drive_sheet(book: Book, view: DriveView) -> None:
    """Declare the sheet."""
    driven, sizes = view.driven, view.tables.machine.given.sizes
    linkage = LINKAGES.get(driven.given.kind)
    turning = by_angle.ROWS if view.slides else page.ROWS
    entered, sized = linkage[:2] if linkage else turning
    title = sheet_title(driven.called, [sheet.title for sheet in book.sheets])
    sheet = book.sheet(title, f"The drive of axis {driven.number}: what its motion asks of the motor.")
    sheet.called = driven.called
    with sheet.scoped(f"drive{driven.number}_"):
        sheet.heading("Motor and reducer in use", USED)
        sheet.rows(*in_use.in_use(driven.motor_used, driven.reducer, driven.left, driven.limits), *at_rate(view))
        entries(sheet, driven, entered(driven, f"axes.{driven.number - 1}"))
        outcome(sheet, view)
        sheet.checks(*checks(view))
        charts(sheet, view)
        if linkage and linkage.entered:
            linkage.entered(sheet, driven, sizes.positions)
        sheet.heading("Enter: parts and process forces")
        parts_table(sheet, driven, sizes.rotors)
        windows_table(sheet, f"axes.{driven.number - 1}", view)
        sheet.not_printed_below()
        workings(sheet, view, sized(driven))
        if linkage and linkage.worked:
            linkage.worked(sheet, driven, sizes.positions)
        if driven.linkage:
            reach_table(sheet, view, driven.linkage)
        peaks_table(sheet, view)
        rates_between.rates_table(sheet, view)
        if view.for_selection:
            reducer_load.means(sheet, view)
        sheet.heading("Workings: the motor's limits in the chart")
        backward = min(0.0, float(view.cycle.direction.min()))
        corners = driven.motor.corners(backward)
        limits_table(sheet, corners, "MIN([@iv.dir])<0", view.knows_falling)
        rms_point(sheet, view.points.mean_speed, view.points.rms_torque)
        sheet.heading("Workings: the cycle in intervals and points")
        turns_table(sheet, view)
        cuts_table(sheet, view)
        intervals_table(sheet, view)
        points_table(sheet, view)
        tops_table(sheet, view)
        samples_table(sheet, view)
    sheet.print_columns = 18


def entries(sheet: Sheet, driven: Driven, size: list[Quantity]) -> None:
    """Declare what is entered of this mechanism, its load, reducer and motor.

    They are watched by two checks: the sentence of one would be too long for a cell.
    """
    m, key = driven.given, f"axes.{driven.number - 1}"
    cell, own = entries_of(m, f"{key}.mechanism"), entries_of(driven.entered, key)
    none = f"empty: {'2 − 1/η_2, of its friction' if m.kind in SCREWS else 'η_2'}; 0 or less: self-locking"
    sheet.heading("Enter")
    sheet.rows(
        calc("@axis", "Axis", "", "", f"=[axes.name.{driven.number}]", driven.entered.name,
             "the sheet keeps the name that the axis was built with", align="left"),
        constant(kind_name(driven.number, m.kind), "Mechanism", "", "", m.kind, align="left"),
        own("@own_rate", "Rate that it is sized at, if not the machine's", "N", "cycles/min", "rate",
            "empty: the machine's"),
        *size,
        cell("@eta2", "Efficiency of the mechanism", "η_2", "", "efficiency"),
        cell("@eta2_back", "Efficiency where the load drives it", "η_2\'", "", "back_efficiency", none),
        cell("@method", "Losses", "", "", "method", "physical: by the flow of power; document: over η always, as S4"),
        *loads(driven, key),
    )  # fmt: skip
    sheet.rows(*in_use.entries(driven.entered, key))
    if driven.entered.stages:
        sheet.heading("Enter: stages between reducer and mechanism", stages.ABOUT)
        sheet.rows(*stages.entries(driven, key))


UNDAMPED = "; exact without viscous friction"


def to(bound: float, of: str = "") -> str:
    """Return the words for a bound: as a share of the result, or ``of`` another."""
    return f"to {100.0 * bound:g} %{f' of {of}' if of else ''}"


def outcome(sheet: Sheet, view: DriveView) -> None:
    """Declare what the cycle asks of the motor, and the highest rate."""
    driven, points, size = view.driven, view.points, view.scales
    motor, reducer, own = view.reserve, view.reducer_checks, driven.entered.rate
    limits, bound = driven.limits, stated_bounds(driven.train)
    fastest = f"=MAX({top('n')},0-{top('n', 'low')})" if view.varies else "=ABS(@i)*@vmax*@omega*60/(2*PI())"
    sheet.heading("Results")
    sheet.rows(
        calc("@sized", "Sized at", "", "", f'=IF(@own_rate="","{MACHINES}","{OWN}")',
             OWN if own else MACHINES, align="right"),
        calc("@rate", "the rate", "N", "cycles/min", '=IF(@own_rate="",timing_rate,@own_rate)', view.rate),
        result("@jtot", "External inertia at the motor's shaft", "J_ext", "kg cm²",
               f"=(@j0-@jm+{stages.inertia(driven)}/@i1^2)*10000",
               shown(view.inertia, KG_CM2),
               "the largest over the stroke" if view.varies or view.slides else "Σ J/i², load and parts"),
        result("@inertias", "Inertia ratio", "", "", "=IF(@jm>0,@jtot/10000/@jm,0)",
               view.inertia_ratio, "load at the motor's shaft / motor"),
        result("@tmax", "Motor torque, highest", "T_max", "Nm", f"={top('T')}+0", view.top("T"),
               to(bound.peak_torque) + ("" if view.varies or driven.by_angle else UNDAMPED), scale=size.torque),
        result("@tmin", "Motor torque, lowest", "T_min", "Nm", f"={top('T', 'low')}+0", -view.top("T", -1),
               to(bound.peak_torque), scale=size.torque),
        result("@rms", "RMS torque of the motor", "T_rms", "Nm", "=SQRT(SUMPRODUCT([@pt.share],[@pt.T],[@pt.T]))",
               points.rms_torque, f"√(Σ share T²), {to(bound.rms_torque, 'the peak')}", scale=size.torque),
        result("@t_hold", "Holding torque of the motor", "T_h", "Nm",
               "=MAX(SUMPRODUCT(MAX(([@pt.dir]=0)*[@pt.T])),SUMPRODUCT(MAX(([@pt.dir]=0)*(0-[@pt.T]))))",
               points.holding_torque, "the largest at rest, over η at standstill; without no-load torque",
               scale=size.torque),
        result("@speed", "Motor speed, largest", "n_max", "rpm", fastest, shown(view.speed, RPM),
               f"i_1 φ' ẏ, {to(bound.speed)}" if view.varies else "C_v h/t, through the ratio", scale=size.rpm),
        result("@mean", "Motor speed, mean", "n_mean", "rpm", "=SUMPRODUCT([@pt.share],([@pt.n]^2)^0.5)",
               shown(points.mean_speed, RPM), "of |n| over the cycle; with T_rms the RMS point", scale=size.rpm),
        continuous(view.driven.motor, points.mean_speed),
        result("@res_rms", "Reserve of RMS torque", "", "", "=IF(@rms>0,@continuous*@rms_reserve/@rms,0)",
               motor.rms_torque.reserve * limits.rms_reserve, "of the whole continuous torque"),
        result("@res_peak", "Reserve of peak torque", "", "",
               "=IF(MAX(@tmax,0-@tmin)>0,@motor_peak*@peak_reserve/MAX(@tmax,0-@tmin),0)",
               motor.peak_torque.reserve * limits.peak_reserve),
        result("@res_speed", "Reserve of speed", "", "", "=IF(@speed>0,@motor_nmax*@speed_reserve/@speed,0)",
               motor.speed.reserve * limits.speed_reserve),
        *([result("@spare", "Least reserve below the motor's curve", "", "Nm", "=MIN([@pt.left])", view.spare,
                  "at its points", scale=size.torque)] if view.knows_falling else []),
        result("@smax", "Output torque of the reducer, peak", "", "Nm", f"=MAX({top('S')},0-{top('S', 'low')})",
               reducer[0].value, to(bound.peak_torque), scale=size.behind),
        result("@smean", "Output torque of the reducer, mean", "", "Nm", f"={max_rate.cubic('S')}", reducer[1].value,
               "³√(∫|n||T_1|³ dt/∫|n| dt)", scale=size.behind),
        *energies(view),
        *max_rate.range_results(view),
    )  # fmt: skip


def energies(view: DriveView) -> list[Quantity]:
    """Return the results of the motor's energy and power over the cycle."""
    size, (driving, returned), bound = view.scales, view.energy, stated_bounds(view.driven.train)
    return [
        result("@energy", "Energy of the motor, driving", "E", "J",
               "=SUMPRODUCT([@pt.share],[@pt.P],([@pt.P]>0)*1)*60/@rate*1000", driving,
               f"with its copper losses, a cycle; {to(bound.energy, 'both energies')}", scale=size.work),
        result("@returned", "Energy of the motor, regenerated", "", "J",
               "=0-SUMPRODUCT([@pt.share],[@pt.P],([@pt.P]<0)*1)*60/@rate*1000", returned,
               to(bound.energy, "both energies"), scale=size.work),
        result("@power", "Mean power of the motor", "P", "kW", "=(@energy-@returned)*@rate/60/1000",
               shown((driving - returned) / view.driven.drive_cycle.time, KW), to(bound.mean_power, "the peak"),
               scale=size.power),
        result("@pmax", "Motor power, highest", "P_max", "kW", f"=MAX(0,{top('P')})",
               shown(max(0.0, view.top("P")), KW), to(bound.peak_power), scale=size.power),
        result("@pmin", "Motor power, lowest", "P_min", "kW", f"=MIN(0,{top('P', 'low')})",
               shown(min(0.0, -view.top("P", -1)), KW), f"regenerated; {to(bound.peak_power, 'the larger')}",
               scale=size.power),
        *([brake.torque(view)] if view.brakes else []),
    ]  # fmt: skip


def at_rate(view: DriveView) -> list[Quantity]:
    """Return the rows of the reducer's torque at its cycles an hour, and of the motor's curve if the book has any."""
    held, driven, falling = view.reducer_checks[0].limit, view.driven, view.driven.catalogued_falling
    peak, row, motors = driven.motor.peak_torque, driven.motor_used.row, driven.products.motors
    listed = row > 0 and motors[row - 1].end_torque is not None
    rows = [
        calc("@cycles", "Cycles an hour", "", "1/h", "=60*@rate", view.cycles),
        calc("@full", "Reducer: cycles an hour beyond which f_s counts", "", "1/h",
             f"=IF(@reducer_full=0,{FULL_CYCLES:g},@reducer_full)", driven.reducer.full_cycles or FULL_CYCLES),
        calc("@reducer_held", "Reducer: largest output torque at this rate", "", "Nm",
             "=@reducer_peak/IF(@cycles>@full*(1+1E-9),@reducer_fs,1)", 0.0 if math.isinf(held) else held,
             "over f_s beyond these cycles; 0: no limit"),
        calc("@listed", "Motor: a peak torque at its largest speed is given", "", "",
             f"=IF(@motor_row=0,0,COUNT({END}))", int(listed), "1 yes, 0 no", format="0"),
        calc("@drop", "Motor: its peak torque falls to there by", "", "Nm",
             f"=IF(@listed=0,0,MAX(0,@motor_peak-{END}/@peak_reserve))",
             falling.fall * (driven.motor.max_speed * driven.limits.speed_reserve - falling.knee), scale=peak),
    ]  # fmt: skip
    return rows if not view.knows_falling else [
        *rows,
        calc("@knee", "Motor: its peak torque holds up to", "n_1", "rpm",
             "=IF(@motor_row=0,0,INDEX([motors.knee],MAX(1,@motor_row))+0)", shown(falling.knee, RPM),
             "0: up to its largest speed"),
        calc("@fall", "Motor: fall of its peak torque beyond", "f", "Nm/rpm",
             "=IF(@listed=0,0,@drop/(@motor_nmax*@speed_reserve-@knee))", shown(falling.fall, PER_RPM)),
        calc("@corner", "Motor: the falling line at no speed", "", "Nm", "=IF(@fall=0,0,@motor_peak+@fall*@knee)",
             falling.corner(peak) if falling.fall else 0.0, "T_max + f n_1; 0: it does not fall"),
    ]  # fmt: skip


def checks(view: DriveView) -> list[Quantity]:
    """Return the checks of the drive: of its limits with what would mend them, and of what is entered."""
    driven, (torque, mean, speed) = view.driven, view.reducer_checks
    called, reducer = driven.called, driven.reducer
    mends = CheckSentence('"; the drive "&@mends', f"; the drive {max_rate.range_in_words(view.rates, '@').said}")
    level = check("@ok_curve", f"{called}: the motor's peak torque is given up to its largest speed", "@drop=0",
                  not driven.catalogued_falling.fall, says=CheckSentence(f'"{LEVEL}"', LEVEL))  # fmt: skip
    return [
        *limit_checks(view.reserve, called, mends=mends),
        *within_reducer(
            called, ("torque", "@smax", "@reducer_held", torque.ok, torque.value, torque.limit),
            ("mean torque", "@smean", "@reducer_mean", mean.ok, mean.value, reducer.mean_torque),
            ("speed", "@speed", "@reducer_nmax", speed.ok, shown(speed.value, RPM), reducer.max_speed), mends=mends,
        ),
        inertia_check(called, "@inertias", "@inertia_ratio", view.inertia_ratio, driven.limits.inertia_ratio),
        turns_check(view), *([brake.holds(view)] if view.brakes else []),
        *in_use.checks(driven.number, called), *stages.checks(driven), *page.on_bed(driven),
        below_curve(called, driven.motor.falling.fall, view.spare, mends) if view.knows_falling else level,
        *([windows_check(view)] if view.tables.machine.over.measured else ()),
        *(linkage_checks(view) if view.varies else ()), *(by_angle.checks(view) if driven.by_angle else ()),
    ]  # fmt: skip
