"""Tables of the Selection sheet: motors and reducers with steps 3 to 5, the pairs, and the best of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from engine.laws.base import Array
from workbook.book.declare import Sheet, calc, constant, given, result
from workbook.entries.units import RPM
from workbook.selection.view import Choosing

BEST = 10  # rows of the ranking
BLANK = '0.0##;-0.0##;"–"'  # a row without a pair shows a dash
FINE = '0.0000##;-0.0000##;"–"'
WHOLE = '0;-0;"–"'
SMALL = '0.000000##;-0.000000##;"–"'


def column(rows: Sequence[Any], entry: str, room: int) -> list[Any]:
    """Return an entry of each row, nothing in the spare rows."""
    return [getattr(row, entry) for row in rows] + [None] * (room - len(rows))


def padded(values: Any, room: int, other: Any = 0.0) -> list[Any]:
    """Return values as a column, ``other`` in the spare rows."""
    found = list(values.tolist() if hasattr(values, "tolist") else values)
    return found + [other] * (room - len(found))


def ranking(sheet: Sheet, view: Choosing) -> None:
    """Declare the best pairs, in order."""
    found = view.ranking
    n = min(len(found), BEST)
    m, r = found.motor[:n], found.reducer[:n]

    def at(column: str, row: str, table: str) -> str:
        return f"=IF([at]>0,INDEX([{table}.{column}],INDEX([pairs.{row}],[at])),0)"

    ratio = "INDEX([reducers.match],INDEX([pairs.r],MAX([at],1)))/INDEX([pairs.total],MAX([at],1))"

    sheet.row += 1
    motor_names = [view.motors.names[i] for i in m]
    reducer_names = [view.reducers.names[j] for j in r]
    sheet.table(
        "ranking", "The best pairs (S5, step 6)", BEST,
        result("motor", "motor", "", "",
               '=IF([at]>0,INDEX([motors.name],INDEX([pairs.m],[at])),"–")', padded(motor_names, BEST, "–"),
               align="left"),
        constant("place", "place", "", "", list(range(1, BEST + 1))),
        calc("at", "row among the pairs", "", "",
             "=IF([place]<=sel_count,MATCH(SMALL([pairs.key],[place]),[pairs.key],0),0)",
             padded(view.row(found)[:n], BEST, 0), format=WHOLE),
        calc("i", "reduction", "i", "",
             at("i", "r", "reducers"), padded(1.0 / view.reducers.ratio[r], BEST), format=BLANK),
        result("rms", "RMS torque", "T_rms", "Nm",
               "=IF([at]>0,INDEX([pairs.rms],[at]),0)", padded(found.rms_torque[:n], BEST), format=BLANK),
        result("margin", "margin", "", "",
               "=IF([at]>0,INDEX([motors.rated],INDEX([pairs.m],[at]))/[rms],0)", padded(found.margin[:n], BEST),
               format=BLANK),
        result("match", "off the best ratio by", "", "",
               f"=IF([at]>0,EXP(ABS(LN({ratio}))/2),0)", padded(found.mismatch[:n], BEST), format=BLANK),
        calc("score", "score, the lowest best", "", "",
             "=IF([at]>0,INDEX([pairs.score],[at]),0)", padded(view.scores[m, r], BEST), format=FINE),
        result("reducer", "reducer", "", "",
               '=IF([at]>0,INDEX([reducers.name],INDEX([pairs.r],[at])),"–")', padded(reducer_names, BEST, "–"),
               align="left"),
    )  # fmt: skip


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
    s, n = view.given, view.rooms[0]

    def entered(entry: str) -> list[Any]:
        return column(s.motors, entry, n)

    x = motor_values(view)
    sheet.table(
        "motors", "Motors (S5, steps 1, 3 and 4)", n,
        given("name", "motor", "", "", entered("name"), "selection.motors.*.name", align="left"),
        constant("k", "number", "", "", list(range(1, n + 1))),
        given("inertia", "inertia", "J_M", "kg m²",
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
               x["verdict"]),
        result("alpha", "accelerating factor", "α", "Nm rad/s²",
               "=IF([on]=1,[rated]^2/[inertia],0)", x["alpha"], source="T_N²/J_M", format="0;-0;\"–\""),
        result("tau_min", "least ratio", "τ_min", "",
               "=IF([enough]=1,2*SQRT([inertia])*sel_wrms/([wide]+[root]),0)", x["tau_min"], source="S5, (14) with −",
               format=FINE),
        result("tau_max", "largest ratio", "τ_max", "",
               "=IF([enough]=1,SQRT([inertia])*([wide]+[root])*sel_eta/(2*sel_trms),0)", x["tau_max"],
               source="S5, (14) with +", format=FINE),
        result("tau_opt", "best ratio", "τ_opt", "",
               "=IF([on]*sel_moves=1,SQRT([inertia]*sel_wrms*sel_eta/sel_trms),0)", x["tau_opt"],
               source="√(τ_min τ_max)", format=FINE),
        result("tau_lim", "ratio at n_max", "τ_lim", "",
               "=IF([on]*sel_moves=1,sel_wmax/([nmax]*2*PI()/60),0)", x["tau_lim"], source="ω_L,max / ω_M,max",
               format=FINE),
        calc("low", "ratios from", "", "",
             "=MAX([tau_min],[tau_lim])", x["low"], source="max(τ_min, τ_lim)", format=FINE),
        calc("on", "in use", "", "", "=COUNT([inertia])*COUNT([rated])*COUNT([peak])*COUNT([nmax])", x["on"]),
        calc("enough", "strong enough", "", "",
             "=IF([on]*sel_moves=1,IF([alpha]>=sel_beta/sel_eta,1,0),0)", x["enough"], source="α ≥ β/η"),
        calc("root", "working", "", "",
             "=IF([enough]=1,SQRT([alpha]-sel_beta/sel_eta),0)", x["root"], source="√(α − β/η)"),
        calc("wide", "working", "", "",
             "=IF([enough]=1,SQRT([root]^2+4*sel_wrms*sel_trms/sel_eta),0)", x["wide"], source="√(α − β/η + 4 ω̇ T*/η)"),
        calc("corner", "peak torque holds to", "n_1", "rpm", "=IF(COUNT([knee])=1,[knee],[nmax])", x["corner"]),
        calc("slope", "fall beyond", "", "Nm/rpm",
             "=IF(COUNT([knee])*([nmax]-[knee])>0,([end]-[peak])/([nmax]-[knee]),0)", x["slope"]),
        calc("has", "has the criterion's figure", "", "", "=CHOOSE(sel_no,1,1,COUNT([mass]),COUNT([cost]))", x["has"]),
        calc("figure", "the criterion's figure", "", "",
             "=IF([has]=1,CHOOSE(sel_no,0,0,[mass],[cost]),0)", x["figure"]),
        given("source", "source", "", "", entered("source"), "selection.motors.*.source", align="left"),
    )  # fmt: skip


def motor_values(view: Choosing) -> dict[str, list[Any]]:
    """Return the engine's values for the columns of the motors."""
    m, n, ranges, a = view.motors, view.rooms[0], view.ranges, view.asked
    count = len(m.names)
    nothing = np.zeros(count)
    alpha = m.rated_torque**2 / m.inertia
    names = ("tau_min", "tau_max", "tau_opt", "tau_limit", "lowest")
    found = dict.fromkeys(names, nothing) if ranges is None else {f: np.nan_to_num(getattr(ranges, f)) for f in names}
    enough = np.zeros(count, bool) if ranges is None else np.isfinite(ranges.tau_max)
    verdict = ["–"] * count
    if ranges is not None:
        verdict = [
            "yes" if good else "too slow" if strong else "too weak"
            for good, strong in zip(ranges.accepted, enough, strict=True)
        ]
    eta = view.given.efficiency
    root = np.sqrt(np.where(enough, alpha - a.load_factor / eta, 0.0))
    wide = np.where(enough, np.sqrt(root**2 + 4.0 * a.acceleration_rms * a.torque_rms / eta), 0.0)
    has, figure = criterion_figures(view, view.given.motors)
    rows = view.given.motors
    corner = [r.max_speed if r.full_torque_to is None else r.full_torque_to for r in rows]
    slope = [0.0 if r.end_torque is None else (r.end_torque - r.peak_torque) / (r.max_speed - c) for r, c in zip(rows,
        corner, strict=True)]  # fmt: skip
    spare_has = 0 if view.given.criterion in ("size", "cost") else 1
    return {
        "verdict": padded(verdict, n, "–"), "alpha": padded(alpha, n),
        "tau_min": padded(found["tau_min"], n), "tau_max": padded(found["tau_max"], n),
        "tau_opt": padded(found["tau_opt"], n), "tau_lim": padded(found["tau_limit"], n),
        "low": padded(np.fmax(found["tau_min"], found["tau_limit"]), n),
        "on": padded([1] * count, n, 0), "enough": padded(enough.astype(int), n, 0),
        "root": padded(root, n), "wide": padded(wide, n), "corner": padded(corner, n), "slope": padded(slope, n),
        "has": padded(has, n, spare_has), "figure": padded(figure, n),
    }  # fmt: skip


