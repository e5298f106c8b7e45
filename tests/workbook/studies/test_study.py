"""A study from its description to its results: what is evaluated without a book is what the book says."""

import csv
import os
import random
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import tomli_w

from tests.workbook.machines.test_machine_drives import TOOTHED
from tests.workbook.machines.test_machine_stages import WORM
from tests.workbook.studies.studied import FEED, MOTORS, RATES, REDUCERS, SIZES, base, laws, planned, stops, written
from workbook.entries.design import as_entered
from workbook.errors import InputError
from workbook.machines.machine.drive.view import AT_NO_RATE
from workbook.reading.descriptions import read_machine
from workbook.studies.evaluate import Evaluator, book_value, require_names
from workbook.studies.plan import read_study
from workbook.studies.run import deviation
from workbook.templates import TEMPLATES


def run(*arguments, **options):
    command = [sys.executable, "-m", "workbook", "study", *map(str, arguments)]
    env = os.environ | {"COLUMNS": "200"}
    return subprocess.run(command, capture_output=True, text=True, check=False, encoding="utf-8", env=env, **options)


def rows(path):
    with Path(path).open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def chosen(plan, number):
    columns = plan.space.columns(number, number + 1)
    return {one: column.values[0] for one, column in zip(plan.space.dimensions, columns, strict=True)}


WINDOWS = [{"start": 20.0, "stop": 60.0, "force": -4000.0}, {"start": 70.0, "stop": 90.0, "force": 900.0}]
LOADED = {"load": {"force": 300.0, "friction": 0.1, "mass": 30.0, "windows": WINDOWS}}


def compared(plan, number):
    """All that a design's book and a study without it both tell, by name; those that only the study knows."""
    here = chosen(plan, number)
    book = plan.template.declare(plan.machine(here))
    outer = plan.machine({one: value for one, value in here.items() if not one.part})
    columns = zip(plan.space.dimensions, plan.space.columns(number, number + 1), strict=True)
    found = plan.template.scaling.results(outer, {one.key: column for one, column in columns if one.part}).named
    both = {name for name in found if name.partition(".")[0] in book.blocks}
    assert drive_results(book) <= both
    return {name: (np.ravel(found[name]())[0], book_value(book, name)) for name in both}, set(found) - both


ON_THE_PAGE = frozenset(
    (
        "creep_use inertia_ratio j_figures losses nmax peak peak_reserve rated reducer_rated rms_reserve "
        "speed_reserve stall torque_factor largest_mass parts_listed windows_listed"
    ).split()
)
"""bold on a drive's page, and no results: what entries decide or say in words, and the use while it creeps"""


def drive_results(book):
    """The names of what comes out of drives, a value each."""
    singles = (block.quantities[0] for block in book.blocks.values() if len(block.quantities) == 1)
    names = {one.name for one in singles if one.role == "result" and one.name.startswith("drive")}
    return {name for name in names if name.partition("_")[2] not in ON_THE_PAGE}


PEAKS = ("tmax", "tmin", "largest", "use_peak", "pmax", "pmin", "about_peak")
"""results of which a study has the parabola through points, where a book works the drive out at its peaks once more"""


def require_alike(pairs):
    """Each result is what the book says, peaks to 0.2 %; a drive that holds at no rate has the rate 0."""
    pairs = {name: (one, 0.0 if one == 0.0 and other == AT_NO_RATE else other) for name, (one, other) in pairs.items()}
    apart = {name: deviation(*pair) for name, pair in pairs.items()}
    allowed = {name: 2e-3 if name.endswith(PEAKS) else 1e-9 for name in pairs}
    assert {name: pairs[name] for name, value in apart.items() if value > allowed[name]} == {}


