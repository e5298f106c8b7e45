"""Linked entries: a timing moves as a whole, and what cannot be meant is told."""

import pytest

from tests.workbook.studies.studied import FEED, MOTORS, base, planned
from workbook.errors import InputError
from workbook.studies.evaluate import Evaluator

BEGINS = [10.0, 30.0, 50.5]
START = {"key": f"{FEED}.start", "values": BEGINS}
WHOLE = {f"{FEED}.stop": f"{FEED}.start + 80", "axes.MC01.shift": f"{FEED}.stop - 12.5"}
RESULTS = ["drive1_rms", "drive1_res_peak"]


def evaluated(plan):
    """The results of all designs of a plan."""
    return Evaluator(plan).table(0, plan.space.columns(0, plan.space.size))


def test_a_timing_moves_as_a_whole(tmp_path):
    plan = planned(tmp_path, START, links=WHOLE, results=RESULTS)
    (begin,) = plan.space.dimensions
    for value in BEGINS:
        axis = plan.machine({begin: value}).axes[0]
        assert (axis.phases[0].start, axis.phases[0].stop, axis.shift) == (value, value + 80.0, value + 67.5)


@pytest.mark.parametrize("spaced", ["{} + 80.0", "{}+80", " {} +80 ", "{} - -80"])
def test_a_number_is_added_however_it_is_spaced(tmp_path, spaced):
    links = {f"{FEED}.stop": spaced.format("axes.1.phases.1.start")}  # counted from 1, as messages have it
    if "- -" in spaced:
        with pytest.raises(InputError, match="has no"):
            planned(tmp_path, START, links=links, results=RESULTS)
        return
    assert planned(tmp_path, START, links=links, results=RESULTS).links[0].offset == 80.0


def test_a_motor_that_varies_and_leads_a_link_is_worked_out_by_itself(tmp_path):
    """It no longer only scales: what follows it changes too."""
    links = {"axes.MC01.group": "axes.MC01.motor.name"}
    plan = planned(tmp_path, MOTORS, links=links, results=RESULTS)
    (motor,) = plan.space.dimensions
    assert not motor.part
    name = motor.values[3]
    assert plan.machine({motor: name}).axes[0].group == name
    alone, together = (evaluated(one).results["drive1_rms"]
                       for one in (plan, planned(tmp_path, MOTORS, results=RESULTS)))  # fmt: skip
    assert alone == pytest.approx(together, rel=1e-12, nan_ok=True)


@pytest.mark.parametrize(
    ("links", "said"),
    [
        ({f"{FEED}.end": f"{FEED}.start + 5"}, "has no .end.; expected .*start, stop"),
        ({f"{FEED}.stop": f"{FEED}.begin + 5"}, "has no 'begin'"),
        ({f"{FEED}.stop": f"{FEED}.start * 2"}, "has no 'start \\* 2'"),
        ({f"{FEED}.stop": f"{FEED}.law + 5"}, "expected a number, to which one is added"),
        ({f"{FEED}.start": f"{FEED}.stop - 5"}, "varies already"),
        ({f"{FEED}.stop": f"{FEED}.stop + 5"}, "follow each other"),
        ({f"{FEED}.stop": "axes.MC01.shift + 5", "axes.MC01.shift": f"{FEED}.stop + 5"}, "follow each other"),
        ({f"{FEED}.stop": f"{FEED}.start + 5", "axes[1].phases[1].stop": f"{FEED}.start + 6"}, "is linked twice"),
        ({f"{FEED}.stop": "axes.MC01 + 5"}, "is a table of entries"),
        ({"axes.0.phases.1.stop": f"{FEED}.start"}, "has no '0'"),
    ],
)  # fmt: skip
def test_a_link_that_cannot_be_meant_is_told(tmp_path, links, said):
    base(tmp_path)
    with pytest.raises(InputError, match=said):
        planned(tmp_path, START, links=links, results=RESULTS)


def test_a_phase_that_gives_room_cannot_follow(tmp_path):
    second = [{"law": "MTP", "lift": 300.0, "start": 0.0, "stop": 80.0},
              {"law": "CIC", "lift": 10.0, "start": 80.0, "stop": 200.0}]  # fmt: skip
    base(tmp_path, phases=second)
    gives = {"key": f"{FEED}.stop", "values": [70.0, 90.0], "takes": "axes.MC01.phases[2]"}
    with pytest.raises(InputError, match="varies already"):
        planned(tmp_path, gives, links={"axes.MC01.phases[2].start": f"{FEED}.stop"}, results=RESULTS)
