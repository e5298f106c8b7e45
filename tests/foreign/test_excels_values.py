"""Workbooks that Excel computed: nothing that it saved is named as wrong, and nearly all of it can be judged."""

from collections import Counter
from pathlib import Path

import pytest

from tests.foreign.books import VARIABLE, files
from tests.foreign.excels_values import books, count
from workbook.audit import audit
from workbook.reading.files import open_book

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


@pytest.mark.nightly
@pytest.mark.parametrize("line", Path(__file__).with_name("audited.sha256").read_text(encoding="utf-8").splitlines())
def test_the_audit_names_in_published_workbooks_what_the_page_has_verdicts_on(line):
    sha, number, _ = line.split(maxsplit=2)
    if sha not in files():
        pytest.skip(f"it is not in the folder that {VARIABLE} names")
    assert len(audit(open_book(files()[sha])).shown()) == int(number)
