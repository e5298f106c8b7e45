"""The three charts of the Selection sheet: figures 11 and 12 of S5, and the pair in the torque–speed plane."""

from __future__ import annotations

from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet
from workbook.selection.view import Choosing


def charts(sheet: Sheet, view: Choosing) -> None:
    """Place the three charts beside the figures."""
    down = view.rooms[0]
    ranges = (
        Series("motors: from max(τ_min, τ_lim)", "[figure11.x]", "[figure11.low]", points=True, marker="dash",
               up="[figure11.up]", color="0072B2"),
        Series("to τ_max", "[figure11.x]", "[figure11.high]", points=True, marker="dash", color="0072B2"),
        Series("τ_opt", "[figure11.x]", "[figure11.best]", points=True, marker="circle", color="0072B2"),
        Series("across: reducers that hold the load", "[figure11r.x]", "[figure11r.tau]", points=True,
               right="[figure11r.right]", color="A6A6A6"),
        Series("selected pair", "[figure11p.x]", "[figure11p.tau]", points=True, marker="diamond", color="D55E00"),
    )  # fmt: skip
    sheet.chart(
        Chart("Ratios that each motor accepts, and reducers (S5, figure 11)", "number of the motor in its table",
              "transmission ratio τ", ranges,
              "A vertical line for each motor from its least to its largest ratio, a horizontal line for each reducer",
              (0, down + 1, 1), log_y=True),
        column=13, row=5, width=8, height=22,
    )  # fmt: skip
    points = (
        Series("operating points", "[pair_cycle.rpm]", "[pair_cycle.torque]"),
        Series("peak torque and speed of the motor", "[pair_limits.rpm]", "[pair_limits.peak]", dashed=True),
        Series("rated torque", "[pair_limits.rpm]", "[pair_limits.rated]", dashed=True),
    )
    sheet.chart(
        Chart("Torque against speed of the selected motor", "motor speed n_M [rpm]", "motor torque T_M [Nm]", points,
              "Operating points of the chosen motor over one cycle, within its torque-speed curve"),
        column=13, row=28, width=8, height=18,
    )  # fmt: skip
    against = (
        Series("τ_max", "[figure12.beta]", "[figure12.tau_max]", color="C00000"),
        Series("τ_opt", "[figure12.beta]", "[figure12.tau_opt]", dashed=True, color="404040"),
        Series("τ_min", "[figure12.beta]", "[figure12.tau_min]", color="000000"),
        Series("selected pair", "[figure12p.beta]", "[figure12p.tau]", points=True, marker="diamond", color="D55E00"),
    )
    sheet.chart(
        Chart("Ratios against the load factor, selected motor (S5, figure 12)", "load factor β [W/s]",
              "transmission ratio τ", against,
              "Largest, best and least transmission ratio of the chosen motor against the load factor",
              (0, None, None), log_y=True),
        column=13, row=47, width=8, height=18,
    )  # fmt: skip
    sheet.row = max(sheet.row, 66)
