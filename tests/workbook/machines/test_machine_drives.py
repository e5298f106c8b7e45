"""Drives of every mechanism: what a machine may have all at once, what is refused, what fails and by which check."""

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.in_seconds import convert_to_seconds
from tests.workbook.machines.test_machine import RATIO, RISE, TEMPLATE, axis, described, driven
from workbook.errors import InputError
from workbook.fields.paths import put, split
from workbook.machines.machine.mechanism import MECHANISMS
from workbook.reading.descriptions import make_machine

CRANK = {"kind": "crank-slider", "efficiency": 1.0, "crank_radius": 50.0, "rod_length": 200.0, "offset": 10.0,
         "start": 15.0}  # fmt: skip
ROCKER = {"kind": "rocker", "efficiency": 1.0, "lever_length": 90.0, "link_length": 240.0, "offset": 95.0,
          "start_angle": 80.0}  # fmt: skip
PRESS = {"kind": "press crank", "crank_radius": 60.0, "rod_length": 240.0, "efficiency": 1.0}
SCREW = {"kind": "lead screw", "lead": 10.0, "efficiency": 1.0}
BELT = {"kind": "conveyor", "roller_diameter": 150.0, "efficiency": 0.9, "belt_mass": 10.0, "belt_on_bed": 4.5}
TOOTHED = {"teeth_driver": 20.0, "teeth_driven": 43.0, "driver_inertia": 1.3, "driven_inertia": 6.5, "efficiency": 0.93,
           "friction_torque": 0.4}  # fmt: skip
MOTOR = {"inertia": 8.0, "rated_torque": 9.0, "peak_torque": 30.0, "max_speed": 4500.0}
TURN = (0.0, 360.0, 360.0, "LIN")
OUT = ((20, 140, 60.0, "CIC"), (190, 330, -60.0, "MTP"))
SHORT = ((20, 140, 20.0, "CIC"), (190, 330, -20.0, "MTP"))
SLOW = ((30, 90, 20.0, "CIC"), (180, 300, -20.0, "CIC"))
LOSSY = {
    "load": {"mass": 12.0, "friction": 0.1, "slope": 30.0,
             "windows": [{"start": 100.0, "stop": 150.0, "force": 400.0}]},
    "parts": [{"name": "Crank", "count": 1.0, "inertia": 40.0, "shaft": "mechanism"}],
    "reducer": {"ratio": 5.0, "efficiency": 0.9}, "shift": 33.0,
}  # fmt: skip


def points(*pairs):
    """Points of a table: angle in °, position."""
    return [{"angle": float(angle), "position": float(position)} for angle, position in pairs]


def table(*pairs, **entries):
    """A mechanism told by points."""
    return {"kind": "table", "efficiency": 1.0, "points": points(*pairs)} | entries


TABLE = table(*((30.0 * k, 13.0 * k + 0.2 * k * k) for k in range(6)))
BENT = table((-20, -5), (20, 3), (70, 15), (130, 26), efficiency=0.85)


def linked(*phases, mechanism=CRANK, **entries):
    """An axis on a mechanism."""
    more = {"mechanism": mechanism, "load": {"mass": 12.0}, "motor": MOTOR}
    return axis(1, *(phases or OUT)) | more | entries


def some_mechanism(kind):
    """A mechanism of a kind with any sizes."""
    model = MECHANISMS[kind]
    sizes = {model.SIZE: 1.0} if model.SIZE else model.LARGE
    return model.model_validate({"kind": kind, "efficiency": 1.0} | sizes)


def press(*phases, mechanism=PRESS, **entries):
    """A crank of one turn a cycle, and its slide."""
    more = {"load": {"mass": 20.0}, "motor": MOTOR, "reducer": {"ratio": 5.0, "efficiency": 1.0}}
    return axis(1, *(phases or [TURN]), unit="°", closes="feed") | {"mechanism": mechanism} | more | entries


def arm(*phases, **entries):
    """An arm of 10 kg at 0.3 m that begins 20° below the horizontal."""
    load = {"inertia": 9000.0, "friction_torque": 0.4, "arm": {"mass": 10.0, "radius": 300.0, "angle": -20.0}}
    return press(*phases, **({"mechanism": {"kind": "gear train", "efficiency": 1.0}, "load": load} | entries))


