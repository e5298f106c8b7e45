"""Viscous friction in cells: in closed form, by energy, beside a drive without it, at other samples, wrong entries."""

import math
import random

import openpyxl
import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from tests.workbook.machines.test_machine_linked import CRANK, FIGURES, LOSSY, MOTOR, linked, small
from workbook.build import build, read_inputs
from workbook.reading.descriptions import validated

SCREW = {"kind": "lead screw", "lead": 10.0, "efficiency": 1.0}
TURNING = {"kind": "rotary table", "efficiency": 0.8}
TURNS = 2 * math.pi / 0.01  # of the screw, rad/m
RISE = ((30, 90, 20.0, "CIC"), (180, 300, -20.0, "CIC"))
LIGHT = {"inertia": 0.0, "rated_torque": 9.0, "peak_torque": 30.0, "max_speed": 4500.0}
TIMES = 0.3 * 60 / 360, 0.3 * 120 / 360  # of both movements at 200 cycles/min, s


def viscous(value=300.0, mechanism=SCREW, phases=RISE, **entries):
    """An axis with viscous friction and no other load, on a motor without inertia."""
    load = {"viscous": value} | entries.pop("load", {})
    return axis(1, *phases) | {"mechanism": mechanism, "load": load, "motor": LIGHT} | entries


def lossy(value=300.0, mechanism=SCREW, **entries):
    """An axis with losses, a process force, parts, a reducer, a shift."""
    more = {"load": LOSSY["load"] | {"viscous": value}, "motor": MOTOR}
    return linked(*RISE, mechanism=mechanism | {"efficiency": 0.85}, **(LOSSY | more | entries))


def turning(value):
    """The same on a rotary table."""
    load = {"inertia": 200.0, "friction_torque": 0.3, "torque": 0.4, "viscous": value}
    return lossy(value, mechanism=TURNING, unit="°", load=load, motor=MOTOR | {"holding": "brake"})


AXES = {
    "screw": lambda: lossy(),
    "rotary table": lambda: turning(0.05),
    "crank": lambda: lossy(mechanism=CRANK),
    "none of it": lambda: lossy(0.0),
}


@pytest.mark.parametrize("name", AXES)
@pytest.mark.sample(2)
def test_cells_agree_with_the_engine_and_entries_come_back(name):
    machine = small(AXES[name]())
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert entered(TEMPLATE, machine) == (machine, [])


def test_peak_rms_and_power_of_viscous_friction_alone_in_closed_form():
    """ẏ = (h/t)(1 − cos 2πξ): T = c ẏ/i up to 2 h/t, ⟨ẏ²⟩ = 3/2 (h/t)²; the power c ẏ² never comes back."""
    c, h, i = 300.0, 0.02, TURNS
    value = computed(TEMPLATE, small(viscous(c)))
    fastest = [2 * h / t for t in TIMES]
    assert value("drive1_tmax") == pytest.approx(c * fastest[0] / i, rel=1e-9)
    assert value("drive1_tmin") == pytest.approx(-c * fastest[1] / i, rel=1e-9)
    squares = sum(1.5 * h**2 / t for t in TIMES)  # ∮ ẏ² dt
    assert value("drive1_rms") == pytest.approx(c / i * math.sqrt(squares / 0.3), rel=1e-9)
    assert value("drive1_pmax") == pytest.approx(c * fastest[0] ** 2 / 1000, rel=1e-9)
    assert value("drive1_pmin") == pytest.approx(0.0, abs=1e-9)
    assert value("drive1_energy") == pytest.approx(c * squares, rel=1e-9)
    assert value("drive1_returned") == pytest.approx(0.0, abs=1e-9)


def test_the_peak_beside_a_mass_lies_where_neither_speed_nor_acceleration_is_greatest():
    """m ÿ + c ẏ = A sin 2πξ + B (1 − cos 2πξ): from B − √(A² + B²) to B + √(A² + B²)."""
    c, m, h, t = 300.0, 12.0, 0.02, TIMES[0]
    value = computed(TEMPLATE, small(viscous(c, load={"mass": m})))
    most, level = 2 * math.pi * m * h / t**2, c * h / t
    assert value("drive1_tmax") == pytest.approx((level + math.hypot(most, level)) / TURNS, rel=1e-4)
    assert value("drive1_tmin") == pytest.approx((level - math.hypot(most, level)) / TURNS, rel=1e-4)
    assert level - math.hypot(most, level) < -level - math.hypot(most / 4, level / 2)


