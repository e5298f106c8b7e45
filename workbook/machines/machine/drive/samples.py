"""The charts of a drive, and the drive at the samples of the cycle, for them and for the sheet Power."""

from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet, calc, constant, result
from workbook.drive.motor import plane
from workbook.entries.units import KW, RPM, shown
from workbook.machines.machine.drive.view import DriveView

ABOUT = "Between two points the torque is that of a straight line, right to about 1 %; at the points it is as above."


def samples_table(sheet: Sheet, view: DriveView) -> None:
    """Declare torque and power of the motor at the samples of the cycle."""
    i, size, (torque, power) = view.driven.number, view.scales, view.sampled
    at = f"[cycle{i}.p.same]"
    speed = "[n]*PI()/30000" if view.varies else f"@i*@faster*[cycle{i}.v.same]/1000"
    here, there = "INDEX(@at,[at])", "INDEX(@at,[at]+1)"
    sheet.heading("Table over the cycle", ABOUT)
    sheet.table(
        "@cycle", "The drive over the cycle", len(torque),
        result("torque", "torque of the motor", "T", "Nm", line("T"), torque, scale=size.torque),
        result("power", "power of the motor", "P", "kW", f"=[torque]*({speed}+@copper*[torque])",
               shown(power, KW), scale=size.power, source="T ω + P_Cu (T/T_N)²"),
        *([] if view.driven.linkage is None else [
            calc("phi", "angle of the shaft", "φ", "rad", line("phi"),
                 view.between.of(view.driven.linkage.shaft(view.load.position).angle), scale=1.0),
            calc("n", "speed of the motor", "n", "rpm", line("n"), shown(view.between.of(view.points.speed), RPM),
                 scale=size.rpm),
        ]),
        constant("k", "sample", "k", "", list(range(len(torque)))),
        calc("at", "point before it", "", "", f"=MATCH(MIN({at}+eps,360-eps),@at,1)",
             view.between.point + 1.0, format="0"),
        calc("s", "share of the way to the next", "", "", f"=({at}-{here})/({there}-{here})", view.between.share,
             scale=1.0),
    )  # fmt: skip


def line(column: str) -> str:
    """Return the formula of a quantity between two points."""
    return f"=INDEX(@{column},[at])*(1-[s])+INDEX(@{column},[at]+1)*[s]"


CHART_COLUMN = 10


def charts(sheet: Sheet, view: DriveView) -> None:
    """Place the charts: torque against speed, torque over the cycle, and the angle of a shaft whose ratio changes."""
    sheet.chart(plane("[@pt.n]", "[@pt.T]"), column=CHART_COLUMN, row=5, width=8, height=22)
    over, places = view.one.machine.over, {"column": CHART_COLUMN, "width": 8, "height": 11}
    drawn = [("Torque of the motor", "T [Nm]", "torque", "torque", " over the cycle", 28)]
    drawn += [("Angle of the mechanism's shaft", "φ [rad]", "angle", "phi", "", 40)] if view.varies else []
    for what, y, name, column, cycle, row in drawn:
        line = Series(name, f"[cycle{view.driven.number}.{over.column}]", f"[@cycle.{column}]")
        about = f"{what} over {over.cycle}"
        sheet.chart(Chart(f"{what}{cycle}", over.title, y, (line,), about, over.axis(60)), row=row, **places)
