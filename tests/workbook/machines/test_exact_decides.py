"""What the exact engine knows decides: a limit holds where the sheet and the engine say so, on every surface alike."""

import math

import openpyxl
import pytest

from engine.drive.motor import LimitCheck
from engine.drive.results import DriveResults
from tests.workbook import office
from tests.workbook.edit import cell_named
from tests.workbook.machines.test_machine import RISE, TEMPLATE, driven, small
from workbook.book.sentence import as_shown
from workbook.build import build
from workbook.judging.verify import verify
from workbook.machines.machine.axes import tables_of
from workbook.machines.machine.exact import drives_of, limits_of
from workbook.reading.descriptions import write_machine
from workbook.serve.shown import design
from workbook.studies.evaluate import Evaluator
from workbook.studies.plan import make_plan
from workbook.studies.space import Study
from workbook.template_outputs import ExactJudgement, JudgedLimit
from workbook.witnesses.engines import libreoffice_path

RMS = "Drive A1: RMS torque within the continuous torque"
TURNING = [
    {"start": 0.0, "stop": 90.0, "lift": 90.0, "law": "PO5"},
    {"start": 90.0, "stop": 130.0, "lift": 80.0, "law": "LIN"},
    {"start": 130.0, "stop": 320.0, "lift": -170.0, "law": "PO5"},
]
"""a motion that is handed over at speed, overshoots and turns round inside a phase"""


def limited(rated):
    """One axis whose motor has so much rated torque for each Nm that its cycle asks for."""
    (view,) = drives_of(small([driven(*RISE)]))
    motor = {
        "inertia": 10.0,
        "rated_torque": rated * view.points.rms_torque,
        "peak_torque": 450.0,
        "max_speed": 13000.0,
    }
    return small([driven(*RISE, motor=motor)])


def turning(rated):
    """One axis that turns round inside a phase, with a motor of a rated torque (Nm)."""
    motor = {"inertia": 10.0, "rated_torque": rated, "peak_torque": 4500.0, "max_speed": 13000.0}
    load = {"mass": 35.6, "friction": 0.198}
    axis = driven(smoothness="velocity", lead=33.1, load=load, motor=motor) | {"phases": TURNING}
    data = small([driven(*RISE)], phases=3).model_dump()
    laws = data["laws"] | {name: {"family": name} for name in ("LIN", "PO5")}
    return TEMPLATE.model.model_validate(
        data | {"axes": [axis], "laws": laws, "sizes": data["sizes"] | {"motion_pieces": None}}
    )


def surfaces(machine, folder):
    """Return by surface what it says of the RMS torque: build's line, verify's check, the browser's, whether a study
    finds the design feasible."""
    tables_of.cache_clear()
    lines = [one for one in build(machine, folder / "book.xlsx", overwrite=True) if one.startswith(RMS)]
    (check,) = (one for one in verify(folder / "book.xlsx").checks if one.what == RMS)
    path = folder / "machine.toml"
    path.write_text(text := write_machine(machine), encoding="utf-8")
    design.cache_clear()
    (live,) = (one for one in design("machine.toml", text).checks().values() if one.label == RMS)
    table = studied(path)
    return (
        lines,
        (check.found, check.says),
        (live.value, live.says),
        bool(table.feasible[0]),
        table.fails["drive1_ok_rms"],
    )


def studied(path, **more):
    """Return the table of a study of the machine in a file at its own rate."""
    vary = [{"key": "master.rate", "values": [200.0]}]
    told = {"title": "T", "base": path.name, "vary": vary, "results": ["drive1_rms"]} | more
    plan = make_plan(Study.model_validate(told), path, "test")
    return Evaluator(plan).table(0, plan.space.columns(0, 1))


@pytest.mark.parametrize(("rated", "exact", "sheet"), [(1.03, 1.06, "OK"), (0.97, 0.94, "FAIL")])
def test_a_figure_that_breaks_a_limit_by_one_hand_alone_fails_everywhere(rated, exact, sheet, tmp_path, monkeypatch):
    """The sheet's figure is right; the engine's is made another, to stand for a sheet that errs."""
    machine = limited(rated)
    (view,) = drives_of(machine)
    rms = view.points.rms_torque
    monkeypatch.setattr(DriveResults, "rms_torque", property(lambda self: exact * rms))
    book = TEMPLATE.declare(machine)
    assert {q.name: q.value for _, q in book.checks}["drive1_ok_rms"] == sheet
    lines, check, live, feasible, excluded = surfaces(machine, tmp_path)
    engine, cell, limit = (f"{as_shown(one * rms)} Nm" for one in (exact, 1.0, rated))
    both = f"RMS torque is {engine} exactly, {cell} on its sheet; the limit is {limit}"
    assert lines == [f"{RMS}: {check[1]}"]
    assert check[1].startswith(both)
    assert (check[0], live) == ("FAIL", check)
    assert (feasible, excluded) == (False, [True])


def test_a_figure_that_both_hands_hold_holds_everywhere(tmp_path):
    lines, check, live, feasible, excluded = surfaces(limited(1.03), tmp_path)
    assert (lines, check, live, feasible, excluded) == ([], ("OK", ""), ("OK", ""), True, [False])


