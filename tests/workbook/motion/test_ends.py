"""Phases that hand velocity over, in cells: what they take, what they come to, what FAILs."""

import math
import random

import pytest

from tests.tiers import by_day, nights
from tests.workbook.cells import computed, disagreeing
from tests.workbook.composed import MACHINE
from tests.workbook.composed import composed as one_axis
from workbook.errors import InputError
from workbook.law_sheets.book_laws import BookLaws
from workbook.machines.machine import view
from workbook.machines.machine.exact import MOTION, extremes_of
from workbook.machines.machine.view import moving_axes

SMALL = {"cycle": 36, "law": 4}
FAMILIES = ("LIN", "MSN", "MTS", "SCC", "SCV", "SHM", "SRT", "SGS", "HAC", "PO5", "PO7", "DHM")
DRAWN = ("ACS", "TVP", "CIC", "CUB", "MTP", "LIN", "DWL", "OWN", "shifted", "moving", *FAMILIES, "LIN", "PO5", "PO7")
STEP = [("PO5", 30.0, 90.0), ("LIN", 20.0, 40.0), ("PO5", -50.0, 170.0), ("DWL", 0.0, 60.0)]


QUINTIC = {"duration": 1.0, "c1": 15.6, "c2": -39.6, "c3": 24.0}  # from the velocity 0.5 to 1.1
OWN = {"family": "OWN", "first_slope": 0.5, "last_slope": 1.1, "pieces": [QUINTIC]}
LAWS = {code: {"family": code} for code in FAMILIES} | {"shifted": {"family": "PO5", "share": 0.4}, "moving": OWN}


def composed(phases, laws=LAWS, **axis):
    """A machine of phases over °: law, lift, duration of each, and what it passes its begin with."""
    return one_axis(rows(phases), laws, SMALL | {"phases": 8, "motion_pieces": 48}, **axis)


def rows(phases):
    """Phases with what is entered for their begins, if anything, in a row."""
    told = [(phase[:3], dict(*phase[3:])) for phase in phases]
    return [(*phase, passing.get("velocity"), passing.get("acceleration")) for phase, passing in told]


def drawn(seed):
    """Phases of every kind, straight lines and dwells among them, some with an entered velocity or acceleration."""
    dice = random.Random(seed)
    phases = []
    for _ in range(dice.randint(1, 8)):
        law = dice.choice(DRAWN)
        lift = 0.0 if law == "DWL" else dice.choice((0.0, *(dice.uniform(-80.0, 80.0) for _ in range(5))))
        passing = {"velocity": dice.choice((0.0, dice.uniform(-3.0, 3.0)))} if dice.random() < 0.4 else {}
        passing |= {"acceleration": dice.choice((0.0, dice.uniform(-0.3, 0.3)))} if dice.random() < 0.3 else {}
        phases.append((law, lift, dice.uniform(0.5, 60.0), passing))
    return composed(phases, closes=dice.choice(("position", "open")), position=dice.uniform(-5.0, 5.0))


def of(machine):
    """What the cells of a machine of one axis compute, every one of them as the engine does."""
    assert disagreeing(MACHINE, machine)[0] == []
    return computed(MACHINE, machine)


def said(value, check):
    return value(check), value(f"{check}_says")


@pytest.mark.parametrize("seed", [*range(4), *nights(10)])
def test_random_phases_come_to_what_the_engine_says(seed):
    wrong, count = disagreeing(MACHINE, drawn(seed))
    assert wrong == []
    assert count > 9000


def along(law, seed):
    """A curve between two straight lines of one slope that goes on with it, in lifts that are rounded."""
    dice = random.Random(seed)
    slope, (*spans, back) = dice.uniform(-3.0, 3.0), (dice.uniform(5.0, 80.0) for _ in range(4))
    rows = [(name, slope * d, d) for name, d in zip(("LIN", law, "LIN"), spans, strict=True)]
    return composed([*rows, ("LIN", -slope * sum(spans), back)])


@pytest.mark.parametrize("law", by_day([law for law in FAMILIES[1:] if law != "DHM"], "PO5", "MSN"))
@pytest.mark.parametrize("seed", [0, *nights(1)])
def test_a_curve_that_goes_straight_on_is_a_straight_line(law, seed):
    value = of(along(law, seed))
    assert [value("axis1", column)[1] for column in ("a", "j")] == [0.0, 0.0]
    assert value("axis1_joints", "order")[1:3] == [0, 0]  # from the first line to it, and on to the next one


@pytest.mark.parametrize("law", ["OWN", "shifted"])
def test_a_law_that_cannot_take_a_velocity_fails_by_row_and_reason(law):
    value = of(composed([(law, 30.0, 90.0), *STEP[1:]]))
    assert said(value, "axis1_meets") == (
        "FAIL",
        f"Axis row 1: {law} cannot end with a velocity: it begins and ends at rest",
    )
    verdict, words = said(value, "axis1_smooth")
    assert (verdict, words.partition(" by ")[0]) == ("FAIL", "Axis at 90°: velocity jumps")


def test_an_own_law_with_slopes_meets_the_lines_of_its_velocities_and_no_others():
    rise, line = ("moving", 30.0, 90.0), ("LIN", 11.0, 30.0)
    value = of(composed([("LIN", 5.0, 30.0), rise, line, ("PO5", -46.0, 210.0)]))
    assert value("overall") == "OK"
    value = of(composed([("LIN", 5.0, 30.0), rise, ("LIN", 12.0, 30.0), ("PO5", -47.0, 210.0)]))
    verdict, words = said(value, "axis1_smooth")
    assert (verdict, words.partition(" by ")[0]) == ("FAIL", "Axis at 120°: velocity jumps")
    assert said(value, "axis1_meets")[0] == "OK"


