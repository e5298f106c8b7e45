"""Axes that must stay apart: their least gap in cells, against samples and closed forms."""

import math
import random

import numpy as np
import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from workbook.fields.units import shown
from workbook.machines.machine import exact
from workbook.machines.machine.axes import axes_of
from workbook.machines.machine.gap import ClearanceView

PUNCH = axis(1, (30, 90, 20.0, "CIC"), (150, 210, -20.0, "CIC"))
FEED = axis(2, (60, 140, 50.0, "MTP"), (200, 280, -50.0, "MTP"), shift=12.5)
ARM = axis(3, (0, 100, 90.0, "CIC"), (180, 300, -90.0, "CIC"), unit="°")
GAP = {"name": "Gap", "first": "A1", "second": "A2"}


def machine(*clearances, axes=(PUNCH, FEED, ARM), **sizes):
    """A machine with clearances."""
    data = described(list(axes), phases=2, **sizes).model_dump() | {"clearances": [GAP | one for one in clearances]}
    return TEMPLATE.model.model_validate(data)


def views(given):
    """The engine's view of the clearances."""
    rows = axes_of(given)
    return [ClearanceView(one, k, rows) for k, one in enumerate(given.clearances, 1)]


def sampled(one, count):
    """The gap at so many places of the turn, by the motions themselves."""
    x = np.linspace(0.0, 2 * math.pi, count)
    return one.given.offset + sum(f * shifted.over_cycle(x).y for f, shifted in one.terms), x


def test_the_least_gap_is_that_of_a_fine_table():
    made = machine({"first_factor": -1.0, "second_factor": 0.3, "offset": 8.0}, {"name": "Other", "second": "A3"})
    value = computed(TEMPLATE, made)
    for k, one in enumerate(views(made)):
        gaps, x = sampled(one, 200_001)
        least, at = value("clearances", "gap")[k], value("clearances", "at")[k]
        assert least == pytest.approx(gaps.min(), abs=1e-4 * one.change)
        assert least >= one.exact - 1e-12
        assert gaps[np.abs(x - math.radians(at)).argmin()] == pytest.approx(least, abs=1e-3)


def test_the_check_says_where_and_by_how_much():
    made = machine({"first_factor": -1.0, "second_factor": 0.0, "offset": 25.0, "least": 6.5})
    value = computed(TEMPLATE, made)
    assert value("clear1_kept") == "FAIL"
    assert value("clear1_kept_says") == "Gap: 5 mm at 90°; expected at least 6.5 mm"
    assert computed(TEMPLATE, machine({"first_factor": -1.0, "second_factor": 0.0, "offset": 25.0, "least": 5.0}))(
        "clear1_kept"
    ) == "OK"  # fmt: skip


@pytest.mark.parametrize(
    ("entry", "said"), [({"first": "A9"}, "no axis is named 'A9'"), ({"second": "a1"}, "is the first axis too")]
)
def test_an_axis_that_is_not_there_is_refused(entry, said):
    with pytest.raises(ValueError, match=said):
        machine(entry)


@pytest.mark.parametrize("number", [*range(8), *nights(25)])
def test_least_gaps_are_as_exact_as_their_sheet_states(number):
    made = drawn_machine(machine({}, {"name": "Other", "first": "A3"}), random.Random(f"exact gap {number}"))
    for one in views(made):
        if all(rows.axis.missing_lift < 1e-9 for rows in one.rows):
            assert -1e-9 * one.size <= one.least - one.exact <= exact.GAP * one.change + 1e-9 * one.size
            assert exact.gap_of(one) == ""


def test_a_least_gap_that_is_farther_off_is_told(monkeypatch):
    one = views(machine({"first_factor": -1.0, "second_factor": 0.3, "offset": 8.0}))[0]
    monkeypatch.setattr(one, "least", one.exact + 2.0 * exact.GAP * one.change)
    assert exact.gap_of(one).startswith("Gap: the least gap is ")


PAIRS = [[-5.0, 30.0], [3.0, 42.0], [10.0, 46.0], [14.5, 60.0], [25.0, 52.0]]
BY_PAIRS = {"first_factor": 1.0, "second_factor": -1.0, "offset": 2.0, "pairs": PAIRS}


