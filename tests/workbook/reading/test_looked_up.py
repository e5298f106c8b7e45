"""Names that are looked up: every program finds them again, or the description is refused when it is read."""

import openpyxl
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests import cutting
from tests.mutation.bench import sized
from tests.workbook.composed import committed_as
from tests.workbook.evaluated import by_formulon
from workbook.build import build, read_inputs
from workbook.entries.rules import field_at
from workbook.errors import InputError
from workbook.fields.texts import checked_name, place_of, require_distinct
from workbook.fields.types import EntryError
from workbook.judging.verify import verify
from workbook.reading.contents import Contents
from workbook.reading.descriptions import counted_from_1, make_machine, read_machine
from workbook.templates import TEMPLATES
from workbook.witnesses.pycel.model import PycelModel

CUTTING, OVERLAP = cutting.DESCRIPTION, TEMPLATES["indexing-overlap"].description
TABLES = {
    "axes": (CUTTING, lambda data: data["axes"], "axes[2].name"),
    "tools": (OVERLAP, lambda data: data["overlap"]["tools"], "overlap.tools[2].name"),
    "motors": (CUTTING, lambda data: data["selection"]["motors"], "selection.motors[2].name"),
    "reducers": (CUTTING, lambda data: data["selection"]["reducers"], "selection.reducers[2].name"),
}
NO_NAMES = {
    "A~1": "~", "A?": "?", "*": "*", " A": "blank", "A ": "blank", "\u00a0A": "blank", "#N/A": "value", "#n/a": "value",
    "#REF!": "value", "#DIV/0!": "value", "#NAME?": "value", "#SPILL!": "value", "TRUE": "value", "false": "value",
    "12": "value", "1e5": "value", "-1,5": "value", "50%": "value", "1-2": "value", "3/4": "value",
    "1 1/2": "value", "8:30": "value", "8 a": "value", "2026-11-22": "value", "Mar1": "value", "5 Dec 26": "value",
    "=A": "=", "A\tB": "U+0009", "A\u0085": "U+0085",
}  # fmt: skip
ALIKE = [("MC01", "mc01"), ("I", "\u0131"), ("i", "\u0131"), ("i", "\u0130"), ("Straße", "STRASSE"), ("K", "\u212a"),
         ("Ä", "ä"), ("A", "\uff21"), ("é", "e\u0301"), ("s", "\u017f"), ("Σ", "ς"), ("A", "A")]  # fmt: skip


def renamed(table, *names):
    """Read a description whose table begins with these names."""
    description, entries, _ = TABLES[table]
    data = read_machine(description).model_dump()
    rows = entries(data)
    if len(rows) < len(names):
        rows.append(rows[0] | {"name": "further"})
    if table == "axes":
        data["selection"]["axis"] = names[0]
    for row, name in zip(rows, names, strict=False):
        row["name"] = name
    return make_machine(TEMPLATES[data["template"]], data, counted_from_1)


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize(("name", "says"), NO_NAMES.items())
@pytest.mark.sample(35)
def test_what_a_look_up_would_not_find_is_no_name(table, name, says):
    with pytest.raises(InputError) as caught:
        renamed(table, "first", name)
    (line,) = caught.value.lines
    assert line.startswith(TABLES[table][2])
    assert says in line


@pytest.mark.parametrize("table", TABLES)
@pytest.mark.parametrize(("name", "other"), ALIKE)
@pytest.mark.sample(17)
def test_names_that_some_program_takes_for_one_are_refused(table, name, other):
    with pytest.raises(InputError) as caught:
        renamed(table, name, other)
    (line,) = caught.value.lines
    assert line.startswith(TABLES[table][2])
    assert "a second" in line


@pytest.mark.parametrize(
    "name",
    ["12 kW", "No. 3", "MARK 2", "1-A", "S1.2", "A 1-2", "#3", "Schweißzange", "k\u0131sa", "A[1]", "A|B", "<A>", "a.b",
     "漢字", "'A"],
)  # fmt: skip
def test_other_names_are_names(name):
    assert checked_name(name) == name


def found_at(name, names):
    """The places at which pycel and formulon find a name, from 1."""
    workbook = openpyxl.Workbook()
    page = workbook.active
    for row, each in enumerate(names, 1):
        cell = page.cell(row, 1)
        cell.value, cell.data_type = each, "s"
    page["B1"].value, page["B1"].data_type = name, "s"
    page["C1"] = f"=MATCH(B1,A1:A{len(names)},0)"
    (ours,) = PycelModel(Contents(workbook)).evaluate().values()
    return ours, by_formulon(workbook)[page.title, 1, 3]


