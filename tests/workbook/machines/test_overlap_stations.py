"""Several tools over one transfer: each as if it were alone, together, entries, books; and how smooth all must be."""

import random

import openpyxl
import pytest

from tests.mutation.machines import machine as drawn_machine
from tests.workbook.cells import computed, disagreeing, entered
from workbook.book.limits import EXPECTED
from workbook.build import build
from workbook.errors import InputError
from workbook.machines.overlap.entries import MOST_TOOLS
from workbook.reading.descriptions import counted_from_1, make_machine, read_machine, write_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

TEMPLATE = TEMPLATES["indexing-overlap"]
STATIONS = FOLDER / "indexing-overlap-stations.toml"
SMALL = {"cycle": 24, "law": 8, "margins": 5}
OWN_PLACE = {"lane_a", "lane_b", "x"}  # columns that say where a tool is drawn among the others
WORKED_OUT_ONCE = {"lane_t"}  # of the transfer, in the table of the first tool


def entries(**second):
    """The committed description with small tables, and other entries of the second tool."""
    data = read_machine(STATIONS).model_dump()
    data["sizes"] |= SMALL
    data["overlap"]["tools"][1] |= second
    return data


def described(data):
    return TEMPLATE.model.model_validate(data)


def alone(data, i):
    """The machine that has the ``i``-th tool only."""
    return described(data | {"overlap": data["overlap"] | {"tools": [data["overlap"]["tools"][i]]}})


def with_tools(number, seed):
    """A machine of so many tools, drawn at random."""
    data = entries()
    data["overlap"]["tools"] = [data["overlap"]["tools"][0] | {"name": f"Tool {i}"} for i in range(number)]
    return drawn_machine(described(data), random.Random(seed))


def same(there, here):
    """Whether two cells, or two columns, are the same: texts as they are, numbers to rounding."""
    if isinstance(here, list):
        return len(there) == len(here) and all(map(same, there, here))
    return there == (here if isinstance(here, str) else pytest.approx(here, rel=1e-12, abs=1e-12))


@pytest.fixture(scope="module")
def three():
    return computed(TEMPLATE, described(entries()))


@pytest.mark.parametrize("i", range(3))
def test_each_tool_computes_what_it_computes_alone(three, i):
    machine = alone(entries(), i)
    value, book = computed(TEMPLATE, machine), TEMPLATE.declare(machine)
    blocks = [block for name, block in book.blocks.items() if name.startswith("tool1_")]
    compared = [
        (block.name, q.name if block.is_table else None)
        for block in blocks
        for q in block.quantities
        if q.formula and q.name not in OWN_PLACE | WORKED_OUT_ONCE and not q.name.endswith(EXPECTED)
    ]
    for name, column in compared:
        here, there = value(name, column), three(name.replace("tool1_", f"tool{i + 1}_"), column)
        assert same(there, here), (name, column)
    assert len(compared) > 200


def test_the_first_sheets_show_the_worst_of_all_tools(three):
    peaks = [three(f"tool{i}_a0") for i in (1, 2, 3)], [three(f"tool{i}_a1") for i in (1, 2, 3)]
    assert three("about_a0") == three("overlap_a0") == max(peaks[0]) == pytest.approx(4.154172, abs=5e-7)
    assert three("about_a1") == three("overlap_a1") == max(peaks[1])
    assert three("about_least") == three("overlap_least") == min(three(f"tool{i}_least") for i in (1, 2, 3))
    assert three("tools", "name") == ["Die", "Riveting head", "Ejector"]
    assert three("tools", "ok") == ["OK", "OK", "OK"]
    assert three("overall") == "OK"


def test_each_motion_has_a_lane_of_its_own_in_the_diagrams(three):
    for i in (1, 2, 3):
        for lane in ("lane_a", "lane_b"):
            heights = three(f"tool{i}_motions", lane)
            assert i <= min(heights)
            assert max(heights) == pytest.approx(i + 0.8, abs=1e-9)
    assert max(three("tool1_motions", "lane_t")) <= 0.8


def test_the_stations_stand_apart_in_the_picture(three):
    ends = [(min(x), max(x)) for x in (three(f"tool{i}_punch", "x") for i in (1, 2, 3))]
    assert ends[0][1] < ends[1][0] < ends[1][1] < ends[2][0]
    assert min(three("outline", "x")) >= min(three("frame", "x"))
    assert max(three("outline", "x")) <= max(three("frame", "x"))


