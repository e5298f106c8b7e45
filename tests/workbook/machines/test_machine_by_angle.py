"""A press crank and a swinging arm in cells: known figures, work over a turn, every variation, what is refused."""

import math

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from tests.workbook.machines.test_machine_linked import MOTOR
from workbook.reading.descriptions import validated

PRESS = {"kind": "press crank", "crank_radius": 60.0, "rod_length": 240.0, "efficiency": 1.0}
GEARS = {"kind": "gear train", "efficiency": 1.0}
REDUCER = {"ratio": 5.0, "efficiency": 1.0}
TURN = ((0.0, 360.0, 360.0, "LIN"),)
R, ROD, OMEGA = 0.06, 0.24, 2 * math.pi / 0.3  # m, m, rad/s at 200 a minute
WINDOW = {"start": 120.0, "stop": 180.0, "force": 2000.0}


def small(*axes):
    """A machine of these axes with little room, and straight lines among its laws."""
    data = described(phases=2, rotors=2).model_dump()
    data["laws"] |= {"LIN": {"family": "LIN"}}
    others = {"axes": [*axes], "switches": [], "clearances": [], "power": {}, "selection": {}}
    return TEMPLATE.model.model_validate(data | others)


def press(*phases, mechanism=PRESS, **entries):
    """A crank of one turn a cycle, and its slide."""
    more = {"load": {"mass": 20.0}, "motor": MOTOR, "reducer": REDUCER}
    return axis(1, *(phases or TURN), unit="°", closes="feed") | {"mechanism": mechanism} | more | entries


def arm(*phases, **entries):
    """An arm of 10 kg at 0.3 m that begins 20° below the horizontal."""
    load = {"inertia": 9000.0, "friction_torque": 0.4, "arm": {"mass": 10.0, "radius": 300.0, "angle": -20.0}}
    more = {"mechanism": GEARS, "load": load, "motor": MOTOR, "reducer": REDUCER}
    return axis(1, *(phases or TURN), unit="°", closes="feed") | more | entries


LOSSY = {
    "load": {"mass": 20.0, "friction": 0.1, "slope": -80.0, "viscous": 30.0,
             "windows": [WINDOW, {"start": 300.0, "stop": 40.0, "force": 60.0, "resists": "moving"}]},
    "parts": [{"name": "Flywheel", "count": 1.0, "inertia": 400.0, "shaft": "mechanism"}],
    "reducer": {"ratio": 7.0, "efficiency": 0.9, "no_load_torque": 0.1}, "shift": 33.0,
}  # fmt: skip
INDEXED = ((10.0, 150.0, 200.0, "MTP"), (170.0, 330.0, 160.0, "CIC"))
AXES = {
    "press": press(*INDEXED, mechanism=PRESS | {"efficiency": 0.85, "offset": 9.0, "start_angle": 180.0}, **LOSSY),
    "to and fro": press((20.0, 140.0, 250.0, "CIC"), (190.0, 330.0, -250.0, "MTP"), **LOSSY) | {"closes": "position"},
    "arm": arm((20.0, 140.0, 90.0, "CIC"), (190.0, 330.0, -90.0, "MTP"), closes="position"),
}


@pytest.mark.parametrize("name", AXES)
def test_cells_agree_with_the_engine_and_entries_come_back(name):
    machine = small(AXES[name])
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert entered(TEMPLATE, machine) == (machine, [])


def test_the_slide_in_its_dead_centres_is_that_of_the_textbook():
    """x = r cos φ + √(l² − r² sin² φ); at constant speed ẍ = ∓r ω² (1 ± r/l) in the outer and the inner one."""
    value = computed(TEMPLATE, small(press()))
    rows = {round(theta): k for k, theta in enumerate(value("drive1_pt", "theta"))}
    for degrees, x, acceleration in ((0, ROD + R, -R * 1.25), (90, math.sqrt(ROD**2 - R**2), None),
                                     (180, ROD - R, R * 0.75)):  # fmt: skip
        k = rows[degrees]
        assert value("drive1_pt", "X")[k] == pytest.approx(x, rel=1e-12)
        if acceleration:
            assert value("drive1_pt", "as")[k] == pytest.approx(acceleration * OMEGA**2, rel=1e-9)
            assert value("drive1_pt", "vs")[k] == pytest.approx(0.0, abs=1e-9)
            assert value("drive1_pt", "T")[k] == pytest.approx(0.0, abs=1e-9)


