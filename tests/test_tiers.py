"""The tiers of the tests: a share of a night is the same for a commit."""

import pytest

from tests import tiers


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
