"""A motion as one table of pieces in cells: its room, its joints, and the verdicts of all committed books."""

import openpyxl
import pytest

from tests.workbook.cells import computed, disagreeing
from tests.workbook.composed import MACHINE, description, placed
from tests.workbook.composed import composed as one_axis
from workbook.book.quantity import SAYS
from workbook.build import build
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.laws.entries import Laws
from workbook.motion.requirements import dwells_for_room, piece_counts
from workbook.reading.descriptions import counted_from_1, make_machine


def composed(phases, **axis):
    return one_axis(phases, sizes={"cycle": 24}, **axis)


@pytest.mark.parametrize(
    ("smoothness", "said"),
    [
        ("velocity", None),
        ("acceleration", "Axis at 60°: acceleration jumps by 0.022222222 °/°²"),
        ("jerk", "Axis at 0°: jerk jumps by 0.0000571156 °/°³"),
    ],
)
def test_a_joint_that_is_less_smooth_than_asked_is_named(smoothness, said):
    machine = composed([("DWL", 0.0, 60.0), ("ACS", 20.0, 60.0), ("CIC", -20.0, 240.0)], smoothness=smoothness)
    value = computed(MACHINE, machine)
    assert value("axis1_smooth") == ("FAIL" if said else "OK")
    if said:
        assert value(f"axis1_smooth{SAYS}").startswith(said.partition(" by ")[0])
    assert disagreeing(MACHINE, machine)[0] == []


def test_a_law_that_jumps_within_itself_is_named_by_the_place():
    machine = composed([("TVP", 20.0, 60.0), ("DWL", 0.0, 300.0)], closes="open")
    said = computed(MACHINE, machine)(f"axis1_smooth{SAYS}")
    assert said.startswith("Axis at 20°: acceleration jumps by ")


def test_across_the_end_of_the_cycle_too_unless_it_is_open():
    phases = [("CUB", 20.0, 180.0), ("CUB", -20.0, 180.0)]
    again, once = (computed(MACHINE, composed(phases, closes=cycle)) for cycle in ("position", "open"))
    assert (again("axis1_smooth"), once("axis1_smooth")) == ("OK", "OK")
    jerk = [computed(MACHINE, composed(phases, closes=cycle, smoothness="jerk")) for cycle in ("position", "open")]
    assert jerk[0](f"axis1_smooth{SAYS}").startswith("Axis at 0°: jerk jumps by ")
    assert jerk[1](f"axis1_smooth{SAYS}").startswith("Axis at 180°: jerk jumps by ")


def test_pieces_more_than_there_is_room_for_fail_in_words(tmp_path):
    """As an engineer comes to it: laws of more pieces, chosen in a book that was built for fewer."""
    path = tmp_path / "book.xlsx"
    build(composed([("CUB", 5.0, 15.0) for _ in range(24)]), path)
    workbook = openpyxl.load_workbook(path)
    sheet, (area,) = workbook["Timing"], workbook.defined_names["axis1"].destinations
    top = sheet[area[1].replace("$", "")][0]
    law = next(cell.column for row in sheet["A1:Z60"] for cell in row if cell.value == "law")
    for row in range(top[0].row, top[0].row + 24):
        sheet.cell(row, law).value = "MTP"
    workbook.save(path)
    report = verify(path, ["pycel"])
    assert report.findings == []
    failing, *_ = [check for check in report.checks if check.found == "FAIL"]  # what has no room makes others fail too
    assert failing.what == "Axis 1: the table of pieces has room for all"
    assert failing.says.startswith("168 pieces do not fit into 56 rows")


def test_the_room_is_a_few_rows_more_than_are_used():
    machine = composed([("MTP", 5.0, 15.0) for _ in range(24)])
    assert machine.sizes.motion_pieces == [24 * 7 + 8]


def test_each_axis_has_the_rows_that_it_needs_or_those_stated_of_which_the_last_holds_for_all_others():
    data = description(sizes={"phases": 8}, name="short")
    data["axes"].append(data["axes"][0] | {"name": "long", "phases": placed([("MTP", 5.0, 15.0)] * 8)[0]})
    for stated, rows in ((None, [22, 65]), (70, [70, 70]), ([19, 60], [19, 60]), ([60, 61, 25], [60, 61])):
        data["sizes"]["motion_pieces"] = stated
        book = MACHINE.declare(make_machine(MACHINE, data, counted_from_1))
        assert [book.blocks[f"axis{number}_pieces"].size for number in (1, 2)] == rows
    with pytest.raises(InputError, match="18 pieces are too few; expected at least 19"):
        make_machine(MACHINE, description(sizes={"phases": 8, "motion_pieces": [18]}), counted_from_1)


@pytest.mark.parametrize("room", range(4, 24))
def test_phases_of_a_variation_rest_until_the_pieces_of_all_find_room(room):
    counts = piece_counts(Laws.model_validate({}))
    phases = dwells_for_room([{"law": law} for law in ("CUB", "MTP", "CIC", "MTP")], {}, room)
    assert sum(counts[phase["law"]] for phase in phases) <= room
    assert room < sum(counts[law] for law in ("CUB", "MTP", "CIC", "MTP")) or "DWL" not in str(phases)
