"""Mutants of what is shown: each that changes what a user reads is found and named, and no other."""

from pathlib import Path

import pytest

from tests.mutation.looks import Looks, Oracle, outcomes, redrawn
from tests.tiers import by_day, seed
from tests.workbook.composed import COMPOSED, DESCRIBED

SEED, COUNT = 5, 80

every_template = pytest.mark.parametrize("name", by_day(DESCRIBED, COMPOSED))


@every_template
def test_what_a_user_reads_otherwise_is_found_and_named(name: str, tmp_path: Path) -> None:
    """Formats by formulon's displayed texts; units, labels, symbols, charts, types, settings and parts."""
    found = list(outcomes(name, tmp_path, COUNT, SEED))
    assert len(found) > COUNT
    assert [words for words, named in found if not named] == []


@every_template
def test_the_oracle_sees_each_change_of_a_chart_and_no_other_chart_is_named(name: str, tmp_path: Path) -> None:
    here = Looks(name, tmp_path)
    before, changed = Oracle(here.opened()), here.opened()
    faults = list(redrawn(changed, SEED))
    after = Oracle(changed)
    assert here.said(changed) == {corner for _, _, corner in faults} != set()
    assert [c for sheet, n, c in faults if before.charts(sheet)[n] == after.charts(sheet)[n]] == []


@every_template
@pytest.mark.nightly
def test_a_night_s_looks_are_found(name: str, tmp_path: Path) -> None:
    assert [words for words, named in outcomes(name, tmp_path, 100, seed("looks")) if not named] == []
