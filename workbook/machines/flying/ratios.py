"""The Ratios sheet: the transmission ratios that each motor accepts, and figures 11 and 12 of S5."""

from dataclasses import replace
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.selection.task import NOTHING
from workbook.book.cell_tables import cell_tables, charts_beside
from workbook.book.declare import Book, Sheet
from workbook.book.rows import filled
from workbook.machines.flying.view import ToolDrive

CELLS = cell_tables(__file__)
CHARTS = charts_beside(__file__)

POINTS = 24  # of the curves of figure 12
LEAST, MOST = 0.001, 0.1  # of α, where they begin
OFF = -1.0  # left of the charts' edge: where what is not drawn is
FINE = '0.0000;-0.0000;"–"'
FIGURE_11 = "Ratios that each motor accepts, and reducers (S5, figure 11)"
FIGURE_12 = "Ratios against the load factor, motor in use (S5, figure 12)"


class RatiosSheet:
    """The sheet of a drive."""

    def __init__(self, view: ToolDrive) -> None:
        self.view, self.choice, self.task = view, view.proposal, view.proposal.grid.task
        self.rooms, self.efficiency = self.choice.rooms, view.chosen.efficiency
        self.first = float(self.choice.reducers.ratio[0])
        self.ranges = self.task.ratio_ranges(self.choice.motors, self.efficiency)
        whole = replace(view.motor, rated_torque=view.motor.rated_torque * view.reserves.rms_reserve)
        self.curves = self.task.ratio_curves(whole, self.efficiency, POINTS, (LEAST, MOST))
        """the ratios of the motor in use over the load factor"""

    def declare(self, book: Book) -> None:
        """Declare the sheet."""
        cell = CELLS["declare"]
        sheet = book.sheet("Ratios", "Which transmission ratios each motor accepts: S5, steps 3 to 5, figures 11, 12.")
        sheet.heading("Enter")
        sheet.rows(cell("ratio_eta", self.efficiency))
        figure11 = replace(CHARTS[FIGURE_11], x_range=(0, self.rooms[0] + 1, 1), log_y=True)
        figure12 = replace(CHARTS[FIGURE_12], x_range=(0, None, None), log_y=True)
        sheet.chart_row(figure11, figure12, width=9, height=24)
        sheet.heading("Results")
        self.motors(sheet)
        sheet.not_printed_below()
        sheet.heading("Workings")
        (m, _), now = self.view.pair, self.task.load_factor / self.efficiency
        alpha = float(self.ranges.accelerating_factor[m])
        sheet.rows(
            cell("ratio_none", NOTHING),
            cell("sel_moves", int(self.task.moves)),
            cell("ratio_beta", self.task.load_factor, scale=self.choice.shaft.product),
            cell("ratio_alpha", alpha),
            cell("ratio_least", LEAST),
            cell("ratio_most", MOST),
            cell("ratio_first", max(LEAST, min(MOST, now / alpha))),
            cell("ratio_off", OFF),
        )
        self.reducers(sheet)
        self.over_load_factor(sheet)
        sheet.print_columns = 19

    def drawn(self, values: Array, rows: int, shows: Any) -> Array:
        """Return ratios as drawn: the first reducer's where there are none, as a logarithmic axis has no 0."""
        return np.where(filled(shows, rows, False), filled(np.nan_to_num(values), rows), self.first)

    def motors(self, sheet: Sheet) -> None:
        """Declare the motors: α, the ratios that each accepts, and its line in figure 11."""
        cell = CELLS["ratios"]
        ranges, n, m = self.ranges, self.rooms[0], self.choice.motors
        places = np.arange(1, n + 1)
        low, high = (self.drawn(ratios, n, ranges.accepted) for ratios in (ranges.lowest, ranges.tau_max))
        words = np.where(ranges.accepted, "yes", np.where(ranges.strong, "too slow", "too weak"))

        def of(values: Array) -> list[Any]:
            return filled(np.nan_to_num(values), n)

        cell.place(
            sheet,
            cell("motor", filled(m.names, n, "")),
            cell("k", places.tolist()),
            cell("verdict", filled(words if self.task.moves else [], n, "–")),
            cell("alpha", of(ranges.accelerating_factor)),
            cell("tau_min", of(ranges.tau_min), format=FINE),
            cell("tau_max", of(ranges.tau_max), format=FINE),
            cell("tau_opt", of(ranges.tau_opt), format=FINE),
            cell("tau_lim", of(ranges.tau_limit), format=FINE),
            cell("j", filled(m.inertia, n)),
            cell("low", of(ranges.lowest), format=FINE),
            cell("enough", filled(ranges.strong.astype(int), n, 0)),
            cell("root", of(ranges.root)),
            cell("wide", of(ranges.wide)),
            cell("x", np.where(filled(ranges.accepted, n, False), places, OFF)),
            cell("from", low),
            cell("to", high),
            cell("up", high - low, scale=self.first),
            cell("best", self.drawn(ranges.tau_opt, n, ranges.accepted)),
            blank='[motor]=""',
        )

    def reducers(self, sheet: Sheet) -> None:
        """Declare the reducers' lines in figure 11, and the pair in use."""
        (down, across), choice = self.rooms, self.choice
        fits = choice.grid.fits & self.task.moves
        there = np.array(filled(fits, across, False))
        m, _ = self.view.pair
        sheet.row += 1
        CELLS["ratio_reducers"].place(
            sheet,
            CELLS["ratio_reducers"]("fits", there.astype(int)),
            CELLS["ratio_reducers"]("x", np.where(there, 0.0, OFF)),
            CELLS["ratio_reducers"]("tau", self.drawn(choice.reducers.ratio, across, fits)),
            CELLS["ratio_reducers"]("right", there * (down + 1.0)),
        )
        CELLS["ratio_pair"].place(
            sheet,
            CELLS["ratio_pair"]("x", [m + 1]),
            CELLS["ratio_pair"]("beta", [self.task.load_factor], scale=choice.shaft.product),
            CELLS["ratio_pair"]("tau", [1.0 / self.view.gears[1]]),
        )

    def over_load_factor(self, sheet: Sheet) -> None:
        """Declare the ratios of the motor in use, for this load driven faster and slower."""
        cell = CELLS["figure12"]
        x, still = self.curves, np.full(POINTS, self.first)

        def drawn(values: Array) -> Array:
            return values if self.task.moves else still

        sheet.row += 1
        cell.place(
            sheet,
            cell("share", x.share),
            cell("beta", x.load_factor),
            cell("pace", x.rate_factor),
            cell("root", x.root),
            cell("wide", x.wide),
            cell("tau_min", drawn(x.tau_min)),
            cell("tau_opt", drawn(x.tau_opt)),
            cell("tau_max", drawn(x.tau_max)),
        )
