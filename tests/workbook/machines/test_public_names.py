"""The public names of a machine: each is valid, has the figure that its sheet shows, and follows its axis."""

import re

import openpyxl
import pytest
from openpyxl.utils import FORMULAE

from tests.workbook import office
from tests.workbook.edit import enter
from tests.workbook.machines.test_machine import TEMPLATE, axis, described, driven
from workbook.build import build, read_inputs
from workbook.judging.verify import verify
from workbook.machines.machine.template import NAMES
from workbook.reading.files import find_places

PHASES = (0, 90, 2.0, "CIC"), (180, 200, -2.0, "CIC")
GAP = {"name": "gap 1", "first": "MC 01", "second": "1st °", "offset": 40.0}
ADDRESS = re.compile(r"[A-Za-z]{1,3}\d+|[Rr]\d*([Cc]\d*)?|[Cc]\d*")
VALID = re.compile(r"[^\W\d]\w{0,254}")


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    """A machine of an axis with a drive, and one without, of awkward names."""
    made = tmp_path_factory.mktemp("names") / "book.xlsx"
    axes = [driven(*PHASES) | {"name": "MC 01"}, axis(2, *PHASES) | {"name": "1st °"}]
    machine = described(axes).model_dump() | {"clearances": [GAP]}
    build(TEMPLATE.model.model_validate(machine), made)
    return made


def public(names):
    """The public names of a book of axes of these names."""
    return TEMPLATE.declare(described([axis(n, *PHASES) | {"name": name} for n, name in enumerate(names, 1)])).public


AWKWARD = [
    "A1",
    "R1C1",
    "R",
    "°",
    "MC 01",
    "MC_01",
    "mc-01",
    "checks",
    "drive1",
    "ACS",
    "Zuführung",
    "x²",
    "送り",
    "a.b",
]


def test_every_name_of_awkward_axes_is_valid_and_no_other_cells():
    book = TEMPLATE.declare(described([axis(n, *PHASES) | {"name": name} for n, name in enumerate(AWKWARD, 1)]))
    names = [name for name, _ in book.names()]
    assert len({name.casefold() for name in names}) == len(names)
    wrong = [n for n in book.public if not VALID.fullmatch(n) or ADDRESS.fullmatch(n) or n.upper() in FORMULAE]
    assert wrong == []


@pytest.mark.parametrize(
    ("name", "begin"),
    [("MC 01", "MC_01"), ("°", "axis1"), ("2nd axis", "_2nd_axis"), ("a  -- b", "a_b"), ("x²", "x2"), ("ACS", "ACS_2")],
)
def test_a_name_begins_with_that_of_its_axis(name, begin):
    assert f"{begin}_v_max" in public([name])


def test_axes_of_names_that_are_cleaned_to_the_same_are_numbered():
    assert {"mc_01_h", "MC_01_2_h", "MC_01_3_h"} <= set(public(["mc-01", "MC 01", "MC°01"]))


def test_a_name_follows_its_axis_and_not_its_number():
    both = [driven(*PHASES) | {"name": "MC01"}, axis(2, *PHASES) | {"name": "MC02"}]
    books = [TEMPLATE.declare(described(axes)) for axes in (both, both[::-1])]
    values = [{name: book.blocks[cell].quantities[0].value for name, cell in book.public.items()} for book in books]
    assert values[0] == pytest.approx(values[1])
    assert values[0]["MC01_T_max"] > 0


def test_public_names_alone_are_in_sight_each_with_meaning_and_unit(path):
    names = openpyxl.load_workbook(path).defined_names
    seen = {name: name_of.comment for name, name_of in names.items() if not name_of.hidden}
    assert set(seen) == set(TEMPLATE.declare(read_inputs(path)[0]).public)
    assert seen["MC_01_T_max"] == "the highest torque of the motor [Nm]"
    assert seen["_1st_v_max"] == "the greatest velocity [m/s]"
    assert {"gap_gap_1", "n_cycles", "t_cycle", "N_max", "P_peak"} <= set(seen)
    assert sum(name.startswith("MC_01_") for name in seen) == len(NAMES["Axis"])
    assert len(names) > 10 * len(seen)


def test_own_formulas_by_public_names_have_the_same_values_in_libreoffice(path, tmp_path):
    book = openpyxl.load_workbook(path)
    places = {name: place for name, place in find_places(book).items() if not book.defined_names[name].hidden}
    shown = openpyxl.load_workbook(path, data_only=True)
    mine = book.create_sheet("Mine")
    for row, name in enumerate(places, 1):
        mine.cell(row, 1).value = f"={name}"
    book.save(tmp_path / "own.xlsx")
    saved = office.edit(tmp_path / "own.xlsx", tmp_path / "saved.xlsx", [])
    computed = openpyxl.load_workbook(saved, data_only=True)["Mine"]
    for row, (name, place) in enumerate(places.items(), 1):
        expected = shown[place.sheet].cell(place.row, place.column).value
        value = computed.cell(row, 1).value
        assert value == (expected if isinstance(expected, str) else pytest.approx(expected, rel=1e-9)), name


def test_a_public_name_that_leads_elsewhere_is_a_finding(path, tmp_path):
    book = openpyxl.load_workbook(path)
    book.defined_names["MC_01_T_max"].attr_text = book.defined_names["MC_01_T_min"].attr_text
    del book.defined_names["n_cycles"]
    book.save(tmp_path / "moved.xlsx")
    told = [finding.computed for finding in verify(tmp_path / "moved.xlsx").findings]
    assert [text.partition(":")[0] for text in told] == ["n_cycles", "MC_01_T_max"]


def test_the_names_keep_what_an_axis_was_called_until_the_book_is_built_anew(path, tmp_path):
    renamed = enter(path, tmp_path / "renamed.xlsx", {"axis_name": "Punch", "clearances": "other"})
    assert verify(renamed).findings == []
    assert {"Punch_T_max", "gap_other"} <= set(TEMPLATE.declare(read_inputs(renamed)[0]).public)
