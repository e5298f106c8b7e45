"""Selection for drives of a ratio that changes, or with viscous friction: its pairs against drives that have them."""

import random

import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import RISE, TEMPLATE, driven, small
from tests.workbook.machines.test_machine_drives import CRANK, LOSSY, ROCKER, TABLE, linked, press
from tests.workbook.machines.test_machine_selection import WIDE, chosen
from workbook.judging.matching import is_formula

BELOW = 5e-3
"""of a peak: what it may be more between the nodes"""
LIFTS = {"crank-slider": (60.0, CRANK), "rocker": (25.0, ROCKER), "table": (60.0, TABLE)}


def choosing(*axes, **selection):
    """A machine with the catalogue, that looks at the last of its axes."""
    data = small([driven(*RISE)]).model_dump() | {"axes": list(axes)}
    data["sizes"] |= {"motors": 6, "reducers": 5, "phases": 2, "rotors": 2}
    return TEMPLATE.model.model_validate(data | chosen({"axis": axes[-1]["name"]} | WIDE | selection))


def placed(kind, **entries):
    """An axis with losses, a process force and parts, on a mechanism that is worked out place by place."""
    if kind == "plain":
        return driven((20, 140, 60.0, "CIC"), (190, 330, -60.0, "MTP")) | LOSSY | entries
    if kind == "viscous":
        axis = driven((20, 140, 60.0, "CIC"), (190, 330, -60.0, "MTP")) | LOSSY
        return axis | {"load": LOSSY["load"] | {"viscous": 150.0}} | entries
    lift, mechanism = LIFTS[kind]
    phases = ((20, 140, lift, "CIC"), (190, 330, -lift, "MTP"))
    return linked(*phases, mechanism=mechanism | {"efficiency": 0.85}, **LOSSY | entries)


def require_pairs_of_the_grid(axis, pairs):
    """Raise AssertionError unless pairs of the grid do what the sheet of a drive says that has them."""
    value = computed(TEMPLATE, choosing(axis))
    for m, r in pairs:
        one = axis | {"motor": axis["motor"] | {"name": f"M{m}"}, "reducer": {"name": f"R{r}"}}
        told = computed(TEMPLATE, choosing(one))
        peak = max(told("drive1_tmax"), -told("drive1_tmin"))
        share, rated = value(f"sel_share{r}", "v"), value("sel_motors", "rated")
        assert share[m - 1] * rated[m - 1] == pytest.approx(told("drive1_rms"), rel=1e-9)
        assert peak * (1 - BELOW) <= value(f"sel_peak{r}", "v")[m - 1] <= peak * (1 + 1e-9)
        assert value("sel_reducers", "n")[r - 1] == pytest.approx(told("drive1_speed"), rel=1e-9)
        assert value("sel_reducers", "j")[r - 1] * 1e4 == pytest.approx(told("drive1_jtot"), rel=1e-9)


@pytest.mark.parametrize("kind", ["plain", "viscous", *LIFTS])
@pytest.mark.sample(2)
def test_each_cell_agrees_and_a_pair_does_what_a_drive_with_it_does(kind):
    axis = placed(kind)
    given = choosing(axis)
    assert disagreeing(TEMPLATE, given)[0] == []
    assert entered(TEMPLATE, given) == (given, [])
    require_pairs_of_the_grid(axis, ((4, 2), (2, 4)))


def of_each_kind():
    """Axes whose drives have points at pieces of the motion alone, and one at even steps of its turn as well."""
    axes = driven(*RISE), placed("viscous"), placed("crank-slider"), press((20, 340, 360.0, "CIC"))
    return [axis | {"name": name} for name, axis in zip("ABCD", axes, strict=True)]


def test_whichever_axis_is_named_the_formulas_are_the_same():
    """So that an axis that is named in the book has room for all of its points."""
    named = [TEMPLATE.declare(choosing(*of_each_kind(), axis=name)).cells() for name in "ABCD"]
    first, *others = [
        {(c.block.sheet.title, c.row, c.column): c.content for c in cells if is_formula(c.content)} for cells in named
    ]
    assert all(other == first for other in others)


@pytest.mark.parametrize("named", range(4))
@pytest.mark.sample(1)
def test_drives_of_each_kind_among_the_axes(named):
    """The sheet has room for the places of the drive with the most; the others leave theirs empty."""
    axes = of_each_kind()
    given = choosing(*axes, axis=axes[named]["name"])
    assert disagreeing(TEMPLATE, given)[0] == []
    alone = computed(TEMPLATE, choosing(axes[named]))
    together = computed(TEMPLATE, given)
    for column in ("motor", "reducer", "rms", "peak", "spare"):
        assert together("sel_best", column) == alone("sel_best", column), column


@pytest.mark.sample(1)
@pytest.mark.parametrize(("holding", "method"), [("brake", "physical"), ("motor", "document")])
def test_who_holds_and_how_losses_count(holding, method):
    axis = placed("crank-slider")
    axis |= {"motor": axis["motor"] | {"holding": holding}, "mechanism": axis["mechanism"] | {"method": method}}
    assert disagreeing(TEMPLATE, choosing(axis))[0] == []
    require_pairs_of_the_grid(axis, ((5, 3),))


@pytest.mark.parametrize("number", nights(10))
def test_random_drives_among_the_pairs(number):
    drawn = random.Random(seed(f"placed selection {number}"))
    kind = drawn.choice(["viscous", *LIFTS])
    made = drawn_machine(choosing(placed(kind)), drawn)
    assert disagreeing(TEMPLATE, made)[0] == []
