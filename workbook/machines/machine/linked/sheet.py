"""The sheet Drive of an axis whose drive is worked out place by place: of a changing ratio, or viscous friction."""

from __future__ import annotations

import numpy as np

from engine.laws.base import Array
from engine.machine.places import SUFFICES, Worked
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Quantity, Sheet, calc, check, constant, result
from workbook.book.rows import total
from workbook.drive.motor import plane, rms_point
from workbook.entries.abscissa import Abscissa
from workbook.entries.units import RPM, shown
from workbook.machines.machine import chosen, curved, drive
from workbook.machines.machine.breaks import breaks_table, turns_table, windows_check
from workbook.machines.machine.chain import UNSIZED
from workbook.machines.machine.cycle import CYCLES
from workbook.machines.machine.linked import cut, found, kinds, pacing, reach
from workbook.machines.machine.linked.changing import LinkedWork
from workbook.machines.machine.linked.places import stacked, turned
from workbook.machines.machine.linked.worked import LINE, PlacedWork
from workbook.machines.machine.pacing import highest, mending
from workbook.machines.machine.powered import power_peaks
from workbook.machines.machine.selecting import behind

CHANGING = {"jtot": "=(@j0-@jm+@j1/@i1^2+@m/(@i1*MAX([@sec.topg]))^2)*10000"}
"""of a ratio that changes: the largest inertia"""
RESULTS = {
    "jtot": drive.STRAIGHT["jtot"],
    "tmax": "=MAX([@sec.topT])",
    "tmin": "=0-MAX([@sec.topD])",
    "rms": f"=SQRT(MAX(0,{total('@sec.square')}/(2*PI())))",
    "speed": "=@i1*MAX([@sec.topw])*60/(2*PI())",
    "mean": f"=@i1*{total('@sec.way')}/(2*PI())*60/(2*PI())",
    "smax": "=MAX([@sec.topS])",
    "smean": f"=IF({total('@sec.way')}>0,({total('@sec.cube')}/{total('@sec.way')})^(1/3),0)",
    "energy": "=SUMPRODUCT(([@sec.work]>0)*[@sec.work])",
    "returned": "=0-SUMPRODUCT(([@sec.work]<0)*[@sec.work])",
}
PEAKS = "@i1*MAX([@sec.topP])/1000", "0-@i1*MAX([@sec.topQ])/1000"
"""highest and lowest power"""
TITLES = (
    "Speed and torque of the motor over the cycle",
    "Angle of the mechanism's shaft, speed and torque of the motor over the cycle",
)


def placed_sheet(book: Book, view: PlacedWork) -> None:
    """Declare the sheet."""
    one, driven = view.one, view.driven
    i, line = driven.number, line_of(view)
    sheet = drive.begun(book, driven)
    with sheet.scoped(f"drive{i}_"):
        drive.entries(sheet, driven, kinds.of(driven).entries(driven, f"axes.{i - 1}"))
        results = *curved.spare(view, line), *power_peaks(view, PEAKS), *highest(view, pacing.BELOW, pacing.NEAR)
        drive.outcome(sheet, one, driven, RESULTS | (CHANGING if view.varies else {}), results)
        sheet.checks(
            *drive.checks(driven, mending(view)),
            curved.curve_check(view, line, mending(view)),
            drive.laws_check(driven, one),
            *windows_check(view),
            *checks(view),
        )
        sheet.chart(plane("@cycle", "T"), column=drive.CHART_COLUMN, row=5, width=8, height=22)
        if view.varies:
            sheet.chart(
                angles(one.axis.number, one.machine.over), column=drive.CHART_COLUMN, row=28, width=8, height=18
            )
        kinds.of(driven).entered(sheet, driven, one.machine.machine.sizes.positions)
        drive.tables(sheet, view)
        sheet.not_printed_below()
        sheet.heading("Motor and reducer in use")
        sheet.rows(*chosen.in_use(driven.motor_used, driven.reducer, driven.left))
        drive.workings(sheet, one, driven, [
            calc("@omega", f"{one.machine.over.speed} at its rate", "ω", "rad/s", "=timing_omega*@faster",
                 driven.axis.speed),
            *kinds.of(driven).sizes(driven),
            *curved.curve_rows(view, line),
        ])  # fmt: skip
        kinds.of(driven).table(sheet, driven, one.machine.machine.sizes.positions)
        cycle(sheet, view)
        if isinstance(view, LinkedWork):
            reach.reach_table(sheet, view)
        turns_table(sheet, view)
        kinds.of(driven).passing(sheet, view)
        breaks_table(sheet, view)
        cut.stretches_table(sheet, view)
        cut.looks_table(sheet, view)
        sheet.rows(*cut.lost_rows(view))
        cut.turns_table(sheet, view)
        cut.rule_table(sheet)
        cut.cuts_table(sheet, view)
        found.sections_table(sheet, view, *pacing.pace_columns(view))
        cut.nodes_table(sheet, view, *behind.node_columns(view))
        sheet.rows(*found.lost_rows(view), *pacing.loss_rows(view.pacing))
        pacing.pace_tables(sheet, view)
        behind.means(sheet, view)
        curved.corners_table(sheet, view, drive.BACKWARD)
        rms_point(sheet, driven.demand.mean_speed, driven.demand.rms_torque)
    sheet.print_columns = 18


