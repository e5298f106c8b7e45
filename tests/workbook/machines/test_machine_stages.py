"""Stages between reducer and mechanism in cells: closed forms, a simulation, entries, Selection, studies."""

import math

import numpy as np
import openpyxl
import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, driven
from tests.workbook.machines.test_machine_by_angle import arm, press
from tests.workbook.machines.test_machine_by_angle import small as small_with_lines
from tests.workbook.machines.test_machine_linked import CRANK, LOSSY, MOTOR, ROCKER, TABLE, linked, small
from tests.workbook.machines.test_machine_selection_placed import choosing, placed, require_pairs_of_the_grid
from workbook.build import build, read_inputs
from workbook.judging.verify import verify
from workbook.machines.machine.entries import AnyMachine
from workbook.reading.descriptions import validated
from workbook.templates import TEMPLATES

BELT = {"teeth_driver": 20.0, "teeth_driven": 43.0, "driver_inertia": 1.3, "driven_inertia": 6.5, "efficiency": 0.93,
        "friction_torque": 0.4}  # fmt: skip
WORM = {"ratio": 2.5, "driver_inertia": 2.0, "driven_inertia": 3.5, "efficiency": 0.8, "back_efficiency": -0.1,
        "friction_torque": 1.1}  # fmt: skip
RISE = ((30, 90, 20.0, "CIC"), (180, 300, -20.0, "CIC"))
SCREW = driven(*RISE, load={"mass": 8.0, "slope": 40.0, "friction": 0.1}, reducer={"ratio": 3.0, "efficiency": 0.8})
TURNED = {"inertia": 900.0, "torque": 3.0, "friction_torque": 0.5}
AXES = {
    "screw": SCREW,
    "table": driven((30, 90, 90.0, "CIC"), (180, 300, -90.0, "MTP"), unit="°", load=TURNED,
                    mechanism={"kind": "rotary table", "efficiency": 0.9}),
    "crank": linked(mechanism=CRANK | {"efficiency": 0.85}, **LOSSY),
    "points": linked(mechanism=TABLE | {"efficiency": 0.85}, **LOSSY),
    "rocker": linked((20, 140, 25.0, "CIC"), (190, 330, -25.0, "MTP"), mechanism=ROCKER | {"efficiency": 0.8}, **LOSSY),
    "press": press(), "arm": arm((20.0, 140.0, 90.0, "CIC"), (190.0, 330.0, -90.0, "MTP"), closes="position"),
}  # fmt: skip
PEAKS = ("tmax", "tmin", "pmax", "pmin", "res_peak", "highest")  # which a study has by the parabola alone
RESULTS = ("tmax", "tmin", "rms", "speed", "mean", "smax", "smean", "energy", "returned", "jtot", "highest")


@pytest.mark.parametrize("kind", AXES)
@pytest.mark.parametrize("stages", [[BELT], [WORM, BELT]])
@pytest.mark.sample(2)
def test_cells_agree_and_entries_come_back(kind, stages):
    machine = small_with_lines(AXES[kind] | {"stages": stages})
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])


def test_stages_that_do_nothing_change_no_result():
    nothing = {"ratio": 1.0}
    for axis in (AXES["screw"], AXES["crank"]):
        one, other = (computed(TEMPLATE, small(axis | {"stages": stages})) for stages in ([], [nothing, nothing]))
        for name in RESULTS:
            assert other(f"drive1_{name}") == pytest.approx(one(f"drive1_{name}"), rel=1e-12), name


def test_a_stage_is_a_reducer_where_the_motor_has_none():
    """Of the same ratio and losses; its inertia on the driving shaft is then the reducer's at its input."""
    reducer = {"ratio": 3.0, "efficiency": 0.8, "inertia": 5.0}
    stage = {"ratio": 3.0, "efficiency": 0.8, "driver_inertia": 5.0}
    for axis in (AXES["screw"], AXES["crank"]):
        one = computed(TEMPLATE, small(axis | {"reducer": reducer}))
        other = computed(TEMPLATE, small(axis | {"reducer": {}, "stages": [stage]}))
        for name in ("tmax", "tmin", "rms", "speed", "energy", "returned", "jtot", "highest"):
            assert other(f"drive1_{name}") == pytest.approx(one(f"drive1_{name}"), rel=1e-9), name


