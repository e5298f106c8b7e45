"""The highest rate of drives that are worked out place by place: by what it means, and against an exact search."""

import random
import re
from dataclasses import replace

import pytest

from engine.machine.limits import Judged, Limits
from engine.machine.place_pace import WITHIN
from engine.machine.rate import of_axis
from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE, driven
from tests.workbook.machines.test_machine_forces import RISE
from tests.workbook.machines.test_machine_linked import CRANK, MOTOR, ROCKER, small
from tests.workbook.machines.test_machine_rates import BINDING, FREE, limited, verdicts
from tests.workbook.machines.test_machine_tables import table
from tests.workbook.machines.test_machine_viscous import SCREW, lossy
from workbook.laws.shelf import LawShelf
from workbook.machines.machine.linked.changing import over_motion
from workbook.machines.machine.linked.driven import driven_of
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.view import Whole

POINTS = table((-30, -15), (20, 3), (90, 35), (190, 66))
AXES = {"screw": (SCREW, 300.0), "crank": (CRANK, None), "rocker": (ROCKER, 20.0), "table": (POINTS, None)}


def machine(name, rate=200.0, motor=None, reducer=None):
    """An axis with losses, a process force and parts, at a rate, with limits of its motor and reducer."""
    mechanism, viscous = AXES[name]
    one = lossy(viscous, mechanism=mechanism)
    one |= {"motor": FREE | (motor or {}), "reducer": one["reducer"] | (reducer or {})}
    made = small(one, positions=4)
    return made.model_copy(update={"master": made.master.model_copy(update={"rate": rate})})


def drives_of(given):
    """The drives of a machine."""
    shelf = LawShelf(given.laws, given.sizes, bool(given.laws.of("LIN")))
    whole = Whole(given, shelf.laws)
    rows = [AxisRows(whole, axis, shelf.stack) for axis in whole.axes]
    return [over_motion(one, driven_of(one.axis, given.selection)) for one in rows]


@pytest.mark.parametrize("limit", BINDING)
@pytest.mark.parametrize("name", AXES)
@pytest.mark.sample(2)
def test_at_the_highest_rate_all_hold_and_a_thousandth_above_it_the_named_limit_fails(name, limit):
    motor, reducer = BINDING[limit]
    found = computed(TEMPLATE, machine(name, 100.0, motor, reducer))
    rate = found("drive1_highest")
    assert (found("drive1_binds"), found("about_highest"), found("about_binds")) == (limit, rate, f"A1: {limit}")
    assert set(verdicts(computed(TEMPLATE, machine(name, rate, motor, reducer))).values()) == {"OK"}
    above = verdicts(computed(TEMPLATE, machine(name, 1.001 * rate, motor, reducer)))
    assert [one for one, verdict in above.items() if verdict == "FAIL"] == [limit]


@pytest.mark.parametrize("name", AXES)
def test_the_highest_rate_is_the_same_from_wherever_it_is_asked_for(name):
    """Other rates have other places where power turns round, and so other nodes."""
    rates = [drives_of(machine(name, rate, {"rated_torque": 10.0}))[0].paced.rate for rate in (20.0, 100.0, 700.0)]
    assert rates == pytest.approx([rates[0]] * 3, rel=2.0 * WITHIN)


@pytest.mark.parametrize("rate", [3.0, 3000.0])
@pytest.mark.parametrize("name", AXES)
@pytest.mark.sample(2)
def test_the_cells_agree_far_from_the_present_rate(name, rate):
    wrong, _ = disagreeing(TEMPLATE, machine(name, rate, {"rated_torque": 10.0}, {"mean_torque": 21.0}))
    assert wrong == []


def test_a_load_that_the_motor_cannot_hold_has_no_rate():
    found = computed(TEMPLATE, machine("crank", 100.0, {"peak_torque": 1e-3}))
    assert (found("drive1_highest"), found("drive1_binds")) == (0.0, "peak torque")


def test_a_limit_that_is_broken_tells_the_rate_up_to_which_all_hold():
    found = TEMPLATE.declare(machine("crank", 200.0, {"rated_torque": 2.0}))
    told = [q.said for _, q in found.checks if q.value == "FAIL" and "RMS" in q.label]
    rate = drives_of(machine("crank", 200.0, {"rated_torque": 2.0}))[0].paced.rate * 60
    (most,) = [float(re.search(r"; the drive holds all up to ([\d.]+) cycles/min$", said)[1]) for said in told]
    assert most <= rate < most + 1e-3


def test_the_machine_tells_the_axis_that_binds_among_drives_of_both_kinds():
    plain = driven(*RISE, motor=MOTOR | {"max_speed": 1e6, "peak_torque": 1e5, "rated_torque": 1e5}) | {"name": "A2"}
    crank = lossy(None, mechanism=CRANK) | {"motor": FREE | {"max_speed": 4500.0}}
    given = small(crank)
    given = given.model_copy(update={"axes": [*given.axes, *small(plain).axes]})
    found = computed(TEMPLATE, given)
    assert found("about_binds") == "A1: motor speed"
    assert found("about_highest") == found("drive1_highest") < found("drive2_highest")


@pytest.mark.parametrize("number", [*range(6), *nights(200)])
def test_the_rate_is_that_of_an_exact_search(request, number):
    """Of drives and limits drawn at random; where the load at rest alone breaks a limit, there is none."""
    told = f"place pace {number}"
    drawn = random.Random(seed(told) if request.node.get_closest_marker("nightly") else told)
    view = drives_of(drawn_machine(machine([*AXES][number % len(AXES)]), drawn))[0]
    pace = limited(drawn, view.pacing)
    motor = replace(view.driven.motor, rated_torque=pace.rated_torque, peak_torque=pace.peak_torque,
                    max_speed=pace.max_speed)  # fmt: skip
    course = pace.demand.course
    speed, _ = of_axis(Judged(course, Limits(motor, None, pace.reducer)))
    if min(pace.each) == 0.0:
        assert any(value > limit for value, limit in zip(pace.rest, pace.limits, strict=True))
    else:
        expected = min(speed / course.speed, 1e6)
        assert pace.rate * course.time == pytest.approx(expected * (1.0 - WITHIN), rel=WITHIN)