def test_build_and_verify_end_with_3_where_an_axis_turns_round_inside_a_phase(tmp_path, motionbook):
    """As reversal.toml: the motor lies between what nine points of a phase made of it and what is right."""
    (view,) = drives_of(turning(60.0))
    path, book = tmp_path / "turning.toml", tmp_path / "turning.xlsx"
    path.write_text(write_machine(turning(view.driven.limit_checks.results.rms_torque / 1.001)), encoding="utf-8")
    code, _, said = motionbook("build", path, "-o", book)
    assert (code, book.exists()) == (3, True)
    assert "FAIL Drive A1: RMS torque within the continuous torque" in " ".join(said.split())
    code, said, _ = motionbook("verify", book)
    assert code == 3
    assert "RMS torque within the continuous torque" in " ".join(said.split())
    assert not studied(path).feasible.any()


BELT = {
    "name": "BELT",
    "group": "Transfer",
    "phases": [TURNING[0], TURNING[1] | {"law": "PO5"}, TURNING[2]],
    "parts": [{"name": "Pulleys", "count": 2.0, "inertia": 4.5, "shaft": "mechanism"}],
    "mechanism": {"kind": "belt", "efficiency": 0.95, "belt_mass": 0.8, "pulley_diameter": 63.66},
    "load": {"mass": 6.5, "friction": 0.02},
    "motor": {"inertia": 1.28, "rated_torque": 1.25, "peak_torque": 2.25, "max_speed": 5000.0},
    "reducer": {"name": "Beckhoff AG2400 TP004 MF i=4"},
}
"""the transfer belt of a cartoner, whose first and last phase meet at rest"""


@pytest.mark.skipif(libreoffice_path() is None, reason="LibreOffice is not on this machine")
def test_a_law_and_a_rate_entered_by_hand_in_libreoffice_fail_there_before_any_command(tmp_path):
    """A straight line makes the belt turn inside its last phase, where its peak then lies: 2.357 Nm of 2.25."""
    laws = {name: {"family": name} for name in ("LIN", "PO5")}
    machine = TEMPLATE.model.model_validate(
        {"title": "Cartoner", "master": {"rate": 30.0}, "laws": laws, "axes": [BELT]}
    )
    build(machine, tmp_path / "book.xlsx")
    blocks = TEMPLATE.declare(machine).blocks
    phases, rate = blocks["axis1"], blocks["timing_rate"]
    edited = office.edit(
        tmp_path / "book.xlsx",
        tmp_path / "edited.xlsx",
        [
            'sheet = book.Sheets.getByName("Timing")',
            f'sheet.getCellByPosition({phases.columns["law"] - 1}, {phases.row}).String = "LIN"',
            f"sheet.getCellByPosition({rate.column - 1}, {rate.row - 1}).Value = 90",
        ],
    )
    (before, now) = (openpyxl.load_workbook(path, data_only=True) for path in (tmp_path / "book.xlsx", edited))

    def value(book, name):
        return cell_named(book, name).value

    assert (value(before, "drive1_ok_peak"), value(now, "drive1_ok_peak")) == ("OK", "FAIL")
    assert max(value(now, "drive1_tmax"), -value(now, "drive1_tmin")) == pytest.approx(2.357, abs=0.001)


@pytest.mark.parametrize(
    ("sheet", "exact", "verdict", "told"),
    [(0.9997, 0.9999, "OK", True), (0.9997, 1.0001, "FAIL", True), (1.0003, 0.9999, "FAIL", True),
     (0.9, 0.9001, "OK", False), (0.9, 1.1, "FAIL", False)],
)  # fmt: skip
def test_what_is_as_close_to_a_limit_as_the_sheet_is_exact_is_told_so(sheet, exact, verdict, told):
    limit = JudgedLimit(
        "ok", "Drive A", "RMS torque", "Nm", LimitCheck("", sheet, 1.0), LimitCheck("", exact, 1.0), 5e-4
    )
    judged = ExactJudgement([limit])
    found, says = judged.judge("ok", "OK" if sheet <= 1.0 else "FAIL", "")
    words = f"RMS torque at the limit: {100 * sheet:.2f} %, known to 0.05 %; {exact} Nm exactly, the limit is 1 Nm"
    assert found == verdict
    assert says == ("" if verdict == "OK" else words if told else "RMS torque is 1.1 Nm exactly, 0.9 Nm on its sheet; "
                    "the limit is 1 Nm")  # fmt: skip
    assert judged.notes == ([f"Drive A: {words}"] if told and verdict == "OK" else [])


def test_every_limit_that_is_entered_is_judged():
    """Each check of the drive's sheet that compares a figure with a limit has the engine's figure as well."""
    reducer = {"ratio": 3.0, "peak_torque": 400.0, "mean_torque": 200.0, "max_speed": 9000.0}
    machine = small([driven(*RISE, reducer=reducer)])
    (view,) = drives_of(machine)
    judged = {one.check: one for one in limits_of(view)}
    compared = {q.name for _, q in TEMPLATE.declare(machine).checks if q.formula.count("<=") == 1 and "ok_" in q.name}
    # sums of inertias and masses, a shaft as entered; a share that is judged where it is near 1
    others = {f"drive1_ok_{name}" for name in ("inertia", "mass", "shaft", "creep")}
    assert set(judged) == {name for name in compared if name.startswith("drive1_ok_")} - others
    assert all(math.isclose(one.sheet.limit, one.exact.limit, rel_tol=1e-6) for one in judged.values())
