"""Charts of the flying cutter over its cycle."""

from __future__ import annotations

from workbook.declare import Chart, Series, Sheet

TIME = "time t [s]"


def over_time(title: str, y: str, about: str, *lines: tuple[str, str, bool]) -> Chart:
    """Return a chart of columns of the cycle's table over time; each line has a name, a column, and may be dashed."""
    series = tuple(Series(name, "[cycle.t]", f"[cycle.{column}]", dashed=dashed) for name, column, dashed in lines)
    return Chart(title, TIME, y, series, about)


def beside(sheet: Sheet) -> None:
    """Place speed, position and acceleration of the tool beside what is entered and what comes out."""
    for row, chart in (
        (5, over_time("Speed of the tool over a cycle", "speed [m/s]", "Speed of the tool over one cycle, with the line speed that it works at", ("tool", "v", False), ("line", "line", True))),
        (24, over_time("Position of the tool and of the product", "position [mm]", "Position of the tool along its path over one cycle, with the product's", ("tool", "s", False), ("product", "product", True))),
        (43, over_time("Acceleration of the tool over a cycle", "acceleration [m/s²]", "Acceleration of the tool over one cycle", ("tool", "a", False))),
    ):  # fmt: skip
        sheet.chart(chart, column=11, row=row, width=8, height=18)


def drive_charts(sheet: Sheet) -> None:
    """Place speed, torque and torque against speed at the tool's shaft side by side."""
    sheet.chart_row(
        over_time("Speed of the shaft", "n [rpm]", "Speed of the tool's shaft over one cycle", ("shaft", "n", False)),
        over_time("Generalized load torque", "T*_L [Nm]", "Load torque and inertia torque at the tool's shaft over one cycle", ("T*_L = T_L + J_L ω̇_L", "torque", False)),
        Chart("Torque against speed", "n [rpm]", "T*_L [Nm]", (Series("one cycle", "[cycle.n]", "[cycle.torque]"),),
              "Generalized load torque against the speed of the tool's shaft over one cycle"),
        width=7, height=18,
    )  # fmt: skip
