"""A motor whose peak torque falls beyond a speed: on the sheets of drives, against a search and by what it means."""

import math

import numpy as np
import openpyxl
import pytest

from tests.workbook.cells import computed
from tests.workbook.machines import test_machine_rates as straight
from tests.workbook.machines.test_machine import TEMPLATE
from workbook.build import build
from workbook.judging.verify import verify

NONE = {"inertia": 10.0, "rated_torque": 1e5, "max_speed": 1e6}
AXES = {
    "constant": lambda rate: straight.machine(rate, {}, {}),
    **{name: lambda rate, name=name: straight.linked_machine(name, rate) for name in straight.LINKAGES},
}
CURVES = {
    "constant": {"peak_torque": 90.0, "full_torque_to": 2000.0, "end_torque": 5.0, "max_speed": 12000.0},
    "screw": {"peak_torque": 30.0, "full_torque_to": 1000.0, "end_torque": 2.0, "max_speed": 9000.0},
    "crank": {"peak_torque": 20.0, "full_torque_to": 100.0, "end_torque": 1.0, "max_speed": 3000.0},
    "rocker": {"peak_torque": 20.0, "full_torque_to": 100.0, "end_torque": 1.0, "max_speed": 3000.0},
    "table": {"peak_torque": 20.0, "full_torque_to": 100.0, "end_torque": 1.0, "max_speed": 3000.0},
}


def machine(name, rate=60.0, **motor):
    """An axis with losses and process forces on a motor of the catalogue, beside a motor without limits."""
    given = AXES[name](rate).model_dump()
    rows = [{"name": "Falls", **NONE, **(CURVES[name] | motor)}, {"name": "Level", **NONE, "peak_torque": 1e5}]
    given["selection"]["motors"], given["sizes"]["positions"] = rows, 12
    given["axes"][0]["motor"] |= {"name": "Falls"}
    return TEMPLATE.model.model_validate(given)


@pytest.mark.parametrize("name", AXES)
@pytest.mark.sample(2)
def test_at_the_highest_rate_the_torque_is_below_the_curve_and_above_it_is_not(name):
    rate, value = straight.settled(lambda rate: machine(name, rate))
    assert value("drive1_binds") == "torque below the curve"
    there, above = (computed(TEMPLATE, machine(name, times * rate)) for times in (0.999, 1.007))
    assert (there("drive1_ok_curve"), above("drive1_ok_curve")) == ("OK", "FAIL")
    assert there("drive1_ok_peak") == above("drive1_ok_peak") == "OK"
    assert 0.0 <= there("drive1_spare") < 1.5e-2 * CURVES[name]["peak_torque"]
    assert above("drive1_spare") < 0.0
    assert " Nm more than the motor has at its speed; the drive holds from 0 to " in above("drive1_ok_curve_says")


@pytest.mark.parametrize("name", ["constant", "crank"])
@pytest.mark.sample(1)
def test_the_reserve_is_that_of_the_samples_of_the_sheet(name):
    """Samples and points each miss a little of what is asked for most."""
    given = machine(name).model_dump()
    given["sizes"]["cycle"] = 720
    value = computed(TEMPLATE, TEMPLATE.model.model_validate(given))
    power, torque = (np.abs(value("drive1_cycle", column)) for column in ("power", "torque"))
    speed = 30e3 / math.pi * np.divide(power, torque, out=np.zeros_like(power), where=torque > 0.0)
    curve = CURVES[name]
    limit = np.interp(speed, [curve["full_torque_to"], curve["max_speed"]], [curve["peak_torque"], curve["end_torque"]])
    left = float((limit - torque).min())
    assert value("drive1_spare") == pytest.approx(left, abs=5e-3 * curve["peak_torque"])


def changed(path, **cells):
    """Write other values into the row of the first motor of a book, by the names of columns."""
    book = openpyxl.load_workbook(path)
    sheet = book["Catalogue"]
    head = {}
    for cell in (cell for row in sheet.iter_rows() for cell in row if isinstance(cell.value, str)):
        head.setdefault(cell.value, cell)  # the messages on an entry stand under the same heading, to its right
    first = next(cell.row for row in sheet.iter_rows() for cell in row if cell.value == "Falls")
    for label, value in cells.items():
        column = next(cell.column for text, cell in head.items() if text.startswith(label.replace("_", " ")))
        sheet.cell(first, column).value = value
    book.save(path)


def test_a_curve_that_is_typed_into_a_book_without_one_fails_and_says_why(tmp_path):
    path = tmp_path / "level.xlsx"
    build(machine("constant", full_torque_to=None, end_torque=None), path)
    changed(path, peak_torque_up_to=2000.0, peak_torque_at=5.0)
    report = verify(path)
    assert report.findings == []
    assert any("is given up to its largest speed" in line and "give it to the description" in line
               for line in (check.line for check in report.failing)), report.failing  # fmt: skip


ODD = {
    "cleared": ({"peak_torque_up_to": None, "peak_torque_at": None}, "OK"),
    "half of it": ({"peak_torque_up_to": None}, None),
    "beyond the largest speed": ({"peak_torque_up_to": 20000.0}, None),
    "rising": ({"peak_torque_at": 500.0}, "OK"),
    "from rest to nothing": ({"peak_torque_up_to": 0.0, "peak_torque_at": 0.0}, "OK"),
    "nothing left": ({"peak_torque_up_to": 0.0, "peak_torque_at": 0.0, "largest_speed": 4400.0}, "FAIL"),
}


@pytest.mark.parametrize("odd", ODD)
@pytest.mark.sample(1)
def test_an_odd_curve_in_a_book_that_knows_one_is_judged_alike(odd, tmp_path):
    cells, verdict = ODD[odd]
    path = tmp_path / "falling.xlsx"
    build(machine("constant"), path)
    changed(path, **cells)
    report = verify(path)
    assert report.findings == []
    (found,) = [check.found for check in report.checks if check.what == "Drive A1: torque below the motor's curve"]
    assert (verdict is None) == (report.unfinished > 0)
    assert found == verdict or verdict is None
