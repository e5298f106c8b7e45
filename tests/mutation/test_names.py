"""`verify` finds names that lead elsewhere: whoever moves one changes what its cells are taken for."""

from collections.abc import Iterable
from functools import cache
from itertools import chain, islice

import pytest

from tests.mutation.bench import Bench, smaller
from tests.mutation.names import Redirection, blocks, columns, outcome, shifted, swapped
from tests.tiers import by_day, seed
from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as
from tests.workbook.press import TEMPLATE
from workbook.reading.descriptions import read_machine

COUNT, SEED = 4, 3

every_template = pytest.mark.parametrize("name", by_day(DESCRIBED, COMPOSED))
and_press = pytest.mark.parametrize("name", by_day(["press", *DESCRIBED], "press"))
pytestmark = pytest.mark.usefixtures("press")


@cache
def bench(name: str) -> Bench:
    template, machine = (TEMPLATE, read_machine(TEMPLATE.description)) if name == "press" else committed_as(name)
    return Bench(template, smaller(machine, cycle=12, law=4))


def require_found(here: Bench, faults: Iterable[Redirection]) -> None:
    assert [str(fault) for fault in faults if outcome(here, fault) == "agrees"] == []


@and_press
def test_a_block_whose_name_leads_elsewhere_is_found(name: str) -> None:
    here = bench(name)
    require_found(here, shifted(here, blocks(here), 6 * COUNT, SEED))


@every_template
def test_a_column_whose_name_leads_elsewhere_is_found(name: str) -> None:
    here = bench(name)
    require_found(here, shifted(here, columns(here), COUNT, SEED))


@and_press
def test_two_inputs_whose_names_have_changed_places_are_found(name: str) -> None:
    here = bench(name)
    pairs = islice(swapped(here, SEED), 3 * COUNT)
    require_found(here, pairs)


def test_two_inputs_of_one_label_whose_names_have_changed_places_are_found() -> None:
    here = bench("indexing-overlap")
    labels = {block.name: (block.sheet.title, block.quantities[0].label) for block in here.declared.blocks.values()}
    alike = [r for r in swapped(here, SEED) if len({labels[name] for name in r.targets}) == 1]
    assert alike
    require_found(here, alike)


@and_press
def test_an_input_of_words_or_an_empty_one_whose_name_leads_elsewhere_is_found(name: str) -> None:
    here = bench(name)
    first = {block.name: block.quantities[0] for block in here.declared.blocks.values() if not block.is_table}
    wordy = [name for name, q in first.items() if q.role == "input" and not isinstance(q.value, int | float)]
    shifts = [r for seed in (SEED, SEED + 1) for r in shifted(here, wordy, 2 * COUNT, seed)]
    assert shifts
    require_found(here, shifts)


@every_template
@pytest.mark.nightly
def test_a_night_s_names_that_lead_elsewhere_are_found(name: str) -> None:
    here, drawn = bench(name), seed("names")
    faults = chain(
        shifted(here, blocks(here), 10, drawn), shifted(here, columns(here), 6, drawn),
        islice(swapped(here, drawn), 6),
    )  # fmt: skip
    require_found(here, faults)