def test_a_belt_from_motor_to_spindle_in_closed_form():
    """J_ext = J_a + (J_b + m/(2π/P)²)/i²; in uniform motion T = (F/(2π/P)/η + T_f)/(η_s i)."""
    belt = BELT | {"teeth_driver": 20.0, "teeth_driven": 40.0}
    axis = driven((30, 330, 100.0, "TVP"), closes="feed", load={"mass": 20.0, "force": 900.0}, stages=[belt])
    axis |= {"mechanism": {"kind": "lead screw", "lead": 10.0, "efficiency": 0.9}}
    value, screw = computed(TEMPLATE, small(axis)), 2 * math.pi / 0.01
    assert value("drive1_jtot") == pytest.approx(1.3 + (6.5 + 20.0 / screw**2 * 1e4) / 4.0, rel=1e-12)
    assert value("drive1_j_out") == pytest.approx(value("drive1_jtot") / 1e4, rel=1e-12)
    assert value("drive1_i") == pytest.approx(2.0 * screw, rel=1e-12)
    uniform = (900.0 / screw / 0.9 + 0.4) / 0.93 / 2.0
    at = [k for k, (a, v) in enumerate(zip(value("drive1_pt", "a"), value("drive1_pt", "v"), strict=True))
          if abs(a) < 1e-9 < v]  # fmt: skip
    assert at
    assert [value("drive1_pt", "T")[k] for k in at] == pytest.approx([uniform] * len(at), rel=1e-9)


def simulated(stages, method):
    """RMS, highest and lowest torque of the motor of the screw: its cycloidal motion by time, stage by stage."""
    n, time, kinds = 200_000, 0.3, {"document": False, "physical": True}
    tau = (np.arange(n) + 0.5) / n * 360.0
    v, a = np.zeros(n), np.zeros(n)
    for begin, end, lift in ((30.0, 90.0, 0.02), (180.0, 300.0, -0.02)):
        xi, lasts = (tau - begin) / (end - begin), (end - begin) / 360.0 * time
        inside = (xi >= 0.0) & (xi <= 1.0)
        v += np.where(inside, lift / lasts * (1.0 - np.cos(2 * np.pi * xi)), 0.0)
        a += np.where(inside, lift / lasts**2 * 2 * np.pi * np.sin(2 * np.pi * xi), 0.0)
    way, weight = np.sign(v), 8.0 * 9.81
    torque = 8.0 * a + weight * (math.sin(math.radians(40.0)) + 0.1 * math.cos(math.radians(40.0)) * way)

    def passed(torque, ratio, eta, back):
        driven = (torque * way < 0.0) & kinds[method]
        held = (way == 0.0) & (back <= 0.0) & kinds[method]
        return torque / ratio * np.where(held, 0.0, np.where(driven, back, 1.0 / eta))

    speed = 2 * math.pi / 0.01
    torque = passed(torque, speed, 1.0, 1.0)
    for stage in reversed(stages):
        ratio = stage["ratio"] if "ratio" in stage else stage["teeth_driven"] / stage["teeth_driver"]
        torque = torque + stage["driven_inertia"] * 1e-4 * speed * a + stage["friction_torque"] * way
        torque = passed(torque, ratio, stage["efficiency"], stage.get("back_efficiency", stage["efficiency"]))
        speed *= ratio
        torque = torque + stage["driver_inertia"] * 1e-4 * speed * a
    torque = passed(torque, 3.0, 0.8, 0.8) + 10.0 * 1e-4 * 3.0 * speed * a
    return math.sqrt(float((torque**2).mean())), float(torque.max()), float(torque.min())


@pytest.mark.parametrize("stages", [[BELT], [WORM], [BELT, WORM], [WORM, BELT]], ids=["belt", "worm", "both", "other"])
@pytest.mark.parametrize("method", ["physical", "document"])
def test_against_a_simulation_stage_by_stage(stages, method):
    axis = SCREW | {"stages": stages, "mechanism": SCREW["mechanism"] | {"method": method}}
    value = computed(TEMPLATE, small(axis))
    rms, most, least = simulated(stages, method)
    assert value("drive1_rms") == pytest.approx(rms, rel=1e-3)
    assert value("drive1_tmax") == pytest.approx(most, rel=5e-3)
    assert value("drive1_tmin") == pytest.approx(least, rel=5e-3)


