"""A design is feasible if its book has no FAIL; what excludes others, or keeps them from being ranked, is told."""

import csv
import json
import random
import re

import pytest

from tests.workbook.studies.studied import FEED, MOTORS, RATES, REDUCERS, base, laws, planned, written
from tests.workbook.studies.test_study import chosen, run
from workbook.errors import InputError, ReadError
from workbook.reading.descriptions import read_machine
from workbook.studies.evaluate import Evaluator, require_names
from workbook.studies.plan import read_study
from workbook.studies.run import Pace, build_design
from workbook.studies.summary import summarise
from workbook.templates import TEMPLATES

FOLDER = TEMPLATES["machine"].description.parent
DECIDED = re.compile(
    "_(entries|forward|follows|within|room|repeats|apart|sum|lasts|order|brief|enough|lead|rise|tuned)$"
    "|ok_(sized|linked|reach|told|cool|bed|stage[0-9]|axis|windows)$"
)
"""names of checks that repeat rules of the entries: a study's designs keep to these"""


def tabled(plan, begin=0, end=None):
    """The table of some designs."""
    end = plan.space.size if end is None else end
    return Evaluator(plan).table(begin, plan.space.columns(begin, end))


def told(plan):
    """What is known of all designs of a study."""
    return summarise(plan.study, [one.label for one in plan.space.dimensions], tabled(plan))


def failing(plan, number):
    """The checks that FAIL in the book of a design."""
    book = plan.template.declare(plan.machine(chosen(plan, number)))
    return {q.name for _, q in book.checks if q.value != "OK"}


def test_what_excludes_a_design_is_what_fails_in_its_book(tmp_path):
    base(tmp_path, smoothness="acceleration")
    plan = planned(tmp_path, laws("MTP", "CUB"), {**RATES, "to": 300.0}, MOTORS, REDUCERS, results=["drive1_rms"])
    table = tabled(plan)
    assert 0 < table.feasible.sum() < len(table)
    by_verdict = {bool(one): [k for k in range(len(table)) if table.feasible[k] == one] for one in (True, False)}
    for verdict, numbers in by_verdict.items():
        for number in random.Random(1).sample(numbers, 3):
            found = failing(plan, number)
            here = {name for name, fails in table.fails.items() if fails[number]}
            assert here == found - ({"sel_ok"} - here)  # this is asked of what keeps to all else
            assert not (verdict and found)


@pytest.mark.parametrize(
    "template", ["machine", "cutting-machine", "machine-linkages", "crank-press", "machine-seconds"]
)
def test_every_check_that_entries_do_not_decide_is_asked_without_a_book(template):
    machine = read_machine(FOLDER / f"{template}.toml")
    kind = TEMPLATES[machine.template]
    book, found = kind.declare(machine), kind.scaling.results(machine, {})
    undecided = {q.name: q.value for _, q in book.checks if not DECIDED.search(q.name)}
    assert set(undecided) <= set(found.checks) <= {q.name for _, q in book.checks}
    assert {name: str(found.named[name]().ravel()[0]) for name in undecided} == undecided


def test_all_checks_are_constraints_until_they_are_switched_off(tmp_path):
    vary = ({"key": "axes.MC01.motor.name", "all": "catalogue"}, REDUCERS)
    usual = told(planned(tmp_path, *vary, results=["drive1_rms"]))
    free = told(planned(tmp_path, *vary, results=["drive1_rms"], constraints={"drive1_*": "off", "about_held": "off"}))
    named = {name for name in usual.excluded if name.startswith("drive1_")}
    assert named >= {
        "drive1_ok_rms",
        "drive1_ok_peak",
        "drive1_ok_speed",
        "drive1_ok_reducer_peak",
        "drive1_ok_inertia",
    }
    assert usual.excluded["drive1_ok_peak"] > 0
    assert free.feasible == free.designs > usual.feasible
    assert not [name for name in free.excluded if name.startswith("drive1_")]


def test_a_check_that_is_switched_off_and_fails_in_the_book_is_told_with_it(tmp_path):
    base(tmp_path, smoothness="acceleration")
    study = {"minimise": ["drive1_rms"], "constraints": {"axis1_smooth": "off"}}
    plan = planned(tmp_path, laws("CUB"), **study)
    judged = build_design(plan, told(plan).best[0], tmp_path / "best.xlsx", False)
    assert judged.failing == judged.unasked == ("axis1_smooth",)
    assert judged.holds


