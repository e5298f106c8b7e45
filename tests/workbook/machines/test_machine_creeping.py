"""A drive that creeps at 1 cycle/min, as a machine starts up: in closed form, empty and loaded, on every surface."""

import math

import pytest

from engine.drive.drive_points import stated_bounds
from engine.drive.limits import creeping
from tests.workbook.cells import computed, entered
from tests.workbook.machines.drawn_drives import drawn_machine
from tests.workbook.machines.test_exact_decides import studied
from tests.workbook.machines.test_machine import RATIO, RISE, TEMPLATE, driven, small
from workbook.machines.machine.exact import drives_of, judgement
from workbook.reading.descriptions import write_machine

FAST = {"inertia": 8.0, "rated_torque": 9.0, "peak_torque": 30.0, "max_speed": 30000.0}
NAMES = ["RMS torque", "peak torque", "reducer peak torque", "reducer mean torque"]
REDUCER = {"ratio": 4.0, "efficiency": 0.8, "no_load_torque": 0.02, "peak_torque": 1e3, "mean_torque": 1e3}


def loaded(machine):
    """The same machine with its process forces while it creeps."""
    return machine.model_copy(update={"creep_forces": "on"})


def screwed(*windows, motor=FAST, **load):
    """A screw without losses of its own, behind a reducer with some."""
    mass = {"mass": 20.0, "friction": 0.1} | load
    return driven(*RISE, load=mass | {"windows": [*windows]}, motor=motor, reducer=REDUCER)


def test_what_stands_on_a_screw_is_friction_over_its_ratio_and_inertia_next_to_nothing():
    """Of a rise and a return over 120 of 360° against μ m g; at 1 of 200 cycles/min inertia is 1/40,000 of its own."""
    machine = small([screwed()])
    (view,) = drives_of(machine)
    behind = 0.1 * 20.0 * 9.81 / RATIO
    motor = behind / 0.8 / 4.0 + 0.02
    bound = float(abs(view.points.torque - view.points.standing).max()) / 200.0**2
    found = dict(zip(NAMES, computed(TEMPLATE, machine)("drive1_creep", "value"), strict=True))
    assert found["peak torque"] == pytest.approx(motor, abs=bound)
    assert found["RMS torque"] == pytest.approx(motor * math.sqrt(120 / 360), abs=bound)
    assert found["reducer peak torque"] == pytest.approx(behind, abs=4.0 * bound)
    assert found["reducer mean torque"] == pytest.approx(behind, abs=4.0 * bound)


def test_a_press_that_holds_at_its_rate_fails_while_it_creeps_loaded_and_not_empty(tmp_path):
    """The force acts while the screw is braked: at the rate inertia takes half of it."""
    swift = FAST | {"rated_torque": 1e3, "peak_torque": 1e3}
    inertia = max(view.peaks.size("T") for view in drives_of(small([screwed(motor=swift)])))
    window = {"start": 68.0, "stop": 82.0, "force": 1.5 * inertia * 0.8 * 4.0 * RATIO}
    machine = small([screwed(window, motor=swift | {"peak_torque": 1.05 * inertia})])
    path = tmp_path / "press.toml"
    for made, verdict in ((machine, "OK"), (loaded(machine), "FAIL")):
        value = computed(TEMPLATE, made)
        assert (value("drive1_ok_peak"), value("drive1_ok_creep")) == ("OK", verdict)
        path.write_text(write_machine(made), encoding="utf-8")
        table = studied(path)
        assert table.fails["drive1_ok_creep"].tolist() == [verdict == "FAIL"]
        assert bool(table.feasible[0]) == (verdict == "OK")
        assert entered(TEMPLATE, made) == (made, [])
    (limit,) = (one for one in judgement(loaded(machine)).limits if one.check == "drive1_ok_creep")
    assert not limit.exact.ok
    assert limit.exact.value == pytest.approx(100.0 * 1.5 / 1.05, rel=2e-3)
    assert limit.sheet.value == pytest.approx(limit.exact.value, rel=1e-6)


def test_a_drive_slower_than_a_cycle_a_minute_creeps_at_its_own_rate():
    machine = loaded(small([screwed({"start": 20.0, "stop": 120.0, "force": 500.0}) | {"rate": 0.4}]))
    value = computed(TEMPLATE, machine)
    assert value("drive1_slow") == 1.0
    assert value("drive1_creep", "value")[0] == pytest.approx(value("drive1_rms"), rel=1e-12)
    assert value("drive1_creep", "value")[3] == pytest.approx(value("drive1_smean"), rel=1e-12)


@pytest.mark.parametrize("number", range(30))
@pytest.mark.sample(3)
def test_points_and_exact_engine_agree_on_what_a_drawn_drive_needs_creeping(number):
    """Of all mechanisms, to the bounds that the sheet states of those at its rate; the reducer's mean to 0.5 %."""
    made = drawn_machine(number, "creeping")
    for machine in (made, loaded(made)):
        for view in drives_of(machine):
            driven_by = view.driven.limit_checks
            exact = creeping(driven_by, view.creeps_loaded)
            results, bound = exact.results, stated_bounds(exact.drive_cycle.train)
            peak, behind = results.torque.peak, results.shaft_torque(1).peak
            rms, most, most_behind, mean_behind = (check.value for check in view.creep_checks)
            assert most == pytest.approx(peak, abs=bound.peak_torque * peak)
            assert rms == pytest.approx(results.rms_torque, abs=bound.rms_torque * peak)
            assert most_behind == pytest.approx(behind, abs=bound.peak_torque * behind)
            assert mean_behind == pytest.approx(results.mean_shaft_torque(1), abs=5e-3 * behind)
