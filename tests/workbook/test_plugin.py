"""A template of another package, the hoist that ``new-template`` writes: what holds of ours holds of it."""

import tomllib

import pytest
import tomli_w

from tests.mutation.bench import Bench
from tests.mutation.examine import examined, names_it_first, survivors
from tests.workbook.cells import disagreeing, entered
from tests.workbook.dimensions.test_dimensions import Labelled, not_named
from workbook.build import build, read_inputs
from workbook.judging.verify import verify
from workbook.reading.descriptions import read_machine
from workbook.serve.design import verdict
from workbook.serve.tables import schema
from workbook.starter.hoist import TEMPLATE
from workbook.studies.evaluate import Evaluator, book_value
from workbook.studies.plan import read_study
from workbook.templates import TEMPLATES


@pytest.fixture(autouse=True)
def known(monkeypatch):
    """The register knows the template, as of a package that is installed."""
    monkeypatch.setitem(TEMPLATES.others, TEMPLATE.name, TEMPLATE)


@pytest.fixture
def hoist():
    return read_machine(TEMPLATE.description)


def test_its_book_agrees_and_its_inputs_come_back(hoist, tmp_path):
    build(hoist, tmp_path / "hoist.xlsx")
    assert verify(tmp_path / "hoist.xlsx", ["pycel", "formulon"]).findings == []
    assert read_inputs(tmp_path / "hoist.xlsx") == (hoist, [])


def test_every_variation_agrees_and_comes_back(hoist):
    for variation in [hoist, *TEMPLATE.variants(hoist)]:
        assert disagreeing(TEMPLATE, variation)[0] == []
        assert entered(TEMPLATE, variation) == (variation, [])


def test_every_mutant_is_found_and_its_cell_named_first(hoist):
    bench = Bench(TEMPLATE, hoist)
    mutants = bench.orchard.sample(300, seed=37)
    assert [str(verdict.mutant) for verdict in survivors(examined(bench, mutants, []))] == []
    for mutant in mutants[::60]:
        assert names_it_first(bench.verified(mutant), mutant), str(mutant)


def test_its_cells_have_the_units_of_their_labels():
    assert Labelled(TEMPLATE).came().wrong == {}
    assert not_named(TEMPLATE, 20) == ([], 6)


def test_a_study_of_it_says_what_its_books_say(hoist, tmp_path):
    (tmp_path / "hoist.toml").write_bytes(TEMPLATE.description.read_bytes())
    masses = {"key": "mass", "from": 50.0, "to": 150.0, "steps": 3}
    study = {"title": "Masses", "base": "hoist.toml", "vary": [masses], "results": ["peak", "rms"]}
    (tmp_path / "study.toml").write_text(tomli_w.dumps(study), encoding="utf-8")
    plan = read_study(tmp_path / "study.toml")
    found = Evaluator(plan).table(0, plan.space.columns(0, 3))
    books = [TEMPLATE.declare(hoist.model_copy(update={"mass": mass})) for mass in (50.0, 100.0, 150.0)]
    for name in ("peak", "rms"):
        assert list(found.results[name]) == [book_value(book, name) for book in books]


def test_the_design_page_has_a_field_for_each_of_its_entries_and_judges_it():
    text = TEMPLATE.description.read_text(encoding="utf-8")
    fields = {key["name"] for section in schema(TEMPLATE.name) for key in section["keys"]}
    assert set(tomllib.loads(text)) <= fields
    assert verdict("hoist.toml", text)["verdict"] == "OK"
