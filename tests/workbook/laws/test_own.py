"""Laws of one's own: any number, exact extremes, by how much they miss, and what mends them."""

import math

import pytest

from engine.laws.pieces import misses, normalized
from tests.workbook.cells import computed, disagreeing
from tests.workbook.composed import MACHINE, composed

OFF = [{"duration": 0.3, "c0": 4.0}, {"duration": 0.3}, {"duration": 0.4, "c0": -3.5}]
UP = [{"duration": 1.0, "c0": 4.0}]


def machine(**laws):
    own = {name: {"family": "OWN", "pieces": pieces} for name, pieces in laws.items()}
    return composed(laws=own, sizes={"law": 10})


@pytest.fixture(scope="module")
def cells():
    return computed(MACHINE, machine(Off=OFF, Up=UP))


def test_each_own_law_tells_by_how_much_it_misses_and_what_mends_it(cells):
    made = [piece.engine_piece for piece in machine(Off=OFF).laws["Off"].pieces]
    off, right = misses(made), normalized(made)
    assert (cells("OWN8_miss_s"), cells("OWN8_miss_v")) == pytest.approx((off.s, off.v), rel=1e-9)
    assert cells("OWN8_mends") == "yes"
    assert cells("OWN8_mend", "c0")[:3] == pytest.approx([piece.c[0] for piece in right], rel=1e-9)
    assert (cells("OWN8_reaches"), cells("OWN8_rests")) == ("FAIL", "FAIL")
    assert cells("OWN9_mends").startswith("no")


def test_a_law_with_the_scaled_entries_passes_its_checks():
    entered = [piece.engine_piece for piece in machine(Off=OFF).laws["Off"].pieces]
    pieces = [{"duration": p.duration, "c0": p.c[0]} for p in normalized(entered)]
    value = computed(MACHINE, machine(Right=pieces))
    assert [value(f"OWN8_{name}") for name in ("sum", "reaches", "rests", "dense")] == ["OK"] * 4


@pytest.mark.parametrize("beside", [1e-8, -1e-7, 1e-6, -1e-5])
def test_a_velocity_that_is_largest_next_to_a_point_of_the_table_is_found_there(beside):
    """Of nine points one is in the middle of a single piece: it counts where v there is as good as the largest."""
    top = 0.5 + beside
    machine_ = machine(Near=[{"duration": 1.0, "c0": 4.0 * top, "c1": -4.0}])
    assert disagreeing(MACHINE, machine_)[0] == []
    assert computed(MACHINE, machine_)("OWN8_v_at") == pytest.approx(top, abs=4e-5)


@pytest.mark.parametrize("gains", [[], [{"duration": 0.1, "amplitude": 4.0, "omega": 20.0 * math.pi}]],
                         ids=["no duration", "a whole turn of a sine"])  # fmt: skip
def test_of_a_law_that_gains_nothing_but_rounding_no_factors_are_told(gains):
    """What gains velocity is a stage of no duration, whose gain is rounding in cells and 0 in the engine."""
    loses = [{"duration": 0.6, "c0": -5.6, "c1": 0.55, "c2": 2.4, "amplitude": -0.98, "omega": 12.7, "phase": 0.2},
             {"duration": 0.0, "c0": 8.8, "c1": 8.0, "c3": 16.6, "amplitude": 2.2, "omega": 8.8, "phase": 1.7},
             {"duration": 0.4 - 0.1 * len(gains), "amplitude": -6.1, "omega": 5.1, "phase": 1.0}]  # fmt: skip
    odd = machine(Odd=[*loses, *gains])
    assert disagreeing(MACHINE, odd)[0] == []
    assert computed(MACHINE, odd)("OWN8_mends").startswith("no")


def test_a_sine_with_too_many_turns_for_the_points_is_told():
    value = computed(MACHINE, machine(Fast=[{"duration": 1.0, "amplitude": 4.0, "omega": 90.0}]))
    assert value("OWN8_dense") == "FAIL"
