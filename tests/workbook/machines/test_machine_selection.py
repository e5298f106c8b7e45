"""The sheet Selection of a machine: its pairs against drives that have them, its limits, the axis that is named."""

import numpy as np
import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.edit import enter
from tests.workbook.machines.test_machine import RISE, TEMPLATE, driven, small
from workbook.build import build, read_inputs
from workbook.entries.design import as_entered
from workbook.judging.verify import verify
from workbook.selection.entries import Limits

PRESS = [{"start": 50.0, "stop": 120.0, "force": 900.0, "resists": "moving"},
         {"start": 150.0, "stop": 230.0, "force": -400.0, "resists": "always"}]  # fmt: skip
LOAD = {"mass": 20.0, "friction": 0.1, "slope": 30.0, "windows": PRESS}
PARTS = [{"name": "Coupling", "count": 1.0, "inertia": 3.0, "shaft": "motor"},
         {"name": "Pulley", "count": 2.0, "inertia": 10.0, "shaft": "mechanism"}]  # fmt: skip
OTHER = ((10, 150, 50.0, "MTP"), (200, 350, -50.0, "CIC"))
MOTORS = [
    {"name": f"M{k}", "inertia": 2.0 * k**1.5, "rated_torque": 2.0 * k, "peak_torque": 6.0 * k, "max_speed": 5000.0,
     "mass": 2.0 * k if k != 3 else None} | ({"full_torque_to": 1500.0, "end_torque": 2.5 * k} if k % 2 else {})
    for k in range(1, 6)
]  # fmt: skip
REDUCERS = [
    {"name": f"R{k}", "reduction": float(k), "efficiency": 0.99 - 0.04 * k, "inertia": 1.0 * k, "mass": 1.0}
    for k in range(1, 5)
]
WIDE = {"inertia_ratio": 1e6, "rms_reserve": 1e-3, "greatest_margin": 1e6}


def chosen(choice):
    """The entries of a choice by their tables: limits, and what else the sheet Selection has."""
    tables = {"limits": {}, "selection": {"motors": MOTORS, "reducers": REDUCERS}}
    for name, value in choice.items():
        tables["limits" if name in Limits.model_fields else "selection"][name] = value
    return tables


def machine(rate=60.0, axes=None, **choice):
    """Two drives with losses, process forces and parts, and a small catalogue with curves; a choice and its limits."""
    first = driven(*RISE, load=LOAD, reducer={"ratio": 3.0, "efficiency": 0.8}, parts=PARTS)
    second = driven(*OTHER, load=LOAD, parts=PARTS, motor={"name": "M4"}, reducer={"name": "R2"}) | {"name": "B2"}
    second["mechanism"] = second["mechanism"] | {"lead": 20.0, "efficiency": 0.7}
    data = small([driven(*RISE)]).model_dump() | {"axes": axes or [first, second]}
    data["sizes"] |= {"motors": 6, "reducers": 5}
    data["master"]["rate"] = rate
    return TEMPLATE.model.model_validate(data | chosen({"axis": "b2"} | choice))


@pytest.mark.parametrize("rank", ["smallest motor", "margin", "inertia match", "mass", "cost"])
@pytest.mark.sample(1)
def test_each_cell_agrees_and_what_is_entered_comes_back(rank):
    given = machine(rank=rank, **WIDE)
    wrong, _ = disagreeing(TEMPLATE, given)
    assert wrong == []
    assert entered(TEMPLATE, given) == (given, [])


@pytest.mark.parametrize(("limit", "beyond", "word"), [
    ("inertia_ratio", 1e-6, "inertia"), ("rms_reserve", 1e6, "RMS"), ("greatest_margin", 1e-6, "large"),
    ("largest_mass", 1e-6, "mass"),
])  # fmt: skip
def test_each_limit_can_leave_no_pair_and_says_so(limit, beyond, word):
    value = computed(TEMPLATE, machine(**WIDE | {limit: beyond}))
    words = {one for r in range(1, 5) for one in value(f"sel_word{r}", "v")[:5]}
    assert word in words
    assert "yes" not in words
    assert (value("sel_ok"), value("sel_motor")) == ("FAIL", "none")
    assert value("sel_ok_says") == "no pair can do it"


def test_no_torque_of_a_listed_pair_comes_nearer_to_its_motors_curve_than_is_said():
    """Held against the points of the drive itself."""
    given = machine(rate=100.0, **WIDE).model_dump()
    given["sizes"]["cycle"] = 720
    for m, r, rated in ((1, 2, 1500.0), (2, 3, 5000.0)):
        given["axes"][1] |= {"motor": {"name": f"M{m}"}, "reducer": {"name": f"R{r}"}}
        value = computed(TEMPLATE, TEMPLATE.model.model_validate(given))
        speed, torque = (np.abs(value("drive2_pt", column)) for column in ("n", "T"))
        motor = MOTORS[m - 1]
        fall = (motor["peak_torque"] - motor.get("end_torque", motor["peak_torque"])) / (5000.0 - rated or 1.0)
        left = motor["peak_torque"] - fall * np.maximum(speed - rated, 0.0) - torque
        assert value("drive2_spare") == pytest.approx(left.min(), rel=1e-9, abs=1e-9 * motor["peak_torque"])


@pytest.mark.parametrize(("axes", "row", "name"), [([driven(*RISE)], 0, "a1"), (None, 1, "b2")], ids=["one", "two"])
@pytest.mark.sample(1)
def test_an_axis_that_is_renamed_while_selection_names_it_fails_by_the_name(axes, row, name, tmp_path):
    """Its book is one of an unfinished design: nothing is refused, and what was entered stays."""
    build(machine(axes=axes, axis=name), tmp_path / "book.xlsx")
    enter(tmp_path / "book.xlsx", tmp_path / "other.xlsx", {("axis_name", row): "Punch"})
    report = verify(tmp_path / "other.xlsx")
    assert report.findings == []
    failing = {check.what: check.says for check in report.checks if check.found == "FAIL"}
    said = f"no axis with a drive is named {name}"
    assert failing["Selection: its axis has a drive"] == said
    given, lost = read_inputs(tmp_path / "other.xlsx")
    assert lost == []
    assert as_entered(given)["selection"]["axis"] == name
    assert [fault.message for fault in given.design.faults] == [said]


@pytest.mark.parametrize(("selection", "said"), [
    ({"axis": "C3"}, "selection.axis: no axis with a drive is named C3"),
    ({"axis": None, "rank": "mass"}, "selection.rank: no axis is told for the sheet Selection"),
])  # fmt: skip
def test_what_it_cannot_look_at_is_refused(selection, said):
    with pytest.raises(ValueError, match=said.split(": ")[1].split(";")[0]):
        machine(**selection)


def test_motors_behind_the_reducer_of_each_drive_fail_what_their_pairs_fail():
    """Of the named axis the pairs with its reducer, of the other one too once it is named."""
    for wanted in (WIDE, {"rms_reserve": 1.3}):
        given = machine(**wanted).model_dump()
        given["axes"][0] |= {"reducer": {"name": "R4"}}
        for axis, reducer, number in (("A1", 4, 1), ("B2", 2, 2)):
            given["selection"]["axis"] = axis
            value = computed(TEMPLATE, TEMPLATE.model.model_validate(given))
            found = value(f"sel_all_word{number}", "v")
            assert found == value(f"sel_word{reducer}", "v")
            usable = [k for k, word in enumerate(found, 1) if word == "yes"]
            assert value("sel_each", "can")[number - 1] == len(usable)
            assert value("sel_each", "smallest")[number - 1] == (f"M{min(usable)}" if usable else "none")