def test_the_legends_follow_the_names_entered(tmp_path):
    path = tmp_path / "book.xlsx"
    build(described(entries()), path)
    book = openpyxl.load_workbook(path)
    names = {book.defined_names[f"tool{i}_name"].attr_text for i in (1, 2, 3)}
    for chart in book["Overlap"]._charts:
        assert {s.tx.strRef.f for s in chart.series if s.tx.strRef} >= names
    colours = [{s.tx.strRef.f: s.graphicalProperties.line.solidFill.srgbClr for s in chart.series if s.tx.strRef}
               for chart in book["Overlap"]._charts]  # fmt: skip
    assert len(colours) == 4
    assert all(found[name] == colours[0][name] for found in colours for name in names)


def test_a_collision_of_the_second_tool_fails_its_own_checks_and_the_book():
    value = computed(TEMPLATE, described(entries(angle_in=250.0, angle_out=60.0)))
    assert value("tool2_ok_collide") == value("tool2_ok_margin") == "FAIL"
    assert value("tools", "ok") == ["OK", "FAIL", "OK"]
    assert value("overall") == "FAIL"
    assert value("about_least") == value("tool2_least") < 0
    assert sum(verdict == "FAIL" for verdict in value("checks", "verdict")) == 2


@pytest.mark.parametrize(
    ("path", "changed", "line"),
    [
        ((), {"law_out": "DWL"}, r"overlap.tools\[3\].law_out .*: a dwell does not move; expected one of ACS, TVP"),
        ((), {"name": "Die"}, r"overlap.tools\[3\].name .*: a second tool is named 'Die'; expected a name of its own"),
    ],
)
def test_a_bad_entry_of_the_third_tool_is_named_with_its_path(path, changed, line):
    data = entries()
    tool = data["overlap"]["tools"][2]
    (tool["passage"] if path else tool).update(changed)
    with pytest.raises(InputError, match=line):
        make_machine(TEMPLATE, data, counted_from_1)


@pytest.mark.parametrize("number", [0, MOST_TOOLS + 1])
def test_one_to_six_tools(number):
    data = entries()
    data["overlap"]["tools"] = data["overlap"]["tools"][:1] * number
    with pytest.raises(InputError, match=r"overlap.tools: found .*; expected a list of 1 to 6 entries"):
        make_machine(TEMPLATE, data, counted_from_1)


@pytest.mark.parametrize("number", range(1, MOST_TOOLS + 1))
@pytest.mark.sample(2)
def test_a_book_of_any_number_of_tools_comes_back_and_agrees(number, tmp_path):
    machine, text = with_tools(number, number), tmp_path / "machine.toml"
    assert disagreeing(TEMPLATE, machine)[0] == []
    assert entered(TEMPLATE, machine) == (machine, [])
    text.write_text(write_machine(machine), encoding="utf-8")
    assert read_machine(text) == machine


def asking(transfer, tool):
    data = read_machine(TEMPLATE.description).model_dump()
    data["sizes"] |= SMALL
    data["overlap"]["transfer"] |= transfer
    data["overlap"]["tools"][0] |= tool
    return make_machine(TEMPLATE, data, counted_from_1)


MILL, DIE = "Indexing mill dwell to movement at 0°: ", "Die way in to {} at 0° after its arrival: "
SAID = {
    "smooth": ({}, {}, "", ""),
    "a way that begins with a jump": ({}, {"law_in": "ACS", "dwell": 0.0}, "", f"{DIE.format('way out')}acceleration"),
    "less is asked": ({"law": "ACS", "smoothness": "velocity"}, {"law_in": "CUB", "smoothness": "velocity"}, "", ""),
    "more is asked": ({"smoothness": "jerk"}, {"smoothness": "jerk"}, f"{MILL}jerk", f"{DIE.format('dwell')}jerk"),
    "within a law": ({"law": "TVP"}, {}, f"{MILL}acceleration jumps by", ""),
}


@pytest.mark.parametrize("what", SAID)
@pytest.mark.sample(3)
def test_the_joint_that_is_less_smooth_than_asked_is_named(what):
    transfer, tool, mill, die = SAID[what]
    one = asking(transfer, tool)
    value = computed(TEMPLATE, one)
    for name, says in (("overlap_ok_smooth", mill), ("tool1_ok_smooth", die)):
        assert value(name) == ("FAIL" if says else "OK")
        assert not says or value(f"{name}_says").startswith(says)
    assert disagreeing(TEMPLATE, one)[0] == []
