"""The hook that this repository offers, run by pre-commit in another repository."""

import shutil
import subprocess
import sys
from pathlib import Path

import openpyxl
import pytest

from tests.workbook.composed import small
from workbook.build import build

pytestmark = pytest.mark.nightly  # pre-commit installs the command for itself: a minute
ROOT = Path(__file__).parents[3]


def call(folder, *command):
    """Run a program in a folder; return how it ended and what it printed."""
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8", check=False)
    return done.returncode, done.stdout + done.stderr


@pytest.fixture(scope="module")
def hook(tmp_path_factory):
    """The sources as a repository of their own, with the changes that are not committed yet."""
    folder = tmp_path_factory.mktemp("hook")
    for name in ("engine", "workbook", "templates"):
        shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "*.xlsx"))
    for name in ("pyproject.toml", "README.md", "LICENSE", "hatch_build.py", ".pre-commit-hooks.yaml"):
        shutil.copy(ROOT / name, folder / name)
    commit(folder)
    return folder


@pytest.fixture(scope="module")
def machines(tmp_path_factory):
    """A repository with a sound book."""
    folder = tmp_path_factory.mktemp("machines")
    build(small(), folder / "press.xlsx")
    commit(folder)
    return folder


def commit(folder):
    """Make a repository of a folder."""
    git = ["git", "-c", "user.name=A", "-c", "user.email=a@example.org"]
    for step in (["init", "-q"], ["add", "-A"], ["commit", "-q", "-m", "Begin"]):
        code, said = call(folder, *git, *step)
        assert code == 0, said


def tried(hook, machines):
    """Run the hook on all files of a repository; return how it ended and what it printed."""
    return call(machines, sys.executable, "-m", "pre_commit", "try-repo", str(hook), "motionbook-verify", "--all-files")


def test_the_hook_passes_a_sound_book_and_names_the_cell_that_was_changed(hook, machines):
    code, said = tried(hook, machines)
    assert code == 0, said
    assert "Passed" in said
    book = openpyxl.load_workbook(machines / "press.xlsx")
    sheet, cell = book.defined_names["axis1_position"].attr_text.replace("$", "").replace("'", "").split("!")
    book[sheet][cell] = "=1+1"
    book.save(machines / "press.xlsx")
    code, said = tried(hook, machines)
    assert code == 1, said
    assert "press.xlsx" in said
    assert f"{sheet}!{cell}" in said.replace("'", "").replace(" ", "")
