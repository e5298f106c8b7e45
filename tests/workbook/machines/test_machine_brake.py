"""A motor's brake in cells: which dwells it holds, the load at rest in closed form, entries, Selection."""

from math import pi, sqrt

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from tests.workbook.machines.test_machine_selection_placed import choosing, require_pairs_of_the_grid

PHASES = ((30, 120, 20.0, "CIC"), (150, 240, -20.0, "CIC"))  # dwells of 30° and 150°, the latter across the end
RACK = {"kind": "rack and pinion", "pinion_diameter": 100.0}
MOTOR = {"inertia": 10.0, "rated_torque": 200.0, "peak_torque": 450.0, "max_speed": 13000.0, "holding": "brake"}
SHORT, LONG = (60 / 60 * share * 1000 for share in (30 / 360, 150 / 360))  # ms at 60 cycles/min
STATIC = 4000.0 * 0.05 / 0.9 / 2.0  # Nm


def lifted(brake, **entries):
    """A rack and pinion Ø100 with 4,000 N always, behind a reducer of 2."""
    more = {"mechanism": RACK | {"efficiency": 0.9}, "load": {"mass": 5.0, "force": 4000.0}, "reducer": {"ratio": 2.0}}
    return axis(1, *PHASES) | {"rate": 60.0} | more | {"motor": MOTOR | {"brake": brake}} | entries


def squares(value):
    """The mean square torque of the motor, Nm²."""
    return value("drive1_rms") ** 2


@pytest.mark.parametrize(
    ("times", "share", "held"),
    [((0, 0), 0, STATIC), ((SHORT / 2, SHORT / 2), 0, STATIC), ((SHORT, 1), 30, STATIC), ((1, LONG), 180, 0)],
)
def test_the_motor_holds_in_dwells_too_short_for_the_brake(times, share, held):
    brake = {"torque": 120.0, "closing": times[0], "opening": times[1]}
    machine, never = (described([lifted(one)]) for one in (brake, None))
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])
    value = computed(TEMPLATE, machine)
    assert squares(value) - squares(computed(TEMPLATE, never)) == pytest.approx(share / 360 * STATIC**2, abs=1e-6)
    assert value("drive1_brake_load") == pytest.approx(held)
    assert value("drive1_smax") == pytest.approx(computed(TEMPLATE, never)("drive1_smax"))


@pytest.mark.parametrize(("torque", "verdict"), [(STATIC * 1.001, "OK"), (STATIC * 0.999, "FAIL")])
@pytest.mark.parametrize("holding", ["motor", "brake"])
def test_the_brake_must_hold_the_load_at_rest(torque, verdict, holding):
    one = lifted({"torque": torque}) | {"motor": MOTOR | {"brake": {"torque": torque}, "holding": holding}}
    value = computed(TEMPLATE, described([one]))
    assert value("drive1_ok_brake") == (verdict if holding == "brake" else "OK")


@pytest.mark.parametrize("closing", [1.0, SHORT + 1.0])
def test_pairs_of_selection_rest_as_the_drive_does(closing):
    one = lifted({"torque": 500.0, "closing": closing})
    given = choosing(one)
    assert disagreeing(TEMPLATE, given)[0] == []
    require_pairs_of_the_grid(one, ((4, 2), (2, 4)))


def test_a_drive_without_figures_of_a_brake_has_no_cells_of_them():
    value = computed(TEMPLATE, described([lifted(None)]))
    with pytest.raises(KeyError):
        value("drive1_brake_torque")
    assert squares(value) < sqrt(2) * STATIC**2
    assert value("drive1_speed") == pytest.approx(0.02 * 2 / (0.25 * 1.0) / 0.05 * 2 * 30 / pi)
