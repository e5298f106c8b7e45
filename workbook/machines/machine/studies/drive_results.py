"""The results and checks of the drive of an axis in many designs, by the names of the cells that have them in the book.

Checks are by the points of its cycle, and by the exact engine.
"""

from collections.abc import Callable
from functools import cache, lru_cache, partial
from operator import attrgetter
from typing import Any

import numpy as np

from engine.drive.motor import continuous
from engine.selection.point_load import PointLoad, shares_of
from workbook.book.quantity import FAIL, OK
from workbook.fields.units import KG_CM2, KW, shown
from workbook.machines.machine.drive.by_angle import ends_in_place
from workbook.machines.machine.drive.in_use import IN_USE, UNITS
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.entries import MOST_AXES
from workbook.machines.machine.exact import limit_of_creeping, limit_of_rate, limits_of
from workbook.machines.machine.first_sheet import hold_at
from workbook.machines.machine.mechanism import LINKED
from workbook.machines.machine.studies.drives import WEIGHED, DriveStudy
from workbook.template_outputs import Computations, JudgedLimit

LIMITED: dict[str, Callable[[DriveStudy], tuple[Any, Any]]] = {
    "ok_rms": lambda study: (study.rms, study.continuous),
    "ok_peak": lambda study: (study.extremes.peak, study.motors_used["peak_torque"]),
    "ok_speed": lambda study: (study.speed, study.motors_used["max_speed"]),
    "ok_reducer_peak": lambda study: (study.behind(0), study.reducer_held_at(1.0 / study.time)),
    "ok_reducer_mean": lambda study: (study.behind(1), study.reducers_used["mean_torque"]),
    "ok_reducer_speed": lambda study: (study.speed, study.reducers_used["max_speed"]),
}
"""of each check what is asked, and the limit, 0 for none"""
ASKED = 0.9  # share of a limit from which the exact engine is asked too: of all bounds that sheets state the tenfold


RESULTS: dict[str, Callable[[DriveStudy], Any]] = {
    "rate": lambda study: study.rates.each,
    "jtot": lambda study: shown(study.at_motor, KG_CM2),
    "j_all": lambda study: shown(study.motors_used["inertia"] + study.at_motor, KG_CM2),
    "inertias": lambda study: study.inertias,
    "largest": lambda study: study.extremes.peak,
    "tmax": lambda study: study.extremes.torque,
    "tmin": lambda study: study.extremes.torque_low,
    "rms": lambda study: study.rms,
    "speed": lambda study: study.speed,
    "mean": lambda study: study.mean,
    "continuous": lambda study: study.continuous,
    "res_rms": lambda study: shares_of(study.continuous * study.limits.rms_reserve, study.rms),
    "res_peak": lambda study: shares_of(
        study.motors_used["peak_torque"] * study.limits.peak_reserve, study.extremes.peak
    ),
    "res_speed": lambda study: shares_of(study.motors_used["max_speed"] * study.limits.speed_reserve, study.speed),
    "use_rms": lambda study: shares_of(*LIMITED["ok_rms"](study)),
    "use_peak": lambda study: shares_of(*LIMITED["ok_peak"](study)),
    "use_speed": lambda study: shares_of(*LIMITED["ok_speed"](study)),
    "use_reducer": lambda study: shares_of(*LIMITED["ok_reducer_peak"](study)),
    "use_mean": lambda study: shares_of(*LIMITED["ok_reducer_mean"](study)),
    "use_input": lambda study: shares_of(*LIMITED["ok_reducer_speed"](study)),
    "use_inertia": lambda study: study.inertias / study.limits.inertia_ratio,
    "smax": lambda study: study.behind(0),
    "smean": lambda study: study.behind(1),
    "energy": lambda study: study.works.driving,
    "returned": lambda study: study.works.regenerated,
    "power": lambda study: shown(study.works.net / study.time, KW),
    "pmax": lambda study: shown(np.maximum(0.0, study.extremes.power), KW),
    "pmin": lambda study: shown(np.minimum(0.0, study.extremes.power_low), KW),
    "highest": lambda study: study.ends("high")[0],
    "binds": lambda study: study.ends("high")[1],
    "lowest": lambda study: study.ends("low")[0],
    "binds_low": lambda study: study.ends("low")[1],
    "t_hold": lambda study: study.holding_torque,
    "reducer_held": lambda study: study.reducer_held_at(1.0 / study.time),
} | {f"pair_{name}": lambda study, name=name: study.motors_used[name] + study.reducers_used[name] for name in WEIGHED}

SLOW = ("highest", "binds", "lowest", "binds_low", "t_hold")
"""results for which the points of each design are worked out"""


def results(study: DriveStudy) -> Computations:
    """Return all results by name, each worked out when it is called."""
    asked = RESULTS | ({"brake_load": lambda study: study.brake_load} if study.bases[0].brakes else {})
    asked |= {"spare": lambda study: study.extremes.spare} if study.products.knows_falling else {}
    weighed = [(product, f"{product}_{name}", name) for product in ("motor", "reducer") for name in WEIGHED]
    for product, cell, name in (*zip(*IN_USE.values(), strict=True), *weighed):
        used = attrgetter(f"{product}s_used")
        asked[cell] = lambda study, used=used, name=name: shown(used(study)[name], UNITS.get(name, 1.0))
    return {f"drive{study.axis.number}_{name}": partial(figure, study) for name, figure in asked.items()}


def within(limit: Callable[[DriveStudy], tuple[Any, Any]], study: DriveStudy) -> Any:
    """Return whether what is asked is within its limit."""
    value, most = limit(study)
    return (most == 0.0) | (value <= most)


