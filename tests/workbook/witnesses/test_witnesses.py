"""Each witness agrees with the engine, and notices a corrupted formula and, where it reads them, corrupted values."""

import pytest

from tests.mutation.bench import smaller
from tests.tiers import by_day
from tests.workbook.composed import COMPOSED, DESCRIBED, committed_as
from workbook.build import build
from workbook.errors import WitnessError
from workbook.judging.verify import verify
from workbook.reports.console import verdict
from workbook.witnesses.registry import WITNESSES

PRESENT = [name for name in WITNESSES if WITNESSES[name]().version()]  # IronCalc has no wheel for every Python
COMPUTING = [name for name in PRESENT if name != "saved"]


@pytest.mark.parametrize("name", by_day(DESCRIBED, COMPOSED))
def test_the_witnesses_agree_and_say_their_versions(name, tmp_path):
    build(smaller(committed_as(name)[1]), tmp_path / "book.xlsx")
    report = verify(tmp_path / "book.xlsx", PRESENT)
    assert report.findings == []
    assert [ran.name for ran in report.witnesses] == PRESENT
    assert {ran.compared for ran in report.witnesses} == {report.compared}
    assert report.compared == report.declared > 1000


def test_each_witness_computes_a_corrupted_formula_and_is_not_misled_by_the_saved_value(press, tmp_path):
    address, right = (pair := press.a_number()).address, pair.cell.expected
    path = press.changed(tmp_path / "b.xlsx", address, rb"<f>(.*?)</f>", rb"<f>1.25*(\1)</f>")
    report = verify(path, PRESENT)
    found = [f for f in report.findings if (f.sheet, f.cell) == (address.sheet, address.a1)]
    assert found[0].kind == "formula"
    assert {(f.kind, f.witness) for f in found[1:]} == {("value", name) for name in COMPUTING}
    assert [f.computed for f in found[1:]] == pytest.approx([1.25 * right] * len(COMPUTING), rel=1e-12)
    assert len(report.witnesses) == len(PRESENT)


def test_each_witness_computes_a_book_that_a_program_saved_without_values(press, tmp_path):
    """Saved by openpyxl, an empty cell with a style says that it is a number: to read it as 0 would be another book."""
    path = tmp_path / "b.xlsx"
    opened = press.opened()
    opened.save(path)
    report = verify(path, COMPUTING)
    assert [f for f in report.findings if f.witness in COMPUTING] == []


@pytest.mark.parametrize(
    ("names", "kinds"),
    [(["all"], []), (["pycel", "formulon"], ["witness"]), (["all", "formulon"], ["witness"]),
     (["formulon"], ["witness"])],
)  # fmt: skip
def test_a_witness_that_fails_counts_where_it_was_named_or_no_other_computed(names, kinds, press, monkeypatch):
    """Those that ``all`` finds on a machine judge without it, and it is named."""

    def fails(*_):
        raise WitnessError("it failed")

    few = {name: WITNESSES[name] for name in ("pycel", "formulon", "saved")}
    monkeypatch.setattr("workbook.judging.verify.WITNESSES", few)
    monkeypatch.setattr(type(few["formulon"]()), "values", fails)
    report = verify(press.path, names)
    assert [(f.kind, f.cell) for f in report.findings] == [(kind, "formulon") for kind in kinds]
    assert ("Not compared by formulon: it failed" in verdict(report)) == (not kinds)
