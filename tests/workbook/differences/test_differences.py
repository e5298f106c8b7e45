"""Two books or descriptions compared: what changed is named, what follows from it, and nothing else."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import openpyxl
import pytest
from rich.console import Console

from tests import cutting
from tests.workbook.composed import small
from tests.workbook.edit import cell_named
from workbook.build import build
from workbook.commands.oracle import diff
from workbook.differences.design import Change, Differences, compare, read_design
from workbook.reading.descriptions import make_machine, read_machine, write_machine
from workbook.reports.differences import MOST, show
from workbook.template import FOLDER
from workbook.templates import TEMPLATES
from workbook.witnesses.engines import convert, libreoffice_path
from workbook.writing.output_files import write_text


def machine_of(data):
    """Return the machine of entries."""
    return make_machine(TEMPLATES["machine"], data, str)


@pytest.fixture(scope="module")
def data():
    """The cutting machine in small tables, as entries."""
    return cutting.small(cycle=12, law=4).model_dump()


@pytest.fixture(scope="module")
def folder(tmp_path_factory, data):
    """A folder with its description and its book."""
    folder = tmp_path_factory.mktemp("differences")
    write_text(folder / "old.toml", write_machine(machine_of(data)))
    build(machine_of(data), folder / "old.xlsx")
    return folder


def edited(folder, data, name, change):
    """Write the description with a change of its entries; return its path."""
    copy = json.loads(json.dumps(data))
    change(copy)
    path = folder / f"{name}.toml"
    write_text(path, write_machine(machine_of(copy)), overwrite=True)
    return path


def differences(old, new):
    return compare(read_design(old), read_design(new))


def lift_more(data):
    data["axes"][2]["phases"][1]["lift"] += 4.0
    data["axes"][2]["phases"][3]["lift"] -= 4.0


def test_a_book_is_the_same_as_its_description(folder):
    assert differences(folder / "old.toml", folder / "old.xlsx").same


@pytest.mark.sample(2)
@pytest.mark.parametrize("save", ["openpyxl", "libreoffice", "opendocument"])
def test_a_book_saved_by_another_program_is_the_same(tmp_path, save):
    book, made = tmp_path / "small.xlsx", tmp_path / "made"
    build(small(), book)
    made.mkdir()
    if save == "openpyxl":
        saved = tmp_path / "saved.xlsx"
        openpyxl.load_workbook(book).save(saved)
    elif libreoffice_path() is None:
        pytest.skip("LibreOffice is not on this machine")
    else:
        source = book if save == "libreoffice" else convert(book, "ods", made)
        saved = convert(source, "xlsx", made)
    assert differences(book, saved).same


def test_one_changed_lift_names_that_and_the_results_of_its_axis(folder, data):
    found = differences(folder / "old.toml", edited(folder, data, "lift", lift_more))
    entries = [(one.place, one.label, one.old, one.new) for one in found.entries]
    assert entries == [("Timing: MC03 row 2", "lift", 80.0, 84.0), ("Timing: MC03 row 4", "lift", -80.0, -84.0)]
    assert {one.place.partition(": ")[2].partition(" ")[0] for one in found.results} == {"MC03"}
    assert {abs(round(one.per_cent, 9)) for one in found.results} == {5.0}
    assert not found.checks


def test_an_axis_put_before_the_others_is_all_that_is_new(folder, data):
    def insert(copy):
        copy["axes"].insert(1, copy["axes"][1] | {"name": "MC00"})

    found = differences(folder / "old.toml", edited(folder, data, "more", insert))
    places = {one.place for one in found.entries}
    assert [one for one in found.entries if one.old is not None] == []
    assert [place for place in places if "MC00" not in place] == []


def test_a_check_that_fails_now_is_worse_and_says_where(folder, data):
    def weaker(copy):
        copy["axes"][0]["motor"]["rated_torque"] = 20.0

    found = differences(folder / "old.toml", edited(folder, data, "weak", weaker))
    (failed,) = [one for one in found.checks if "RMS torque" in one.label]
    assert (failed.old, failed.new, failed.worse) == ("OK", "FAIL", True)
    assert failed.says
    assert [one.worse for one in found.results if one.label == "Use of the continuous torque"] == [True]


def test_an_edited_formula_and_cells_of_ones_own_are_named(folder, tmp_path):
    book = openpyxl.load_workbook(folder / "old.xlsx")
    cell = cell_named(book, "drive1_tmax")
    cell.value = "=1+1"
    cell.parent["AL2"] = "=2+2"
    book.create_sheet("Notes")["A1"] = "mine"
    book.save(tmp_path / "new.xlsx")
    found = differences(folder / "old.xlsx", tmp_path / "new.xlsx")
    assert len(found.edited["new"]) == 1
    assert f"{cell.parent.title}!{cell.coordinate}" in found.edited["new"][0]
    assert [line for line in found.own["new"] if "AL2" in line]
    assert "the sheet 'Notes'" in found.own["new"]
    assert found.edited["old"] == found.own["old"] == found.entries == found.results == []


def test_the_command_tells_by_its_exit_code_and_as_json(folder, data, tmp_path, capsys):
    new, page = edited(folder, data, "lift", lift_more), tmp_path / "page.html"
    assert diff(folder / "old.toml", folder / "old.toml", False, None, False) == 0
    capsys.readouterr()
    assert diff(folder / "old.toml", new, True, page, False) == 1
    told = json.loads(capsys.readouterr().out)
    assert not told["same"]
    assert [one["new"] for one in told["entries"]] == [84.0, -84.0]
    assert page.read_text(encoding="utf-8").count("<svg") == 1  # of the axis that differs
    assert command("diff", folder / "old.toml", FOLDER / "flying-cutter.toml").returncode == 2
    assert command("diff", folder / "old.toml", folder / "none.xlsx").returncode == 2


def command(*arguments, **options):
    """Run motionbook in a process of its own."""
    line = [sys.executable, "-m", "workbook", *map(str, arguments)]
    return subprocess.run(line, capture_output=True, text=True, check=False, cwd=Path(__file__).parents[3], **options)


@pytest.mark.skipif(shutil.which("git") is None, reason="git is not on this machine")
def test_git_shows_a_changed_book_as_docs_differences_says(folder, data, tmp_path):
    def git(*arguments):
        done = subprocess.run(["git", *arguments], cwd=tmp_path, capture_output=True, text=True, check=False, env=None)
        assert done.returncode == 0, done.stderr
        return done.stdout

    program = f"PYTHONPATH={Path(__file__).parents[3]} {sys.executable} -m workbook"
    guide = (Path(__file__).parents[3] / "docs/differences.md").read_text(encoding="utf-8")
    driver, textconv = (line.split("'")[1] for line in guide.splitlines() if line.startswith("git config diff."))
    git("init", "-q")
    git("config", "user.email", "me@example.org")
    git("config", "user.name", "me")
    (tmp_path / ".gitattributes").write_text("*.xlsx diff=motionbook\n")
    shutil.copy(folder / "old.xlsx", tmp_path / "machine.xlsx")
    git("add", ".")
    git("commit", "-qm", "one")
    build(read_machine(edited(folder, data, "lift", lift_more)), tmp_path / "machine.xlsx", overwrite=True)
    git("config", "diff.motionbook.textconv", textconv.replace("motionbook", program))
    changed = [line.strip() for line in git("diff").splitlines() if line.startswith(("-", "+")) and "lift" in line]
    assert len(changed) == 4
    git("config", "diff.motionbook.command", driver.replace("motionbook", program))
    shown = git("diff")
    assert "MC03 row 2" in shown
    assert "+5.00 %" in shown


def changed_results(count):
    """So many results that moved, and one by its last digit."""
    moved = [Change("Drive", f"result {n}", "Nm", 1.0, 2.0) for n in range(count)]
    return [*moved, Change("Drive", "a last digit", "Nm", 1.0, 1.0 + 1e-9)]


@pytest.mark.parametrize("everything", [False, True])
def test_people_read_what_moved_and_a_formula_once_and_all_where_they_ask(everything, capsys):
    formulas = [f"Cycle 1!C{row} (position, row {row}): =A{row}*2" for row in range(15, 115)]
    found = Differences([], changed_results(30), [], {"old": [], "new": formulas}, {"old": [], "new": []})
    show(Console(width=200), found, everything)
    said = capsys.readouterr().out
    assert said.count("Cycle 1!C") == (100 if everything else 1)
    assert said.count("+100.00 %") == (30 if everything else MOST)
    assert ("a last digit" in said) == everything
    if not everything:
        assert f"… and {31 - MOST} more results; --all lists them" in said
        assert "+ Cycle 1!C15 … 114, 100 cells (position, row 15): =A15*2" in said
