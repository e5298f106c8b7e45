"""The highest rate in cells: against a search by the engine's other route, and by what it means."""

import math
import random
from dataclasses import replace

import pytest

from engine.drivetrain import Motor
from engine.machine.limits import Judged, Limits, ReducerLimits
from engine.machine.pace import FAR, LIMITS
from engine.machine.rate import of_axis
from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE, driven
from tests.workbook.machines.test_machine_forces import RISE, small
from workbook.laws.shelf import LawShelf
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.entries import Master
from workbook.machines.machine.motion import AxisRows
from workbook.machines.machine.stretched import Stretched
from workbook.machines.machine.view import Whole

CHECKS = dict(
    zip(LIMITS, ("speed", "reducer_speed", "peak", "reducer_peak", "rms", "reducer_mean", "curve"), strict=True)
)
FREE = {"inertia": 10.0, "rated_torque": 1e5, "peak_torque": 1e5, "max_speed": 1e6}
PRESS = [{"start": 50.0, "stop": 120.0, "force": 900.0, "resists": "moving"},
         {"start": 150.0, "stop": 230.0, "force": -400.0, "resists": "always"}]  # fmt: skip
BINDING = {
    "motor speed": ({"max_speed": 9000.0}, {}),
    "peak torque": ({"peak_torque": 40.0}, {}),
    "RMS torque": ({"rated_torque": 10.0}, {}),
    "reducer peak torque": ({}, {"peak_torque": 40.0}),
    "reducer mean torque": ({}, {"mean_torque": 20.0}),
    "reducer input speed": ({}, {"max_speed": 8000.0}),
}


def machine(rate, motor, reducer):
    """One axis with process forces, friction, and losses in both stages, at a rate."""
    load = {"mass": 20.0, "friction": 0.1, "slope": 30.0, "windows": PRESS}
    gears = {"ratio": 3.0, "efficiency": 0.8} | reducer
    axis = driven(*RISE, load=load, reducer=gears, motor=FREE | motor)
    axis["mechanism"]["efficiency"] = 0.7
    made = small([axis])
    return made.model_copy(update={"master": made.master.model_copy(update={"rate": rate})})


def verdicts(value):
    """What the checks of the first drive's limits say, by the limits' names."""
    return {limit: value(f"drive1_ok_{name}") for limit, name in CHECKS.items()}


@pytest.mark.parametrize("limit", BINDING)
def test_at_the_highest_rate_all_hold_and_above_it_the_named_limit_fails(limit):
    entered = BINDING[limit]
    found = computed(TEMPLATE, machine(100.0, *entered))
    rate = found("drive1_highest")
    assert found("drive1_binds") == limit
    assert found("about_highest") == rate
    assert found("about_binds") == f"A1: {limit}"
    assert set(verdicts(computed(TEMPLATE, machine(rate, *entered))).values()) == {"OK"}
    above = verdicts(computed(TEMPLATE, machine(1.001 * rate, *entered)))
    assert [name for name, verdict in above.items() if verdict == "FAIL"] == [limit]


def test_the_highest_rate_is_the_same_from_wherever_it_is_asked_for():
    rates = [
        computed(TEMPLATE, machine(rate, {"rated_torque": 10.0}, {}))("drive1_highest") for rate in (7.0, 100.0, 2000.0)
    ]
    assert rates == pytest.approx([rates[0]] * 3, rel=1e-9)


def test_the_cells_agree_far_from_the_present_rate():
    for rate in (1.0, 3000.0):
        wrong, _ = disagreeing(TEMPLATE, machine(rate, {"rated_torque": 10.0}, {"mean_torque": 21.0}))
        assert [cell for cell in wrong if cell.startswith("drive1_")] == []


def test_a_load_that_the_motor_cannot_hold_has_no_rate():
    found = computed(TEMPLATE, machine(100.0, {"peak_torque": 0.01}, {}))
    assert (found("drive1_highest"), found("drive1_binds")) == (0.0, "peak torque")


def test_the_axis_that_binds_is_named():
    axes = [driven(*RISE, motor=FREE | {"max_speed": speed}) for speed in (9000.0, 7000.0, 8000.0)]
    found = computed(TEMPLATE, small([axis | {"name": f"Axis {k}"} for k, axis in enumerate(axes, 1)]))
    assert found("about_binds") == "Axis 2: motor speed"
    assert found("about_highest") == found("drive2_highest") == min(found(f"drive{k}_highest") for k in (1, 2, 3))


