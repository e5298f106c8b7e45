"""Backlash of drives: cells against the exact engine, the check while the tool works, what improve lists."""

import pytest

from engine.drive.backlash import Backlash
from tests.workbook.cells import computed, disagreeing
from tests.workbook.machines.test_machine_drives import OUT, TEMPLATE, arm, linked, lossy, press, small
from workbook.build import build, read_inputs
from workbook.commands import improve as command
from workbook.errors import InputError
from workbook.machines.machine.exact import drives_of, judgement
from workbook.machines.machine.studies.changes import breaks, crossings
from workbook.machines.machine.studies.results import results
from workbook.reading.descriptions import make_machine, write_machine

BRAKING = (30.0, 130.0)
MOST = 5e3  # N that resist


def loose(one, window=BRAKING, force=0.0, gap=0.1, **more):
    """A machine of an axis whose drive has a backlash, and whose tool works in a window."""
    windows = [{"start": 300.0, "stop": 310.0, "force": 1.0}, {"start": window[0], "stop": window[1], "force": force}]
    load = one["load"] | {"windows": windows}
    return small(one | {"load": load, "backlash": {"gap": gap, "works": 2}} | more)


DRIVES = {
    "a crank-slider, late": lambda: loose(linked(shift=40.0)),
    "a press crank, across the end": lambda: loose(press(), (330.0, 40.0)),
    "an arm": lambda: loose(arm()),
    "losses": lambda: loose(lossy(), (0.0, 360.0), 50.0),
    "a window of no length": lambda: loose(linked(), (70.0, 70.0)),
}


@pytest.mark.parametrize("name", DRIVES)
@pytest.mark.sample(2)
def test_cells_and_engine_agree(name):
    machine = DRIVES[name]()
    wrong, count = disagreeing(TEMPLATE, machine)
    assert wrong == []
    assert count > 1000
    (limit,) = (limit for limit in judgement(machine).limits if limit.check == "back1_sides")
    assert limit.sheet.ok == limit.exact.ok


def test_the_check_holds_while_a_force_keeps_the_load_on_its_side(tmp_path):
    held, crossed = loose(linked(*OUT), BRAKING, MOST), loose(linked(*OUT))
    for machine, verdict in ((held, "OK"), (crossed, "FAIL")):
        value = computed(TEMPLATE, machine)
        assert value("back1_sides") == verdict
        assert ("back1_sides" in breaks(machine)) == (verdict == "FAIL")
        named = results(machine, {}).named
        for name in ("back1_back", "back1_fore"):
            assert named[name]() == pytest.approx(value(name), abs=1e-9)
    assert " Nm backward, " in value("back1_sides_says")
    (line,) = (line for line in build(crossed, tmp_path / "book.xlsx") if "change sides" in line)
    assert "Nm forward" in line
    assert read_inputs(tmp_path / "book.xlsx") == (crossed, [])


def test_improve_lists_each_moment_with_error_and_shock(tmp_path, monkeypatch, capsys):
    machine = loose(linked(*OUT))
    (view,) = drives_of(machine)
    moments = list(Backlash(view.driven.drive_cycle, 1e-4).crossings)
    lines = list(crossings(machine))
    assert len(lines) == len(moments) > 1
    for line, moment in zip(lines, moments, strict=True):
        assert line.startswith("A1: its load crosses the backlash of 0.1 mm (")
        assert line.endswith(f"strikes after {1e3 * moment.time:.4g} ms with {1e3 * moment.shock:.4g} mm/s")
    path = tmp_path / "machine.toml"
    path.write_text(write_machine(machine), encoding="utf-8")
    monkeypatch.setattr(command, "show_gains", lambda design, *_: design)
    command.improve(path, None, "laws", ("rate", 0.0, 0.0), "", (None, None), False)
    assert "crosses the backlash" in capsys.readouterr().out.replace("\n", " ")


def test_a_load_without_inertia_says_so():
    one = linked(*OUT) | {"load": {"mass": 0.0, "force": 3.0}, "parts": []}
    (line,) = crossings(loose(one))
    assert line.endswith("expected that of load or parts")


@pytest.mark.parametrize(
    ("change", "match"),
    [
        ({"works": 3}, "backlash.works: 3; expected the number of one of 2 process forces"),
        ({"works": 9}, "backlash.works"),
    ],
)
def test_what_cannot_be_is_refused(change, match):
    data = loose(linked(*OUT)).model_dump()
    data["axes"][0]["backlash"] |= change
    with pytest.raises(InputError, match=match):
        make_machine(TEMPLATE, data, str)
    data["axes"][0] |= {"backlash": {"gap": 0.1}, "motor": None, "mechanism": None, "load": {}, "parts": []}
    with pytest.raises(InputError, match="backlash: entered for an axis without a drive"):
        make_machine(TEMPLATE, data, str)
