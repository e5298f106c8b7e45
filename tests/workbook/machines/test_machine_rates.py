"""The highest rate in cells: against a search by the engine's other route, and by what it means."""

import random

import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import RISE, TEMPLATE, driven, small
from tests.workbook.machines.test_machine_drives import CRANK, ROCKER, SCREW, lossy, table
from tests.workbook.machines.test_machine_drives import small as linked_small
from tests.workbook.machines.test_machine_selection import PRESS
from workbook.machines.machine import exact
from workbook.machines.machine.drive.view import AT_NO_RATE
from workbook.machines.machine.entries import Master
from workbook.machines.machine.exact import drives_of, exact_rates, rate_of

CHECKS = {
    "motor speed": "speed", "reducer input speed": "reducer_speed", "peak torque": "peak",
    "reducer peak torque": "reducer_peak", "RMS torque": "rms", "reducer mean torque": "reducer_mean",
    "torque below the curve": "curve",
}  # fmt: skip
"""the names of checks, by the limits'"""
FREE = {"inertia": 10.0, "rated_torque": 1e5, "peak_torque": 1e5, "max_speed": 1e6}
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


LINKAGES = {
    "screw": (SCREW, 300.0), "crank": (CRANK, None), "rocker": (ROCKER, 20.0),
    "table": (table((-30, -15), (20, 3), (90, 35), (190, 66)), None),
}  # fmt: skip
"""mechanisms, and viscous friction"""


def linked_machine(name, rate=200.0, motor=None, reducer=None):
    """An axis on a mechanism of its own with losses, a process force and parts, at a rate, with limits."""
    mechanism, viscous = LINKAGES[name]
    one = lossy(viscous, mechanism=mechanism)
    one |= {"motor": FREE | (motor or {}), "reducer": one["reducer"] | (reducer or {})}
    made = linked_small(one, positions=4)
    return made.model_copy(update={"master": made.master.model_copy(update={"rate": rate})})


def verdicts(value):
    """What the checks of the first drive's limits say, by the limits' names."""
    return {limit: value(f"drive1_ok_{name}") for limit, name in CHECKS.items()}


def settled(made):
    """The rate that the sheet of the first drive names, entered and read again; and what is computed there."""
    rate = 100.0
    for _ in range(6):
        value = computed(TEMPLATE, made(rate))
        if value("drive1_highest") == pytest.approx(rate, rel=1e-4):
            break
        rate = value("drive1_highest")
    return rate, value


@pytest.mark.parametrize("limit", BINDING)
def test_at_the_highest_rate_all_hold_and_above_it_the_named_limit_fails(limit):
    entered = BINDING[limit]
    rate, found = settled(lambda rate: machine(rate, *entered))
    assert found("drive1_binds") == limit
    assert found("about_highest") == found("drive1_highest")
    assert found("about_binds") == f"A1: {limit}"
    assert set(verdicts(computed(TEMPLATE, machine(rate, *entered))).values()) == {"OK"}
    above = verdicts(computed(TEMPLATE, machine(1.003 * rate, *entered)))
    assert [name for name, verdict in above.items() if verdict == "FAIL"] == [limit]


def test_a_load_that_the_motor_cannot_hold_has_no_rate():
    found = computed(TEMPLATE, machine(100.0, {"peak_torque": 0.01}, {}))
    assert (found("drive1_highest"), found("drive1_lowest")) == (AT_NO_RATE, AT_NO_RATE)
    assert found("drive1_binds") == "peak torque"
    assert found("about_range") == "hold at no rate"
    assert found("about_binds") == "A1: peak torque"


