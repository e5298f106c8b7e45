"""Tables behind the charts of the Selection sheet: figures 11 and 12 of S5, the pair over the cycle."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from engine.choice.curve import Outline
from engine.choice.pair import reverses, square_steps
from engine.choice.ratios import ratio_curves
from engine.drivetrain import direction
from engine.laws.base import Array
from workbook.book.declare import Sheet, calc, constant, result
from workbook.book.rows import filled
from workbook.drive import losses
from workbook.entries.units import RPM, shown
from workbook.selection.load import LoadCells
from workbook.selection.view import Choosing
from workbook.selection.workings import OFF

POINTS = 24  # of the curves of figure 12
LEAST, MOST = 0.001, 0.1  # of α, where they begin
SIDES = (-1, -1, 1, 1, 1, 1, -1, -1, -1)
UPPER = (1, 1, 1, 1, -1, -1, -1, -1, 1)
OUTER = (1, 0, 0, 1, 1, 0, 0, 1, 1)


def curves(sheet: Sheet, load: LoadCells, view: Choosing) -> None:
    """Declare the tables behind the charts."""
    sheet.heading("As drawn in the charts")
    motor_lines(sheet, view)
    reducer_lines(sheet, view)
    figure12(sheet, view)
    limits(sheet, view)
    cycle(sheet, load, view)


def first_ratio(view: Choosing) -> float:
    """Return the first reducer's ratio: on a logarithmic axis what is not drawn must be somewhere, too."""
    return float(view.reducers.ratio[0])


def motor_lines(sheet: Sheet, view: Choosing) -> None:
    """Declare the ends of the motors' lines in figure 11."""
    down, ranges, first = view.rooms[0], view.ranges, first_ratio(view)
    good = np.array(filled(ranges.accepted, down, False))

    def drawn(values: Array) -> Array:
        return np.where(good, filled(values, down), first)

    low, high = drawn(ranges.lowest), drawn(ranges.tau_max)
    places = np.arange(1, down + 1)
    sheet.table(
        "figure11", "Figure 11: motors", down,
        constant("k", "motor", "", "", places.tolist()),
        calc("x", "place", "", "",
             '=IF(INDEX([motors.verdict],[k])="yes",[k],sel_off)', np.where(good, places, OFF)),
        calc("low", "from", "τ", "",
             '=IF(INDEX([motors.verdict],[k])="yes",INDEX([motors.low],[k]),[reducers.tau.1])', low),
        calc("high", "to", "τ_max", "",
             '=IF(INDEX([motors.verdict],[k])="yes",INDEX([motors.tau_max],[k]),[reducers.tau.1])', high),
        calc("up", "length", "", "", "=[high]-[low]", high - low, scale=first),
        calc("best", "best", "τ_opt", "",
             '=IF(INDEX([motors.verdict],[k])="yes",INDEX([motors.tau_opt],[k]),[reducers.tau.1])',
             drawn(ranges.tau_opt)),
    )  # fmt: skip


def reducer_lines(sheet: Sheet, view: Choosing) -> None:
    """Declare the reducers' lines in figure 11, and the pair."""
    (down, across), first, pair = view.rooms, first_ratio(view), view.pair
    fits: NDArray[np.bool_] = np.array(filled(view.at_motor.fits & view.task.moves, across, False))
    sheet.table(
        "figure11r", "Figure 11: reducers", across,
        constant("k", "reducer", "", "", list(range(1, across + 1))),
        constant("width", "width of the chart", "", "", filled([], across, down + 1)),
        calc("x", "place", "", "",
             '=IF(INDEX([reducers.verdict],[k])="yes",0,sel_off)', np.where(fits, 0.0, OFF)),
        calc("tau", "ratio", "τ", "",
             '=IF(INDEX([reducers.verdict],[k])="yes",INDEX([reducers.tau],[k]),[reducers.tau.1])',
             np.where(fits, filled(view.reducers.ratio, across), first)),
        calc("right", "length", "", "",
             '=IF(INDEX([reducers.verdict],[k])="yes",[width],0)', np.where(fits, down + 1.0, 0.0)),
    )  # fmt: skip
    sheet.table(
        "figure11p", "Figure 11: selected pair", 1,
        calc("x", "place", "", "", "=IF(sel_found=1,sel_m,sel_off)", [pair.motor + 1 if pair else OFF]),
        calc("tau", "ratio", "τ", "", "=IF(sel_found=1,sel_tau,[reducers.tau.1])", [pair.ratio if pair else first]),
    )  # fmt: skip


