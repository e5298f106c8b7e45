"""S4's lead screw and conveyor as axes of a machine: exact figures, cylinders, temperature."""

import math

import pytest

from engine.drive import cylinder
from tests.workbook.cells import computed
from workbook.errors import InputError
from workbook.reading.descriptions import read_machine, validated
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["machine"]
SCREW = FOLDER / "actuator-sizing.toml"
SMALL = {"cycle": 24, "law": 8, "motors": 5, "reducers": 5, "phases": 3}
PINION = {"kind": "rack and pinion", "pinion_diameter": 30.0}


def entries(**changed):
    """A committed description with small tables; ``load__mass=3`` changes an entry of the axis."""
    data = read_machine(SCREW).model_dump()
    data["sizes"] |= SMALL
    choice = data["selection"]
    data["selection"] = {"motors": choice["motors"][:5], "reducers": choice["reducers"][:5]}
    axis = data["axes"][0]
    for name, value in changed.items():
        part, _, entry = name.rpartition("__")
        (axis[part] if part else axis)[entry] = value
    return data


def described(**changed):
    return validated(TEMPLATE, entries(**changed), str)


def test_a_cylinder_is_the_part_of_its_inertia():
    size = {"name": "Drum", "count": 2.0, "shaft": "motor"}
    whole = size | {"diameter": 80.0, "length": 120.0, "density": 7800.0, "bore": 30.0}
    inertia = cylinder(0.08, 0.12, 7800.0, 0.03)
    by_size, by_inertia = (
        computed(TEMPLATE, described(parts=[part])) for part in (whole, size | {"inertia": inertia * 1e4})
    )
    for name in ("jtot", "tmax", "tmin", "rms"):
        assert by_size(f"drive1_{name}") == pytest.approx(by_inertia(f"drive1_{name}"), rel=1e-13)


@pytest.mark.parametrize(("temperature", "share"), [(None, 1.0), (10.0, 1.0), (100.0, math.sqrt(75 / 150))])
def test_what_is_around_the_motor_lowers_its_rated_torque_and_the_highest_rate(temperature, share):
    cool, here = (computed(TEMPLATE, described(motor__temperature=one)) for one in (None, temperature))
    assert here("drive1_motor_rated") == pytest.approx(0.08 * share, rel=1e-12)
    assert here("drive1_res_rms") == pytest.approx(cool("drive1_res_rms") * share, rel=1e-12)
    assert (here("drive1_highest") < cool("drive1_highest")) == (share < 1.0)


def test_a_motor_too_hot_is_built_and_fails():
    hot = described(motor__temperature=200.0)
    assert [fault.message for fault in hot.design.faults] == ["200 °C; expected less than the limit, 175 °C"]
    assert computed(TEMPLATE, hot, by_cells=True)("drive1_ok_cool") == "FAIL"


@pytest.mark.parametrize(
    ("changed", "line"),
    [
        ({"mechanism": PINION | {"belt_mass": 3.0}}, "mechanism.belt_mass: unknown entry; expected"),
        ({"mechanism__method": "lossless"}, "found 'lossless'; expected physical or document"),
    ],
)
def test_entries_that_cannot_be_get_one_line(changed, line):
    with pytest.raises(InputError, match=line) as found:
        described(**changed)
    assert len(found.value.lines) == 1
