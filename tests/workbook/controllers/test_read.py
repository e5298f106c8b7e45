"""The way back: a controller's file read as a description, built, and compared with the book that it came from."""

from dataclasses import replace

import numpy as np
import pytest

from workbook.controllers import as_description
from workbook.controllers.registry import TARGETS, target
from workbook.controllers.tabulation import automatic, reread, tabulate
from workbook.controllers.target import CamExport
from workbook.errors import TargetError
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES

EXACT = ("csv", "codesys", "twincat", "siemens", "siemens-segments", "codesys-table", "twincat-table", "siemens-points",
         "kollmorgen", "lenze")  # fmt: skip


UNITS = ("°", "mm")
EVERY_DAY = ("csv", "codesys", "siemens-segments", "rockwell", "br", "mitsubishi")


@pytest.mark.parametrize(
    ("name", "of"),
    [
        pytest.param(name, of, marks=[] if of == 1 and name in EVERY_DAY else pytest.mark.nightly)
        for name in TARGETS for of in range(3)
    ],
)  # fmt: skip
def test_the_cutting_machine_comes_back_from_every_target(axes, machine, name: str, of: int) -> None:
    """Codes and breaks are equal; from numbers of 32 bits, and whole ones, within what they leave."""
    one = target(name)
    for axis, given in ((axes[of], machine.axes[of]),):
        made = automatic(one, axis, dict(one.tolerance))
        table = reread(one, one.write(CamExport(made.table, "demo", (), ("°", "mm"))), made.table)
        found = as_description.phases_of(one, table).phases
        moving = [phase for phase in given.phases if phase.law != "DWL"]
        assert [phase.law.code for phase in found] == [phase.law for phase in moving]
        near = 1e-9 if name in EXACT else 2e-3
        for phase, meant in zip(found, moving, strict=True):
            assert (phase.begin, phase.end, phase.lift) == pytest.approx(
                (meant.start, meant.stop, meant.lift), abs=near
            )
            assert phase.residual <= (1e-9 if name in EXACT else 1e-4)


ON_THE_WAY = {
    ("flying-cutter", "tool"): [("CIC", 188.495559), ("LIN", 62.831853)],
    ("flying-cutter-saw", "shaft"): [("MTP", -4500.0), ("LIN", 4500.0)],
    ("indexing-overlap-stations", "Die"): [("CIC", 50.0), ("CIC", -50.0)],
    ("indexing-overlap-stations", "Riveting head"): [("MTP", 80.0), ("CUB", -80.0)],
    ("actuator-sizing", "Slide"): [("ACS", 0.8), ("LIN", 6.4), ("ACS", 0.8)],
}  # fmt: skip
FEW_POINTS = ("rockwell", "mitsubishi", "mitsubishi-ratio")  # and numbers of 32 bits: lines are two points
BY_DAY = ("codesys", "siemens-points", "siemens-segments", "sew")


@pytest.mark.parametrize("of", ON_THE_WAY, ids="-".join)
@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=[] if name in BY_DAY else pytest.mark.nightly)
     for name in TARGETS if name not in FEW_POINTS],
)  # fmt: skip
def test_a_cycle_that_begins_on_the_way_comes_back_with_its_laws(name: str, of) -> None:
    """Tools that go with a line, and tables that start in the middle of a movement."""
    one, template = target(name), of[0]
    machine = read_machine(FOLDER / f"{template}.toml")
    axis = next(one for one in TEMPLATES[machine.template].axes(machine) if one.name == of[1])
    made = automatic(one, axis, dict(one.tolerance))
    units = axis.x_unit, axis.y_unit
    table = reread(one, one.write(CamExport(made.table, "demo", (), units, axis.repeats)), made.table)
    found = as_description.phases_of(one, table, units)
    if name == "br" and axis.x_unit == "s":  # polynomials of degree 5 in REAL, over whole microseconds
        assert all(phase.known for phase in found.phases)
        return
    assert [phase.law.code for phase in found.phases] == [code for code, _ in ON_THE_WAY[of]]
    assert [phase.lift for phase in found.phases] == pytest.approx([lift for _, lift in ON_THE_WAY[of]], rel=1e-5)
    assert as_description.compose(found, table, units, "back")


@pytest.mark.parametrize("name", ["x" * 240 + ".csv", "a\x1b[31m\u009b\n.csv", "[red]x.csv", "\udcff.csv", "#REF!.csv"])
def test_a_file_of_any_name_is_read(name, run, tmp_path) -> None:
    (tmp_path / name).write_text("0;0\n90;10\n180;10\n360;0\n", encoding="utf-8")
    code, _, err = run("read", name, "--from", "csv", "-o", "back.toml")
    assert code in (0, 2)
    assert "title" not in err
    assert all(line.isprintable() for line in err.splitlines())
    if code == 0:
        assert read_machine(tmp_path / "back.toml").title.startswith("Read from ")


