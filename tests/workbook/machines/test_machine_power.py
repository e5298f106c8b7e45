"""Energy of a machine's drives: against the sum of their powers by the equation of motion, and by the hour."""

import random

import pytest

from tests.tiers import nights
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.simulated import Simulated, bus_of
from tests.workbook.machines.test_machine import RISE, TEMPLATE, driven, small
from tests.workbook.machines.test_machine_drives import small as with_laws
from workbook.fields.units import KW
from workbook.machines.machine.drive_entries import PowerEntry
from workbook.machines.machine.exact import drives_of

POWER = PowerEntry(efficiency=0.9, hours=4000.0, price=0.3)
PEAK, ENERGY = 0.06, 0.03  # by which the peak power and the energy of one drive may be off
AXES = [driven(*RISE, reducer={"ratio": 3.0, "efficiency": 0.8}),
        driven(*RISE, shift=30.0, load={"mass": 8.0, "slope": 90.0}) | {"name": "A2"}]  # fmt: skip


def machine(axes=AXES, power=POWER):
    """A machine of two drives."""
    return small(axes).model_copy(update={"power": power})


def alone(made):
    """What each drive of a machine takes by itself, by its equation of motion."""
    return [bus_of([Simulated(view.tables.axis, made)], made.power.efficiency) for view in drives_of(made)]


def together(made):
    """What the drives of a machine take on a common bus, by their equations of motion."""
    return bus_of([Simulated(view.tables.axis, made) for view in drives_of(made)], made.power.efficiency)


def assert_bounded(value, exact):
    """What the sheet says of the common bus is true: peaks and means lie within its bounds, those within the sums."""
    peaks = {"mains": exact.peak, "resistor": exact.burnt_peak}
    sums = {"mains": "peak", "resistor": "burnt"}
    for name, peak in peaks.items():
        here, most = (KW * value(f"bus_{name}_{end}") for end in ("peak", "most"))
        on_bus = zip(value("on_bus", "on"), value("power", sums[name]), strict=True)
        assert here <= most <= KW * sum(bus * each for bus, each in on_bus) * (1 + 1e-9)
        assert peak <= most * (1 + PEAK) + 1e-9 * exact.peak
    apart, saved, most = (KW * value(f"bus_{name}") for name in ("apart", "saved", "saved_most"))
    assert KW * value("power_mean") == pytest.approx(KW * value("power_mains") - saved)
    assert -1e-9 * apart <= saved <= apart
    error = ENERGY * apart
    assert apart - most - error <= exact.mean <= apart + error


def test_the_sums_are_those_of_the_power_of_all_drives():
    made = machine()
    value = computed(TEMPLATE, made)
    each, common = alone(made), together(made)
    mains = sum(one.mean for one in each)
    assert KW * value("power_mains") == pytest.approx(mains, rel=0.03)
    assert KW * value("power_resistors") == pytest.approx(sum(one.burnt for one in each), abs=0.03 * mains)
    assert value("power_year") == pytest.approx(mains * 4.0, rel=0.03)
    assert KW * value("bus_net") < common.mean < KW * value("power_mains")
    assert_bounded(value, common)


def quick(start):
    """A belt that goes 80 mm and back, each in 0.06 s of a cycle of 10 s, by CIC."""
    belt = {"kind": "belt", "pulley_diameter": 60.0, "efficiency": 0.95}
    return driven((start, start + 2.16, 80.0, "CIC"), (200.0, 202.16, -80.0, "CIC"), mechanism=belt)


def slow_machine(axes, **sizes):
    """A machine of six cycles a minute."""
    made = small(axes, **sizes)
    return made.model_copy(update={"master": made.master.model_copy(update={"rate": 6.0}), "power": POWER})


