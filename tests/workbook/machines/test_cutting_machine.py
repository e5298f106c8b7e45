"""The cutting machine's book: S1's figures in its cells, every formula cell with an engine value, both agree."""

import math

import pytest

from tests.laws import MOVING
from tests.workbook.cells import computed, disagreeing
from workbook.build import build, inputs
from workbook.judging.matching import is_formula
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["cutting-machine"]
pytestmark = pytest.mark.quick


def described(**sizes):
    """The committed description, with smaller tables where speed matters more than resolution."""
    machine = read_machine(TEMPLATE.description)
    return machine.model_copy(update={"sizes": machine.sizes.model_copy(update=sizes)})


def with_law(machine, axis, law):
    """The same machine with another law for the movements of one axis."""
    data = machine.model_dump()
    for phase in data["timing"]["axes"][axis]["phases"]:
        if phase["law"] != "DWL":
            phase["law"] = law
    return type(machine).model_validate(data)


def test_s1_constant_acceleration_shows_the_printed_figures():
    """S1: 0.43 m/rad, 0.61 m/rad², 9 m/s, 270 m/s² for MC01 with C_a = 4."""
    value = computed(TEMPLATE, with_law(described(cycle=12, law=4, own_law=4), 0, "ACS"))
    assert round(value("axis1", "y1")[0], 2) == 0.43
    assert math.floor(value("axis1", "y2")[0] * 100) / 100 == 0.61  # S1 cuts 0.6155 off instead of rounding it
    assert value("axis1", "v")[0] == pytest.approx(9.0, rel=1e-12)
    assert value("axis1", "a")[0] == pytest.approx(270.0, rel=1e-12)


@pytest.mark.parametrize(
    ("law", "y1", "y2", "v", "a"),
    [
        ("ACS", 0.42972, 0.61553, 9.0000, 270.000),
        ("TVP", 0.32229, 0.69247, 6.7500, 303.750),
        ("CUB", 0.32229, 0.92329, 6.7500, 405.000),
        ("CIC", 0.42972, 0.96687, 9.0000, 424.115),
        ("MTP", 0.42972, 0.75219, 9.0000, 329.948),
    ],
)
def test_s1_mc01_rise(law, y1, y2, v, a):
    value = computed(TEMPLATE, with_law(described(cycle=12, law=4, own_law=4), 0, law))
    got = [value("axis1", name)[0] for name in ("y1", "y2", "v", "a")]
    assert got == [pytest.approx(x, abs=5e-6 if x < 1 else 5e-4) for x in (y1, y2, v, a)]


def test_s1_movements_with_the_modified_trapezoidal_law():
    value = computed(TEMPLATE, described(cycle=12, law=4, own_law=4))
    v2, a2, v3, a3 = value("axis2", "v"), value("axis2", "a"), value("axis3", "v"), value("axis3", "a")
    assert (v2[1], a2[1], v2[3], a2[3]) == pytest.approx((1.0667, 69.520, 1.0667, 69.520), abs=5e-4)
    assert (v3[1], a3[1], v3[3], a3[3]) == pytest.approx((2.4000, 87.986, 3.2000, 156.420), abs=5e-4)


@pytest.mark.parametrize(
    ("law", "dw", "highest", "lowest"),
    [
        ("ACS", 503.7313, 653.3433, -519.3433),
        ("MTP", 615.5753, 783.5297, -649.5297),
        ("CIC", 791.2593, 988.0259, -854.0259),
    ],
)
def test_s1_torque_at_the_roller_shaft(law, dw, highest, lowest):
    """S1's feeding group without motor and reducer: J_m = 0, τ = 1, η = 1."""
    data = with_law(described(law=4, own_law=4), 0, law).model_dump()
    data["drive"]["motor"].update(inertia=0.0, reduction=1.0, efficiency=1.0, max_speed=3000.0)
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(data))
    assert value("drive_jtot") == pytest.approx(1.164, abs=1e-12)
    assert value("drive_cr") == pytest.approx(67, abs=1e-12)
    assert max(value("drive", "dw")) == pytest.approx(dw, abs=5e-5)
    assert (value("drive_tmax"), value("drive_tmin")) == pytest.approx((highest, lowest), abs=1e-4)
    assert value("drive_speed") == pytest.approx(320.685, abs=5e-4)


@pytest.mark.parametrize("law", MOVING)
def test_pycel_agrees_with_the_engine_in_every_cell(law):
    machine = described(cycle=72, law=20, own_law=20)
    for axis in range(3):
        machine = with_law(machine, axis, law)
    wrong, count = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert count > 3000


def test_a_book_that_was_built_is_verified_and_comes_back(tmp_path):
    machine, path = described(cycle=24, law=8, own_law=60), tmp_path / "book.xlsx"
    build(machine, path)
    report = verify(path)
    assert report.findings == []
    assert report.own == []
    assert inputs(path) == (machine, [])


def test_the_committed_template_verifies():
    report = verify(TEMPLATE.book)
    assert report.findings == []


@pytest.mark.parametrize("radius", [1e-12, 1e-9, 1e-6])
@pytest.mark.parametrize("resists", ["always", "moving"])
@pytest.mark.sample(2)
def test_rollers_next_to_nothing_verify_clean(radius, resists, tmp_path):
    data = described(cycle=90, law=4, own_law=4).model_dump()
    data["drive"] |= {"radius": radius, "resists": resists}
    build(TEMPLATE.model.model_validate(data), tmp_path / "book.xlsx")
    assert verify(tmp_path / "book.xlsx", ["pycel", "formualizer"]).findings == []


def test_samples_that_all_fall_on_rests_leave_nothing_to_choose_and_cells_and_engine_agree():
    assert disagreeing(TEMPLATE, described(cycle=4, law=4, own_law=4))[0] == []


BEFORE = 17_099
"""formula cells of Timing, without jerk, when every sample looked up phase and law (the committed book of da12479)"""


def test_timing_has_a_fifth_fewer_formula_cells_than_before_motions_were_tables_of_pieces():
    book = TEMPLATE.declare(read_machine(TEMPLATE.description))
    cells = [cell for cell in book.cells() if cell.block.sheet.title == "Timing" and is_formula(cell.content)]
    assert len(cells) <= 0.82 * BEFORE
    assert book.blocks["cycle"].columns.keys() >= {"ggg1", "ggg2", "ggg3"}  # with jerk
