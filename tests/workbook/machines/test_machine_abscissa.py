"""A machine over any abscissa (°, rad, mm) whose time nothing tells; axes that are open, and that begin anywhere."""

import math
import random

import numpy as np
import openpyxl
import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.composed import MACHINE, composed, description
from workbook.build import build
from workbook.errors import InputError
from workbook.reading.descriptions import counted_from_1, make_machine

LINE = {"LIN": {"family": "LIN"}, "PO5": {"family": "PO5"}}
TO_AND_FRO = (("CIC", 20.0, 30.0), ("DWL", 0.0, 10.0), ("CIC", -20.0, 60.0))
DRIVE = {
    "mechanism": {"kind": "lead screw", "lead": 20.0, "efficiency": 0.8},
    "load": {"mass": 30.0},
    "motor": {"inertia": 10.0, "rated_torque": 500.0, "peak_torque": 1500.0, "max_speed": 30000.0},
}


def units(machine):
    """The units of all that a book shows as a result, but on the pages of laws, and the titles of its charts."""
    book = MACHINE.declare(machine)
    blocks = [block for block in book.blocks.values() if block.sheet.title not in machine.laws.names]
    found = {q.unit for block in blocks for q in block.quantities if q.role == "result"}
    titles = {text for block in blocks for chart, *_ in block.sheet.charts for text in (chart.x, chart.y, chart.title)}
    return found, titles


@pytest.mark.parametrize("over", ["°", "rad", "mm"])
def test_rates_are_lift_by_abscissa(over):
    """y'max = C_v h/δ, y''max = C_a h/δ², in the units entered; y along the cycle."""
    value = computed(MACHINE, composed(TO_AND_FRO, over=over, unit="mm"))
    assert value("axis1", "v") == pytest.approx([2 * 20 / 30, 0.0, 2 * 20 / 60], rel=1e-12)
    assert value("axis1", "a") == pytest.approx([math.tau * 20 / 30**2, 0.0, math.tau * 20 / 60**2], rel=1e-12)
    assert value("axis1", "j")[0] == pytest.approx(math.tau**2 * 20 / 30**3, rel=1e-12)
    assert value("axis1", "lasts") == pytest.approx([30.0, 10.0, 60.0], rel=1e-12)
    assert value("cycle1", "time") == pytest.approx([100 / 12 * k for k in range(13)], rel=1e-12)
    xi = (100 / 12 * 2) / 30
    assert value("cycle1", "v")[2] == pytest.approx(20 / 30 * (1 - math.cos(math.tau * xi)), rel=1e-9)
    assert (value("axes", "v"), value("overall")) == (pytest.approx([4 / 3], rel=1e-12), "OK")


@pytest.mark.parametrize("over", ["°", "rad", "mm"])
def test_the_book_shows_the_unit_of_its_abscissa_and_no_time(over):
    found, titles = units(composed(TO_AND_FRO, over=over, unit="mm"))
    assert {f"mm/{over}", f"mm/{over}²", f"mm/{over}³"} <= found
    assert [unit for unit in found if unit == "s" or unit.endswith(("/s", "/s²", "/s³", "cycles/min"))] == []
    assert any(title.endswith(f"[{over}]") for title in titles)
    assert f"y' [mm/{over}]" in titles
    assert [title for title in titles if "[s]" in title or "/s" in title] == []


@pytest.mark.parametrize("over", ["°", "rad", "mm", "s"])
@pytest.mark.sample(2)
def test_every_cell_is_the_engines_and_what_is_entered_comes_back(over):
    """Handed over at speed, open, later, elsewhere; a turning axis beside it, a switch, a clearance, an export."""
    phases = (("PO5", 20.0, 30.0, 0.3), ("LIN", 20.0, 30.0), ("PO5", -30.0, 30.0), ("PO5", 4.0, 10.0, -0.1, 0.02))
    data = description(phases, LINE, {"export": 7}, over=over, unit="mm", closes="open", position=-3.5, shift=7.0)
    data["axes"].append(description(TO_AND_FRO, name="Other", position=4.0)["axes"][0])
    data |= {"switches": [{"name": "Valve", "on": [[10.0, 20.0], [90.0, 5.0]]}], "export": {"axis": 1}}
    data["clearances"] = [{"name": "ClearanceView", "first": "Axis", "second": "Other", "least": -1000.0}]
    machine = make_machine(MACHINE, data, counted_from_1)
    assert machine.design.faults == ()
    assert disagreeing(MACHINE, machine)[0] == []
    assert entered(MACHINE, machine) == (machine, [])
    for one in (MACHINE.variants(machine)[3], drawn_machine(machine, random.Random(over))):
        assert disagreeing(MACHINE, one)[0] == []


def test_what_two_curved_phases_meet_with_is_in_the_units_shown():
    rise, on = ("PO5", 40.0, 50.0), ("PO5", 60.0, 50.0, 1.5, -0.02)
    machine = composed((rise, on), LINE, {"cycle": 10}, over="mm", unit="mm", closes="feed")
    value = computed(MACHINE, machine)
    assert (value("cycle1", "v")[5], value("cycle1", "a")[5]) == pytest.approx((1.5, -0.02), rel=1e-9)


