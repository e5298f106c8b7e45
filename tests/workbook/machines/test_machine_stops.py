"""The hard stops of an axis: its travel, overshoot included, against them, in cells and by the exact engine."""

import pytest

from tests.workbook.cells import computed, disagreeing
from tests.workbook.edit import enter
from tests.workbook.machines.test_exact_decides import turning
from tests.workbook.machines.test_machine import TEMPLATE, axis, described
from workbook.build import build, read_inputs
from workbook.errors import InputError
from workbook.judging.verify import verify
from workbook.machines.machine.exact import judgement, limit_of_stop
from workbook.reading.descriptions import make_machine

THIRDS = (
    (0, 90, 10.0, "CIC"),
    (90, 180, 20.0, "CIC"),
    (180, 300, -30.0 + 4e-15, "CIC"),
)  # ends where it began, but for rounding
RISE = ((30, 90, 20.0, "CIC"), (180, 300, -20.0, "CIC"))


def stopped(*stops, phases=RISE, beside=None, **entries):
    """Return a machine of an axis with hard stops, and one with other stops beside it."""
    axes = [axis(1, *phases, stops=list(stops) if len(stops) == 2 else stops[0], **entries)]
    data = described([*axes, axis(2, *RISE)]).model_dump()
    data["axes"][1]["stops"] = beside
    return TEMPLATE.model.model_validate(data)


def overshooting(*stops):
    """Return a machine whose axis is handed over at speed and goes on beyond the end of its phase."""
    data = turning(60.0).model_dump()
    data["axes"][0]["stops"] = dict(zip(("low", "high"), stops, strict=True))
    return TEMPLATE.model.model_validate(data)


@pytest.mark.parametrize(
    ("machine", "verdicts", "says"),
    [
        (stopped(-5, 25), ("OK", "OK"), ""),
        (stopped(0, 20), ("OK", "OK"), ""),
        (stopped({"high": 19.5}), ("OK", "FAIL"), "it goes to 20 mm, 0.5 mm beyond its upper stop"),
        (stopped(1, 30), ("FAIL", "OK"), "it goes to 0 mm, 1 mm beyond its lower stop"),
        (stopped(-5, 25, position=6.0), ("OK", "FAIL"), "it goes to 26 mm, 1 mm beyond its upper stop"),
        (stopped({}), ("OK", "OK"), ""),
        (stopped(-1, 900, phases=RISE[:1], closes="feed"), ("OK", "FAIL"), "it feeds on, cycle by cycle"),
        (stopped(-900, 1, phases=RISE[1:], closes="feed"), ("FAIL", "OK"), "it feeds on, cycle by cycle"),
        (stopped(-1, 21, closes="feed"), ("OK", "OK"), ""),
        (stopped({"low": -1}, phases=RISE[:1], closes="feed"), ("OK", "OK"), ""),
        (stopped({"high": 900}, phases=RISE[:1], closes="feed"), ("OK", "FAIL"), "it feeds on, cycle by cycle"),
        (
            stopped({"high": 19}, phases=THIRDS, closes="feed"),
            ("OK", "FAIL"),
            "it goes to 30 mm, 11 mm beyond its upper stop",
        ),
        (stopped(-90, 19, unit="°"), ("OK", "FAIL"), "it goes to 20 °, 1 ° beyond its upper stop"),
    ],
)
def test_travel_is_checked_against_the_stops_that_are_entered(machine, verdicts, says):
    value = computed(TEMPLATE, machine)
    names = [f"axis1_stop_{end}_kept" for end in ("low", "high")]
    assert tuple(map(value, names)) == verdicts
    assert "".join(value(f"{name}_says") for name in names) == says
    judged = {one.check: one for one in judgement(machine).limits}
    assert [judged[name].ok for name in names] == [verdict == "OK" for verdict in verdicts]
    assert disagreeing(TEMPLATE, machine)[0] == []


def test_overshoot_counts():
    """Its phases end at 170 mm at most; handed over at speed it goes on."""
    machine = overshooting(-1.0, 170.0)
    value = computed(TEMPLATE, machine)
    assert value("axis1_stop_high_kept") == "FAIL"
    assert value("axes", "high")[0] > 170.5
    assert disagreeing(TEMPLATE, machine)[0] == []


@pytest.mark.parametrize(("exact", "verdict"), [(19.0, "OK"), (21.0, "FAIL")])
def test_the_exact_reach_decides_too(exact, verdict, tmp_path, monkeypatch):
    """The sheet goes to 20 mm, and the engine's is made another, to stand for a sheet that errs."""
    path = tmp_path / "book.xlsx"
    machine = stopped(-5, 20.5)

    def erring(stop):
        limit = limit_of_stop(stop)
        return limit._replace(exact=limit.exact._replace(value=exact if stop.end == "high" else 0.0))

    monkeypatch.setattr("workbook.machines.machine.exact.limit_of_stop", erring)
    lines = [line for line in build(machine, path) if "upper stop" in line]
    (check,) = (one for one in verify(path).checks if "upper stop" in one.what)
    assert check.found == verdict
    said = "highest position is 21 mm exactly, 20 mm on its sheet; the limit is 20.5 mm"
    assert lines == ([f"{check.what}: {check.says}".replace("Axis 1", "A1")] if verdict == "FAIL" else [])
    assert check.says == (said if verdict == "FAIL" else "")


def test_only_an_axis_that_has_stops_gets_cells_for_them():
    def cells(*stops):
        return {cell.quantity.name for cell in TEMPLATE.declare(stopped(*stops)).cells()}

    assert not {name for name in cells(None) if "_stop_" in name}
    assert {name.partition("_")[0] for name in cells(0, 20) if "_stop_" in name} == {"axis1"}


def test_they_come_back_from_a_book_and_from_one_with_emptied_cells(tmp_path):
    path, again = tmp_path / "book.xlsx", tmp_path / "again.xlsx"
    machine = stopped(-5, 25, beside={"low": -3.0})
    build(machine, path)
    assert read_inputs(path) == (machine, [])
    enter(path, again, {"axis1_stop_low": None, "axis1_stop_high": 19.0, "axis2_stop_low": None})
    back, _ = read_inputs(again)
    assert back == stopped({"high": 19.0}, beside={})
    assert "FAIL" in {one.found for one in verify(again).checks if "upper stop" in one.what}


@pytest.mark.parametrize(
    ("stops", "key"), [([1.0], "axes.0.stops"), ([1.0, "a"], "axes.0.stops.high"), ({"lo": 1.0}, "axes.0.stops.lo")]
)
def test_what_is_no_pair_of_stops_is_refused_by_its_key(stops, key):
    data = stopped(0, 1).model_dump()
    data["axes"][0]["stops"] = stops
    with pytest.raises(InputError, match=key.replace(".", r"\.")):
        make_machine(TEMPLATE, data, str)