def lossy(viscous=300.0, mechanism=SCREW, **entries):
    """An axis with losses, viscous friction, a process force, parts, a reducer, a shift."""
    more = {"load": LOSSY["load"] | {"viscous": viscous}, "motor": MOTOR}
    return linked(*SLOW, mechanism=mechanism | {"efficiency": 0.85}, **(LOSSY | more | entries))


def small(one, **sizes):
    """A machine of one axis with little room, and the laws that its phases have."""
    data = described(**{"phases": 2, "rotors": 2} | sizes).model_dump()
    if "motion_pieces" not in sizes:
        del data["sizes"]["motion_pieces"]  # as many as those other axes have
    others = {"axes": [one], "switches": [], "clearances": [], "power": {}, "selection": {}}
    laws = {phase["law"]: {"family": phase["law"]} for phase in one["phases"]}
    return TEMPLATE.model.model_validate(data | {"laws": laws | data["laws"]} | others)


def with_everything():
    """A machine of an axis with a drive at each end, and of all that may be entered beside them."""
    load = LOSSY["load"] | {"viscous": 150.0}
    motor = MOTOR | {
        "brake": {"torque": 5.0, "closing": 10.0, "opening": 20.0},
        "holding": "brake",
        "temperature": 60.0,
    }
    axes = [
        linked(mechanism=CRANK, **LOSSY) | {"rate": 150.0, "stops": [-5.0, 90.0], "limits": {"rms_reserve": 1.3}},
        axis(2, *RISE, unit="°", closes="open", position=4.0, smoothness="velocity"),
        driven(*RISE, load=load, motor=motor, stages=[TOOTHED], parts=LOSSY["parts"] * 3) | {"name": "A3"},
    ]
    data = described(axes, phases=2, rotors=3, export=7).model_dump()
    gap = {"name": "Gap", "first": "A1", "second": "A2", "first_factor": -1.0, "second_factor": 0.3, "offset": 80.0}
    by_pairs = {"name": "Pairs", "first": "A3", "second": "A1", "pairs": [[-5.0, 30.0], [10.0, 46.0], [25.0, 52.0]]}
    valves = (("Valve", [[20.0, 95.0], [200.0, 215.0]]), ("Sensor", [[345.0, 15.0]]), ("Never", []), ("On", [[0, 360]]))
    return TEMPLATE.model.model_validate(
        data
        | {
            "clearances": [gap, by_pairs],
            "switches": [{"name": name, "on": on} for name, on in valves],
            "export": {"axis": 3},
            "gravity": 1.62,
            "creep_forces": "on",
            "limits": {"rms_reserve": 1.2, "torque_factor": 1.5, "inertia_ratio": 4.0},
            "power": {"efficiency": 0.9, "hours": 4000.0, "price": 0.3},
            "selection": {"axis": "A3", "rank": "mass"},
        }
    )


@pytest.mark.parametrize("convert", [lambda machine: machine, convert_to_seconds], ids=["degrees", "seconds"])
@pytest.mark.sample(1)
def test_cells_of_a_machine_with_everything_agree_and_its_entries_come_back(convert):
    machine = convert(with_everything())
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])


ROUND = (0.0, 300.0, 360.0, "CIC")
BY_ANGLE = {
    "arm": arm(ROUND),
    "slide": press(ROUND, load={"mass": 20.0, "viscous": 100.0, "windows": LOSSY["load"]["windows"]}),
    "rocker": lossy(20.0, ROCKER),
}


@pytest.mark.parametrize("name", BY_ANGLE)
@pytest.mark.sample(1)
def test_cells_of_a_load_that_follows_the_angle_agree_and_its_entries_come_back(name):
    machine = small(BY_ANGLE[name])
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])


REFUSED = [
    (press(load={"inertia": 3.0}), "no entry of a press crank; expected none"),
    (press(load={"arm": {"mass": 3.0}}), "no entry of a press crank; expected none"),
    (press(unit="mm"), "a press crank does not move an axis in mm"),
    (arm() | {"load": {"mass": 3.0}}, "no entry of an axis in °; expected none"),
    (driven(*RISE) | {"mechanism": None}, "expected the mechanism that the motor drives"),
    (driven(*RISE) | {"unit": "°"}, "a lead screw does not move an axis in °"),
    (driven(*RISE) | {"load": {"inertia": 10000.0}}, "no entry of an axis in mm"),
    (linked(mechanism=table(*((10 * k, k) for k in range(13)))), r"raise sizes\.positions"),
    (linked(stages=[TOOTHED] * 3), "expected a list of 0 to 2 entries"),
    (linked(mechanism=SCREW | {"crank_radius": 5.0}), "crank_radius: unknown entry; expected one of kind, efficiency"),
]