LETTERS = "aAiIkKsSzZ01 .-_#'\"()[]{}|^$+<>&%@!,;:/\\\u0131\u0130ß\u017f\u212aÄäÉéΣσς\u0406\u0456\uff21\uff41ﬁ漢😀"
NAMES = st.lists(st.text(LETTERS, min_size=1, max_size=3), min_size=1, max_size=4)


@given(NAMES, st.sampled_from([str, str.lower, str.upper, str.swapcase]))
def test_what_passes_is_found_again(names, change):
    try:
        for name in names:
            checked_name(name)
        require_distinct(names, "name", "{}")
    except EntryError:
        return
    for name in names:
        place = place_of(change(name), names)
        if place >= 0 and len(change(name)) == len(name):  # of a letter that becomes two, programs think differently
            assert found_at(change(name), names) == (place + 1, place + 1)
    assert [place_of(name, names) for name in names] == list(range(len(names)))


@pytest.fixture(scope="module")
def small():
    return cutting.small(cycle=12)


def test_law_codes_and_the_axis_of_selection_are_found_without_regard_to_case(small):
    data = small.model_dump()
    data["selection"]["axis"] = "mc01"
    laws = [phase for axis in data["axes"] for phase in axis["phases"]]
    for phase in laws:
        phase["law"] = phase["law"].lower()
    assert make_machine(cutting.TEMPLATE, data, counted_from_1).axes == small.axes


def test_a_sheet_takes_a_law_and_an_axis_in_any_case(small, tmp_path):
    path = tmp_path / "book.xlsx"
    build(small, path)
    workbook = openpyxl.load_workbook(path)
    cells = [cell for title in ("Timing", "Selection") for row in workbook[title].iter_rows() for cell in row]
    typed = {"Timing": ("MTP", "DWL"), "Selection": ("MC01",)}
    changed = [cell for cell in cells if cell.style == "Entry" and cell.value in typed[cell.parent.title]]
    assert len(changed) > 5
    for cell in changed:
        cell.value = cell.value.lower()
    workbook.save(path)
    report = verify(path, ["pycel", "formulon"])
    assert report.findings == []


@pytest.mark.parametrize("name", TEMPLATES)
def test_a_text_that_reads_as_a_value_stays_the_text_that_is_typed(name, tmp_path):
    """Programs keep 4711, 3-4 or 1E5 in a cell of the format of texts, and make a number or a date of it elsewhere."""
    template = TEMPLATES[name]
    machine = sized(template)
    build(machine, tmp_path / "book.xlsx")
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    texts = 0
    for block in template.declare(machine).blocks.values():
        for q in block.quantities:
            kind = field_at(template.model, q.key)[0] if q.role == "input" else None
            cells = [book[block.sheet.title].cell(block.row + k, block.columns[q.name]) for k in range(block.size)]
            typed = kind is str and not q.choices
            texts += typed
            assert {cell.number_format == "@" for cell in cells} == {typed}, (block.name, q.name)
    assert texts >= 5


@pytest.mark.parametrize(("name", "key", "value"), [
    *(("press", key, value) for key in ("title", "motors.*.name") for value in ("#N/A", "#ref!", "#DIV/0!")),
    ("motion-composer", "laws.OWN.name", "#N/A"),
])  # fmt: skip
def test_an_error_value_is_no_text(name, key, value, press, tmp_path):
    """Pasted, it would go through every formula that shows the text."""
    template, machine = (press.template, press.machine) if name == "press" else committed_as(name)
    build(machine, tmp_path / "book.xlsx")
    block, q = next((b, q) for b in template.declare(machine).blocks.values() for q in b.quantities if q.key == key)
    book = openpyxl.load_workbook(tmp_path / "book.xlsx")
    cell = book[block.sheet.title].cell(block.row, block.columns[q.name])
    cell.value = value
    book.save(tmp_path / "edited.xlsx")
    with pytest.raises(InputError) as refused:
        read_inputs(tmp_path / "edited.xlsx")
    (line,) = refused.value.lines
    assert f"{block.sheet.title}!{cell.coordinate} ({q.label})" in line
    assert "reads as an error value; expected a text" in line