def criterion_figures(view: Choosing, rows: Sequence[Any]) -> tuple[list[int], list[float]]:
    """Return for each product whether it has the figure that the criterion reads, and that figure."""
    name = {"size": "mass", "cost": "cost"}.get(view.given.criterion)
    if name is None:
        return [1] * len(rows), [0.0] * len(rows)
    figures = [getattr(row, name) for row in rows]
    return [int(f is not None) for f in figures], [0.0 if f is None else f for f in figures]


def reducers(sheet: Sheet, view: Choosing) -> None:
    """Declare the reducers: what is entered, and what each does to the load."""
    s, n = view.given, view.rooms[1]

    def entered(entry: str) -> list[Any]:
        return column(s.reducers, entry, n)

    x = reducer_values(view)
    sheet.table(
        "reducers", "Reducers (S5, steps 1, 5 and 7)", n,
        given("name", "reducer", "", "", entered("name"), "selection.reducers.*.name", align="left"),
        constant("k", "number", "", "", list(range(1, n + 1))),
        given("i", "reduction", "i", "", entered("reduction"), "selection.reducers.*.reduction", format="0.0##"),
        given("eta", "efficiency", "η", "", entered("efficiency"), "selection.reducers.*.efficiency", format="0.0##"),
        given("inertia", "inertia at the input", "J_T", "kg m²",
              entered("inertia"), "selection.reducers.*.inertia", format="0.000000##"),
        given("nmax", "largest input speed", "", "rpm",
              entered("max_speed"), "selection.reducers.*.max_speed", format="0.##"),
        given("tmax", "largest output torque", "", "Nm",
              entered("max_torque"), "selection.reducers.*.max_torque", format="0.0##"),
        given("mass", "mass", "", "kg", entered("mass"), "selection.reducers.*.mass", format="0.0##"),
        given("cost", "cost", "", "", entered("cost"), "selection.reducers.*.cost", format="0.##"),
        result("verdict", "holds the load?", "", "",
               '=IF([on]*sel_moves=0,"–",IF([strong]=0,"too weak",IF([fits]=1,"yes","too fast")))', x["verdict"]),
        result("tau", "ratio", "τ", "", "=IF([on]=1,1/[i],0)", x["tau"], source="1/i", format=FINE),
        calc("speed", "speed of the motor", "n_M", "rpm",
             "=IF([on]=1,sel_wmax*[i]*60/(2*PI()),0)", x["speed"], source="ω_L,max/τ", format=BLANK),
        calc("load", "load's RMS at the motor", "", "Nm",
             "=IF([on]=1,[tau]*sel_trms/[eta],0)", x["load"], source="τ T*_rms/η", format=BLANK),
        calc("acc", "RMS acceleration of the motor", "", "rad/s²",
             "=IF([on]=1,sel_wrms*[i],0)", x["acc"], source="ω̇_rms/τ", scale=x["acc_scale"], format=BLANK),
        calc("cross", "mean product", "", "",
             "=IF([on]=1,2*sel_mean/[eta],0)", x["cross"], source="2 (ω̇ T*)_mean/η", scale=max(x["cross_scale"], 1e-3),
             format=BLANK),
        calc("match", "inertia that balances", "", "kg m²",
             "=IF([on]*sel_moves=1,[tau]^2/[eta]*sel_trms/sel_wrms,0)", x["match"], source="τ² T*_rms / (η ω̇_rms)",
             format=SMALL),
        calc("on", "in use", "", "", "=COUNT([i])*COUNT([eta])", x["on"]),
        calc("strong", "strong enough", "", "",
             "=IF([on]=1,IF(COUNT([tmax])=0,1,IF(sel_tmax<=[tmax],1,0)),0)", x["strong"], source="f T*_max"),
        calc("fits", "and not too fast", "", "",
             "=IF([strong]=1,IF(COUNT([nmax])=0,1,IF([speed]<=[nmax],1,0)),0)", x["fits"]),
        calc("has", "has the criterion's figure", "", "", "=CHOOSE(sel_no,1,1,COUNT([mass]),COUNT([cost]))", x["has"]),
        calc("figure", "the criterion's figure", "", "",
             "=IF([has]=1,CHOOSE(sel_no,0,0,[mass],[cost]),0)", x["figure"]),
        given("source", "source", "", "", entered("source"), "selection.reducers.*.source", align="left"),
    )  # fmt: skip


