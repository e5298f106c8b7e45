"""A template of one's own, in a package outside the repository: written, installed, built, verified and tested."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from workbook import api

ROOT = Path(__file__).parents[1]
PAGE = (ROOT / "docs" / "own-templates.md").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """The folder in which a package of a crane is written and installed, with one that cannot be loaded; and runs."""
    folder = tmp_path_factory.mktemp("own")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(folder / "site"), str(ROOT)])}

    def run(*command):
        done = subprocess.run(
            [sys.executable, "-m", *command], capture_output=True, text=True, encoding="utf-8", check=False,
            cwd=folder, env=environment,
        )  # fmt: skip
        return done.returncode, done.stdout, " ".join(done.stderr.split())

    assert run("workbook", "new-template", "crane", "-o", "crane")[0] == 0
    pip = (
        "pip",
        "install",
        "--no-deps",
        "--no-index",
        "--no-build-isolation",
        "--quiet",
        "--target",
        "site",
        "./crane",
    )
    assert run(*pip)[::2] == (0, "")
    broken = folder / "site" / "broken-1.dist-info"
    broken.mkdir()
    (broken / "METADATA").write_text("Metadata-Version: 2.1\nName: broken\nVersion: 1\n")
    (broken / "entry_points.txt").write_text("[motionbook.templates]\nbroken = no_such_module:TEMPLATE\n")
    return folder, run


def test_a_package_is_built_verified_and_tests_itself(package):
    _, run = package
    assert run("workbook", "build", "crane/crane.toml", "-o", "crane.xlsx")[0] == 0
    code, said, _ = run("workbook", "verify", "crane.xlsx")
    assert (code, "every one computes what the engine computes" in " ".join(said.split())) == (0, True)
    code, said, _ = run("pytest", "-q", "-p", "no:cacheprovider", "crane")
    assert (code, "2 passed" in said) == (0, True)


def test_an_entry_of_ones_own_is_described_and_refused_as_all_are(package):
    folder, run = package
    assert run("workbook", "new", "crane", "-o", "new.toml")[0] == 0
    text = (folder / "new.toml").read_text(encoding="utf-8")
    (folder / "new.toml").write_text(text.replace("mass = 120.0", "mass = 1"), encoding="utf-8")
    assert run("workbook", "diff", "crane/crane.toml", "new.toml")[0] == 1
    (folder / "new.toml").write_text(text.replace("mass = ", "weight = "), encoding="utf-8")
    code, _, said = run("workbook", "build", "new.toml", "-o", "new.xlsx")
    assert code == 2
    assert "weight" in said


def test_a_package_that_cannot_be_loaded_is_named_and_the_rest_works(package):
    _, run = package
    code, _, said = run("workbook", "new", "machine", "-o", "machine.toml", "--force")
    assert code == 0
    code, _, said = run("workbook", "new", "none-such")
    assert code == 2
    assert "The template 'broken' of no_such_module:TEMPLATE cannot be used: No module named 'no_such_module'" in said
    assert "crane" in said


@pytest.mark.parametrize("name", ["Crane", "2cranes", "a-b", "class", "machine", ""])
def test_a_name_that_cannot_be_one_is_refused(name, motionbook, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, _, said = motionbook("new-template", name)
    assert code == 2
    assert "NAME" in said
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_there_is_left_as_it_is(motionbook, tmp_path):
    code, _, said = motionbook("new-template", "crane", "-o", str(tmp_path))
    assert code == 2
    assert "exists" in said
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", api.__all__)
def test_every_public_name_is_explained(name):
    assert f"`{name}`" in PAGE
