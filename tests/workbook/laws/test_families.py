"""A book with one law of each family, with other parameters than the default: every cell, by every witness."""

import pytest

from tests.workbook.cells import disagreeing
from tests.workbook.composed import MACHINE, composed
from workbook.laws.registry import FAMILY
from workbook.witnesses.registry import WITNESSES

NAMED = tuple(code for code, page in FAMILY.items() if page.entries)
TURNS = max(len(FAMILY[code].variations) for code in NAMED)


def one_of_each(turn, **sizes):
    """A machine of one axis, with a law of each family in its phases too."""
    laws = {}
    for code in NAMED:
        found = FAMILY[code].variations
        laws[f"One {code}"] = {"family": code} | (found[turn % len(found)] if found else {})
    phases = [(f"one {code}", 10.0 + k, 20.0 + k) for k, code in enumerate(NAMED) if code != "DHM"]  # two sines
    room = {"cycle": 48, "law": 10, "motion_pieces": 90} | sizes
    return composed(phases, laws, room, closes="open")


@pytest.mark.parametrize("turn", range(TURNS))
@pytest.mark.sample(2)
def test_every_cell_of_every_family_computes_what_the_engine_has(turn):
    wrong, count = disagreeing(MACHINE, one_of_each(turn))
    assert wrong == []
    assert count > 300 * len(NAMED)


@pytest.mark.parametrize("turn", range(2))
@pytest.mark.parametrize("witness", ["formulon", "libreoffice"])
@pytest.mark.nightly
def test_and_so_say_the_other_witnesses(witness, turn, tmp_path):
    found = WITNESSES[witness]()
    if found.version() is None:
        pytest.skip(f"{witness} is not on this machine")
    from workbook.build import build
    from workbook.judging.verify import verify

    build(one_of_each(turn, cycle=12, law=4), tmp_path / "book.xlsx")
    report = verify(tmp_path / "book.xlsx", (witness,))
    assert report.findings == []
    assert report.compared == report.declared
