"""S4's lead screw and conveyor as axes of a machine: printed figures, losses its way, cylinders, belts, temperature."""

import math

import openpyxl
import pytest

from engine.drive import KINDS, Part, Slide, Stage, cylinder
from engine.laws import Dwell, TrapezoidalVelocity
from engine.motion import Phase
from tests.engine.sizing import Sizing
from tests.workbook.cells import computed, disagreeing
from workbook.build import read_inputs
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.machines.machine.printed import FIGURES
from workbook.reading.descriptions import read_machine, validated
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
SCREW, CONVEYOR = (FOLDER / f"actuator-sizing{name}.toml" for name in ("", "-conveyor"))
SMALL = {"cycle": 24, "law": 8, "motors": 5, "reducers": 5, "phases": 3}
PINION = {"kind": "rack and pinion", "pinion_diameter": 30.0}
THERE_AND_BACK = [
    {"start": 0.0, "stop": 0.1, "lift": 160.0, "law": "TVP"},
    {"start": 0.15, "stop": 0.28, "lift": -160.0, "law": "TVP"},
]


def entries(path=SCREW, **changed):
    """A committed description with small tables; ``load__mass=3`` changes an entry of the axis."""
    data = read_machine(path).model_dump()
    data["sizes"] |= SMALL
    choice = data["selection"]
    data["selection"] = {"motors": choice["motors"][:5], "reducers": choice["reducers"][:5]}
    axis = data["axes"][0]
    for name, value in changed.items():
        part, _, entry = name.rpartition("__")
        (axis[part] if part else axis)[entry] = value
    return data


def described(path=SCREW, **changed):
    return validated(TEMPLATE, entries(path, **changed), str)


def test_s4_lead_screw():
    """Printed figures with the tolerance of their digits; where S4 is misprinted or rounded, the exact ones only."""
    value = computed(TEMPLATE, described())
    assert value("drive1_parts", "one")[0] == pytest.approx(0.1470878, abs=5e-8)  # printed 1.47e-5
    here = value("drive1_printed", "here")
    assert here[2] == pytest.approx(2e-5, abs=5e-7)
    assert [figure * 9.8 / 9.81 for figure in here[3:5]] == pytest.approx([4.096e-3, 7.22e-3], abs=5e-6)
    assert here[8] == pytest.approx(1440 * math.pi, rel=1e-12)  # printed 1460.4 π, of 0.033 s
    assert here[9:12] == pytest.approx([0.103, 0.0113, -0.0805], abs=1.1e-3)
    assert value("drive1_rms") == pytest.approx(0.044, abs=5e-4)
    failing = [q.name for _, q in TEMPLATE.declare(described()).checks if q.value == "FAIL"]
    assert failing == []


def test_s4_conveyor():
    value = computed(TEMPLATE, described(CONVEYOR))
    light = 1.509848 * (1 - 9.8 / 9.81)  # S4 worked with g = 9.8
    here = value("drive1_printed", "here")
    assert value("drive1_parts", "all")[0] / 2500 == pytest.approx(49.6, abs=5e-2)
    assert (here[1], here[2]) == pytest.approx((6.4e-3, 0.0128), abs=5e-5)
    assert [figure - light for figure in here[9:12]] == pytest.approx([1.5343, 1.508, 1.4816], abs=5e-4)
    assert value("drive1_speed") * math.pi / 30 == pytest.approx(6.173, abs=5e-4)
    assert value("drive1_derate") == pytest.approx(math.sqrt(140 / 150), rel=1e-12)
    assert value("drive1_motor_rated") == pytest.approx(1.6 * math.sqrt(140 / 150), rel=1e-12)
    assert value("overall") == "OK"


@pytest.mark.parametrize(("path", "side"), [(SCREW, 0), (CONVEYOR, 1)], ids=["screw", "conveyor"])
def test_the_figures_called_exact_are_those_of_the_book_as_delivered(path, side):
    exact = [figure.exact[side] for figure in FIGURES]
    assert computed(TEMPLATE, described(path))("drive1_printed", "here") == pytest.approx(exact, rel=2e-6)