def reducer_values(view: Choosing) -> dict[str, Any]:
    """Return the engine's values for the columns of the reducers."""
    r, n, a = view.reducers, view.rooms[1], view.asked
    count = len(r.names)
    speed = a.max_speed / r.ratio
    fits = view.strong & (speed <= r.max_input_speed)
    verdict = ["–"] * count
    if a.task:
        verdict = [
            "yes" if good else "too fast" if strong else "too weak"
            for good, strong in zip(fits, view.strong, strict=True)
        ]
    match = r.ratio**2 / r.efficiency * (a.torque_rms / a.acceleration_rms) if a.task else np.zeros(count)
    has, figure = criterion_figures(view, view.given.reducers)
    spare_has = 0 if view.given.criterion in ("size", "cost") else 1
    return {
        "verdict": padded(verdict, n, "–"), "tau": padded(r.ratio, n), "speed": padded(speed / RPM, n),
        "load": padded(r.ratio * a.torque_rms / r.efficiency, n), "acc": padded(a.acceleration_rms / r.ratio, n),
        "cross": padded(2.0 * a.power_rate_mean / r.efficiency,
                        n), "cross_scale": view.acceleration_scale * a.torque_rms,
        "acc_scale": view.acceleration_scale / float(r.ratio.min()),
        "match": padded(match, n), "on": padded([1] * count, n, 0), "strong": padded(view.strong.astype(int), n, 0),
        "fits": padded(fits.astype(int), n, 0), "has": padded(has, n, spare_has), "figure": padded(figure, n),
    }  # fmt: skip


