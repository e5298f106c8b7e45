"""The machine's own checks: told beside the cells' agreement, and an exit code of their own where they fail."""

import json
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import openpyxl
import pytest

from tests import cutting
from tests.mutation.bench import sized
from workbook.build import build
from workbook.judging.many import exit_code
from workbook.judging.one import Outcome
from workbook.judging.report import Check, Finding, Ran, Report
from workbook.judging.verify import verify
from workbook.templates import TEMPLATES


@pytest.fixture(scope="module")
def failing(tmp_path_factory):
    """A sound workbook of a machine whose motor is too weak."""
    path = tmp_path_factory.mktemp("failing") / "failing.xlsx"
    build(cutting.too_weak(), path)
    return path


def run(*arguments):
    command = [sys.executable, "-m", "workbook", "verify", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, encoding="utf-8")


@pytest.mark.parametrize("name", TEMPLATES)
@pytest.mark.sample(3)
def test_the_checks_of_a_book_are_all_told(name, tmp_path):
    machine = sized(TEMPLATES[name], cycle=120, law=4, own_law=4)
    build(machine, tmp_path / "b.xlsx")
    report = verify(tmp_path / "b.xlsx")
    assert len(report.checks) == len(TEMPLATES[name].declare(machine).checks) > 5
    assert report.failing == []
    assert report.holds


def test_a_design_that_fails_ends_with_3_and_says_where(failing, tmp_path):
    report = verify(failing)
    assert report.agrees
    assert not report.holds
    assert {c.found for c in report.failing} == {"FAIL"}
    done = run(failing, "--json", "--report", tmp_path / "r.html", "--junit", tmp_path / "r.xml")
    assert done.returncode == 3
    told = json.loads(done.stdout)
    assert told["agrees"]
    assert told["checks"]["all"] == len(report.checks)
    assert not told["checks"]["holds"]
    cells = {f"{c['sheet']}!{c['cell']}" for c in told["checks"]["failing"]}
    assert cells == {f"{c.sheet}!{c.cell}" for c in report.failing}
    page = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert all(cell in page for cell in cells)
    case = ElementTree.parse(tmp_path / "r.xml").getroot().findall(".//testcase")[-1]
    assert case.find("failure") is not None
    assert all(cell in case.find("failure").text for cell in cells)
    table = run(failing)
    assert table.returncode == 3
    assert all(f"FAIL  {cell}" in table.stdout for cell in cells)


def test_the_cells_say_where_they_fail(failing):
    """What is told is what stands in the book: the named cells hold FAIL."""
    held = openpyxl.load_workbook(failing, data_only=True)
    assert all(held[c.sheet][c.cell].value == "FAIL" for c in verify(failing).failing)


def test_cells_that_disagree_are_graver_than_a_design_that_fails(failing, tmp_path):
    book = openpyxl.load_workbook(failing)
    next(c for row in book["Drive MC01"].iter_rows() for c in row if c.data_type == "f").value = 1
    book.save(tmp_path / "b.xlsx")
    assert run(tmp_path / "b.xlsx").returncode == 1
    assert run(failing, tmp_path / "b.xlsx").returncode == 1
    done = run(failing, tmp_path / "none.xlsx", "--json")
    assert done.returncode == 2
    assert [f["verdict"] for f in json.loads(done.stdout)["files"]] == ["fails", "unreadable"]


def test_the_gravest_of_many_counts():
    def code(*verdicts):
        return exit_code([Outcome(Path("b.xlsx"), v) for v in verdicts])

    assert code("agrees") == code("agrees", "no machine") == 0
    assert code("agrees", "fails") == code("fails") == 3
    assert code("fails", "disagrees", "agrees") == 1
    assert code("fails", "disagrees", "unreadable") == code("no machine") == 2


def test_an_unfinished_design_does_not_hold():
    report = Report(Path("b.xlsx"), "t", witnesses=[Ran("pycel", "1", compared=5, unfinished=2)])
    assert report.agrees
    assert not report.holds
    report.witnesses[0].unfinished = 0
    assert report.holds
    report.checks = [Check("A", "A1", "x", "unfinished")]
    assert not report.holds
    report.findings = [Finding("A", "A1", "value", 1, 2)]
    assert not report.agrees
