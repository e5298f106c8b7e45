"""The sheet Export: one axis as a table, live in cells, in every template whose axes a controller can be given."""

import numpy as np
import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_machine import axis, described
from workbook.build import committed_descriptions
from workbook.errors import InputError
from workbook.reading.descriptions import make_machine, read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

SMALL = {"cycle": 12, "law": 4, "export": 30}
AXES = {"cutting-machine": 3, "machine": 4, "motion-composer": 1, "actuator-sizing": 1, "flying-cutter": 2,
        "indexing-overlap": 2, "indexing-overlap-stations": 4}  # fmt: skip
ALL = [(name, number) for name, count in AXES.items() for number in range(1, count + 1)]


def exporting(data, which, **sizes):
    """A description whose book has the sheet, and little room for all else."""
    template = TEMPLATES[data["template"]]
    data["sizes"] |= SMALL | {"motion_pieces": None} | sizes
    return template, make_machine(template, data | {"export": {"axis": which}}, str)


def committed_as(name, which, **sizes):
    return exporting(read_machine(FOLDER / f"{name}.toml").model_dump(), which, **sizes)


def table(template, machine):
    value = computed(template, machine)
    return [np.array(value("export", column)) for column in ("at", "y", "y1", "y2")]


@pytest.mark.parametrize(("name", "number"), ALL)
@pytest.mark.sample(3)
def test_the_table_is_the_course_that_a_controller_is_given(name, number):
    template, machine = committed_as(name, number)
    meant = template.axes(machine)[number - 1]
    x, *found = table(template, machine)
    assert len(x) == 31
    inside = np.min(np.abs(x[:, None] - meant.profile.edges[None, :]), axis=1) > 1e-6  # where nothing jumps
    at = meant.profile.at(x[inside])
    for values, course in zip(found, at[:3], strict=True):
        assert values[inside] == pytest.approx(course, rel=1e-9, abs=1e-9 * max(1e-6, np.abs(course).max()))
    assert found[0][[0, -1]] == pytest.approx([meant.profile.at(x[:1]).y[0], meant.profile.at(x[-1:], left=True).y[0]])


@pytest.mark.parametrize("name", AXES)
@pytest.mark.sample(2)
def test_a_book_with_it_agrees_and_comes_back(name):
    template, machine = committed_as(name, AXES[name])
    wrong, _ = disagreeing(template, machine)
    assert wrong == []
    assert entered(template, machine) == (machine, [])


@pytest.mark.parametrize(
    "name", [file.stem for file in committed_descriptions() if "template" in file.read_text("utf-8")]
)
def test_without_the_entry_there_is_no_sheet(name):
    machine = read_machine(TEMPLATES["machine"].description.with_name(f"{name}.toml"))
    assert "export" not in TEMPLATES[machine.template].declare(machine).blocks


def test_an_axis_is_told_by_its_name_or_its_number():
    assert committed_as("machine", "mc04")[1] == committed_as("machine", 4)[1]
    assert committed_as("flying-cutter", "shaft")[1].export.axis == 2
    assert committed_as("cutting-machine", "MC02")[1].export.axis == 2


@pytest.mark.parametrize(
    ("name", "which", "said"),
    [
        ("machine", "MC09", "no axis is named 'MC09'; expected one of MC01, MC02, MC03, MC04"),
        ("machine", 5, "axis 5; expected 1 to 4, one of MC01"),
        ("machine", 0, "expected a whole number of at least 1"),
        ("motion-composer", "press", "no axis is named 'press'; expected one of α"),
        ("motion-laws", "MTP", "unknown entry"),
        ("indexing-overlap", "tool", "no axis is named 'tool'; expected one of transfer, Die"),
    ],
)
def test_an_axis_that_is_none_is_refused_in_a_line(name, which, said):
    with pytest.raises(InputError, match=said) as refused:
        committed_as(name, which)
    assert "\n" not in str(refused.value)


def test_a_shift_and_a_feed_count_as_they_do_in_the_cycle():
    data = described([axis(1, (0, 120, 300.0, "CIC"), closes="feed", shift=-60.0)], phases=2).model_dump()
    template, machine = exporting(data, 1, export=12)
    x, y, v, _ = table(template, machine)
    assert x == pytest.approx(np.linspace(0.0, 360.0, 13))
    assert (y[0], y[6], y[-1]) == pytest.approx((150.0, 300.0, 450.0))
    assert v[0] == pytest.approx(2.0 * 300.0 / 120.0)


@pytest.mark.parametrize("unit", ["mm", "°"])
def test_one_interval_and_an_axis_at_rest(unit):
    data = described([axis(1, (0, 360, 0.0, "DWL"), unit=unit)], phases=2).model_dump()
    template, machine = exporting(data, 1, export=1)
    assert disagreeing(template, machine)[0] == []
    assert table(template, machine)[1].tolist() == [0.0, 0.0]