@pytest.mark.parametrize("more", [{}, {"rate": 41.0, "stages": [TOOTHED, WORM]}], ids=["machine", "own"])
def test_every_result_without_a_book_is_what_the_book_says(tmp_path, more):
    base(tmp_path, **LOADED, **more)
    plan = planned(tmp_path, laws("MTP", "PO5", "ACS"), RATES, MOTORS, REDUCERS, results=["drive1_rms"])
    for number in random.Random(1).sample(range(plan.space.size), 2):
        pairs, alone = compared(plan, number)
        require_alike(pairs)
        assert {name.rpartition("_")[2] for name in alone} == {"mass", "cost"}
        assert {"drive1_highest", "about_binds", "power_year", "MTP_cj", "axis1.j.1", "timing_cycle"} < set(pairs)


@pytest.mark.parametrize("template", ["machine", "machine-linkages", "crank-press"])
@pytest.mark.sample(2)
def test_every_result_of_a_whole_machine_is_what_its_book_says(tmp_path, template):
    data = as_entered(read_machine(TEMPLATES["machine"].description.with_name(f"{template}.toml")))
    data["sizes"] |= SIZES
    (tmp_path / "feed.toml").write_text(tomli_w.dumps(data), encoding="utf-8")
    driven = next(one["name"] for one in data["axes"] if one.get("motor"))
    varied = {"key": f"axes.{driven}.motor.inertia", "values": [10.0, 40.0]}
    plan = planned(tmp_path, {**RATES, "steps": 2}, varied, results=["timing_rate"])
    pairs, _ = compared(plan, 3)
    require_alike(pairs)
    assert {"power_mains", "power.resistor.1", "axes.v.2"} < set(pairs)
    assert len(data["clearances"]) == sum(name.startswith("clearances.gap") for name in pairs)


def test_what_scales_is_worked_out_together_and_gives_what_each_gives_alone(tmp_path):
    names = ["drive1_rms", "drive1_ok_peak", "drive1_energy", "drive1_smean", "about_cycle"]
    plan = planned(tmp_path, laws("MTP", "CUB"), MOTORS, REDUCERS, RATES, results=names)
    assert [one.part for one in plan.space.dimensions] == ["", "axes.0.motor", "axes.0.reducer", "master.rate"]
    together = Evaluator(plan).table(0, plan.space.columns(0, plan.space.size))
    for number in (0, 5, plan.space.inner, plan.space.size - 1):
        alone = Evaluator(plan).table(number, plan.space.columns(number, number + 1))
        for name, values in together.results.items():
            same = values[number] == alone.results[name][0]
            assert same or values[number] == pytest.approx(alone.results[name][0], rel=1e-14)


