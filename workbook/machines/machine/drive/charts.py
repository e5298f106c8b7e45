"""The charts on the sheet of a drive."""

from __future__ import annotations

from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet
from workbook.drive.motor import plane
from workbook.machines.machine.drive.view import DriveView

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