def test_a_name_that_is_switched_off_and_is_none_is_told_with_what_is_near(tmp_path):
    plan = planned(tmp_path, laws("MTP"), results=["drive1_rms"], constraints={"drive1_ok_sped": "off"})
    with pytest.raises(InputError, match="no check is named 'drive1_ok_sped'; expected drive1_ok_speed"):
        require_names(plan, "study.toml")


def test_designs_without_a_value_of_an_objective_are_counted_and_told(tmp_path):
    off = {"drive1_*": "off", "about_held": "off"}
    study = written(tmp_path, MOTORS, REDUCERS, minimise=["drive1_pair_mass"], constraints=off)
    done = run(study, "--jobs", 1, "--unverified", cwd=tmp_path)
    with (tmp_path / "study.csv").open(encoding="utf-8") as file:
        feasible = [row for row in csv.DictReader(file) if row["feasible"] == "yes"]
    lacking = sum(not row["drive1_pair_mass"] for row in feasible)
    counted = f"{lacking:,} of {len(feasible):,} feasible designs cannot be ranked"
    line = f"{counted}: drive1_pair_mass has no value in {lacking:,}"
    assert 0 < lacking < len(feasible)
    assert line in done.stdout
    assert line in (tmp_path / "study.html").read_text(encoding="utf-8")


def test_a_row_says_which_constraints_it_breaks(tmp_path):
    study = written(tmp_path, MOTORS, results=["drive1_rms"], constraints={"drive1_rms": {"max": 20.0}})
    run(study, "--jobs", 1, "--unverified", cwd=tmp_path)
    with (tmp_path / "study.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        assert ("drive1_rms" in row["fails"].split()) == (float(row["drive1_rms"]) > 20.0)
        assert (row["feasible"] == "yes") == (row["fails"] == "")


def test_the_names_of_a_machine_are_listed_the_fast_ones_first(tmp_path):
    base(tmp_path)
    done = run("--results", "feed.toml", cwd=tmp_path)
    lines = done.stdout.splitlines()
    heads = [k for k, line in enumerate(lines) if not line.startswith(" ")]
    fast, slow, books = (lines[a + 1 : b] for a, b in zip(heads, [*heads[1:], len(lines)], strict=True))
    assert "  drive1_motor_rated  Motor: continuous torque at the rated speed [Nm]" in fast
    assert any(line.startswith("  drive1_highest ") for line in slow)
    assert any(line.startswith("  MTP_k ") for line in books)


def test_a_slow_result_is_announced_with_its_time_before_it_begins(tmp_path, monkeypatch, capsys):
    from workbook.commands import study as command

    study = written(tmp_path, laws("MTP", "CUB"), results=["MTP_k"])
    monkeypatch.setattr(command, "measure_pace", lambda plan: Pace(0.0, 120.0))
    monkeypatch.setattr(command, "run", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        command.study(study, tmp_path / "r.csv", None, 2, False, None, True, False)
    said = " ".join(capsys.readouterr().out.split())
    assert "2 designs take up to about 2 minutes on 2 cores (MTP_k: from a book of each design;" in said


def test_a_pick_takes_the_results_at_hand_however_they_are_called(tmp_path, monkeypatch):
    from workbook.commands import study as command

    monkeypatch.chdir(tmp_path)
    study = written(tmp_path, laws("MTP", "PO5"), minimise=["drive1_rms"])
    assert command.study(study, tmp_path / "r.csv", None, 1, False, None, True, False) == 0
    monkeypatch.setattr(command, "run_study", None)  # it is not run again
    (tmp_path / "other.json").write_text("[1]", encoding="utf-8")
    found = command.finished_study(read_study(study), tmp_path / "study.csv")
    assert [one.entries[f"{FEED}.law"] for one in found.best] == ["PO5", "MTP"]


def test_a_pick_refuses_results_of_the_study_before_it_was_changed(tmp_path):
    from workbook.commands.study import finished_study

    plan = planned(tmp_path, laws("MTP"), minimise=["drive1_rms"])
    (tmp_path / "study.json").write_text(json.dumps({"digest": "another"}), encoding="utf-8")
    with pytest.raises(ReadError, match="before it or its machine was changed"):
        finished_study(plan, tmp_path / "study.csv")