def near(drawn, value):
    """A limit near to what is asked for, below or above; none at times."""
    return max(value, 1e-6) * drawn.uniform(0.6, 3.0) if drawn.random() < 0.7 else math.inf


def limited(drawn, pace):
    """The same stretches with other limits."""
    found = pace.demand
    behind, mean = found.shaft_torque(1).peak, found.mean_shaft_torque(1)
    return replace(
        pace, rated_torque=near(drawn, found.rms_torque), peak_torque=near(drawn, found.torque.peak),
        max_speed=near(drawn, found.speed.peak),
        reducer=ReducerLimits(near(drawn, behind), near(drawn, mean), near(drawn, found.speed.peak)),
    )  # fmt: skip


def stretches_of(given):
    """The stretches of the first drive of a machine."""
    shelf = LawShelf(given.laws, given.sizes, bool(given.laws.of("LIN")))
    whole = Whole(given, shelf.laws)
    return Stretched(AxisRows(whole, whole.axes[0], shelf.stack), Driven(whole.axes[0], given.selection))


@pytest.mark.parametrize("number", [*range(4), *nights(200)])
def test_the_rate_is_that_of_a_search_over_closed_forms(request, number):
    told = f"pace {number}"
    drawn = random.Random(seed(told) if request.node.get_closest_marker("nightly") else told)
    pace = limited(drawn, stretches_of(drawn_machine(machine(200.0, {}, {}), drawn)).pace)
    course = pace.demand.course
    motor = Motor(1e-3, pace.rated_torque, pace.peak_torque, pace.max_speed)
    speed, _ = of_axis(Judged(course, Limits(motor, None, pace.reducer)))
    expected = min(speed / course.speed, math.sqrt(FAR))
    assert pace.highest == pytest.approx(expected, rel=1e-9, abs=1e-5)


def test_a_drive_is_sized_at_a_rate_of_its_own():
    """As if the machine ran at it; the others, the timing and the machine's rate stay."""
    reducer = {"ratio": 3.0, "efficiency": 0.8, "mean_torque": 22.0}
    axis = driven(*RISE, reducer=reducer, load={"mass": 20.0, "friction": 0.1, "windows": PRESS})
    both = computed(TEMPLATE, small([axis | {"rate": 150.0}, axis | {"name": "A2"}]))
    alone = computed(TEMPLATE, small([axis]).model_copy(update={"master": Master(rate=150.0)}))
    names = ("rms", "tmax", "tmin", "speed", "mean", "smax", "smean", "energy", "returned", "power", "rate", "highest")
    for name in names:
        assert both(f"drive1_{name}") == pytest.approx(alone(f"drive1_{name}"), rel=1e-9), name
    for column in ("rpm", "torque"):
        assert both("drive1_cycle", column) == pytest.approx(alone("drive1_cycle", column), rel=1e-9, abs=1e-9)
    assert both("drive2_rms") != pytest.approx(both("drive1_rms"), rel=0.1)
    assert both("drive1_sized") == "a rate of its own"
    assert both("axes_short", "sized") == [150.0, "machine's"]
    assert both("drive2_rate") == 200.0


def test_a_rate_without_a_drive_is_refused():
    with pytest.raises(ValueError, match="without a drive"):
        small([{"name": "A", "group": "G", "phases": small([driven(*RISE)]).axes[0].phases, "rate": 3.0}])


def test_of_equal_drives_the_first_is_named():
    """As of two lanes, whose motions differ by a shift: which rate is lower hangs on rounding."""
    slow, twin = driven(*RISE, motor=FREE | {"max_speed": 9000.0}), driven(*RISE, motor=FREE | {"max_speed": 7000.0})
    lanes = [slow, *({**twin, "shift": 52.7 * k} for k in (0, 1, 2, 3))]
    machine = small([axis | {"name": f"Axis {k}"} for k, axis in enumerate(lanes, 1)])
    assert computed(TEMPLATE, machine)("about_binds") == "Axis 2: motor speed"
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert [cell for cell in wrong if cell.startswith("about_")] == []
