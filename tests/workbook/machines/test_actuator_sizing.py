"""The actuator's book: S4's lead screw and conveyor in its cells, six mechanisms, exact RMS, entries."""

import math
import random
from itertools import pairwise
from typing import get_args

import numpy as np
import openpyxl
import pytest

from engine.drivetrain import KINDS, Load, Part, Sizing, Slide, Stage, cylinder
from engine.laws import TrapezoidalVelocity
from engine.motion import Phase
from tests.laws import MOVING
from tests.mutation.draw_actuator import varied
from tests.workbook.cells import computed, disagreeing
from workbook.build import inputs
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.laws.library import laws
from workbook.machines.actuator.entries import Kind
from workbook.machines.actuator.printed import FIGURES
from workbook.machines.actuator.view import Sized
from workbook.reading.descriptions import checked, read_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["actuator-sizing"]
CONVEYOR = TEMPLATE.description.with_name("actuator-sizing-conveyor.toml")
SMALL = {"cycle": 24, "law": 8, "own_law": 8, "motors": 5, "reducers": 5}


def entries(path=TEMPLATE.description, **changed):
    """A committed description with small tables; ``load__mass=3`` changes an entry of the actuator."""
    data = read_machine(path).model_dump()
    data["sizes"] |= SMALL
    choice = data["selection"]
    choice |= {"motors": choice["motors"][:5], "reducers": choice["reducers"][:5]}
    for name, value in changed.items():
        part, _, entry = name.rpartition("__")
        (data["actuator"][part] if part else data["actuator"])[entry] = value
    return data


def described(path=TEMPLATE.description, **changed):
    return TEMPLATE.model.model_validate(entries(path, **changed))


def turned(machine):
    """The motor's turns a minute by the entries alone: laws that bring their lift, on a screw."""
    entered = machine.actuator
    lifts, times = (sum(abs(getattr(phase, name)) for phase in entered.phases) for name in ("lift", "duration"))
    return lifts * entered.output.turns / times * 60


def test_s4_lead_screw():
    """Printed figures with the tolerance of their digits; where S4 is misprinted or rounded, the exact ones only."""
    value = computed(TEMPLATE, described())
    assert value("act_parts", "one")[0] == pytest.approx(1.47e-5, abs=5e-8)
    assert value("act_jload") == pytest.approx(1.35e-6, abs=5e-9)
    assert value("act_jmach") == pytest.approx(1.605973e-5, abs=5e-12)  # printed 1.65e-5
    assert value("act_jtotal") == pytest.approx(2e-5, abs=5e-7)
    assert value("act_tf") * 9.8 / 9.81 == pytest.approx(4.096e-3, abs=5e-7)
    assert value("act_tl") * 9.8 / 9.81 == pytest.approx(7.22e-3, abs=5e-6)
    assert value("act_tr") == pytest.approx(0.0113, abs=5e-5)
    assert value("act_vmax") == pytest.approx(0.048, abs=1e-12)
    assert value("act_wmax") == pytest.approx(48 * math.pi, rel=1e-12)
    assert value("act_mean") == pytest.approx(turned(described()), rel=1e-12)
    assert value("act_alpha") == pytest.approx(1440 * math.pi, rel=1e-12)  # printed 1460.4 π, of 0.033 s
    parts = [value("phases", name)[0] for name in ("acc", "level", "dec")]
    assert parts == pytest.approx([0.1021457, 0.0113301, -0.0794856], abs=5e-8)
    assert parts == pytest.approx([0.103, 0.0113, -0.0805], abs=1.1e-3)
    assert value("act_rms") == pytest.approx(0.044, abs=5e-4)
    assert value("act_rms") == pytest.approx(0.0437990, abs=5e-8)
    assert value("overall") == "OK"


