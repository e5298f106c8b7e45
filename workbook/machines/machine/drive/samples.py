"""The charts of a drive, and the drive at the samples of the cycle, for them and for the sheet Power."""

from workbook.book.chart import Chart, Series
from workbook.book.declare import Quantity, Sheet, calc, constant, result
from workbook.drive.motor import plane
from workbook.entries.units import KW, RPM, shown
from workbook.machines.machine.drive.view import DriveView

ABOUT = "Between two points the torque is that of a straight line, right to about 1 %; at the points it is as above."


def samples_table(sheet: Sheet, view: DriveView) -> None:
    """Declare torque and power of the motor at the samples of the cycle."""
    i, size, (torque, power) = view.driven.number, view.scales, view.sampled
    at = f"INDEX(cycle{i}_p,[k]+1)"
    speed = "[n]*PI()/30000" if view.varies else f"@i*@faster*INDEX(cycle{i}_v,[k]+1)/1000"
    here, there = "INDEX(@at,[at])", "INDEX(@at,[at]+1)"
    sheet.heading("Table over the cycle", ABOUT)
    sheet.table(
        "@cycle", "The drive over the cycle", len(torque),
        result("torque", "torque of the motor", "T", "Nm", line("T"), torque, scale=size.torque),
        result("power", "power of the motor", "P", "kW", f"=[torque]*{speed}+@copper*[torque]^2",
               shown(power, KW), scale=size.power, source="T ω + P_Cu (T/T_N)²"),
        *shaft(view),
        constant("k", "sample", "k", "", list(range(len(torque)))),
        calc("at", "point before it", "", "", f"=MATCH(MIN({at}+timing_eps,360-timing_eps),@at,1)",
             view.between.point + 1.0, format="0"),
        calc("s", "share of the way to the next", "", "", f"=({at}-{here})/({there}-{here})", view.between.share,
             scale=1.0),
    )  # fmt: skip


def line(column: str) -> str:
    """Return the formula of a quantity between two points."""
    return f"=INDEX(@{column},[at])*(1-[s])+INDEX(@{column},[at]+1)*[s]"


def shaft(view: DriveView) -> list[Quantity]:
    """Return the columns of a ratio that changes: the angle of the mechanism's shaft, and the motor's speed."""
    if view.driven.linkage is None:
        return []
    angle = view.driven.linkage.shaft(view.load.position).angle
    return [
        calc("phi", "angle of the shaft", "φ", "rad", line("phi"), view.between.of(angle), scale=1.0),
        calc("n", "speed of the motor", "n", "rpm", line("n"), shown(view.between.of(view.points.speed), RPM),
             scale=view.scales.rpm),
    ]  # fmt: skip


CHART_COLUMN = 10


def charts(sheet: Sheet, view: DriveView) -> None:
    """Place the charts: torque against speed, torque over the cycle, and the angle of a shaft whose ratio changes."""
    sheet.chart(plane("[@pt.n]", "[@pt.T]"), column=CHART_COLUMN, row=5, width=8, height=22)
    sheet.chart(over_cycle(view), column=CHART_COLUMN, row=28, width=8, height=11)
    if view.varies:
        sheet.chart(angles(view), column=CHART_COLUMN, row=40, width=8, height=11)


def x_of(view: DriveView) -> str:
    """Return the column that charts over the cycle are drawn over."""
    return f"[cycle{view.driven.number}.{view.one.machine.over.column}]"


def over_cycle(view: DriveView) -> Chart:
    """Return the chart of the motor's torque over the cycle."""
    over = view.one.machine.over
    lines = (Series("torque", x_of(view), "[@cycle.torque]"),)
    return Chart("Torque of the motor over the cycle", over.title, "T [Nm]", lines,
                 f"Torque of the motor over {over.cycle}", over.axis(60))  # fmt: skip


def angles(view: DriveView) -> Chart:
    """Return the chart of the mechanism's shaft over the cycle."""
    over = view.one.machine.over
    lines = (Series("angle", x_of(view), "[@cycle.phi]"),)
    return Chart("Angle of the mechanism's shaft", over.title, "φ [rad]", lines,
                 f"Angle of the mechanism's shaft over {over.cycle}", over.axis(60))  # fmt: skip
