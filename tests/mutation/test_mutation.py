"""`verify` finds what slips into a formula, and names the cell: a sample of mutants over every template."""

from functools import cache

import pytest

from tests.mutation.bench import Bench, OfValues, smaller
from tests.mutation.examine import examined, names_it_first, survivors
from tests.mutation.machines import machines
from tests.mutation.mutants import KINDS, Mutant
from tests.tiers import by_day, seed
from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as

SEED, PARTS = 7, 3
SAMPLE = 1080  # mutants of a template, or one of each quantity where it has more
MANY, RUNS = 150, 1  # mutants of a template in a night, and the tests among which they are divided
WHOLE = 2  # of each kind, to be judged by all of verify
LOOKED_AT = 0.85  # least share of the mutants that show at some valid input which must show at verify's own inputs

every_template = pytest.mark.parametrize("name", by_day(DESCRIBED, COMPOSED))


@cache
def bench(name: str) -> Bench:
    template, machine = committed_as(name)
    return Bench(template, smaller(machine))


@cache
def sample(name: str) -> list[Mutant]:
    orchard = bench(name).orchard
    return orchard.sample(max(SAMPLE, len(orchard.strata)), SEED)


def of_kind(name: str, kind: str, count: int) -> list[Mutant]:
    return [m for m in sample(name) if m.kind == kind][:count]


@every_template
def test_the_sample_spreads_over_every_quantity_and_kind(name: str) -> None:
    orchard = bench(name).orchard
    mutants = sample(name)
    assert len(mutants) >= SAMPLE
    assert {m.kind for m in mutants} == set(KINDS)
    hit = {m.address for m in mutants}
    missed = [
        s
        for s, cells in orchard.strata.items()
        if not any((c.block.sheet.title, c.row, c.column) in hit for c in cells)
    ]
    assert missed == []


@every_template
@pytest.mark.parametrize("part", range(PARTS))
def test_every_mutant_is_found(name: str, part: int) -> None:
    mutants = sample(name)[part::PARTS]
    verdicts = list(examined(bench(name), mutants, []))
    assert len(verdicts) == len(mutants)
    assert [str(v.mutant) for v in survivors(verdicts)] == []
    unseen = [v for v in verdicts if not v.by_text and v.mutant.kind != "anchor"]
    assert [str(v.mutant) for v in unseen] == []


@every_template
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.sample(3)
def test_verify_names_the_cell_first(name: str, kind: str) -> None:
    for mutant in of_kind(name, kind, WHOLE):
        report = bench(name).verified(mutant)
        assert names_it_first(report, mutant), f"{mutant}: {report.findings[:1]}"


@every_template
@pytest.mark.parametrize("kind", [k for k in KINDS if k not in ("anchor", "value")])
@pytest.mark.sample(3)
def test_one_cell_evaluated_alone_tells_what_verify_reports_of_it(name: str, kind: str) -> None:
    for mutant in of_kind(name, kind, 1):
        report = bench(name).verified(mutant, OfValues)
        own = [f for f in report.findings if (f.sheet, f.cell) == (mutant.address.sheet, mutant.address.a1)]
        if any(f.computed == "#CYCLE!" for f in own):
            continue  # alone, it reads what the cells that need it are to hold
        assert bool(own) == (bench(name).differs_at(mutant) is not None), str(mutant)


@every_template
def test_values_alone_find_most_of_what_shows_at_any_valid_input(name: str) -> None:
    here = bench(name)
    elsewhere = [here.inputs(m) for m in machines(here.machine, 12, SEED)]
    verdicts = list(examined(here, sample(name)[::4], elsewhere))
    found = sum(v.found(values_only=True) for v in verdicts)
    missed = [str(v.mutant) for v in survivors(verdicts, values_only=True) if v.by_value]
    assert found / (found + len(missed)) >= LOOKED_AT, "\n".join(missed)


@every_template
@pytest.mark.nightly
@pytest.mark.parametrize("run", range(RUNS))
def test_a_night_s_mutants_are_found_and_named_first(name: str, run: int) -> None:
    here = bench(name)
    mutants = here.orchard.sample(MANY, seed("mutants"))[run::RUNS]
    elsewhere = [here.inputs(m) for m in machines(here.machine, 20, seed("machines"))]
    verdicts = list(examined(here, mutants, elsewhere))
    found = [v.mutant for v in verdicts if v.found(values_only=False)]
    assert [str(v.mutant) for v in survivors(verdicts)] == []
    assert [str(m) for m in found[::25] if not names_it_first(here.verified(m), m)] == []
