"""Energy of a machine's drives: against the engine's sum over all drives' power, and by the hour."""

import math
import random

import numpy as np
import pytest

from tests.engine.drive.drivetrains import Drivetrains, Supply
from tests.mutation.machines import machine as drawn_machine
from tests.tiers import nights, seed
from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import TEMPLATE, axis, described, driven
from tests.workbook.machines.test_machine_forces import RISE, small
from tests.workbook.machines.test_machine_linked import CRANK, LOSSY, MOTOR, ROCKER, TABLE, linked
from workbook.fields.units import KW
from workbook.law_sheets.library import laws
from workbook.machines.machine.drive.driven import Driven
from workbook.machines.machine.drive_entries import PowerEntry
from workbook.machines.machine.view import MachineView

PRESS = [{"start": 50.0, "stop": 120.0, "force": 900.0, "resists": "moving"},
         {"start": 150.0, "stop": 230.0, "force": -400.0, "resists": "always"}]  # fmt: skip
POWER = PowerEntry(efficiency=0.9, hours=4000.0, price=0.3)
PEAK, ENERGY = 0.06, 0.03  # by which the peak power and the energy of one drive may be off
AXES = [driven(*RISE, reducer={"ratio": 3.0, "efficiency": 0.8}),
        driven(*RISE, shift=30.0, load={"mass": 8.0, "slope": 90.0}) | {"name": "A2"}]  # fmt: skip


def machine(axes=AXES, power=POWER):
    """A machine of two drives."""
    return small(axes).model_copy(update={"power": power})


def together(made):
    """The drives of a machine at its rate, by the engine's search over their cycles."""
    axes = MachineView(made, laws(made.laws)).axes
    drive_cycles = tuple(Driven(one, made).results.drive_cycle for one in axes if one.given.rate is None)
    return Drivetrains(drive_cycles, made.power.efficiency)


def assert_bounded(value, exact):
    """What the sheet says of the common bus is true: peaks and means lie within its bounds, those within the sums."""
    peaks = {"mains": exact.mains_peak, "resistor": exact.resistor_peak}
    sums = {"mains": "peak", "resistor": "burnt"}
    for name, peak in peaks.items():
        here, most = (KW * value(f"bus_{name}_{end}") for end in ("peak", "most"))
        on_bus = zip(value("power", "bus"), value("power", sums[name]), strict=True)
        assert here <= most <= KW * sum(bus * each for bus, each in on_bus) * (1 + 1e-9)
        assert peak <= most * (1 + PEAK) + 1e-9 * exact.mains_peak
    apart, saved, most = (KW * value(f"bus_{name}") for name in ("apart", "saved", "saved_most"))
    assert KW * value("bus_mains") == pytest.approx(apart - saved)
    assert -1e-9 * apart <= saved <= apart
    error = ENERGY * apart
    assert apart - most - error <= exact.mains_mean <= apart + error


def test_the_sums_are_those_of_the_power_of_all_drives():
    made = machine()
    value = computed(TEMPLATE, made)
    alone, common = together(made).supply(False), together(made).supply(True)
    assert KW * value("power_mains") == pytest.approx(alone.mains_mean, rel=0.03)
    assert KW * value("power_resistors") == pytest.approx(alone.resistor_mean, abs=0.03 * alone.mains_mean)
    assert value("power_year") == pytest.approx(alone.energy_a_year(4000.0) / 3.6e6, rel=0.03)
    assert KW * value("power_least") < common.mains_mean < KW * value("power_mains")
    assert_bounded(value, common)


def test_the_first_sheet_tells_the_power_of_all_drives():
    value = computed(TEMPLATE, machine())
    assert value("about_peak") == value("bus_mains_peak")
    assert (value("about_bus_year"), value("about_year")) == (value("bus_year"), value("power_year"))
    assert value("about_bus_year") <= value("about_year")
    assert value("about_peak_most") == value("bus_mains_most")


