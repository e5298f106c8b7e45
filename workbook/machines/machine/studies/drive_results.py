"""The results of a drive in a study, by the names of the cells that have them in the book."""

from collections.abc import Callable
from functools import partial
from operator import attrgetter
from typing import Any

import numpy as np

from engine.selection.point_load import shares_of
from workbook.fields.units import KG_CM2, KW, shown
from workbook.machines.machine.drive.in_use import IN_USE, UNITS
from workbook.machines.machine.studies.drives import WEIGHED, DriveStudy
from workbook.template_outputs import Computations

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
    "use_rms": lambda study: shares_of(study.rms, study.continuous),
    "use_peak": lambda study: shares_of(study.extremes.peak, study.motors_used["peak_torque"]),
    "use_speed": lambda study: shares_of(study.speed, study.motors_used["max_speed"]),
    "use_reducer": lambda study: shares_of(study.behind(0), study.reducer_held_at(1.0 / study.time)),
    "use_mean": lambda study: shares_of(study.behind(1), study.reducers_used["mean_torque"]),
    "use_input": lambda study: shares_of(study.speed, study.reducers_used["max_speed"]),
    "use_inertia": lambda study: study.inertias / study.limits.inertia_ratio,
    "smax": lambda study: study.behind(0),
    "smean": lambda study: study.behind(1),
    "energy": lambda study: study.works.driving,
    "returned": lambda study: study.works.regenerated,
    "power": lambda study: shown(study.works.net / study.time, KW),
    "pmax": lambda study: shown(np.maximum(0.0, study.extremes.power), KW),
    "pmin": lambda study: shown(np.minimum(0.0, study.extremes.power_low), KW),
    "highest": lambda study: study.highest[0],
    "binds": lambda study: study.highest[1],
    "lowest": lambda study: study.lowest[0],
    "binds_low": lambda study: study.lowest[1],
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
