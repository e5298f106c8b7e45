"""Charts of the Selection sheet and their tables: the pair over the cycle, figures 11 and 12 of S5."""

from __future__ import annotations

import numpy as np

from engine.drivetrain import STANDSTILL
from engine.laws.base import Array
from engine.selection import Task, ratio_ranges
from workbook.book.chart import Chart, Series
from workbook.book.declare import Sheet, calc, constant, result
from workbook.entries.units import RPM
from workbook.selection.load import LoadCells
from workbook.selection.view import Choosing

POINTS = 24  # of the curves of figure 12
LEAST, MOST = 0.001, 0.1  # of α, where they begin
OFF = -1.0  # left of the charts' edge
SIDES = (-1, -1, 1, 1, 1, 1, -1, -1, -1)
UPPER = (1, 1, 1, 1, -1, -1, -1, -1, 1)
OUTER = (1, 0, 0, 1, 1, 0, 0, 1, 1)


def charts(sheet: Sheet, view: Choosing) -> None:
    """Place the three charts beside the figures."""
    down = view.rooms[0]
    ranges = (
        Series("motors: from max(τ_min, τ_lim)", "[figure11.x]", "[figure11.low]", points=True, marker="dash",
               up="[figure11.up]", color="1F4E79"),
        Series("to τ_max", "[figure11.x]", "[figure11.high]", points=True, marker="dash", color="1F4E79"),
        Series("τ_opt", "[figure11.x]", "[figure11.best]", points=True, marker="circle", color="1F4E79"),
        Series("across: reducers that hold the load", "[figure11r.x]", "[figure11r.tau]", points=True,
               right="[figure11r.right]", color="A6A6A6"),
        Series("the pair", "[figure11p.x]", "[figure11p.tau]", points=True, marker="diamond", color="C55A11"),
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
        Chart("Torque against speed of the motor of the pair", "motor speed n_M [rpm]", "motor torque T_M [Nm]", points,
              "Operating points of the chosen motor over one cycle, within its torque-speed curve"),
        column=13, row=28, width=8, height=18,
    )  # fmt: skip
    against = (
        Series("τ_max", "[figure12.beta]", "[figure12.tau_max]", color="C00000"),
        Series("τ_opt", "[figure12.beta]", "[figure12.tau_opt]", dashed=True, color="404040"),
        Series("τ_min", "[figure12.beta]", "[figure12.tau_min]", color="000000"),
        Series("the pair", "[figure12p.beta]", "[figure12p.tau]", points=True, marker="diamond", color="C55A11"),
    )
    sheet.chart(
        Chart("Ratios against the load factor, the pair's motor (S5, figure 12)", "load factor β [Nm rad/s²]",
              "transmission ratio τ", against,
              "Largest, best and least transmission ratio of the chosen motor against the load factor",
              (0, None, None), log_y=True),
        column=13, row=47, width=8, height=18,
    )  # fmt: skip
    sheet.row = max(sheet.row, 66)


def curves(sheet: Sheet, load: LoadCells, view: Choosing) -> None:
    """Declare the tables behind the charts."""
    figure11(sheet, view)
    figure12(sheet, view)
    limits(sheet, view)
    cycle(sheet, load, view)


def figure11(sheet: Sheet, view: Choosing) -> None:
    """Declare the ends of the motors' lines, the reducers' lines, and the pair."""
    down, across = view.rooms
    ranges, first = view.ranges, float(view.reducers.ratio[0])
    good = np.zeros(down, bool)
    low, high, best = (np.full(down, first) for _ in range(3))
    if ranges is not None:
        n = len(ranges.accepted)
        good[:n] = ranges.accepted
        for values, found in ((low, ranges.lowest), (high, ranges.tau_max), (best, ranges.tau_opt)):
            values[:n] = np.where(ranges.accepted, found, first)
    fits = np.zeros(across, bool)
    tau = np.full(across, first)
    if view.asked.task:
        r = view.reducers
        fits[: len(r.names)] = view.strong & (view.asked.max_speed / r.ratio <= r.max_input_speed)
        tau[: len(r.names)] = np.where(fits[: len(r.names)], r.ratio, first)
    chosen = view.chosen
    accepted = 'INDEX([motors.verdict],[k])="yes"'
    fitting = 'INDEX([reducers.verdict],[k])="yes"'
    sheet.heading("As drawn in the charts")
    sheet.table(
        "figure11", "Figure 11: motors", down,
        constant("k", "motor", "", "", list(range(1, down + 1))),
        calc("x", "place", "", "", f"=IF({accepted},[k],sel_off)", np.where(good, np.arange(1, down + 1), OFF)),
        calc("low", "from", "τ", "", f"=IF({accepted},INDEX([motors.low],[k]),[reducers.tau.1])", low),
        calc("high", "to", "τ_max", "", f"=IF({accepted},INDEX([motors.tau_max],[k]),[reducers.tau.1])", high),
        calc("up", "length", "", "", "=[high]-[low]", high - low, scale=first),
        calc("best", "best", "τ_opt", "", f"=IF({accepted},INDEX([motors.tau_opt],[k]),[reducers.tau.1])", best),
    )  # fmt: skip
    sheet.table(
        "figure11r", "Figure 11: reducers", across,
        constant("k", "reducer", "", "", list(range(1, across + 1))),
        constant("width", "width of the chart", "", "", [down + 1] * across),
        calc("x", "place", "", "", f"=IF({fitting},0,sel_off)", np.where(fits, 0.0, OFF)),
        calc("tau", "ratio", "τ", "", f"=IF({fitting},INDEX([reducers.tau],[k]),[reducers.tau.1])", tau),
        calc("right", "length", "", "", f"=IF({fitting},[width],0)", np.where(fits, down + 1.0, 0.0)),
    )  # fmt: skip
    sheet.table(
        "figure11p", "Figure 11: the pair", 1,
        calc("x", "place", "", "", "=IF(sel_found=1,sel_m,sel_off)", [chosen[0] + 1 if chosen else OFF]),
        calc("tau", "ratio", "τ", "",
             "=IF(sel_found=1,sel_tau,[reducers.tau.1])", [float(view.reducers.ratio[chosen[1]]) if chosen else first]),
    )  # fmt: skip