def test_there_a_drive_at_a_rate_of_its_own_is_beside_the_bus():
    slow = AXES[1] | {"rate": 60.0}
    both, one, other = (computed(TEMPLATE, machine(axes)) for axes in ([AXES[0], slow], AXES[:1], [slow]))
    assert disagreeing(TEMPLATE, machine([AXES[0], slow]))[0] == []
    for name in ("about_peak", "about_bus_year", "about_year"):
        assert both(name) == pytest.approx(one(name) + other(name), rel=1e-12)
    assert other("about_peak") == other("power", "peak")[0]
    assert other("about_bus_year") == other("about_year") > 0.0


def test_the_peaks_of_each_drive_are_those_of_its_power():
    value = computed(TEMPLATE, machine())
    for k, one in enumerate(together(machine()).drive_cycles):
        supply = Drivetrains((one,), POWER.efficiency).supply(False)
        assert KW * value("power", "peak")[k] == pytest.approx(supply.mains_peak, rel=5e-3)
        assert KW * value("power", "burnt")[k] == pytest.approx(supply.resistor_peak, abs=5e-3 * supply.mains_peak)
        assert KW * value(f"drive{k + 1}_pmax") == pytest.approx(supply.mains_peak * POWER.efficiency, rel=5e-3)


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
    value, exact = computed(TEMPLATE, made), together(made).supply(True)
    assert KW * value("bus_mains_peak") == pytest.approx(exact.mains_peak, rel=5e-3)
    assert value("bus_alone") == pytest.approx(value("bus_mains_peak"), rel=1e-12)
    assert KW * value("bus_mains") == pytest.approx(exact.mains_mean, rel=0.03)
    assert value("bus_year") == pytest.approx(value("power_year"), rel=1e-12)
    assert value("bus_mains_most") == pytest.approx(value("bus_mains_peak"), rel=1e-12)
    assert value("bus_saved_most") == 0.0


def test_where_samples_miss_the_peaks_of_two_drives_the_sheet_says_what_they_are_at_most():
    """Both move between the same samples of 30°: their sum is between one drive's peak and twice that."""
    made = slow_machine([quick(10.3), quick(10.3) | {"name": "A2"}], cycle=12)
    value, exact = computed(TEMPLATE, made), together(made).supply(True)
    assert disagreeing(TEMPLATE, made)[0] == []
    at_most = KW * value("bus_mains_most")
    assert KW * value("bus_mains_peak") < 0.95 * exact.mains_peak < exact.mains_peak <= 1.005 * at_most


@pytest.mark.parametrize("number", [0, *nights(2)])
def test_many_drives_whose_cuts_all_differ_are_bounded_with_few_samples(number):
    """Each drive begins and ends elsewhere, between samples of 30°, with jumps of its acceleration."""
    drawn, count = random.Random(f"cuts {number}"), 24 if number else 6
    axes = []
    for k in range(count):
        start, back = drawn.uniform(0.0, 150.0), drawn.uniform(180.0, 320.0)
        law, load = drawn.choice(("ACS", "TVP", "CIC", "MTP")), {"mass": drawn.uniform(2.0, 60.0)}
        moves = (
            (start, start + drawn.uniform(4.0, 28.0), 80.0, law),
            (back, back + drawn.uniform(4.0, 30.0), -80.0, law),
        )
        axes.append(driven(*moves, load=load, shift=drawn.uniform(0.0, 360.0)) | {"name": f"A{k}"})
    made = small(axes, cycle=12).model_copy(update={"power": POWER})
    assert disagreeing(TEMPLATE, made)[0] == []
    value, exact = computed(TEMPLATE, made), together(made).supply(True)
    assert_bounded(value, exact)
    assert exact.mains_peak <= 1.005 * KW * value("bus_mains_most") < 2.0 * exact.mains_peak
    assert KW * value("bus_mains") == pytest.approx(exact.mains_mean, abs=KW * value("bus_saved_most"))