def test_a_motor_too_small_for_an_axis_that_stands_has_no_rate():
    given = machine(100.0, {"rated_torque": 0.001}, {})
    (axis,) = given.axes
    phases = [phase.model_copy(update={"lift": 0.0, "law": "DWL"}) for phase in axis.phases]
    load = axis.load.model_copy(update={"force": 500.0})
    found = computed(
        TEMPLATE, given.model_copy(update={"axes": [axis.model_copy(update={"phases": phases, "load": load})]})
    )
    assert (found("drive1_highest"), found("drive1_lowest")) == (AT_NO_RATE, AT_NO_RATE)
    assert found("drive1_binds") == "RMS torque"


def with_usual_motor(given):
    """The machine with a motor whose torque at standstill is at most three times that at its rated speed."""
    (axis,) = given.axes
    stall, rated = axis.motor.stall_torque, axis.motor.rated_torque
    motor = axis.motor.model_copy(update={"stall_torque": min(stall, 3.0 * rated) if stall and rated else stall})
    return given.model_copy(update={"axes": [axis.model_copy(update={"motor": motor})]})


@pytest.mark.parametrize("number", [*range(4), *nights(30)])
def test_the_rate_of_the_sheet_is_at_most_a_per_cent_below_the_exact_one_and_never_above(request, number):
    """At a machine's own rate that is 0.6 to 1.5 times it; entered, it is confirmed."""
    told = f"pace {number}"
    drawn = random.Random(seed(told) if request.node.get_closest_marker("nightly") else told)
    given = with_usual_motor(drawn_machine(machine(200.0, {}, {}), drawn))
    (view,) = drives_of(given)
    exact = exact_rates(view)
    if isinstance(exact.high, str):
        assert view.rates.high == exact.high
        return
    (near,) = drives_of(at_rate(given, exact.high * drawn.uniform(0.6, 1.5)))
    assert 0.99 * exact.high <= near.rates.high <= exact.high
    (there,) = drives_of(at_rate(given, near.rates.high))
    assert there.search.holds
    assert there.driven.limit_checks.ok


def at_rate(given, rate):
    """A machine of one drive at another rate."""
    axis = given.axes[0].model_copy(update={"rate": None})
    return given.model_copy(update={"axes": [axis], "master": Master(rate=rate)})


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
    assert both("axes_short", "sized") == [150.0, 200.0]
    assert both("drive2_rate") == 200.0


@pytest.mark.parametrize(("rate", "lines"), [(200.0, 0), (0.01, 1)])
def test_a_rate_is_told_where_the_sheet_has_none_for_it_is_beyond_rounding(rate, lines):
    (view,) = drives_of(small([driven(*RISE, load={"mass": 20.0, "friction": 0.1}) | {"rate": rate}]))
    found = list(rate_of(view))
    assert len(found) == lines
    assert all("holds from 0 to 420.908 cycles/min exactly; its sheet says no limit" in line for line in found)


def test_ranges_that_differ_behind_their_rounded_digits_are_told_with_more(monkeypatch):
    (view,) = drives_of(machine(100.0, {"peak_torque": 40.0}, {}))
    monkeypatch.setattr(exact, "ends_exactly", lambda _: False)
    monkeypatch.setattr(exact, "agree", lambda *_: False)
    monkeypatch.setattr(exact, "exact_rates", lambda _: view.rates._replace(high=view.rates.high * (1 - 1e-7)))
    (line,) = rate_of(view)
    first, second = (float(words.split()[0]) for words in line.split("holds up to ")[1:])
    assert first < second


def test_of_equal_drives_the_first_is_named():
    """As of two lanes, whose motions differ by a shift: which rate is lower hangs on rounding."""
    slow, twin = driven(*RISE, motor=FREE | {"max_speed": 9000.0}), driven(*RISE, motor=FREE | {"max_speed": 7000.0})
    lanes = [slow, *({**twin, "shift": 52.7 * k} for k in (0, 1, 2, 3))]
    machine = small([axis | {"name": f"Axis {k}"} for k, axis in enumerate(lanes, 1)])
    assert computed(TEMPLATE, machine)("about_binds") == "Axis 2: motor speed"
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert [cell for cell in wrong if cell.startswith("about_")] == []
