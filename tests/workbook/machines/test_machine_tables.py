"""Drives by a table of positions, in cells: against a constant ratio, energy, other samples; what is no table."""

import math

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE
from tests.workbook.machines.test_machine_linked import FIGURES, LOSSY, linked, small
from workbook.reading.descriptions import validated

PHASES = ((20, 140, 20.0, "CIC"), (190, 330, -20.0, "MTP"))


def table(*points, **entries):
    """A mechanism told by points: angle in °, position."""
    told = [{"angle": float(angle), "position": float(position)} for angle, position in points]
    return {"kind": "table", "efficiency": 1.0, "points": told} | entries


BENT = table((-20, -5), (20, 3), (70, 15), (130, 26), efficiency=0.85)


def driven(mechanism, *phases, **entries):
    """A machine of one axis on it, with little room."""
    return small(linked(*(phases or PHASES), mechanism=mechanism, **LOSSY | entries), positions=4)


def test_cells_agree_with_the_engine_and_entries_come_back():
    machine = driven(BENT)
    wrong, _ = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert entered(TEMPLATE, machine) == (machine, [])


def test_six_points_of_a_crank_once_out_and_back_give_results():
    crank = table(*((30.0 * k, 15.0 - 20.0 * math.cos(math.radians(30.0 * k))) for k in range(1, 7)))
    made = small(linked(*PHASES, mechanism=crank, **LOSSY), positions=6)
    wrong, _ = disagreeing(TEMPLATE, made)
    assert wrong == []
    assert computed(TEMPLATE, made)("drive1_rms") > 0.0


def test_a_straight_table_is_a_pinion():
    """r = 20 mm: 20 mm a rad, by points of any distance; the pinion's drive goes by closed forms, not by nodes."""
    points = [(angle, angle * 0.017453292519943295 * 20.0) for angle in (-10.0, 25.0, 31.0, 90.0)]
    pinion = {"kind": "rack and pinion", "pinion_diameter": 40.0, "efficiency": 0.85}
    one, other = (computed(TEMPLATE, driven(mechanism)) for mechanism in (table(*points, efficiency=0.85), pinion))
    for name in FIGURES:
        if name != "ok_peak":
            assert one(f"drive1_{name}") == pytest.approx(other(f"drive1_{name}"), rel=1e-9), name


@pytest.mark.parametrize("points", [
    [(0.0, 0.0), (30.0, 25.546450017429244)],
    [(angle, angle * 0.7371) for angle in (-31.7, 3.3, 12.1, 88.8)],
    [(angle, angle * 0.0213) for angle in (0.0, 0.7, 177.7, 178.1)],
], ids=["two points", "four", "narrow parts"])  # fmt: skip
@pytest.mark.sample(1)
def test_rounding_of_a_straight_table_is_no_disagreement(points):
    """Its φ'' is 0 but for rounding, which cells and engine have each of their own."""
    assert disagreeing(TEMPLATE, driven(table(*points), (20, 140, 0.5, "ACS"), (190, 330, -0.5, "MTP")))[0] == []


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("points", "check", "said"),
    [
        (((0, 0), (10, 5), (10, 30)), "linked", "point 3 at 10 °, 30 mm is not beyond the one before it, at 10 °, 5 "),
        (((0, 0), (10, 5), (20, 4)), "linked", "point 3 at 20 °, 4 mm is not beyond the one before it, at 10 °, 5 mm"),
        (((0, 0),), "sized", "a size of the mechanism is empty"),
        (((0, 0), (50, 12.5)), "reach", "A1 row 1 reaches 20 mm, 7.5 mm beyond the end of the table"),
        (((0, 1), (50, 30)), "reach", "A1 row 1 reaches 0 mm, 1 mm beyond the begin of the table"),
    ],
)
def test_what_is_no_table_is_built_and_fails_by_point_or_row_and_amount(points, check, said):
    data = driven(BENT).model_dump()
    data["axes"][0]["mechanism"]["points"] = table(*points)["points"]
    machine = validated(TEMPLATE, data, str)
    assert machine.design.faults[0].message.startswith(said)
    value = computed(TEMPLATE, machine, by_cells=True)
    assert value(f"drive1_ok_{check}") == "FAIL"
    assert value(f"drive1_ok_{check}_says").startswith("point 3 does not rise" if check == "linked" else said[:60])
    if check != "sized":  # where too little is entered, cells have nothing to compute from
        assert all(isinstance(one, float | int) for one in [*value("drive1_pt", "T"), *value("drive1_cycle", "phi")])


def test_more_points_than_there_is_room_for_are_refused():
    with pytest.raises(ValueError, match=r"raise sizes\.positions"):
        driven(table(*((10 * k, k) for k in range(5))))
