"""Charts of the flying cutter over its cycle."""

from __future__ import annotations

from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet

TIME = "time t [s]"


def over_time(title: str, y: str, about: str, *lines: tuple[str, str, bool]) -> Chart:
    """Return a chart of columns of the cycle's table over time; each line has a name, a column, and may be dashed."""
    series = tuple(Series(name, "[cycle.t]", f"[cycle.{column}]", dashed=dashed) for name, column, dashed in lines)
    return Chart(title, TIME, y, series, about)


def beside(sheet: Sheet) -> None:
    """Place the tool's motion, and right of it the load of its shaft, beside what is entered and what comes out."""
    tool = (
        over_time("Speed of the tool over a cycle", "speed [m/s]",
                  "Speed of the tool over one cycle, with the line speed that it works at", ("tool", "v", False),
                  ("line", "line", True)),
        over_time("Position of the tool and of the product", "position [mm]",
                  "Position of the tool along its path over one cycle, with the product's", ("tool", "s", False),
                  ("product", "product", True)),
        over_time("Acceleration of the tool over a cycle", "acceleration [m/s²]",
                  "Acceleration of the tool over one cycle", ("tool", "a", False)),
    )  # fmt: skip
    shaft = (
        over_time("Generalized load torque at the shaft", "T*_L [Nm]",
                  "Load torque and inertia torque at the tool's shaft over one cycle",
                  ("T*_L = T_L + J_L ω̇_L", "torque", False)),
        Chart("Torque against speed of the shaft", "n [rpm]", "T*_L [Nm]", (Series("one cycle", "[cycle.n]",
            "[cycle.torque]"),),
              "Generalized load torque against the speed of the tool's shaft over one cycle"),
        Chart("Load factor against product length", "product length L_p [mm]", "β [W/s]", (
              Series("load factor", "[lengths.length]", "[lengths.beta]"),
              Series("product entered", "[length_line.x]", "[length_line.beta]", dashed=True)),
              "Load factor over the product length at this line speed, with the product entered marked"),
    )  # fmt: skip
    for column, charts in ((11, tool), (18, shaft)):
        for row, chart in zip((5, 24, 43), charts, strict=True):
            sheet.chart(chart, column=column, row=row, width=7, height=18)