def test_what_the_bus_saves_in_a_year_has_a_price():
    value = computed(TEMPLATE, machine())
    assert value("bus_saved_year") == pytest.approx(value("power_year") - value("bus_year"))
    assert value("bus_saved_year") == pytest.approx(4000.0 * value("bus_saved"))
    assert value("bus_saved_price") == pytest.approx(0.3 * value("bus_saved_year"))
    assert sum(value("power", "year")) == pytest.approx(value("power_year"))


def test_one_drive_is_its_own_bus():
    value = computed(TEMPLATE, machine(AXES[:1]))
    for name, column in (("mains_peak", "peak"), ("mains", "mains"), ("resistor_peak", "burnt")):
        assert value(f"bus_{name}") == pytest.approx(value("power", column)[0], rel=1e-12)


@pytest.mark.parametrize("number", [*range(1), *nights(2)])
def test_random_drives_are_off_by_no_more_than_the_sheet_says(request, number):
    """With process forces, and in every cell as the engine."""
    told = f"power {number}"
    drawn = random.Random(seed(told) if request.node.get_closest_marker("nightly") else told)
    made = drawn_machine(machine([AXES[0] | {"load": {"mass": 20.0, "windows": PRESS}}, AXES[1]]), drawn)
    made = made.model_copy(update={"axes": [axis.model_copy(update={"rate": None}) for axis in made.axes]})
    assert disagreeing(TEMPLATE, made)[0] == []
    value = computed(TEMPLATE, made)
    assert_bounded(value, together(made).supply(True))
    assert value("bus_mains_peak") >= max(value("power", "proves"))


PLACED = {
    "crank": linked(mechanism=CRANK | {"efficiency": 0.85}, **LOSSY),
    "rocker": linked((20, 140, 25.0, "CIC"), (190, 330, -25.0, "MTP"), mechanism=ROCKER | {"efficiency": 0.8}, **LOSSY),
    "table": linked(mechanism=TABLE | {"efficiency": 0.9}, **LOSSY),
    "viscous": driven(*RISE, load={"mass": 8.0, "viscous": 300.0}, reducer={"ratio": 3.0, "efficiency": 0.8}),
}  # fmt: skip


def mixed(*axes, **sizes):
    """A machine of drives that are worked out place by place, and others."""
    named = [one | {"name": f"A{k}"} for k, one in enumerate(axes, 1)]
    return described(named, **{"phases": 2, "rotors": 2, "positions": 6} | sizes).model_copy(update={"power": POWER})


@pytest.mark.parametrize("kind", PLACED)
@pytest.mark.sample(2)
def test_a_drive_that_is_worked_out_place_by_place_shares_the_bus(kind):
    """In every cell as the engine, and by no more off the search over the cycles than the sheet says."""
    made = mixed(PLACED[kind], AXES[1])
    assert disagreeing(TEMPLATE, made)[0] == []
    value, found = computed(TEMPLATE, made), together(made)
    assert value("power", "bus") == [1, 1]
    common = found.supply(True)
    assert_bounded(value, common)
    assert KW * value("power", "peak")[0] == pytest.approx(
        Drivetrains(found.drive_cycles[:1], 0.9).supply(False).mains_peak, rel=5e-3
    )


def test_where_nothing_comes_back_the_bus_takes_the_energies_of_all_drives():
    """Work of friction alone, on a crank and a screw without inertia: what the bus takes is the sum of both."""
    bare = {"motor": MOTOR | {"inertia": 0.0}}
    crank = linked(load={"mass": 0.0, "viscous": 400.0}, **bare)
    screw = driven(*RISE, load={"mass": 0.0, "viscous": 900.0}, **bare)
    made = mixed(crank, screw, cycle=360)
    value, common = computed(TEMPLATE, made), together(made).supply(True)
    energies = value("drive1_energy") + value("drive2_energy")
    assert common.mains_mean == pytest.approx(energies / 0.9 / value("timing_cycle"), rel=0.03)
    assert KW * value("bus_mains") == pytest.approx(common.mains_mean, rel=0.03)
    assert KW * value("power_mains") == pytest.approx(common.mains_mean, rel=0.03)
    assert value("bus_resistor") == pytest.approx(0.0, abs=1e-6 * value("bus_mains"))
    assert value("drive1_returned") == pytest.approx(0.0, abs=1e-9 * energies)