def test_a_short_movement_in_a_long_cycle_has_its_exact_power_on_the_bus():
    """80 mm by CIC in 0.06 s of 10 s, between samples of the cycle: the bus of one drive is the drive alone."""
    made = slow_machine([quick(10.3)])
    value, exact = computed(TEMPLATE, made), together(made)
    assert KW * value("bus_mains_peak") == pytest.approx(exact.peak, rel=5e-3)
    assert value("bus_alone") == pytest.approx(value("bus_mains_peak"), rel=1e-12)
    assert KW * value("power_mean") == pytest.approx(exact.mean, rel=0.03)
    assert value("power_bus_year") == pytest.approx(value("power_year"), rel=1e-12)
    assert value("bus_mains_most") == pytest.approx(value("bus_mains_peak"), rel=1e-12)
    assert value("bus_saved_most") == 0.0


@pytest.mark.parametrize("number", [0, *nights(2)])
def test_many_drives_whose_cuts_all_differ_are_bounded_with_few_samples(number):
    """Each drive begins and ends elsewhere, between samples of 30°, with jumps of acceleration; no bound is wide."""
    drawn, count, least = random.Random(f"cuts {number}"), 24 if number else 6, 4.0 if number == 1 else 60.0
    axes = []
    for k in range(count):
        start, back, law = (
            drawn.uniform(0.0, 30.0),
            drawn.uniform(180.0, 210.0),
            drawn.choice(("ACS", "TVP", "CIC", "MTP")),
        )
        rise, fall = (drawn.uniform(least, 145.0) for _ in range(2))
        moves = (start, start + rise, 80.0, law), (back, back + fall, -80.0, law)
        load = {"mass": drawn.uniform(2.0, 60.0)}
        axes.append(driven(*moves, load=load, shift=drawn.uniform(0.0, 360.0)) | {"name": f"A{k}"})
    made = small(axes, cycle=12).model_copy(update={"power": POWER})
    assert disagreeing(TEMPLATE, made)[0] == []
    value, exact = computed(TEMPLATE, made), together(made)
    assert_bounded(value, exact)
    for name, peak in (("mains", exact.peak), ("resistor", exact.burnt_peak)):
        assert peak <= 1.005 * KW * value(f"bus_{name}_most") < 1.4 * peak
    saved = value("bus_apart") - exact.mean / KW
    widest = 1.7 if least == 4.0 else 1.3  # a move of 4° takes and returns between the samples of 30°
    assert 0.97 * saved <= value("bus_saved_most") < widest * saved


def test_a_drive_that_only_gives_back_takes_nothing_from_the_mains():
    """A line all around the cycle, down which its load pulls it."""
    made = with_laws(driven((0.0, 360.0, 200.0, "LIN"), closes="feed", load={"mass": 5.0, "force": -1000.0}))
    made = made.model_copy(update={"power": POWER})
    assert disagreeing(TEMPLATE, made)[0] == []
    value = computed(TEMPLATE, made)
    assert [value(f"bus_mains_{end}") for end in ("peak", "most")] == [0.0, 0.0]
    assert value("bus_resistor_peak") > 0.0


def test_what_the_bus_saves_in_a_year_has_a_price():
    value = computed(TEMPLATE, machine())
    assert value("bus_saved_year") == pytest.approx(value("power_year") - value("power_bus_year"))
    assert value("bus_saved_year") == pytest.approx(4000.0 * value("bus_saved"))
    assert value("bus_saved_price") == pytest.approx(0.3 * value("bus_saved_year"))
    assert sum(value("power", "year")) == pytest.approx(value("power_year"))


def test_a_drive_at_a_rate_of_its_own_counts_at_that_rate():
    slow = computed(TEMPLATE, machine([AXES[0] | {"rate": 50.0}]))
    assert slow("power", "time") == [pytest.approx(1.2)]
    energy = slow("drive1_energy") / 0.9 / 1.2
    assert KW * slow("power_mains") == pytest.approx(energy, rel=1e-12)
    assert slow("on_bus", "on") == [0]
    assert (slow("bus_mains_peak"), slow("bus_apart"), slow("bus_mains_most")) == (0.0, 0.0, 0.0)
    (peak,) = slow("power", "peak")
    assert slow("power_peak") == slow("power_peak_most") == slow("about_peak") == peak > 0.0