@pytest.mark.parametrize("path", [SCREW, CONVEYOR], ids=["screw", "conveyor"])
def test_the_document_s_sums_are_the_extremes_that_the_drive_has_by_its_pieces(path):
    value = computed(TEMPLATE, described(path))
    accelerating, decelerating = value("drive1_printed", "here")[9], value("drive1_printed", "here")[11]
    assert value("drive1_tmax") == pytest.approx(accelerating, rel=1e-12)
    assert value("drive1_tmin") == pytest.approx(min(0.0, decelerating), rel=1e-12)  # 0: the brake holds


@pytest.mark.parametrize("method", ["document", "physical"])
@pytest.mark.parametrize("slope", [10.0, 75.0, -75.0])
def test_rms_and_peak_are_those_of_the_closed_forms_either_way_of_losses(method, slope):
    """The sheet integrates its stretches; :class:`engine.drive.Sizing` has the mean squares in closed form."""
    law = TrapezoidalVelocity(1 / 6, 5 / 6)
    load = Slide(6, 0.1, math.radians(slope)).load
    mechanism = KINDS["lead screw"].of(load, 500, 0.45, parts=[Part("screw", cylinder(0.014, 0.5, 7800))])
    phases = [Phase(law, 0.16, 0.1), Phase(Dwell(), 0, 0.05), Phase(law, -0.16, 0.13), Phase(Dwell(), 0, 0.02)]
    sizing = Sizing(mechanism, phases, 4.01493221e-6, method, "brake")
    value = computed(
        TEMPLATE,
        described(mechanism__method=method, mechanism__back_efficiency=0.45, load__slope=slope, phases=THERE_AND_BACK),
    )
    assert value("drive1_rms") == pytest.approx(sizing.rms_torque, rel=1e-10)
    assert max(value("drive1_tmax"), -value("drive1_tmin")) == pytest.approx(sizing.peak_torque, rel=1e-12)


def test_losses_as_the_document_has_them_never_help_to_brake():
    falling = {
        "load__slope": -60.0,
        "load__friction": 0.0,
        "phases": THERE_AND_BACK,
        "parts": [],
        "motor__inertia": 0.0,
    }
    by_power, documented = (
        computed(TEMPLATE, described(mechanism__method=way, **falling)) for way in ("physical", "document")
    )
    assert by_power("drive1_returned") < by_power("drive1_energy")
    assert documented("drive1_returned") == pytest.approx(documented("drive1_energy"), rel=1e-9)  # 1/η both ways
    lossless = 6 * 9.81 * math.sin(math.radians(60)) * 0.16
    assert by_power("drive1_energy") - by_power("drive1_returned") > lossless * (1 / 0.45 - 0.45) * 0.99


@pytest.mark.parametrize("law", ["CIC", "TVP"])
def test_every_cell_agrees_with_losses_as_the_document_has_them_where_the_load_drives(law):
    phases = [phase | {"law": law} for phase in THERE_AND_BACK]
    data = entries(mechanism__method="document", load__slope=-70.0, motor__holding="motor", phases=phases)
    data["selection"]["axis"] = "Slide"
    data["axes"][0]["motor"]["temperature"] = 90.0
    assert disagreeing(TEMPLATE, TEMPLATE.model.model_validate(data))[0] == []


def test_a_cylinder_is_the_part_of_its_inertia():
    size = {"name": "Drum", "count": 2.0, "shaft": "motor"}
    whole = size | {"diameter": 80.0, "length": 120.0, "density": 7800.0, "bore": 30.0}
    inertia = cylinder(0.08, 0.12, 7800.0, 0.03)
    by_size, by_inertia = (
        computed(TEMPLATE, described(parts=[part])) for part in (whole, size | {"inertia": inertia * 1e4})
    )
    for name in ("jtot", "tmax", "tmin", "rms"):
        assert by_size(f"drive1_{name}") == pytest.approx(by_inertia(f"drive1_{name}"), rel=1e-13)


