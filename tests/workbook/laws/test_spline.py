"""Points joined by a cubic spline in a workbook: solution and extremes in cells, what is refused, lines beside them."""

import itertools
import random

import pytest

from tests.workbook.cells import computed, disagreeing
from tests.workbook.composed import MACHINE, composed
from workbook.errors import InputError

REST = ("DWL", 0.0, 5.0)


def points(*pairs):
    return [{"at": at, "s": s} for at, s in pairs]


def machine(laws, phases=None, more=None, axis=None, **sizes):
    known = {name: {"family": "SPL"} | entry for name, entry in laws.items()} | (more or {})
    moving = ((name, (-1) ** k * 10.0, 20.0 + k) for k, name in enumerate(laws))
    room = {"law": 6, "motion_pieces": 120} | sizes
    return composed(phases or [*moving, REST], known, room, **(axis or {}))


def drawn(dice, n):
    """Points at random, some close together; slopes and ends at random."""
    places = sorted(dice.random() for _ in range(n - 2))
    near = dice.random() < 0.3 and n > 3
    if near:
        places[1] = places[0] + 1e-3 * (1.0 - places[0])
    at = [0.0, *sorted(places), 1.0]
    if min(b - a for a, b in itertools.pairwise(at)) < 1e-4:
        return drawn(dice, n)
    s = [0.0, *(round(dice.uniform(-0.3, 1.3), 3) for _ in places), 1.0]
    return {
        "points": points(*zip(at, s, strict=True)),
        "first_slope": dice.choice((None, 0.0, dice.uniform(-2.0, 2.0))),
        "last_slope": dice.choice((None, 0.0, dice.uniform(-2.0, 2.0))),
        "natural": dice.choice(("none", "begin", "end", "both")),
    }


@pytest.mark.parametrize("seed", [0, *(pytest.param(k, marks=pytest.mark.nightly) for k in range(1, 12))])
def test_so_it_is_for_points_at_random(seed):
    dice = random.Random(seed)
    laws = {f"Points {k}": drawn(dice, n) for k, n in enumerate((2, 3, 5, dice.randint(6, 12), 12))}
    assert disagreeing(MACHINE, machine(laws))[0] == []


@pytest.mark.nightly
def test_so_it_is_for_a_hundred_points():
    dice, last = random.Random(3), 99
    way = [(k / last, k / last + dice.uniform(-0.02, 0.02)) for k in range(1, last)]
    laws = {"Points": {"points": points((0, 0), *way, (1, 1)), "first_slope": 0.5}, "Few": {}}
    assert disagreeing(MACHINE, machine(laws, points=100, motion_pieces=240))[0] == []


SYMMETRIC = {"points": points((0, 0), (0.25, 0.15), (0.5, 0.5), (0.75, 0.85), (1, 1))}
ON_A_LINE = points((0, 0), (0.3, 0.3), (0.7, 0.7), (1, 1))
AT_THE_EDGE = {
    "two points, clamped: the cubic": {"points": points((0, 0), (1, 1))},
    "a line": {"points": points((0, 0), (1, 1)), "natural": "both"},
    "points on a line": {"points": ON_A_LINE, "natural": "both"},
    "points on a line, with its slope": {"points": ON_A_LINE, "first_slope": 1.0, "last_slope": 1.0},
    "a parabola": {"points": points((0, 0), (0.5, 0.25), (1, 1)), "first_slope": 0.0, "last_slope": 2.0},
    "natural, symmetric": SYMMETRIC | {"natural": "both"},
    "flat between points": {"points": points((0, 0), (0.3, 0.5), (0.6, 0.5), (1, 1))},
    "points as near as may be": {"points": points((0, 0), (0.5, 0.5), (0.500001, 0.500001), (1, 1))},
}


def test_so_it_is_at_the_edge():
    assert disagreeing(MACHINE, machine(AT_THE_EDGE))[0] == []


BAD = {
    "not to one": (points((0, 0), (0.5, 0.5), (1, 0.9)), "lead", "they lead from (0, 0) to (1, 0.9); expected"),
    "not from zero": (points((0.1, 0), (1, 1)), "lead", "they lead from (0.1, 0) to (1, 1); expected"),
    "back": (points((0, 0), (0.6, 0.5), (0.4, 0.7), (1, 1)), "rise", "point 3 is at 0.4, the one before at 0.6"),
    "twice": (points((0, 0), (0.6, 0.5), (0.6, 0.5), (1, 1)), "rise", "point 3 is at 0.6, the one before at 0.6"),
    "one": (points((0, 0)), "enough", "1 points are given; expected 2 or more"),
}


def test_points_that_make_no_law_fail_by_row_and_are_built():
    one = machine({what: {"points": given} for what, (given, _, _) in BAD.items()})
    assert len(one.design.faults) == len(BAD)
    value = computed(MACHINE, one, by_cells=True)
    for number, (_, rule, says) in enumerate(BAD.values(), 8):
        assert value(f"SPL{number}_{rule}") == "FAIL"
        assert value(f"SPL{number}_{rule}_says").startswith(says)


def test_more_points_than_room_are_refused():
    many = points(*((k / 12, k / 12) for k in range(13)))
    with pytest.raises(InputError, match=r'laws\."My points"\.points: 13 rows do not fit into 12; raise sizes\.points'):
        machine({"My points": {"points": many}})


def beside_a_line(slope, *between):
    laws = {"Points": {"points": points((0, 0), (0.4, 0.2), (1, 1)), "last_slope": slope}}
    lines = {code: {"family": code} for code in ("LIN", "PO5")}
    return machine(
        laws,
        (("Points", 30.0, 60.0), *between, ("LIN", 20.0, 40.0)),
        lines,
        {"closes": "open", "smoothness": "velocity"},
    )


@pytest.mark.parametrize(("slope", "verdict"), [(1.0, "OK"), (0.9, "FAIL"), (None, "FAIL")])
def test_beside_a_straight_line_the_slope_that_is_entered_meets_it_or_the_joint_is_told(slope, verdict):
    """0.5 mm/° of the line are the slope 0.5 · 60/30 = 1 of the spline."""
    one = beside_a_line(slope)
    value = computed(MACHINE, one)
    assert value("axis1_smooth") == verdict
    assert value("axis1_meets") == "OK"
    if verdict == "FAIL":
        assert value("axis1_smooth_says").startswith("Axis at 60°: velocity jumps by")
    assert disagreeing(MACHINE, one)[0] == []


def test_points_keep_the_rates_they_have_and_the_joint_with_others_that_are_entered_is_told():
    one = beside_a_line(1.0, ("PO5", 5.0, 10.0, None, 0.01))
    value = computed(MACHINE, one)
    assert (value("axis1_meets"), value("axis1_smooth")) == ("OK", "FAIL")
    assert value("axis1_smooth_says").startswith("Axis at 60°: velocity jumps by")
    assert disagreeing(MACHINE, one)[0] == []
