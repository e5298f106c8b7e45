"""Dimensions: units as people write them, what cannot be added, and our own books."""

import random

import openpyxl
import pytest

from tests.tiers import by_day
from tests.workbook.cells import in_memory
from tests.workbook.machines.test_machine_drives import linked, small, some_mechanism
from workbook.book.address import Address
from workbook.dimensions.rules import UnitWalk
from workbook.dimensions.units import NONE, dimension_of
from workbook.machines.machine.mechanism import LINKED
from workbook.reading.contents import Contents
from workbook.reading.descriptions import read_machine
from workbook.templates import TEMPLATES
from workbook.witnesses.pycel.model import PycelModel


@pytest.mark.parametrize(
    ("unit", "same"),
    [
        ("Nm", "kg m²/s²"), ("kg cm²", "m^2*kg"), ("W/m²K⁴", "W/(m² K⁴)"), ("W/m2K4", "kg/s³K⁴"), ("rpm", "1/s"),
        ("1/min", "Hz"), ("N-cm", "J"), ("kW/N²m²", "1/Nms"), ("m³/h", "l/min"), ("mH", "V s/A"), ("°C", "K"),
        ("rad/s²", "°/min²"), ("kWh", "Ws"), ("Volts", "W/A"), ("m·s⁻²", "mm/s²"), ("[N/mm²]", "MPa"),
    ],
)  # fmt: skip
def test_units_are_read_as_people_write_them(unit, same):
    same = same.replace("(", "").replace(")", "")
    assert dimension_of(unit) == dimension_of(same) is not None


@pytest.mark.parametrize("unit", ["", "SI", "Teeth", "m, rad", "kg or price", "yes/no", "+", "F - 1"])
def test_what_is_no_unit_is_not_known(unit):
    assert dimension_of(unit) is None


@pytest.mark.parametrize("unit", ["%", "°", "rad", "1", "mm/m"])
def test_shares_and_angles_are_numbers(unit):
    assert dimension_of(unit) == NONE


def found(formula, **units):
    """What cannot be in one formula of cells a, b, c with units, and what its dimension is: ``x`` has its own unit."""
    book = openpyxl.Workbook()
    sheet = book.active
    for k, name in enumerate("abc", 1):
        sheet.cell(1, k, 2.0)
        formula = formula.replace(name, f"{'ABC'[k - 1]}1")
    sheet["D1"] = formula
    sheet["E1"] = "=D1"
    cells = {Address("Sheet", 1, "abcx".index(name) + 1): unit for name, unit in units.items()}
    contents = Contents(book)
    came = UnitWalk(contents, cells).walk(PycelModel(contents).order)
    return came.wrong.get(Address("Sheet", 1, 4), ""), came.known


@pytest.mark.parametrize(
    ("formula", "units", "says"),
    [
        ("=a+b", {"a": "m", "b": "s"}, "a sum of m and s"),
        ("=SIN(a)", {"a": "mm"}, "SIN of m"),
        ("=EXP(a/b)", {"a": "m", "b": "s"}, "EXP of m/s"),
        ("=a*b", {"a": "N", "b": "m", "x": "kW"}, "kg·m^2/s^2 where the unit says kg·m^2/s^3"),
        ("=IF(a>b,1,2)", {"a": "kg", "b": "m"}, "a comparison of kg and m"),
        ("=SUM(a:b)", {"a": "kg", "b": "m"}, "SUM of kg and m"),
        ("=MAX(a,b)-c", {"a": "m", "b": "m", "c": "m²"}, "a sum of m and m^2"),
        ("=a^b", {"a": "m", "b": "m"}, "an exponent of m"),
        ("=IF(c>0,a,b)", {"a": "N", "b": "Nm"}, "the branches of IF of kg·m/s^2 and kg·m^2/s^2"),
        ("=SQRT(a)+b", {"a": "m²/s²", "b": "m/s²"}, "a sum of m/s and m/s^2"),
        ("=ATAN2(a,b)", {"a": "m", "b": "N"}, "ATAN2 of m and kg·m/s^2"),
    ],
)
def test_what_cannot_be_is_named(formula, units, says):
    assert found(formula, **units)[0] == says


