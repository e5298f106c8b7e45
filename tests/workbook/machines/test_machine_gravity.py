"""Gravity: one entry for all drives of a machine, in the cells and in the engine."""

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described, driven
from tests.workbook.machines.test_machine_forces import RISE

MOON = 1.62  # m/s²
LEAD = 0.01 / 6.283185307179586  # of the screw, m/rad
HOISTED = {"mass": 20.0, "friction": 0.1, "slope": 90.0}


def hoist(gravity, **load):
    """A machine of one vertical axis on a screw without losses."""
    told = described([driven(*RISE, load=HOISTED | load)], phases=2, rotors=2)
    return told.model_copy(update={"gravity": gravity})


def test_a_weight_is_held_by_the_gravity_that_is_entered():
    """m g of 20 kg at rest, through the screw: in the table without motion, on the moon and on earth."""
    for gravity in (MOON, 9.81, 0.0):
        value = computed(TEMPLATE, hoist(gravity))
        assert value("drive1_pt", "T0")[0] == pytest.approx(20.0 * gravity * LEAD, rel=1e-12)


def test_friction_of_a_level_axis_follows_it_too():
    """μ m g · 2 h over a cycle there and back."""
    value = computed(TEMPLATE, hoist(MOON, slope=0.0))
    net = value("drive1_energy") - value("drive1_returned")
    assert net == pytest.approx(0.1 * 20.0 * MOON * 0.04, rel=1e-9)


def test_cells_agree_with_the_engine_and_the_entry_comes_back():
    machine = hoist(MOON)
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])


def test_a_machine_without_a_weight_has_no_such_entry():
    data = described([axis(1, *RISE)]).model_dump() | {"gravity": MOON}
    with pytest.raises(ValueError, match="no axis with a drive has a weight; expected none"):
        TEMPLATE.model.model_validate(data)
