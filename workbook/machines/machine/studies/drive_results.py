"""The results of many designs of a drive by the names of their cells."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.selection.point_load import shares_of
from workbook.entries.units import KG_CM2, KW, shown
from workbook.machines.machine.drive.by_angle import ends_in_place
from workbook.machines.machine.mechanism import LINKED
from workbook.machines.machine.studies.drives import WEIGHED, Studied, in_words
from workbook.scaling import Worked

ASKED: dict[str, Callable[[Studied], Any]] = {
    "rate": lambda one: one.rates.each,
    "jtot": lambda one: shown(one.at_motor, KG_CM2),
    "inertias": lambda one: shares_of(one.at_motor, one.motors_used["inertia"]),
    "tmax": lambda one: one.extremes.torque,
    "tmin": lambda one: one.extremes.torque_low,
    "rms": lambda one: one.rms,
    "speed": lambda one: one.speed,
    "mean": lambda one: one.mean,
    "continuous": lambda one: one.continuous,
    "res_rms": lambda one: shares_of(one.continuous, one.rms),
    "res_peak": lambda one: shares_of(one.motors_used["peak_torque"], one.extremes.peak),
    "res_speed": lambda one: shares_of(one.motors_used["max_speed"], one.speed),
    "smax": lambda one: one.behind(0),
    "smean": lambda one: one.behind(1),
    "energy": lambda one: one.works.driving,
    "returned": lambda one: one.works.regenerated,
    "power": lambda one: shown((one.works.driving - one.works.regenerated) / one.time, KW),
    "pmax": lambda one: shown(np.maximum(0.0, one.extremes.power), KW),
    "pmin": lambda one: shown(np.minimum(0.0, one.extremes.power_low), KW),
    "highest": lambda one: one.highest,
    "binds": lambda one: one.binds,
    "reducer_held": lambda one: one.reducer_held,
} | {f"pair_{name}": lambda one, name=name: one.motors_used[name] + one.reducers_used[name] for name in WEIGHED}
PRODUCTS = {
    "motors_used": {
        "motor_row": "row", "jm": "inertia", "motor_rated": "rated_torque", "motor_peak": "peak_torque",
        "motor_nmax": "max_speed", "motor_stall": "stall_torque", "motor_nn": "rated_speed",
        "motor_mass": "mass", "motor_cost": "cost",
    },
    "reducers_used": {
        "reducer_row": "row", "i1": "ratio", "eta1": "efficiency", "j_reducer": "inertia", "no_load": "no_load_torque",
        "reducer_peak": "peak_torque", "reducer_mean": "mean_torque", "reducer_nmax": "max_speed",
        "reducer_full": "full_cycles", "reducer_fs": "cycle_factor",
        "reducer_mass": "mass", "reducer_cost": "cost",
    },
}  # fmt: skip
"""of motors and of reducers: the cells of their figures"""


def within(limits: Array, value: Any) -> Any:
    """Return whether what is asked of the reducer is within its limits, 0 for none."""
    return (limits == 0.0) | (value <= limits)


def below_curve(one: Studied) -> Any:
    """Return whether torques stay below the motor's curve; of a curve that the book does not know they do not."""
    level = one.motors_used["fall"] == 0.0
    return level | (one.extremes.spare >= 0.0) if one.products.knows_falling else level


CHECKS: dict[str, Callable[[Studied], Any]] = {
    "ok_rms": lambda one: one.rms <= one.continuous,
    "ok_peak": lambda one: one.extremes.peak <= one.motors_used["peak_torque"],
    "ok_speed": lambda one: one.speed <= one.motors_used["max_speed"],
    "ok_curve": below_curve,
    "ok_reducer_peak": lambda one: within(one.reducer_held, one.behind(0)),
    "ok_reducer_mean": lambda one: within(one.reducers_used["mean_torque"], one.behind(1)),
    "ok_reducer_speed": lambda one: within(one.reducers_used["max_speed"], one.speed),
}


def results(one: Studied) -> Worked:
    """Return all results by name, each worked out when it is called."""
    found: Worked = {name: partial(figure, one) for name, figure in ASKED.items()}
    for used, cells in PRODUCTS.items():
        found |= {
            cell: partial(lambda used, name: getattr(one, used)[name], used, name) for cell, name in cells.items()
        }
    if one.bases[0].brakes:
        found["brake_load"] = lambda: one.brake_load
    if one.products.knows_falling:
        found["spare"] = lambda: one.extremes.spare
    return {f"drive{one.axis.number}_{name}": value for name, value in found.items()}


def checks(one: Studied) -> Worked:
    """Return the checks of its sheet that entries do not decide."""
    driven = one.bases[0].driven
    found = CHECKS | ({"ok_back": lambda one: one.axis.motion.closes} if driven.given.kind in LINKED else {})
    found |= {"ok_brake": lambda one: one.brake_load <= driven.brake.torque} if one.bases[0].brakes else {}
    found |= {"ok_turns": lambda _: ends_in_place(driven)} if driven.by_angle else {}
    return {f"drive{one.axis.number}_{name}": partial(lambda ok: in_words(ok(one)), ok) for name, ok in found.items()}