def test_over_a_turn_the_motor_does_the_work_of_friction_and_process_force():
    """∮ T dφ = F Δx + μ m g 4 r: the slide's inertia and its weight ask for none."""
    load = {"mass": 20.0, "friction": 0.2, "windows": [WINDOW]}
    value = computed(TEMPLATE, small(press(mechanism=PRESS | {"start_angle": 180.0}, load=load)))
    way = R * 0.5 + ROD - math.sqrt(ROD**2 - (R * math.sin(math.radians(60))) ** 2)
    net = value("drive1_energy") - value("drive1_returned")
    assert net == pytest.approx(2000.0 * way + 0.2 * 20.0 * 9.81 * 4 * R, abs=1e-5 * value("drive1_energy"))


def test_inertia_at_the_motor_counts_the_slide_where_it_is_fastest():
    """Fastest at about 77° from the outer dead centre of r/l = 1/4, x' = 1.0308 r: at points to 0.1 %."""
    value = computed(TEMPLATE, small(press()))
    assert value("drive1_jtot") == pytest.approx(20.0 * (1.0308 * R) ** 2 / 25.0 * 1e4, rel=2e-3)


def test_an_arm_asks_for_its_moment_by_the_cosine():
    """29.43 Nm level, RMS 29.43/√2 over a turn at constant speed without inertia; by gravity of 1.62 a sixth."""
    load = {"arm": {"mass": 10.0, "radius": 300.0, "angle": -20.0}}
    value = computed(TEMPLATE, small(arm(load=load, motor=MOTOR | {"inertia": 0.0})))
    assert value("drive1_arm") == pytest.approx(29.43, rel=1e-12)
    assert 5.0 * value("drive1_tmax") == pytest.approx(29.43, rel=5e-3)
    assert 5.0 * value("drive1_rms") == pytest.approx(29.43 / math.sqrt(2), rel=1e-3)
    moon = small(arm(load=load, motor=MOTOR | {"inertia": 0.0})).model_copy(update={"gravity": 1.62})
    assert computed(TEMPLATE, moon)("drive1_arm") == pytest.approx(29.43 * 1.62 / 9.81, rel=1e-12)


@pytest.mark.parametrize("made", [press, arm])
@pytest.mark.parametrize(("lift", "verdict"), [(720.0, "OK"), (0.0, "OK"), (270.0, "FAIL")])
def test_a_cycle_ends_at_the_angle_where_it_begins(made, lift, verdict):
    value = computed(TEMPLATE, small(made((0.0, 360.0, lift, "CIC"))))
    assert value("drive1_ok_turns") == verdict
    said = "" if verdict == "OK" else "it ends 270 ° from where it begins"
    assert value("drive1_ok_turns_says").startswith(said)


def test_a_rod_that_is_too_short_fails_by_name_and_is_carried():
    data = small(press()).model_dump()
    data["axes"][0]["mechanism"]["rod_length"] = 50.0
    machine = validated(TEMPLATE, data, str)
    (fault,) = machine.design.faults
    assert fault.key == "axes.0.mechanism"
    assert fault.message == "the rod is not longer than crank and offset: the crank cannot turn round"
    assert computed(TEMPLATE, machine)("drive1_ok_linked") == "FAIL"
    back, lost = entered(TEMPLATE, machine)
    assert (back.design.replaced, lost) == (machine.design.replaced, [])


@pytest.mark.parametrize(
    ("one", "words"),
    [
        (press(load={"inertia": 3.0}), "no entry of a press crank; expected none"),
        (press(load={"arm": {"mass": 3.0}}), "no entry of a press crank; expected none"),
        (arm(load={"mass": 3.0}), "no entry of an axis in °; expected none"),
        (press(unit="mm"), "a press crank does not move an axis in mm"),
    ],
)
def test_what_is_no_load_of_it_is_refused(one, words):
    with pytest.raises(ValueError, match=words):
        small(one)
