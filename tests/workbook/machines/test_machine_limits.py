"""One set of limits: the sheet of a drive, Selection, Pairs, studies and the exact engine judge by it alike."""

import random

import pytest

from tests.workbook.cells import computed
from tests.workbook.machines.test_machine import TEMPLATE
from tests.workbook.machines.test_machine_selection import MOTORS, REDUCERS, machine

HELD = ("rms", "peak", "speed", "curve", "inertia", "shaft", "mass", "reducer_peak", "reducer_mean", "reducer_speed")
WORDS = {"RMS": "rms", "peak": "peak", "speed": "speed", "inertia": "inertia", "shaft": "shaft", "mass": "mass"}
"""of what a pair fails first, the check of the drive's sheet"""


def limited(drawn):
    """A machine of two drives at limits that are drawn, the second drive at some of its own."""
    limits = {name: drawn.uniform(0.7, 1.8) for name in ("rms_reserve", "peak_reserve", "speed_reserve")}
    limits |= {"torque_factor": drawn.uniform(0.5, 2.0), "inertia_ratio": 10 ** drawn.uniform(-0.5, 1.0)}
    data = machine(drawn.uniform(50.0, 170.0), greatest_margin=1e9, **limits).model_dump()
    data["selection"]["motors"] = [one | {"shaft": 14.0 - k} for k, one in enumerate(MOTORS)]
    data["selection"]["reducers"] = [
        one | {"max_torque": 30.0 * k, "max_speed": 4500.0, "hub": 12.0 + k} for k, one in enumerate(REDUCERS)
    ][1:]
    data["axes"][1]["limits"] = {
        "peak_reserve": drawn.uniform(0.8, 1.5),
        "inertia_ratio": 10 ** drawn.uniform(-0.5, 1.0),
        "largest_mass": drawn.choice([0.0, 9.5]),
    }
    return data


def verdicts(data):
    """Return the verdicts of the second drive's limits, by the engine's values of its checks."""
    book = TEMPLATE.declare(TEMPLATE.model.model_validate(data))
    return {
        q.name.removeprefix("drive2_ok_"): q.value == "OK" for _, q in book.checks if q.name.startswith("drive2_ok_")
    }


def test_a_pair_can_do_it_exactly_if_the_drive_with_it_keeps_to_all_limits():
    """Of what a pair fails first, the drive's sheet says FAIL; of a pair that can do it, all but the curve is OK."""
    said = set()
    for data in (limited(random.Random(seed)) for seed in range(4)):
        book = TEMPLATE.declare(TEMPLATE.model.model_validate(data))
        for r, reducer in enumerate(data["selection"]["reducers"], 1):
            for motor, word in zip(MOTORS, book.values(f"[sel_word{r}.v]"), strict=False):
                data["axes"][1] |= {"motor": {"name": motor["name"]}, "reducer": {"name": reducer["name"]}}
                found = verdicts(data)
                said.add(word)
                if word == "yes":
                    assert all(found[name] for name in HELD if name != "curve"), (motor, reducer, found)
                elif word == "reducer":
                    assert not all(found[f"reducer_{one}"] for one in ("peak", "mean", "speed")), (
                        motor,
                        reducer,
                        found,
                    )
                else:
                    assert not found[WORDS[word]], (motor, reducer, word, found)
    assert {"yes", "RMS", "peak", "reducer", "shaft", "mass"} <= said


def test_a_reserve_lowers_the_limit_and_the_highest_rate_and_leaves_the_reserve_that_is_told():
    """At a reserve of 1.3 a drive holds its limits up to the rate at which it has 1.3 times what it needs."""
    whole, held = (
        computed(TEMPLATE, machine(speed_reserve=one, rms_reserve=one, peak_reserve=one)) for one in (1.0, 1.3)
    )
    for name in ("res_rms", "res_peak", "res_speed"):
        assert held(f"drive1_{name}") == pytest.approx(whole(f"drive1_{name}"), rel=1e-12)
    assert held("drive1_motor_peak") == pytest.approx(whole("drive1_motor_peak") / 1.3, rel=1e-12)
    assert held("drive1_highest") < whole("drive1_highest")