@pytest.mark.parametrize(
    ("formula", "units"),
    [
        ("=a*1000+b", {"a": "m", "b": "mm"}),
        ("=2*PI()*a/60*b", {"a": "rpm", "b": "Nm", "x": "W"}),
        ("=SQRT(a*b)^2", {"a": "m", "b": "s", "x": "m s"}),
        ("=SIN(RADIANS(a))*b", {"a": "°", "b": "m", "x": "mm"}),
        ("=IF(a=0,\"–\",b/a)", {"a": "s", "b": "m", "x": "m/s"}),
        ("=ROUND(MAX(a,0)/b^(1/2),2)", {"a": "m", "b": "m²", "x": "%"}),
        ("=a+273.15", {"a": "°C", "x": "K"}),
        ("=SUMPRODUCT(A1:A1,B1:B1)*c%", {"a": "m", "b": "N", "c": "", "x": "J"}),
        ("=PRODUCT(a:b)+c", {"a": "m", "b": "m", "c": "m²", "x": "m²"}),
        ("=(a>b)*c-(-c)", {"a": "m", "b": "m", "c": "W", "x": "kW"}),
    ],
)  # fmt: skip
def test_what_can_be_is_not(formula, units):
    assert found(formula, **units)[0] == ""


def test_a_number_that_may_have_a_unit_leaves_the_product_unknown():
    assert found("=a*9.81", a="kg", x="N") == ("", 1)
    assert found("=a*9.81", a="kg") == ("", 0)
    assert found("=a*1000", a="kg") == ("", 2)


class Labelled:
    """The book of a machine, the committed one of a template, and the units of its cells by their labels."""

    def __init__(self, template, machine=None):
        book = template.declare(machine or read_machine(template.description))
        self.units, self.given = {}, []
        for cell in book.cells():
            formula = isinstance(cell.content, str) and cell.content.startswith("=")
            place = Address(cell.block.sheet.title, cell.row, cell.column)
            self.units[place] = cell.quantity.unit or ("" if formula else "1")
            if cell.quantity.role == "input" and cell.quantity.unit and isinstance(cell.content, float):
                self.given.append(place)
        self.contents = Contents(in_memory(book))
        self.order = PycelModel(self.contents).order

    def came(self, units=None):
        """What came of the units, some of them others."""
        return UnitWalk(self.contents, self.units | (units or {})).walk(self.order)


@pytest.mark.parametrize("name", by_day(TEMPLATES, "motion-laws"))
def test_the_cells_of_a_template_have_the_units_of_their_labels(name):
    came = Labelled(TEMPLATES[name]).came()
    assert came.wrong == {}
    assert came.known > 0.5 * came.formulas


@pytest.mark.parametrize("kind", [kind for kind in LINKED if kind != "table"])
def test_the_cells_of_a_mechanism_have_the_units_of_their_labels(kind):
    """But of a table: there the number check_zero is added to a position."""
    assert Labelled(TEMPLATES["machine"], small(linked(mechanism=some_mechanism(kind).model_dump()))).came().wrong == {}


def not_named(template, count):
    """The entries, of some that are drawn, of which another unit is not named; and how many were drawn."""
    book = Labelled(template)
    drawn = random.Random(37).sample(book.given, min(count, len(book.given)))
    return [place for place in drawn if not book.came({place: "cd"}).wrong], len(drawn)


@pytest.mark.parametrize("name", by_day(TEMPLATES, "motion-laws"))
def test_another_unit_of_an_entry_is_named(name):
    missed, drawn = not_named(TEMPLATES[name], 6)
    assert len(missed) <= 0.4 * drawn, missed
