"""The catalogues on the Selection sheet: motors and reducers as entered, and steps 3 to 5 of S5 beside each."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from engine.choice.pairs import load_at_motor
from engine.laws.base import Array
from workbook.book.declare import Sheet, calc, constant, given, result
from workbook.book.rows import filled
from workbook.entries.units import KG_CM2, PER_RPM, RPM, shown
from workbook.selection.catalogue import FALLING, HALF, MotorRow, ReducerRow
from workbook.selection.choosing import figures
from workbook.selection.view import Choosing

FIGURES = {"size": "mass", "cost": "cost"}
"""the entry of a product that a criterion reads"""
BLANK = '0.0##;-0.0##;"–"'  # a row without a pair shows a dash
FINE = '0.0000##;-0.0000##;"–"'
WHOLE = '0;-0;"–"'
SMALL = '0.0####;-0.0####;"–"'


def catalogues(sheet: Sheet, view: Choosing) -> None:
    """Declare both catalogues, below the charts."""
    sheet.heading(
        "Motors and reducers", "Add products in the empty rows, or change what stands there; no empty row in between."
    )
    motors(sheet, view)
    sheet.row += 1
    reducers(sheet, view)


def motors(sheet: Sheet, view: Choosing) -> None:
    """Declare the motors: what is entered, α and the range of ratios that each accepts."""
    rows, m, n, ranges = view.given.motors, view.motors, view.rooms[0], view.ranges
    has, figure = criterion_figures(view, rows)
    in_use = filled([], len(rows), 1)

    def entered(entry: str) -> list[Any]:
        return filled([getattr(row, entry) for row in rows], n, None)

    def found(values: Array) -> list[Any]:
        return filled(np.nan_to_num(values), n)

    sheet.book.column_names["motor_name"] = ("motors", "name")
    sheet.table(
        "motors", "Motors (S5, steps 1, 3 and 4)", n,
        given("name", "motor", "", "", entered("name"), "selection.motors.*.name", align="left"),
        constant("k", "number", "", "", list(range(1, n + 1))),
        given("inertia", "inertia", "J_M", "kg cm²",
              entered("inertia"), "selection.motors.*.inertia", format="0.000000##"),
        given("rated", "rated torque", "T_N", "Nm",
              entered("rated_torque"), "selection.motors.*.rated_torque", format="0.0##"),
        given("peak", "peak torque", "T_max", "Nm",
              entered("peak_torque"), "selection.motors.*.peak_torque", format="0.0##"),
        given("nmax", "largest speed", "n_max", "rpm",
              entered("max_speed"), "selection.motors.*.max_speed", format="0.##"),
        given("knee", "peak torque up to, if less", "n_1", "rpm",
              entered("full_torque_to"), "selection.motors.*.full_torque_to", format="0.##"),
        given("end", "peak torque at n_max, if less", "", "Nm",
              entered("end_torque"), "selection.motors.*.end_torque", format="0.0##"),
        given("mass", "mass", "", "kg", entered("mass"), "selection.motors.*.mass", format="0.0##"),
        given("cost", "cost", "", "", entered("cost"), "selection.motors.*.cost", format="0.##"),
        result("verdict", "has a range of τ?", "", "",
               '=IF([on]*sel_moves=0,"–",IF([enough]=0,"too weak",IF([low]<=[tau_max],"yes","too slow")))',
               filled(verdicts(view, ranges.strong, ranges.accepted, "too slow"), n, "–")),
        result("alpha", "accelerating factor", "α", "W/s",
               "=IF([on]=1,[rated]^2/([inertia]/10000),0)",
               filled(ranges.accelerating_factor, n), source="T_N²/J_M", format=WHOLE),
        result("tau_min", "least ratio", "τ_min", "",
               "=IF([enough]=1,2*SQRT([inertia]/10000)*sel_wrms/([wide]+[root]),0)",
               found(ranges.tau_min), source="S5, (14) with −", format=FINE),
        result("tau_max", "largest ratio", "τ_max", "",
               "=IF([enough]=1,SQRT([inertia]/10000)*([wide]+[root])*sel_eta/(2*sel_trms),0)",
               found(ranges.tau_max), source="S5, (14) with +", format=FINE),
        result("tau_opt", "best ratio", "τ_opt", "",
               "=IF([on]*sel_moves=1,SQRT([inertia]/10000*sel_wrms*sel_eta/sel_trms),0)",
               found(ranges.tau_opt), source="√(τ_min τ_max)", format=FINE),
        result("tau_lim", "ratio at n_max", "τ_lim", "",
               "=IF([on]*sel_moves=1,sel_wmax/([nmax]*2*PI()/60),0)",
               found(ranges.tau_limit), source="ω_L,max / ω_M,max", format=FINE),
        calc("low", "ratios from", "", "",
             "=MAX([tau_min],[tau_lim])",
             found(ranges.lowest), source="max(τ_min, τ_lim)", format=FINE),
        calc("on", "in use", "", "",
             "=COUNT([inertia])*COUNT([rated])*COUNT([peak])*COUNT([nmax])",
             filled(in_use, n, 0)),
        calc("enough", "strong enough", "", "",
             "=IF([on]*sel_moves=1,IF([alpha]>=sel_beta/sel_eta,1,0),0)",
             filled(ranges.strong.astype(int), n, 0), source="α ≥ β/η"),
        calc("root", "working", "", "",
             "=IF([enough]=1,SQRT([alpha]-sel_beta/sel_eta),0)",
             found(ranges.root), source="√(α − β/η)"),
        calc("wide", "working", "", "",
             "=IF([enough]=1,SQRT([root]^2+4*sel_wrms*sel_trms/sel_eta),0)",
             found(ranges.wide), source="√(α − β/η + 4 ω̇ T*/η)"),
        calc("corner", "peak torque holds to", "n_1", "rpm",
             "=IF(COUNT([knee])=1,[knee],[nmax])",
             filled(shown(m.knee, RPM), n)),
        calc("slope", "fall beyond", "", "Nm/rpm",
             "=IF(COUNT([knee])*([nmax]-[knee])>0,([end]-[peak])/([nmax]-[knee]),0)",
             filled(shown(m.slope, PER_RPM), n)),
        calc("has", "has the criterion's figure", "", "",
             "=CHOOSE(sel_no,1,1,COUNT([mass]),COUNT([cost]))",
             filled(has, n, spare_has(view))),
        calc("figure", "the criterion's figure", "", "",
             "=IF([has]=1,CHOOSE(sel_no,0,0,[mass],[cost]),0)",
             filled(figure, n)),
        given("source", "source", "", "", entered("source"), "selection.motors.*.source", align="left"),
        rules=[HALF, FALLING],
    )  # fmt: skip


def reducers(sheet: Sheet, view: Choosing) -> None:
    """Declare the reducers: what is entered, and what each does to the load."""
    rows, r, n, load = view.given.reducers, view.reducers, view.rooms[1], view.at_motor
    sizes = load_at_motor(view.sizes, r)
    has, figure = criterion_figures(view, rows)
    in_use = filled([], len(rows), 1)

    def entered(entry: str) -> list[Any]:
        return filled([getattr(row, entry) for row in rows], n, None)

    sheet.book.column_names["reducer_name"] = ("reducers", "name")
    sheet.table(
        "reducers", "Reducers (S5, steps 1, 5 and 7)", n,
        given("name", "reducer", "", "", entered("name"), "selection.reducers.*.name", align="left"),
        constant("k", "number", "", "", list(range(1, n + 1))),
        given("i", "reduction", "i", "", entered("reduction"), "selection.reducers.*.reduction", format="0.0##"),
        given("eta", "efficiency", "η", "", entered("efficiency"), "selection.reducers.*.efficiency", format="0.0##"),
        given("inertia", "inertia at the input", "J_T", "kg cm²",
              entered("inertia"), "selection.reducers.*.inertia", format="0.000000##"),
        given("nmax", "largest input speed", "", "rpm",
              entered("max_speed"), "selection.reducers.*.max_speed", format="0.##"),
        given("tmax", "largest output torque", "", "Nm",
              entered("max_torque"), "selection.reducers.*.max_torque", format="0.0##"),
        given("mass", "mass", "", "kg", entered("mass"), "selection.reducers.*.mass", format="0.0##"),
        given("cost", "cost", "", "", entered("cost"), "selection.reducers.*.cost", format="0.##"),
        result("verdict", "holds the load?", "", "",
               '=IF([on]*sel_moves=0,"–",IF([strong]=0,"too weak",IF([fits]=1,"yes","too fast")))',
               filled(verdicts(view, load.strong, load.fits, "too fast"), n, "–")),
        result("tau", "ratio", "τ", "",
               "=IF([on]=1,1/[i],0)",
               filled(r.ratio, n), source="1/i", format=FINE),
        calc("speed", "speed of the motor", "n_M", "rpm",
             "=IF([on]=1,sel_wmax*[i]*60/(2*PI()),0)",
             filled(shown(load.speed, RPM), n), source="ω_L,max/τ", format=BLANK),
        calc("load", "load's RMS at the motor", "", "Nm",
             "=IF([on]=1,[tau]*sel_trms/[eta],0)",
             filled(load.torque_rms, n), source="τ T*_rms/η", format=BLANK),
        calc("acc", "RMS acceleration of the motor", "", "rad/s²",
             "=IF([on]=1,sel_wrms*[i],0)",
             filled(load.acceleration_rms, n), source="ω̇_rms/τ", format=BLANK,
             scale=float(sizes.acceleration_rms.max())),
        calc("cross", "mean product", "", "",
             "=IF([on]=1,2*sel_mean/[eta],0)",
             filled(load.product, n), source="2 (ω̇ T*)_mean/η", format=BLANK,
             scale=max(view.sizes.power_rate_mean, 1e-3)),
        calc("match", "inertia that balances", "", "kg cm²",
             "=IF([on]*sel_moves=1,[tau]^2/[eta]*sel_trms/sel_wrms*10000,0)",
             filled(shown(np.nan_to_num(load.balancing), KG_CM2), n), source="τ² T*_rms / (η ω̇_rms)", format=SMALL),
        calc("on", "in use", "", "",
             "=COUNT([i])*COUNT([eta])",
             filled(in_use, n, 0)),
        calc("strong", "strong enough", "", "",
             "=IF([on]=1,IF(COUNT([tmax])=0,1,IF(sel_tmax<=[tmax],1,0)),0)",
             filled(load.strong.astype(int), n, 0), source="f T*_max"),
        calc("fits", "and not too fast", "", "",
             "=IF([strong]=1,IF(COUNT([nmax])=0,1,IF([speed]<=[nmax],1,0)),0)",
             filled(load.fits.astype(int), n, 0)),
        calc("has", "has the criterion's figure", "", "",
             "=CHOOSE(sel_no,1,1,COUNT([mass]),COUNT([cost]))",
             filled(has, n, spare_has(view))),
        calc("figure", "the criterion's figure", "", "",
             "=IF([has]=1,CHOOSE(sel_no,0,0,[mass],[cost]),0)",
             filled(figure, n)),
        given("source", "source", "", "", entered("source"), "selection.reducers.*.source", align="left"),
    )  # fmt: skip


def verdicts(view: Choosing, strong: NDArray[np.bool_], good: NDArray[np.bool_], fails: str) -> list[str]:
    """Return the verdict on each product in words; ``fails`` says what a strong one that is not good is."""
    if not view.task.moves:
        return filled([], len(good), "–")
    return ["yes" if g else fails if s else "too weak" for s, g in zip(strong, good, strict=True)]


def criterion_figures(view: Choosing, rows: Sequence[MotorRow | ReducerRow]) -> tuple[list[int], list[float]]:
    """Return for each product whether it has the figure that the criterion reads, and that figure."""
    entry = FIGURES.get(view.given.criterion)
    if entry is None:
        return filled([], len(rows), 1), filled([], len(rows))
    values = figures(rows, entry)
    return np.isfinite(values).astype(int).tolist(), np.nan_to_num(values).tolist()


def spare_has(view: Choosing) -> int:
    """Return what a spare row says of the criterion's figure: that it has it, where the criterion reads none."""
    return 0 if view.given.criterion in FIGURES else 1
