"""The chart of the sheet Selection: what of their motors the best pairs use, by name."""

from __future__ import annotations

from engine.selection.pair_matrix import Used
from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet, calc
from workbook.selection.choosing import Choosing

NAMED = 6
"""pairs that a chart shows"""


def uses(sheet: Sheet, view: Choosing) -> None:
    """Declare the points of the chart: left of its edge where there is no pair."""
    names = view.named(NAMED)
    sheet.heading("Workings: as drawn in the chart")
    sheet.rows(*(
        calc(f"@name{k}", f"Pair {k}", "", "",
             f'=IF([@order.m.{k}]>0,[@best.motor.{k}]&" + "&[@best.reducer.{k}],"–")', names[k - 1], align="left")
        for k in range(1, NAMED + 1)
    ))  # fmt: skip
    for k in range(1, NAMED + 1):
        row, there = f"INDEX([motors.nmax],MAX(1,[@order.m.{k}]))", f"[@order.m.{k}]>0"
        point(sheet, k, f"=IF({there},[@best.n.{k}]/{row},0-1)",
              f"=IF({there},[@best.share.{k}],0-1)", view.used(k - 1))  # fmt: skip
    point(sheet, 0, "=@own_speed/@held_nmax", "=@own_rms/@held_rated", view.own_use)


def point(sheet: Sheet, k: int, speed: str, torque: str, used: Used) -> None:
    """Declare a point."""
    sheet.table(
        f"@use{k}", f"Pair {k}" if k else "The drive's pair", 1,
        calc("speed", "speed", "", "", speed, [used.speed]),
        calc("torque", "RMS torque", "", "", torque, [used.torque]),
    )  # fmt: skip


def chart(sheet: Sheet) -> None:
    """Place the chart, whose series are named by their pairs."""
    shown = [Series(f"=@name{k}", f"[@use{k}.speed]", f"[@use{k}.torque]", points=True, marker="circle")
             for k in range(1, NAMED + 1)]  # fmt: skip
    series = (*shown, Series("the drive's pair", "[@use0.speed]", "[@use0.torque]", points=True, marker="diamond",
                             color="374151"))  # fmt: skip
    sheet.chart(
        Chart("What the best pairs use of their motors", "largest speed / motor's largest speed",
              "RMS torque / continuous torque", series,
              "RMS torque over continuous torque against speed over largest speed, of the best pairs and the drive's",
              (0, None, None), (0, None, None)),
        column=13, row=5, width=8, height=24,
    )  # fmt: skip
