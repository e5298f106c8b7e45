"""The laws side by side: the reference's figures in cells, continuity in words, the curves that are chosen."""

import pytest

from engine.laws import CATALOGUE
from engine.laws.family import Vendors
from tests.workbook.cells import computed, disagreeing
from workbook.laws.registry import CODES
from workbook.reading import descriptions
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["motion-laws"]
SMALL = {"cycle": 4, "law": 4}
FIGURES = {  # C_v, C_a+, C_a,rms, (va)+, E, order at ends and inside: the laws compared with each other at λ = 1/2
    "CUB": (1.5, 6, 3.464101615138, 3.464101615138, 1, "velocity", "jerk"),
    "Simple harmonic": (1.570796326795, 4.934802200545, 3.489432099819, 3.875784585037, 1.014678031604, "velocity",
                        "jerk"),
    "TVP": (1.5, 4.5, 3.674234614175, 6.75, 1.125, "velocity", "velocity"),
    "Sine-straight-sine": (1.222030940703, 7.678246851546, 3.839123425773, 4.691527611473, 1.228239056527, "velocity",
                           "acceleration"),
    "Modified sine": (1.759603385954, 5.527957070544, 3.908855930690, 5.457752762719, 1.273262890574, "acceleration",
                      "jerk"),
    "ACS": (2, 4, 4, 8, 1.333333333333, "velocity", "velocity"),
    "Jerk-limited S-curve": (1.5, 6, 4, 7.5, 1.333333333333, "acceleration", "acceleration"),
    "Polynomial 3-4-5": (1.875, 5.773502691896, 4.140393356054, 6.694268727496, 1.428571428571, "acceleration", "jerk"),
    "Sine-ramp trapezoid": (1.333333333333, 8.377580409573, 4.188790204786, 7.255197456937, 1.462163614976,
                            "acceleration", "acceleration"),
    "MTP": (2, 4.888123762813, 4.233239355439, 8.089980982313, 1.493359620036, "acceleration", "jerk"),
    "Sine-constant-cosine": (2, 5.278810157861, 4.310130445260, 8.097972240976, 1.548102037930, "acceleration", "jerk"),
    "CIC": (2, 6.283185307180, 4.442882938158, 8.162097139054, 1.644934066848, "acceleration", "jerk"),
    "Polynomial 4-5-6-7": (2.1875, 7.513188404399, 5.045249791095, 10.75022616403, 2.121212121212, "jerk", "jerk"),
    "Double harmonic": (2.040524284764, 5.551652475613, 4.934802200545, 7.751569170075, 2.029356063208, "velocity",
                        "jerk"),
    "Straight line": (1, 0, 0, 0, 0, "position", "jerk"),
}  # fmt: skip


@pytest.fixture(scope="module")
def value():
    return computed(TEMPLATE, described())


def described(**comparison):
    machine = read_machine(TEMPLATE.description)
    data = machine.model_dump()
    data["sizes"] |= SMALL
    data["comparison"] |= comparison
    return TEMPLATE.model.model_validate(data)


def row_of(value, name):
    return value("costs", "law").index(name)


@pytest.mark.parametrize("name", FIGURES)
def test_the_references_figures_stand_in_the_table(value, name):
    """motion-laws' figures are those of the reference table of thirteen digits, which mpmath verified."""
    k, (*numbers, ends, within) = row_of(value, name), FIGURES[name]
    found = [value("costs", column)[k] for column in ("cv", "ca_max", "ca_rms", "va_max", "loss")]
    assert found == pytest.approx(numbers, rel=1e-12, abs=1e-13)
    assert (value("costs", "at_ends")[k], value("costs", "within")[k]) == (ends, within)


def test_the_jerk_is_infinite_where_the_acceleration_jumps(value):
    costs = [value("costs", column) for column in ("law", "cj")]
    orders = [value("costs_worked", column) for column in ("ends", "inside")]
    for name, jerk, ends, within in zip(*costs, *orders, strict=True):
        smooth = name == "Straight line" or min(ends, within) > 1
        assert (jerk != "∞") == smooth, name


def test_the_least_are_those_of_the_modified_sine(value):
    """Of the dwell-to-dwell laws with finite jerk and no straight part it needs the least power, and the least heat."""
    k = row_of(value, "Modified sine")
    assert value("least_loss") == value("costs", "loss")[k]
    assert value("least_va") == value("costs", "va")[k]


def test_a_curve_may_take_a_law_by_any_name_and_the_book_has_it_once():
    data = {"template": "motion-laws", "title": "all", "comparison": {"curves": [{"law": "quintic"}, {"law": "MS"}]}}
    machine = descriptions.described(TEMPLATE, data, str)
    assert [curve.law for curve in machine.comparison.curves] == ["Polynomial 3-4-5", "Modified sine"]
    assert len(machine.laws.names) == len(CATALOGUE)


def test_every_family_is_compared_by_its_name(value):
    names = [law.code if law.code in CODES else law.name for law in CATALOGUE if law.code != "DWL"]
    assert value("costs", "law") == names


@pytest.mark.parametrize("families", [(), ("PO7",), ("DHM",)])
def test_every_cell_agrees_of_a_book_with_few_laws(families):
    """Laws of other powers and sines leave columns of the pieces out."""
    laws = {family: {"family": family} for family in families}
    few = {"template": "motion-laws", "title": "few", "sizes": SMALL, "laws": laws}
    machine = TEMPLATE.model.model_validate(few | {"comparison": {"curves": [{"law": "CUB"}]}})
    assert disagreeing(TEMPLATE, machine)[0] == []


def test_the_curves_are_those_chosen_and_a_spare_one_lies_under_the_first():
    value = computed(TEMPLATE, described(curves=[{"law": "CUB"}, {"law": "Straight line"}]))
    assert [value(f"curve{i}_name") for i in range(1, 5)] == ["CUB", "Straight line", "", ""]
    cubic = [3 * x**2 - 2 * x**3 for x in (0, 0.25, 0.5, 0.75, 1)]
    assert value("samples1", "s") == pytest.approx(cubic, abs=1e-15)
    assert value("samples2", "s") == pytest.approx([0, 0.25, 0.5, 0.75, 1], abs=1e-15)
    assert value("samples3", "s") == value("samples4", "s") == value("samples1", "s")


def test_names_elsewhere_are_each_of_one_family_but_for_the_trapezoid():
    """The modified trapezoid has two pages: with seven durations, and by the share that controllers ask for."""
    for vendor in Vendors._fields:
        named = [name for entry in CATALOGUE if entry.code != "MTP" and (name := getattr(entry.vendors, vendor))]
        assert len(named) == len(set(named)) > 1
