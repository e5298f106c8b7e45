"""Random machines of every mechanism, with straight lines and viscous friction, built and verified: all are clean."""

import random
import time

import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from workbook.build import build
from workbook.judging.verify import verify
from workbook.machines.machine.mechanism import MECHANISMS, some_mechanism

KINDS = list(MECHANISMS)
ALL = 40
"""machines by night"""
DAY, FIRST, LEAST = 20.0, KINDS.index("press crank"), 3
"""seconds by day, the first machine then, and how many there are at least"""


def random_machine(number):
    """A machine of one drive of a kind in turn, and an axis without; every second drive has viscous friction."""
    drawn = random.Random(f"verified {number}")
    kind = KINDS[number % len(KINDS)]
    unit = drawn.choice(MECHANISMS[kind].UNITS)
    load = {"viscous": drawn.choice((None, 1.0)), "windows": []}
    if unit == "°" and not MECHANISMS[kind].SLIDES:
        load["arm"] = drawn.choice((None, {}))
    motor = {"inertia": 1.0, "rated_torque": 1.0, "peak_torque": 1.0, "max_speed": 1.0}
    motor |= {"brake": {"torque": 1.0}} if number % 3 else {}
    rise, back = (10.0, 150.0, 30.0, "CIC"), (200.0, 340.0, -30.0, "CIC")
    one = axis(1, rise, back, unit=unit, mechanism=some_mechanism(kind).model_dump(), load=load, motor=motor)
    room = {"phases": drawn.choice((2, 4, 10)), "rotors": 2, "positions": 6}
    data = described([one, axis(2, rise, back)], **room).model_dump()
    data["laws"] |= {"LIN": {"family": "LIN"}}
    return drawn_machine(TEMPLATE.model.model_validate(data), drawn)


def found_in(number, path):
    """What verify finds in the fresh book of a machine."""
    path.unlink(missing_ok=True)
    build(random_machine(number), path)
    return [str(one) for one in verify(path).findings]


def test_a_day_s_random_machines_are_clean(tmp_path):
    """Each kind in turn, for so long as a day has."""
    begin = time.monotonic()
    for number in range(FIRST, ALL):
        assert found_in(number, tmp_path / "book.xlsx") == [], number
        if number - FIRST + 1 >= LEAST and time.monotonic() - begin > DAY:
            break


@pytest.mark.nightly
@pytest.mark.parametrize("number", range(ALL))
def test_a_night_s_random_machines_are_clean(number, tmp_path):
    assert found_in(number, tmp_path / "book.xlsx") == []
