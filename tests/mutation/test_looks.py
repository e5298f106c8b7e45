"""Mutants of what is shown: each that changes what a user reads is found and named, and no other."""

from functools import cache
from pathlib import Path

import pytest

from tests.mutation.looks import (
    TASTE,
    Looks,
    Oracle,
    exchanged,
    formatted,
    named,
    reads_back,
    redrawn,
    settings,
    texts,
    value_of,
)  # fmt: skip
from workbook.templates import TEMPLATES

SEED = 5
COUNT = 80

every_template = pytest.mark.parametrize("name", TEMPLATES)


@pytest.fixture(scope="module")
def looks(tmp_path_factory: pytest.TempPathFactory):
    @cache
    def made(name: str) -> Looks:
        return Looks(TEMPLATES[name], tmp_path_factory.mktemp(name))

    return made


@every_template
def test_a_format_is_found_where_its_text_does_not_read_as_the_value(name: str, looks) -> None:
    here = looks(name)
    changed = here.opened()
    faults = formatted(here, changed, COUNT, SEED)
    said, oracle = here.said(changed), Oracle(changed)
    wrong = []
    for pair, code in faults:
        text, unit = oracle.text(pair.address), pair.cell.quantity.unit
        misread = not reads_back(text, value_of(pair), unit)
        found = f"{pair.address.sheet}!{pair.address.a1}" in said
        if (misread and not found) or (found and code in TASTE):
            wrong.append(f"{pair.address} {code}: {text!r} for {value_of(pair)}, found: {found}")
    assert wrong == []


@every_template
@pytest.mark.parametrize("style", ["label", "symbol", "unit"])
def test_texts_that_have_changed_places_are_found(name: str, style: str, looks) -> None:
    here = looks(name)
    changed = here.opened()
    cells = exchanged(here, changed, style, SEED)
    assert cells
    assert cells - here.said(changed) == set()


@every_template
def test_a_chart_that_draws_something_else_is_found_and_no_other(name: str, looks) -> None:
    here = looks(name)
    before, changed = Oracle(here.opened()), here.opened()
    faults = list(redrawn(changed, SEED))
    after, said = Oracle(changed), here.said(changed)
    assert faults
    assert said == {corner for _, _, corner in faults}
    same = [corner for sheet, n, corner in faults if before.charts(sheet)[n] == after.charts(sheet)[n]]
    assert same == []  # the oracle sees each of them too


@every_template
def test_formulas_kept_as_texts_and_settings_are_found(name: str, looks, tmp_path: Path) -> None:
    here = looks(name)
    changed = here.opened()
    cells = texts(here, changed, 5, SEED)
    changed.calculation.calcMode = "manual"
    changed.save(tmp_path / "b.xlsx")
    kinds = named(tmp_path / "b.xlsx")
    assert {cell for cell, found in kinds.items() if "replaced" in found} == cells
    assert kinds["!calculation"] == {"setting"}


def test_every_setting_is_found(looks, tmp_path: Path) -> None:
    changed = looks("motion-composer").opened()
    for name in settings(changed):
        changed.save(tmp_path / "b.xlsx")
        assert named(tmp_path / "b.xlsx") == {"!calculation": {"setting"}}, name