@pytest.mark.parametrize(("one", "words"), REFUSED, ids=lambda part: part if isinstance(part, str) else "")
def test_a_drive_that_is_none_is_refused(one, words):
    with pytest.raises(InputError, match=words):
        make_machine(TEMPLATE, described().model_dump() | {"axes": [one], "selection": {}, "clearances": []}, str)


@pytest.mark.parametrize("entry", ["gravity", "creep_forces", "limits", "power"])
def test_what_belongs_to_drives_is_refused_of_a_machine_without(entry):
    given = {"gravity": 1.62, "creep_forces": "on", "limits": {"rms_reserve": 1.2}, "power": {"hours": 1.0}}[entry]
    bare = described([axis(1, *RISE)])
    assert "power" not in TEMPLATE.declare(bare).blocks
    with pytest.raises(InputError, match=f"{entry}.*: no axis .*; expected none"):
        make_machine(TEMPLATE, bare.model_dump() | {entry: given}, str)


CRANKED = "the rod is not longer than crank and offset: the crank cannot turn round"
NEITHER = "expected either a ratio or the teeth"
UNFINISHED = [
    (linked(), "mechanism.start", 0.0, "A1 row 1 reaches 0 mm, 0 mm beyond the inner dead centre", "ok_reach"),
    (linked(), "mechanism.start", 45.0, "A1 row 1 reaches 60 mm, 4.8664 mm beyond the outer dead centre", "ok_reach"),
    (linked(), "mechanism.rod_length", 40.0, CRANKED, "ok_linked"),
    (linked(), "mechanism.rod_length", None, "a size of the mechanism is empty", "ok_sized"),
    (linked(mechanism=ROCKER), "phases.0.lift", 120.0, "A1 row 1 reaches 120 mm, ", "ok_reach"),
    (press(), "mechanism.rod_length", 50.0, CRANKED, "ok_linked"),
    (lossy(), "load.viscous", -5.0, "expected a number of at least 0", "entries"),
    (linked(*SHORT, mechanism=BENT), "mechanism.points", points((0, 0), (10, 5), (10, 30)),
     "point 3 at 10 °, 30 mm is not beyond the one before it, at 10 °, 5 ", "ok_linked"),
    (linked(*SHORT, mechanism=BENT), "mechanism.points", points((0, 0), (10, 5), (20, 4)),
     "point 3 at 20 °, 4 mm is not beyond the one before it, at 10 °, 5 mm", "ok_linked"),
    (linked(*SHORT, mechanism=BENT), "mechanism.points", points((0, 0)), "a size of the mechanism is empty",
     "ok_sized"),
    (linked(*SHORT, mechanism=BENT), "mechanism.points", points((0, 0), (50, 12.5)),
     "A1 row 1 reaches 20 mm, 7.5 mm beyond the end of the table", "ok_reach"),
    (linked(*SHORT, mechanism=BENT), "mechanism.points", points((0, 1), (50, 30)),
     "A1 row 1 reaches 0 mm, 1 mm beyond the begin of the table", "ok_reach"),
]  # fmt: skip


@pytest.mark.parametrize(("one", "entry", "content", "said", "check"), UNFINISHED)
@pytest.mark.sample(2)
def test_what_cannot_be_is_built_fails_by_row_and_amount_and_comes_back(one, entry, content, said, check):
    data = small(one).model_dump()
    put(data["axes"][0], split(entry), content)
    machine = make_machine(TEMPLATE, data, str)
    assert machine.design.faults[0].message.startswith(said)
    value = computed(TEMPLATE, machine, by_cells=True)
    assert value(f"drive1_{check}") == "FAIL"
    if check != "ok_sized":  # where too little is entered, cells have nothing to compute from
        assert all(isinstance(one, float | int) for one in [*value("drive1_pt", "T"), *value("drive1_cycle", "phi")])
    back, lost = entered(TEMPLATE, machine)
    assert (back.design.replaced, lost) == (machine.design.replaced, [])


