"""SARIF, and what pipelines run: the hook, the action's script."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from tests.workbook.composed import small
from tests.workbook.edit import enter
from workbook.build import build

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def books(tmp_path_factory):
    """A folder with a sound book, one with an edited formula, and a file that is none."""
    folder = tmp_path_factory.mktemp("pipeline") / "books"
    folder.mkdir()
    build(small(), folder / "sound.xlsx")
    enter(folder / "sound.xlsx", folder / "edited.xlsx", {"axis1_position": "=1+1"})
    (folder / "broken.xlsx").write_bytes(b"PK")
    return folder


@pytest.fixture(scope="module")
def ran(books):
    """The action's script, run on that folder as a pipeline does."""
    folder = books.parent
    (folder / "motionbook").write_text(f'#!/bin/sh\nexec "{sys.executable}" -m workbook "$@"\n')
    (folder / "motionbook").chmod(0o755)
    environment = os.environ | {"PATH": f"{folder}:{os.environ['PATH']}", "PYTHONPATH": str(ROOT),
                                "GITHUB_STEP_SUMMARY": str(folder / "summary.md")}  # fmt: skip
    audited = subprocess.run(["bash", ROOT / ".ci/action", "books", "audit"], cwd=folder, env=environment, check=False)
    audit = json.loads((folder / "motionbook.sarif").read_text(encoding="utf-8"))
    done = subprocess.run(["bash", ROOT / ".ci/action", "books"], cwd=folder, env=environment, check=False)
    return folder, done.returncode, audited.returncode, audit


def test_the_action_s_script_ends_as_verify_does_and_writes_all_that_is_uploaded(ran):
    folder, *codes, audit = ran
    assert codes == [2, 2]  # a file cannot be read
    assert "unreadable" in {result["ruleId"] for result in audit["runs"][0]["results"]}
    assert "### motionbook audit" in (folder / "summary.md").read_text(encoding="utf-8")
    assert "edited.xlsx" in (folder / "summary.md").read_text(encoding="utf-8")
    assert "<table" in (folder / "motionbook-report.html").read_text(encoding="utf-8")


def test_sarif_names_file_cell_and_kind_of_each_finding(ran):
    log = json.loads((ran[0] / "motionbook.sarif").read_text(encoding="utf-8"))
    (run,) = log["runs"]
    assert log["version"] == "2.1.0"
    rules = {rule["id"] for rule in run["tool"]["driver"]["rules"]}
    assert {result["ruleId"] for result in run["results"]} <= rules
    by_file = {}
    for result in run["results"]:
        uri = result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        by_file.setdefault(Path(uri).name, []).append(result)
    assert "sound.xlsx" not in by_file or {r["level"] for r in by_file["sound.xlsx"]} == {"warning"}
    assert [r["ruleId"] for r in by_file["broken.xlsx"]] == ["unreadable"]
    (edited,) = [r for r in by_file["edited.xlsx"] if r["ruleId"] == "formula"]
    assert edited["locations"][0]["logicalLocations"][0]["fullyQualifiedName"].startswith("Timing!")
    assert edited["level"] == "error"


def test_the_hook_and_the_action_call_what_there_is():
    hooks = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))
    assert [hook["entry"].split() for hook in hooks] == [["motionbook", "verify"], ["motionbook", "audit"]]
    action = yaml.safe_load((ROOT / "action.yml").read_text(encoding="utf-8"))
    scripts = " ".join(step.get("run", "") for step in action["runs"]["steps"])
    assert ".ci/action" in scripts
