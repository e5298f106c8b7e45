"""Workbooks that Excel computed: nothing that it saved is named as wrong, and nearly all of it can be judged."""

from collections import Counter

import pytest

from tests.foreign.books import VARIABLE
from tests.foreign.excels_values import books, count

SHARE = 0.001  # of the cells that may be left, or be a false alarm of the audit


@pytest.mark.nightly
def test_what_excel_saved_is_neither_blamed_nor_left():
    if not (there := books()):
        pytest.skip(f"none is in the folder that {VARIABLE} names")
    states = sum(map(count, there), Counter())
    cells = states.total() - states["alarms"]
    assert (states["differs"], states["disputed"]) == (0, 0)
    assert states["cannot"] <= SHARE * cells
    assert states["alarms"] <= SHARE * cells