@pytest.mark.parametrize(
    ("one", "entry", "content", "words"),
    [
        (linked(*SHORT, mechanism=BELT), "mechanism.belt_on_bed", 12.0, "more of the belt"),
        (linked(), "stages", [{}], NEITHER),
        (linked(), "stages", [{"teeth_driver": 20.0}], NEITHER),
        (linked(), "stages", [TOOTHED | {"ratio": 2.0}], NEITHER),
        (linked(), "stages", [TOOTHED | {"efficiency": 1.2}], "efficiency"),
        (linked(), "stages", [TOOTHED | {"friction_torque": -1.0}], "friction_torque"),
    ],
)
def test_a_part_of_a_drive_that_cannot_be_makes_an_unfinished_design(one, entry, content, words):
    data = small(one).model_dump()
    put(data["axes"][0], split(entry), content)
    assert [words in str(fault) for fault in make_machine(TEMPLATE, data, str).design.faults] == [True]


@pytest.mark.parametrize(("torque", "verdict"), [(1.001, "OK"), (0.999, "FAIL")])
@pytest.mark.parametrize("holding", ["motor", "brake"])
def test_the_brake_must_hold_the_load_at_rest(torque, verdict, holding):
    """4,000 N always, on a pinion of 50 mm and behind a reducer of 2."""
    motor = MOTOR | {"brake": {"torque": torque * 4000.0 * 0.05 / 0.9 / 2.0}, "holding": holding}
    rack = {"kind": "rack and pinion", "pinion_diameter": 100.0, "efficiency": 0.9}
    held = driven(*RISE, mechanism=rack, load={"mass": 5.0, "force": 4000.0}, reducer={"ratio": 2.0}, motor=motor)
    assert computed(TEMPLATE, small(held))("drive1_ok_brake") == (verdict if holding == "brake" else "OK")


def test_a_weight_is_held_by_the_gravity_that_is_entered():
    """m g of 20 kg at rest, through the screw: in the table without motion, on the moon and on earth."""
    hoist = small(driven(*RISE, load={"mass": 20.0, "friction": 0.1, "slope": 90.0}))
    for gravity in (1.62, 9.81, 0.0):
        value = computed(TEMPLATE, hoist.model_copy(update={"gravity": gravity}))
        assert value("drive1_pt", "T0")[0] == pytest.approx(20.0 * gravity / RATIO, rel=1e-12)


def test_inertia_at_the_motor_counts_the_slide_where_it_is_fastest():
    """Fastest at about 77° from the outer dead centre of r/l = 1/4, x' = 1.0308 r: at points to 0.1 %."""
    value = computed(TEMPLATE, small(press()))
    assert value("drive1_jtot") == pytest.approx(20.0 * (1.0308 * 0.06) ** 2 / 25.0 * 1e4, rel=2e-3)


@pytest.mark.parametrize("made", [press, arm])
@pytest.mark.parametrize(("lift", "verdict"), [(720.0, "OK"), (0.0, "OK"), (270.0, "FAIL")])
def test_a_cycle_ends_at_the_angle_where_it_begins(made, lift, verdict):
    value = computed(TEMPLATE, small(made((0.0, 360.0, lift, "CIC"))))
    assert value("drive1_ok_turns") == verdict
    said = "" if verdict == "OK" else "it ends 270 ° from where it begins"
    assert value("drive1_ok_turns_says").startswith(said)


def test_an_axis_that_does_not_come_back_fails():
    machine = small(linked((20, 140, 60.0, "CIC"), (190, 330, -30.0, "MTP"), closes="feed"))
    assert computed(TEMPLATE, machine)("drive1_ok_back") == "FAIL"


STRAIGHT = [
    [(0.0, 0.0), (30.0, 25.546450017429244)],
    [(angle, angle * 0.7371) for angle in (-31.7, 3.3, 12.1, 88.8)],
    [(angle, angle * 0.0213) for angle in (0.0, 0.7, 177.7, 178.1)],
]


@pytest.mark.parametrize("pairs", STRAIGHT, ids=["two points", "four", "narrow parts"])
@pytest.mark.sample(1)
def test_rounding_of_a_straight_table_is_no_disagreement(pairs):
    """Its φ'' is 0 but for rounding, which cells and engine have each of their own."""
    phases = (20, 140, 0.5, "ACS"), (190, 330, -0.5, "MTP")
    assert disagreeing(TEMPLATE, small(linked(*phases, mechanism=table(*pairs), **LOSSY), positions=4))[0] == []