def line_of(view: PlacedWork) -> curved.Line:
    """Return the formulas of what the line of a falling curve must be at no speed, by the sections."""
    return curved.Line(f"MAX([@sec.top{LINE}])", "@i1*60/(2*PI())", view.pacing.sink, curved.EXACT)


def checks(view: PlacedWork) -> list[Quantity]:
    """Return the checks of the mechanism: its sizes, where it can bring its load to, and the sheet's own places."""
    driven, i = view.driven, view.driven.number
    enough = (
        f"MAX([@sec.rest])<={SUFFICES!r}*MAX(MAX([@pl.T]),0-MIN([@pl.T])),MAX([@st.e])>=360,MAX([@sec.e])>=360,"
        "MAX([@look.nF])+MAX([@look.nS])+MAX([@look.nT])<=MAX([@turn.k])"
    )
    places = check("@ok_nodes", f"{driven.called}: the sheet has places enough", f"AND({enough})", True,
                   "extremes, RMS torque and energy are exact", f":nodes{i}", f'"{view.too_few}"')  # fmt: skip
    if not isinstance(view, LinkedWork):
        return [places]
    return [
        check("@ok_sized", f"{driven.called}: the mechanism has its sizes", kinds.of(driven).SIZED, True,
              rule=f"axes.{i - 1}.mechanism:sized", says=f'"{UNSIZED}"'),
        *kinds.checks(view.linked),
        reach.reach_check(view),
        places,
        reach.back_check(view),
    ]  # fmt: skip


def cycle(sheet: Sheet, view: PlacedWork) -> None:
    """Declare speed and torque over the cycle, for the charts; of a ratio that changes, the angle of its shaft too."""
    i, driven, samples = view.driven.number, view.driven, stacked(view.samples)
    within = np.array([view.helds[number - 1].within for number in view.sampled])
    told = view.driven.axis.told(view.one.machine.samples)
    near = f"MIN(INDEX([cycle{i}.p],[k]+1)+timing_eps,360-timing_eps)"
    v, a = (f"({power}*INDEX([cycle{i}.{name}],[k]+1))" for power, name in (("@faster", "v"), ("@faster^2", "a")))
    angle, place = cycled(view, samples, within) if view.varies else ([], [])
    sheet.heading("Table over the cycle")
    sheet.table(
        "@cycle", TITLES[view.varies], len(told.x),
        result("rpm", "motor speed", "n", "rpm", "=@i1*[w]*60/(2*PI())",
               shown(driven.mechanism.turning(0, samples.rate if view.varies else samples.v), RPM), source="i_1 φ' ẏ"),
        result("torque", "motor torque", "T", "Nm", "=[T]+0", samples.torque, scale=driven.sizes.torque),
        *angle,
        constant("k", "sample", "k", "", list(range(len(told.x)))),
        calc("st", "stretch", "", "", f"=MATCH({near},[@st.b],1)", view.sampled, format="0"),
        *place,
        *turned(view, samples, (v, a), within),
    )  # fmt: skip


def cycled(view: PlacedWork, samples: Worked, within: Array) -> tuple[list[Quantity], list[Quantity]]:
    """Return the columns of the angle of the mechanism's shaft at samples, and of the load's position."""
    i, driven = view.driven.number, view.driven
    begun = CYCLES.format(f"INDEX([cycle{i}.theta],[k]+1)", i, f"INDEX([cycle{i}.p],[k]+1)")
    y = f"INDEX([cycle{i}.y],[k]+1)-{begun}*[axes.travel.{i}]"
    return [kinds.of(driven).angle(driven, samples.y, within)], [
        calc("p", "position", "y", view.base, f"=({y})/1000" if driven.travels else f"=RADIANS({y})", samples.y,
             scale=driven.axis.motion.size(0)),
    ]  # fmt: skip


def angles(number: int, over: Abscissa) -> Chart:
    """Return the chart of the mechanism's shaft over the cycle."""
    lines = (Series("angle", f"[cycle{number}.{over.column}]", "[@cycle.phi]"),)
    return Chart(
        "Angle of the mechanism's shaft", over.title, "φ [rad]", lines,
        f"Angle of the mechanism's shaft over {over.cycle}", over.axis(60),
    )  # fmt: skip
