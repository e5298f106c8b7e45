"""Stages between reducer and mechanism: entered in a book, under Selection."""

from tests.workbook.cells import disagreeing
from tests.workbook.edit import enter
from tests.workbook.machines.test_machine import TEMPLATE, driven
from tests.workbook.machines.test_machine_drives import TOOTHED, small
from tests.workbook.machines.test_machine_selection_placed import choosing, placed, require_pairs_of_the_grid
from workbook.build import build, read_inputs
from workbook.judging.verify import verify

WORM = {"ratio": 2.5, "driver_inertia": 2.0, "driven_inertia": 3.5, "efficiency": 0.8, "back_efficiency": -0.1,
        "friction_torque": 1.1}  # fmt: skip
RISE = ((30, 90, 20.0, "CIC"), (180, 300, -20.0, "CIC"))
SCREW = driven(*RISE, load={"mass": 8.0, "slope": 40.0, "friction": 0.1}, reducer={"ratio": 3.0, "efficiency": 0.8})


def test_what_is_entered_in_a_book_comes_back_and_missing_teeth_fail_a_check(tmp_path):
    path = tmp_path / "belt.xlsx"
    build(small(SCREW | {"stages": [TOOTHED]}), path)

    def edited(**cells):
        return enter(path, tmp_path / "edited.xlsx", {f"drive1_s1_{name}": cells[name] for name in cells})

    stage = read_inputs(edited(driver=None, driven=None, ratio=3.5, friction=0.9))[0].axes[0].stages[0]
    assert (stage.ratio, stage.friction_torque, stage.reduction) == (3.5, 0.9, 3.5)
    failing = verify(edited(driven=None))
    assert [one for one in failing.failing if "stage 1" in str(one)] or failing.findings


def test_selection_takes_the_task_at_the_reducers_output():
    for kind in ("viscous", "crank-slider"):
        axis = placed(kind) | {"stages": [TOOTHED]}
        given = choosing(axis)
        assert disagreeing(TEMPLATE, given)[0] == []
        require_pairs_of_the_grid(axis, ((4, 2),))