def pairs(sheet: Sheet, view: Choosing) -> None:
    """Declare every pair: its RMS torque with the reducer's η and inertia, whether it is usable, what it is sorted by."""
    down, across = view.rooms
    k = np.arange(down * across)
    x = pair_values(view)
    score = (
        "=IF([counts]=1,CHOOSE(sel_no,[rms]/INDEX([motors.rated],[m]),"
        "EXP(ABS(LN(INDEX([reducers.match],[r])/[total]))/2),"
        "INDEX([motors.figure],[m])+INDEX([reducers.figure],[r]),"
        "INDEX([motors.figure],[m])+INDEX([reducers.figure],[r])),0)"
    )
    sheet.heading("Every pair")
    sheet.table(
        "pairs", "Pairs in the order of the tables", len(k),
        constant("k", "pair", "", "", (k + 1).tolist()),
        constant("m", "motor", "", "", (k // across + 1).tolist()),
        constant("r", "reducer", "", "", (k % across + 1).tolist()),
        calc("total", "inertia", "J", "kg m²",
             ("=IF(INDEX([motors.on],[m])*INDEX([reducers.on],[r])*sel_moves=1,INDEX([motors.inertia],"
              "[m])+INDEX([reducers.inertia],[r]),0)"), x["total"], source="J_M + J_T", format=SMALL),
        result("rms", "RMS torque", "T_rms", "Nm",
               ("=IF([total]>0,SQRT(MAX(0,INDEX([reducers.load],[r])^2+([total]*INDEX([reducers.acc],"
                "[r]))^2+[total]*INDEX([reducers.cross],[r]))),0)"), x["rms"],
               source="√((τ T*/η)² + (J ω̇/τ)² + 2 J (ω̇T*)/η)", format=BLANK),
        result("usable", "usable", "", "",
               ("=IF([total]*INDEX([reducers.fits],[r])>0,IF(AND([rms]<=INDEX([motors.rated],[m]),"
                "INDEX([reducers.speed],[r])<=INDEX([motors.nmax],[m])),1,0),0)"), x["usable"],
               source="torques and speeds", format=WHOLE),
        calc("counts", "ranked", "", "",
             "=[usable]*INDEX([motors.has],[m])*INDEX([reducers.has],[r])", x["counts"], source="has the figures",
             format=WHOLE),
        result("score", "score, the lowest best", "", "", score, x["score"], source="by the criterion", format=FINE),
        calc("key", "sorted by", "", "",
             '=IF([counts]=1,ROUND([score]/sel_unit,sel_places)+[k]*sel_step,"–")', x["key"], source="score, then row",
             format="0.0000000000"),
    )  # fmt: skip


def pair_values(view: Choosing) -> dict[str, list[Any]]:
    """Return the engine's values for the columns of the pairs, spare rows included."""
    counts, keys = spread(view, view.ranked.astype(int)), spread(view, view.keys)
    inertia = view.motors.inertia[:, None] + view.reducers.inertia
    total = inertia if view.asked.task else np.zeros(inertia.shape)
    return {
        "total": spread(view, total), "rms": spread(view, view.rms),
        "usable": spread(view, view.usable.astype(int)), "counts": counts, "score": spread(view, view.scores),
        "key": [key if ranked else "–" for key, ranked in zip(keys, counts, strict=True)],
    }  # fmt: skip


def spread(view: Choosing, table: Array) -> list[Any]:
    """Return a figure of each pair as one column, 0 where a row of a table is spare."""
    whole = np.zeros(view.rooms, dtype=table.dtype)
    whole[: table.shape[0], : table.shape[1]] = table
    return whole.ravel().tolist()
