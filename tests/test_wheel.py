"""The built wheel works outside the repository: new, build, verify, laws."""

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import workbook

ROOT = Path(__file__).parents[1]


def run(*command, **options):
    """Run a program; return what it printed."""
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=False, **options)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def motionbook(tmp_path_factory):
    """Calls the command of the installed wheel, in a folder of its own."""
    folder = tmp_path_factory.mktemp("wheel")
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check"]
    options = ["--no-deps", "--no-build-isolation", "--quiet"]
    run(*pip, "wheel", *options, "--wheel-dir", str(folder), str(ROOT))
    (wheel,) = folder.glob("*.whl")
    assert wheel.name.startswith(f"motionbook-{workbook.__version__}-")
    names = zipfile.ZipFile(wheel).namelist()
    assert {name.partition("/")[0] for name in names if ".dist-info" not in name} == {"engine", "workbook"}
    assert {
        "engine/py.typed",
        "workbook/py.typed",
        "workbook/shipped/machine.toml",
        "workbook/serve/page/vendor/uplot.css",
    } <= set(names)
    run(*pip, "install", "--no-deps", "--no-index", "--quiet", "--target", str(folder / "site"), str(wheel))
    environment = os.environ | {"PYTHONPATH": str(folder / "site")}
    return lambda *arguments: run(sys.executable, "-m", "workbook", *arguments, cwd=folder, env=environment)


def test_the_wheel_runs_outside_the_repository(motionbook):
    assert motionbook("--version") == f"motionbook {workbook.__version__}\n"
    assert {law["code"] for law in json.loads(motionbook("laws", "--json"))} >= {"TVP", "CIC", "MTP"}
    motionbook("new", "machine", "-o", "mine.toml")
    motionbook("build", "mine.toml")
    assert "cutting-machine.xlsx" in motionbook("build")  # the description that comes with it
    assert "every one computes what" in " ".join(motionbook("verify", "mine.xlsx").split())


def test_changelog_and_package_name_one_version():
    assert f"## {workbook.__version__} " in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