@pytest.mark.parametrize("mechanism", [SCREW, CRANK], ids=lambda m: m["kind"])
def test_over_a_cycle_the_motor_does_the_work_of_viscous_friction_too(mechanism):
    """∮ T dφ = ∮ c ẏ² dt + μ m g · 2 h: without losses in between, whatever the mechanism does."""
    load = {"mass": 12.0, "friction": 0.1}
    told = viscous(300.0, mechanism, load=load) | {"motor": MOTOR}
    value = computed(TEMPLATE, small(told))
    work = 300.0 * sum(1.5 * 0.02**2 / t for t in TIMES)
    net = value("drive1_energy") - value("drive1_returned")
    assert net == pytest.approx(work + 0.1 * 12.0 * 9.81 * 0.04, abs=1e-6 * value("drive1_energy"))
    assert value("drive1_returned") > 0.0


@pytest.mark.parametrize("number", [*range(2), *nights(10)])
def test_none_of_it_is_the_same_as_a_drive_without_it(request, number):
    """Places of each section beside bent lines in closed form: two sheets that share no cell."""
    name = f"viscous {number}"
    drawn = random.Random(seed(name) if request.node.get_closest_marker("nightly") else name)
    data = drawn_machine(small(lossy(None)), drawn).model_dump()
    bare, placed = (validated(TEMPLATE, with_viscous(data, value), str) for value in (None, 0.0))
    assert bare.design.replaced == placed.design.replaced == {}
    one, other = computed(TEMPLATE, bare), computed(TEMPLATE, placed)
    peak = max(one("drive1_tmax"), -one("drive1_tmin"), 1e-9)
    size = dict.fromkeys(("tmax", "tmin", "rms"), peak) | {
        name: max(one("drive1_energy"), one("drive1_returned"), 1e-9) for name in ("energy", "returned")
    }
    size["power"] = max(one("drive1_pmax"), -one("drive1_pmin"), 1e-9)
    for figure in FIGURES[:-1]:
        expected = pytest.approx(one(f"drive1_{figure}"), rel=1e-8, abs=1e-8 * size.get(figure, 0.0))
        assert other(f"drive1_{figure}") == expected, figure


def with_viscous(data, value):
    """The description of one axis with another viscous friction."""
    (one,) = data["axes"]
    return data | {"axes": [one | {"load": one["load"] | {"viscous": value}}]}


def test_a_torque_with_a_kink_beside_the_place_where_it_turns_round():
    """Of a load that drives a light part: power turns round at the load and in the reducer between the same places."""
    load = {"torque": -126.0, "friction_torque": 0.2, "viscous": 162.0}
    parts = [{"name": "Disc", "count": 4.0, "inertia": 544.0, "shaft": "mechanism"}]
    reducer = {"ratio": 38.0, "efficiency": 0.55}
    one = viscous(mechanism=TURNING | {"efficiency": 0.515}, phases=((0, 105, 99.0, "CIC"),), unit="°", load=load,
                  parts=parts, reducer=reducer, rate=147.7, closes="feed")  # fmt: skip
    machine = small(one)
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert wrong == []


def test_a_negative_one_fails_by_name_and_is_carried():
    data = small(lossy()).model_dump()
    data["axes"][0]["load"]["viscous"] = -5.0
    machine = validated(TEMPLATE, data, str)
    (fault,) = machine.design.faults
    assert (fault.key, fault.message) == ("axes.0.load.viscous", "expected a number of at least 0")
    value = computed(TEMPLATE, machine)
    assert value("drive1_own_rate_entries") == "FAIL"
    assert value("drive1_own_rate_entries_says") == "Viscous friction: -5; expected a number of at least 0"
    back, lost = entered(TEMPLATE, machine)
    assert lost == []
    assert back.design.replaced == machine.design.replaced


def test_an_axis_without_a_drive_has_none():
    with pytest.raises(ValueError, match="entered for an axis without a drive"):
        described([axis(1, *RISE, load={"viscous": 3.0})])


def test_an_emptied_cell_counts_as_none_of_it_and_keeps_its_place(tmp_path):
    path = tmp_path / "book.xlsx"
    build(small(lossy()), path)
    written = openpyxl.load_workbook(path)
    title, cell = next(written.defined_names["drive1_viscous"].destinations)
    written[title][cell].value = None
    written.save(path)
    assert read_inputs(path)[0] == small(lossy(0.0))