def test_a_jump_is_told_in_the_units_shown():
    machine = composed((("CUB", 20.0, 50.0), ("DWL", 0.0, 50.0)), over="mm", unit="mm", closes="open")
    value = computed(MACHINE, machine)
    assert value("axis1_smooth_says") == "Axis at 50 mm: acceleration jumps by 0.048 mm/mm²"  # 6 · 20/50²
    assert disagreeing(MACHINE, machine)[0] == []


def test_a_drive_needs_time():
    with pytest.raises(InputError, match=r"^axes\[1\]\.motor \(counted from 1\): a cycle in mm does not tell how time"):
        composed(TO_AND_FRO, over="mm", unit="mm", **DRIVE)
    assert composed(TO_AND_FRO, over="s", unit="mm", **DRIVE).design.faults == ()


def test_twenty_four_phases_and_a_thousand_samples():
    phases = [("CIC", 10.0 * (-1) ** k, 15.0) for k in range(24)]
    machine = composed(phases, sizes={"phases": 24, "cycle": 999})
    book = MACHINE.declare(machine)
    assert (book.blocks["axis1"].size, book.blocks["cycle1"].size) == (24, 1000)
    assert computed(MACHINE, composed(phases, sizes={"phases": 24}))("overall") == "OK"
    with pytest.raises(InputError, match=r"axes\[1\]\.phases .*: 24 rows do not fit into 23; raise sizes\.phases"):
        composed(phases, sizes={"phases": 23})


# --- Open, and elsewhere --------------------------------------------------------------------------


def test_an_open_axis_begins_with_what_is_entered_and_ends_at_rest():
    phases = (("PO5", 20.0, 50.0, 0.7, 0.01), ("CIC", 10.0, 50.0))
    value = computed(MACHINE, composed(phases, LINE, {"cycle": 10}, closes="open"))
    assert (value("cycle1", "v")[0], value("cycle1", "a")[0]) == pytest.approx((0.7, 0.01), rel=1e-9)
    assert (value("cycle1", "v")[-1], value("overall")) == (pytest.approx(0.0, abs=1e-12), "OK")


@pytest.mark.parametrize("master", [{"rate": 100.0}, {"cycle": 100.0}])
@pytest.mark.sample(1)
def test_an_open_axis_with_a_drive_fails_by_name(master):
    data = description(TO_AND_FRO, unit="mm", closes="open", **DRIVE) | {"master": master}
    data["sizes"] |= {"cycle": 200}  # samples that tell the peak of the bus
    machine = make_machine(MACHINE, data, counted_from_1)
    said = "Axis is open, so its cycle does not follow upon itself; expected position or feed of an axis with a drive"
    assert [fault.message for fault in machine.design.faults] == [said]
    assert entered(MACHINE, machine) == (machine, [])


def test_positions_are_counted_from_where_the_axis_begins():
    value = computed(MACHINE, composed(position=-3.5))
    assert value("cycle1", "y") == pytest.approx([y - 3.5 for y in (0, 0, 0, 10, 20, 20, 20, 10, 0, 0, 0, 0, 0)])
    assert (value("axes", "low"), value("axes", "high")) == (pytest.approx([-3.5]), pytest.approx([16.5]))


def test_an_axis_that_begins_elsewhere_goes_out_so_and_open_ones_do_not_repeat():
    (one,) = MACHINE.axes(composed(position=2.0))
    (other,) = MACHINE.axes(composed(closes="open", over="mm"))
    assert one.profile.at(np.array([0.0, 150.0, 300.0])).y == pytest.approx([2.0, 22.0, 2.0])
    assert one.repeats
    assert (other.x_unit, other.units[1], other.repeats) == ("mm", "°/mm", False)


def test_a_crank_is_where_its_slide_begins():
    """The same slide, told from 0 to 30 and from 10 mm on to 40 with a table that is as much farther."""

    def driven(begin):
        points = [{"angle": 30.0 * k, "position": begin + y} for k, y in enumerate((-2.0, 8.0, 19.0, 33.0))]
        mechanism = {"kind": "table", "efficiency": 0.9, "points": points}
        data = description((("CIC", 30.0, 40.0), ("CIC", -30.0, 60.0)), over="s", unit="mm", position=begin,
                           **DRIVE | {"mechanism": mechanism})  # fmt: skip
        return make_machine(MACHINE, data, counted_from_1)

    one, other = driven(0.0), driven(10.0)
    assert disagreeing(MACHINE, other)[0] == []
    values = [computed(MACHINE, machine) for machine in (one, other)]
    for name in ("drive1_rms", "drive1_tmax", "drive1_speed"):
        assert values[0](name) == pytest.approx(values[1](name), rel=1e-9)


def test_the_drop_down_offers_what_a_cycle_can_do(tmp_path):
    build(composed(), tmp_path / "book.xlsx")
    sheet = openpyxl.load_workbook(tmp_path / "book.xlsx")["Timing"]
    lists = {rule.formula1 for rule in sheet.data_validations.dataValidation if rule.type == "list"}
    assert '"position,feed,open"' in lists