def test_s4_conveyor():
    value = computed(TEMPLATE, described(CONVEYOR))
    light = 1.509848 * (1 - 9.8 / 9.81)  # S4 worked with g = 9.8
    assert value("act_parts", "at_motor")[0] == pytest.approx(4.96e-3, abs=5e-6)
    assert value("act_jbelt") == pytest.approx(9e-5, rel=1e-12)
    assert value("act_jload") == pytest.approx(1.35e-3, rel=1e-12)
    assert value("act_jmach") == pytest.approx(6.4e-3, abs=5e-5)
    assert value("act_jtotal") == pytest.approx(0.0128, abs=5e-5)
    assert value("act_vmax") == pytest.approx(0.01851852, abs=5e-9)
    assert value("act_wmax") == pytest.approx(6.173, abs=5e-4)
    assert value("act_alpha") == pytest.approx(2.058, abs=5e-4)
    parts = np.array([value("phases", name)[0] for name in ("acc", "level", "dec")])
    assert parts - light == pytest.approx([1.5343, 1.508, 1.4816], abs=5e-4)
    assert value("act_rms") == pytest.approx(1.439627, abs=5e-7)  # printed 0.147
    assert value("act_derate") == pytest.approx(0.142 / 0.147, abs=5e-3)
    assert value("act_derate") == pytest.approx(math.sqrt(140 / 150), rel=1e-12)
    assert value("overall") == "OK"


@pytest.mark.parametrize(("path", "side"), [(TEMPLATE.description, 0), (CONVEYOR, 1)], ids=["screw", "conveyor"])
def test_the_figures_called_exact_are_those_of_the_book_as_delivered(path, side):
    exact = [figure.exact[side] for figure in FIGURES]
    assert computed(TEMPLATE, described(path))("printed", "here") == pytest.approx(exact, rel=2e-6)


def test_the_description_is_the_engine_s_lead_screw():
    load = Slide(6, 0.1, math.radians(10)).load
    mechanism = KINDS["lead screw"].of(load, 500, 0.45, parts=[Part("screw", cylinder(0.014, 0.5, 7800))])
    phases = [Phase(TrapezoidalVelocity(1 / 6, 5 / 6), 0.008, 0.2)]
    for method in ("document", "physical"):
        machine = described(method=method, phases=[{"law": "TVP", "lift": 8.0, "duration": 0.2}])
        sizing = Sizing(mechanism, phases, mechanism.inertia(method) / 4, method, "brake")
        assert computed(TEMPLATE, machine)("act_rms") == pytest.approx(sizing.rms_torque, rel=1e-12)


def test_the_description_is_the_engine_s_conveyor():
    load, rollers = Slide(150, 0.05, math.radians(20)).load, Part("rollers", cylinder(0.3, 1.0, 7800), 1, 2)
    mechanism = KINDS["conveyor"].of(load, 0.3, gears=[Stage("gear", 50, 0.9)], parts=[rollers], belt=10)
    data = entries(CONVEYOR, load__friction=0.05, method="physical", holding="motor")
    data["actuator"]["gears"][0]["efficiency"] = 0.9
    machine = TEMPLATE.model.model_validate(data)
    value, view = computed(TEMPLATE, machine), Sized(machine, laws(machine.laws))
    sizing = Sizing(mechanism, view.phases, mechanism.inertia())
    assert value("act_rms") == pytest.approx(sizing.rms_torque, rel=1e-12)
    assert value("act_peak") == pytest.approx(sizing.peak_torque, rel=1e-12)
    assert value("phases", "level")[1] == pytest.approx(sizing.parts[-1].torque, rel=1e-12)