def test_a_belt_moves_with_the_load_and_weighs_nothing():
    """A mass more would pull on the slope; the belt's own halves balance each other."""
    bare, belted, heavier = (
        computed(TEMPLATE, described(CONVEYOR, mechanism__belt_mass=belt, load__mass=mass))
        for belt, mass in ((None, 150.0), (10.0, 150.0), (None, 160.0))
    )
    assert belted("drive1_steady") == bare("drive1_steady") < heavier("drive1_steady")
    assert belted("drive1_jtot") - bare("drive1_jtot") == pytest.approx(10 * 15**2 / 50**2, rel=1e-9)  # kg cm²
    assert belted("drive1_jtot") == pytest.approx(heavier("drive1_jtot"), rel=1e-13)


@pytest.mark.parametrize(("temperature", "share"), [(None, 1.0), (10.0, 1.0), (100.0, math.sqrt(75 / 150))])
def test_what_is_around_the_motor_lowers_its_rated_torque_and_the_highest_rate(temperature, share):
    cool, here = (computed(TEMPLATE, described(motor__temperature=one)) for one in (None, temperature))
    assert here("drive1_motor_rated") == pytest.approx(0.08 * share, rel=1e-12)
    assert here("drive1_res_rms") == pytest.approx(cool("drive1_res_rms") * share, rel=1e-12)
    assert (here("drive1_highest") < cool("drive1_highest")) == (share < 1.0)


def test_a_motor_too_hot_is_built_and_fails():
    hot = described(motor__temperature=200.0)
    assert [fault.message for fault in hot.design.faults] == ["200 °C; expected less than the limit, 175 °C"]
    book = TEMPLATE.declare(hot)
    assert [q.label for _, q in book.checks if q.value == "FAIL" and not q.name.startswith("bus_")] == [
        "Drive Slide: ambient temperature below the limit"
    ]


@pytest.mark.parametrize(
    ("changed", "line"),
    [
        ({"mechanism": PINION | {"belt_mass": 3.0}, "printed": None}, "mechanism.belt_mass: unknown entry; expected"),
        ({"mechanism": {"kind": "belt", "pulley_diameter": 30.0}}, "printed: S4 has no belt; expected none"),
        ({"mechanism__method": "lossless"}, "found 'lossless'; expected physical or document"),
        ({"printed": "S9"}, "found 'S9'; expected S4"),
    ],
)
def test_entries_that_cannot_be_get_one_line(changed, line):
    with pytest.raises(InputError, match=line) as found:
        described(**changed)
    assert len(found.value.lines) == 1


@pytest.mark.parametrize("path", [SCREW, CONVEYOR], ids=["screw", "conveyor"])
@pytest.mark.sample(1)
def test_the_committed_books_tell_their_sheet_of_figures(path, committed_book):
    machine, notes = read_inputs(committed_book(path))
    assert (machine.axes[0].printed, notes) == ("S4", [])


def test_losses_chosen_in_the_book(tmp_path, build_book):
    """Another entry taken from the drop-down, saved: cells and engine follow alike."""
    path = build_book(described(load__slope=-60.0), tmp_path / "b.xlsx")
    book = openpyxl.load_workbook(path)
    sheet, cell = next(book.defined_names["drive1_method"].destinations)
    book[sheet][cell] = "physical"
    book.save(path)
    assert verify(path).findings == []
    assert read_inputs(path)[0].axes[0].mechanism.method == "physical"


def test_the_engine_s_conveyor_with_losses_and_friction():
    load, rollers = Slide(150, 0.05, math.radians(20)).load, Part("rollers", cylinder(0.3, 1.0, 7800), 1, 2)
    mechanism = KINDS["conveyor"].of(load, 0.3, gears=[Stage("gear", 50, 0.9)], parts=[rollers], belt=10)
    phases = [Phase(TrapezoidalVelocity(0.1, 0.9), 0.5, 30), Phase(Dwell(), 0, 3)]
    data = entries(CONVEYOR, load__friction=0.05, mechanism__method="physical", motor__holding="motor")
    data["axes"][0]["reducer"]["efficiency"] = 0.9
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(data))
    sizing = Sizing(mechanism, phases, 0.006402146)
    assert value("drive1_rms") == pytest.approx(sizing.rms_torque, rel=1e-11)
    assert value("drive1_tmax") == pytest.approx(sizing.peak_torque, rel=1e-12)
