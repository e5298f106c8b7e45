"""The results of many designs of a drive by the names of their cells."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from engine.laws.base import Array
from engine.selection.batch import mean_power
from engine.selection.point_load import shares_of
from workbook.entries.units import KG_CM2, KW, shown
from workbook.machines.machine.drive.by_angle import ends_in_place
from workbook.machines.machine.mechanism import LINKED
from workbook.machines.machine.studies.drives import WEIGHED, Studied, in_words, within


def results(one: Studied) -> dict[str, Callable[[], Any]]:
    """Return all results by name, each worked out when it is called."""
    each = _asked(one) | _products(one)
    return {f"drive{one.axis.number}_{name}": value for name, value in each.items()}


def checks(one: Studied) -> dict[str, Callable[[], Any]]:
    """Return the checks of its sheet that entries do not decide."""
    return {f"drive{one.axis.number}_{name}": value for name, value in _checks(one).items()}


def _asked(one: Studied) -> dict[str, Callable[[], Any]]:
    """Return what the cycle asks of motors and reducers."""
    motor = one.motors_used.__getitem__
    found: dict[str, Callable[[], Any]] = {
        "rate": lambda: one.rates.each,
        "jtot": lambda: shown(one.at_motor, KG_CM2),
        "inertias": lambda: shares_of(one.at_motor, motor("inertia")),
        "tmax": lambda: one.extremes.torque,
        "tmin": lambda: one.extremes.torque_low,
        "rms": lambda: one.rms,
        "speed": lambda: one.speed,
        "mean": lambda: one.mean,
        "continuous": lambda: one.continuous,
        "res_rms": lambda: shares_of(one.continuous, one.rms),
        "res_peak": lambda: shares_of(motor("peak_torque"), one.extremes.peak),
        "res_speed": lambda: shares_of(motor("max_speed"), one.speed),
        "smax": lambda: one.behind,
        "smean": lambda: one.mean_behind,
        "energy": lambda: one.works.driving,
        "returned": lambda: one.works.regenerated,
        "power": lambda: shown(mean_power(one.works, one.time), KW),
        "pmax": lambda: shown(np.maximum(0.0, one.extremes.power), KW),
        "pmin": lambda: shown(np.minimum(0.0, one.extremes.power_low), KW),
        "highest": lambda: one.highest,
        "binds": lambda: one.binds,
    }
    return found | ({"spare": lambda: one.extremes.spare} if one.products.knows_falling else {})


def _products(one: Studied) -> dict[str, Callable[[], Any]]:
    """Return the figures of motors and reducers themselves."""
    motor = {"motor_row": "row", "jm": "inertia", "motor_rated": "rated_torque", "motor_peak": "peak_torque",
             "motor_nmax": "max_speed", "motor_stall": "stall_torque", "motor_nn": "rated_speed"}  # fmt: skip
    reducer = {"reducer_row": "row", "i1": "ratio", "eta1": "efficiency", "j_reducer": "inertia",
               "no_load": "no_load_torque",
               "reducer_peak": "peak_torque", "reducer_mean": "mean_torque",
               "reducer_full": "full_cycles", "reducer_fs": "cycle_factor",
               "reducer_nmax": "max_speed"}  # fmt: skip
    found: dict[str, Callable[[], Any]] = {"reducer_held": lambda: one.reducer_held}
    for name, figure in motor.items():
        found[name] = partial(_figure, one, "motors_used", figure)
    for name, figure in reducer.items():
        found[name] = partial(_figure, one, "reducers_used", figure)
    for figure in WEIGHED:
        found[f"motor_{figure}"] = partial(_figure, one, "motors_used", figure)
        found[f"reducer_{figure}"] = partial(_figure, one, "reducers_used", figure)
        found[f"pair_{figure}"] = partial(one.pair, figure)
    return found


def _figure(one: Studied, products: str, figure: str) -> Array:
    """Return a figure of the motors or the reducers in use."""
    found: dict[str, Array] = getattr(one, products)
    return found[figure]


def _checks(one: Studied) -> dict[str, Callable[[], Any]]:
    """Return the checks of the drive's sheet."""
    motor, reducer = one.motors_used.__getitem__, one.reducers_used.__getitem__
    linked = one.axis.given.mechanism and one.axis.given.mechanism.kind in LINKED
    closes = {"ok_back": lambda: in_words(one.axis.motion.closes)} if linked else {}
    if one.bases[0].driven.by_angle:
        closes["ok_turns"] = lambda: in_words(ends_in_place(one.bases[0].driven))
    return closes | {
        "ok_rms": lambda: in_words(one.rms <= one.continuous),
        "ok_peak": lambda: in_words(one.extremes.peak <= motor("peak_torque")),
        "ok_speed": lambda: in_words(one.speed <= motor("max_speed")),
        "ok_curve": lambda: one.below_curve,
        "ok_reducer_peak": lambda: within(one.reducer_held, one.behind),
        "ok_reducer_mean": lambda: within(reducer("mean_torque"), one.mean_behind),
        "ok_reducer_speed": lambda: within(reducer("max_speed"), one.speed),
    }