def test_a_train_of_two_gears():
    data = entries(mechanism="gear train", method="physical", holding="motor", load__inertia=0.05, load__torque=1.0)
    data["actuator"]["gears"] = [
        {"name": "first", "ratio": 3.0, "efficiency": 0.8},
        {"name": "second", "ratio": 5.0, "efficiency": 0.7},
    ]
    data["actuator"]["parts"] = [
        {"name": f"part {k}", "count": 1.0, "inertia": j, "shaft": float(k)} for k, j in enumerate((1e-4, 1e-3))
    ]
    data["actuator"]["load"]["friction_torque"] = 0.5
    data["actuator"]["motor"]["inertia"] = 1e-4
    data["actuator"]["phases"] = [
        {"law": "CIC", "lift": 300.0, "duration": 0.2},
        {"law": "DWL", "lift": 0.0, "duration": 0.1},
        {"law": "MTP", "lift": -300.0, "duration": 0.3},
    ]
    machine = TEMPLATE.model.model_validate(data)
    parts, gears = [Part("a", 1e-4), Part("b", 1e-3, 1)], [Stage("first", 3.0, 0.8), Stage("second", 5.0, 0.7)]
    train = KINDS["gear train"].of(Load(0.05, 1.0, 0.5), gears=gears, parts=parts)
    phases = Sized(machine, laws(machine.laws)).phases
    value = computed(TEMPLATE, machine)
    assert value("act_rms") == pytest.approx(Sizing(train, phases, 1e-4).rms_torque, rel=1e-11)
    assert value("act_lrms") == pytest.approx(Sizing(train, phases, 0.0).rms_torque, rel=1e-11)
    assert value("act_peak") == pytest.approx(Sizing(train, phases, 1e-4).peak_torque, rel=1e-12)


@pytest.mark.parametrize("law", [code for code in MOVING if code != "OWN"])
@pytest.mark.parametrize("slope", [35.0, -35.0])
def test_rms_in_closed_form_where_power_turns_round_within_the_law(law, slope):
    """The cells split a law where its load gives power back; the engine integrates; fine samples are nearly so."""
    there_and_back = [{"law": law, "lift": lift, "duration": 0.22} for lift in (160.0, -160.0)]
    machine = described(method="physical", holding="motor", load__slope=slope, phases=there_and_back)
    value, view = computed(TEMPLATE, machine), Sized(machine, laws(machine.laws))
    assert any(0 < x < 1 for x in value("turns", "x1"))  # it does turn round
    sizing = view.sizing
    assert value("act_rms") == pytest.approx(sizing.rms_torque, rel=1e-11)
    edges, middles = sizing.motion.edges, (np.arange(20000) + 0.5) / 20000
    time = np.concatenate([a + (b - a) * middles for a, b in pairwise(edges)])
    points = sizing.operating_points(time)
    assert value("act_rms") == pytest.approx(math.sqrt(np.mean(points.torque**2)), rel=1e-4)
    acceleration = view.mechanism.ratio * sizing.motion.at(time).y2
    load = points.torque - view.motor_inertia * acceleration
    assert value("act_wrms") == pytest.approx(math.sqrt(np.mean(acceleration**2)), rel=1e-4)
    assert value("act_lrms") == pytest.approx(math.sqrt(np.mean(load**2)), rel=1e-4)
    assert value("act_lmean") == pytest.approx(np.mean(load * acceleration), rel=1e-3)


def test_rms_of_the_own_law_comes_near_the_exact_one_as_its_samples_grow():
    there_and_back = [{"law": "OWN", "lift": lift, "duration": 0.22} for lift in (160.0, -160.0)]
    gaps = []
    for samples in (20, 200):
        data = entries(method="physical", phases=there_and_back)
        data["sizes"]["law"] = samples
        view = Sized(TEMPLATE.model.model_validate(data), laws(described().laws))
        gaps.append(abs(view.rms_torque / view.sizing.rms_torque - 1))
    assert 0 < gaps[1] < 0.03 * gaps[0]
    assert gaps[1] < 1e-5


def test_losses_help_to_brake():
    value = computed(TEMPLATE, described(method="physical", load__slope=-60.0, load__friction=0.0))
    documented = computed(TEMPLATE, described(load__slope=-60.0, load__friction=0.0))
    lossless = 6 * 9.81 * math.sin(math.radians(60)) / (1000 * math.pi)
    assert value("phases", "level")[0] == pytest.approx(-lossless * 0.45, rel=1e-12)
    assert documented("phases", "level")[0] == pytest.approx(-lossless / 0.45, rel=1e-12)


