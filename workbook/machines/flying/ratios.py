"""The Ratios sheet: the transmission ratios that each motor accepts, and figures 11 and 12 of S5."""

from dataclasses import replace
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.selection.task import NOTHING
from workbook.book.chart import Chart, Series
from workbook.book.declare import Book, Sheet, calc, constant, given, result
from workbook.book.rows import filled
from workbook.machines.flying.view import ToolDrive

POINTS = 24  # of the curves of figure 12
LEAST, MOST = 0.001, 0.1  # of α, where they begin
OFF = -1.0  # left of the charts' edge: where what is not drawn is
FINE = '0.0000##;-0.0000##;"–"'
TALL = {"width": 9, "height": 24}


class RatiosSheet:
    """The sheet of a drive."""

    def __init__(self, view: ToolDrive) -> None:
        self.view, self.choice, self.task = view, view.proposal, view.proposal.grid.task
        self.rooms, self.efficiency = self.choice.rooms, view.chosen.efficiency
        self.first = float(self.choice.reducers.ratio[0])
        self.ranges = self.task.ratio_ranges(self.choice.motors, self.efficiency)
        whole = replace(view.motor, rated_torque=view.motor.rated_torque * view.kept.rms_reserve)
        self.curves = self.task.ratio_curves(whole, self.efficiency, POINTS, (LEAST, MOST))
        """the ratios of the motor in use over the load factor"""

    def declare(self, book: Book) -> None:
        """Declare the sheet."""
        sheet = book.sheet("Ratios", "Which transmission ratios each motor accepts: S5, steps 3 to 5, figures 11, 12.")
        sheet.heading("Enter")
        sheet.rows(
            given("ratio_eta", "Efficiency before a reducer is known", "η", "", self.efficiency,
                  "selection.efficiency", format="0.0##", source="1: S5 as printed")
        )  # fmt: skip
        sheet.chart_row(figure11(self.rooms[0]), figure12(), **TALL)
        sheet.heading("Results")
        self.motors(sheet)
        sheet.not_printed_below()
        sheet.heading("Workings")
        (m, _), now = self.view.pair, self.task.load_factor / self.efficiency
        alpha = float(self.ranges.accelerating_factor[m])
        sheet.rows(
            constant("ratio_none", "A smaller acceleration, torque or speed is none", "", "SI", NOTHING,
                     "so small it comes from rounding", format="0E+00"),
            calc("sel_moves", "The load accelerates, and has a torque", "", "",
                 "=IF(AND(sel_wrms>ratio_none,sel_trms>ratio_none,sel_wmax>ratio_none),1,0)", int(self.task.moves),
                 "1 yes, 0 no"),
            calc("ratio_beta", "Load factor", "β", "W/s", "=sel_moves*sel_beta", self.task.load_factor,
                 scale=self.choice.shaft.product),
            calc("ratio_alpha", "Accelerating factor of the motor in use", "α", "W/s",
                 "=(drive_motor_rated*limits_rms_reserve)^2/drive_jm", alpha, "T_N²/J_M"),
            constant("ratio_least", "Figure 12 begins at this share of α at least", "", "", LEAST, format="0.0##"),
            constant("ratio_most", "… and at this at most", "", "", MOST, format="0.0##"),
            calc("ratio_first", "It begins at", "", "",
                 "=MAX(ratio_least,MIN(ratio_most,ratio_beta/ratio_eta/ratio_alpha))",
                 max(LEAST, min(MOST, now / alpha)), "so that the present load is in it"),
            constant("ratio_off", "Where charts hide what is not drawn", "", "", OFF, format="0"),
        )  # fmt: skip
        self.reducers(sheet)
        self.over_load_factor(sheet)
        sheet.print_columns = 20

    def drawn(self, values: Array, rows: int, shows: Any) -> Array:
        """Return ratios as drawn: the first reducer's where there are none, as a logarithmic axis has no 0."""
        return np.where(filled(shows, rows, False), filled(np.nan_to_num(values), rows), self.first)

    def motors(self, sheet: Sheet) -> None:
        """Declare the motors: α, the ratios that each accepts, and its line in figure 11."""
        found, n, m = self.ranges, self.rooms[0], self.choice.motors
        places = np.arange(1, n + 1)
        low, high = (self.drawn(one, n, found.accepted) for one in (found.lowest, found.tau_max))
        words = np.where(found.accepted, "yes", np.where(found.strong, "too slow", "too weak"))

        def of(values: Array) -> list[Any]:
            return filled(np.nan_to_num(values), n)

        sheet.table(
            "ratios", "Motors (S5, steps 3 and 4)", n,
            result("motor", "motor", "", "", '=INDEX([motors.name],[k])&""', filled(m.names, n, ""), align="left"),
            constant("k", "number", "k", "", places.tolist()),
            result("verdict", "has a range of τ?", "", "",
                   '=IF([j]*sel_moves=0,"–",IF([enough]=0,"too weak",IF([low]<=[tau_max],"yes","too slow")))',
                   filled(words if self.task.moves else [], n, "–")),
            result("alpha", "accelerating factor", "α", "W/s", "=IF([j]>0,INDEX([sel_motors.rated],[k])^2/[j],0)",
                   of(found.accelerating_factor), "T_N²/J_M", format='0;-0;"–"'),
            result("tau_min", "least ratio", "τ_min", "", "=IF([enough]=1,2*SQRT([j])*sel_wrms/([wide]+[root]),0)",
                   of(found.tau_min), "S5, (14) with −", format=FINE),
            result("tau_max", "largest ratio", "τ_max", "",
                   "=IF([enough]=1,SQRT([j])*([wide]+[root])*ratio_eta/(2*sel_trms),0)", of(found.tau_max),
                   "S5, (14) with +", format=FINE),
            result("tau_opt", "best ratio", "τ_opt", "", "=IF(sel_moves=1,SQRT([j]*sel_wrms*ratio_eta/sel_trms),0)",
                   of(found.tau_opt), "√(τ_min τ_max)", format=FINE),
            result("tau_lim", "ratio at n_max", "τ_lim", "",
                   "=IF([j]*sel_moves>0,sel_wmax/INDEX([sel_motors.nmax],[k])*30/PI(),0)", of(found.tau_limit),
                   "ω_L,max / ω_M,max", format=FINE),
            calc("j", "inertia", "J_M", "kg m²", "=INDEX([sel_motors.jm],[k])", filled(m.inertia, n)),
            calc("low", "ratios from", "", "", "=MAX([tau_min],[tau_lim])", of(found.lowest),
                 "max(τ_min, τ_lim)", format=FINE),
            calc("enough", "strong enough", "", "", "=IF(AND([j]*sel_moves>0,[alpha]>=ratio_beta/ratio_eta),1,0)",
                 filled(found.strong.astype(int), n, 0), "α ≥ β/η", format="0"),
            calc("root", "working", "", "", "=IF([enough]=1,SQRT([alpha]-ratio_beta/ratio_eta),0)", of(found.root),
                 "√(α − β/η)"),
            calc("wide", "working", "", "", "=IF([enough]=1,SQRT([root]^2+4*sel_wrms*sel_trms/ratio_eta),0)",
                 of(found.wide), "√(α − β/η + 4 ω̇ T*/η)"),
            calc("x", "drawn at", "", "", '=IF([verdict]="yes",[k],ratio_off)',
                 np.where(filled(found.accepted, n, False), places, OFF), format="0"),
            calc("from", "from", "τ", "", '=IF([verdict]="yes",[low],1/[sel_reducers.i.1])', low),
            calc("to", "to", "τ_max", "", '=IF([verdict]="yes",[tau_max],1/[sel_reducers.i.1])', high),
            calc("up", "length", "", "", "=[to]-[from]", high - low, scale=self.first),
            calc("best", "best", "τ_opt", "", '=IF([verdict]="yes",[tau_opt],1/[sel_reducers.i.1])',
                 self.drawn(found.tau_opt, n, found.accepted)),
        )  # fmt: skip

    def reducers(self, sheet: Sheet) -> None:
        """Declare the reducers' lines in figure 11, and the pair in use."""
        (down, across), choice = self.rooms, self.choice
        fits = choice.grid.fits & self.task.moves
        there = np.array(filled(fits, across, False))
        m, _ = self.view.pair
        sheet.row += 1
        sheet.table(
            "ratio_reducers", "Figure 11: reducers that meet the load's torque and speed", across,
            constant("k", "reducer", "", "", list(range(1, across + 1))),
            calc("fits", "drawn", "", "", "=INDEX([sel_reducers.fits],[k])*sel_moves", there.astype(int), format="0"),
            calc("x", "from", "", "", "=IF([fits]=1,0,ratio_off)", np.where(there, 0.0, OFF)),
            calc("tau", "ratio", "τ", "", "=1/INDEX([sel_reducers.i],IF([fits]=1,[k],1))",
                 self.drawn(choice.reducers.ratio, across, fits)),
            calc("right", "length", "", "", "=[fits]*(MAX([ratios.k])+1)", there * (down + 1.0)),
        )  # fmt: skip
        sheet.table(
            "ratio_pair", "The pair in use", 1,
            calc("x", "motor", "", "", "=MAX(1,drive_motor_row)", [m + 1]),
            calc("beta", "load factor", "β", "W/s", "=ratio_beta+0", [self.task.load_factor],
                 scale=choice.shaft.product),
            calc("tau", "ratio", "τ", "", "=1/drive_i", [1.0 / self.view.gears[1]]),
        )  # fmt: skip

    def over_load_factor(self, sheet: Sheet) -> None:
        """Declare the ratios of the motor in use, for this load driven faster and slower."""
        x, still = self.curves, np.full(POINTS, self.first)

        def drawn(values: Array) -> Array:
            return values if self.task.moves else still

        sheet.row += 1
        sheet.table(
            "figure12", "Figure 12: the motor in use, with this load driven faster and slower", POINTS,
            constant("k", "point", "", "", list(range(1, POINTS + 1))),
            calc("share", "share of α", "β/(η α)", "",
                 "=1-(1-ratio_first)*(1-([k]-1)/([figure12.k.last]-1))^2", x.share, "closer at the tip"),
            calc("beta", "load factor", "β", "W/s", "=[share]*ratio_eta*ratio_alpha", x.load_factor),
            calc("pace", "pace", "√(β/β_now)", "", "=IF(sel_moves=1,SQRT([beta]/ratio_beta),0)", x.rate_factor,
                 "on ω̇ and T* alike"),
            calc("root", "working", "", "", "=SQRT((1-[share])*ratio_alpha)", x.root, "√(α − β/η)"),
            calc("wide", "working", "", "", "=SQRT([root]^2+4*sel_wrms*sel_trms*[pace]^2/ratio_eta)", x.wide,
                 "√(α − β/η + 4 ω̇ T*/η)"),
            result("tau_min", "least ratio", "τ_min", "",
                   "=IF(sel_moves=1,2*SQRT(drive_jm)*sel_wrms*[pace]/([wide]+[root]),1/[sel_reducers.i.1])",
                   drawn(x.tau_min)),
            result("tau_opt", "best ratio", "τ_opt", "",
                   "=IF(sel_moves=1,SQRT(drive_jm*sel_wrms*ratio_eta/sel_trms),1/[sel_reducers.i.1])",
                   drawn(x.tau_opt)),
            result("tau_max", "largest ratio", "τ_max", "",
                   "=IF(sel_moves=1,SQRT(drive_jm)*([wide]+[root])*ratio_eta/(2*sel_trms*[pace]),"
                   "1/[sel_reducers.i.1])", drawn(x.tau_max)),
        )  # fmt: skip


