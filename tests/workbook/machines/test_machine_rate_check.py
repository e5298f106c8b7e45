"""A machine's rate against the range of all its drives, on every surface; and the rate to compare at."""

import pytest

from tests.workbook.cells import computed, disagreeing, entered
from tests.workbook.machines.test_exact_decides import studied
from tests.workbook.machines.test_machine import RISE, TEMPLATE, driven, small
from tests.workbook.machines.test_machine_rates import FREE, machine
from workbook.build import build
from workbook.judging.verify import verify
from workbook.machines.machine.axes import tables_of
from workbook.machines.machine.drive.view import AT_NO_RATE, NONE_BINDS, Rates
from workbook.machines.machine.exact import drives_of, limit_of_rate
from workbook.machines.machine.first_sheet import RATE_CHECK, hold_at, rate_check
from workbook.reading.descriptions import write_machine
from workbook.serve.shown import design

WITHIN = "The drives hold the rate"


def sized_at(own, rate, reducer=None, **motor):
    """A machine at a rate whose drive is sized at another."""
    load = {"mass": 20.0, "friction": 0.1}
    made = small([driven(*RISE, load=load, motor=FREE | motor, reducer=reducer or {}) | {"rate": own}])
    return made.model_copy(update={"master": made.master.model_copy(update={"rate": rate})})


def verdicts_on(made, folder):
    """Return the verdicts of build, verify, browser and study on the machine's rate; what build and verify say."""
    lines = [one for one in build(made, folder / "book.xlsx", overwrite=True) if one.startswith(WITHIN)]
    (check,) = (one for one in verify(folder / "book.xlsx").checks if one.what == WITHIN)
    path = folder / "machine.toml"
    path.write_text(text := write_machine(made), encoding="utf-8")
    design.cache_clear()
    (live,) = (one for one in design("machine.toml", text).checks().values() if one.label == WITHIN)
    table = studied(path, vary=[{"key": "master.rate", "values": [made.master.rate]}])
    excluded = table.fails[RATE_CHECK][0]
    verdicts = ["FAIL" if failing else "OK" for failing in (lines, excluded)]
    return {*verdicts, check.found, live.value}, lines, check.says


def test_a_machine_above_the_range_of_a_drive_sized_at_a_lower_rate_fails_on_every_surface(tmp_path):
    """Its own checks hold at the rate that it is sized at: only the machine's tells."""
    made = sized_at(100.0, 200.0, max_speed=4000.0)
    assert computed(TEMPLATE, made)("drive1_ok_speed") == "OK"
    verdicts, lines, says = verdicts_on(made, tmp_path)
    assert verdicts == {"FAIL"}
    assert says == "runs at 200; the drives hold from 0 to 166.6 cycles/min (A1: motor speed)"
    assert lines == [f"{WITHIN}: {says}"]


def test_the_limits_at_both_ends_of_a_range_are_named():
    """Of A1 that holds from a rate on, and A2 up to one below it: neither alone keeps the machine from running."""
    for low, high, holds in ((70.0, 100.9, "from 70 to 100.9 cycles/min"), (AT_NO_RATE, AT_NO_RATE, "at no rate")):
        says = rate_check(Rates(low, high, "A1: peak torque", "A2: motor speed"), 60.0).sentence
        assert says == f"runs at 60; the drives hold {holds} (A1: peak torque, A2: motor speed)"


def test_a_machine_within_the_range_of_all_drives_holds_on_every_surface(tmp_path):
    assert verdicts_on(sized_at(100.0, 160.0, max_speed=4000.0), tmp_path) == ({"OK"}, [], "")


def test_a_rate_that_the_exact_engine_alone_finds_too_high_fails_everywhere(tmp_path, monkeypatch):
    """The sheet's range is right; the exact engine's figure is made another, to stand for a sheet that errs."""
    from workbook.machines.machine import exact

    made = sized_at(100.0, 160.0, max_speed=4000.0)
    tables_of.cache_clear()
    at_speed = exact.at_speed
    monkeypatch.setattr(exact, "at_speed", lambda checks, speed: at_speed(checks, 1.1 * speed))
    verdicts, _, says = verdicts_on(made, tmp_path)
    assert verdicts == {"FAIL"}
    assert says.startswith("at 160 cycles/min the most used limit, motor speed, is 105.6 % exactly, 96 % on its sheet")


@pytest.mark.parametrize("rate", [30.0, 90.0, 240.0])
def test_at_the_machines_rate_points_and_exact_engine_use_the_same_of_a_limit(rate):
    """Of the reducer's too, whose torque counts four times beyond 150 cycles a minute."""
    limits = {"rated_torque": 10.0, "peak_torque": 40.0, "max_speed": 9000.0}
    reducer = {"ratio": 1.0, "peak_torque": 2.0, "full_cycles": 9000.0, "cycle_factor": 4.0}
    (view,), (there,) = (drives_of(sized_at(own, rate, reducer, **limits)) for own in (100.0, None))
    limit = limit_of_rate(view, [], rate)
    assert limit.exact.value == pytest.approx(100.0 * there.driven.limit_checks.worst.use, rel=1e-12)
    assert limit.sheet.value == pytest.approx(limit.exact.value, rel=2e-3)


@pytest.mark.parametrize("own", [None, 120.0])
def test_a_tie_of_rate_and_end_holds_in_cells_and_engine(own):
    """The highest rate of a sheet entered as the machine's, to 15 digits; above it both FAIL."""
    made = machine(120.0, {"max_speed": 9000.0}, {})
    highest = computed(TEMPLATE, made)("about_highest")
    for rate, verdict in ((float(f"{highest:.15g}"), "OK"), (1.001 * highest, "FAIL")):
        axis = made.axes[0].model_copy(update={"rate": own})
        there = machine(rate, {"max_speed": 9000.0}, {}).model_copy(update={"axes": [axis]})
        wrong, _ = disagreeing(TEMPLATE, there)
        assert [cell for cell in wrong if cell.startswith("about_")] == []
        assert computed(TEMPLATE, there)(RATE_CHECK) == verdict


@pytest.mark.parametrize(
    ("low", "high", "holds"),
    [(0.0, NONE_BINDS, True), (70.0, 100.0, True), (79.5, 100.0, False), (70.0, 79.0, False),
     (79.4, 79.4 * (1 - 1e-12), True), (80.0, NONE_BINDS, False), (AT_NO_RATE, AT_NO_RATE, False)],
)  # fmt: skip
def test_a_rate_is_held_between_both_ends(low, high, holds):
    assert hold_at(79.4, Rates(low, high, "", "")) == holds


def compared(rate, compare_rate):
    """Two axes at a rate, with one to compare at."""
    made = small([driven(*RISE), driven(*RISE, lead=20.0) | {"name": "A2", "shift": 30.0}])
    return made.model_copy(
        update={"master": made.master.model_copy(update={"rate": rate, "compare_rate": compare_rate})}
    )


def test_velocity_and_acceleration_are_shown_at_the_rate_to_compare_too():
    """As those of the machine that runs there; entered, written and read again, the rate comes back."""
    made, there = compared(100.0, 250.0), computed(TEMPLATE, compared(250.0, None))
    value = computed(TEMPLATE, made)
    for shown, own in (("vc", "v"), ("ac", "a")):
        assert value("axes", shown) == pytest.approx(there("axes", own), rel=1e-12)
    assert value("omega_compared") == pytest.approx(there("omega"), rel=1e-12)
    assert entered(TEMPLATE, made) == (made, [])
    assert disagreeing(TEMPLATE, made)[0] == []