def kinetic(time, rates, inertia):
    """Power (W) that changes a kinetic energy, by differences of it over time."""
    return np.gradient(0.5 * inertia * rates**2, time)


def test_the_bus_against_power_from_differentiated_positions():
    """A crank's angle by the law of cosines and its kinetic energy, both differentiated; a screw's by its lead."""
    crank = linked((20, 140, 60.0, "CIC"), (190, 330, -60.0, "CIC"), load={"mass": 12.0, "friction": 0.1})
    screw = driven(*RISE, load={"mass": 8.0, "viscous": 300.0}, shift=77.0)
    made = mixed(crank, screw)
    value = computed(TEMPLATE, made)
    one, other = MachineView(made, laws(made.laws)).axes
    time = np.linspace(0.0, value("timing_cycle"), 60001)
    y, z = (axis.at(2 * math.pi * time / time[-1]).y for axis in (one, other))
    inner = math.sqrt((0.2 - 0.05) ** 2 - 0.01**2) + 0.015
    x, r, rod, e = inner + y, 0.05, 0.2, 0.01
    angle = np.arctan2(e, x) + np.arccos((r**2 + x**2 + e**2 - rod**2) / (2 * r * np.hypot(x, e)))
    turning, v, w = (np.gradient(place, time) for place in (angle, y, z))
    weight = 12.0 * 9.81
    motor = MOTOR["inertia"] * 1e-4  # kg m²
    first = kinetic(time, turning, motor) + kinetic(time, v, 12.0) + 0.1 * weight * np.abs(v)
    second_motor = screw["motor"]["inertia"] * 1e-4 * (2 * math.pi / 0.01) ** 2
    second = kinetic(time, w, 8.0 + second_motor) + 300.0 * w**2
    drawn = sum(np.where(power > 0, power / 0.9, power * 0.9) for power in (first, second))
    ups, downs = np.maximum(drawn, 0.0), np.maximum(-drawn, 0.0)
    means = [float(np.trapezoid(part, time) / time[-1]) for part in (ups, downs)]
    expected = ups.max(), means[0], downs.max(), means[1]
    assert_bounded(value, Supply(*expected))
    assert tuple(together(made).supply(True)) == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize("number", nights(2))
def test_random_placed_drives_are_off_by_no_more_than_the_sheet_says(number):
    """Two that are worked out place by place and one that is not, in every cell as the engine."""
    drawn = random.Random(seed(f"placed power {number}"))
    kinds = drawn.sample(list(PLACED), 2)
    made = drawn_machine(mixed(*(PLACED[kind] for kind in kinds), AXES[0]), drawn)
    made = made.model_copy(update={"axes": [axis.model_copy(update={"rate": None}) for axis in made.axes]})
    assert disagreeing(TEMPLATE, made)[0] == []
    value, exact = computed(TEMPLATE, made), together(made).supply(True)
    assert_bounded(value, exact)


def test_a_drive_at_a_rate_of_its_own_counts_at_that_rate():
    slow = computed(TEMPLATE, machine([AXES[0] | {"rate": 50.0}]))
    assert slow("power", "time") == [pytest.approx(1.2)]
    energy = slow("drive1_energy") / 0.9 / 1.2
    assert KW * slow("power_mains") == pytest.approx(energy, rel=1e-12)
    assert slow("power", "bus") == [0]
    assert (slow("bus_mains_peak"), slow("bus_mains"), slow("bus_mains_most")) == (0.0, 0.0, 0.0)


def test_the_entries_come_back_and_a_machine_without_drives_has_none():
    assert entered(TEMPLATE, machine()) == (machine(), [])
    still = [axis(1, *RISE)]
    assert "power" not in TEMPLATE.declare(small(still)).blocks
    with pytest.raises(ValueError, match="no axis has a drive"):
        TEMPLATE.model.model_validate(small(AXES).model_dump() | {"axes": still, "power": {"hours": 1.0}})