def test_the_command_writes_results_a_page_and_the_picked_book(tmp_path):
    study = written(
        tmp_path, laws("MTP", "CUB", "CIC"), stops(80, 120, 2), MOTORS, REDUCERS,
        results=["drive1_energy"], minimise=["drive1_rms", "drive1_pair_mass"],
        constraints={"drive1_res_rms": {"min": 1.0}, "drive1_ok_speed": "OK"},
    )  # fmt: skip
    done = run(study, "--pick", 1, "-o", "best.xlsx", "--jobs", 1, "--unverified", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout
    assert "formula cells agree" in done.stdout
    found = rows(tmp_path / "study.csv")
    assert len(found) == 3 * 2 * 19 * 16
    assert (tmp_path / "best.xlsx").exists()
    assert not (tmp_path / "study.csv.parts").exists()
    page = (tmp_path / "study.html").read_text(encoding="utf-8")
    assert "<svg" in page
    assert "seed 1" in page
    feasible = [row for row in found if row["feasible"] == "yes" and row["drive1_pair_mass"]]
    best = min(feasible, key=lambda row: float(row["drive1_rms"]))
    assert f"1. design {best['design']}:" in done.stdout
    again = run(study, cwd=tmp_path)
    assert again.returncode == 2
    assert "study.csv: the file exists" in again.stderr


def test_parquet_holds_what_csv_holds(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    study = written(tmp_path, laws("MTP", "CUB"), stops(-10, 80, 40), results=["drive1_rms", "drive1_ok_rms"])
    for name in ("r.csv", "r.parquet"):
        assert run(study, "-o", name, "--jobs", 1, cwd=tmp_path).returncode == 0
        (tmp_path / "r.json").unlink()
        (tmp_path / "r.html").unlink()
    table = parquet.read_table(tmp_path / "r.parquet").to_pylist()
    texts = [{name: "" if value is None else str(value) for name, value in row.items()} for row in table]
    assert texts == rows(tmp_path / "r.csv")
    assert len(texts) == 80
    assert {row["feasible"] for row in texts} == {"yes", "no"}


def test_no_feasible_design_tells_what_each_constraint_excludes(tmp_path):
    bounds = {"drive1_res_rms": {"min": 1e6}, "drive1_rms": {"max": 1e9}}
    study = written(tmp_path, laws("MTP", "CUB"), minimise=["drive1_energy"], constraints=bounds)
    done = run(study, "--jobs", 1, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (3, "")
    assert "drive1_res_rms (at least 1e+06) excludes 2, 1 of them alone" in done.stdout
    assert "drive1_rms (at most 1e+09) excludes 0, 0 of them alone" in done.stdout
    assert "No design is feasible." in done.stdout


def test_an_impossible_design_is_a_row_with_its_reason(tmp_path):
    plan = planned(tmp_path, stops(-10, 80, 2), results=["drive1_rms"])
    table = Evaluator(plan).table(0, plan.space.columns(0, 2))
    assert table.possible.tolist() == [False, True]
    assert "axes[1].phases[1].stop" in table.reasons[0]
    assert "expected a number of at least 0" in table.reasons[0]
    assert np.isnan(table.results["drive1_rms"][0])


def test_a_phase_that_grows_takes_its_room_from_the_phase_that_is_named(tmp_path):
    phases = [
        {"start": 0.0, "stop": 90.0, "lift": 200.0, "law": "MTP"},
        {"start": 90.0, "stop": 200.0, "lift": 100.0, "law": "CUB"},
    ]
    base(tmp_path, phases=phases)
    plan = planned(tmp_path, stops(80, 110, 2, takes="axes.MC01.phases[2]"), results=["drive1_rms"])
    for number, stop in enumerate((80.0, 110.0)):
        first, second = plan.machine(chosen(plan, number)).axes[0].phases
        assert (first.stop, second.start, second.stop) == (stop, stop, 200.0)


def test_all_laws_are_those_with_the_same_ends_that_the_machine_takes(tmp_path):
    (law,) = planned(tmp_path, {"key": f"{FEED}.law", "all": "laws"}, results=["drive1_rms"]).space.dimensions
    assert {"CUB", "MTP", "SHM", "PO5"} <= set(law.values)
    assert not {"DWL", "LIN"} & set(law.values)


def test_a_result_that_only_the_book_has_comes_from_it(tmp_path):
    plan = planned(tmp_path, laws("MTP", "CUB"), results=["MTP_k", "MTP_cj", "drive1_rms"])
    one = Evaluator(plan)
    assert not one.swift
    table = one.table(0, plan.space.columns(0, 2))
    assert table.results["MTP_cj"].tolist() == pytest.approx([61.43, 61.43], abs=0.01)
    assert table.results["drive1_rms"][0] != table.results["drive1_rms"][1]


@pytest.mark.parametrize(
    ("vary", "more", "said"),
    [
        ([{"key": f"{FEED}.lw", "values": ["MTP"]}], {}, "has no 'lw'; expected law"),
        ([{"key": "axes.MC1.shift", "values": [1.0]}], {}, "has no 'MC1'; expected MC01"),
        ([{"key": FEED, "values": [1.0]}], {}, "is a table of entries"),
        ([laws("MTTP")], {}, "MTTP"),
        ([laws("MTP")], {"results": ["drive1_rsm"]}, "no result is named 'drive1_rsm'; expected drive1_rms"),
        ([stops(90, 80, 3)], {}, "the range from 90 to 80 is empty"),
        ([{"key": f"{FEED}.law", "values": []}], {}, "values"),
        ([laws("MTP", "CUB", "MTP")], {}, "vary.1.values.3: 'MTP' stands there twice"),
        ([{"key": "master.rate", "values": [60, 60.0]}], {}, "60.0 stands there twice"),
        ([stops(60, 90)], {}, "expects steps of each range"),
        ([stops(60, 90, 1_000_000_000)], {}, "1,000,000,000 designs in full; expected at most"),
        ([laws("MTP"), laws("CUB")], {}, "varies twice"),
        ([laws("MTP")], {"constraints": {"drive1_ok_rms": {"min": 1.0}}}, 'expected drive1_ok_rms = "OK"'),
        ([laws("MTP")], {"minimise": ["drive1_ok_rms"]}, "is a text, 'OK'; expected a number"),
        ([{"key": "axes.MC01.motor.name", "values": ["No such"]}], {}, "no motor of the catalogue is named"),
        ([laws("MTP")], {"way": {"kind": "sobol"}}, "how many designs"),
        ([{**RATES, "from": -5.0}], {}, "master.rate = -5.0: master.rate: expected a number greater than 0"),
        ([{"key": "axes[2].rate", "values": [60.0]}], {}, "has no '2'; expected MC01"),
        ([{"key": "", "values": [1.0]}], {}, "vary.1.key: found ''; string should have at least 1 character"),
        ([{"key": "axes.MC01.motor.name", "all": "laws"}], {}, "'axes.MC01.motor.name' names no law"),
        ([laws("MTP")], {"constraints": {"drive1_rms": {"min": 2.0, "max": 1.0}}}, "constraints.drive1_rms.max: 1 is"),
        ([laws("MTP")], {"results": ["drive1_higest"]}, "expected drive1_highest"),
        ([laws("MTP")], {"minimize": []}, "minimize: unknown entry; expected one of minimise"),
    ],
)  # fmt: skip
def test_what_cannot_be_asked_is_told_in_a_line_with_what_is_near(tmp_path, vary, more, said):
    with pytest.raises(InputError) as told:
        require_names(read_study(written(tmp_path, *vary, **({"results": ["drive1_rms"]} | more))), "study.toml")
    assert said in str(told.value)
    assert len(str(told.value).splitlines()) == 1


def test_a_name_with_dots_and_brackets_is_written_in_quotes(tmp_path):
    base(tmp_path, name="A.1 [x]")
    plan = planned(tmp_path, {"key": 'axes."A.1 [x]".shift', "values": [1.0, 2.0]}, results=["drive1_rms"])
    assert plan.space.size == 2
    with pytest.raises(InputError, match=r'has no .A.; expected "A.1 \[x\]"'):
        planned(tmp_path, {"key": "axes.A.1 [x].shift", "values": [1.0, 2.0]}, results=["drive1_rms"])


MOTOR = {"inertia": 10.0, "rated_torque": 20.0, "peak_torque": 60.0, "max_speed": 6000.0}


@pytest.mark.parametrize("torque", [0.1, 1e3])
def test_a_brake_holds_in_a_study_the_dwells_that_it_holds_in_the_book(tmp_path, torque):
    """From 30 to 300 cycles/min the same dwell becomes too short for it."""
    brake = {"torque": torque, "closing": 100.0, "opening": 90.0}
    base(tmp_path, **LOADED, motor=MOTOR | {"holding": "brake", "brake": brake})
    rates = {"key": "master.rate", "values": [30.0, 300.0]}
    plan = planned(tmp_path, rates, MOTORS, REDUCERS, results=["drive1_rms", "drive1_ok_brake", "drive1_brake_load"])
    loads = []
    for number in random.Random(1).sample(range(plan.space.size), 6):
        pairs, _ = compared(plan, number)
        require_alike({name: one for name, one in pairs.items() if "_ok_" not in name})
        assert pairs["drive1_ok_brake"][0] == pairs["drive1_ok_brake"][1]
        loads.append((pairs["drive1_brake_load"][0], pairs["drive1_ok_brake"][0]))
    assert {load > 0.0 for load, _ in loads} == {True, False}
    assert all((verdict == "OK") == (load <= torque) for load, verdict in loads)
