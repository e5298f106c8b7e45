"""The tiers of the tests: a share of a night is the same for a commit, and a test that is known to be red is told."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests import tiers

ROOT = Path(__file__).parents[1]


class Item:
    """A test as pytest collects it."""

    def __init__(self, nodeid, *marks):
        self.nodeid, self.marks = nodeid, [getattr(pytest.mark, mark) for mark in marks]

    def get_closest_marker(self, name):
        return next((mark for mark in self.marks if mark.name == name), None)

    def add_marker(self, mark):
        self.marks.append(mark)


def test_four_commits_run_a_whole_night_and_nothing_of_the_day():
    night = [Item(f"test_a.py::test[night {k}]", "nightly") for k in range(30)]
    shares = [tiers.shared([Item("test_a.py::test[0]"), *night], f"{k:08x}cafe") for k in range(tiers.PARTS)]
    assert sorted(item.nodeid for share in shares for item in share) == sorted(item.nodeid for item in night)
    assert max(map(len, shares)) - min(map(len, shares)) <= 1
    assert tiers.shared(night, "00000001ff") == tiers.shared(night, "00000001ff") == shares[1]


def test_a_night_runs_a_case_of_a_list_and_all_that_is_drawn(monkeypatch):
    listed = [Item(f"test_a.py::test[book {k}]", "nightly") for k in range(9)]
    rest = [Item(f"test_a.py::test[night {k}]", "nightly") for k in range(9)] + [Item("test_a.py::test[0]")]
    nights = []
    for number in range(20):
        monkeypatch.setattr(tiers, "night", number)
        tonight = tiers.of_this_night([*listed, *rest])
        assert len(tonight) == tiers.CASES + len(rest)
        assert set(rest) < set(tonight)
        nights.append(tonight)
    assert set(listed) == {item for tonight in nights for item in tonight if item in listed}


@pytest.mark.parametrize(("body", "is_told"), [("pass", True), ("1 / 0", False)])
def test_a_listed_test_that_passes_is_told(body, is_told, tmp_path):
    """As pytest is run: with a list of its own and a test beside it."""
    for name in ("conftest", "known_red", "tiers"):
        source = (ROOT / f"tests/{name}.py").read_text(encoding="utf-8")
        (tmp_path / f"{name}.py").write_text(source.replace("from tests import", "import"), encoding="utf-8")
    (tmp_path / "known_red.toml").write_text('[[red]]\ntests = "test_it.py::"\nreason = "so"\n', encoding="utf-8")
    (tmp_path / "test_it.py").write_text(f"def test_it():\n    {body}\n", encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--hypothesis-seed=7", "test_it.py"]
    found = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, env=found)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "known red: 1 entries in" in done.stdout
    assert ("none of these was red: test_it.py::" in done.stdout) == is_told
