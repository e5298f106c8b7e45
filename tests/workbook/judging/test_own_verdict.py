"""The machine's own checks: told beside the cells' agreement, and an exit code of their own where they fail."""

import json
from pathlib import Path
from xml.etree import ElementTree

import openpyxl
import pytest

from tests.workbook.press import too_weak
from workbook.build import build
from workbook.judging.batch import Outcome, exit_code
from workbook.judging.verify import verify


@pytest.fixture(scope="module")
def failing(press, tmp_path_factory):
    """A sound workbook of a press whose motors are too weak."""
    path = tmp_path_factory.mktemp("failing") / "failing.xlsx"
    build(too_weak(press.machine), path)
    return path


def test_the_checks_of_a_book_are_all_told(press):
    report = verify(press.path)
    assert len(report.checks) == len(press.declared.checks) > 5
    assert report.failing == []
    assert report.holds


def test_a_design_that_fails_ends_with_3_and_says_where(failing, motionbook, tmp_path):
    report = verify(failing)
    assert report.agrees
    assert not report.holds
    assert {c.found for c in report.failing} == {"FAIL"}
    page, junit = tmp_path / "r.html", tmp_path / "r.xml"
    code, said, _ = motionbook("verify", failing, "--json", "--report", page, "--junit", junit)
    assert code == 3
    told = json.loads(said)
    assert told["agrees"]
    assert told["checks"]["all"] == len(report.checks)
    assert not told["checks"]["holds"]
    cells = {f"{c['sheet']}!{c['cell']}" for c in told["checks"]["failing"]}
    assert cells == {f"{c.sheet}!{c.cell}" for c in report.failing}
    text = page.read_text(encoding="utf-8")
    assert all(cell in text for cell in cells)
    case = ElementTree.parse(junit).getroot().findall(".//testcase")[-1]
    assert case.find("failure") is not None
    assert all(cell in case.find("failure").text for cell in cells)
    code, said, _ = motionbook("verify", failing)
    assert code == 3
    assert all(f"FAIL  {cell}" in said for cell in cells)


def test_cells_that_disagree_are_graver_than_a_design_that_fails(failing, motionbook, tmp_path):
    book = openpyxl.load_workbook(failing)
    next(c for row in book["Drive MC01"].iter_rows() for c in row if c.data_type == "f").value = 1
    book.save(tmp_path / "b.xlsx")
    assert motionbook("verify", tmp_path / "b.xlsx")[0] == 1
    assert motionbook("verify", failing, tmp_path / "b.xlsx")[0] == 1
    code, said, _ = motionbook("verify", failing, tmp_path / "none.xlsx", "--json")
    assert code == 2
    assert [f["verdict"] for f in json.loads(said)["files"]] == ["fails", "unreadable"]


def test_the_gravest_of_many_counts():
    def code(*verdicts):
        return exit_code([Outcome(Path("b.xlsx"), v) for v in verdicts])

    assert code("agrees") == code("agrees", "no machine") == 0
    assert code("agrees", "fails") == code("fails") == 3
    assert code("fails", "disagrees", "agrees") == 1
    assert code("fails", "disagrees", "unreadable") == code("no machine") == 2
