"""Random machines: cells against the engine, work of what resists, mirrored motion, other units, other samples.

Each is one axis drawn, and beside it the same mirrored and the same told in degrees and Nm: what their motors do must
be the same, by cells that have other entries and another mechanism.
"""

import itertools
import math
import random

import numpy as np
import pytest

from engine.drive.limits import CYCLES
from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE, driven
from tests.workbook.machines.test_machine_forces import RISE, small
from tests.workbook.machines.test_machine_rates import CHECKS
from workbook.fields.units import KW
from workbook.law_sheets.library import laws
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive.view import AT_NO_RATE
from workbook.machines.machine.view import MachineView
from workbook.reading.descriptions import validated

G = 9.81
SAME = ("rms", "speed", "mean", "smax", "smean", "energy", "returned", "power", "highest", "jtot", "pmax", "pmin")
RACK = {"kind": "rack and pinion", "pinion_diameter": 50.0, "efficiency": 0.9}


def told(request, number):
    """What a machine is drawn from."""
    name = f"machine {number}"
    return random.Random(seed(name) if request.node.get_closest_marker("nightly") else name)


def window(drawn):
    """A process force."""
    start, stop = drawn.sample(range(0, 360, 5), 2)
    return {"start": start + 0.3, "stop": stop + 0.7, "force": drawn.uniform(-900, 900),
            "resists": drawn.choice(("always", "moving"))}  # fmt: skip


def one_axis(drawn, **entries):
    """The entries of a drive on a rack, with process forces."""
    made = drawn_machine(small([driven(*RISE, mechanism=RACK)]), drawn).model_dump()
    axis = made["axes"][0] | {"rate": None}
    axis["load"]["windows"] = [window(drawn) for _ in range(drawn.randint(0, 2))]
    for one in axis["load"]["windows"]:
        one["force"] = abs(one["force"]) if one["resists"] == "moving" else one["force"]
    return made | {"axes": [axis]} | entries


def mirrored(axis):
    """The same with motion and loads the other way."""
    load = axis["load"]
    windows = [w | ({"force": -w["force"]} if w["resists"] == "always" else {}) for w in load["windows"]]
    turned = {"force": -load["force"], "slope": -load["slope"], "windows": windows}
    phases = [phase | {"lift": -phase["lift"]} for phase in axis["phases"]]
    return axis | {"name": "Mirrored", "phases": phases, "load": load | turned}


def in_degrees(axis):
    """The same with the pinion's angle as the motion: behind a ratio of 1."""
    load, radius = axis["load"], axis["mechanism"]["pinion_diameter"] / 2000
    weight, slope = load["mass"] * G, math.radians(load["slope"])
    turning = {"inertia": 1e4 * load["mass"] * radius**2, "torque": (load["force"] + weight * math.sin(slope)) * radius,
               "friction_torque": load["friction"] * weight * abs(math.cos(slope)) * radius}  # fmt: skip
    windows = [one | {"force": one["force"] * radius} for one in load["windows"]]
    phases = [phase | {"lift": math.degrees(phase["lift"] / 1000 / radius)} for phase in axis["phases"]]
    mechanism = {"kind": "rotary table"} | {name: axis["mechanism"][name] for name in ("efficiency", "method")}
    return axis | {"name": "In degrees", "unit": "°", "phases": phases, "mechanism": mechanism,
                   "load": turning | {"windows": windows}}  # fmt: skip


def valid(data):
    """A machine of these entries."""
    made = validated(TEMPLATE, data, str)
    assert made.design.replaced == {}
    return made


def names_the_slowest(cell):
    """Whether a cell tells which drive the highest rate hangs on: of three that do the same, a rounding decides."""
    return cell.startswith(("about_first", "about_binds")) or "the drives hold from" in cell


@pytest.mark.parametrize("number", [*range(2), *nights(8)])
def test_cells_mirrored_motion_and_other_units(request, number):
    drawn = told(request, number)
    data = one_axis(drawn)
    axis = data["axes"][0]
    made = valid(data | {"axes": [axis, mirrored(axis), in_degrees(axis)]})
    wrong, _ = disagreeing(TEMPLATE, made)
    assert [cell for cell in wrong if not names_the_slowest(cell)] == []
    value = computed(TEMPLATE, made)
    peak = max(value("drive1_tmax"), -value("drive1_tmin"), 1e-9)
    for name in SAME:
        first, second, third = (value(f"drive{k}_{name}") for k in (1, 2, 3))
        if isinstance(first, str):  # the highest rate, where nothing limits it
            assert (second, third) == (first, first), name
            continue
        size = max(peak * value("drive1_speed") if name in ("pmax", "pmin", "power") else 0.0, abs(first))
        assert second == pytest.approx(first, rel=1e-8, abs=1e-9 * size), name
        assert third == pytest.approx(first, rel=1e-8, abs=1e-9 * size), name
    for name, other, way in (("tmax", "tmin", -1.0), ("tmin", "tmax", -1.0)):
        assert value(f"drive2_{other}") * way == pytest.approx(value(f"drive1_{name}"), rel=1e-8, abs=1e-9 * peak)
        assert value(f"drive3_{name}") == pytest.approx(value(f"drive1_{name}"), rel=1e-8, abs=1e-9 * peak)