def figure12(sheet: Sheet, view: Choosing) -> None:
    """Declare the ratios of the pair's motor, or of the first, for this load made faster and slower."""
    pair, motors, first = view.pair, view.motors, first_ratio(view)
    m = pair.motor if pair else 0
    rated, inertia = float(motors.rated_torque[m]), float(motors.inertia[m])
    x = ratio_curves(view.task, rated, inertia, view.given.efficiency, POINTS, (LEAST, MOST))

    def drawn(values: Array) -> Array:
        return values if view.task.moves else np.full(POINTS, first)

    sheet.rows(
        constant("sel_least", "Figure 12 begins at this share of α at least", "", "", LEAST, format="0.0##"),
        constant("sel_most", "… and at this at most", "", "", MOST, format="0.0##"),
        calc("sel_first", "It begins at", "", "",
             "=MAX(sel_least,MIN(sel_most,sel_beta/(sel_eta*INDEX([motors.alpha],MAX(1,sel_m)))))", float(x.share[0]),
             source="so that the present load is in it"),
    )  # fmt: skip
    sheet.row += 1
    sheet.table(
        "figure12", "Figure 12: the selected motor, or else the first, with this load driven faster and slower",
        POINTS,
        constant("k", "point", "", "", list(range(1, POINTS + 1))),
        calc("share", "share of α", "β/(η α)", "",
             "=1-(1-sel_first)*(1-([k]-1)/([figure12.k.last]-1))^2",
             x.share, source="closer together near the tip"),
        calc("beta", "load factor", "β", "W/s",
             "=[share]*sel_eta*INDEX([motors.alpha],MAX(1,sel_m))",
             x.load_factor),
        calc("pace", "pace", "√(β/β_now)", "",
             "=IF(sel_moves=1,SQRT([beta]/sel_beta),0)",
             x.pace, source="on ω̇ and T* alike"),
        calc("root", "", "√(α − β/η)", "",
             "=SQRT((1-[share])*INDEX([motors.alpha],MAX(1,sel_m)))",
             x.root),
        calc("wide", "", "", "",
             "=SQRT([root]^2+4*sel_wrms*sel_trms*[pace]^2/sel_eta)",
             x.wide, source="√(α − β/η + 4 ω̇ T*/η)"),
        result("tau_min", "least ratio", "τ_min", "",
               ("=IF(sel_moves=1,2*SQRT(INDEX([motors.inertia],MAX(1,sel_m))/10000)*sel_wrms*[pace]/([wide]+[root]),"
                "[reducers.tau.1])"),
               drawn(x.tau_min)),
        result("tau_opt", "best ratio", "τ_opt", "",
               "=IF(sel_moves=1,INDEX([motors.tau_opt],MAX(1,sel_m)),[reducers.tau.1])",
               drawn(x.tau_opt)),
        result("tau_max", "largest ratio", "τ_max", "",
               ("=IF(sel_moves=1,SQRT(INDEX([motors.inertia],MAX(1,sel_m))/10000)*([wide]+[root])*sel_eta"
                "/(2*sel_trms*[pace]),[reducers.tau.1])"),
               drawn(x.tau_max)),
    )  # fmt: skip
    sheet.table(
        "figure12p", "Figure 12: selected pair", 1,
        calc("beta", "load factor", "β", "W/s",
             "=IF(sel_found=1,sel_beta,sel_off)", [view.load_factor if pair else OFF]),
        calc("tau", "ratio", "τ", "",
             "=IF(sel_found=1,sel_tau,[reducers.tau.1])", [pair.ratio if pair else first]),
    )  # fmt: skip


def limits(sheet: Sheet, view: Choosing) -> None:
    """Declare the corners of the motor's torque–speed curve."""
    nothing, pair = np.zeros(len(SIDES)), view.pair
    line = pair.curve.outline(pair.rated_torque, reverses(view.points)) if pair else Outline(nothing, nothing, nothing)
    sheet.table(
        "pair_limits", "Limits of the motor, as drawn", len(SIDES),
        constant("corner", "corner", "", "", list(range(1, len(SIDES) + 1))),
        constant("side", "right or left", "", "", list(SIDES)),
        constant("upper", "above or below", "", "", list(UPPER)),
        constant("outer", "at the largest speed", "", "", list(OUTER)),
        calc("rpm", "speed", "n", "rpm",
             ("=IF(AND([side]<0,MIN([pair_cycle.rpm])>=0-sel_still),0,[side])"
              "*IF([outer]=1,sel_nmax,sel_knee)"),
             shown(line.speed, RPM)),
        calc("peak", "peak torque", "T_max", "Nm",
             "=[upper]*(sel_peak+IF([outer]=1,sel_slope*(sel_nmax-sel_knee),0))",
             line.peak),
        calc("rated", "rated torque", "T_N", "Nm", "=[upper]*sel_rated", line.rated),
    )  # fmt: skip


def cycle(sheet: Sheet, load: LoadCells, view: Choosing) -> None:
    """Declare the pair over the cycle: speed and torque of the motor, what is left below its curve."""
    s, p = view.load, view.points
    sheet.table(
        "pair_cycle", "The pair over the cycle (S5, step 7)", len(s.time),
        constant("k", "sample", "", "", list(range(1, len(s.time) + 1))),
        calc("time", "time", "t", "s", f"=INDEX({load.time},[k])", s.time),
        calc("w", "speed of the load", "ω_L", "rad/s", f"=INDEX({load.speed},[k])", s.speed),
        calc("dir", "direction", "", "", f"={losses.direction('[w]')}", direction(s.speed), format="0"),
        calc("load", "load torque", "T*_L", "Nm", f"=INDEX({load.torque},[k])", s.torque),
        result("rpm", "motor speed", "n_M", "rpm",
               "=IF(sel_found=1,[w]/sel_tau*60/(2*PI()),0)",
               shown(p.speed, RPM), source="ω_L/τ"),
        result("torque", "motor torque", "T_M", "Nm",
               (f"=IF(sel_found=1,sel_j/10000/sel_tau*INDEX({load.acceleration},[k])+sel_tau*[load]"
                f"*{losses.loss_factor('[load]', '[dir]', 'sel_er')},0)"),
               p.torque, source="J ω̇/τ + τ T*/η, braking τ T* η"),
        calc("part", "adds to the mean square", "", "Nm² s",
             "=IF([k]=1,0,([torque]^2+[torque-1]^2)/2*([time]-[time-1]))",
             square_steps(s.time, p.torque), source="trapezoidal rule"),
        result("spare", "below the motor's curve", "", "Nm",
               "=IF(ABS([rpm])>sel_nmax,0,sel_peak+sel_slope*MAX(ABS([rpm])-sel_knee,0))-ABS([torque])",
               view.reserve, source="peak at n_M less |T_M|", scale=max(p.peak_torque, 1e-3)),
    )  # fmt: skip
