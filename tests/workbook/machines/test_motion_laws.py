"""The laws side by side: the reference's figures in cells, continuity in words, the curves that are chosen."""

import pytest

from engine.laws import CATALOGUE
from engine.laws.family import Vendors
from engine.laws.inverse import continuity, law_joints
from tests.workbook.cells import computed, disagreeing
from workbook.laws.registry import CODES
from workbook.reading import descriptions
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["motion-laws"]
SMALL = {"cycle": 4, "law": 4}
ORDERS = ("position", "velocity", "acceleration", "jerk")


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


@pytest.mark.parametrize(
    "law", [one() for one in CATALOGUE if one.code not in ("DWL", "OWN")], ids=lambda law: law.code
)
def test_each_figure_of_a_law_stands_in_its_column(value, law):
    """Orders and the jerk too; the loss is that of the cubic times the mean square of the acceleration."""
    k, cost = row_of(value, law.code if law.code in CODES else law.name), law.coefficients
    found = [value("costs", column)[k] for column in ("cv", "ca_max", "ca_rms", "va_max", "loss")]
    meant = [cost.cv, cost.ca_max, cost.ca_rms, cost.va_max, cost.ca_rms**2 / 12]
    assert found == pytest.approx(meant, rel=1e-12, abs=1e-13)
    smooth = [ORDERS[order] for order in continuity(law_joints(law, law.as_pieces()))]
    assert [value("costs", column)[k] for column in ("at_ends", "within")] == smooth
    assert (value("costs", "cj")[k] == "∞") == (cost.cj == float("inf"))


def test_the_least_are_those_of_the_modified_sine(value):
    """Of the dwell-to-dwell laws with finite jerk and no straight part it needs the least power, and the least heat."""
    k = row_of(value, "Modified sine")
    assert value("least_loss") == value("costs", "loss")[k]
    assert value("least_va") == value("costs", "va")[k]


def test_a_curve_may_take_a_law_by_any_name_and_the_book_has_it_once():
    data = {"template": "motion-laws", "title": "all", "comparison": {"curves": [{"law": "quintic"}, {"law": "MS"}]}}
    machine = descriptions.make_machine(TEMPLATE, data, str, by_code=True)
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
