"""Entries that are emptied in a book, and rows left blank: told where they are, and never taken for a default."""

import re

import openpyxl
import pytest

from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as, description
from tests.workbook.test_unfinished import small
from workbook.book.rows import as_rows
from workbook.build import build, read_inputs
from workbook.entries import rules
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.reading.descriptions import make_machine
from workbook.templates import TEMPLATES


def machine_of(name):
    data = small(name)
    template = TEMPLATES[data["template"]]
    return make_machine(template, data, str, by_code=True)


def defaulted(name):
    """An input of each kind that a description may lack, and that is filled in the book: block, column and row."""
    machine, found = machine_of(name), {}
    model = type(machine)
    for block in TEMPLATES[machine.template].declare(machine).blocks.values():
        for q in block.quantities:
            key = re.sub(r"\.\d+(?=\.|$)", ".*", q.key)
            optional = q.role == "input" and not rules.must_be_entered(model, key)
            held = as_rows(q.value, block.size, q.name)[0]
            if optional and held is not None and rules.must_be_entered(model, key):
                found.setdefault(key, (block.name, q.name))
    return found


CASES = [pytest.param(name, *place, marks=[] if name == COMPOSED else pytest.mark.nightly)
         for name in DESCRIBED for key, place in defaulted(name).items()
         if name == COMPOSED or not key.startswith("laws.")]  # fmt: skip


@pytest.mark.parametrize(("name", "block", "column"), CASES)
@pytest.mark.sample(1)
def test_an_emptied_entry_is_missing_and_not_its_default(name, block, column, tmp_path):
    machine = machine_of(name)
    build(machine, tmp_path / "book.xlsx")
    place = TEMPLATES[machine.template].declare(machine).blocks[block]
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    cell = book[place.sheet.title].cell(place.row, place.columns[column])
    assert cell.value is not None
    cell.value = None
    book.save(tmp_path / "edited.xlsx")
    try:
        report = verify(tmp_path / "edited.xlsx")
    except InputError as refused:  # a text
        (line,) = refused.lines
        assert f"{place.sheet.title}!{cell.coordinate} " in line
        assert "empty; expected a text" in line
        return
    assert report.findings == []
    assert report.unfinished
    assert any(f"{place.quantities[0].label if not place.is_table else ''}" in c.says and "empty" in c.says
               for c in report.failing)  # fmt: skip
    found, _ = read_inputs(tmp_path / "edited.xlsx")
    build(found, tmp_path / "new.xlsx")
    assert (verify(tmp_path / "new.xlsx").findings, read_inputs(tmp_path / "new.xlsx")[0]) == ([], found)


BETWEEN = [("motion-composer", "axis1"), ("motion-composer", "OWN_pieces"), ("actuator-sizing", "axis1"),
           ("actuator-sizing", "reducers"), ("machine", "axis2"),
           ("machine", "drive1_parts"), ("machine", "drive1_windows"), ("machine", "motors")]  # fmt: skip


@pytest.mark.parametrize(("name", "table"), BETWEEN)
@pytest.mark.sample(1)
def test_a_row_left_blank_above_another_is_told_in_one_line(name, table, tmp_path):
    template, machine = committed_as(name)
    short = {"cycle": 12, "law": 10}
    roomy = machine.model_copy(update={"sizes": machine.sizes.model_copy(update=short)})
    build(roomy, tmp_path / "book.xlsx")
    place = template.declare(roomy).blocks[table]
    entered = [q for q in place.quantities if q.role == "input"]
    used = [i for i in range(place.size) if any(q.value[i] is not None for q in entered)]
    free = used[-1] + 1 if used else 0
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    sheet, last = book[place.sheet.title], entered[-1]
    value = next((v for v in last.value if v is not None), 1.0)
    sheet.cell(place.row + free + 1, place.columns[last.name]).value = value
    book.save(tmp_path / "edited.xlsx")
    try:
        lines = read_inputs(tmp_path / "edited.xlsx")[1]
    except InputError as refused:
        lines = refused.lines
    (line,) = [line for line in lines if "nothing is entered" in line]
    assert place.sheet.title in line
    assert f"row {free + 1} of the table {table}" in line


LISTS = {
    "a switch without times": {"switches": [{"name": "Valve"}]},
    "a switch whose list is empty": {"switches": [{"name": "Valve", "on": []}, {"name": "Sensor", "on": [[10, 20]]}]},
    "a switch over seconds": {"switches": [{"name": "Valve"}], "master": {"cycle": 360.0, "unit": "s"}},
    "an own law without pieces": {"laws": {"OWN": {"pieces": []}}},
    "a spline without points": {"laws": {"SPL": {"points": []}}},
    "a spline of one point": {"laws": {"SPL": {"points": [{"at": 0.0, "s": 0.0}]}}},
}


@pytest.mark.parametrize("what", LISTS)
@pytest.mark.sample(1)
def test_a_list_without_rows_is_the_same_in_the_description_and_in_its_book(what, tmp_path):
    given = make_machine(TEMPLATES["machine"], description() | LISTS[what], str, by_code=True)
    build(given, tmp_path / "book.xlsx")
    assert verify(tmp_path / "book.xlsx").findings == []
    back, _ = read_inputs(tmp_path / "book.xlsx")
    for law in ("OWN", "SPL"):
        if law in LISTS[what].get("laws", {}):
            assert back.design.faults == given.design.faults
    assert [switch.on for switch in back.switches] == [switch.on for switch in given.switches]
