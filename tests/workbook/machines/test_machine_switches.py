"""Switches of a machine: lanes of the timing diagram that are on or off, past the end of the turn too."""

from itertools import pairwise

import pytest

from tests.workbook.cells import computed
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from workbook.build import build, read_inputs
from workbook.entries.design import as_entered
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.reading.descriptions import make_machine, read_machine, write_machine

ONE = [axis(1, (30, 90, 20.0, "CIC"), (150, 240, -20.0, "MTP"))]


def switched(*switches, **sizes):
    """A machine with one axis and switches (name, times)."""
    data = described(ONE, phases=2, **sizes).model_dump()
    return make_machine(TEMPLATE, data | {"switches": [{"name": name, "on": on} for name, on in switches]}, str)


VALVES = (("Valve 3", [[20.0, 95.0], [200.0, 215.0]]), ("Sensor", [[345.0, 15.0]]), ("Never", []), ("On", [[0, 360]]))


def test_they_are_on_as_long_as_they_say():
    value = computed(TEMPLATE, switched(*VALVES))
    assert value("switches", "on") == pytest.approx([90.0, 30.0, 0.0, 360.0])
    assert value("switches", "time") == pytest.approx([75.0, 25.0, 0.0, 300.0])  # a turn takes 0.3 s


def test_a_signal_comes_earlier_by_the_angle_of_its_dead_time():
    data = described(ONE, phases=2).model_dump() | {"switches": [{"name": "V", "on": [[20, 95]], "dead_time": 12.5}]}
    machine = make_machine(TEMPLATE, data, str)
    assert computed(TEMPLATE, machine)("switches", "early") == pytest.approx([15.0])  # 12.5 of 300 ms a turn
    with pytest.raises(InputError, match="dead_time"):
        make_machine(TEMPLATE, data | {"switches": [{"name": "V", "dead_time": "soon"}]}, str)


def lane(value, i):
    """The bars of a switch, between gaps: from, to."""
    x, y = value("switch_lanes", f"x{i}"), value("switch_lanes", f"y{i}")
    bars = [ends for ends, up in zip(pairwise(x), pairwise(y), strict=True) if None not in up]
    return sorted((round(a, 9), round(b, 9)) for a, b in bars if b > a)


def test_a_bar_stands_where_a_switch_is_on_and_one_past_the_end_is_two():
    value = computed(TEMPLATE, switched(*VALVES))
    assert lane(value, 1) == [(20.0, 95.0), (200.0, 215.0)]
    assert lane(value, 2) == [(0.0, 15.0), (345.0, 360.0)]
    assert lane(value, 3) == []
    assert lane(value, 4) == [(0.0, 360.0)]
    heights = [{*value("switch_lanes", f"y{i}")} - {None} for i in (1, 2, 3, 4)]
    assert heights == [{3.4}, {2.4}, {1.4}, {0.4}]
    assert 4.0 < min(value("cycle1", "lane")) < max(value("cycle1", "lane")) < 5.0


def test_without_switches_there_is_no_sheet():
    book = TEMPLATE.declare(switched())
    assert "Switches" not in [sheet.title for sheet in book.sheets]
    assert "switches" not in book.blocks


def test_times_are_told_as_from_and_to_or_by_their_keys():
    machine = switched(("V", [[20.0, 95.0]]))
    assert machine.switches == switched(("V", [{"start": 20.0, "stop": 95.0}])).switches


FAULTS = [
    ([[20.0, 95.0], [350.0, 30.5]], "Valve time 2 is on 10.5° beyond the begin of another"),
    ([[20.0, 95.0], {"stop": 120.0}], "row 1, a time on without its begin, or without its end"),
    ([[20.0, 95.0], [90.0, 100.0]], "Valve time 1 is on 5° beyond the begin of another"),
    ([[20.0, 95.0], [20.0, 40.0]], "Valve time 1 is on 75° beyond the begin of another"),
    ([[0.0, 360.0], [20.0, 40.0]], "Valve time 1 is on 340° beyond the begin of another"),
    ([[50.0, 60.0], [40.0, 40.0]], "Valve time 2 does not last"),
    ([[360.0, 0.0]], "Valve time 1 does not last"),
    ([[20.0, 400.0]], "row 1, to (1): 400; expected a number from 0 to 360"),
    ([[-1.0, 40.0]], "row 1, on from (1): -1; expected a number from 0 to 360"),
    ([{"start": 20.0}], "row 1, a time on without its begin, or without its end"),
]


@pytest.mark.parametrize(("on", "said"), FAULTS)
@pytest.mark.sample(1)
def test_times_that_do_not_do_fail_by_row_and_amount(on, said, tmp_path):
    machine = switched(("Valve", on), ("Sensor", [[345.0, 15.0]]))
    assert machine.design.faults
    build(machine, tmp_path / "book.xlsx")
    report = verify(tmp_path / "book.xlsx")
    assert report.findings == []
    assert [line for line in (check.line for check in report.failing) if said in line] != []
    back, _ = read_inputs(tmp_path / "book.xlsx")
    assert as_entered(back) == as_entered(machine)
    (tmp_path / "again.toml").write_text(write_machine(back), encoding="utf-8")
    assert as_entered(read_machine(tmp_path / "again.toml")) == as_entered(machine)


@pytest.mark.parametrize(
    ("switches", "said"),
    [
        ([("V", [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0], [9.0, 10.0], [11.0, 12.0], [13.0, 14.0]])], "6"),
        ([("V", []), ("v", [])], "a second switch is named 'v'"),
        ([("V", [[1.0]])], "on"),
        ([("V", [[1.0, 2.0, 3.0]])], "on"),
        ([("V", "always")], "on"),
        ([(f"V{k}", []) for k in range(25)], "24"),
        ([("", [])], "name"),
    ],
)
def test_what_is_no_switch_is_refused_in_a_line(switches, said):
    with pytest.raises(InputError, match=said) as refused:
        switched(*switches)
    assert "\n" not in str(refused.value)
