"""A belt that carries its load over a bed, level or inclined: closed forms, cells, entries, what cannot be."""

import math

import pytest

from engine.drive import Slide
from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, driven
from tests.workbook.machines.test_machine_linked import small
from workbook.reading.descriptions import validated

G, RADIUS, ETA = 9.81, 0.075, 0.9
BED = {"efficiency": ETA, "belt_mass": 10.0, "belt_on_bed": 4.5}
KINDS = {"conveyor": {"kind": "conveyor", "roller_diameter": 150.0}, "belt": {"kind": "belt", "pulley_diameter": 150.0}}


def carried(slope=0.0, kind="conveyor", **bed):
    """30 kg on a belt that moves 500 mm on, with half its way at a uniform velocity."""
    load = {"mass": 30.0, "friction": 0.3, "slope": slope}
    return driven((0, 300, 500.0, "TVP"), closes="feed", mechanism=KINDS[kind] | BED | bed, load=load)


@pytest.mark.parametrize("slope", [0.0, 20.0, -35.0])
@pytest.mark.parametrize("kind", KINDS)
def test_its_weight_rubs_on_the_bed_and_its_mass_is_accelerated(slope, kind):
    """T = r (F_g + R)/η upwards, F_g = m g sin γ, R = μ (m + m_bed) g cos γ; a adds r (m + m_b) a/η."""
    value = computed(TEMPLATE, small(carried(slope, kind)))
    rubs = 0.3 * (30.0 + 4.5) * G * math.cos(math.radians(slope))
    falls = 30.0 * G * math.sin(math.radians(slope))
    assert value("drive1_rub") == pytest.approx(rubs, rel=1e-12)
    assert value("drive1_steady") == pytest.approx(falls, abs=1e-9)
    assert value("drive1_m") == pytest.approx(40.0)
    at = {name: value("drive1_pt", name) for name in ("a", "v", "T", "S")}
    for a, v, behind in zip(at["a"], at["v"], at["S"], strict=True):
        if v > 1e-6:
            force = falls + rubs + 40.0 * a
            assert behind == pytest.approx(force * RADIUS * (1 / ETA if force > 0 else ETA), rel=1e-9, abs=1e-9)


def test_no_belt_on_the_bed_is_a_load_on_a_guide():
    one, other = (computed(TEMPLATE, small(carried(20.0, belt_on_bed=mass))) for mass in (None, 0.0))
    for name in ("rms", "tmax", "tmin", "rub", "jtot", "energy"):
        assert other(f"drive1_{name}") == pytest.approx(one(f"drive1_{name}"), rel=1e-12)


@pytest.mark.parametrize("slope", [0.0, 20.0])
def test_cells_agree_and_entries_come_back_at_every_variation(slope):
    machine = small(carried(slope))
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])
    for variation in TEMPLATE.variants(machine)[:2]:
        assert disagreeing(TEMPLATE, variation)[0] == []


def test_more_belt_on_the_bed_than_there_is_makes_an_unfinished_design():
    data = small(carried()).model_dump()
    data["axes"][0]["mechanism"]["belt_on_bed"] = 12.0
    faults = validated(TEMPLATE, data, str).design.faults
    assert ["more of the belt" in str(fault) for fault in faults] == [True]


def test_the_engine_refuses_a_negative_mass_on_the_bed():
    with pytest.raises(ValueError, match="bed"):
        Slide(1.0, bed=-1.0)