def figure11(motors: int) -> Chart:
    """Return a line up for each motor, a line across for each reducer."""
    lines = (
        Series("motors: from max(τ_min, τ_lim)", "[ratios.x]", "[ratios.from]", points=True, marker="dash",
               up="[ratios.up]", color="0072B2"),
        Series("to τ_max", "[ratios.x]", "[ratios.to]", points=True, marker="dash", color="0072B2"),
        Series("τ_opt", "[ratios.x]", "[ratios.best]", points=True, marker="circle", color="0072B2"),
        Series("across: reducers that hold the load", "[ratio_reducers.x]", "[ratio_reducers.tau]", points=True,
               right="[ratio_reducers.right]", color="A6A6A6"),
        Series("pair in use", "[ratio_pair.x]", "[ratio_pair.tau]", points=True, marker="diamond", color="D55E00"),
    )  # fmt: skip
    return Chart("Ratios that each motor accepts, and reducers (S5, figure 11)", "number of the motor in its table",
                 "transmission ratio τ", lines,
                 "A vertical line for each motor from its least to its largest ratio, a horizontal line for each "
                 "reducer", (0, motors + 1, 1), log_y=True)  # fmt: skip


def figure12() -> Chart:
    """Return the ratios over the load factor."""
    lines = (
        Series("τ_max", "[figure12.beta]", "[figure12.tau_max]", color="C00000"),
        Series("τ_opt", "[figure12.beta]", "[figure12.tau_opt]", dashed=True, color="404040"),
        Series("τ_min", "[figure12.beta]", "[figure12.tau_min]", color="000000"),
        Series("pair in use", "[ratio_pair.beta]", "[ratio_pair.tau]", points=True, marker="diamond", color="D55E00"),
    )
    return Chart("Ratios against the load factor, motor in use (S5, figure 12)", "load factor β [W/s]",
                 "transmission ratio τ", lines,
                 "Largest, best and least transmission ratio of the motor in use against the load factor",
                 (0, None, None), log_y=True)  # fmt: skip
