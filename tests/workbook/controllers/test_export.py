"""The command export: what it writes, what it refuses, and that nothing is written where it does."""

import json
import sys

import openpyxl
import pytest

from workbook.cli import main
from workbook.commands.export import chosen
from workbook.controllers.registry import target
from workbook.errors import TargetError
from workbook.reading.entries import write_machine


@pytest.fixture
def run(monkeypatch, capsys, tmp_path):
    """Run a command within an empty folder; return its exit code and what it says."""
    monkeypatch.chdir(tmp_path)

    def called(*arguments):
        monkeypatch.setattr(sys, "argv", ["motionbook", *map(str, arguments)])
        capsys.readouterr()
        with pytest.raises(SystemExit) as left:
            main()
        said = capsys.readouterr()
        assert "Traceback" not in said.out + said.err
        return left.value.code, said.out, said.err

    return called


def test_an_axis_is_written_with_its_certificate_and_never_twice_unasked(run, book, tmp_path) -> None:
    code, out, _ = run("export", book, "--axis", "mc02", "--to", "csv")
    assert code == 0
    assert "acceleration" in out
    written = tmp_path / "machine-MC02.csv"
    text = written.read_bytes().decode()
    assert "Cutting machine, axis MC02" in text
    assert "SHA-256" in text
    table = target("csv").read(text)
    assert table.x[[0, -1]].tolist() == [0.0, 360.0]
    assert table.y.max() == pytest.approx(20.0)
    before = written.read_bytes()
    code, _, err = run("export", book, "--axis", "MC02", "--to", "csv", "--unverified")
    assert (code, written.read_bytes()) == (2, before)
    assert "exists" in err
    code, _, _ = run("export", book, "--axis", "MC02", "--to", "csv", "--force")
    assert (code, written.read_bytes()) == (0, before)


def test_every_axis_and_json(run, book, tmp_path) -> None:
    code, out, _ = run("export", book, "--all", "--to", "csv", "-o", "cams", "--unverified", "--json")
    assert code == 0
    told = json.loads(out)
    assert [one["axis"] for one in told] == ["MC01", "MC02", "MC03"]
    assert all(one["rules"]["quintics"]["acceleration"]["share"] < 0.01 for one in told)
    assert sorted(path.name for path in (tmp_path / "cams").iterdir()) == [f"machine-MC0{i}.csv" for i in (1, 2, 3)]
    assert "NOT VERIFIED" in (tmp_path / "cams" / "machine-MC01.csv").read_text("utf-8")


def test_a_book_that_disagrees_is_exported_only_when_told_to(run, book, tmp_path) -> None:
    changed = tmp_path / "changed.xlsx"
    workbook = openpyxl.load_workbook(book)
    sheet, row = next((s, cell) for s in workbook for line in s.iter_rows() for cell in line if cell.data_type == "f")
    sheet[row.coordinate] = 12345.0
    workbook.save(changed)
    code, _, err = run("export", changed, "--axis", "MC01", "--to", "csv", "-o", "a.csv")
    assert code == 1
    assert "--unverified" in err
    assert not (tmp_path / "a.csv").exists()
    code, _, _ = run("export", changed, "--axis", "MC01", "--to", "csv", "-o", "a.csv", "--unverified")
    assert code == 0
    assert "NOT VERIFIED" in (tmp_path / "a.csv").read_text("utf-8")


def test_a_design_that_fails_is_exported_with_a_warning_and_an_unfinished_one_is_not(run, machine, tmp_path) -> None:
    text = write_machine(machine)
    for name, found, meant in (
        ("fails", "peak_torque = 160.0", "peak_torque = 1.0"),
        ("open", "stop = 80.0", "stop = 70.0"),
    ):
        assert found in text
        (tmp_path / f"{name}.toml").write_text(text.replace(found, meant, 1), encoding="utf-8")
        assert run("build", f"{name}.toml")[0] == 0
    code, _, err = run("export", "fails.xlsx", "--axis", "MC01", "--to", "csv")
    assert code == 0
    assert "FAILS" in err
    assert "FAILS" in (tmp_path / "fails-MC01.csv").read_text("utf-8")
    code, _, err = run("export", "open.xlsx", "--axis", "MC01", "--to", "csv")
    assert code == 1
    assert "unfinished" in err
    assert not (tmp_path / "open-MC01.csv").exists()


def test_beyond_a_tolerance_nothing_is_written(run, book, tmp_path) -> None:
    code, _, err = run("export", book, "--all", "--to", "csv", "--points", 16, "--tolerance", "a=0.01%", "--unverified")
    assert code == 1
    assert "acceleration is off by 0.2" in err
    assert [path.name for path in tmp_path.iterdir()] == []
    code, out, _ = run("export", book, "--all", "--to", "csv", "--tolerance", "a=0.001%", "--unverified", "--json")
    assert code == 0
    assert all(one["rules"]["quintics"]["acceleration"]["share"] <= 1e-5 for one in json.loads(out))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--to", "csv"], "either --axis NAME or --all"),
        (["--to", "csv", "--axis", "MC09"], "no axis is named 'MC09'; expected one of MC01, MC02, MC03"),
        (["--to", "csv", "--all", "--axis", "MC01"], "either --axis NAME or --all"),
        (["--to", "plc", "--all"], "no target is named 'plc'"),
        (["--to", "csv", "--axis", "MC01", "--points", "many"], "expected a number of points, or auto"),
        (["--to", "csv", "--axis", "MC02", "--points", "3"], "at least 16"),
        (["--to", "csv", "--axis", "MC02", "--points", "99999"], "expected 2 to 10,000"),
        (["--to", "csv", "--axis", "MC01", "--tolerance", "a=-1%"], "expected y, v, a or j"),
        (["--to", "csv", "--axis", "MC01", "--tolerance", "q=1%"], "expected y, v, a or j"),
        (["--to", "csv", "--axis", "MC01", "--separator", "comma", "--decimal", "comma"], "expected two signs"),
    ],
)  # fmt: skip
def test_what_cannot_be_meant_is_refused_in_a_line(run, book, tmp_path, arguments, said) -> None:
    code, _, err = run("export", book, *arguments, "--unverified")
    assert code == 2
    assert said in " ".join(err.split())
    assert list(tmp_path.iterdir()) == []


def test_a_template_without_motions_says_so() -> None:
    with pytest.raises(TargetError, match="press has no axis"):
        chosen([], None, "press")


def test_a_report_has_the_figures_and_two_pictures_an_axis(run, book, tmp_path) -> None:
    code, _, _ = run("export", book, "--all", "--to", "rockwell", "--unverified", "--report", "cams.html")
    assert code == 0
    text = (tmp_path / "cams.html").read_text("utf-8")
    assert text.count("<svg") == 6
    assert all(word in text for word in ("MC01", "MC02", "MC03", "acceleration", "untested", "clamped cubic spline"))
    assert "script" not in text
    code, _, err = run("export", book, "--all", "--to", "rockwell", "--unverified", "--report", "cams.html", "-o", "b")
    assert code == 2
    assert "exists" in err