def test_the_columns_for_a_selection_are_the_load_without_the_motor():
    """T_m = T*_L + J_m ω̇_L in every row, and the exact means are those of the same columns."""
    value = computed(TEMPLATE, described(method="physical"))
    w, dw, load, torque = (np.array(value("cycle", c)) for c in ("w", "dw", "total", "torque"))
    assert torque == pytest.approx(load + value("act_jm") * dw, abs=1e-15)
    assert w.max() == pytest.approx(value("act_wmax"), rel=1e-12)
    square = (
        value("act_lrms") ** 2 + 2 * value("act_jm") * value("act_lmean") + (value("act_jm") * value("act_wrms")) ** 2
    )
    assert math.sqrt(square) == pytest.approx(value("act_rms"), rel=1e-12)


@pytest.mark.parametrize(
    ("changed", "failed"),
    [
        ({"motor__rated_torque": 0.0437}, "act_ok_rms"),
        ({"motor__peak_torque": 0.102}, "act_ok_peak"),
        ({"motor__max_speed": 1439.0}, "act_ok_speed"),
    ],
)
def test_a_motor_that_is_too_small_fails_one_check(changed, failed):
    value = computed(TEMPLATE, described(**changed))
    checks = ("act_ok_rms", "act_ok_peak", "act_ok_speed")
    assert [name for name in checks if value(name) == "FAIL"] == [failed]
    assert value("overall") == "FAIL"


def test_the_variations_take_every_mechanism_and_fail_every_limit():
    machines = TEMPLATE.variants(described())
    assert {machine.actuator.mechanism for machine in machines} == set(get_args(Kind))
    books = [TEMPLATE.declare(machine) for machine in machines]
    failed = {q.name for book in books for _, q in book.checks if q.value == "FAIL"}
    assert {"act_ok_rms", "act_ok_peak", "act_ok_speed"} <= failed


@pytest.mark.parametrize("seed", range(6))
def test_pycel_agrees_at_machines_drawn_at_random(seed):
    machine = TEMPLATE.model.model_validate(varied(entries(), random.Random(seed)))
    assert disagreeing(TEMPLATE, machine)[0] == []


@pytest.mark.parametrize("mechanism", ["conveyor", "gear train"])
def test_another_mechanism_chosen_in_the_book(mechanism, tmp_path, build_book):
    """The lead screw's book, another entry taken from the drop-down, saved: cells and engine follow alike."""
    path = build_book(described(output__diameter=60.0, load__inertia=0.01, load__torque=0.2), tmp_path / "b.xlsx")
    book = openpyxl.load_workbook(path)
    sheet, cell = next(book.defined_names["act_mechanism"].destinations)
    book[sheet][cell] = mechanism
    book.save(path)
    report = verify(path)
    assert report.findings == []
    machine, lost = inputs(path)
    assert (machine.actuator.mechanism, lost) == (mechanism, [])


@pytest.mark.parametrize(
    ("changed", "line"),
    [
        ({"mechanism": "cam"}, "mechanism.*found 'cam'; expected lead screw, conveyor, .* or gear train"),
        (
            {"phases": [{"law": "CIC", "lift": 1.0, "duration": 1.0}] * 7},
            "7 rows do not fit into 6; raise sizes.phases",
        ),
    ],
)
def test_entries_that_cannot_be_get_one_line(changed, line):
    with pytest.raises(InputError, match=line) as found:
        checked(TEMPLATE, entries(**changed), str)
    assert len(found.value.lines) == 1


@pytest.mark.parametrize("path", [TEMPLATE.description, CONVEYOR], ids=["screw", "conveyor"])
def test_the_committed_books_verify(path):
    assert verify(path.with_suffix(".xlsx")).findings == []