def work(made):
    """Work of all that resists the first axis over a cycle (J), from its positions at edges of phases and windows."""
    axis = MachineView(made, laws(made.laws)).axes[0]
    load, late = axis.given.load, axis.given.shift
    weight, slope = load.mass * G, math.radians(load.slope)
    edges = [late, *(late + at for phase in axis.given.phases for at in (phase.start, phase.stop))]
    edges += [at for one in load.windows for at in (one.start, one.stop)]
    cuts = sorted({0.0, 360.0, *(at % 360 for at in edges)})
    found = 0.0
    for low, high in itertools.pairwise(cuts):
        middle, half = (low + high) / 2, (high - low) / 2
        x = np.radians((middle - late) % 360 + np.array([-half, half]))
        moved = float(np.diff(axis.motion.at(x).y)[0])
        force = load.force + weight * math.sin(slope)
        force += math.copysign(load.friction * weight * abs(math.cos(slope)), moved)
        for one in load.windows:
            if (middle - one.start) % 360 < (one.stop - one.start) % 360:
                force += math.copysign(one.force, moved) if one.resists == "moving" else one.force
        found += force * moved
    return found


@pytest.mark.parametrize("number", [*range(1), *nights(8)])
def test_without_losses_the_motor_does_the_work_of_what_resists(request, number):
    data = one_axis(told(request, number))
    axis = data["axes"][0]
    axis["mechanism"]["efficiency"] = axis["reducer"]["efficiency"] = 1.0
    axis["reducer"]["no_load_torque"], axis["motor"]["copper_losses"] = 0.0, None
    made = valid(data)
    value = computed(TEMPLATE, made)
    driving, back = value("drive1_energy"), value("drive1_returned")
    assert driving - back == pytest.approx(work(made), rel=1e-8, abs=1e-9 * (driving + back))
    share = KW * (value("power_mains") - value("power_resistors"))
    efficiency = made.power.efficiency
    assert share * value("timing_cycle") == pytest.approx(
        driving / efficiency - back * efficiency, rel=1e-9, abs=1e-9 * driving
    )


@pytest.mark.parametrize("number", nights(4))
def test_no_result_hangs_on_the_samples(request, number):
    data = one_axis(told(request, number))
    books = [TEMPLATE.declare(valid(data | {"sizes": data["sizes"] | {"cycle": cycle}})) for cycle in (12, 720)]
    few, many = ({q.name: q.value for block in book.blocks.values() if not block.is_table for q in block.quantities
                  if not q.name.startswith(("bus_", "about_"))}
                 for book in books)  # fmt: skip
    assert few == many


def near(drawn, value):
    """A limit near to what is asked for, below or above; so high at times that it hardly binds."""
    return max(value, 1e-6) * (drawn.uniform(0.6, 3.0) if drawn.random() < 0.7 else 1e4)


def limited(drawn, data):
    """The same machine with limits near to what its drive asks for."""
    made = valid(data)
    found = Driven(MachineView(made, laws(made.laws)).axes[0], made).results
    rpm, behind = found.speed.peak * 30 / math.pi, found.shaft_torque(1).peak
    axis = data["axes"][0]
    motor = {"rated_torque": near(drawn, found.rms_torque), "peak_torque": near(drawn, found.torque.peak),
             "max_speed": near(drawn, rpm)}  # fmt: skip
    reducer = {"peak_torque": near(drawn, behind), "mean_torque": near(drawn, found.mean_shaft_torque(1)),
               "max_speed": near(drawn, rpm)}  # fmt: skip
    return data | {"axes": [axis | {"motor": axis["motor"] | motor, "reducer": axis["reducer"] | reducer}]}


def failing(data, rate):
    """The limits that checks of the drive's sheet say are not held at a rate."""
    value = computed(TEMPLATE, valid(data | {"master": {"rate": rate}}))
    return {limit for limit, name in CHECKS.items() if value(f"drive1_ok_{name}") == "FAIL"}


@pytest.mark.parametrize("number", [*range(1), *nights(8)])
def test_at_the_highest_rate_every_limit_holds_and_above_it_the_named_one_fails(request, number):
    drawn = told(request, number)
    data = limited(drawn, one_axis(drawn))
    value = computed(TEMPLATE, valid(data))
    rate, limit = value("drive1_highest"), value("drive1_binds")
    if limit == "none":
        assert failing(data, 1000 * data["master"]["rate"]) == set()
        return
    limit = {CYCLES: "reducer peak torque"}.get(limit, limit)
    if rate == AT_NO_RATE:
        assert limit in failing(data, 0.01 * data["master"]["rate"])
    else:
        assert failing(data, rate) == set()
        again = computed(TEMPLATE, valid(data | {"master": {"rate": rate}}))("drive1_highest")
        assert limit in failing(data, 1.01 * again)