def test_a_file_becomes_a_description_that_is_built_and_exported_and_the_same(run, axes, tmp_path) -> None:
    one = target("codesys")
    made = automatic(one, axes[1], {"a": 0.01})
    (tmp_path / "cam.st").write_text(
        one.write(CamExport(made.table, "MC02", ("x in °, y in mm;",), ("°", "mm"))), "utf-8"
    )
    code, _, err = run("read", "cam.st", "--from", "codesys", "-o", "back.toml")
    assert code == 0
    assert "90–135 °: Modified trapezoidal, lift 20 mm, residual" in err
    back = read_machine(tmp_path / "back.toml")
    assert [(p.law, p.lift, p.start, p.stop) for p in back.axes[0].phases] == [
        ("MTP", 20.0, 90.0, 135.0), ("MTP", -20.0, 305.0, 350.0)
    ]  # fmt: skip
    assert (back.over.unit, back.over.length) == ("°", 360.0)
    assert run("build", "back.toml")[0] == 0
    code, out, _ = run("compare", "back.xlsx", "cam.st", "--axis", "Read", "--from", "codesys")
    assert code == 0
    assert "acceleration" in out
    asked = ("--axis", "Read", "--from", "codesys", "--tolerance", "a=0.1%", "--unverified")
    code, _, err = run("compare", "back.xlsx", "cam.st", *asked)
    assert code == 1
    assert "acceleration is off by 0.219 %" in err
    assert run("export", "back.xlsx", "--all", "--to", "codesys", "--unverified")[0] == 0
    again = one.read((tmp_path / "back-Read.st").read_text("utf-8"))
    assert again.y == pytest.approx(made.table.y, abs=1e-9)
    assert np.array_equal(again.x, made.table.x)


def test_compare_refuses_another_cycle_and_no_file(run, book, tmp_path) -> None:
    (tmp_path / "short.csv").write_text("0;0\n100;1\n200;0\n", "utf-8")
    code, _, err = run("compare", book, "short.csv", "--axis", "Press", "--from", "csv", "--unverified")
    assert code == 2
    assert "expected the same cycle" in " ".join(err.split())
    code, _, err = run("compare", book, "none.csv", "--axis", "Press", "--from", "csv", "--unverified")
    assert code == 2
    assert "no such file" in err


LINE = """\
template = "machine"
title = "To line speed and back"
[laws.LIN]
family = "LIN"
[laws."Polynomial 3-4-5"]
family = "PO5"
[master]
cycle = 360.0
unit = "°"
[[axes]]
name = "Line"
group = "Line"
phases = [
  { law = "Polynomial 3-4-5", lift = 30.0, start = 0.0, stop = 90.0 },
  { law = "LIN", lift = 20.0, start = 90.0, stop = 130.0 },
  { law = "Polynomial 3-4-5", lift = -20.0, start = 130.0, stop = 230.0 },
  { law = "Polynomial 3-4-5", lift = -30.0, start = 230.0, stop = 300.0, velocity = -0.3, acceleration = 0.001 },
]
"""


@pytest.mark.parametrize("name", ["codesys", "siemens-segments", "csv"])
def test_a_motion_that_hands_over_at_speed_comes_back_as_it_was(run, tmp_path, name: str) -> None:
    (tmp_path / "line.toml").write_text(LINE, "utf-8")
    meant = read_machine(tmp_path / "line.toml")
    (axis,) = TEMPLATES["machine"].axes(meant)
    one = target(name)
    made = automatic(one, axis, {"a": 1e-6})
    (tmp_path / "cam").write_text(one.write(CamExport(made.table, "line", ("x in °, y in mm;",), ("°", "mm"))), "utf-8")
    assert run("read", "cam", "--from", name, "-o", "back.toml")[0] == 0
    back = read_machine(tmp_path / "back.toml").axes[0]
    found = [(p.law, p.lift, p.start, p.stop, p.velocity or 0.0, p.acceleration or 0.0) for p in back.phases]
    for phase, given in zip(found, meant.axes[0].phases, strict=True):
        assert phase[0] == given.law
        expected = (given.lift, given.start, given.stop, given.velocity or 0.0, given.acceleration or 0.0)
        assert phase[1:] == pytest.approx(expected, abs=1e-6)