def rates(value, name, order):
    """y' or y'' where the first phase ends and the second begins, in ° by °."""
    per = math.degrees(1.0) * (value("omega")) ** order
    return value("axis1_kinds", f"{name}1")[1] * per, value("axis1_kinds", f"{name}0")[3] * per


def test_an_entered_velocity_and_acceleration_between_two_curves():
    turn = {"velocity": 0.0, "acceleration": -0.005}
    value = of(composed([("PO5", 10.0, 100.0), ("PO5", -10.0, 120.0, turn), ("DWL", 0.0, 140.0)]))
    kinds = [value("axis1_kinds", f"{end}s")[1:6:2] for end in ("begin", "end")]
    assert kinds == [["R", "U", "R"], ["U", "R", "R"]]
    assert rates(value, "a", 2) == pytest.approx((-0.005, -0.005), rel=1e-12)
    assert value("overall") == "OK"
    value = of(
        composed([("MSN", 10.0, 100.0), ("MSN", 10.0, 120.0, {"velocity": 0.3}), ("DWL", 0.0, 140.0)], closes="open")
    )
    assert rates(value, "v", 1) == pytest.approx((0.3, 0.3), rel=1e-12)
    assert value("overall") == "OK"


def test_a_velocity_that_is_entered_beside_a_dwell_or_where_a_law_has_none_fails():
    beside = of(composed([("PO5", 10.0, 100.0), ("DWL", 0.0, 60.0, {"velocity": 0.1}), ("PO5", -10.0, 200.0)]))
    reason = "Axis row 2: its begin is entered otherwise than the straight line or dwell there has it"
    assert said(beside, "axis1_passes") == ("FAIL", reason)
    pulses = of(composed([("MSN", 10.0, 100.0), ("PO5", -10.0, 260.0, {"acceleration": 0.1})]))
    reason = "Axis row 1: MSN cannot end with an acceleration: it takes a velocity only"
    assert said(pulses, "axis1_meets") == ("FAIL", reason)
    agrees = of(composed([("PO5", 10.0, 100.0), ("LIN", 40.0, 100.0, {"velocity": 0.4}), ("PO5", -50.0, 160.0)]))
    assert agrees("overall") == "OK"


@pytest.mark.parametrize(
    ("phases", "smooth"),
    [
        ([("LIN", 20.0, 100.0), ("LIN", -20.0, 260.0)], "FAIL"),  # two slopes: each keeps its own
        ([("LIN", 20.0, 100.0), ("LIN", 52.0, 260.0)], "OK"),  # one slope: a feed
        ([("LIN", 72.0, 360.0)], "OK"),
        ([("MTP", 72.0, 360.0)], "OK"),
        ([("MSN", 0.0, 360.0)], "OK"),
        ([("LIN", 20.0, 180.0), ("MSN", 0.0, 180.0)], "OK"),  # comes back to where it began
        ([("LIN", 20.0, 360.0), ("PO5", -20.0, 1e-3)], "OK"),
    ],
)
@pytest.mark.sample(3)
def test_straight_lines_and_single_phases(phases, smooth):
    value = of(composed(phases))
    assert (value("axis1_smooth"), value("axis1_meets")) == (smooth, "OK")


def test_a_jump_between_straight_lines_names_both_slopes():
    value = of(composed([("LIN", 20.0, 100.0), ("LIN", -20.0, 260.0)]))
    reason = "Axis at 0°: velocity jumps by 0.276923077 °/°: straight lines of -0.076923077 and 0.2"
    assert said(value, "axis1_smooth") == ("FAIL", reason)
    beside = said(of(composed([("LIN", 20.0, 100.0), ("DWL", 0.0, 160.0), ("CIC", -20.0, 100.0)])), "axis1_smooth")
    assert beside[1].endswith(": straight lines of 0.2 and 0")
    curved = said(of(composed([("CIC", 20.0, 100.0, {}), ("ACS", -20.0, 260.0)])), "axis1_smooth")
    assert "straight" not in curved[1]


@pytest.mark.parametrize("seed", [*range(30), *nights(40)])
def test_extremes_at_points_are_as_exact_as_their_sheet_states(seed):
    machine = drawn(seed)
    (axis,) = moving_axes(machine, BookLaws(machine.laws, machine.sizes, True).laws)
    assert list(extremes_of(axis)) == []
    for exact, found in zip(axis.joined.motion.reaches, axis.motion.reaches, strict=True):
        assert found == pytest.approx(exact, abs=MOTION * (exact[1] - exact[0]) + 1e-12)


def test_an_extreme_that_points_miss_is_told(monkeypatch):
    machine = composed([("PO5", 10.0, 100.0), ("LIN", 40.0, 100.0), ("PO5", -50.0, 160.0)])
    (axis,) = moving_axes(machine, BookLaws(machine.laws, machine.sizes, True).laws)
    monkeypatch.setattr(view, "POINTS", view.POINTS[::50])
    assert any("row 3: the greatest velocity is " in line for line in extremes_of(axis))


def test_an_entered_velocity_asks_for_a_straight_line_among_the_laws():
    laws = {code: entry for code, entry in LAWS.items() if code != "LIN"}
    with pytest.raises(InputError, match="expected a straight line among the laws"):
        composed([("PO5", 10.0, 100.0), ("PO5", -10.0, 100.0, {"velocity": 0.1})], laws)