def below_curve(study: DriveStudy) -> Any:
    """Return whether torques stay below the motor's curve; they do not where the book does not know the curve."""
    return (study.motors_used["fall"] == 0.0) | (study.products.knows_falling & (study.extremes.spare >= 0.0))


@lru_cache(maxsize=MOST_AXES)
def creep_use(study: DriveStudy) -> Any:
    """Return the largest use of a torque's limit in each design, creeping."""
    loads = [PointLoad(base.creeping.load, 0.0, 0.0, 0.0) for base in study.bases]
    rms, spare = study.gathered(lambda _, many: (many.load.rms(many.gears), many.extremes.spare), loads)
    motor, slow = study.motors_used, study.of_rate(attrgetter("slow"))
    stall, rated, peak = motor["stall_torque"], motor["rated_torque"], motor["peak_torque"]
    uses = [rms / continuous(rated, stall, motor["rated_speed"], study.mean * slow), (peak - spare) / peak]
    behind = np.array([[check.value for check in base.creep_checks[2:]] for base in study.bases])
    limits = study.reducer_held_at(slow / study.time), study.reducers_used["mean_torque"]
    for value, limit in zip(behind[study.rates.places].T, limits, strict=True):
        uses.append(value / np.where(limit == 0.0, np.inf, limit))
    return np.maximum.reduce(np.broadcast_arrays(*uses))


CHECKS = {name: partial(within, limit) for name, limit in LIMITED.items()} | {
    "ok_creep": lambda study: creep_use(study) <= 1.0,
    "ok_curve": below_curve,
    "ok_inertia": lambda study: study.inertias <= study.limits.inertia_ratio,
    "ok_shaft": lambda study: (
        (study.reducers_used["hub"] == 0.0) | (study.motors_used["shaft"] <= study.reducers_used["hub"])
    ),
    "ok_mass": lambda study: (
        (study.limits.largest_mass == 0.0)
        | (study.motors_used["known_mass"] + study.reducers_used["known_mass"] <= study.limits.largest_mass)
    ),
}


def judged_exactly(study: DriveStudy) -> Computations:
    """Return by check which designs keep to a limit by the exact engine, each worked out when it is called."""

    def judged(view: DriveView) -> list[JudgedLimit]:
        return [*limits_of(view), *limit_of_creeping(view)]

    @cache
    def limits() -> list[dict[str, bool]]:
        asked = [limit(study) for limit in LIMITED.values()]
        uses = [value / np.where(most == 0.0, np.inf, most) for value, most in asked]
        uses.append(1.0 - study.extremes.spare / study.motors_used["peak_torque"])
        uses.append(creep_use(study))
        near = np.maximum.reduce(np.broadcast_arrays(*uses, study.rates.places)[:-1]) >= ASKED
        some = {study.designs[k] for k in np.flatnonzero(near).tolist()}
        by_design = {design: {limit.check: limit.ok for limit in judged(study.view(*design))} for design in some}
        return [by_design.get(design, {}) for design in study.designs]

    def judge(check: str) -> Any:
        return ok_texts(np.array([verdicts.get(check, True) for verdicts in limits()]))

    return {name: partial(judge, name) for name in (f"drive{study.axis.number}_{check}" for check in CHECKS)}


def at_machine_rate(study: DriveStudy, rates: Any, judge: Callable[[DriveView, float], bool]) -> Any:
    """Return the judgement of the drive of each design at the machine's rate (cycles/min)."""
    places, each = np.broadcast_arrays(np.arange(len(study.designs)), rates)
    views = [study.views[study.designs[k]] for k in places.tolist()]
    return np.array([judge(*both) for both in zip(views, each.tolist(), strict=True)])


def hold_machine_rate(study: DriveStudy, rates: Any) -> Any:
    """Return in which designs the machine's rate (cycles/min) is within the drive's range, by its points."""
    if study.axis.given.rate is not None:
        return at_machine_rate(study, rates, lambda view, rate: hold_at(rate, view.rates))
    held = [within(limit, study) for limit in LIMITED.values()]
    falling = [below_curve(study)] if study.products.knows_falling else []
    return np.logical_and.reduce(np.broadcast_arrays(*held, *falling))


def hold_machine_rate_exactly(study: DriveStudy, rates: Any, judged: Computations) -> Any:
    """Return the same by the exact engine, which ``judged`` the drive at the rate that it is sized at."""

    def is_held(view: DriveView, rate: float) -> bool:
        nearly = max(view.search.at(rate / view.rate).uses.values()) >= ASKED
        return not nearly or limit_of_rate(view, [], rate).exact.ok

    if study.axis.given.rate is not None:
        return at_machine_rate(study, rates, is_held)
    at_rate = [verdict() == OK for name, verdict in judged.items() if not name.endswith("_ok_creep")]
    return np.logical_and.reduce(at_rate)


def ok_texts(ok: Any) -> Any:
    """Return in words which checks hold."""
    return np.where(ok, OK, FAIL)


def checks(study: DriveStudy) -> Computations:
    """Return the checks of its sheet that entries do not decide."""
    driven = study.bases[0].driven
    judged = CHECKS | ({"ok_back": lambda study: study.axis.motion.closes} if driven.given.kind in LINKED else {})
    judged |= {"ok_brake": lambda study: study.brake_load <= driven.brake.torque} if study.bases[0].brakes else {}
    judged |= {"ok_turned": lambda study: len(study.bases[0].tables.turns) == study.bases[0].turns_cut}
    judged |= {"ok_turns": lambda _: ends_in_place(driven)} if driven.by_angle else {}
    return {
        f"drive{study.axis.number}_{key}": partial(lambda ok: ok_texts(ok(study)), ok) for key, ok in judged.items()
    }