def test_a_cycle_that_begins_on_the_way_is_a_machine_with_a_shift(run, axes, tmp_path) -> None:
    one, later = target("csv"), axes[1].profile.shifted(250.0)
    text = one.write(
        CamExport(tabulate(one, replace(axes[1], profile=later), 40), "late", ("x in °, y in mm;",), UNITS)
    )
    (tmp_path / "late.csv").write_text(text, "utf-8")
    code, _, err = run("read", "late.csv", "--from", "csv", "-o", "late.toml")
    assert code == 0
    assert "written as an axis that is 240 ° later" in " ".join(err.split())
    machine = read_machine(tmp_path / "late.toml")
    (axis,) = TEMPLATES["machine"].axes(machine)
    x = np.linspace(0.25, 359.75, 97)
    assert axis.profile.at(x).y == pytest.approx(later.at(x).y, abs=1e-9)


@pytest.mark.parametrize(("units", "closes"), [("x in s, y in mm;", "open"), ("x in mm, y in °;", "open")])
def test_a_table_over_any_abscissa_is_an_axis_over_it(run, tmp_path, units: str, closes: str) -> None:
    """From 2 to 12 of its units, and it does not come back: the cycle begins at 0, the position is the table's."""
    x = np.linspace(2.0, 12.0, 401)
    xi = np.clip((x - 4.0) / 5.0, 0.0, 1.0)
    y = 7.0 + 30.0 * (xi - np.sin(2 * np.pi * xi) / (2 * np.pi))
    rows = "".join(f"{a:.12g};{b:.15g}\n" for a, b in zip(x, y, strict=True))
    (tmp_path / "any.csv").write_text(f"# {units}\n{rows}", "utf-8")
    code, _, err = run("read", "any.csv", "--from", "csv", "-o", "any.toml")
    assert code == 0, err
    machine = read_machine(tmp_path / "any.toml")
    (given,), (axis,) = machine.axes, TEMPLATES["machine"].axes(machine)
    assert (machine.over.unit, machine.over.length, given.closes) == (axis.x_unit, 10.0, closes)
    assert [(p.law, p.start, p.stop, p.lift) for p in given.phases] == [("CIC", 2.0, 7.0, pytest.approx(30.0))]
    assert axis.profile.at(x[:-1] - 2.0).y == pytest.approx(y[:-1], abs=1e-9)


def test_units_that_no_axis_has_are_refused_in_a_line(run, tmp_path) -> None:
    (tmp_path / "odd.csv").write_text("# x in rev, y in m;\n0;0\n0.5;1\n1;0\n", "utf-8")
    code, _, err = run("read", "odd.csv", "--from", "csv")
    assert code == 2
    assert "it is in m over rev; expected an axis in mm or ° over s, °, rad, mm" in " ".join(err.split())


SHARP = {
    "sawtooth": ([0, 100, 120, 220, 240, 360], [0, 20, 0, 20, 0, 0], range(0, 361, 2)),
    "corners at one side": ([0, 40, 100, 220, 300, 360], [0, 0, 25, 25, 0, 0], range(361)),
    "unequal steps": (
        [0, 90, 250, 360],
        [0, 20, 0, 0],
        [*range(0, 90, 7), *range(90, 250, 3), 250, 261.3, 280.05, 360],
    ),
}


@pytest.mark.parametrize("name", SHARP)
def test_a_sharp_table_stays_sharp_in_the_digits_of_a_spreadsheet(name, run, tmp_path) -> None:
    at, positions, steps = SHARP[name]
    rows = (f"{angle};{np.interp(angle, at, positions):.9g}" for angle in steps)
    (tmp_path / "sharp.csv").write_text("\n".join(rows), "utf-8")
    code, out, err = run("read", "sharp.csv", "--from", "csv")
    assert code == 0, err
    (tmp_path / "back.toml").write_text(out, "utf-8")
    moves = [(a, b, d - c) for a, b, c, d in zip(at, at[1:], positions, positions[1:], strict=False) if c != d]
    phases = read_machine(tmp_path / "back.toml").axes[0].phases
    assert [(p.law, p.start, p.stop, pytest.approx(p.lift, abs=1e-6)) for p in phases] == [
        ("LIN", *one) for one in moves
    ]


def test_a_motion_that_misses_a_point_is_refused(axes) -> None:
    """By the profile of the machine that was described, not by the phases from which it was made."""
    made = tabulate(target("csv"), axes[1], 40)
    read = as_description.phases_of(target("csv"), made, UNITS)
    assert "keeps to all 40 points" in as_description.require_points(read, made, axes[1].profile, UNITS)
    wrong = made.y.copy()
    wrong[17] += 0.1
    with pytest.raises(TargetError, match=r"off by 0\.1 mm at"):
        as_description.require_points(read, replace(made, y=wrong), axes[1].profile, UNITS)