def figure12(sheet: Sheet, view: Choosing) -> None:
    """Declare the ratios of the pair's motor, or of the first, for this load made faster and slower."""
    chosen, a = view.chosen, view.asked
    x = load_curves(view)
    row = "MAX(1,sel_m)"
    first = float(view.reducers.ratio[0])
    sheet.rows(
        constant("sel_least", "Figure 12 begins at this share of α at least", "", "", LEAST, format="0.0##"),
        constant("sel_most", "… and at this at most", "", "", MOST, format="0.0##"),
        calc("sel_first", "It begins at", "", "",
             f"=MAX(sel_least,MIN(sel_most,sel_beta/(sel_eta*INDEX([motors.alpha],{row}))))", float(x["share"][0]),
             source="so that the present load is in it"),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "figure12", "Figure 12: the motor of the pair, or else the first, and this load driven faster and slower", POINTS,
        constant("k", "point", "", "", list(range(1, POINTS + 1))),
        calc("share", "share of α", "β/(η α)", "",
             "=1-(1-sel_first)*(1-([k]-1)/([figure12.k.last]-1))^2", x["share"], source="closer together near the tip"),
        calc("beta", "load factor", "β", "Nm rad/s²", f"=[share]*sel_eta*INDEX([motors.alpha],{row})", x["beta"]),
        calc("pace", "pace", "√(β/β_now)", "",
             "=IF(sel_moves=1,SQRT([beta]/sel_beta),0)", x["pace"], source="on ω̇ and T* alike"),
        calc("root", "", "√(α − β/η)", "", f"=SQRT((1-[share])*INDEX([motors.alpha],{row}))", x["root"]),
        calc("wide", "", "", "",
             "=SQRT([root]^2+4*sel_wrms*sel_trms*[pace]^2/sel_eta)", x["wide"], source="√(α − β/η + 4 ω̇ T*/η)"),
        result("tau_min", "least ratio", "τ_min", "",
               (f"=IF(sel_moves=1,2*SQRT(INDEX([motors.inertia],{row}))*sel_wrms*[pace]/([wide]+[root]),"
                f"[reducers.tau.1])"), x["tau_min"]),
        result("tau_opt", "best ratio", "τ_opt", "",
               f"=IF(sel_moves=1,INDEX([motors.tau_opt],{row}),[reducers.tau.1])", x["tau_opt"]),
        result("tau_max", "largest ratio", "τ_max", "",
               (f"=IF(sel_moves=1,SQRT(INDEX([motors.inertia],{row}))*([wide]+[root])*sel_eta/(2*sel_trms*[pace]),"
                f"[reducers.tau.1])"), x["tau_max"]),
    )  # fmt: skip
    sheet.table(
        "figure12p", "Figure 12: the pair", 1,
        calc("beta", "load factor", "β", "", "=IF(sel_found=1,sel_beta,sel_off)", [a.load_factor if chosen else OFF]),
        calc("tau", "ratio", "τ", "",
             "=IF(sel_found=1,sel_tau,[reducers.tau.1])", [float(view.reducers.ratio[chosen[1]]) if chosen else first]),
    )  # fmt: skip


