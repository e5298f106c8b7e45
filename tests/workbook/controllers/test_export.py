"""The command export: what it writes, what it refuses, and that nothing is written where it does."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import openpyxl
import pytest

from tests.workbook.controllers.examples import TEXT
from workbook import build as making
from workbook import file_cache
from workbook.build import build
from workbook.commands import verify as verifying
from workbook.commands.export import slugs
from workbook.controllers.registry import TARGETS, target
from workbook.controllers.tabulation import automatic, certify_table, tabulate
from workbook.controllers.target import read_table
from workbook.reading.descriptions import read_machine
from workbook.template import FOLDER
from workbook.templates import TEMPLATES


@pytest.fixture(autouse=True)
def _read_once(monkeypatch, read_once):
    monkeypatch.setattr(making, "read_inputs", read_once)


@pytest.fixture
def verified(monkeypatch, tmp_path):
    """The books that verify is asked of, nothing being remembered before."""
    asked, verify = [], verifying.judged

    def counted(path, **given):
        asked.append(path)
        return verify(path, **given)

    monkeypatch.setattr(verifying, "judged", counted)
    monkeypatch.setattr(file_cache, "folder", lambda: tmp_path / "remembered")
    return asked


def test_an_axis_is_written_with_its_certificate_and_never_twice_unasked(run, book, tmp_path) -> None:
    code, out, _ = run("export", book, "--axis", "press", "--to", "csv")
    assert code == 0
    assert "acceleration" in out
    written = tmp_path / "two-Press.csv"
    text = written.read_bytes().decode()
    assert "Two axes, axis Press" in text
    assert "SHA-256" in text
    table = target("csv").read(text)
    assert table.x[[0, -1]].tolist() == [0.0, 360.0]
    assert table.y.max() == pytest.approx(20.0)
    before = written.read_bytes()
    code, _, err = run("export", book, "--axis", "Press", "--to", "csv", "--unverified")
    assert (code, written.read_bytes()) == (2, before)
    assert "exists" in err
    code, _, _ = run("export", book, "--axis", "Press", "--to", "csv", "--force", "--unverified")
    assert code == 0
    unverified = written.read_text("utf-8").splitlines()
    assert [line for line in unverified if "NOT VERIFIED" not in line] == before.decode().splitlines()


def test_every_axis_and_json(run, book, tmp_path) -> None:
    code, out, _ = run("export", book, "--all", "--to", "csv", "-o", "cams", "--unverified", "--json")
    assert code == 0
    told = json.loads(out)
    assert [one["axis"] for one in told] == ["Press", "Feed 2"]
    assert all(one["rules"]["quintics"]["acceleration"]["share"] < 0.01 for one in told)
    assert sorted(path.name for path in (tmp_path / "cams").iterdir()) == ["two-Feed_2.csv", "two-Press.csv"]
    assert "NOT VERIFIED" in (tmp_path / "cams" / "two-Press.csv").read_text("utf-8")


def test_a_book_that_disagrees_is_exported_only_when_told_to(run, book, tmp_path) -> None:
    changed = tmp_path / "changed.xlsx"
    workbook = openpyxl.load_workbook(book)
    sheet, row = next((s, cell) for s in workbook for line in s.iter_rows() for cell in line if cell.data_type == "f")
    sheet[row.coordinate] = 12345.0
    workbook.save(changed)
    code, _, err = run("export", changed, "--axis", "Press", "--to", "csv", "-o", "a.csv")
    assert code == 1
    assert "--unverified" in err
    assert not (tmp_path / "a.csv").exists()
    code, _, _ = run("export", changed, "--axis", "Press", "--to", "csv", "-o", "a.csv", "--unverified")
    assert code == 0
    assert "NOT VERIFIED" in (tmp_path / "a.csv").read_text("utf-8")


def test_a_design_that_fails_is_exported_with_a_warning_and_an_unfinished_one_is_not(run, tmp_path) -> None:
    for name, found, meant in (("fails", "lift = -20.0", "lift = -19.0"), ("open", "stop = 135.0", "stop = 85.0")):
        assert found in TEXT
        (tmp_path / f"{name}.toml").write_text(TEXT.replace(found, meant, 1), encoding="utf-8")
        assert run("build", f"{name}.toml")[0] == 3
    code, _, err = run("export", "fails.xlsx", "--axis", "Press", "--to", "csv")
    assert code == 0
    assert "FAILS" in err
    assert "FAILS" in (tmp_path / "fails-Press.csv").read_text("utf-8")
    code, _, err = run("export", "open.xlsx", "--axis", "Press", "--to", "csv", "--unverified")
    assert code == 1
    assert "unfinished" in err
    assert not (tmp_path / "open-Press.csv").exists()


def test_beyond_a_tolerance_nothing_is_written(run, book, tmp_path) -> None:
    code, _, err = run("export", book, "--all", "--to", "csv", "--points", 18, "--tolerance", "a=0.01%", "--unverified")
    assert code == 1
    assert "acceleration is off by 0.2" in err
    assert [path.name for path in tmp_path.iterdir()] == []
    code, out, _ = run("export", book, "--all", "--to", "csv", "--tolerance", "a=0.001%", "--unverified", "--json")
    assert code == 0
    assert all(one["rules"]["quintics"]["acceleration"]["share"] <= 1e-5 for one in json.loads(out))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--to", "csv"], "either --axis NAME, --switches or --all"),
        (["--to", "csv", "--axis", "MC09"], "no axis is named 'MC09'; expected one of Press, Feed 2"),
        (["--to", "csv", "--all", "--axis", "Press"], "either --axis NAME, --switches or --all"),
        (["--to", "plc", "--all"], "no target is named 'plc'"),
        (["--to", "csv", "--axis", "Press", "--points", "many"], "expected a number of points, or auto"),
        (["--to", "csv", "--axis", "Press", "--points", "3"], "at least 16"),
        (["--to", "csv", "--axis", "Press", "--points", "99999"], "expected 2 to 10,000"),
        (["--to", "csv", "--axis", "Press", "--tolerance", "a=-1%"], "expected y, v, a or j"),
        (["--to", "csv", "--axis", "Press", "--tolerance", "q=1%"], "expected y, v, a or j"),
        (["--to", "csv", "--axis", "Press", "--separator", "comma", "--decimal", "comma"], "expected two signs"),
        (["--to", "siemens-segments", "--axis", "Press", "--equidistant"], "expected no --equidistant"),
        (["--to", "mitsubishi-ratio", "--axis", "Press", "--points", "300"], "expected one of 257, 513, 1025"),
        (["--to", "codesys", "--axis", "Press", "--decimal", "comma"], "expected no --decimal"),
    ],
)  # fmt: skip
def test_what_cannot_be_meant_is_refused_in_a_line(run, book, tmp_path, arguments, said) -> None:
    code, _, err = run("export", book, *arguments, "--unverified")
    assert code == 2
    assert said in " ".join(err.split())
    assert list(tmp_path.iterdir()) == []


def test_a_report_has_the_figures_and_four_pictures_an_axis(run, book, tmp_path) -> None:
    code, _, _ = run("export", book, "--all", "--to", "rockwell", "--unverified", "--report", "cams.html")
    assert code == 0
    text = (tmp_path / "cams.html").read_text("utf-8")
    assert text.count("<svg") == 8
    assert text.count("error of the position over the cycle</title>") == 2
    assert all(word in text for word in ("Press", "Feed 2", "acceleration", "untested", "clamped cubic spline"))
    assert "script" not in text
    assert text.count("Recommended: ") == 2
    assert re.search(
        r"Recommended: \d+ points, the fewest that keep to position 0.01 %, acceleration 1 % of its peak", text
    )
    code, _, err = run("export", book, "--all", "--to", "rockwell", "--unverified", "--report", "cams.html", "-o", "b")
    assert code == 2
    assert "exists" in err


def test_points_at_equal_steps_where_they_are_asked_for(run, book, tmp_path) -> None:
    asked = ("--axis", "Press", "--to", "twincat-table", "--points", 577, "--unverified")
    assert run("export", book, *asked, "--equidistant", "-o", "equal.st")[0] == 0
    text = (tmp_path / "equal.st").read_text("utf-8")
    assert "MC_TABLETYPE_EQUIDISTANT" in text
    assert "at equal steps" in text
    assert target("twincat-table").read(text).x == pytest.approx(np.linspace(0.0, 360.0, 577))
    assert run("export", book, *asked, "-o", "breaks.st")[0] == 0
    assert "MC_TABLETYPE_NONEQUIDISTANT" in (tmp_path / "breaks.st").read_text("utf-8")


@pytest.mark.parametrize("name", ["siemens-points", "rockwell", "br"])
def test_at_equal_steps_the_best_is_not_the_first_that_was_tried(axes, name: str) -> None:
    equal = replace(target(name), spacing="equal")
    smooth = axes[1]
    found, few = automatic(equal, smooth, {"a": 0.01}), tabulate(equal, smooth, 9)
    assert found.share("a") < 0.1 * certify_table(equal, few, smooth.profile).share("a")
    assert np.diff(found.table.x) == pytest.approx(360.0 / (found.points - 1), abs=1e-4)


@pytest.mark.parametrize(
    ("names", "called"),
    [
        (["MC01", "Feed 2"], ["MC01", "Feed_2"]),
        (["Ось", "轴", "Press"], ["Axis_1", "Axis_2", "Press"]),
        (["A-1", "a 1", "a__1"], ["A_1_1", "a_1_2", "a_1_3"]),
        (["1 up", "<x>'; DROP", "END_VAR", "é"], ["Axis_1_up", "x_DROP", "END_VAR", "Axis"]),
    ],
)
def test_every_axis_has_a_name_that_controllers_take(names, called):
    assert slugs(names) == called
    assert all(name.replace("_", "a").isalnum() and name.isascii() and "__" not in name for name in called)
    assert len({name.casefold() for name in called}) == len(names)


def test_the_header_tells_number_and_revision_and_the_help_what_is_untested(run, tmp_path):
    (tmp_path / "told.toml").write_text(
        TEXT.replace("[master]", 'number = "CM-7"\nrevision = "C"\n[master]', 1), "utf-8"
    )
    assert run("build", "told.toml")[0] == 0
    assert run("export", "told.xlsx", "--axis", "Press", "--to", "codesys", "--unverified")[0] == 0
    head = (tmp_path / "told-Press.st").read_text("utf-8").splitlines()[0]
    assert head.startswith("// Two axes, number CM-7, revision C, axis Press: CODESYS")
    _, out, _ = run("export", "--help")
    assert "untested" in out


WITH_AXES = sorted(path.stem for path in FOLDER.glob("*.toml") if path.stem != "motion-laws")


@pytest.mark.nightly
@pytest.mark.parametrize("template", WITH_AXES)
def test_all_axes_of_every_template_go_to_every_target_and_can_be_read(template, run, tmp_path):
    build(read_machine(FOLDER / f"{template}.toml"), tmp_path / "book.xlsx")
    for name in TARGETS:
        code, _, err = run("export", "book.xlsx", "--all", "--to", name, "-o", name, "--unverified")
        if "no y is above 0" in err:  # an axis that only moves below its begin, which this target cannot have
            assert (code, name) == (2, "kollmorgen")
            continue
        assert code == 0, (name, err)
        files = [path for path in (tmp_path / name).iterdir() if "switches" not in path.name]
        assert files
        for path in files:
            assert read_table(path, target(name)).x.size >= 2


def test_with_all_axes_nothing_is_written_where_one_file_exists_and_all_of_these_are_named(
    run, book, tmp_path, verified
):
    for name in ("two-Press.csv", "two-Feed_2.csv"):
        (tmp_path / name).write_text("mine", "utf-8")
    code, _, err = run("export", book, "--all", "--to", "csv")
    assert code == 2
    assert all(f"{name}" in " ".join(err.split()) for name in ("two-Press.csv", "two-Feed_2.csv"))
    assert (tmp_path / "two-Press.csv").read_text("utf-8") == "mine"
    assert verified == []  # told before the book is verified


def test_what_verify_said_of_the_same_bytes_is_remembered(run, book, tmp_path, verified) -> None:
    given = ("export", book, "--axis", "press", "--to", "csv", "--force")
    assert [run(*given)[0] for _ in range(3)] == [0, 0, 0]
    assert len(verified) == 1
    assert run(*given, "--fresh")[0] == 0
    assert len(verified) == 2
    verified.clear()
    assert run("compare", book, "two-Press.csv", "--axis", "Press", "--from", "csv")[0] == 0
    assert verified == []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(file_cache, "program_digest", lambda: "another one")
        assert run(*given)[0] == 0
    assert len(verified) == 1


@pytest.mark.parametrize("text", ["", "{", "[]", '{"program": 1}', "\x00"])
def test_a_memory_that_is_damaged_is_none(text, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(file_cache, "folder", lambda: tmp_path)
    file_cache.store_cached("verdict", "ab", {"findings": 0})
    assert file_cache.load_cached("verdict", "ab")["findings"] == 0
    (tmp_path / "ab.verdict.json").write_text(text, "utf-8")
    assert file_cache.load_cached("verdict", "ab") is None


def test_a_folder_that_takes_nothing_is_no_fault(tmp_path, monkeypatch) -> None:
    (tmp_path / "file").write_text("no folder", "utf-8")
    monkeypatch.setattr(file_cache, "folder", lambda: tmp_path / "file")
    file_cache.store_cached("verdict", "ab", {})
    assert file_cache.load_cached("verdict", "ab") is None


def test_a_system_that_knows_no_home_has_nothing_written_where_the_command_is_given(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(file_cache, "user_cache_path", lambda *name, **how: Path("~/.cache/motionbook"))
    file_cache.store_cached("verdict", "ab", {})
    assert file_cache.load_cached("verdict", "ab") is None
    assert list(tmp_path.iterdir()) == []


SHAFTS = {"MC01": 8.0 * 300.0 / 134.0 * 180.0 / np.pi, "MC02": 360.0}
"""largest angle in degrees: i s/R of feed rollers behind a reducer, a turn a lead of 20 mm"""


def test_the_motors_shaft_goes_out_as_an_angle(run, tmp_path) -> None:
    workbook_of = read_machine(FOLDER / "machine.toml")
    for axis in TEMPLATES["machine"].axes(workbook_of):
        assert (axis.shaft is not None) == (axis.name in SHAFTS)
        if axis.shaft is not None:
            seen = axis.shaft()
            assert np.ptp(seen.profile.at(np.linspace(0.0, 360.0, 3_601)).y) == pytest.approx(SHAFTS[axis.name])
            assert (seen.y_unit, seen.x_unit, seen.repeats) == ("°", "°", axis.repeats)


def test_behind_a_crank_the_shafts_angle_is_that_of_its_geometry_and_is_certified(run, tmp_path) -> None:
    """The ram's crank worked out anew, by the triangle of crank, rod and the line from the shaft to the slide."""
    described = read_machine(FOLDER / "machine-linkages.toml")
    ram, entry = TEMPLATES["machine"].axes(described)[0], described.axes[0].mechanism
    tolerance = {"y": 1e-4, "a": 0.01}
    made = automatic(target("csv"), ram.shaft(), tolerance)
    assert made.excess(tolerance) <= 1.0
    crank, rod = entry.crank_radius, entry.rod_length
    inner = np.sqrt((rod - crank) ** 2 - entry.offset**2)
    x = inner + entry.start + ram.profile.at(made.table.x).y
    apart = np.hypot(x, entry.offset)
    turned = np.arccos((crank**2 + apart**2 - rod**2) / (2.0 * crank * apart))
    angle = np.degrees(turned + np.arctan2(entry.offset, x)) * described.axes[0].reducer.ratio
    assert np.abs(made.table.y - made.table.y[0]) == pytest.approx(np.abs(angle - angle[0]), abs=1e-4)


def test_an_axis_without_a_drive_has_no_shaft(run, book) -> None:
    code, _, err = run("export", book, "--axis", "Press", "--to", "csv", "--of", "shaft", "--unverified")
    assert (code, "expected --of load" in " ".join(err.split())) == (2, True)
    code, _, err = run("export", book, "--axis", "Press", "--to", "csv", "--of", "motor", "--unverified")
    assert (code, "'motor' is not one of 'load', 'shaft'" in err) == (2, True)
