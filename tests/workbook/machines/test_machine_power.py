"""Energy of a machine's drives: against the engine's sum over all drives' power, and by the hour."""

import pytest

from engine.machine.bus import Drivetrains
from tests.workbook.cells import computed, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, driven
from tests.workbook.machines.test_machine_forces import RISE, small
from workbook.laws.library import laws
from workbook.machines.machine.chain import PowerEntry
from workbook.machines.machine.driven import Driven
from workbook.machines.machine.view import Whole

POWER = PowerEntry(efficiency=0.9, hours=4000.0)
AXES = [driven(*RISE, reducer={"ratio": 3.0, "efficiency": 0.8}),
        driven(*RISE, shift=30.0, load={"mass": 8.0, "slope": 90.0}) | {"name": "A2"}]  # fmt: skip


def machine(axes=AXES, power=POWER):
    """A machine of two drives."""
    return small(axes).model_copy(update={"power": power})


def test_the_sums_are_those_of_the_power_of_all_drives():
    made = machine()
    value, whole = computed(TEMPLATE, made), Whole(made, laws(made.laws))
    courses = tuple(Driven(one, made.selection).demand.course for one in whole.axes)
    together = Drivetrains(courses, POWER.efficiency)
    alone, common = together.supply(False), together.supply(True)
    assert value("power_mains") == pytest.approx(alone.mains_mean, rel=1e-9)
    assert value("power_resistors") == pytest.approx(alone.resistor_mean, rel=1e-9)
    assert value("power_year") == pytest.approx(alone.energy_a_year(4000.0) / 3.6e6, rel=1e-9)
    assert value("power_least") < common.mains_mean < value("power_mains")


def test_a_drive_at_a_rate_of_its_own_counts_at_that_rate():
    slow = computed(TEMPLATE, machine([AXES[0] | {"rate": 50.0}]))
    assert slow("power", "time") == [pytest.approx(1.2)]
    energy = slow("drive1_energy") / 0.9 / 1.2
    assert slow("power_mains") == pytest.approx(energy, rel=1e-12)


def test_the_entries_come_back_and_a_machine_without_drives_has_none():
    assert entered(TEMPLATE, machine()) == (machine(), [])
    still = [axis(1, *RISE)]
    assert "power" not in TEMPLATE.declare(small(still)).blocks
    with pytest.raises(ValueError, match="no axis has a drive"):
        TEMPLATE.model.model_validate(small(AXES).model_dump() | {"axes": still, "power": {"hours": 1.0}})