def load_curves(view: Choosing) -> dict[str, Array]:
    """Return the engine's range of ratios of one motor, for the load at paces that change β alone."""
    m = view.chosen[0] if view.chosen else 0
    motors, eta, task = view.motors, view.given.efficiency, view.asked.task
    inertia, rated = float(motors.inertia[m]), float(motors.rated_torque[m])
    alpha = rated**2 / inertia
    begin = max(LEAST, min(MOST, view.asked.load_factor / (eta * alpha)))
    share = 1.0 - (1.0 - begin) * (1.0 - np.arange(POINTS) / (POINTS - 1)) ** 2
    beta, root = share * eta * alpha, np.sqrt((1.0 - share) * alpha)
    if task is None:
        flat = dict.fromkeys(("tau_min", "tau_opt", "tau_max"), np.full(POINTS, view.reducers.ratio[0]))
        return {"share": share, "beta": beta, "pace": np.zeros(POINTS), "root": root, "wide": root} | flat
    pace = np.sqrt(beta / task.load_factor)
    found = [
        ratio_ranges(
            Task(task.acceleration_rms * p, task.torque_rms * p, task.power_rate_mean * p * p, task.max_speed * p),
            rated, inertia, float(motors.max_speed[m]), eta,
        )
        for p in pace[:-1]
    ]  # fmt: skip
    best = float(np.sqrt(inertia * task.acceleration_rms * eta / task.torque_rms))
    wide = np.sqrt(root**2 + 4.0 * task.acceleration_rms * task.torque_rms * pace**2 / eta)
    return {
        "share": share, "beta": beta, "pace": pace, "root": root, "wide": wide,
        "tau_min": np.array([*(float(r.tau_min) for r in found), best]),
        "tau_opt": np.full(POINTS, best),
        "tau_max": np.array([*(float(r.tau_max) for r in found), best]),
    }  # fmt: skip


def limits(sheet: Sheet, view: Choosing) -> None:
    """Declare the corners of the motor's torque–speed curve."""
    speeds = view.curve.speed / RPM if view.chosen else np.zeros(3)
    torques = view.curve.torque if view.chosen else np.zeros(3)
    rated = float(view.motors.rated_torque[view.chosen[0]]) if view.chosen else 0.0
    reverse = bool(view.points.speed.min() < -STANDSTILL)
    side = [s if s > 0 or reverse else 0 for s in SIDES]
    sheet.table(
        "pair_limits", "Limits of the motor, as drawn", len(SIDES),
        constant("corner", "corner", "", "", list(range(1, len(SIDES) + 1))),
        constant("side", "right or left", "", "", list(SIDES)),
        constant("upper", "above or below", "", "", list(UPPER)),
        constant("outer", "at the largest speed", "", "", list(OUTER)),
        calc("rpm", "speed", "n", "rpm", "=IF(AND([side]<0,MIN([pair_cycle.rpm])>=0-sel_still),0,[side])*IF([outer]=1,sel_nmax,sel_knee)",
             [s * (speeds[2] if o else speeds[1]) for s, o in zip(side, OUTER, strict=True)]),
        calc("peak", "peak torque", "T_max", "Nm", "=[upper]*(sel_peak+IF([outer]=1,sel_slope*(sel_nmax-sel_knee),0))",
             [u * (torques[2] if o else torques[1]) for u, o in zip(UPPER, OUTER, strict=True)]),
        calc("rated", "rated torque", "T_N", "Nm", "=[upper]*sel_rated", [u * rated for u in UPPER]),
    )  # fmt: skip


def cycle(sheet: Sheet, load: LoadCells, view: Choosing) -> None:
    """Declare the pair over the cycle: speed and torque of the motor, what is left below its curve."""
    s, p = view.samples, view.points
    n = len(s.time)
    spare = view.curve.at(p.speed) - np.abs(p.torque) if view.chosen else np.zeros(n)
    part = np.concatenate(([0.0], np.diff(s.time) * (p.torque[1:] ** 2 + p.torque[:-1] ** 2) / 2.0))
    torque = (
        f"=IF(sel_found=1,sel_j/sel_tau*INDEX({load.acceleration},[k])+sel_tau*[load]"
        "*IF(OR(ABS([w])<sel_still,[load]*[w]+sel_returned>=0),1/sel_er,sel_er),0)"
    )
    size = float(np.abs(p.torque).max())
    sheet.table(
        "pair_cycle", "The pair over the cycle (S5, step 7)", n,
        constant("k", "sample", "", "", list(range(1, n + 1))),
        calc("time", "time", "t", "s", f"=INDEX({load.time},[k])", s.time),
        calc("w", "speed of the load", "ω_L", "rad/s", f"=INDEX({load.speed},[k])", s.speed),
        calc("load", "load torque", "T*_L", "Nm", f"=INDEX({load.torque},[k])", s.torque),
        result("rpm", "motor speed", "n_M", "rpm",
               "=IF(sel_found=1,[w]/sel_tau*60/(2*PI()),0)", p.speed / RPM, source="ω_L/τ"),
        result("torque", "motor torque", "T_M", "Nm", torque, p.torque, source="J ω̇/τ + τ T*/η, braking τ T* η"),
        calc("part", "adds to the mean square", "", "Nm² s",
             "=IF([k]=1,0,([torque]^2+[torque-1]^2)/2*([time]-[time-1]))", part, source="trapezoidal rule"),
        result("spare", "below the motor's curve", "", "Nm",
               "=IF(ABS([rpm])>sel_nmax,0,sel_peak+sel_slope*MAX(ABS([rpm])-sel_knee,0))-ABS([torque])", spare,
               source="peak at n_M less |T_M|", scale=max(size, 1e-3)),
    )  # fmt: skip