def test_a_self_locking_stage_holds_the_load_at_rest():
    held = SCREW | {"stages": [WORM]}
    for back, holds in ((-0.1, True), (0.5, False)):
        value = computed(TEMPLATE, small(held | {"stages": [WORM | {"back_efficiency": back}]}))
        resting = [t for t, way in zip(value("drive1_pt", "T"), value("drive1_pt", "dir"), strict=True) if way == 0]
        assert (max(map(abs, resting)) == 0.0) == holds


NEITHER = "expected either a ratio or the teeth"
LIMITS = [({"efficiency": 1.2}, "efficiency"), ({"friction_torque": -1.0}, "friction_torque")]


@pytest.mark.parametrize(
    ("stage", "words"),
    [
        ({}, NEITHER),
        ({"teeth_driver": 20.0}, NEITHER),
        (BELT | {"ratio": 2.0}, NEITHER),
        *((BELT | a, b) for a, b in LIMITS),
    ],
)
def test_a_stage_that_cannot_be_is_an_unfinished_design(stage, words):
    data = small(SCREW).model_dump()
    data["axes"][0]["stages"] = [stage]
    assert [words in str(fault) for fault in validated(TEMPLATE, data, str).design.faults] == [True]


def test_no_more_than_two_stages_and_none_without_a_drive_or_beside_printed_figures():
    with pytest.raises(ValueError, match="at most 2"):
        small(SCREW | {"stages": [BELT] * 3})
    bare = {name: SCREW[name] for name in ("name", "group", "phases")}
    with pytest.raises(ValueError, match="an axis without a drive"):
        small(bare | {"stages": [BELT]})
    with pytest.raises(ValueError, match="no stages behind its reducer"):
        small(SCREW | {"stages": [BELT], "printed": "S4"})


def test_what_is_entered_in_a_book_comes_back_and_missing_teeth_fail_a_check(tmp_path):
    path = tmp_path / "belt.xlsx"
    build(small(SCREW | {"stages": [BELT]}), path)

    def edited(**cells):
        book = openpyxl.load_workbook(path)
        for name, content in cells.items():
            sheet, cell = next(iter(book.defined_names[f"drive1_s1_{name}"].destinations))
            book[sheet][cell.replace("$", "")] = content
        book.save(tmp_path / "edited.xlsx")
        return tmp_path / "edited.xlsx"

    stage = read_inputs(edited(driver=None, driven=None, ratio=3.5, friction=0.9))[0].axes[0].stages[0]
    assert (stage.ratio, stage.friction_torque, stage.reduction) == (3.5, 0.9, 3.5)
    failing = verify(edited(driven=None))
    assert [one for one in failing.failing if "stage 1" in str(one)] or failing.findings


def test_selection_takes_the_task_at_the_reducers_output():
    for kind in ("viscous", "crank-slider"):
        axis = placed(kind) | {"stages": [BELT]}
        given = choosing(axis)
        assert disagreeing(TEMPLATE, given)[0] == []
        require_pairs_of_the_grid(axis, ((4, 2),))


@pytest.mark.parametrize("kind", ["screw", "crank"])
def test_a_study_has_the_results_of_the_book(kind):
    machine: AnyMachine = small(AXES[kind] | {"stages": [BELT, WORM], "motor": MOTOR})
    book, found = TEMPLATE.declare(machine), TEMPLATES["machine"].scaling.results(machine, {})
    values = {q.name: q.value for block in book.blocks.values() if not block.is_table for q in block.quantities}
    shared = [name for name in found.named if name in values and name.startswith("drive1_")]
    assert {"drive1_rms", "drive1_tmax", "drive1_jtot", "drive1_speed", "drive1_smax"} <= set(shared)
    for name in shared:
        there, here = found.named[name](), values[name]
        told = np.ravel(there)[0]
        near = 5e-3 if name.removeprefix("drive1_") in PEAKS else 1e-9
        assert str(told) == here if isinstance(here, str) else told == pytest.approx(here, rel=near), name