def by_hand(one, count=400_001):
    """The gap of a clearance by pairs at so many places of the turn."""
    x = np.linspace(0.0, 2 * math.pi, count)
    (_, first), (_, second) = one.terms
    at, free = np.array([[pair.at, pair.free] for pair in one.given.pairs]).T
    y, z = (shown(shifted.over_cycle(x).y, rows.axis.unit)
            for shifted, rows in zip((first, second), one.rows, strict=True))  # fmt: skip
    ends = np.clip(y, at[0], at[-1])
    beyond = np.where(y < at[0], (free[1] - free[0]) / (at[1] - at[0]), (free[-1] - free[-2]) / (at[-1] - at[-2]))
    limit = np.interp(ends, at, free) + beyond * (y - ends)
    return one.given.offset + one.given.first_factor * limit + one.given.second_factor * z, x


@pytest.mark.parametrize("second", ["A2", "A3"])
def test_the_exact_gap_by_pairs_is_that_of_a_fine_table(second):
    (one,) = views(machine(BY_PAIRS | {"second": second}))
    gaps, _ = by_hand(one)
    assert one.exact == pytest.approx(gaps.min(), abs=1e-4)
    assert one.exact <= gaps.min() + 1e-12
    assert one.unit == {"A2": "mm", "A3": "°"}[second]


def test_the_cells_of_a_gap_by_pairs_are_the_engine_s_and_its_check_says_where():
    made = machine(BY_PAIRS | {"least": 50.0}, {"name": "Other", "second": "A3", "pairs": [[0, 90], [20, 100]]})
    wrong, _ = disagreeing(TEMPLATE, made)
    assert wrong == []
    value = computed(TEMPLATE, made)
    assert value("clear1_kept") == "FAIL"
    assert value("clear1_covered") == value("clear2_covered") == "OK"
    assert value("clearances", "gap")[0] == pytest.approx(views(made)[0].exact, rel=0.02)


@pytest.mark.parametrize(
    ("pairs", "said"),
    [
        ([[0.0, 1.0]], "one pair; expected two or more"),
        ([[0.0, 1.0], [0.0, 2.0]], "expected positions that rise"),
        ([[0.0, 1.0], [1.0]], "pairs"),
        ([[k, 1.0] for k in range(13)], "12"),
    ],
)
def test_pairs_that_cannot_be_meant_are_refused(pairs, said):
    with pytest.raises(ValueError, match=said):
        machine(BY_PAIRS | {"pairs": pairs})


def drawn_pairs(number):
    """A machine with a clearance by pairs at random."""
    drawn = random.Random(f"pairs {number}")
    given = drawn_machine(machine({}), random.Random(f"exact gap {number}"))
    (one,) = views(given)
    low, high = sorted(shown(np.array(one.rows[0].axis.motion.reach), one.rows[0].axis.unit).tolist())
    width, count = max(high - low, 1.0), drawn.randint(2, 12)
    at = sorted(low - 0.1 * width + 1.2 * width * drawn.random() for _ in range(count))
    free = [drawn.uniform(0.5, 1.5) * width for _ in at]
    clearance = given.clearances[0].model_dump() | {"pairs": [list(pair) for pair in zip(at, free, strict=True)]}
    return type(given).model_validate(given.model_dump() | {"clearances": [clearance]})


@pytest.mark.parametrize("number", [*range(6), *nights(40)])
def test_least_gaps_by_pairs_are_as_exact_as_their_sheet_states(number):
    (one,) = views(drawn_pairs(number))
    gaps, _ = by_hand(one, 20_001)
    assert one.exact <= gaps.min() + 1e-9 * one.size
    if all(rows.axis.missing_lift < 1e-9 for rows in one.rows):
        assert -1e-9 * one.size <= one.least - one.exact <= exact.PAIRS_GAP * one.change + 1e-9 * one.size


def test_the_exact_gap_decides_where_the_sheet_sees_less():
    """Its points miss a turn of the lines: the sheet has more room than there is."""
    made = drawn_pairs(116)
    (one,) = views(made)
    asked = 0.5 * (one.least + one.exact)
    data = made.model_dump()
    data["clearances"][0]["least"] = asked
    judged = exact.judgement(type(made).model_validate(data)).limits[-1]
    assert (judged.check, judged.sheet.ok, judged.exact.ok, judged.ok) == ("clear1_kept", True, False, False)
    assert judged.line.startswith("least gap is ")
